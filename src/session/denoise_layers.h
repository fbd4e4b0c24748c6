// Denoises a layered picture, guided by the albedo and normal layers in its file.
#pragma once

#include "denoise/denoise.h"
#include "image/layers.h"

namespace hm {

// The layer of the denoised picture in a file; the beauty stays the noisy one.
inline constexpr const char* kDenoisedLayer = "denoised";

struct Guidance {
    bool without = false;  // by the colours alone
    bool clean = false;    // albedo and normal are free of noise
};

// Denoises the beauty into the layer "denoised" and says so in the metadata. Fails with
// ErrorKind::invalid and no file name if a layer is missing.
Result<Denoised> denoise_layers(const Denoiser& denoiser, LayeredImage& picture,
                                const Guidance& guidance);

}  // namespace hm
