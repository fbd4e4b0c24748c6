#include <himalaya/render.h>
#include <oneapi/tbb/task_arena.h>

#include <atomic>
#include <exception>
#include <mutex>

#include "library/errors.h"
#include "library/picture_impl.h"
#include "library/scene_impl.h"
#include "library/settings.h"
#include "scene/origin.h"
#include "scene/pose.h"
#include "scene/tangents.h"
#include "session/denoise_layers.h"
#include "session/draw.h"
#include "session/vulkan_devices.h"

namespace himalaya {
namespace {

hm::DeviceChoice choice_of(const DeviceSettings& settings) {
    using Kind = hm::DeviceChoice::Kind;
    return {settings.kind == DeviceSettings::Kind::cpu      ? Kind::cpu
            : settings.kind == DeviceSettings::Kind::vulkan ? Kind::vulkan
                                                            : Kind::automatic,
            settings.index};
}

// The caller's wish to stop: a stop token, or a progress callback that returns false or throws.
class Cancellation {
  public:
    explicit Cancellation(const RenderCallbacks& callbacks) : callbacks_(callbacks) {}

    bool requested() const { return cancelled_ || callbacks_.stop.stop_requested(); }

    // On the session's watching thread, which no exception may leave.
    void report(const hm::ProgressState& s) noexcept {
        if (!callbacks_.progress || cancelled_) return;
        try {
            if (!callbacks_.progress({s.fraction, s.samples_per_pixel, s.rays, s.seconds}))
                cancelled_ = true;
        } catch (...) {
            thrown_ = std::current_exception();
            cancelled_ = true;
        }
    }

    // After the session has ended its thread.
    void rethrow() const {
        if (thrown_) std::rethrow_exception(thrown_);
    }

  private:
    const RenderCallbacks& callbacks_;
    std::atomic<bool> cancelled_ = false;
    std::exception_ptr thrown_;
};

std::string text_of(const hm::NamedValues& values) {
    std::string text;
    for (const auto& [name, value] : values)
        text += (text.empty() ? "" : " ") + name + "=" + value;
    return text;
}

void prepare(Scene::Impl& impl) {
    if (impl.lacks_tangents) hm::prepare_tangents(impl.scene);
    impl.lacks_tangents = false;
    if (impl.lacks_origin) hm::set_origin(impl.scene);
    // Skinned vertices are relative to the origin, and a picture before this one may have posed it.
    if (impl.lacks_origin || !impl.scene.animations.empty())
        value_or_throw(hm::pose_scene(impl.scene, std::nullopt));
    impl.lacks_origin = false;
}

// R, G, B and A of the beauty, or of its denoised version.
std::vector<float> pixels_of(const hm::LayeredImage& layers, bool denoised) {
    const hm::Layer* const beauty = layers.find(denoised ? hm::kDenoisedLayer : "");
    const std::size_t count = layers.data.pixels();
    std::vector<float> pixels(4 * count, 1.0f);
    constexpr const char* kChannels[] = {"R", "G", "B", "A"};
    for (std::size_t c = 0; c < 4; ++c)
        if (const hm::LayerChannel* const channel = beauty->find(kChannels[c]))
            for (std::size_t i = 0; i < count; ++i)
                pixels[4 * i + c] = channel->values[i];
    return pixels;
}

std::unique_ptr<Picture::Impl> finish(const hm::RenderSettings& settings, hm::DrawnPicture drawn,
                                      const hm::Denoiser* denoiser,
                                      const hm::Diagnostics& diagnostics) {
    auto picture = std::make_unique<Picture::Impl>();
    picture->finished = hm::finish_picture(drawn.film, settings.frame.width, settings.frame.height,
                                           drawn.record, denoiser);
    value_or_throw(picture->finished.denoised);
    picture->width = drawn.film.crop.width();
    picture->height = drawn.film.crop.height();
    picture->pixels = pixels_of(picture->finished.layers, denoiser != nullptr);
    picture->complete = drawn.film.fewest_samples() >= settings.sampling.samples;
    picture->samples_per_pixel = drawn.film.mean_samples();
    picture->device = drawn.summary.renderer.device;
    for (const hm::Warning& warning : diagnostics.warnings())
        picture->warnings.push_back(warning.line());
    if (drawn.summary.non_finite > 0)
        picture->warnings.push_back(std::to_string(drawn.summary.non_finite) +
                                    " samples were not finite and count as black");
    return picture;
}

}  // namespace

struct Renderer::Impl {
    unsigned threads = 0;
    hm::Diagnostics diagnostics;  // of the device, which refers to it
    std::mutex mutex;             // of the notes: a device may fail on any thread
    std::vector<std::string> notes;
    std::unique_ptr<hm::RenderDevice> device;

    explicit Impl(const DeviceSettings& settings) : threads(settings.threads) {
        device = value_or_throw(hm::choose_device(
            choice_of(settings), threads,
            [this](const auto& index) { return hm::open_vulkan_device(index, diagnostics); },
            [this](std::string_view note) {
                const std::lock_guard lock(mutex);
                notes.emplace_back(note);
            }));
    }

    Picture render(Scene::Impl& scene, const RenderSettings& settings, Cancellation& cancellation) {
        const hm::RenderSettings s = to_session(settings);
        std::optional<hm::Denoiser> denoiser;
        if (s.denoise.enabled)
            denoiser = value_or_throw(hm::Denoiser::open(s.denoise.device, threads));
        prepare(scene);
        hm::Stage stage{
            *device, scene.scene, {scene.scene.hash, scene.load.scene, scene.load.variant}};
        const hm::DrawHooks hooks{
            .stop = [&] { return cancellation.requested(); },
            .watch = [&](const hm::ProgressState& state) { cancellation.report(state); },
            .warn = [](std::string_view) {},
            .describe =
                [](const hm::RenderSummary& summary) {
                    return hm::MetadataTexts{"", text_of(summary.view)};
                }};
        hm::Diagnostics warnings;
        hm::DrawnPicture drawn = value_or_throw(hm::draw_picture(s, {}, stage, hooks, warnings));
        if (drawn.failed) throw_error(*drawn.failed);
        return Picture(finish(s, std::move(drawn), denoiser ? &*denoiser : nullptr, warnings));
    }
};

Renderer::Renderer(const DeviceSettings& settings)
    : impl_(guarded([&] { return std::make_unique<Impl>(settings); })) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

std::string Renderer::device() const {
    return impl_->device->name();
}

std::vector<std::string> Renderer::messages() const {
    const std::lock_guard lock(impl_->mutex);
    std::vector<std::string> messages = impl_->notes;
    for (const hm::Warning& warning : impl_->diagnostics.warnings())
        messages.push_back(warning.line());
    return messages;
}

Picture Renderer::render(Scene& scene, const RenderSettings& settings,
                         const RenderCallbacks& callbacks) {
    Cancellation cancellation(callbacks);
    Picture picture = guarded([&] {
        const auto draw = [&] { return impl_->render(scene.impl(), settings, cancellation); };
        if (impl_->threads == 0) return draw();
        oneapi::tbb::task_arena arena{int(impl_->threads)};
        return arena.execute(draw);
    });
    cancellation.rethrow();
    return picture;
}

Picture render(Scene& scene, const RenderSettings& settings) {
    return Renderer().render(scene, settings);
}

}  // namespace himalaya
