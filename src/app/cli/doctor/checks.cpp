#include "app/cli/doctor/checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "base/text.h"

namespace hm::cli {
namespace {

using Findings = std::vector<Finding>;

constexpr double kGiB = 1024.0 * 1024.0 * 1024.0;

Findings check_cpu(const Machine& m) {
    const std::string text =
        fmt::format("{}, {} thread{}, rendering with {}", m.cpu.model, m.cpu.threads,
                    m.cpu.threads == 1 ? "" : "s", m.cpu.instruction_set);
    if (m.cpu.instruction_set != "baseline") return {{Level::good, "CPU", text}};
    return {{Level::note, "CPU", text + ": it has no AVX2, which is twice as fast"}};
}

Findings check_memory(const Machine& m) {
    constexpr double kEnough = 2;
    const double free = double(m.memory.available_bytes) / kGiB;
    const std::string text =
        fmt::format("{:.1f} GiB, {:.1f} free", double(m.memory.total_bytes) / kGiB, free);
    if (m.memory.total_bytes == 0) return {{Level::note, "memory", "unknown"}};
    if (free >= kEnough) return {{Level::good, "memory", text}};
    return {
        {Level::warning, "memory", text, "Close other programs before rendering large scenes."}};
}

Findings check_build(const Machine& m) {
    if (m.built_with_vulkan) return {};
    return {{Level::warning, "Vulkan renderer", "not included in this build; only the CPU renders",
             "Install the packages that scripts/install-deps.sh lists, run scripts/fetch-vma.sh "
             "and build again with -DHIMALAYA_VULKAN=ON."}};
}

Findings check_loader(const Machine& m) {
    if (m.loader.trouble.empty())
        return {
            {Level::good, "Vulkan loader",
             fmt::format("{} ({})", m.loader.version.empty() ? "older than 1.1" : m.loader.version,
                         m.loader.path)}};
    return {{Level::warning, "Vulkan loader", m.loader.trouble,
             "Install it: libvulkan1 (Debian, Ubuntu), vulkan-loader (Fedora), vulkan-icd-loader "
             "(Arch)."}};
}

bool has_node(const Machine& m, std::string_view start) {
    return std::any_of(m.nodes.begin(), m.nodes.end(),
                       [&](const DeviceNode& n) { return n.path.starts_with(start); });
}

bool sees_nvidia(const Machine& m) {
    return !m.nvidia.kernel_driver.empty() || has_node(m, "/dev/nvidia");
}

std::string nvidia_container_advice(const Machine& m) {
    const std::string& capabilities = m.nvidia.capabilities;
    if (!lacks_graphics(capabilities))
        return "The container has no Vulkan driver although graphics is requested: check that the "
               "host has one (nvidia_icd.json, not a compute-only driver), and update NVIDIA's "
               "container toolkit.";
    return fmt::format(
        "The container does not have the graphics part of the driver (NVIDIA_DRIVER_CAPABILITIES "
        "is {}): "
        "start it with -e NVIDIA_DRIVER_CAPABILITIES=all, and install libxext6 and libegl1 in it.",
        capabilities.empty() ? "not set" : "\"" + capabilities + "\"");
}

std::string driver_advice(const Machine& m) {
    if (sees_nvidia(m))
        return m.in_container ? nvidia_container_advice(m)
                              : "Install the Vulkan part of NVIDIA's driver: nvidia-vulkan-icd "
                                "(Debian), libnvidia-gl-VERSION (Ubuntu).";
    if (has_node(m, "/dev/dri"))
        return "Install the card's driver: mesa-vulkan-drivers (AMD, Intel), or NVIDIA's own.";
    if (m.in_container)
        return "If the host has a GPU, pass it to the container: --gpus all with NVIDIA's "
               "container toolkit, --device /dev/dri for AMD and Intel.";
    return "If the machine has a GPU, install its driver.";
}

// Distribution packages of libraries that drivers need and minimal images do not have.
constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kPackages = {{
    {"libXext.so", "libxext6"},
    {"libX11.so", "libx11-6"},
    {"libX11-xcb.so", "libx11-xcb1"},
    {"libEGL.so", "libegl1"},
    {"libGLdispatch.so", "libglvnd0"},
    {"libxcb", "the libxcb packages"},
    {"libdrm", "libdrm2"},
    {"libwayland-client.so", "libwayland-client0"},
}};

std::string library_advice(const Machine& m, const DriverManifest& manifest) {
    if (manifest.driver.empty())
        return m.chosen_drivers.empty() ? "Reinstall the driver that the file belongs to."
                                        : "Unset the variable, or name a manifest.";
    for (const auto& [library, package] : kPackages)
        if (manifest.trouble.starts_with(library))
            return fmt::format("Install {} (Debian, Ubuntu).", package);
    if (is_nvidia(manifest) && m.in_container) return nvidia_container_advice(m);
    return "Reinstall the driver: its manifest exists, its library does not.";
}

Findings check_drivers(const Machine& m) {
    Findings findings;
    bool one_loads = false;
    for (const DriverManifest& manifest : m.manifests) {
        const std::string file = manifest.file.string();
        const bool is_added = m.added_drivers.find(file) != std::string::npos;
        if (!manifest.trouble.empty()) {
            findings.push_back({Level::warning, "Vulkan driver",
                                fmt::format("{}: {}", file, manifest.trouble),
                                library_advice(m, manifest)});
            continue;
        }
        one_loads = one_loads || manifest.is_searched || is_added;
        if (is_added)
            findings.push_back({Level::note, "Vulkan driver",
                                fmt::format("{}: the loader does not look there; himalaya adds it. "
                                            "For other programs: export VK_ADD_DRIVER_FILES={}",
                                            file, file)});
        else if (manifest.is_searched)
            findings.push_back(
                {Level::good, "Vulkan driver", fmt::format("{} ({})", file, manifest.driver)});
    }
    if (!m.chosen_drivers.empty())
        findings.push_back({Level::note, "Vulkan driver",
                            fmt::format("VK_DRIVER_FILES or VK_ICD_FILENAMES allows only these: {}",
                                        m.chosen_drivers)});
    if (!one_loads)
        findings.push_back(
            {Level::warning, "Vulkan driver",
             m.chosen_drivers.empty() ? "none is installed" : "none of these can be used",
             m.chosen_drivers.empty() ? driver_advice(m)
                                      : "Unset the variable, or name a manifest."});
    return findings;
}

bool is_nvidia_device(const VulkanDevice& d) {
    return d.name.find("NVIDIA") != std::string::npos;
}

// Only if there is a card that cannot trace rays.
Findings check_nvidia(const Machine& m) {
    const NvidiaFacts& n = m.nvidia;
    if (!sees_nvidia(m) || std::any_of(m.devices.begin(), m.devices.end(), [](const auto& d) {
            return is_nvidia_device(d) && can_trace(d);
        }))
        return {};
    Findings findings;
    const auto warn = [&](std::string text, std::string advice) {
        findings.push_back({Level::warning, "NVIDIA driver", std::move(text), std::move(advice)});
    };
    if (m.in_container && lacks_graphics(n.capabilities))
        warn("the container does not have the Vulkan part of the driver",
             nvidia_container_advice(m));
    if (!n.user_driver.empty() && !n.kernel_driver.empty() && n.user_driver != n.kernel_driver)
        warn(fmt::format("the kernel runs {}, the library is {}", n.kernel_driver, n.user_driver),
             m.in_container ? "Let NVIDIA's container toolkit provide the host's driver instead of "
                              "installing one in the image."
                            : "They must have the same version: restart after an update.");
    for (const LibraryFacts& library : n.opened) {
        if (library.trouble.empty()) continue;
        warn(fmt::format("it requires {}: {}", library.name, library.trouble),
             !library.package.empty()
                 ? fmt::format("Install {} (Debian, Ubuntu); other systems have it in libglvnd and "
                               "their X11 libraries.",
                               library.package)
             : m.in_container ? nvidia_container_advice(m)
                              : "Reinstall the driver: ray tracing needs this library.");
    }
    return findings;
}

Findings check_nodes(const Machine& m) {
    std::string refused;
    for (const DeviceNode& node : m.nodes)
        if (!node.may_use) refused += " " + node.path;
    if (refused.empty()) return {};
    return {{Level::warning, "permissions", "this user cannot access" + refused,
             m.in_container
                 ? "Start the container with --group-add of the group that owns the file outside."
                 : "Add the user to the groups that own them (usermod -aG render,video USER), and "
                   "log in again."}};
}

std::vector<std::string> missing_of(const VulkanDevice& device) {
    std::vector<std::string> names;
    for (const rhi::Capability& c : device.capabilities)
        if (c.required && !c.present) names.push_back(c.name);
    return names;
}

std::string describe(const VulkanDevice& d) {
    return fmt::format("vulkan:{} {} ({}, {:.1f} GiB, Vulkan {}, {})", d.index, d.name, d.kind,
                       double(d.memory_bytes) / kGiB, d.api_version, d.driver);
}

std::string old_driver_advice(const VulkanDevice& d) {
    if (d.is_software) return "lavapipe supports ray tracing since Mesa 25.";
    return "Update the driver to NVIDIA 515, Mesa 24 (AMD, Intel) or newer. If it is, the card is "
           "too old: ray tracing needs GeForce 10, Radeon RX 6000, Arc or newer.";
}

Findings check_devices(const Machine& m) {
    if (!m.built_with_vulkan) return {};
    if (!m.devices_trouble.empty())
        return {{Level::warning, "devices", m.devices_trouble,
                 "See the findings about the loader and the drivers."}};
    Findings findings;
    bool has_nvidia = false, has_gpu = false;
    for (const VulkanDevice& d : m.devices) {
        has_nvidia = has_nvidia || is_nvidia_device(d);
        has_gpu = has_gpu || (!d.is_software && can_trace(d));
        if (can_trace(d)) {
            findings.push_back({d.is_software ? Level::note : Level::good, "device",
                                describe(d) + (d.is_software ? ": software; used only if "
                                                               "requested"
                                                             : "")});
            continue;
        }
        findings.push_back({d.is_software ? Level::note : Level::warning, "device",
                            fmt::format("{} lacks {}", describe(d), joined(missing_of(d), ", ")),
                            old_driver_advice(d)});
    }
    if (sees_nvidia(m) && !has_nvidia)
        findings.push_back({Level::warning, "devices",
                            "the kernel has an NVIDIA card, but Vulkan does not list it",
                            driver_advice(m)});
    else if (!has_gpu)
        findings.push_back({Level::warning, "devices",
                            "no GPU can render; --device auto uses the CPU", driver_advice(m)});
    return findings;
}

// Only --denoise needs it, so its absence is not a warning.
Findings check_denoiser(const Machine& m) {
    const DenoiserFacts& d = m.denoiser;
    if (!d.trouble.empty()) return {{Level::note, "denoiser", d.trouble}};
    std::string others;
    for (std::size_t i = 1; i < d.devices.size(); ++i)
        others += (i == 1 ? ", also " : ", ") + d.devices[i];
    return {{Level::good, "denoiser", fmt::format("{}{} ({})", d.fastest, others, d.path)}};
}

}  // namespace

const std::vector<Check>& all_checks() {
    static const std::vector<Check> kChecks = {check_cpu,    check_memory,  check_build,
                                               check_loader, check_drivers, check_nvidia,
                                               check_nodes,  check_devices, check_denoiser};
    return kChecks;
}

std::vector<Finding> check_all(const Machine& machine) {
    Findings all;
    for (const Check check : all_checks())
        for (Finding& finding : check(machine))
            all.push_back(std::move(finding));
    return all;
}

std::vector<FeatureTier> tiers_of(const VulkanDevice& device) {
    std::vector<FeatureTier> tiers = {{"path tracing", missing_of(device)}};
    for (const rhi::Capability& c : device.capabilities) {
        if (c.required) continue;
        const auto same = std::find_if(tiers.begin(), tiers.end(), [&](const FeatureTier& tier) {
            return tier.feature == c.purpose;
        });
        FeatureTier& tier =
            same != tiers.end() ? *same : tiers.emplace_back(FeatureTier{c.purpose, {}});
        if (!c.present) tier.missing.push_back(c.name);
    }
    return tiers;
}

bool can_trace(const VulkanDevice& device) {
    return missing_of(device).empty();
}

}  // namespace hm::cli
