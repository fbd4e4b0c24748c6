#include "keep/pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "image/layers.h"

namespace hm::test {
namespace {

template <class Compare>
void compare(const std::string& a, const std::string& b, Compare compare_values) {
    const auto one = read_layers(a), other = read_layers(b);
    ASSERT_TRUE(one) << one.error().line();
    ASSERT_TRUE(other) << other.error().line();
    EXPECT_EQ(one->data, other->data);
    EXPECT_EQ(one->display, other->display);
    ASSERT_EQ(one->layers.size(), other->layers.size());
    for (std::size_t l = 0; l < one->layers.size(); ++l) {
        const Layer& layer = one->layers[l];
        EXPECT_EQ(layer.name, other->layers[l].name);
        ASSERT_EQ(layer.channels.size(), other->layers[l].channels.size());
        for (std::size_t c = 0; c < layer.channels.size(); ++c) {
            const LayerChannel& channel = layer.channels[c];
            EXPECT_EQ(channel.name, other->layers[l].channels[c].name);
            SCOPED_TRACE(layer.name + "." + channel.name + " of " + a + " and " + b);
            compare_values(layer.name, channel.values, other->layers[l].channels[c].values);
        }
    }
}

}  // namespace

void expect_same_pixels(const std::string& a, const std::string& b) {
    compare(a, b,
            [](const std::string&, const std::vector<float>& one, const std::vector<float>& other) {
                ASSERT_EQ(one.size(), other.size());
                EXPECT_EQ(std::memcmp(one.data(), other.data(), one.size() * sizeof(float)), 0);
            });
}

void expect_near_pixels(const std::string& a, const std::string& b, float roundings) {
    compare(
        a, b,
        [=](const std::string& layer, const std::vector<float>& one,
            const std::vector<float>& other) {
            const float allowed = (layer == "variance" ? 1000 : 1) * roundings * 0x1p-23f;
            ASSERT_EQ(one.size(), other.size());
            for (std::size_t i = 0; i < one.size(); ++i) {
                if (one[i] == other[i]) continue;  // also handles infinities
                ASSERT_LE(std::abs(one[i] - other[i]), allowed * std::max(std::abs(one[i]), 1.0f))
                    << i;
            }
        });
}

}  // namespace hm::test
