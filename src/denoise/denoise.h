// Denoising by Intel Open Image Denoise, guided by albedo and normal. The noisy picture stays as it
// is; what comes back is another one, biased and mostly closer to the truth.
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
    const FloatImage* albedo = nullptr;  // null: none; taken as within [0, 1]
    const FloatImage* normal = nullptr;  // null: none; taken as within [-1, 1], of any length
    bool alpha = false;                  // the beauty's alpha is to be denoised; else it is kept
    // Albedo and normal are free of noise. Else they are denoised before they guide.
    bool clean_guides = false;
};

struct Denoised {
    FloatImage picture;  // premultiplied
    // Pixels of the beauty and the guides that were NaN or infinite; they were replaced by the mean
    // of their finite neighbours, larger holes from their edges inwards.
    std::uint64_t replaced_pixels = 0;
    std::uint64_t negative_pixels = 0;  // of the beauty; negative values became 0
    double seconds = 0;
};

class Denoiser {
  public:
    // Finds the library (film/oidn_library.h) and one of its devices. threads 0: all cores. Fails
    // with ErrorKind::no_device where either is missing.
    static Result<Denoiser> open(DenoiseDevice device, unsigned threads);

    Denoiser(Denoiser&&) noexcept;
    Denoiser& operator=(Denoiser&&) noexcept;
    ~Denoiser();

    // For people: "Open Image Denoise 2.5.1 on cpu (AMD EPYC ...)".
    const std::string& description() const;

    // Of any size (small ones are continued by their mirror images) and in any unit of radiance
    // (the library takes less than 1e-8 for black). Alpha that is 0 or 1 at a pixel and all around
    // it stays so. Pictures too large for the device's memory are cut into tiles by the library.
    Result<Denoised> denoise(const DenoiseInput& input) const;

  private:
    Result<Denoised> denoise_mirrored(const DenoiseInput& input) const;

    struct Impl;
    explicit Denoiser(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace hm
