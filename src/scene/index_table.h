// A hash table of indices, for finding the equal elements of an array in linear time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shading/structs.h"

namespace hm {

class IndexTable {
  public:
    explicit IndexTable(std::size_t expected) {
        std::size_t size = 16;
        while (size < 2 * expected)
            size *= 2;
        entries_.resize(size);
    }

    // Returns the index in the table whose element equals the searched one, or else adds and
    // returns `index`. `equal(i)` compares the searched element with element i; equal elements must
    // have the same hash.
    template <class Equal>
    std::uint32_t find_or_add(std::uint64_t hash, std::uint32_t index, const Equal& equal) {
        if (2 * (count_ + 1) > entries_.size()) grow();
        const auto tag = static_cast<std::uint32_t>(hash >> 32);
        Entry* entry = first(tag);
        for (; entry->index != kNone; entry = after(entry))
            if (entry->tag == tag && equal(entry->index)) return entry->index;
        *entry = {tag, index};
        ++count_;
        return index;
    }

  private:
    struct Entry {
        std::uint32_t tag = 0;
        std::uint32_t index = kNone;
    };

    Entry* first(std::uint32_t tag) { return &entries_[tag & (entries_.size() - 1)]; }
    Entry* after(Entry* entry) { return entry == &entries_.back() ? entries_.data() : entry + 1; }

    void grow() {
        std::vector<Entry> old(2 * entries_.size());
        old.swap(entries_);
        for (const Entry& moved : old) {
            if (moved.index == kNone) continue;
            Entry* entry = first(moved.tag);
            while (entry->index != kNone)
                entry = after(entry);
            *entry = moved;
        }
    }

    std::vector<Entry> entries_;  // size is a power of two, at most half full
    std::size_t count_ = 0;
};

// Hashes the words so that the upper 32 bits depend on all of them.
inline std::uint64_t hash_words(std::span<const std::uint32_t> words) {
    std::uint64_t hash = words.size();
    for (const std::uint32_t word : words) {
        hash = (hash ^ word) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 29;
    }
    return hash * 0xbf58476d1ce4e5b9u;
}

}  // namespace hm
