// The valid documents that the corpus's files are broken versions of: they load, and Khronos'
// validator finds no error in them.
#pragma once

#include <string>
#include <vector>

#include "corpus/case.h"

namespace hm::corpus {

// A document's JSON without the uri of its only buffer, and that buffer.
struct Document {
    std::string_view json;
    std::string buffer;
};

// minimal   nothing but what every file has
// still     meshes, materials, textures, cameras, lights, nodes
// moving    animations, a skin, morph targets
// extended  variants, instances, quantized vertices
Document document(Base base);

// Little-endian values, one after the other.
std::string floats(const std::vector<float>& values);
std::string shorts(const std::vector<std::uint16_t>& values);
std::string words(const std::vector<std::uint32_t>& values);

}  // namespace hm::corpus
