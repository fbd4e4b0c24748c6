// Shared by reading and writing OpenEXR.
#pragma once

#include <ImfHeader.h>
#include <ImfStandardAttributes.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <string_view>

#include "image/color_space.h"
#include "image/layers.h"

namespace hm {

// Attributes that describe how pixels are stored; every header has its own.
inline bool describes_storage(std::string_view attribute) {
    constexpr std::string_view kStorage[] = {
        "channels", "compression", "dataWindow", "displayWindow", "lineOrder", "tiles",
        "type",     "name",        "version",    "chunkCount",    "preview"};
    return std::find(std::begin(kStorage), std::end(kStorage), attribute) != std::end(kStorage);
}

// The other attributes of a file, except strings, which are metadata.
struct ExrAttributes {
    Imf::Header header;
};

// Rec. 709 unless the file specifies others.
inline Chromaticities chromaticities_of(const Imf::Header& header) {
    if (!Imf::hasChromaticities(header)) return kRec709;
    const Imf::Chromaticities& c = Imf::chromaticities(header);
    const auto xy = [](const Imath::V2f& v) { return std::array{double(v.x), double(v.y)}; };
    return {xy(c.red), xy(c.green), xy(c.blue), xy(c.white)};
}

inline std::string full_name(const Layer& layer, const LayerChannel& channel) {
    return layer.name.empty() ? channel.name : layer.name + "." + channel.name;
}

}  // namespace hm
