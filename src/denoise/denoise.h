// Denoising with Intel Open Image Denoise, guided by albedo and normal. The noisy picture is not
// changed; the result is a biased estimate that is usually closer to the converged picture.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "base/result.h"
#include "image/image.h"

namespace hm {

enum class DenoiseDevice { fastest, cpu, cuda, hip, sycl };

// Pictures of one size, rgba32f.
struct DenoiseInput {
    const FloatImage* beauty = nullptr;  // premultiplied, linear
    const FloatImage* albedo = nullptr;  // null: none; clamped to [0, 1]
    const FloatImage* normal = nullptr;  // null: none; clamped to [-1, 1], of any length
    bool alpha = false;                  // the beauty's alpha is to be denoised; else it is kept
    // Albedo and normal are noise-free. Otherwise they are prefiltered.
    bool clean_guides = false;
};

struct Denoised {
    FloatImage picture;  // premultiplied
    // Pixels of the beauty and the guides with NaN or infinity, replaced by the mean of their
    // finite neighbours, larger holes from their edges inwards.
    std::uint64_t replaced_pixels = 0;
    std::uint64_t negative_pixels = 0;  // of the beauty; negative values became 0
    double seconds = 0;
};

class Denoiser {
  public:
    // Finds the library (film/oidn_library.h) and one of its devices. threads 0: all cores. Fails
    // with ErrorKind::no_device if either is missing.
    static Result<Denoiser> open(DenoiseDevice device, unsigned threads);

    Denoiser(Denoiser&&) noexcept;
    Denoiser& operator=(Denoiser&&) noexcept;
    ~Denoiser();

    // For people: "Open Image Denoise 2.5.1 on cpu (AMD EPYC ...)".
    const std::string& description() const;

    // Pictures of any size (small ones are padded by mirroring) and any unit of radiance (rescaled,
    // since the library treats less than 1e-8 as black). Alpha that is 0 or 1 at a pixel and all
    // its neighbours is kept. The library splits pictures that exceed the device's memory into
    // tiles.
    Result<Denoised> denoise(const DenoiseInput& input) const;

  private:
    Result<Denoised> denoise_mirrored(const DenoiseInput& input) const;

    struct Impl;
    explicit Denoiser(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace hm
