#include "gltf/budget.h"

namespace hm::gltf {
namespace {

tl::unexpected<Error> too_much(const Json& json) {
    return json.invalid("", "the file decodes to too much data for its size");
}

}  // namespace

Result<void> take_work(const Json& json, Source& source, std::uint64_t bytes) {
    if (bytes > source.budget.kept_bytes || bytes > source.budget.decoded_bytes)
        return too_much(json);
    source.budget.decoded_bytes -= bytes;
    return {};
}

Result<void> take_memory(const Json& json, Source& source, std::uint64_t bytes) {
    if (bytes > source.budget.kept_bytes) return too_much(json);
    source.budget.kept_bytes -= bytes;
    return {};
}

}  // namespace hm::gltf
