#include "app/cli/demo.h"

#include <fmt/format.h>

#include <cstdlib>
#include <set>
#include <system_error>

#include "base/files.h"
#include "base/json_document.h"

namespace hm::cli {
namespace {

namespace fs = std::filesystem;

using Flags = std::vector<std::pair<std::string, std::string>>;

std::vector<fs::path> scene_folders() {
    std::vector<fs::path> folders;
    if (const char* chosen = std::getenv("HIMALAYA_SCENES"); chosen != nullptr && *chosen != '\0')
        folders.emplace_back(chosen);
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (!error) folders.push_back(program.parent_path() / "../share/himalaya/scenes");
    folders.emplace_back(HIMALAYA_SOURCE_SCENES);
    return folders;
}

// Sorted, each once.
std::string known_demos(const std::vector<fs::path>& folders) {
    std::set<std::string> names;
    std::error_code error;
    for (const fs::path& folder : folders)
        for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
            if (entry.path().extension() == ".glb") names.insert(entry.path().stem().string());
    std::string list;
    for (const std::string& name : names)
        list += (list.empty() ? "" : ", ") + std::string(kDemoPrefix) + name;
    return list.empty() ? "no demo was found" : "there are " + list;
}

}  // namespace

Result<Flags> parse_flags(std::string_view json, const std::string& file) {
    HM_TRY_ASSIGN(const JsonDocument document, JsonDocument::parse(json, file));
    const Json& root = document.root();
    if (root.type() != JsonType::object) return root.invalid("", "expected an object of strings");
    Flags flags;
    for (const std::string_view key : root.keys()) {
        HM_TRY_ASSIGN(const auto value, root.text(key));
        flags.emplace_back(key, value.value());
    }
    return flags;
}

Result<Demo> find_demo(std::string_view name) {
    const std::vector<fs::path> folders = scene_folders();
    const bool is_name = !name.empty() && name.find('/') == name.npos && name.front() != '.';
    for (const fs::path& folder : folders) {
        std::error_code error;
        Demo demo{folder / fmt::format("{}.glb", name), {}};
        if (!is_name || !fs::exists(demo.scene, error)) continue;
        const fs::path beside = folder / fmt::format("{}.json", name);
        if (!fs::exists(beside, error)) return demo;
        HM_TRY_ASSIGN(const ByteArray bytes, read_file(beside));
        const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        HM_TRY_ASSIGN(demo.flags, parse_flags(text, beside.string()));
        for (auto& [flag, value] : demo.flags)
            if (flag == "env" && value != "none") value = (folder / value).string();
        return demo;
    }
    return fail(ErrorKind::unreadable, fmt::format("{}{}", kDemoPrefix, name), "",
                "there is no such demo; " + known_demos(folders));
}

}  // namespace hm::cli
