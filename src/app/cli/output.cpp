#include "app/cli/output.h"

#include <cstdio>

namespace hm::cli {

Result<void> print(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
        return fail(ErrorKind::unwritable, "standard output", "", "can't be written");
    return {};
}

void tell(std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
}

}  // namespace hm::cli
