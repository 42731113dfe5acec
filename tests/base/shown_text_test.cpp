// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Control characters made visible, long texts cut, broken UTF-8 borne.
#include "gudgeon/base/shown_text.h"

#include <gtest/gtest.h>

namespace gudgeon {
namespace {

TEST(ShownText, LeavesVisibleTextsAlone) {
  for (const char* text : {"", "a", "a\tb\nc", "0.5 µm", "日本", "…", "\U0001F600"}) {
    EXPECT_EQ(show_controls(text), text);
    EXPECT_EQ(find_control(text), "");
  }
}

TEST(ShownText, ShowsWhatWouldCommandATerminal) {
  EXPECT_EQ(show_controls("a\x1b[2Jb"), "a\\u001B[2Jb");
  EXPECT_EQ(show_controls("a\rb\x7f"), "a\\u000Db\\u007F");
  EXPECT_EQ(show_controls("\u009b31m"), "\\u009B31m");             // the one-character form of ESC [
  EXPECT_EQ(show_controls("x\u202ey\u2066"), "x\\u202Ey\\u2066");  // texts that run backwards
  EXPECT_EQ(show_controls(std::string_view("a\0b", 3)), "a\\u0000b");
  EXPECT_EQ(find_control("ab\x1b"), "U+001B");
  EXPECT_EQ(find_control("ä\u0085"), "U+0085");
}

TEST(ShownText, ShowsLineEndsWhereThereIsOneLine) {
  EXPECT_EQ(show_line("a\tb\nc\rd"), "a\\u0009b\\u000Ac\\u000Dd");
  EXPECT_EQ(show_line("0.5 µm\xff"), "0.5 µm\\xFF");
}

TEST(ShownText, ShowsBytesThatAreNoUtf8) {
  EXPECT_EQ(show_controls("\x9b"
                          "31m"),
            "\\x9B31m");
  EXPECT_EQ(show_controls("a\xc3"), "a\\xC3");
  EXPECT_EQ(show_controls("\xe2\x82z\xff"), "\\xE2\\x82z\\xFF");
  EXPECT_EQ(show_controls("\xc0\x9b"), "\\xC0\\x9B");  // too long a form of ESC
}

TEST(ShownText, CutsLongTextsInTheMiddle) {
  EXPECT_EQ(shorten("abcdef", 6), "abcdef");
  EXPECT_EQ(shorten("abcdefghij", 6), "abcd … (4 characters left out) … ij");
  EXPECT_EQ(shorten("ääääää", 6), "ääääää");
  EXPECT_EQ(shorten("äöüäöüß", 3), "äö … (4 characters left out) … ß");
}

}  // namespace
}  // namespace gudgeon
