#include "gpu/spirv_layout.h"

#include <stdexcept>
#include <vector>

namespace hm::test {

namespace {

constexpr std::uint32_t kMagic = 0x07230203;
constexpr std::uint32_t kHeaderWords = 5;
constexpr std::uint32_t kOpName = 5;
constexpr std::uint32_t kOpMemberName = 6;
constexpr std::uint32_t kOpTypeBool = 20;
constexpr std::uint32_t kOpTypeInt = 21;
constexpr std::uint32_t kOpTypeFloat = 22;
constexpr std::uint32_t kOpTypeVector = 23;
constexpr std::uint32_t kOpTypeRuntimeArray = 29;
constexpr std::uint32_t kOpTypeStruct = 30;
constexpr std::uint32_t kOpTypePointer = 32;
constexpr std::uint32_t kOpVariable = 59;
constexpr std::uint32_t kRayPayload = 5338;  // storage classes
constexpr std::uint32_t kIncomingRayPayload = 5342;
constexpr std::uint32_t kOpDecorate = 71;
constexpr std::uint32_t kOpMemberDecorate = 72;
constexpr std::uint32_t kDecorationArrayStride = 6;
constexpr std::uint32_t kDecorationMatrixStride = 7;
constexpr std::uint32_t kDecorationOffset = 35;

struct Member {
    std::string name;
    std::size_t offset = 0;
    std::size_t matrix_stride = 0;
    bool has_offset = false;
};

struct Module {
    std::map<std::uint32_t, std::string> names;
    std::map<std::uint32_t, std::map<std::uint32_t, Member>> structs;
    std::map<std::uint32_t, std::size_t> array_strides;     // array type -> bytes
    std::map<std::uint32_t, std::uint32_t> element_arrays;  // element type -> array type
    std::map<std::uint32_t, std::size_t> sizes;             // of types, bytes, without padding
    std::map<std::uint32_t, std::uint32_t> pointees;        // pointer type -> type
    std::vector<std::uint32_t> payloads;                    // their pointer types
};

// A literal string: bytes in words, least significant first, closed by zero.
std::string read_text(std::span<const std::uint32_t> words) {
    std::string text;
    for (const std::uint32_t word : words) {
        for (unsigned shift = 0; shift < 32; shift += 8) {
            const char c = static_cast<char>(word >> shift & 0xffu);
            if (c == 0) return text;
            text += c;
        }
    }
    return text;
}

// Types come before what is made of them, so their sizes are known.
void read_type(std::uint32_t code, std::span<const std::uint32_t> operands, Module& module) {
    if (operands.empty()) return;  // the end of a function, and others that define nothing
    const std::uint32_t id = operands[0];
    if (code == kOpTypeBool) {
        module.sizes[id] = 4;
    } else if (code == kOpTypeInt || code == kOpTypeFloat) {
        module.sizes[id] = operands[1] / 8;
    } else if (code == kOpTypeVector) {
        module.sizes[id] = module.sizes[operands[1]] * operands[2];
    } else if (code == kOpTypeStruct) {
        for (const std::uint32_t member : operands.subspan(1))
            module.sizes[id] += module.sizes[member];
    } else if (code == kOpTypePointer) {
        module.pointees[id] = operands[2];
    } else if (code == kOpVariable &&
               (operands[2] == kRayPayload || operands[2] == kIncomingRayPayload)) {
        module.payloads.push_back(id);
    }
}

void read_instruction(std::uint32_t code, std::span<const std::uint32_t> operands, Module& module) {
    if (code == kOpName) {
        module.names[operands[0]] = read_text(operands.subspan(1));
    } else if (code == kOpMemberName) {
        module.structs[operands[0]][operands[1]].name = read_text(operands.subspan(2));
    } else if (code == kOpTypeRuntimeArray) {
        module.element_arrays[operands[1]] = operands[0];
    } else if (code == kOpDecorate && operands[1] == kDecorationArrayStride) {
        module.array_strides[operands[0]] = operands[2];
    } else if (code == kOpMemberDecorate && operands[2] == kDecorationOffset) {
        Member& member = module.structs[operands[0]][operands[1]];
        member.offset = operands[3];
        member.has_offset = true;
    } else if (code == kOpMemberDecorate && operands[2] == kDecorationMatrixStride) {
        module.structs[operands[0]][operands[1]].matrix_stride = operands[3];
    }
}

Module read_module(std::span<const std::uint32_t> spirv) {
    if (spirv.size() < kHeaderWords || spirv[0] != kMagic) throw std::runtime_error("not SPIR-V");
    Module module;
    for (std::size_t at = kHeaderWords; at < spirv.size();) {
        const std::uint32_t words = spirv[at] >> 16;
        if (words == 0 || at + words > spirv.size()) throw std::runtime_error("cut-off SPIR-V");
        const std::uint32_t code = spirv[at] & 0xffffu;
        read_instruction(code, spirv.subspan(at + 1, words - 1), module);
        read_type(code, spirv.subspan(at + 1, words - 1), module);
        at += words;
    }
    return module;
}

}  // namespace

std::map<std::string, std::size_t> read_payload_sizes(std::span<const std::uint32_t> spirv) {
    Module module = read_module(spirv);
    std::map<std::string, std::size_t> sizes;
    for (const std::uint32_t pointer : module.payloads) {
        const std::uint32_t type = module.pointees[pointer];
        sizes[module.names[type]] = module.sizes[type];
    }
    return sizes;
}

std::map<std::string, StructLayout> read_struct_layouts(std::span<const std::uint32_t> spirv) {
    Module module = read_module(spirv);
    std::map<std::string, StructLayout> layouts;
    for (const auto& [id, members] : module.structs) {
        if (!members.begin()->second.has_offset) continue;
        StructLayout& layout = layouts[module.names[id]];
        for (const auto& [index, member] : members) {
            layout.offsets[member.name] = member.offset;
            if (member.matrix_stride != 0)
                layout.matrix_strides[member.name] = member.matrix_stride;
        }
        const auto array = module.element_arrays.find(id);
        if (array != module.element_arrays.end())
            layout.array_stride = module.array_strides[array->second];
    }
    return layouts;
}

}  // namespace hm::test
