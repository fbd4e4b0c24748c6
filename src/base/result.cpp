#include "base/result.h"

#include "base/text.h"

namespace hm {

std::string Error::line() const {
    std::string text;
    if (!file.empty()) text += file + ": ";
    if (!place.empty()) text += place + ": ";
    return printable(text + message);
}

}  // namespace hm
