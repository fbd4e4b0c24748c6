#include "base/check.h"

namespace hm {

void check_failed(const char* file, int line, const char* condition, std::string_view values) {
    throw CheckFailure(fmt::format("{}:{}: check failed: {} ({})", file, line, condition, values));
}

}  // namespace hm
