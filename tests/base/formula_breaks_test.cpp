// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Breaks of formulas: which there are, where their pieces end, and that a held piece goes on beyond its end.
#include "gudgeon/base/formula_breaks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gudgeon/base/expression.h"

namespace gudgeon {
namespace {

using testing::ElementsAre;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<std::string> list_texts(const std::string& formula) {
  std::vector<std::string> texts;
  for (const FormulaBreak& at : mark_breaks(formula).breaks) texts.push_back(at.text);
  return texts;
}

// The formula of t with its breaks held, as they were found at one time.
struct HeldFormula {
  explicit HeldFormula(const std::string& text)
      : evaluator(text, {{"low", -1.0}}, {"t", "u"}), found(evaluator.breaks().size()) {}

  double eval(double t, const int* held = nullptr, double u = 0.0) {
    const double values[] = {t, u};
    return evaluator.eval(values, held, found.data());
  }
  std::vector<int> find_pieces(double t) {
    eval(t);
    std::vector<int> pieces;
    for (const BreakState& state : found) pieces.push_back(state.met ? state.piece : kFreePiece);
    return pieces;
  }

  ExpressionEvaluator evaluator;
  std::vector<BreakState> found;
};

TEST(FormulaBreaks, AreComparisonsAndFunctionsThatJumpOrBend) {
  EXPECT_THAT(list_texts("3*sin(t) + exp(-t)^2 - 1e-3*t"), testing::IsEmpty());
  EXPECT_THAT(list_texts("t > 0.5034 && t < 0.5114 ? 1000 : 0"), ElementsAre("t > 0.5034", "t < 0.5114"));
  EXPECT_THAT(list_texts("sign(t) > 0"), testing::UnorderedElementsAre("sign(t)", "sign(t) > 0"));
  EXPECT_THAT(list_texts("-5*sign(block.x_velocity) + abs(t - 1)"),
              ElementsAre("sign(block.x_velocity)", "abs(t - 1)"));
}

TEST(FormulaBreaks, AreToldAsTheyWereWritten) {
  EXPECT_THAT(list_texts("abs(min(t, 2)) > (t<1) + 3"),
              testing::UnorderedElementsAre("abs(min(t, 2))", "min(t, 2)", "abs(min(t, 2)) > (t < 1) + 3", "t < 1"));
  EXPECT_THAT(list_texts("t < 1 < 2"), testing::UnorderedElementsAre("t < 1", "t < 1 < 2"));
}

TEST(FormulaBreaks, AreLeftAloneWhereTheHeldPieceHasNoValue) {
  HeldFormula root("abs(t)^0.5");
  const std::vector<int> held = root.find_pieces(1.0);
  EXPECT_EQ(root.eval(-4.0, held.data()), 2.0);
  EXPECT_EQ(root.found[0].argument, -4.0);
}

TEST(FormulaBreaks, HaveTheOperandsThatPrecedenceGives) {
  EXPECT_THAT(list_texts("(t+1)*2 < 3^2-1 || u >= -t ? (t == 2) : max(t < 1, 2)"),
              testing::UnorderedElementsAre("(t + 1) * 2 < 3 ^ 2 - 1", "u >= - t", "t == 2", "max(t < 1, 2)", "t < 1"));
  EXPECT_THAT(list_texts("3 > t > 1").size(), 2u);
}

struct FormulaInBothLanguages {
  const char* text;
  double (*value)(double t, double u);
};

double smooth(double x, double a, double b) {
  const double s = std::min(std::max((x - a) / (b - a), 0.0), 1.0);
  return s * s * s * (10.0 + s * (-15.0 + 6.0 * s));
}

const FormulaInBothLanguages kFormulas[] = {
    {"3 > t > 1", [](double t, double) { return (3 > t ? 1.0 : 0.0) > 1 ? 1.0 : 0.0; }},
    // All comparisons have one rank, and are read from the left.
    {"t < 1 == u < 2", [](double t, double u) { return ((t < 1 ? 1.0 : 0.0) == u ? 1.0 : 0.0) < 2 ? 1.0 : 0.0; }},
    {"(t+1)*2 < 3^2-1 || u >= -t ? (t == 2) : max(t < 1, 2)",
     [](double t, double u) { return (t + 1) * 2 < 8 || u >= -t ? (t == 2 ? 1.0 : 0.0) : 2.0; }},
    {"min(t, u, 1 - t) + max(t, u) - abs(t*u)",
     [](double t, double u) {
       return std::min({t, u, 1 - t}) + std::max(t, u) - std::abs(t * u);
     }},
    {"sign(t - 1) + sign(u) - rint(3*t)",
     [](double t, double u) { return (t > 1) - (t < 1) + (u > 0) - (u < 0) - std::floor(3 * t + 0.5); }},
    {"t > 1 ? u > 1 ? 4 : 3 : u < low ? 2 : 1",
     [](double t, double u) { return t > 1 ? (u > 1 ? 4.0 : 3.0) : (u < -1 ? 2.0 : 1.0); }},
    {"smooth_step(t, 0.5, 1.5) - smooth_step(u, 2, 1)",
     [](double t, double u) { return smooth(t, 0.5, 1.5) - smooth(u, 2, 1); }}};

TEST(FormulaBreaks, LeaveTheValueAsItIs) {
  for (const auto& [text, value] : kFormulas) {
    HeldFormula formula(text);
    ASSERT_FALSE(formula.found.empty());
    for (double t = -2.0; t <= 3.0; t += 0.25) {
      for (double u = -2.0; u <= 3.0; u += 0.25) {
        EXPECT_DOUBLE_EQ(formula.eval(t, nullptr, u), value(t, u)) << text << " at " << t << ", " << u;
      }
    }
  }
}

TEST(FormulaBreaks, HoldTheirPieceBeyondItsEnd) {
  HeldFormula step("t < 1 ? t : 5");
  const std::vector<int> before = step.find_pieces(0.5);
  EXPECT_EQ(step.eval(2.0), 5.0);
  EXPECT_EQ(step.eval(2.0, before.data()), 2.0);
  EXPECT_DOUBLE_EQ(step.found[0].argument, 1.0);
  EXPECT_EQ(step.found[0].low, -kInfinity);
  EXPECT_EQ(step.found[0].high, 0.0);

  HeldFormula bend("abs(t) + max(t, 2*t - 1)");
  const std::vector<int> right = bend.find_pieces(0.5);
  EXPECT_DOUBLE_EQ(bend.eval(-2.0, right.data()), -2.0 - 2.0);
  HeldFormula rise("smooth_step(t, 1, 3)");
  const std::vector<int> middle = rise.find_pieces(2.0);
  EXPECT_DOUBLE_EQ(rise.eval(5.0, middle.data()), 8.0 * (10.0 - 30.0 + 24.0));
  EXPECT_DOUBLE_EQ(rise.found[0].argument, 2.0);
}

TEST(FormulaBreaks, OfBranchesNotTakenAreNotMet) {
  HeldFormula nested("t < 1 ? 0 : (u < 2 ? 1 : 2)");
  nested.eval(0.0);
  EXPECT_TRUE(nested.found[0].met);
  EXPECT_FALSE(nested.found[1].met);
  nested.eval(3.0);
  EXPECT_TRUE(nested.found[1].met);
}

TEST(FormulaBreaks, OfWholeNumbersLieOneApart) {
  HeldFormula wave("rint(t)");
  wave.eval(2.2);
  EXPECT_EQ(wave.found[0].low, 1.5);
  EXPECT_EQ(wave.found[0].high, 2.5);
}

}  // namespace
}  // namespace gudgeon
