// Runs the program as a child process: starts it with arguments, sends signals, waits for it.
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
    int code = -1;     // exit code; -1 if terminated by a signal
    int signal = 0;    // that terminated it; 0 if it exited
    std::string text;  // everything written to stderr
};

class Program {
  public:
    // `prepare` runs in the child process before exec: to set limits, or to change the user.
    explicit Program(const Arguments& arguments, const std::function<void()>& prepare = {});
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    ~Program();  // kills the process if it is still running

    void send(int signal) const;
    bool is_running();
    Outcome wait();

  private:
    pid_t pid_ = -1;
    int stderr_ = -1;
    std::optional<int> status_;
};

// Starts the program and waits for it.
Outcome run(const Arguments& arguments, const std::function<void()>& prepare = {});

// An empty temporary folder, removed by the destructor.
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

// Arguments for a small Cornell box on one CPU thread.
Arguments small_render(const std::string& output, int samples);

// Appends more flags, which override earlier values of the same flags.
Arguments with(Arguments arguments, const Arguments& more);

}  // namespace hm::test
