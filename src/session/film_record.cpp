#include "session/film_record.h"

#include <fmt/format.h>

#include <charconv>
#include <string_view>
#include <utility>

namespace hm {
namespace {

constexpr std::string_view kSetting = "setting.";
constexpr std::string_view kPicture = "picture.";
constexpr std::string_view kDevice = "device.";
constexpr std::string_view kOrigin[] = {"origin.x", "origin.y", "origin.z"};

// Notes with a common prefix, in order.
std::vector<std::pair<std::string, std::string>> notes_below(const Metadata& notes,
                                                             std::string_view prefix) {
    std::vector<std::pair<std::string, std::string>> found;
    for (const auto& [name, value] : notes)
        if (name.starts_with(prefix)) found.emplace_back(name.substr(prefix.size()), value);
    return found;
}

// A list as one text: a line per item, with line feed and backslash escaped. Each item ends with a
// line feed, so that an empty list and an empty item differ.
std::string join_lines(const std::vector<std::string>& items) {
    std::string text;
    for (const std::string& item : items) {
        for (const char c : item) {
            if (c == '\\')
                text += "\\\\";
            else if (c == '\n')
                text += "\\n";
            else
                text += c;
        }
        text += '\n';
    }
    return text;
}

std::vector<std::string> split_lines(std::string_view text) {
    std::vector<std::string> items;
    std::string item;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\n')
            items.push_back(std::exchange(item, {}));
        else if (text[i] == '\\' && i + 1 < text.size())
            item += text[++i] == 'n' ? '\n' : text[i];
        else
            item += text[i];
    }
    return items;
}

// Reads the notes of one file; the first invalid one is remembered.
class Reader {
  public:
    explicit Reader(const Metadata& notes) : notes_(notes) {}

    const std::string* find(std::string_view name) const {
        for (const auto& [key, value] : notes_)
            if (key == name) return &value;
        return nullptr;
    }
    std::vector<std::string> list(std::string_view name) const {
        const std::string* text = find(name);
        return text ? split_lines(*text) : std::vector<std::string>();
    }
    template <class T>
    void read(std::string_view name, T& value) {
        const std::string* text = find(name);
        const char* end = text ? text->data() + text->size() : nullptr;
        if (text == nullptr || std::from_chars(text->data(), end, value).ptr != end)
            if (wrong_.empty()) wrong_ = name;
    }
    const std::string& wrong() const { return wrong_; }

  private:
    const Metadata& notes_;
    std::string wrong_;
};

}  // namespace

Metadata to_notes(const FilmRecord& record) {
    Metadata notes = {{"samples_asked", fmt::format("{}", record.samples_asked)},
                      {"seconds", fmt::format("{}", record.seconds)},
                      {"rays", fmt::format("{}", record.rays)},
                      {"non_finite", fmt::format("{}", record.non_finite)},
                      {"tone_curve", fmt::format("{}", record.tone.curve)},
                      {"exposure", fmt::format("{}", record.tone.exposure)},
                      {"half", join_lines(record.half)},
                      {"exr_compression", fmt::format("{}", unsigned(record.exr.compression))},
                      {"exr_tile", fmt::format("{}", record.exr.tile)},
                      {"names.objects", join_lines(record.names.objects)},
                      {"names.materials", join_lines(record.names.materials)},
                      {"names.assets", join_lines(record.names.assets)}};
    if (record.origin != glm::dvec3(0))
        for (int axis = 0; axis < 3; ++axis)
            notes.emplace_back(kOrigin[axis], fmt::format("{}", record.origin[axis]));
    if (record.frame) notes.emplace_back("frame", fmt::format("{}", *record.frame));
    if (record.alpha) notes.emplace_back("alpha", "true");
    if (record.auto_exposure) notes.emplace_back("auto_exposure", "true");
    for (std::size_t i = 0; i < record.devices.size(); ++i)
        notes.emplace_back(fmt::format("{}{}", kDevice, i), record.devices[i]);
    for (const auto& [name, value] : record.settings)
        notes.emplace_back(fmt::format("{}{}", kSetting, name), value);
    // Numbered: files sort notes by name, and people read metadata in order.
    for (std::size_t i = 0; i < record.picture.size(); ++i)
        notes.emplace_back(fmt::format("{}{:02}.{}", kPicture, i, record.picture[i].first),
                           record.picture[i].second);
    return notes;
}

Result<FilmRecord> from_notes(const Metadata& notes, const std::string& file) {
    FilmRecord record;
    Reader reader(notes);
    reader.read("samples_asked", record.samples_asked);
    reader.read("seconds", record.seconds);
    reader.read("rays", record.rays);
    reader.read("non_finite", record.non_finite);
    reader.read("tone_curve", record.tone.curve);
    reader.read("exposure", record.tone.exposure);
    unsigned compression = 0;
    reader.read("exr_compression", compression);
    record.exr.compression = static_cast<ExrCompression>(compression);
    reader.read("exr_tile", record.exr.tile);
    record.half = reader.list("half");
    record.names = {reader.list("names.objects"), reader.list("names.materials"),
                    reader.list("names.assets")};
    for (int axis = 0; axis < 3 && reader.find(kOrigin[0]); ++axis)
        reader.read(kOrigin[axis], record.origin[axis]);
    if (reader.find("frame")) reader.read("frame", record.frame.emplace());
    if (!reader.wrong().empty())
        return fail(ErrorKind::invalid, file, "", fmt::format("has no {}", reader.wrong()));
    record.alpha = reader.find("alpha") != nullptr;
    record.auto_exposure = reader.find("auto_exposure") != nullptr;
    for (auto& [number, device] : notes_below(notes, kDevice))
        record.devices.push_back(std::move(device));
    record.settings = notes_below(notes, kSetting);
    for (auto& [name, value] : notes_below(notes, kPicture))
        record.picture.emplace_back(name.substr(name.find('.') + 1), std::move(value));
    return record;
}

std::string devices_text(const std::vector<std::string>& devices) {
    std::string text;
    for (const std::string& device : devices)
        text += fmt::format("{}{}", text.empty() ? "" : ", then ", device);
    return text;
}

}  // namespace hm
