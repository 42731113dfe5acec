// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Formulas cut into words, and chains that are read otherwise elsewhere.
#include "gudgeon/base/formula_tokens.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "gudgeon/base/expression.h"
#include "gudgeon/base/formula_readings.h"

namespace gudgeon {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(FormulaTokens, CutAnyText) {
  std::vector<std::string> words;
  for (const FormulaToken& token : split_formula("-k*.5e-3<=rod.B.x && µ!=2**3 \"")) words.emplace_back(token.text);
  EXPECT_THAT(words, ElementsAre("-", "k", "*", ".5e-3", "<=", "rod.B.x", "&&", "µ", "!=", "2", "**", "3", "\""));
}

std::vector<std::string> list_chains(const std::string& formula) {
  std::vector<std::string> texts;
  for (const FormulaReading& reading : find_readings(formula)) {
    EXPECT_EQ(formula.substr(static_cast<std::size_t>(reading.position), reading.text.size()), reading.text);
    texts.push_back(reading.text);
  }
  return texts;
}

TEST(FormulaReadings, AreChainsOfPowers) {
  EXPECT_THAT(list_chains("1 + 2^3^2*t"), ElementsAre("2^3^2"));
  EXPECT_THAT(list_chains("sin(a^-b^2) + (t^(2^3))^2"), ElementsAre("a^-b^2"));
  EXPECT_THAT(list_chains("2^3 + 3^2*t^4 - (t^2)^3"), IsEmpty());
}

TEST(FormulaReadings, AreChainsOfComparisons) {
  EXPECT_THAT(list_chains("3 > t > 1 ? 2 : 0"), ElementsAre("3 > t > 1"));
  EXPECT_THAT(list_chains("max(t + 1 < 2 == 1, 3)"), ElementsAre("t + 1 < 2 == 1"));
  EXPECT_THAT(list_chains("3 > t && t > 1 || (t < 5) == 1 ? t < 2 : t < 3"), IsEmpty());
}

TEST(FormulaReadings, AreAsTheyAreSaidToBe) {
  EXPECT_EQ(ExpressionEvaluator("2^3^2", {}, {}).eval(nullptr), 512.0);
  EXPECT_EQ(ExpressionEvaluator("3 > 2 > 1", {}, {}).eval(nullptr), 0.0);
}

TEST(FormulaReadings, SurviveAnyText) {
  for (const char* text : {"", "((((", "))", ",,?", "^^", "< <", "a ^ ) ^ b"}) find_readings(text);
  find_readings(std::string(100000, '('));
}

}  // namespace
}  // namespace gudgeon
