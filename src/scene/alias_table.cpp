#include "scene/alias_table.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hm {
namespace {

std::uint32_t to_threshold(double probability) {
    double scaled = std::floor(probability * 4294967296.0);
    return std::uint32_t(std::clamp(scaled, 0.0, 4294967295.0));
}

}  // namespace

std::vector<AliasEntry> build_alias_table(std::span<const float> weights) {
    const std::size_t n = weights.size();
    std::vector<AliasEntry> table(n);
    double sum = 0;
    for (float w : weights)
        sum += double(w);
    if (!(sum > 0)) return table;

    // Underfull slots take the remainder from an overfull slot.
    std::vector<double> fill(n);
    std::vector<std::uint32_t> small, large;
    for (std::size_t i = 0; i < n; ++i) {
        double p = double(weights[i]) / sum;
        fill[i] = p * double(n);
        table[i].pdf_self = float(p);
        (fill[i] < 1.0 ? small : large).push_back(std::uint32_t(i));
    }
    auto set = [&](std::uint32_t slot, double own, std::uint32_t alias) {
        table[slot].threshold = to_threshold(own);
        table[slot].alias = alias;
        table[slot].pdf_alias = table[alias].pdf_self;
    };
    while (!small.empty() && !large.empty()) {
        std::uint32_t low = small.back();
        std::uint32_t high = large.back();
        small.pop_back();
        set(low, fill[low], high);
        fill[high] -= 1.0 - fill[low];
        if (fill[high] < 1.0) {
            large.pop_back();
            small.push_back(high);
        }
    }
    // The remaining slots are full up to rounding; an entry with zero weight must never be sampled.
    std::uint32_t heaviest =
        std::uint32_t(std::max_element(weights.begin(), weights.end()) - weights.begin());
    for (std::uint32_t i : large)
        set(i, 1.0, i);
    for (std::uint32_t i : small) {
        if (weights[i] > 0)
            set(i, 1.0, i);
        else
            set(i, 0.0, heaviest);
    }
    return table;
}

}  // namespace hm
