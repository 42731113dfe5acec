// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// How deep a text nests: what counts, what does not, and where it is too deep.
#include "gudgeon/io/nesting.h"

#include <gtest/gtest.h>

#include <string>

#include "gudgeon/io/model_reader.h"

namespace gudgeon {
namespace {

std::string repeat(const std::string& piece, int times) {
  std::string text;
  for (int k = 0; k < times; ++k) text += piece;
  return text;
}

struct Nested {
  std::string text;
  int line;    // 0: it is not too deep
  int column;  // of the part that is
};

class Nesting : public testing::TestWithParam<Nested> {};

TEST_P(Nesting, IsFoundWhereItIsTooDeep) {
  const auto [text, line, column] = GetParam();
  const auto place = find_deep_nesting(text);
  ASSERT_EQ(place.has_value(), line > 0);
  if (!place) return;
  EXPECT_EQ(place->line, line);
  EXPECT_EQ(place->column, column);
}

INSTANTIATE_TEST_SUITE_P(
    Texts, Nesting,
    testing::Values(
        Nested{"", 0, 0}, Nested{"a.b = 1\n[c.d]\ne = [[1.5, 2.5]]\n", 0, 0},
        // keys and headers of 32 and 33 parts
        Nested{repeat("a.", 31) + "a = 1", 0, 0}, Nested{"# ä\n" + repeat("a.", 32) + "a = 1", 2, 65},
        Nested{"[" + repeat("a.", 31) + "a]\n", 0, 0}, Nested{"[" + repeat("a . ", 32) + "a]\n", 1, 130},
        Nested{"[[" + repeat("a.", 32) + "a]]\n", 1, 65},
        Nested{"[" + repeat("a.", 20) + "a]\nb = 1\n" + repeat("b.", 11) + "b = 1\n", 3, 23},
        // a header ends the one before it
        Nested{repeat("[" + repeat("a.", 20) + "a]\nb = 1\n", 3), 0, 0},
        // brackets, and keys within braces
        Nested{"a = " + repeat("[", 31) + repeat("]", 31), 0, 0}, Nested{"ä = " + repeat("[", 32), 1, 36},
        Nested{"a = " + repeat("{a = ", 16) + "1" + repeat("}", 16), 1, 81},
        Nested{"a = {" + repeat("a.", 30) + "a = 1}", 1, 66}, Nested{"a = [" + repeat("{a.b = 1},\n", 99) + "]", 0, 0},
        Nested{"a = { " + repeat("b.c = [1, 2], ", 99) + "d = 1 }\n" + repeat("a.", 31) + "a = 1", 0, 0},
        // texts and comments hold no keys
        Nested{"a = \"" + repeat("a.[{", 99) + "\"\n", 0, 0}, Nested{"a = '\\'\n" + repeat("b.", 31) + "b = 1", 0, 0},
        Nested{"a = \"\\\"" + repeat("[", 99) + "\"", 0, 0}, Nested{"a = '''\n" + repeat("[\n", 99) + "'' '''\n", 0, 0},
        Nested{"a = \"\"\"" + repeat("\"\"[", 99) + "\"\"\"\"\"\n", 0, 0}, Nested{"a = 1 # " + repeat("[", 99), 0, 0},
        Nested{repeat("'a.b'.", 32) + "\"c.d\" = 1", 1, 193},
        // no valid TOML
        Nested{"]]}}],,==\"", 0, 0}, Nested{"\"\\", 0, 0}, Nested{"= [ \n '", 0, 0}, Nested{"a = \"\"\"", 0, 0}));

TEST(Nesting, OfThousandsOfLevelsIsAnErrorWithAPlace) {
  for (const std::string& text : {repeat("a.", 200000) + "a = 1\n", "[" + repeat("a.", 200000) + "a]\n",
                                  "a = " + repeat("{" + repeat("a.", 99) + "a = ", 200) + "1" + repeat("}", 200)}) {
    const ModelFile model = read_model_text("m.toml", text);
    const std::string errors = render(model.diagnostics, model.source);
    EXPECT_TRUE(errors.starts_with("m.toml:1:")) << errors;
    EXPECT_NE(errors.find("error E-TOML-002: the file nests deeper than 32 levels here"), std::string::npos) << errors;
    EXPECT_LT(errors.size(), 1000U);
  }
}

}  // namespace
}  // namespace gudgeon
