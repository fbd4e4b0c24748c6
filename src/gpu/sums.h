// A film's sums of radiance in device memory: the images that samples are added to.
#pragma once

#include <vector>

#include "film/film.h"
#include "rhi/image.h"

namespace hm {

class GpuSums {
  public:
    struct Values {
        std::vector<vec4> radiance;  // and alpha
        std::vector<float> removed;  // empty where nothing clamps
    };

    // Starts from the film's sums. `clamps`: luminance that clamping removes is summed too.
    static Result<GpuSums> create(rhi::Device& device, const Film& film, bool clamps);

    // Both in layout general and of the crop's size, except that removed luminance is 1 x 1 without
    // clamping.
    const rhi::Image& accumulation() const { return accumulation_; }
    const rhi::Image& removed() const { return removed_; }

    Result<Values> download(rhi::Device& device) const;

  private:
    rhi::Image accumulation_;
    rhi::Image removed_;
    bool clamps_ = false;
};

}  // namespace hm
