#include "film/store.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <span>
#include <string>
#include <utility>

#include "base/check.h"
#include "base/hash.h"

namespace hm {
namespace {

constexpr std::string_view kVersion = "1";
constexpr std::string_view kSumChannels[] = {"R", "G", "B", "A", "weight", "removed"};
constexpr std::size_t kSumFloats = std::size(kSumChannels);
static_assert(sizeof(PixelSum) == kSumFloats * sizeof(float));

std::string film_key(std::string_view name) {
    return fmt::format("{}{}", kFilmPrefix, name);
}

std::string group_key(std::size_t number) {
    return film_key(fmt::format("light_group.{}", number));
}

// Every `stride`-th value, starting at `at`.
LayerChannel channel_of(std::string name, std::span<const float> values, std::size_t at,
                        std::size_t stride) {
    LayerChannel channel{std::move(name), {}};
    channel.values.reserve(values.size() / stride);
    for (std::size_t i = at; i < values.size(); i += stride)
        channel.values.push_back(values[i]);
    return channel;
}

std::span<const float> floats_of(const std::vector<PixelSum>& sums) {
    return {reinterpret_cast<const float*>(sums.data()), sums.size() * kSumFloats};
}

std::string plane_layer(const FilmPlane& plane) {
    return fmt::format("plane.{}", plane.name);
}

std::string id_layer(std::size_t rank) {
    return fmt::format("ids.{}", rank);
}

// Entry number `rank` of each pixel's list. Ids are stored as bit patterns, because a float cannot
// represent every 32-bit integer.
Layer layer_of_ids(const std::vector<IdList>& ids, std::size_t rank) {
    Layer layer{id_layer(rank), {{"id", {}}, {"count", {}}}};
    for (const IdList& list : ids) {
        const IdCount entry = rank < list.size() ? list[rank] : IdCount{0, 0};
        layer.channels[0].values.push_back(std::bit_cast<float>(entry.id));
        layer.channels[1].values.push_back(entry.count);
    }
    return layer;
}

std::vector<Layer> layers_of(const Film& film) {
    std::vector<Layer> layers;
    Layer& sums = layers.emplace_back(Layer{"sum", {}});
    for (std::size_t c = 0; c < kSumFloats; ++c)
        sums.channels.push_back(
            channel_of(std::string(kSumChannels[c]), floats_of(film.sums), c, kSumFloats));
    for (const FilmPlane& plane : film.planes) {
        Layer& layer = layers.emplace_back(Layer{plane_layer(plane), {}});
        for (std::size_t c = 0; c < plane.floats; ++c)
            layer.channels.push_back(
                channel_of(fmt::format("{}", c), plane.values, c, plane.floats));
    }
    std::size_t longest = 0;
    for (const IdList& list : film.ids)
        longest = std::max(longest, list.size());
    for (std::size_t rank = 0; rank < longest; ++rank)
        layers.push_back(layer_of_ids(film.ids, rank));
    return layers;
}

// The metadata needed to restore the film.
Metadata describe(const Film& film) {
    Metadata text = {{film_key("version"), std::string(kVersion)},
                     {film_key("first_sample"), fmt::format("{}", film.first_sample)}};
    if (const std::string aovs = aov_names(film.selection.aovs); !aovs.empty())
        text.emplace_back(film_key("aovs"), aovs);
    if (film.selection.sample_variance) text.emplace_back(film_key("sample_variance"), "true");
    for (std::size_t i = 0; i < film.selection.light_groups.size(); ++i)
        text.emplace_back(group_key(i), film.selection.light_groups[i]);
    return text;
}

std::string checksum(const Film& film, const FilmLabel& label) {
    Hasher hash;
    const auto add_numbers = [&](std::initializer_list<std::uint32_t> numbers) {
        hash.add(std::as_bytes(std::span(numbers.begin(), numbers.size())));
    };
    add_numbers(
        {label.width, label.height, film.crop.x0, film.crop.y0, film.crop.x1, film.crop.y1});
    hash.add(std::as_bytes(std::span(film.sums)));
    for (const FilmPlane& plane : film.planes)
        hash.add(std::as_bytes(std::span(plane.values)));
    for (const IdList& list : film.ids)
        hash.add(std::as_bytes(std::span(list)));
    Metadata text = describe(film);
    for (const auto& note : label.notes)
        if (!note.second.empty()) text.push_back(note);
    std::sort(text.begin(), text.end());
    for (const auto& [name, value] : text) {
        hash.add(name);
        hash.add(value);
    }
    return hash.text();
}

tl::unexpected<Error> refuse(const std::filesystem::path& path, std::string message,
                             ErrorKind kind = ErrorKind::invalid) {
    return fail(kind, path.string(), "", std::move(message));
}

tl::unexpected<Error> damaged(const std::filesystem::path& path, const std::string& what) {
    return refuse(path, fmt::format("is damaged: {}", what));
}

Result<AovSelection> selection_of(const LayeredImage& picture, const std::filesystem::path& path) {
    AovSelection selection;
    if (const std::string* names = picture.find_metadata(film_key("aovs"))) {
        auto aovs = parse_aovs(*names);
        if (!aovs) return refuse(path, fmt::format("has unknown AOVs: {}", aovs.error()));
        selection.aovs = std::move(*aovs);
    }
    selection.sample_variance = picture.find_metadata(film_key("sample_variance")) != nullptr;
    for (std::size_t i = 0; const std::string* name = picture.find_metadata(group_key(i)); ++i)
        selection.light_groups.push_back(*name);
    return selection;
}

// Copies a channel to every `stride`-th value, starting at `at`.
bool fill(std::span<float> values, std::size_t at, std::size_t stride, const Layer* layer,
          std::string_view name) {
    const LayerChannel* channel = layer ? layer->find(name) : nullptr;
    if (channel == nullptr || channel->type != ChannelType::float32) return false;
    for (std::size_t i = 0; i < channel->values.size(); ++i)
        values[i * stride + at] = channel->values[i];
    return true;
}

bool fill_ids(std::vector<IdList>& ids, const LayeredImage& picture) {
    if (ids.empty()) return true;
    for (std::size_t rank = 0; const Layer* layer = picture.find(id_layer(rank)); ++rank) {
        const LayerChannel* id = layer->find("id");
        const LayerChannel* count = layer->find("count");
        if (id == nullptr || count == nullptr) return false;
        for (std::size_t i = 0; i < ids.size(); ++i)
            if (count->values[i] > 0)
                ids[i].push_back({std::bit_cast<std::uint32_t>(id->values[i]), count->values[i]});
    }
    return true;
}

Result<void> fill_film(Film& film, const LayeredImage& picture, const std::filesystem::path& path) {
    const std::span<float> sums(reinterpret_cast<float*>(film.sums.data()),
                                film.sums.size() * kSumFloats);
    for (std::size_t c = 0; c < kSumFloats; ++c)
        if (!fill(sums, c, kSumFloats, picture.find("sum"), kSumChannels[c]))
            return damaged(path, fmt::format("channel sum.{} is missing", kSumChannels[c]));
    for (FilmPlane& plane : film.planes)
        for (std::size_t c = 0; c < plane.floats; ++c)
            if (!fill(plane.values, c, plane.floats, picture.find(plane_layer(plane)),
                      fmt::format("{}", c)))
                return damaged(path,
                               fmt::format("channel {}.{} is missing", plane_layer(plane), c));
    if (!fill_ids(film.ids, picture)) return damaged(path, "an id or count channel is missing");
    return {};
}

}  // namespace

Result<void> write_film(const std::filesystem::path& path, const Film& film, const FilmLabel& label,
                        ExrCompression compression) {
    HM_CHECK(is_lossless(compression), "compression {}", unsigned(compression));
    const PixelRect& crop = film.crop;
    LayeredImage picture;
    picture.data = {int(crop.x0), int(crop.y0), int(crop.x1), int(crop.y1)};
    picture.display = {0, 0, int(label.width), int(label.height)};
    picture.layers = layers_of(film);
    picture.metadata = describe(film);
    picture.metadata.emplace_back(film_key("checksum"), checksum(film, label));
    for (const auto& note : label.notes) {
        HM_CHECK(!note.first.starts_with(kFilmPrefix), "note {}", note.first);
        if (!note.second.empty()) picture.metadata.push_back(note);
    }
    return write_layers(path, picture, {.compression = compression});
}

Result<StoredFilm> read_film(const std::filesystem::path& path) {
    HM_TRY_ASSIGN(const LayeredImage picture, read_layers(path));
    const std::string* version = picture.find_metadata(film_key("version"));
    if (version == nullptr)
        return refuse(path, "is a picture, not a checkpoint or a part of a rendering");
    if (*version != kVersion)
        return refuse(
            path,
            fmt::format("has version {} of the format; this program has {}", *version, kVersion),
            ErrorKind::unsupported);
    const PictureWindow& data = picture.data;
    const PictureWindow& whole = picture.display;
    if (data.x0 < 0 || data.y0 < 0 || whole.x0 != 0 || whole.y0 != 0 || data.x1 > whole.x1 ||
        data.y1 > whole.y1)
        return damaged(path, "the data window does not fit into the display window");
    HM_TRY_ASSIGN(AovSelection selection, selection_of(picture, path));
    StoredFilm stored{Film({std::uint32_t(data.x0), std::uint32_t(data.y0), std::uint32_t(data.x1),
                            std::uint32_t(data.y1)},
                           std::move(selection)),
                      {whole.width(), whole.height(), {}}};
    const std::string* first = picture.find_metadata(film_key("first_sample"));
    if (first == nullptr ||
        std::from_chars(first->data(), first->data() + first->size(), stored.film.first_sample)
                .ptr != first->data() + first->size())
        return damaged(path, "the attribute film.first_sample is missing or invalid");
    HM_TRY(fill_film(stored.film, picture, path));
    for (const auto& note : picture.metadata)
        if (!note.first.starts_with(kFilmPrefix)) stored.label.notes.push_back(note);
    const std::string* sum = picture.find_metadata(film_key("checksum"));
    if (sum == nullptr || *sum != checksum(stored.film, stored.label))
        return damaged(path, "the checksum does not match");
    return stored;
}

std::uint64_t stored_bytes(const Film& film) {
    std::uint64_t floats = film.sums.size() * kSumFloats;
    for (const FilmPlane& plane : film.planes)
        floats += plane.values.size();
    return floats * sizeof(float) + std::uint64_t(film.crop.height()) * 16;
}

}  // namespace hm
