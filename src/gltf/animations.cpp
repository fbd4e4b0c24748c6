#include "gltf/animations.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>
#include <utility>
#include <variant>

#include "base/text.h"
#include "gltf/accessor.h"
#include "gltf/animation_pointer.h"
#include "gltf/budget.h"
#include "scene/animated_values.h"

namespace hm::gltf {
namespace {

// Which integers may be stored in place of floats.
enum class Integers { none, normalized, any };

struct PathName {
    std::string_view name;
    AnimatedProperty property;
    ElementType type;
    Integers integers;
};
constexpr std::array<PathName, 4> kPaths{
    {{"translation", AnimatedProperty::translation, ElementType::vec3, Integers::none},
     {"rotation", AnimatedProperty::rotation, ElementType::vec4, Integers::normalized},
     {"scale", AnimatedProperty::scale, ElementType::vec3, Integers::none},
     {"weights", AnimatedProperty::weights, ElementType::scalar, Integers::normalized}}};

const PathName* find_path(std::string_view name) {
    for (const PathName& path : kPaths)
        if (path.name == name) return &path;
    return nullptr;
}

const PathName& path_of(AnimatedProperty property) {
    return *std::find_if(kPaths.begin(), kPaths.end(),
                         [&](const PathName& path) { return path.property == property; });
}

Result<Interpolation> read_interpolation(const Json& json) {
    HM_TRY_ASSIGN(const auto name, json.text("interpolation"));
    if (!name || *name == "LINEAR") return Interpolation::linear;
    if (*name == "STEP") return Interpolation::step;
    if (*name == "CUBICSPLINE") return Interpolation::cubic_spline;
    return json.invalid("interpolation", fmt::format("{} is not an interpolation", excerpt(*name)));
}

Result<std::size_t> required_accessor(const Json& json, const Source& source,
                                      std::string_view key) {
    return json.required(key, json.index(key, source.accessors.size(), "accessors"));
}

Result<std::vector<float>> read_values(const Json& json, Source& source, std::size_t index) {
    const Accessor& accessor = source.accessors[index];
    const std::uint64_t bytes =
        std::uint64_t{accessor.count} * component_count(accessor.type) * sizeof(float);
    HM_TRY(take_work(json, source, bytes));
    HM_TRY(take_memory(json, source, bytes));
    return read_floats(source, index);
}

Result<std::vector<float>> read_times(const Json& json, Source& source) {
    HM_TRY_ASSIGN(const std::size_t index, required_accessor(json, source, "input"));
    const Accessor& accessor = source.accessors[index];
    if (accessor.type != ElementType::scalar || accessor.component != ComponentType::float32)
        return json.invalid("input", "key times must be float scalars");
    HM_TRY_ASSIGN(std::vector<float> times, read_values(json, source, index));
    check_limits(source, index, {times.data(), 1});
    if (std::any_of(times.begin(), times.end(), [](float t) { return t < 0; }))
        source.warn(accessor_pointer(index), "negative key times; playback starts at 0");
    return times;
}

struct FileSampler {
    AnimationSampler sampler;
    std::size_t output;  // accessor
    std::size_t keys;    // in the file; the sampler may have fewer
};

// Removes keys with a NaN or infinite time or value.
void drop_bad_keys(const Json& json, Source& source, AnimationSampler& sampler) {
    const std::size_t keys = sampler.times.size();
    // If the sizes do not fit, check_output fails for every channel that uses the sampler.
    const std::size_t width = sampler.values.size() % keys == 0 ? sampler.values.size() / keys : 0;
    std::size_t kept = 0;
    for (std::size_t key = 0; key < keys; ++key) {
        const float* const value = sampler.values.data() + key * width;
        const bool is_good =
            std::isfinite(sampler.times[key]) &&
            std::all_of(value, value + width, [](float number) { return std::isfinite(number); });
        if (!is_good) continue;
        sampler.times[kept] = sampler.times[key];
        std::copy_n(value, width, sampler.values.data() + kept * width);
        ++kept;
    }
    if (kept == keys) return;
    source.warn(json.pointer(), "keys with a NaN or infinite time or value are ignored",
                keys - kept);
    sampler.times.resize(kept);
    if (width > 0) sampler.values.resize(kept * width);
}

// Several keys at the same time are a jump: the last one applies from that time on. Keys out of
// order are sorted together with their values.
void repair_order(const Json& json, Source& source, AnimationSampler& sampler) {
    const std::vector<float> times = sampler.times;
    if (std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) == times.end())
        return;
    const bool sorted = std::is_sorted(times.begin(), times.end());
    source.warn(json.pointer_of("input"),
                sorted ? "several keys at the same time; the value jumps there"
                       : "key times are not increasing; the keys are sorted by time");
    if (sorted || sampler.values.size() % times.size() != 0) return;  // the latter fails later
    std::vector<std::size_t> order(times.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return times[a] < times[b]; });
    const std::vector<float> values = sampler.values;
    const std::size_t width = values.size() / times.size();
    for (std::size_t key = 0; key < order.size(); ++key) {
        sampler.times[key] = times[order[key]];
        std::copy_n(values.begin() + std::ptrdiff_t(order[key] * width), width,
                    sampler.values.begin() + std::ptrdiff_t(key * width));
    }
}

Result<FileSampler> read_sampler(const Json& json, Source& source) {
    FileSampler out;
    HM_TRY_ASSIGN(out.sampler.interpolation, read_interpolation(json));
    HM_TRY_ASSIGN(out.sampler.times, read_times(json, source));
    HM_TRY_ASSIGN(out.output, required_accessor(json, source, "output"));
    HM_TRY_ASSIGN(out.sampler.values, read_values(json, source, out.output));
    out.keys = out.sampler.times.size();
    drop_bad_keys(json, source, out.sampler);
    repair_order(json, source, out.sampler);
    return out;
}

// A zero quaternion is not a rotation.
Result<void> check_rotations(const Source& source, const FileSampler& from) {
    const AnimationSampler& s = from.sampler;
    const bool cubic = s.interpolation == Interpolation::cubic_spline;
    for (std::size_t key = 0; key < s.times.size(); ++key) {
        const float* q = s.values.data() + 4 * (cubic ? 3 * key + 1 : key);
        if (q[0] == 0 && q[1] == 0 && q[2] == 0 && q[3] == 0)
            return fail(ErrorKind::invalid, source.file, accessor_pointer(from.output),
                        fmt::format("the rotation of key {} is a zero quaternion", key));
    }
    return {};
}

// What a channel requires of its sampler's output.
struct Needed {
    std::string_view name;
    ElementType type;
    Integers integers;
    std::size_t per_key = 1;  // elements
};

bool has_component(const Accessor& accessor, Integers integers) {
    return accessor.component == ComponentType::float32 || integers == Integers::any ||
           (integers == Integers::normalized && accessor.normalized);
}

Result<void> check_output(const Json& channel, const Source& source, const Needed& needed,
                          const FileSampler& from) {
    const Accessor& accessor = source.accessors[from.output];
    if (accessor.type != needed.type || !has_component(accessor, needed.integers))
        return channel.invalid(
            "sampler", fmt::format("its output, accessor {}, has a type that is invalid for {}",
                                   from.output, needed.name));
    const bool cubic = from.sampler.interpolation == Interpolation::cubic_spline;
    const std::uint64_t expected = std::uint64_t{from.keys} * needed.per_key * (cubic ? 3u : 1u);
    if (accessor.count != expected)
        return channel.invalid("sampler", fmt::format("its output, accessor {}, has {} elements, "
                                                      "expected {}",
                                                      from.output, accessor.count, expected));
    return {};
}

class AnimationReader {
  public:
    AnimationReader(PointerReader& pointers, Source& source, const std::vector<int>& scene_node,
                    const Scene& scene)
        : pointers_(pointers), source_(source), scene_node_(scene_node), scene_(scene) {}

    Result<Animation> read(const Json& json);

  private:
    Result<void> read_channel(const Json& json);
    Result<void> read_pointer_channel(const Json& json, const Json& target, std::size_t sampler);
    Result<void> add(const Json& json, const Json& target, std::size_t sampler, std::size_t node,
                     const PathName& path);
    Result<void> add(const Json& json, std::size_t sampler, std::size_t owner, AnimatedValue value);
    Result<std::size_t> values_per_key(const Json& target, const PathName& path, const Node& node);
    bool is_first(const Json& json, std::size_t owner,
                  std::variant<AnimatedProperty, AnimatedValue> property);
    bool has_keys(const Json& json, const FileSampler& from);

    PointerReader& pointers_;
    Source& source_;
    const std::vector<int>& scene_node_;
    const Scene& scene_;
    Animation animation_;
    std::vector<FileSampler> samplers_;
    // By the owner's index in the file.
    std::set<std::pair<std::size_t, std::variant<AnimatedProperty, AnimatedValue>>> targets_;
};

Result<std::size_t> AnimationReader::values_per_key(const Json& target, const PathName& path,
                                                    const Node& node) {
    if (path.property != AnimatedProperty::weights) {
        if (!node.rest) return target.invalid("node", "a node with a matrix cannot be animated");
        return 1;
    }
    const std::size_t count =
        node.mesh == kUnset ? 0 : scene_.meshes[std::size_t(node.mesh)].weights.size();
    if (count == 0) return target.invalid("node", "has no mesh with morph targets");
    return count;
}

// Whether no earlier channel has the same target.
bool AnimationReader::is_first(const Json& json, std::size_t owner,
                               std::variant<AnimatedProperty, AnimatedValue> property) {
    if (targets_.emplace(owner, property).second) return true;
    source_.warn(json.pointer_of("target"),
                 "channel ignored: an earlier one of the animation has the same target");
    return false;
}

// Whether any of the sampler's keys is valid.
bool AnimationReader::has_keys(const Json& json, const FileSampler& from) {
    if (!from.sampler.times.empty()) return true;
    source_.warn(json.pointer(), "channel ignored: it has no valid keys");
    return false;
}

Result<void> AnimationReader::add(const Json& json, const Json& target, std::size_t sampler,
                                  std::size_t node, const PathName& path) {
    if (!is_first(json, node, path.property)) return {};
    const int index = scene_node_[node];
    if (index == kUnset) return {};
    HM_TRY_ASSIGN(const std::size_t per_key,
                  values_per_key(target, path, scene_.nodes[std::size_t(index)]));
    const FileSampler& from = samplers_[sampler];
    HM_TRY(check_output(json, source_, {path.name, path.type, path.integers, per_key}, from));
    if (path.property == AnimatedProperty::rotation) HM_TRY(check_rotations(source_, from));
    if (!has_keys(json, from)) return {};
    animation_.channels.push_back({sampler, std::size_t(index), path.property});
    return {};
}

Result<void> AnimationReader::add(const Json& json, std::size_t sampler, std::size_t owner,
                                  AnimatedValue value) {
    if (!is_first(json, owner, value)) return {};
    const FileSampler& from = samplers_[sampler];
    const ElementType type = width(value) == 4   ? ElementType::vec4
                             : width(value) == 3 ? ElementType::vec3
                                                 : ElementType::scalar;
    HM_TRY(check_output(json, source_, {"its target", type, Integers::any}, from));
    if (value == AnimatedValue::node_visible) {
        const Accessor& output = source_.accessors[from.output];
        if (output.component != ComponentType::uint8 || output.normalized ||
            from.sampler.interpolation != Interpolation::step)
            return json.invalid("sampler",
                                "visibility requires STEP interpolation of unsigned bytes");
        if (scene_node_[owner] == kUnset) return {};
        owner = std::size_t(scene_node_[owner]);
    }
    if (!has_keys(json, from)) return {};
    animation_.values.push_back({sampler, value, owner, get_value(scene_, value, owner)});
    return {};
}

Result<void> AnimationReader::read_pointer_channel(const Json& json, const Json& target,
                                                   std::size_t sampler) {
    HM_TRY_ASSIGN(const auto pointed, pointers_.read(target));
    if (!pointed) {
        source_.warn(target.pointer(),
                     "channel ignored: its target is missing or cannot be animated");
        return {};
    }
    if (const auto* property = std::get_if<AnimatedProperty>(&pointed->what)) {
        PathName path = path_of(*property);
        path.integers = Integers::any;
        return add(json, target, sampler, pointed->owner, path);
    }
    if (const auto* value = std::get_if<AnimatedValue>(&pointed->what))
        return add(json, sampler, pointed->owner, *value);
    return {};
}

Result<void> AnimationReader::read_channel(const Json& json) {
    HM_TRY_ASSIGN(const std::size_t sampler,
                  json.required("sampler", json.index("sampler", samplers_.size(), "samplers")));
    HM_TRY_ASSIGN(const Json target, json.required("target", json.object("target")));
    HM_TRY_ASSIGN(const auto node, target.index("node", scene_node_.size(), "nodes"));
    HM_TRY_ASSIGN(const std::string_view name, target.required("path", target.text("path")));
    if (name == "pointer") return read_pointer_channel(json, target, sampler);
    const PathName* path = find_path(name);
    if (path == nullptr || !node) {
        source_.warn(target.pointer(), "channel ignored: its target is unknown");
        return {};
    }
    return add(json, target, sampler, *node, *path);
}

Result<Animation> AnimationReader::read(const Json& json) {
    HM_TRY_ASSIGN(animation_.name, name_of(json));
    HM_TRY_ASSIGN(const std::vector<Json> samplers, json.objects("samplers"));
    for (const Json& item : samplers) {
        HM_TRY_ASSIGN(FileSampler sampler, read_sampler(item, source_));
        samplers_.push_back(std::move(sampler));
    }
    HM_TRY_ASSIGN(const std::vector<Json> channels, json.objects("channels"));
    if (channels.empty()) source_.warn(json.pointer(), "the animation has no channels");
    for (const Json& item : channels)
        HM_TRY(read_channel(item));
    for (FileSampler& from : samplers_)
        animation_.samplers.push_back(std::move(from.sampler));
    return std::move(animation_);
}

}  // namespace

Result<std::vector<Animation>> read_animations(const Json& root, Source& source,
                                               const std::vector<int>& scene_node,
                                               const Scene& scene) {
    HM_TRY_ASSIGN(const std::vector<Json> items, root.objects("animations"));
    PointerReader pointers(root);
    std::vector<Animation> out;
    for (const Json& item : items) {
        HM_TRY_ASSIGN(Animation animation,
                      AnimationReader(pointers, source, scene_node, scene).read(item));
        out.push_back(std::move(animation));
    }
    return out;
}

}  // namespace hm::gltf
