// Messages of the validation layer and the driver, kept until they are taken. Tests fail on them.
#pragma once

#include <mutex>
#include <string>
#include <vector>

namespace hm::rhi {

struct Message {
    bool error = false;  // otherwise a warning
    std::string id;      // "VUID-..." or "SYNC-HAZARD-..."
    std::string text;    // names the objects

    std::string line() const;
};

// Drivers call from their own threads.
class Messages {
  public:
    void add(Message message);
    // Everything since the last call.
    std::vector<Message> take();

  private:
    std::mutex mutex_;
    std::vector<Message> messages_;
};

}  // namespace hm::rhi
