#include "denoise/denoise.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <span>
#include <utility>
#include <vector>

#include "base/check.h"
#include "denoise/finite.h"
#include "denoise/mirror.h"
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

// Smaller pictures are padded (mirror.h).
constexpr std::uint32_t kSmallestSide = 128;

// Replaces negative values by 0; returns the number of such pixels.
std::uint64_t clip_negative(Floats& values, std::size_t channels) {
    std::uint64_t pixels = 0;
    for (std::size_t i = 0; i < values.size(); i += channels) {
        bool negative = false;
        for (std::size_t c = i; c < i + channels; ++c) {
            negative |= values[c] < 0.0f;
            values[c] = std::max(values[c], 0.0f);
        }
        pixels += negative;
    }
    return pixels;
}

// `channels` of each pixel's four channels, starting at `first`.
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

// The scale that brings the mean luminance to a grey like that of the library's training data; 1 if
// it is within a factor of a thousand, or black.
float sane_scale(const Floats& color) {
    constexpr double kGrey = 0.18, kFar = 1000.0;
    double sum = 0;
    for (const float v : color)
        sum += double(v);
    const double mean = sum / double(color.size());
    if (!(mean > 0.0) || (mean > kGrey / kFar && mean < kGrey * kFar)) return 1.0f;
    return float(std::clamp(kGrey / mean, 1e-37, 1e37));
}

// Whether alpha has one value, 0 or 1, at pixel i and at the eight around it.
bool is_certain(const Floats& alpha, std::size_t i, std::size_t width) {
    const float value = alpha[i];
    if (value != 0.0f && value != 1.0f) return false;
    const std::size_t x = i % width, y = i / width, height = alpha.size() / width;
    for (std::size_t v = y - (y > 0); v <= std::min(y + 1, height - 1); ++v)
        for (std::size_t u = x - (x > 0); u <= std::min(x + 1, width - 1); ++u)
            if (alpha[v * width + u] != value) return false;
    return true;
}

// Constant alpha has no noise.
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

    // The first error since the last call.
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

// A filter for images of one size; owns its buffers.
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
        // The threads are shared with the renderer, so they must not be pinned.
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

Result<Denoised> Denoiser::denoise_mirrored(const DenoiseInput& input) const {
    FloatImage images[3];
    DenoiseInput larger = input;
    const FloatImage** const pictures[] = {&larger.beauty, &larger.albedo, &larger.normal};
    std::uint64_t replaced = 0;  // without the padding
    for (std::size_t i = 0; i < 3; ++i) {
        if (*pictures[i] == nullptr) continue;
        check_picture(**pictures[i], *input.beauty);
        const std::ptrdiff_t channels = i == 0 ? 4 : 3;
        Floats values = pick(**pictures[i], 0, channels);
        replaced += replace_non_finite(values, input.beauty->width, std::size_t(channels));
        images[i] = mirrored(**pictures[i], kSmallestSide);
        *pictures[i] = &images[i];
    }
    HM_TRY_ASSIGN(Denoised result, denoise(larger));
    result.picture = middle(result.picture, input.beauty->width, input.beauty->height);
    result.replaced_pixels = replaced;
    Floats color = pick(*input.beauty, 0, 3);
    replace_non_finite(color, input.beauty->width, 3);
    result.negative_pixels = clip_negative(color, 3);
    return result;
}

Result<Denoised> Denoiser::denoise(const DenoiseInput& input) const {
    HM_CHECK(input.beauty != nullptr && input.beauty->width > 0, "a beauty is needed");
    if (std::min(input.beauty->width, input.beauty->height) < kSmallestSide)
        return denoise_mirrored(input);
    const auto start = std::chrono::steady_clock::now();
    const FloatImage& beauty = *input.beauty;
    const oidn::Api& api = impl_->api;
    check_picture(beauty, beauty);
    Denoised result{.picture = beauty};

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
    // The library does not accept normals without albedo.
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
    result.negative_pixels = clip_negative(color, 3);
    const float scale = sane_scale(color);
    for (float& v : color)
        v *= scale;
    filter_with_guides(color);
    for (float& v : color)
        v /= scale;
    const Floats noisy_alpha = alpha;
    // Also in HDR mode: in LDR mode it would be averaged through a tone curve, which shifts the
    // mean.
    if (input.alpha && varies(alpha)) filter_with_guides(alpha);
    HM_TRY(impl_->status("filtering"));

    for (std::size_t i = 0; i < alpha.size(); ++i) {
        const bool certain = is_certain(noisy_alpha, i, beauty.width);
        result.picture.pixels[i] = {color[3 * i], color[3 * i + 1], color[3 * i + 2],
                                    certain ? noisy_alpha[i] : std::clamp(alpha[i], 0.0f, 1.0f)};
    }
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

}  // namespace hm
