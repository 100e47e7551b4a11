// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/font.h"

#include <gtest/gtest.h>

namespace c1mesh {
namespace {

TEST(Font, DecodesUtf8AndReplacesWhatIsNone) {
  EXPECT_EQ(characters_of("aé€😀"), (std::vector<char32_t>{'a', 0xE9, 0x20AC, 0x1F600}));
  EXPECT_EQ(characters_of("a\xff"
                          "b"),
            (std::vector<char32_t>{'a', 0xFFFD, 'b'}));
  EXPECT_EQ(characters_of("\xc3"), (std::vector<char32_t>{0xFFFD}));            // cut short
  EXPECT_EQ(characters_of("\xe2\x82z"), (std::vector<char32_t>{0xFFFD, 'z'}));  // cut by a letter
  EXPECT_EQ(characters_of("\x80"), (std::vector<char32_t>{0xFFFD}));
}

TEST(Font, WidthsAddUpButForKerning) {
  // No kerning between digits, which all have one width.
  const double digit = text_width("0", false);
  EXPECT_GT(digit, 0.3);
  EXPECT_LT(digit, 1);
  EXPECT_DOUBLE_EQ(text_width("0123456789", false), 10 * digit);
  EXPECT_GT(text_width("mmmm", true), text_width("mmmm", false));
  EXPECT_EQ(text_width("", false), 0);
  EXPECT_GT(text_width("\xe4\xb8\xad", false), 0);  // not in the font: a box
}

TEST(Font, TextWithinIsTheLongestBeginningThatFits) {
  EXPECT_EQ(text_within("short", 10, false), "short");
  const std::string text = "éééééééééééééééé";
  const double width = text_width("éééé…", false);
  EXPECT_EQ(text_within(text, width + 1e-9, false), "éééé…");
  EXPECT_EQ(text_within(text, width - 1e-9, false), "ééé…");
  EXPECT_EQ(text_within(text, 0, false), "…");
  EXPECT_LT(text_within(std::string(1000000, 'x'), 5, false).size(), 20u);
}

TEST(Font, OutlinesAreClosedContoursInsideTheLine) {
  const std::vector<GlyphStep> steps = text_outline("bo", false);
  int contours = 0;
  for (const GlyphStep& step : steps) {
    contours += step.kind == 'm';
    EXPECT_GE(step.to.x(), 0);
    EXPECT_LE(step.to.x(), text_width("bo", false));
    EXPECT_GE(step.to.y(), -0.3);
    EXPECT_LE(step.to.y(), 1);
  }
  EXPECT_EQ(contours, 4);  // each letter has one hole
  EXPECT_TRUE(text_outline(" ", false).empty());
}

}  // namespace
}  // namespace c1mesh
