#include "rhi/messages.h"

#include <utility>

namespace hm::rhi {

std::string Message::line() const {
    return (error ? "error: " : "warning: ") + id + ": " + text;
}

void Messages::add(Message message) {
    const std::lock_guard lock(mutex_);
    messages_.push_back(std::move(message));
}

std::vector<Message> Messages::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(messages_, {});
}

}  // namespace hm::rhi
