#include "session/denoise_layers.h"

#include <fmt/format.h>

#include <utility>

namespace hm {
namespace {

Result<FloatImage> guide(const LayeredImage& picture, const char* name) {
    if (const Layer* layer = picture.find(name)) return layer_image(picture, *layer);
    return tl::unexpected(Error{ErrorKind::invalid, "", "",
                                fmt::format("has no layer \"{}\" to guide the denoiser", name),
                                "without-guides"});
}

// Replaces an earlier one.
void set_layer(LayeredImage& picture, Layer layer) {
    for (Layer& old : picture.layers)
        if (old.name == layer.name) {
            old = std::move(layer);
            return;
        }
    picture.layers.push_back(std::move(layer));
}

void set_metadata(LayeredImage& picture, const std::string& key, std::string value) {
    for (auto& [name, old] : picture.metadata)
        if (name == key) {
            old = std::move(value);
            return;
        }
    picture.metadata.emplace_back(key, std::move(value));
}

}  // namespace

Result<Denoised> denoise_layers(const Denoiser& denoiser, LayeredImage& picture,
                                const Guidance& guidance) {
    const Layer* const noisy = picture.find("");
    if (noisy == nullptr || !noisy->find("R") || !noisy->find("G") || !noisy->find("B"))
        return fail(ErrorKind::invalid, "", "",
                    "has no picture: channels R, G and B without a layer's name");
    const bool alpha = noisy->find("A") != nullptr;
    const ChannelType type = noisy->find("R")->type;
    const FloatImage beauty = layer_image(picture, *noisy);
    FloatImage albedo, normal;
    if (!guidance.without) {
        HM_TRY_ASSIGN(albedo, guide(picture, "albedo"));
        HM_TRY_ASSIGN(normal, guide(picture, "normal"));
    }
    HM_TRY_ASSIGN(Denoised denoised,
                  denoiser.denoise({.beauty = &beauty,
                                    .albedo = guidance.without ? nullptr : &albedo,
                                    .normal = guidance.without ? nullptr : &normal,
                                    .alpha = alpha,
                                    .clean_guides = guidance.clean}));
    Layer layer = make_layer(kDenoisedLayer, denoised.picture, alpha);
    for (LayerChannel& channel : layer.channels)
        channel.type = type;
    set_layer(picture, std::move(layer));
    set_metadata(picture, "denoiser", denoiser.description());
    return denoised;
}

}  // namespace hm
