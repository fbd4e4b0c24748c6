// Progress and messages on standard error.
#pragma once

#include <mutex>
#include <string_view>

#include "session/passes.h"

namespace hm::cli {

// A live bar on a terminal, else a line every few seconds. Control characters are escaped. Thread
// safe.
class Progress {
  public:
    explicit Progress(bool quiet);

    void note(std::string_view text);     // "himalaya: text"
    void warning(std::string_view text);  // "himalaya: warning: text"
    void update(const ProgressState& state);
    void finish();  // removes the bar

  private:
    void line(std::string_view text);
    void erase_bar();

    std::mutex mutex_;
    bool quiet_;
    bool terminal_;
    bool bar_shown_ = false;
    double last_line_ = 0;  // seconds of rendering
};

}  // namespace hm::cli
