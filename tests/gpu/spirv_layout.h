// How a SPIR-V module lays out its buffers and payloads, as SPIRV-Cross reads it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace hm::test {

struct StructLayout {
    std::size_t size = 0;       // to the end of the last member
    std::size_t row_bytes = 0;  // the stride of arrays of this struct; 0: there is none
    bool has_gaps = false;      // between members, in the order of the declaration
};

// Structs that lie in buffers, by name.
std::map<std::string, StructLayout> read_structs(std::span<const std::uint32_t> spirv);

struct BlockLayout {
    std::uint32_t set = 0;
    std::uint32_t binding = 0;
    std::size_t row_bytes = 0;  // of the array that is its last member; 0: it is not an array
};

// Uniform and storage blocks that the module uses, by name.
std::map<std::string, BlockLayout> read_blocks(std::span<const std::uint32_t> spirv);

// Bytes of the ray payloads that a stage declares, by the struct's name; booleans count 4.
std::map<std::string, std::size_t> read_payload_sizes(std::span<const std::uint32_t> spirv);

}  // namespace hm::test
