// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Widths and alignment.
#include "gudgeon/report/table.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace gudgeon {
namespace {

TEST(Table, KeepsEachRowOnOneLine) {
  Table table({{"sta\nge"}, {"value"}});
  table.add_row({"wear_1\n  forged", "a\tb\x1b[2J"});
  EXPECT_EQ(table.render(false), "  sta\\u000Age           value\n  wear_1\\u000A  forged  a\\u0009b\\u001B[2J\n");
  EXPECT_EQ(render_title("case 'a\nb'", false), "\ncase 'a\\u000Ab'\n");
}

TEST(Table, AlignsColumnsWhateverTheirLetters) {
  Table table({{"name", Alignment::left}, {"value", Alignment::right}, {"note"}});
  table.add_row({"A", "5.768 µm", "ẍ"});
  table.add_row({"slider", "–", "plain"});
  table.add_row({"x"});
  EXPECT_EQ(table.render(false),
            "  name       value  note\n"
            "  A       5.768 µm  ẍ\n"
            "  slider         –  plain\n"
            "  x\n");
}

TEST(Table, ColorMarksTheHeadingOnly) {
  Table table({{"a"}});
  table.add_row({"b"});
  EXPECT_EQ(table.render(true), "\033[1m  a\033[0m\n  b\n");
  EXPECT_EQ(render_title("T", true), "\n\033[1mT\033[0m\n");
  EXPECT_EQ(render_title("T", false), "\nT\n");
}

TEST(Table, RefusesCellsWithoutAColumn) {
  Table table({{"a"}});
  EXPECT_TRUE(table.empty());
  EXPECT_THROW(table.add_row({"b", "c"}), std::out_of_range);
}

TEST(DisplayWidth, CountsWhatATerminalShows) {
  EXPECT_EQ(find_display_width(""), 0u);
  EXPECT_EQ(find_display_width("abc"), 3u);
  EXPECT_EQ(find_display_width("µm"), 2u);
  EXPECT_EQ(find_display_width("ẍ"), 1u);
  EXPECT_EQ(find_display_width("θ\u0307"), 1u);  // with a combining dot
  EXPECT_EQ(find_display_width("→ ∫ √"), 5u);
  EXPECT_EQ(find_display_width("轴承"), 4u);
  EXPECT_EQ(find_display_width("\xff\xc3"), 2u);  // not UTF-8
}

}  // namespace
}  // namespace gudgeon
