#include "scene/image_view.h"

#include <array>

#include "shading/color.h"

namespace hm {

const float* srgb_table() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> t{};
        for (std::size_t i = 0; i < t.size(); ++i)
            t[i] = srgb_to_linear(float(i) / 255.0f);
        return t;
    }();
    return table.data();
}

}  // namespace hm
