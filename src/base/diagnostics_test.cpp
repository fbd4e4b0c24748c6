#include "base/diagnostics.h"

#include <gtest/gtest.h>

namespace hm {
namespace {

TEST(Diagnostics, CountsTheSameWarningOnce) {
    Diagnostics diagnostics;
    diagnostics.warn("a.gltf", "/nodes/0", "odd");
    diagnostics.warn("a.gltf", "/nodes/1", "strange");
    diagnostics.warn("a.gltf", "/nodes/2", "odd");
    diagnostics.warn("b.gltf", "/nodes/3", "odd");
    const auto& warnings = diagnostics.warnings();
    ASSERT_EQ(warnings.size(), 3u);
    EXPECT_EQ(warnings[0].line(), "a.gltf: /nodes/0: odd (2 times)");
    EXPECT_EQ(warnings[1].line(), "a.gltf: /nodes/1: strange");
    EXPECT_EQ(warnings[2].line(), "b.gltf: /nodes/3: odd");
}

TEST(Diagnostics, LineEscapesAndLeavesOutWhatIsEmpty) {
    EXPECT_EQ((Warning{"", "",
                       "a\x1B"
                       "b"}
                   .line()),
              "a\\x1B"
              "b");
    EXPECT_EQ((Warning{"f", "", "m", 3}.line()), "f: m (3 times)");
}

TEST(Diagnostics, NotesAreNoWarnings) {
    Diagnostics diagnostics;
    diagnostics.note("a.glb", "/extensionsUsed/0", "is metadata");
    diagnostics.note("a.glb", "/extensionsUsed/1", "is metadata");
    EXPECT_TRUE(diagnostics.warnings().empty());
    ASSERT_EQ(diagnostics.notes().size(), 1u);
    EXPECT_EQ(diagnostics.notes()[0].line(), "a.glb: /extensionsUsed/0: is metadata (2 times)");
}

}  // namespace
}  // namespace hm
