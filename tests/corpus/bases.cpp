#include "corpus/bases.h"

#include "corpus/container.h"

namespace hm::corpus {
namespace {

// Bytes 0-35 positions, 36-71 normals, 72-95 texture coordinates, 96-101 indices, 104-115 colours,
// 116-163 tangents, 164 one sparse index, 168-179 its position, 180-249 a PNG.
constexpr std::string_view kStill = R"({
"asset":{"version":"2.0","minVersion":"2.0","generator":"corpus","copyright":"none"},
"extensionsUsed":["KHR_lights_punctual","KHR_materials_emissive_strength","KHR_materials_unlit",
  "KHR_texture_transform"],
"extensions":{"KHR_lights_punctual":{"lights":[
  {"name":"point","type":"point","color":[1,1,1],"intensity":1,"range":10},
  {"name":"spot","type":"spot","spot":{"innerConeAngle":0.1,"outerConeAngle":0.5}},
  {"type":"directional"}]}},
"buffers":[{"name":"all","byteLength":252}],
"bufferViews":[
  {"name":"v","buffer":0,"byteOffset":0,"byteLength":36,"byteStride":12,"target":34962},
  {"buffer":0,"byteOffset":36,"byteLength":36,"target":34962},
  {"buffer":0,"byteOffset":72,"byteLength":24,"target":34962},
  {"buffer":0,"byteOffset":96,"byteLength":6,"target":34963},
  {"buffer":0,"byteOffset":104,"byteLength":12,"target":34962},
  {"buffer":0,"byteOffset":116,"byteLength":48,"target":34962},
  {"buffer":0,"byteOffset":164,"byteLength":4},
  {"buffer":0,"byteOffset":168,"byteLength":12},
  {"buffer":0,"byteOffset":180,"byteLength":70}],
"accessors":[
  {"name":"p","bufferView":0,"byteOffset":0,"componentType":5126,"normalized":false,"type":"VEC3",
   "count":3,"min":[0,0,0],"max":[1,2,0]},
  {"bufferView":1,"componentType":5126,"type":"VEC3","count":3},
  {"bufferView":2,"componentType":5126,"type":"VEC2","count":3},
  {"bufferView":3,"componentType":5123,"type":"SCALAR","count":3},
  {"bufferView":4,"componentType":5121,"type":"VEC4","count":3,"normalized":true},
  {"bufferView":5,"componentType":5126,"type":"VEC4","count":3},
  {"componentType":5126,"type":"VEC3","count":3,"min":[0,0,0],"max":[1,2,3],"sparse":{"count":1,
   "indices":{"bufferView":6,"byteOffset":0,"componentType":5121},
   "values":{"bufferView":7,"byteOffset":0}}}],
"images":[{"name":"png","bufferView":8,"mimeType":"image/png"},{"uri":"@PNG"}],
"samplers":[{"name":"s","magFilter":9729,"minFilter":9987,"wrapS":10497,"wrapT":33071}],
"textures":[{"name":"t","sampler":0,"source":0},{"source":1}],
"materials":[
  {"name":"all","pbrMetallicRoughness":{"baseColorFactor":[1,1,1,1],"metallicFactor":0.5,
    "roughnessFactor":0.5,"baseColorTexture":{"index":0,"texCoord":0,"extensions":{
      "KHR_texture_transform":{"offset":[0,0],"rotation":0,"scale":[1,1],"texCoord":0}}},
    "metallicRoughnessTexture":{"index":1}},
   "normalTexture":{"index":1,"texCoord":0,"scale":1},
   "occlusionTexture":{"index":1,"texCoord":0,"strength":1},
   "emissiveTexture":{"index":1,"texCoord":0},"emissiveFactor":[1,1,1],
   "alphaMode":"MASK","alphaCutoff":0.5,"doubleSided":true,
   "extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":2}}},
  {"extensions":{"KHR_materials_unlit":{}}}],
"meshes":[{"name":"m","primitives":[
  {"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2,"COLOR_0":4,"TANGENT":5},"indices":3,
   "material":0,"mode":4},
  {"attributes":{"POSITION":6},"indices":3,"material":1}]}],
"cameras":[
  {"name":"c","type":"perspective",
   "perspective":{"yfov":1,"aspectRatio":1.5,"znear":0.1,"zfar":10}},
  {"type":"orthographic","orthographic":{"xmag":1,"ymag":1,"znear":0,"zfar":10}}],
"nodes":[
  {"name":"root","children":[1,2],"translation":[0,0,0],"rotation":[0,0,0,1],"scale":[1,1,1]},
  {"mesh":0},
  {"camera":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]},
  {"camera":1,"extensions":{"KHR_lights_punctual":{"light":0}}},
  {"extensions":{"KHR_lights_punctual":{"light":1}}},
  {"extensions":{"KHR_lights_punctual":{"light":2}}}],
"scenes":[{"name":"s","nodes":[0,3,4,5]}],
"scene":0})";

std::string still_bytes() {
    std::string bytes = floats({0, 0, 0, 1, 0, 0, 0, 2, 0});
    bytes += floats({0, 0, 1, 0, 0, 1, 0, 0, 1}) + floats({0, 0, 1, 0, 0, 1});
    bytes += shorts({0, 1, 2, 0}) + std::string(12, '\x7f');
    bytes += floats({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, -1});
    bytes += words({1}) + floats({1, 2, 3}) + tiny_png();
    bytes.resize(252);
    return bytes;
}

// Bytes 0-35 positions, 36-71 those of a morph target, 72-83 joints, 84-131 weights, 132-259 two
// inverse bind matrices, 260-267 times, 268-291 translations, 292-323 rotations, 324-331 morph
// weights, 332-403 cubic translations.
constexpr std::string_view kMoving = R"({
"asset":{"version":"2.0"},
"buffers":[{"byteLength":404}],
"bufferViews":[
  {"buffer":0,"byteLength":36,"target":34962},
  {"buffer":0,"byteOffset":36,"byteLength":36,"target":34962},
  {"buffer":0,"byteOffset":72,"byteLength":12,"target":34962},
  {"buffer":0,"byteOffset":84,"byteLength":48,"target":34962},
  {"buffer":0,"byteOffset":132,"byteLength":128},
  {"buffer":0,"byteOffset":260,"byteLength":144}],
"accessors":[
  {"bufferView":0,"componentType":5126,"type":"VEC3","count":3,"min":[0,0,0],"max":[1,2,0]},
  {"bufferView":1,"componentType":5126,"type":"VEC3","count":3,"min":[0,0,0],"max":[0,0,1]},
  {"bufferView":2,"componentType":5121,"type":"VEC4","count":3},
  {"bufferView":3,"componentType":5126,"type":"VEC4","count":3},
  {"bufferView":4,"componentType":5126,"type":"MAT4","count":2},
  {"bufferView":5,"componentType":5126,"type":"SCALAR","count":2,"min":[0],"max":[1]},
  {"bufferView":5,"byteOffset":8,"componentType":5126,"type":"VEC3","count":2},
  {"bufferView":5,"byteOffset":32,"componentType":5126,"type":"VEC4","count":2},
  {"bufferView":5,"byteOffset":64,"componentType":5126,"type":"SCALAR","count":2},
  {"bufferView":5,"byteOffset":72,"componentType":5126,"type":"VEC3","count":6}],
"meshes":[
  {"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3},
    "targets":[{"POSITION":1}]}],"weights":[0.5]}],
"skins":[{"name":"s","joints":[1,2],"inverseBindMatrices":4,"skeleton":1}],
"animations":[{"name":"a",
  "samplers":[{"input":5,"output":6,"interpolation":"LINEAR"},{"input":5,"output":7},
    {"input":5,"output":8},{"input":5,"output":9,"interpolation":"CUBICSPLINE"}],
  "channels":[{"sampler":0,"target":{"node":1,"path":"translation"}},
    {"sampler":1,"target":{"node":1,"path":"rotation"}},
    {"sampler":2,"target":{"node":0,"path":"weights"}},
    {"sampler":3,"target":{"node":2,"path":"translation"}}]}],
"nodes":[{"mesh":0,"skin":0,"weights":[0.5]},{"children":[2]},{}],
"scenes":[{"nodes":[0,1]}],
"scene":0})";

std::string moving_bytes() {
    std::string bytes = floats({0, 0, 0, 1, 0, 0, 0, 2, 0}) + floats({0, 0, 0, 0, 0, 0, 0, 0, 1});
    bytes += words({0x0100, 0x0100, 0x0100});
    for (int vertex = 0; vertex < 3; ++vertex)
        bytes += floats({0.5f, 0.5f, 0, 0});
    for (int joint = 0; joint < 2; ++joint)
        bytes += floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    bytes += floats({0, 1}) + floats({0, 0, 0, 1, 0, 0}) + floats({0, 0, 0, 1, 0, 0, 1, 0});
    return bytes + floats({0, 1}) + std::string(72, '\0');
}

// Bytes 0-23 16-bit positions, 24-35 8-bit normals, 36-59 translations, 60-91 rotations,
// 92-115 scales of two instances.
constexpr std::string_view kExtended = R"({
"asset":{"version":"2.0"},
"extensionsUsed":["KHR_materials_variants","EXT_mesh_gpu_instancing","KHR_mesh_quantization"],
"extensionsRequired":["KHR_mesh_quantization"],
"extensions":{"KHR_materials_variants":{"variants":[{"name":"day"},{"name":"night"}]}},
"buffers":[{"byteLength":116}],
"bufferViews":[
  {"buffer":0,"byteLength":24,"byteStride":8,"target":34962},
  {"buffer":0,"byteOffset":24,"byteLength":12,"byteStride":4,"target":34962},
  {"buffer":0,"byteOffset":36,"byteLength":80}],
"accessors":[
  {"bufferView":0,"componentType":5123,"type":"VEC3","count":3,"min":[0,0,0],"max":[1,2,0]},
  {"bufferView":1,"componentType":5120,"type":"VEC3","count":3,"normalized":true},
  {"bufferView":2,"componentType":5126,"type":"VEC3","count":2},
  {"bufferView":2,"byteOffset":24,"componentType":5126,"type":"VEC4","count":2},
  {"bufferView":2,"byteOffset":56,"componentType":5126,"type":"VEC3","count":2}],
"materials":[{},{"doubleSided":true}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1},"material":0,"extensions":{
  "KHR_materials_variants":{"mappings":[{"material":0,"variants":[0]},
    {"material":1,"variants":[1]}]}}}]}],
"nodes":[{"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{
  "TRANSLATION":2,"ROTATION":3,"SCALE":4}}}}],
"scenes":[{"nodes":[0]}],
"scene":0})";

std::string extended_bytes() {
    std::string bytes = shorts({0, 0, 0, 0, 1, 0, 0, 0, 0, 2, 0, 0});
    bytes += words({0x7f0000, 0x7f0000, 0x7f0000}) + floats({0, 0, 0, 1, 0, 0});
    return bytes + floats({0, 0, 0, 1, 0, 0, 0, 1}) + floats({1, 1, 1, 2, 2, 2});
}

template <class T>
std::string bytes_of(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

}  // namespace

Document document(Base base) {
    switch (base) {
        case Base::minimal:
            return {R"({"asset":{"version":"2.0"}})", {}};
        case Base::still:
            return {kStill, still_bytes()};
        case Base::moving:
            return {kMoving, moving_bytes()};
        case Base::extended:
            return {kExtended, extended_bytes()};
    }
    return {};
}

std::string floats(const std::vector<float>& values) {
    return bytes_of(values);
}

std::string shorts(const std::vector<std::uint16_t>& values) {
    return bytes_of(values);
}

std::string words(const std::vector<std::uint32_t>& values) {
    return bytes_of(values);
}

}  // namespace hm::corpus
