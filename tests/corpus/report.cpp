#include "corpus/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>

#include "base/json_writer.h"

namespace hm::corpus {
namespace {

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

void write_entry(JsonWriter& json, const Case& c) {
    const Expected& e = c.expected;
    json.begin_object().field("file", c.file).field("rule", c.rule).field("section", c.section);
    json.field("loader", name(e.outcome)).field("kind", e.kind ? name_of(*e.kind) : "");
    json.field("pointer", e.pointer).field("message", e.message).field("reason", e.reason);
    json.field("validator", c.validator_silence.empty() ? "error" : "no error");
    json.field("validatorReason", c.validator_silence).end_object();
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
    JsonWriter json(JsonText::exact);
    json.begin_object(JsonLayout::lines).key("valid").begin_array();
    for (const Case& c : valid)
        json.value(c.file);
    json.end_array().key("broken").begin_array(JsonLayout::lines);
    for (const Case& c : broken)
        write_entry(json, c);
    return json.end_array().end_object().text() + "\n";
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
