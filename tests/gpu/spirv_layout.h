// How a SPIR-V module lays out the structs of its buffers: the few instructions of the binary that
// say so (SPIR-V specification 1.5, sections 2.3, 3.32 and 3.20).
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>

#include "gpu/compute.h"

namespace hm::test {

struct StructLayout {
    std::map<std::string, std::size_t> offsets;         // of members, bytes
    std::map<std::string, std::size_t> matrix_strides;  // of members that are matrices
    std::size_t array_stride = 0;  // of arrays of this struct; 0: there is none
};

// Bytes of the payloads that a ray-tracing stage declares, by the struct's name; booleans count 4.
std::map<std::string, std::size_t> read_payload_sizes(std::span<const std::uint32_t> spirv);

// By the struct's name. Structs without offsets, which no buffer holds, are left out.
std::map<std::string, StructLayout> read_struct_layouts(std::span<const std::uint32_t> spirv);

}  // namespace hm::test
