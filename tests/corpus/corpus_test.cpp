// Loads every file of the corpus: rejected with the expected error code, JSON pointer and message,
// or tolerated as expected.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>

#include "corpus/report.h"
#include "corpus/rules.h"
#include "gltf/load.h"

namespace hm::corpus {
namespace {

namespace fs = std::filesystem;
using Outcome = Expected::Outcome;

const fs::path kFolder = "broken_gltf";

std::size_t warnings_of_base(Base base) {
    static std::map<Base, std::size_t> counts;
    const auto [found, is_new] = counts.try_emplace(base);
    if (is_new) {
        Case c;
        c.file = fmt::format("plain-{}.gltf", static_cast<int>(base));
        c.base = base;
        Diagnostics diagnostics;
        EXPECT_TRUE(write_files({c}, kFolder));
        EXPECT_TRUE(load_gltf(kFolder / c.file, diagnostics));
        found->second = diagnostics.warnings().size();
    }
    return found->second;
}

bool matches(const Expected& expected, std::string_view pointer, const std::string& message) {
    return pointer == expected.pointer && message.find(expected.message) != std::string::npos;
}

std::string all_lines(const Diagnostics& diagnostics) {
    std::string text;
    for (const Warning& warning : diagnostics.warnings())
        text += "\n    " + warning.location + ": " + warning.message;
    return text;
}

// Describes how the loader's result differs from the expected one; empty if it does not.
std::string mismatch(const Case& c) {
    const Expected& expected = c.expected;
    Diagnostics diagnostics;
    const auto scene = load_gltf(kFolder / c.file, diagnostics);
    if (!scene) {
        const Error& error = scene.error();
        if (expected.outcome == Outcome::refused && error.kind == expected.kind &&
            matches(expected, error.location, error.message) && !error.message.empty())
            return {};
        return fmt::format("refused, {}, {}: {}", name_of(error.kind), error.location,
                           error.message);
    }
    const auto& warnings = diagnostics.warnings();
    const bool warned = std::any_of(warnings.begin(), warnings.end(), [&](const Warning& w) {
        // Byte offsets in a GLB depend on the size of the base document.
        return matches(expected, w.location.starts_with("byte ") ? "" : w.location, w.message);
    });
    if (expected.outcome == Outcome::warned && warned) return {};
    if (expected.outcome == Outcome::ignored && warnings.size() == warnings_of_base(c.base))
        return {};
    return "loaded, warnings:" + all_lines(diagnostics);
}

TEST(BrokenFiles, AreRefusedOrToleratedAsExpected) {
    const std::vector<Case> cases = all_cases();
    EXPECT_GE(cases.size(), 400u);
    ASSERT_TRUE(write_files(cases, kFolder));
    for (const Case& c : cases) {
        const std::string text = mismatch(c);
        EXPECT_TRUE(text.empty()) << c.file << " (" << c.rule << ")\n  " << text << "\n  expected "
                                  << name_of(c.expected.kind.value_or(ErrorKind::internal)) << ", "
                                  << c.expected.pointer << ": " << c.expected.message
                                  << (c.expected.reason.empty() ? "" : "; because ")
                                  << c.expected.reason;
    }
}

TEST(BrokenFiles, TheirValidOriginalsLoad) {
    const std::vector<Case> cases = base_cases();
    ASSERT_TRUE(write_files(cases, kFolder));
    for (const Case& c : cases) {
        Diagnostics diagnostics;
        const auto scene = load_gltf(kFolder / c.file, diagnostics);
        EXPECT_TRUE(scene) << scene.error().line();
    }
}

TEST(BrokenFiles, TheTableOfDisagreementsIsUpToDate) {
    const char* source = std::getenv("HIMALAYA_SOURCE_DIR");
    std::ifstream file(fs::path(source != nullptr ? source : ".") / "docs/gltf-disagreements.md",
                       std::ios::binary);
    const std::string table((std::istreambuf_iterator<char>(file)), {});
    EXPECT_TRUE(table == disagreements(all_cases()))
        << "run generate_corpus FOLDER docs/gltf-disagreements.md";
}

}  // namespace
}  // namespace hm::corpus
