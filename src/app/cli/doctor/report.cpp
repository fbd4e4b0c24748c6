#include "app/cli/doctor/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "app/cli/info.h"
#include "base/json_writer.h"
#include "base/text.h"

namespace hm::cli {
namespace {

// Incremented when a field changes its meaning or is removed; not for new fields.
constexpr std::uint32_t kSchema = 1;

std::string_view level_name(Level level) {
    return level == Level::good ? "ok" : level == Level::note ? "note" : "warning";
}

void add_tiers(std::string& text, const VulkanDevice& device) {
    for (const FeatureTier& tier : tiers_of(device)) {
        const bool has = tier.missing.empty();
        fmt::format_to(std::back_inserter(text), "             {:3}  {}", has ? "yes" : "no",
                       tier.feature);
        for (std::size_t i = 0; i < tier.missing.size(); ++i)
            fmt::format_to(std::back_inserter(text), "{}{}", i == 0 ? ": lacks " : ", ",
                           tier.missing[i]);
        text += '\n';
    }
}

// Advice about a device that renders a wrong picture or none.
constexpr const char* kTrialAdvice =
    "Update its driver; until then another device renders correctly: --device cpu.";

std::string trial_line(const Trial& t) {
    if (!t.trouble.empty()) return t.trouble;
    std::string line = fmt::format("ready after {:.2f} s, rendered in {:.3f} s ({:.2f} Mrays/s)",
                                   t.prepare_seconds, t.render_seconds,
                                   double(t.rays) / std::max(t.render_seconds, 1e-9) * 1e-6);
    if (t.parity)
        line += fmt::format("; compared with the CPU: mean {:+.1e}, {:.2f} % of pixels within 1 %",
                            t.parity->mean_difference, 100 * t.parity->share_close);
    return line;
}

void write_devices(JsonWriter& json, const std::vector<VulkanDevice>& devices) {
    json.key("devices").begin_array();
    for (const VulkanDevice& d : devices) {
        json.begin_object().field("index", d.index).field("name", d.name).field("kind", d.kind);
        json.field("driver", d.driver).field("vulkan", d.api_version);
        json.field("software", d.is_software).field("memory_bytes", d.memory_bytes);
        json.key("features").begin_array();
        for (const FeatureTier& tier : tiers_of(d)) {
            json.begin_object().field("name", tier.feature).field("present", tier.missing.empty());
            json.key("missing").begin_array();
            for (const std::string& name : tier.missing)
                json.value(name);
            json.end_array().end_object();
        }
        json.end_array().end_object();
    }
    json.end_array();
}

void write_trials(JsonWriter& json, const std::vector<Trial>& trials) {
    json.key("trials").begin_array();
    for (const Trial& t : trials) {
        json.begin_object().field("device", t.device).field("passed", t.holds());
        json.field("trouble", t.trouble);
        json.field("advice", t.holds() ? "" : kTrialAdvice)
            .field("prepare_seconds", t.prepare_seconds);
        json.field("render_seconds", t.render_seconds).field("rays", t.rays);
        if (t.parity) {
            json.field("mean_difference", t.parity->mean_difference);
            json.field("standard_error", t.parity->standard_error);
            json.field("share_within_1_percent", t.parity->share_close);
        }
        json.end_object();
    }
    json.end_array();
}

}  // namespace

ExitCode verdict(const Diagnosis& d) {
    if (!std::all_of(d.trials.begin(), d.trials.end(), [](const Trial& t) { return t.holds(); }))
        return ExitCode::device_failed;
    const bool warned =
        std::any_of(d.findings.begin(), d.findings.end(),
                    [](const Finding& finding) { return finding.level == Level::warning; });
    return warned ? ExitCode::warned : ExitCode::ok;
}

std::string doctor_text(const Diagnosis& d) {
    std::string text;
    for (const Finding& finding : d.findings) {
        fmt::format_to(std::back_inserter(text), "{:8} {:16} {}\n", level_name(finding.level),
                       finding.subject, printable(finding.text));
        if (!finding.advice.empty())
            fmt::format_to(std::back_inserter(text), "{:25} {}\n", "", printable(finding.advice));
    }
    for (const VulkanDevice& device : d.machine.devices) {
        fmt::format_to(std::back_inserter(text), "\nvulkan:{} {}\n", device.index,
                       printable(device.name));
        add_tiers(text, device);
    }
    fmt::format_to(std::back_inserter(text), "\ndemo:cornell, {} x {} pixels, {} samples each\n",
                   kTrialSize, kTrialSize, kTrialSamples);
    for (const Trial& t : d.trials) {
        fmt::format_to(std::back_inserter(text), "{:8} {}: {}\n", t.holds() ? "ok" : "FAILED",
                       printable(t.device), printable(trial_line(t)));
        if (!t.holds()) fmt::format_to(std::back_inserter(text), "{:8} {}\n", "", kTrialAdvice);
    }
    return text;
}

std::string doctor_json(const Diagnosis& d) {
    JsonWriter json;
    json.begin_object().field("schema", kSchema).field("program", "himalaya " HIMALAYA_VERSION);
    json.field("commit", build_commit()).field("exit_code", unsigned(verdict(d)));
    json.key("cpu").begin_object().field("model", d.machine.cpu.model);
    json.field("threads", d.machine.cpu.threads);
    json.field("instruction_set", d.machine.cpu.instruction_set).end_object();
    json.field("memory_bytes", d.machine.memory.total_bytes);
    json.field("in_container", d.machine.in_container);
    json.key("findings").begin_array();
    for (const Finding& finding : d.findings) {
        json.begin_object().field("level", level_name(finding.level));
        json.field("subject", finding.subject).field("text", finding.text);
        json.field("advice", finding.advice).end_object();
    }
    json.end_array();
    write_devices(json, d.machine.devices);
    write_trials(json, d.trials);
    json.end_object();
    return json.text() + "\n";
}

}  // namespace hm::cli
