// The valid base documents from which the broken files of the corpus are derived: they load, and
// the Khronos glTF Validator reports no errors for them.
#pragma once

#include <string>
#include <vector>

#include "corpus/case.h"

namespace hm::corpus {

// The JSON of a document without the uri of its only buffer, and the buffer's bytes.
struct Document {
    std::string_view json;
    std::string buffer;
};

// minimal   only what every file must have
// still     meshes, materials, textures, cameras, lights, nodes
// moving    animations, a skin, morph targets
// extended  variants, instances, quantized vertices
Document document(Base base);

// Tightly packed little-endian values.
std::string floats(const std::vector<float>& values);
std::string shorts(const std::vector<std::uint16_t>& values);
std::string words(const std::vector<std::uint32_t>& values);

}  // namespace hm::corpus
