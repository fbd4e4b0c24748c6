// Appends accessors to the six of the tests' base document.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "gltf/test_files.h"

namespace hm::gltf_test {

class Accessors {
  public:
    // Returns the accessor's index. `rest` is further JSON, beginning with a comma.
    template <class T>
    std::size_t add(const char* type, int component, std::size_t count,
                    const std::vector<T>& values, const std::string& rest = "") {
        const std::string data = bytes_of(values);
        views_ += fmt::format(R"(,{{"buffer":0,"byteOffset":{},"byteLength":{}}})", bytes_.size(),
                              data.size());
        accessors_ +=
            fmt::format(R"(,{{"bufferView":{},"componentType":{},"type":"{}","count":{}{}}})",
                        next_, component, type, count, rest);
        bytes_ += data;
        bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
        return next_++;
    }
    // With min and max.
    std::size_t floats(const char* type, std::size_t count, const std::vector<float>& values) {
        const std::size_t width = values.size() / count;
        std::vector<float> low(values.begin(), values.begin() + std::ptrdiff_t(width)), high = low;
        for (std::size_t i = width; i < values.size(); ++i) {
            low[i % width] = std::min(low[i % width], values[i]);
            high[i % width] = std::max(high[i % width], values[i]);
        }
        const bool finite = std::all_of(values.begin(), values.end(),
                                        [](float value) { return std::isfinite(value); });
        const auto list = [](const std::vector<float>& v) {
            std::string text;
            for (const float value : v)
                text.append(text.empty() ? "" : ",").append(fmt::to_string(value));
            return text;
        };
        return add(type, 5126, count, values,
                   finite ? fmt::format(R"(,"min":[{}],"max":[{}])", list(low), list(high)) : "");
    }

    // Properties for document(): these accessors and `more`.
    Overrides with(const Overrides& more) const {
        Overrides all{{"buffers", buffers(bytes_)},
                      {"bufferViews", R"([
            {"buffer":0,"byteOffset":0,"byteLength":36},
            {"buffer":0,"byteOffset":36,"byteLength":36},
            {"buffer":0,"byteOffset":72,"byteLength":24},
            {"buffer":0,"byteOffset":96,"byteLength":6},
            {"buffer":0,"byteOffset":104,"byteLength":12},
            {"buffer":0,"byteOffset":116,"byteLength":48})" +
                                          views_ + "]"},
                      {"accessors", R"([
            {"bufferView":0,"componentType":5126,"type":"VEC3","count":3,
             "min":[0,0,0],"max":[1,2,0]},
            {"bufferView":1,"componentType":5126,"type":"VEC3","count":3},
            {"bufferView":2,"componentType":5126,"type":"VEC2","count":3},
            {"bufferView":3,"componentType":5123,"type":"SCALAR","count":3},
            {"bufferView":4,"componentType":5121,"type":"VEC4","count":3,"normalized":true},
            {"bufferView":5,"componentType":5126,"type":"VEC4","count":3})" +
                                        accessors_ + "]"}};
        for (const auto& [key, value] : more)
            all[key] = value;
        return all;
    }

  private:
    std::string bytes_ = triangle_bytes(), views_, accessors_;
    std::size_t next_ = 6;
};

}  // namespace hm::gltf_test
