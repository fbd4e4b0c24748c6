#include "base/machine.h"

#include <chrono>
#include <ctime>
#include <fstream>
#include <thread>

#include "commit.h"  // written by cmake/Commit.cmake at each build

namespace hm {

std::string cpu_model() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown";
}

unsigned cpu_threads() {
    return std::thread::hardware_concurrency();
}

std::string build_commit() {
    return HM_COMMIT;
}

void write_machine(JsonWriter& json) {
    json.field("cpu", cpu_model()).field("threads", cpu_threads());
    json.field("commit", build_commit()).field("compiler", __VERSION__);
}

double wall_seconds() {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

double processor_seconds() {
    return double(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace hm
