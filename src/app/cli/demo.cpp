#include "app/cli/demo.h"

#include <fmt/format.h>

#include <cstdlib>
#include <set>
#include <system_error>

#include "base/files.h"

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

// Just enough of JSON for an object of strings: no nesting, and of the escapes those that stand for
// themselves.
class FlagReader {
  public:
    FlagReader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    Result<Flags> read() {
        Flags flags;
        if (!skip('{')) return broken("'{'");
        if (skip('}')) return end(std::move(flags));
        do {
            HM_TRY_ASSIGN(std::string key, string());
            if (!skip(':')) return broken("':'");
            HM_TRY_ASSIGN(std::string value, string());
            flags.emplace_back(std::move(key), std::move(value));
        } while (skip(','));
        if (!skip('}')) return broken("',' or '}'");
        return end(std::move(flags));
    }

  private:
    tl::unexpected<Error> broken(std::string_view expected) const {
        return fail(ErrorKind::invalid, file_, fmt::format("byte {}", at_),
                    fmt::format("{} is expected in an object of strings", expected));
    }

    Result<Flags> end(Flags flags) {
        skip_space();
        if (at_ != text_.size()) return broken("the end");
        return flags;
    }

    void skip_space() {
        while (at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != text_.npos)
            ++at_;
    }

    bool skip(char c) {
        skip_space();
        if (at_ == text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }

    Result<std::string> string() {
        if (!skip('"')) return broken("a string");
        std::string value;
        for (; at_ < text_.size() && text_[at_] != '"'; ++at_) {
            if (static_cast<unsigned char>(text_[at_]) < 0x20) return broken("'\"'");
            if (text_[at_] == '\\') {
                ++at_;
                if (at_ == text_.size() || std::string_view("\"\\/").find(text_[at_]) == text_.npos)
                    return broken("one of the escapes \\\" \\\\ \\/");
            }
            value += text_[at_];
        }
        if (!skip('"')) return broken("'\"'");
        return value;
    }

    std::string_view text_;
    const std::string& file_;
    std::size_t at_ = 0;
};

}  // namespace

Result<Flags> parse_flags(std::string_view json, const std::string& file) {
    return FlagReader(json, file).read();
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
