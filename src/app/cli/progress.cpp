#include "app/cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "app/cli/output.h"
#include "base/text.h"

namespace hm::cli {
namespace {

constexpr double kSecondsBetweenLines = 5;
constexpr std::size_t kBarCells = 24;

// "7.3 s", "4:05" or "2:04:05".
std::string duration(double seconds) {
    if (seconds < 60) return fmt::format("{:.1f} s", seconds);
    const auto whole = static_cast<std::uint64_t>(seconds);
    if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string describe(const ProgressState& s) {
    std::string text = fmt::format("{:3.0f} %  {:.6g} samples/pixel", 100 * s.fraction,
                                   std::floor(10 * s.samples_per_pixel) / 10);
    if (s.seconds > 0) text += fmt::format("  {:.2f} Mrays/s", double(s.rays) / s.seconds * 1e-6);
    text += fmt::format("  {}", duration(s.seconds));
    // An estimate too early would mislead.
    if (s.fraction > 0.01 && s.fraction < 1)
        text += fmt::format(", {} left", duration(s.seconds / s.fraction * (1 - s.fraction)));
    return text;
}

std::string bar(double fraction) {
    const auto full = static_cast<std::size_t>(fraction * double(kBarCells));
    return fmt::format("[{:#<{}}{:.<{}}]", "", full, "", kBarCells - full);
}

}  // namespace

Progress::Progress(bool quiet) : quiet_(quiet), terminal_(::isatty(STDERR_FILENO) == 1) {}

void Progress::line(std::string_view text) {
    if (quiet_) return;
    erase_bar();
    tell(fmt::format("himalaya: {}\n", printable(text)));
}

void Progress::note(std::string_view text) {
    const std::lock_guard lock(mutex_);
    line(text);
}

void Progress::warning(std::string_view text) {
    const std::lock_guard lock(mutex_);
    line(fmt::format("warning: {}", text));
}

void Progress::update(const ProgressState& state) {
    const std::lock_guard lock(mutex_);
    if (quiet_) return;
    ProgressState s = state;
    s.fraction = std::clamp(s.fraction, 0.0, 1.0);
    if (terminal_) {
        // Returns to the start of the line, and erases the rest of a longer one.
        tell(fmt::format("\r{} {}\x1b[K", bar(s.fraction), describe(s)));
        bar_shown_ = true;
    } else if (s.seconds - last_line_ >= kSecondsBetweenLines) {
        last_line_ = s.seconds;
        line(describe(s));
    }
}

void Progress::finish() {
    const std::lock_guard lock(mutex_);
    erase_bar();
}

void Progress::erase_bar() {
    if (!bar_shown_) return;
    tell("\r\x1b[K");
    bar_shown_ = false;
}

}  // namespace hm::cli
