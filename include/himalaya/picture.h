// A rendered picture: float pixels, the layers asked for, and writing files.
#pragma once

#include <himalaya/export.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace himalaya {

struct Layer {
    std::vector<std::string> channels{};  // "R", "G", "B", or "Z", ...
    std::vector<float> values{};          // pixel by pixel, rows from the top
};

class HIMALAYA_API Picture {
  public:
    Picture(Picture&&) noexcept;
    Picture& operator=(Picture&&) noexcept;
    ~Picture();

    std::uint32_t width() const;  // of the pixels rendered: the crop's, if there is one
    std::uint32_t height() const;
    // R, G, B and A of each pixel, rows from the top: linear Rec.709, premultiplied. Denoised if
    // that was asked for.
    std::span<const float> pixels() const;

    // "albedo", "depth", ...: the AOVs, and with denoising "denoised".
    std::vector<std::string> layer_names() const;
    Layer layer(const std::string& name) const;

    bool complete() const;  // false: cancelled or out of time, with the samples drawn until then
    double samples_per_pixel() const;
    const std::string& device() const;  // that rendered
    const std::vector<std::pair<std::string, std::string>>& metadata() const;
    const std::vector<std::string>& warnings() const;

    // By the extension. .exr: all layers, as rendered. .png: tone mapped. .hdr: linear RGBE.
    void write(const std::filesystem::path& path) const;

    struct Impl;
    explicit Picture(std::unique_ptr<Impl> impl);  // for the library's own use

  private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace himalaya
