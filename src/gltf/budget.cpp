#include "gltf/budget.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/available_memory.h"

namespace hm::gltf {

std::uint64_t memory_limit(const LoadOptions& options) {
    if (options.memory_limit != 0) return options.memory_limit;
    constexpr std::uint64_t kDefaultLimit = 1ull << 34;
    const MemoryFacts memory = memory_facts();
    return memory.total_bytes == 0 ? kDefaultLimit
                                   : std::min(kDefaultLimit, memory.available_bytes / 4 * 3);
}

Budget make_budget(std::uint64_t limit, std::uint64_t file_bytes) {
    constexpr std::uint64_t kBaseWork = 1ull << 36;  // about a minute
    Budget budget;
    budget.limit = limit;
    budget.kept_bytes = limit - std::min(limit, file_bytes);
    budget.decoded_bytes = kBaseWork;
    add_work(budget, file_bytes);
    return budget;
}

void add_work(Budget& budget, std::uint64_t input_bytes) {
    // Decoding expands data at most 7 times if nothing is used twice. Shared vertex data and meshes
    // with many primitives need more.
    constexpr std::uint64_t kFactor = 256;
    budget.decoded_bytes += kFactor * input_bytes;
}

std::uint64_t json_memory(std::span<const std::byte> text) {
    // The parser copies the text, and the strings once more. Each value takes up to three words of
    // its tape, plus the loader's own Json.
    constexpr std::uint64_t kValue = 24 + sizeof(Json);
    // Counted in pieces short enough for an 8-bit sum, so that the loop vectorizes well.
    constexpr std::size_t kPiece = 128;
    const std::uint64_t length = text.size();
    std::uint64_t values = 0;
    for (; !text.empty(); text = text.subspan(std::min(kPiece, text.size()))) {
        std::uint8_t found = 0;
        for (const std::byte b : text.first(std::min(kPiece, text.size())))
            found = std::uint8_t(
                found + (b == std::byte(',') || b == std::byte('{') || b == std::byte('[')));
        values += found;
    }
    return 2 * length + kValue * values;
}

Result<void> check_memory(const Budget& budget, std::uint64_t bytes, const std::string& file,
                          const std::string& pointer) {
    if (bytes <= budget.kept_bytes) return {};
    return fail(ErrorKind::invalid, file, pointer,
                fmt::format("needs {} bytes of memory, but only {} are left of the limit of {} "
                            "(memory-limit)",
                            bytes, budget.kept_bytes, budget.limit));
}

Result<void> take_work(const Json& json, Source& source, std::uint64_t bytes) {
    HM_TRY(check_memory(source.budget, bytes, source.file, json.pointer()));
    if (bytes > source.budget.decoded_bytes)
        return json.invalid("", "the file decodes to too much data for its size");
    source.budget.decoded_bytes -= bytes;
    return {};
}

Result<void> take_memory(const Json& json, Source& source, std::uint64_t bytes) {
    HM_TRY(check_memory(source.budget, bytes, source.file, json.pointer()));
    source.budget.kept_bytes -= bytes;
    return {};
}

}  // namespace hm::gltf
