#include "base/text.h"

#include <gtest/gtest.h>

namespace hm {
namespace {

TEST(Printable, KeepsOrdinaryText) {
    EXPECT_EQ(printable(""), "");
    EXPECT_EQ(printable("a b~/\"\\"), "a b~/\"\\");
    EXPECT_EQ(printable("\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x8F\x94"),
              "\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x8F\x94");
    EXPECT_EQ(printable("\xC2\xA0"), "\xC2\xA0");  // U+00A0, the first character after C1
}

TEST(Printable, EscapesControlCharacters) {
    EXPECT_EQ(printable("a\nb\tc"), "a\\x0Ab\\x09c");
    EXPECT_EQ(printable("\x1B[31m"), "\\x1B[31m");
    EXPECT_EQ(printable("\x7F"), "\\x7F");
    EXPECT_EQ(printable("\xC2\x9B"), "\\xC2\\x9B");
    EXPECT_EQ(printable(std::string_view("\0", 1)), "\\x00");
}

TEST(Printable, EscapesWhatTurnsTheDirectionOrBreaksTheLine) {
    EXPECT_EQ(printable("a\xE2\x80\xAE"
                        "b"),
              "a\\xE2\\x80\\xAEb");                           // U+202E
    EXPECT_EQ(printable("\xE2\x81\xA6"), "\\xE2\\x81\\xA6");  // U+2066
    EXPECT_EQ(printable("\xE2\x80\xA8"), "\\xE2\\x80\\xA8");  // U+2028
    EXPECT_EQ(printable("\xD8\x9C"), "\\xD8\\x9C");           // U+061C
    // Neighbouring code points are kept: en dash, zero-width joiner, fraction slash, Arabic letter.
    const char* plain = "\xE2\x80\x93 \xE2\x80\x8D \xE2\x81\x84 \xD8\xA7";
    EXPECT_EQ(printable(plain), plain);
}

TEST(Printable, EscapesWhatIsNotUtf8) {
    EXPECT_EQ(printable("\x80"), "\\x80");                    // continuation without a lead byte
    EXPECT_EQ(printable("\xC0\xAF"), "\\xC0\\xAF");           // overlong
    EXPECT_EQ(printable("\xE0\x9F\xBF"), "\\xE0\\x9F\\xBF");  // overlong
    EXPECT_EQ(printable("\xED\xA0\x80"), "\\xED\\xA0\\x80");  // surrogate
    EXPECT_EQ(printable("\xF4\x90\x80\x80"), "\\xF4\\x90\\x80\\x80");  // above U+10FFFF
    EXPECT_EQ(printable("\xE2\x82"), "\\xE2\\x82");                    // truncated
    EXPECT_EQ(printable("\xE2\x82z"), "\\xE2\\x82z");  // resumes at the next character
}

TEST(Joined, PutsSeparatorsBetweenParts) {
    EXPECT_EQ(joined({}, ", "), "");
    EXPECT_EQ(joined({"a"}, ", "), "a");
    EXPECT_EQ(joined({"a", "b", "c"}, "; "), "a; b; c");
}

}  // namespace
}  // namespace hm
