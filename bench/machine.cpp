#include "machine.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <thread>

namespace hm {
namespace {

std::string cpu_model() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown";
}

std::string commit() {
    std::string text;
    if (FILE* pipe =
            popen("git -C '" HIMALAYA_SOURCE "' describe --always --dirty 2>/dev/null", "r")) {
        char buffer[64];
        while (std::fgets(buffer, sizeof buffer, pipe) != nullptr)
            text += buffer;
        pclose(pipe);
    }
    while (!text.empty() && text.back() == '\n')
        text.pop_back();
    return text.empty() ? "unknown" : text;
}

}  // namespace

std::string machine_json() {
    return fmt::format("\"cpu\": \"{}\", \"threads\": {}, \"commit\": \"{}\", \"compiler\": \"{}\"",
                       cpu_model(), std::thread::hardware_concurrency(), commit(), __VERSION__);
}

double wall_seconds() {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

double processor_seconds() {
    return double(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace hm
