// Messages of the validation layer and the driver, stored until they are fetched. Tests fail on
// them.
#pragma once

#include <mutex>
#include <string>
#include <vector>

namespace hm::rhi {

struct Message {
    bool error = false;  // otherwise a warning
    std::string id;      // "VUID-..." or "SYNC-HAZARD-..."
    std::string text;    // includes the names of the objects

    std::string line() const;
};

// Thread-safe, because drivers may call from their own threads.
class Messages {
  public:
    void add(Message message);
    // All messages since the last call.
    std::vector<Message> take();

  private:
    std::mutex mutex_;
    std::vector<Message> messages_;
};

}  // namespace hm::rhi
