#include "corpus/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>

namespace hm::corpus {
namespace {

std::string json_string(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + '"';
}

std::string_view name(Expected::Outcome outcome) {
    switch (outcome) {
        case Expected::Outcome::refused:
            return "refused";
        case Expected::Outcome::warned:
            return "warned";
        case Expected::Outcome::ignored:
            return "ignored";
    }
    return "";
}

std::string entry(const Case& c) {
    const Expected& e = c.expected;
    return fmt::format(
        "  {{\"file\": {}, \"rule\": {}, \"section\": {}, \"loader\": {}, \"kind\": {},\n"
        "   \"place\": {}, \"message\": {}, \"reason\": {},\n"
        "   \"validator\": {}, \"validatorReason\": {}}}",
        json_string(c.file), json_string(c.rule), json_string(c.section),
        json_string(name(e.outcome)), json_string(e.kind ? name_of(*e.kind) : ""),
        json_string(e.pointer), json_string(e.message), json_string(e.reason),
        c.validator_silence.empty() ? "\"error\"" : "\"no error\"",
        json_string(c.validator_silence));
}

using ByReason = std::map<std::string, std::vector<const Case*>>;

ByReason group(const std::vector<Case>& cases,
               const std::function<std::string(const Case&)>& reason) {
    ByReason groups;
    for (const Case& c : cases)
        if (std::string text = reason(c); !text.empty()) groups[text].push_back(&c);
    return groups;
}

std::string cell(const std::string& text) {
    std::string out;
    for (const char c : text)
        out += c == '|' ? std::string("\\|") : std::string(1, c);
    return out;
}

std::string tables(const ByReason& groups) {
    std::string out;
    for (const auto& [reason, cases] : groups) {
        out += fmt::format("\n### {}\n\n| file | rule | section |\n| --- | --- | --- |\n", reason);
        for (const Case* c : cases)
            out += fmt::format("| `{}` | {} | {} |\n", c->file, cell(c->rule), c->section);
    }
    return out;
}

constexpr std::string_view kIntroduction =
    R"(# Broken files that Himalaya and Khronos' validator judge differently

Written by `generate_corpus` (see [testing](testing.md)); do not edit. Every file of the corpus breaks
a rule of glTF 2.0. Of {} files the loader refuses {}, loads {} with a warning and {} without; the validator
reports an error in {}.

## Loaded, though broken

A renderer shows what can be shown; a checker says what is wrong.
)";

}  // namespace

std::string manifest(const std::vector<Case>& valid, const std::vector<Case>& broken) {
    std::string out = "{\"valid\": [";
    for (std::size_t i = 0; i < valid.size(); ++i)
        out += fmt::format("{}{}", i == 0 ? "" : ", ", json_string(valid[i].file));
    out += "],\n \"broken\": [\n";
    for (std::size_t i = 0; i < broken.size(); ++i)
        out += fmt::format("{}{}", i == 0 ? "" : ",\n", entry(broken[i]));
    return out + "\n]}\n";
}

std::string disagreements(const std::vector<Case>& broken) {
    using Outcome = Expected::Outcome;
    const auto count = [&](Outcome outcome) {
        return std::count_if(broken.begin(), broken.end(),
                             [&](const Case& c) { return c.expected.outcome == outcome; });
    };
    const auto noticed = std::count_if(broken.begin(), broken.end(),
                                       [](const Case& c) { return c.validator_silence.empty(); });
    std::string out = fmt::format(kIntroduction, broken.size(), count(Outcome::refused),
                                  count(Outcome::warned), count(Outcome::ignored), noticed);
    out += tables(group(broken, [](const Case& c) { return c.expected.reason; }));
    out += "\n## Broken, though the validator reports no error\n";
    return out + tables(group(broken, [](const Case& c) { return c.validator_silence; }));
}

bool write_file(const std::filesystem::path& path, const std::string& content) {
    std::ofstream out(path, std::ios::binary);
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    out.close();
    return out.good();
}

bool write_files(const std::vector<Case>& cases, const std::filesystem::path& folder) {
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    for (const Case& c : cases) {
        // Some file systems flush to disk when a file is overwritten, but not for new files.
        std::filesystem::remove(folder / c.file, ignored);
        if (!write_file(folder / c.file, make_file(c))) return false;
    }
    return true;
}

}  // namespace hm::corpus
