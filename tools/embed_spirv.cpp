// embed_spirv IN.spv OUT.spv WORDS.h: forbids contraction in a shader, and writes it as a C++
// array.
//
// Without that a device may compute a * b + c with one rounding where C++ has two, and paths on a
// GPU would part from the CPU's (shading/exact.glsl). GLSL can forbid it by `precise`, one variable
// at a time; here every arithmetic instruction is given SPIR-V's NoContraction, but in functions
// that say HM_MAY_CONTRACT, which have a variable of the name below.
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace {

// The SPIR-V specification, version 1.6, chapter 3.
constexpr std::uint32_t kMagic = 0x07230203;
constexpr std::size_t kHeaderWords = 5;
enum Opcode : std::uint32_t {
    kName = 5,
    kTypeVoid = 19,  // the first of those that declare types, constants and global variables
    kFunction = 54,
    kFunctionEnd = 56,
    kVariable = 59,
    kDecorate = 71,
    kFNegate = 127,
    kFAdd = 129,
    kFSub = 131,
    kFMul = 133,
    kFDiv = 136,
    kVectorTimesScalar = 142,
    kDot = 148,
};
constexpr std::uint32_t kNoContraction = 42;
constexpr const char* kMayContract = "hm_may_contract";

using Words = std::vector<std::uint32_t>;

struct Instruction {
    std::uint32_t opcode;
    std::span<const std::uint32_t> words;  // the first holds opcode and length
    std::size_t begin;
};

// False if the words are no SPIR-V.
template <class Visit>
bool for_each_instruction(const Words& module, const Visit& visit) {
    if (module.size() < kHeaderWords || module[0] != kMagic) return false;
    for (std::size_t at = kHeaderWords; at < module.size();) {
        const std::size_t length = module[at] >> 16;
        if (length == 0 || at + length > module.size()) return false;
        visit(Instruction{module[at] & 0xffffu, std::span(module).subspan(at, length), at});
        at += length;
    }
    return true;
}

// On products, sums and what consists of them; results are word 2.
bool is_arithmetic(std::uint32_t opcode) {
    return opcode == kFNegate || opcode == kFAdd || opcode == kFSub || opcode == kFMul ||
           opcode == kFDiv || (opcode >= kVectorTimesScalar && opcode <= kDot);
}

struct Findings {
    std::set<std::uint32_t> exact;      // results to decorate
    std::set<std::uint32_t> decorated;  // by `precise`
    std::size_t first_type = 0;         // decorations go before it
};

bool read(const Words& module, Findings& found) {
    std::set<std::uint32_t> markers;
    std::vector<std::uint32_t> of_function;
    bool may_contract = false;
    return for_each_instruction(module, [&](const Instruction& i) {
        if (i.opcode == kName &&
            std::strcmp(reinterpret_cast<const char*>(&i.words[2]), kMayContract) == 0)
            markers.insert(i.words[1]);
        if (i.opcode == kDecorate && i.words[2] == kNoContraction)
            found.decorated.insert(i.words[1]);
        if (i.opcode == kTypeVoid && found.first_type == 0) found.first_type = i.begin;
        if (i.opcode == kFunction) {
            of_function.clear();
            may_contract = false;
        }
        if (i.opcode == kVariable && markers.contains(i.words[2])) may_contract = true;
        if (is_arithmetic(i.opcode)) of_function.push_back(i.words[2]);
        if (i.opcode == kFunctionEnd && !may_contract)
            found.exact.insert(of_function.begin(), of_function.end());
    });
}

Words forbid_contraction(const Words& module, const Findings& found) {
    Words decorations;
    for (const std::uint32_t id : found.exact)
        if (!found.decorated.contains(id))
            decorations.insert(decorations.end(), {3u << 16 | kDecorate, id, kNoContraction});
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
        std::fprintf(stderr, "embed_spirv: %s is no SPIR-V\n", argv[1]);
        return 1;
    }
    const Words exact = forbid_contraction(module, found);
    if (!write_spirv(argv[2], exact) || !write_array(argv[3], exact)) {
        std::fprintf(stderr, "embed_spirv: can't write %s and %s\n", argv[2], argv[3]);
        return 1;
    }
}
