#include "app/cli/doctor/doctor.h"

#include <fmt/format.h>

#include "app/cli/doctor/report.h"
#include "app/cli/output.h"
#include "app/cli/progress.h"

namespace hm::cli {
namespace {

// The CPU first, as the reference.
std::vector<Contender> contenders_of(const Machine& machine, Diagnostics& diagnostics) {
    std::vector<Contender> all = {
        {fmt::format("CPU ({})", machine.cpu.instruction_set), [] { return cpu_device(0); }}};
    for (const VulkanDevice& device : machine.devices)
        if (can_trace(device))
            all.push_back({fmt::format("vulkan:{} {}", device.index, device.name),
                           [&diagnostics, index = device.index] {
                               return open_vulkan_device(index, diagnostics);
                           }});
    return all;
}

}  // namespace

Result<ExitCode> doctor(const DoctorOptions& options) {
    Progress progress(options.json);
    Diagnosis diagnosis;
    Diagnostics diagnostics;
    diagnosis.machine = examine_machine();
    diagnosis.findings = check_all(diagnosis.machine);
    HM_TRY_ASSIGN(
        diagnosis.trials,
        run_trials(contenders_of(diagnosis.machine, diagnostics), [&](std::string_view name) {
            progress.note(fmt::format("drawing on {}", name));
        }));
    for (const Warning& warning : diagnostics.warnings())
        progress.warning(warning.line());
    HM_TRY(print(options.json ? doctor_json(diagnosis) : doctor_text(diagnosis)));
    return verdict(diagnosis);
}

}  // namespace hm::cli
