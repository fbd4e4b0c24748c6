// The program as a process: started with arguments, sent signals, waited for.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace hm::test {

using Arguments = std::vector<std::string>;

struct Outcome {
    int code = -1;     // of the exit; -1 where a signal ended it
    int signal = 0;    // that ended it; 0 where it exited
    std::string text;  // all that it wrote on standard error
};

class Program {
  public:
    // `prepare` runs in the new process before the program does: limits, another user.
    explicit Program(const Arguments& arguments, const std::function<void()>& prepare = {});
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    ~Program();  // kills it if it still runs

    void send(int signal) const;
    bool is_running();
    Outcome wait();

  private:
    pid_t pid_ = -1;
    int stderr_ = -1;
    std::optional<int> status_;
};

// Starts it and waits.
Outcome run(const Arguments& arguments, const std::function<void()>& prepare = {});

// An empty folder, removed at the end.
class Folder {
  public:
    Folder();
    ~Folder();
    std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

std::string bytes_of(const std::filesystem::path& path);

// The Cornell box in a few pixels, on one thread of the CPU.
Arguments small_render(const std::string& output, int samples);

// With more flags, which replace earlier values of the same flags.
Arguments with(Arguments arguments, const Arguments& more);

}  // namespace hm::test
