#include "denoise/denoise.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <span>
#include <utility>
#include <vector>

#include "base/check.h"
#include "denoise/finite.h"
#include "denoise/oidn_library.h"

namespace hm {
namespace {

using Floats = std::vector<float>;

oidn::DeviceType device_type(DenoiseDevice device) {
    switch (device) {
        case DenoiseDevice::cpu:
            return oidn::kCpu;
        case DenoiseDevice::cuda:
            return oidn::kCuda;
        case DenoiseDevice::hip:
            return oidn::kHip;
        case DenoiseDevice::sycl:
            return oidn::kSycl;
        case DenoiseDevice::fastest:
            break;
    }
    return oidn::kDefault;
}

const char* error_name(oidn::ErrorCode code) {
    switch (code) {
        case oidn::kNoError:
            return "no error";
        case oidn::kInvalidArgument:
            return "invalid argument";
        case oidn::kInvalidOperation:
            return "invalid operation";
        case oidn::kOutOfMemory:
            return "out of memory";
        case oidn::kUnsupportedHardware:
            return "unsupported hardware";
        case oidn::kUnknown:
            break;
    }
    return "unknown error";
}

Result<oidn::PhysicalDevice> choose(const oidn::Library& library, DenoiseDevice wanted) {
    const oidn::DeviceType type = device_type(wanted);
    std::string found;
    for (oidn::PhysicalDevice& device : oidn::physical_devices(library)) {
        if (type == oidn::kDefault || device.type == type) return std::move(device);
        found += fmt::format("{}{} ({})", found.empty() ? "" : ", ", type_name(device.type),
                             device.name);
    }
    return fail(ErrorKind::no_device, "", "",
                fmt::format("{} has no {} device; it finds {}", library.file.string(),
                            type == oidn::kDefault ? "usable" : type_name(type),
                            found.empty() ? "none" : found));
}

void check_picture(const FloatImage& image, const FloatImage& like) {
    HM_CHECK(image.width == like.width && image.height == like.height &&
                 image.pixels.size() == std::size_t(image.width) * image.height,
             "{} x {} with {} pixels beside {} x {}", image.width, image.height,
             image.pixels.size(), like.width, like.height);
}

// `channels` of each pixel's four, from `first` on.
Floats pick(const FloatImage& image, std::ptrdiff_t first, std::ptrdiff_t channels) {
    Floats out;
    out.reserve(image.pixels.size() * std::size_t(channels));
    for (const Rgba<float>& pixel : image.pixels)
        out.insert(out.end(), pixel.begin() + first, pixel.begin() + first + channels);
    return out;
}

Floats pick_within(const FloatImage& image, float low, float high, std::uint64_t& replaced) {
    Floats values = pick(image, 0, 3);
    replaced += replace_non_finite(values, image.width, 3);
    for (float& v : values)
        v = std::clamp(v, low, high);
    return values;
}

// Where every pixel has the same there is no noise to take out.
bool varies(const Floats& values) {
    return std::any_of(values.begin(), values.end(), [&](float v) { return v != values.front(); });
}

}  // namespace

struct Denoiser::Impl {
    oidn::Api api;
    oidn::Device device = nullptr;
    std::string description;

    ~Impl() {
        if (device != nullptr) api.ReleaseDevice(device);
    }

    // The first thing that went wrong since the last call.
    Result<void> status(const char* doing) const {
        const char* message = nullptr;
        const oidn::ErrorCode code = api.GetDeviceError(device, &message);
        if (code == oidn::kNoError) return {};
        return fail(ErrorKind::device_failed, "", "",
                    fmt::format("{}: {}: {}: {}", description, doing, error_name(code),
                                message != nullptr ? message : ""));
    }
};

namespace {

// One filter over images of one size; what it needs lives as long as it does.
class Filter {
  public:
    Filter(const oidn::Api& api, oidn::Device device, const FloatImage& size)
        : api_(api),
          device_(device),
          width_(size.width),
          height_(size.height),
          filter_(api.NewFilter(device, "RT")) {}
    Filter(const Filter&) = delete;
    Filter& operator=(const Filter&) = delete;
    ~Filter() {
        for (const oidn::Buffer buffer : buffers_)
            api_.ReleaseBuffer(buffer);
        api_.ReleaseFilter(filter_);
    }

    void set(const char* name, const Floats& values) {
        api_.WriteBuffer(add(name, values.size()), 0, values.size() * 4, values.data());
    }
    void set(const char* name, bool value) { api_.SetFilterBool(filter_, name, value); }

    void run(Floats& output) {
        const oidn::Buffer buffer = add("output", output.size());
        api_.CommitFilter(filter_);
        api_.ExecuteFilter(filter_);
        api_.ReadBuffer(buffer, 0, output.size() * 4, output.data());
    }

  private:
    oidn::Buffer add(const char* name, std::size_t floats) {
        const oidn::Buffer buffer = api_.NewBuffer(device_, floats * 4);
        buffers_.push_back(buffer);
        const bool color = floats == 3 * width_ * height_;
        api_.SetFilterImage(filter_, name, buffer, color ? oidn::kFloat3 : oidn::kFloat, width_,
                            height_, 0, 0, 0);
        return buffer;
    }

    const oidn::Api& api_;
    oidn::Device device_;
    std::size_t width_, height_;
    oidn::Filter filter_;
    std::vector<oidn::Buffer> buffers_;
};

struct Guide {
    const char* name;
    Floats values;
};

}  // namespace

Denoiser::Denoiser(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Denoiser::Denoiser(Denoiser&&) noexcept = default;
Denoiser& Denoiser::operator=(Denoiser&&) noexcept = default;
Denoiser::~Denoiser() = default;

const std::string& Denoiser::description() const {
    return impl_->description;
}

Result<Denoiser> Denoiser::open(DenoiseDevice wanted, unsigned threads) {
    HM_TRY_ASSIGN(const oidn::Library library, oidn::load_library());
    HM_TRY_ASSIGN(const oidn::PhysicalDevice found, choose(library, wanted));
    auto impl = std::make_unique<Impl>();
    impl->api = library.api;
    impl->description =
        fmt::format("Open Image Denoise on {} ({})", type_name(found.type), found.name);
    impl->device = impl->api.NewDeviceByID(found.id);
    HM_TRY(impl->status("opening the device"));
    if (found.type == oidn::kCpu) {
        impl->api.SetDeviceInt(impl->device, "numThreads", int(threads));
        // The threads are shared with the renderer, which wants them where the system puts them.
        impl->api.SetDeviceBool(impl->device, "setAffinity", false);
    }
    impl->api.CommitDevice(impl->device);
    HM_TRY(impl->status("starting the device"));
    const auto number = [&](const char* name) {
        return impl->api.GetDeviceInt(impl->device, name);
    };
    impl->description = fmt::format("Open Image Denoise {}.{}.{} on {} ({})",
                                    number("versionMajor"), number("versionMinor"),
                                    number("versionPatch"), type_name(found.type), found.name);
    return Denoiser(std::move(impl));
}

Result<Denoised> Denoiser::denoise(const DenoiseInput& input) const {
    HM_CHECK(input.beauty != nullptr && input.beauty->width > 0, "a beauty is needed");
    const auto start = std::chrono::steady_clock::now();
    const FloatImage& beauty = *input.beauty;
    const oidn::Api& api = impl_->api;
    check_picture(beauty, beauty);
    Denoised result{beauty, 0, 0};

    std::vector<Guide> guides;
    const auto add_guide = [&](const char* name, const FloatImage* image, float low, float high) {
        if (image == nullptr) return;
        check_picture(*image, beauty);
        Floats values = pick_within(*image, low, high, result.replaced_pixels);
        if (!input.clean_guides) {
            Filter filter(api, impl_->device, beauty);
            filter.set(name, values);
            filter.run(values);
        }
        guides.push_back({name, std::move(values)});
    };
    add_guide("albedo", input.albedo, 0, 1);
    // The library does not take normals without an albedo.
    HM_CHECK(input.albedo != nullptr || input.normal == nullptr, "a normal without an albedo");
    add_guide("normal", input.normal, -1, 1);

    const auto filter_with_guides = [&](Floats& values) {
        Filter filter(api, impl_->device, beauty);
        filter.set("color", values);
        for (const Guide& guide : guides)
            filter.set(guide.name, guide.values);
        filter.set("hdr", true);
        filter.set("cleanAux", !guides.empty());
        filter.run(values);
    };
    Floats pixels = pick(beauty, 0, 4);
    result.replaced_pixels += replace_non_finite(pixels, beauty.width, 4);
    Floats color, alpha;
    color.reserve(beauty.pixels.size() * 3);
    alpha.reserve(beauty.pixels.size());
    for (std::size_t i = 0; i < pixels.size(); i += 4) {
        color.insert(color.end(), {pixels[i], pixels[i + 1], pixels[i + 2]});
        alpha.push_back(pixels[i + 3]);
    }
    filter_with_guides(color);
    // As radiance too: as a value of a display it would be averaged along a curve, to another mean.
    if (input.alpha && varies(alpha)) filter_with_guides(alpha);
    HM_TRY(impl_->status("filtering"));

    for (std::size_t i = 0; i < alpha.size(); ++i) {
        result.picture.pixels[i] = {color[3 * i], color[3 * i + 1], color[3 * i + 2],
                                    std::clamp(alpha[i], 0.0f, 1.0f)};
    }
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

}  // namespace hm
