#include "keep/program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>

namespace hm::test {

namespace fs = std::filesystem;

Program::Program(const Arguments& arguments, const std::function<void()>& prepare) {
    std::array<int, 2> ends{};
    EXPECT_EQ(::pipe2(ends.data(), O_CLOEXEC), 0);
    std::vector<std::string> words = {HIMALAYA_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    pid_ = ::fork();
    if (pid_ == 0) {
        ::dup2(ends[1], STDERR_FILENO);
        if (prepare) prepare();
        ::execv(pointers[0], pointers.data());
        ::_exit(127);
    }
    ::close(ends[1]);
    stderr_ = ends[0];
}

Program::~Program() {
    if (pid_ > 0 && is_running()) {
        send(SIGKILL);
        wait();
    }
    if (stderr_ >= 0) ::close(stderr_);
}

void Program::send(int signal) const {
    ::kill(pid_, signal);
}

bool Program::is_running() {
    int status = 0;
    if (!status_ && ::waitpid(pid_, &status, WNOHANG) == pid_) status_ = status;
    return !status_;
}

Outcome Program::wait() {
    Outcome outcome;
    std::array<char, 4096> block;
    for (ssize_t got = 0; (got = ::read(stderr_, block.data(), block.size())) > 0;)
        outcome.text.append(block.data(), std::size_t(got));
    int status = 0;
    if (!status_ && ::waitpid(pid_, &status, 0) == pid_) status_ = status;
    if (WIFEXITED(*status_)) outcome.code = WEXITSTATUS(*status_);
    if (WIFSIGNALED(*status_)) outcome.signal = WTERMSIG(*status_);
    EXPECT_NE(outcome.signal, SIGABRT) << outcome.text;  // abort() means a failed internal check
    return outcome;
}

Outcome run(const Arguments& arguments, const std::function<void()>& prepare) {
    return Program(arguments, prepare).wait();
}

Folder::Folder() {
    std::string pattern = (fs::temp_directory_path() / "keep_test-XXXXXX").string();
    EXPECT_NE(::mkdtemp(pattern.data()), nullptr);
    path_ = pattern;
}

Folder::~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::string bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    EXPECT_TRUE(file) << path;
    return {std::istreambuf_iterator<char>(file), {}};
}

Arguments small_render(const std::string& output, int samples) {
    return {
        "render", "demo:cornell", "--size", "32x32", "--spp", std::to_string(samples), "--threads",
        "1",      "--device",     "cpu",    "-o",    output};
}

Arguments with(Arguments arguments, const Arguments& more) {
    for (std::size_t i = 0; i < more.size(); ++i) {
        const auto at = std::find(arguments.begin(), arguments.end(), more[i]);
        if (at != arguments.end() && more[i].starts_with("--"))
            *(at + 1) = more[++i];
        else
            arguments.push_back(more[i]);
    }
    return arguments;
}

}  // namespace hm::test
