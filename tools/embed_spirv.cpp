// embed_spirv IN.spv OUT.spv WORDS.h: forbids contraction in a shader and writes it as a C++ array.
//
// With contraction a device may compute a * b + c with one rounding where C++ has two, so paths on
// the GPU would diverge from the CPU's (shading/exact.glsl). GLSL can only forbid it per variable
// (`precise`). This tool decorates every arithmetic instruction with NoContraction, except in
// functions marked HM_MAY_CONTRACT, which contain a variable of the name below.
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <set>
#include <span>
#include <spirv/unified1/spirv.hpp11>
#include <string>
#include <vector>

namespace {

constexpr std::size_t kHeaderWords = 5;
constexpr const char* kMayContract = "hm_may_contract";

using Words = std::vector<std::uint32_t>;

struct Instruction {
    spv::Op opcode;
    std::span<const std::uint32_t> words;  // the first word contains opcode and length
    std::size_t begin;
};

// False if the words are not SPIR-V.
template <class Visit>
bool for_each_instruction(const Words& module, const Visit& visit) {
    if (module.size() < kHeaderWords || module[0] != spv::MagicNumber) return false;
    for (std::size_t at = kHeaderWords; at < module.size();) {
        const std::size_t length = module[at] >> spv::WordCountShift;
        if (length == 0 || at + length > module.size()) return false;
        visit(Instruction{spv::Op(module[at] & spv::OpCodeMask),
                          std::span(module).subspan(at, length), at});
        at += length;
    }
    return true;
}

// Floating-point sums, products and operations composed of them. Word 2 is the result id.
bool is_arithmetic(spv::Op opcode) {
    switch (opcode) {
        case spv::Op::OpFNegate:
        case spv::Op::OpFAdd:
        case spv::Op::OpFSub:
        case spv::Op::OpFMul:
        case spv::Op::OpFDiv:
        case spv::Op::OpVectorTimesScalar:
        case spv::Op::OpMatrixTimesScalar:
        case spv::Op::OpVectorTimesMatrix:
        case spv::Op::OpMatrixTimesVector:
        case spv::Op::OpMatrixTimesMatrix:
        case spv::Op::OpOuterProduct:
        case spv::Op::OpDot:
            return true;
        default:
            return false;
    }
}

struct Findings {
    std::set<std::uint32_t> exact;      // results to decorate
    std::set<std::uint32_t> decorated;  // by `precise`
    std::size_t first_type = 0;         // decorations are inserted before it
};

bool read(const Words& module, Findings& found) {
    std::set<std::uint32_t> markers;
    std::vector<std::uint32_t> of_function;
    bool may_contract = false;
    return for_each_instruction(module, [&](const Instruction& i) {
        if (i.opcode == spv::Op::OpName &&
            std::strcmp(reinterpret_cast<const char*>(&i.words[2]), kMayContract) == 0)
            markers.insert(i.words[1]);
        if (i.opcode == spv::Op::OpDecorate &&
            i.words[2] == std::uint32_t(spv::Decoration::NoContraction))
            found.decorated.insert(i.words[1]);
        if (i.opcode == spv::Op::OpTypeVoid && found.first_type == 0) found.first_type = i.begin;
        if (i.opcode == spv::Op::OpFunction) {
            of_function.clear();
            may_contract = false;
        }
        if (i.opcode == spv::Op::OpVariable && markers.contains(i.words[2])) may_contract = true;
        if (is_arithmetic(i.opcode)) of_function.push_back(i.words[2]);
        if (i.opcode == spv::Op::OpFunctionEnd && !may_contract)
            found.exact.insert(of_function.begin(), of_function.end());
    });
}

Words forbid_contraction(const Words& module, const Findings& found) {
    Words decorations;
    for (const std::uint32_t id : found.exact)
        if (!found.decorated.contains(id))
            decorations.insert(decorations.end(),
                               {3u << spv::WordCountShift | std::uint32_t(spv::Op::OpDecorate), id,
                                std::uint32_t(spv::Decoration::NoContraction)});
    Words result = module;
    result.insert(result.begin() + std::ptrdiff_t(found.first_type), decorations.begin(),
                  decorations.end());
    return result;
}

Words read_words(const char* path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    Words words(file ? static_cast<std::size_t>(file.tellg()) / 4 : 0);
    file.seekg(0);
    file.read(reinterpret_cast<char*>(words.data()), std::streamsize(words.size() * 4));
    return words;
}

bool write_spirv(const char* path, const Words& words) {
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(words.data()), std::streamsize(words.size() * 4));
    return bool(file.flush());
}

bool write_array(const char* path, const Words& words) {
    std::ofstream file(path);
    file << "// Made by tools/embed_spirv.\nconst std::uint32_t words[] = {" << std::hex;
    for (std::size_t i = 0; i < words.size(); ++i)
        file << (i % 10 == 0 ? "\n    0x" : " 0x") << words[i] << ',';
    file << "\n};\n";
    return bool(file.flush());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fprintf(stderr, "usage: embed_spirv IN.spv OUT.spv WORDS.h\n");
        return 2;
    }
    const Words module = read_words(argv[1]);
    Findings found;
    if (!read(module, found) || found.first_type == 0) {
        std::fprintf(stderr, "embed_spirv: %s is not SPIR-V\n", argv[1]);
        return 1;
    }
    const Words exact = forbid_contraction(module, found);
    if (!write_spirv(argv[2], exact) || !write_array(argv[3], exact)) {
        std::fprintf(stderr, "embed_spirv: can't write %s and %s\n", argv[2], argv[3]);
        return 1;
    }
}
