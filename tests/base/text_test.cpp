// SPDX-License-Identifier: MIT
// What is shown of text from outside, and which word is offered for a mistyped one.
#include "franken/nearest.h"
#include "franken/printable.h"

#include <gtest/gtest.h>

#include <vector>

namespace franken {
namespace {

struct Shown {
    std::string_view text, shown;
};

TEST(Printable, EscapesWhatSteersATerminal) {
    for (const auto& [text, shown] : {
             Shown{"basecolor+sun1", "basecolor+sun1"},
             {"\x1b[31mred", "\\x1b[31mred"},
             {"a\r\n\tb\x7f", "a\\r\\n\\tb\\x7f"},
             {"\xc2\x9bm", "\\u{009b}m"},                   // U+009B, the eight-bit CSI.
             {"\x9bm", "\\x9bm"},                           // The same byte alone is no UTF-8.
             {"a\xe2\x80\xaetxt.exe", "a\\u{202e}txt.exe"}, // U+202E turns the direction of writing.
             {"\xe2\x81\xa6\xe2\x80\x8b\xef\xbb\xbf", "\\u{2066}\\u{200b}\\u{feff}"},
             {"\xf3\xa0\x81\x81", "\\u{e0041}"},                                    // A tag.
             {"a\xcd\x8f\xef\xb8\x8f\xe3\x85\xa4", "a\\u{034f}\\u{fe0f}\\u{3164}"}, // Seen by nobody.
             {"\xc2\xad\xf3\xa0\x84\x80", "\\u{00ad}\\u{e0100}"},
             {"\xe2\x80\xa8\xe2\x80\xa9\xc2\x85", "\\u{2028}\\u{2029}\\u{0085}"}, // Line ends.
             {"M\xc3\xbcnchen \xe6\xb0\xb4 \xf0\x9f\x8c\x8a", "M\xc3\xbcnchen \xe6\xb0\xb4 \xf0\x9f\x8c\x8a"},
             {"\xc0\xaf", "\\xc0\\xaf"},          // Overlong.
             {"\xed\xa0\x80", "\\xed\\xa0\\x80"}, // A surrogate.
             {"\xe2\x80", "\\xe2\\x80"},          // Cut.
             {std::string_view("\0", 1), "\\x00"},
         })
        EXPECT_EQ(printable(text), shown);
}

TEST(Printable, KeepsLinesWhereTheyAreWanted) {
    EXPECT_EQ(printableLines("a\n\tb\x1b"), "a\n\tb\\x1b");
    EXPECT_EQ(withoutByteOrderMark("\xEF\xBB\xBFsun1"), "sun1");
    EXPECT_EQ(withoutByteOrderMark("sun1\xEF\xBB\xBF"), "sun1\xEF\xBB\xBF");
}

TEST(Printable, ANameForgesNoMessage) {
    EXPECT_EQ(printableMessage("one\n  two\nerror: three\n\nfour\x1b"),
              "one\n  two\n  error: three\n\n  four\\x1b");
    EXPECT_EQ(printable(Error{"a.b", "x\ny", "what\nerror: no\x1b", "do\nit"}),
              "x\\ny: what\n  error: no\\x1b (do\\nit) [a.b]");
}

struct Meant {
    std::string_view typed, meant;
};

TEST(Nearest, OffersWhatWasProbablyMeant) {
    const std::vector<std::string_view> words = {"sun0",   "sun1",  "sun2",      "sun3",   "sun4",
                                                 "lamp0",  "lamp1", "lamp4",     "normal", "list",
                                                 "linear", "sky",   "basecolor", "--with"};
    for (const auto& [typed, meant] : {
             Meant{"sun5", "sun4"},
             {"sun10", "sun4"},
             {"sun", "sun1"},
             {"sum2", "sun2"},
             {"lamp2", "lamp1"},
             {"lamp9", "lamp4"},
             {"nromal", "normal"},
             {"lits", "list"},
             {"base-color", "basecolor"},
             {"--wiht", "--with"},
             {"LIST", "list"},
             {"Normal", "normal"},
             {"SUN7", "sun4"},
             {"xyzzy", ""},
             {"", ""},
             {"reflection", ""},
         })
        EXPECT_EQ(nearestWord(typed, words), meant) << typed;
    EXPECT_EQ(nearestWord(std::string(1 << 20, 'x'), words), "");
    EXPECT_EQ(nearestWord("sun1", {}), "");
}

} // namespace
} // namespace franken
