// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Formulas: values against the same formula in C++, names with dots, positions of errors, no exceptions when run.
#include "gudgeon/base/expression.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <clocale>
#include <cmath>
#include <numbers>

namespace gudgeon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

double eval_constant(const std::string& text) { return ExpressionEvaluator(text, {}, {}).eval(nullptr); }

TEST(Expression, HasItsValue) {
  const std::vector<std::string> names{"t", "crank.angle", "rod.B.x_velocity"};
  ExpressionEvaluator formula("-k*(crank.angle - 0.2) + F0*cos(2*pi*t) - .5*rod.B.x_velocity^2",
                              {{"k", 3.0}, {"F0", 7.0}}, names);
  for (const double t : {0.0, 0.3, 1.7}) {
    const std::array values{t, 2.0 - t, 1.5 * t};
    EXPECT_DOUBLE_EQ(
        formula.eval(values.data()),
        -3.0 * (values[1] - 0.2) + 7.0 * std::cos(2.0 * std::numbers::pi * t) - 0.5 * values[2] * values[2]);
  }
}

TEST(Expression, ReadsOnlyWhatItUses) {
  const std::array values{0.5, 1e3, 4.0, -1.0};
  ExpressionEvaluator formula("a.y + t", {}, {"t", "a.x", "a.y", "rod-1.x"});
  EXPECT_THAT(formula.used_variables(), ElementsAre(0, 2));
  EXPECT_EQ(formula.eval(values.data()), 4.5);
  ExpressionEvaluator moved = std::move(formula);
  EXPECT_EQ(moved.eval(values.data()), 4.5);
  EXPECT_THAT(ExpressionEvaluator("2", {}, {"t"}).used_variables(), testing::IsEmpty());
}

TEST(Expression, Compares) {
  ExpressionEvaluator formula("t < 1 ? 2 : (t >= 2 && t != 3 ? 5 : -1)", {}, {"t"});
  const auto at = [&](double t) { return formula.eval(&t); };
  EXPECT_EQ(at(0.5), 2.0);
  EXPECT_EQ(at(1.5), -1.0);
  EXPECT_EQ(at(2.0), 5.0);
  EXPECT_EQ(at(3.0), -1.0);
}

TEST(Expression, KnowsFunctions) {
  EXPECT_DOUBLE_EQ(eval_constant("log(100)"), std::log(100.0));
  EXPECT_DOUBLE_EQ(eval_constant("atan2(1, -2) + max(1, 3, 2) + abs(-4)"), std::atan2(1.0, -2.0) + 7.0);
  EXPECT_DOUBLE_EQ(eval_constant("-2^2"), -4.0);
}

TEST(Expression, TakesEveryNumberButZeroForTrue) {
  const std::vector<std::pair<std::string, double>> constants{{"half", 0.5}, {"nothing", 0.0}};
  const auto eval = [&](const char* text) { return ExpressionEvaluator(text, constants, {}).eval(nullptr); };
  EXPECT_EQ(eval("half && 1"), 1.0);
  EXPECT_EQ(eval("half || nothing"), 1.0);
  EXPECT_EQ(eval("nothing && half"), 0.0);
  EXPECT_EQ(eval("nothing || 0"), 0.0);
  EXPECT_EQ(eval("0.5 && 0.25"), 1.0);
  EXPECT_EQ(eval("0 || -0.1"), 1.0);
  EXPECT_EQ(eval("half ? 3 : 4"), 3.0);
}

TEST(Expression, RoundsAndRaises) {
  EXPECT_EQ(eval_constant("floor(-1.2) + 10*ceil(-1.2) + 100*round(2.5) + 1000*round(-2.5)"),
            -2.0 - 10.0 + 300.0 - 3000.0);
  EXPECT_EQ(eval_constant("pow(2, 10)"), 1024.0);
  // The divisor's sign, as in MATLAB, Octave and Python, whose % it is.
  EXPECT_DOUBLE_EQ(eval_constant("mod(7, 3)"), 1.0);
  EXPECT_DOUBLE_EQ(eval_constant("mod(-7, 3)"), 2.0);
  EXPECT_DOUBLE_EQ(eval_constant("mod(7, -3)"), -2.0);
  EXPECT_TRUE(std::isnan(eval_constant("mod(1, 0)")));
}

TEST(Expression, ListsItsFunctions) {
  const std::vector<std::string>& names = list_formula_functions();
  EXPECT_THAT(names, testing::IsSupersetOf({"sin", "atan2", "sqrt", "smooth_step", "max", "floor", "mod"}));
  EXPECT_THAT(names, testing::Not(testing::Contains("pi")));
}

TEST(Expression, StepsSmoothly) {
  ExpressionEvaluator formula("smooth_step(t, 1, 3)", {}, {"t"});
  const auto at = [&](double t) { return formula.eval(&t); };
  EXPECT_EQ(at(0.0), 0.0);
  EXPECT_EQ(at(2.0), 0.5);
  EXPECT_EQ(at(4.0), 1.0);
  // Slope and curvature vanish at both ends; 1e-3 of the width leaves 10 h³ of the value.
  EXPECT_NEAR(at(1.002), 0.0, 1.1e-8);
  EXPECT_NEAR(at(2.998), 1.0, 1.1e-8);
}

TEST(Expression, HasNoValueWhereThereIsNone) {
  ExpressionEvaluator formula("1/t + sqrt(t)", {}, {"t"});
  const auto at = [&](double t) { return formula.eval(&t); };
  EXPECT_TRUE(std::isnan(at(0.0)));
  EXPECT_TRUE(std::isnan(at(-1.0)));
  EXPECT_EQ(at(4.0), 2.25);
  EXPECT_TRUE(std::isnan(at(std::nan(""))));
}

TEST(Expression, IgnoresTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"}) {
    if (std::setlocale(LC_ALL, name) != nullptr) break;
  }
  EXPECT_EQ(eval_constant("max(0.5, 0.25)"), 0.5);
  std::setlocale(LC_ALL, before.c_str());
}

struct BadExpression {
  const char* text;
  std::size_t position;
  const char* message;  ///< a part of it
};

class ExpressionRejects : public testing::TestWithParam<BadExpression> {};

TEST_P(ExpressionRejects, AndSaysWhere) {
  try {
    const ExpressionEvaluator formula(GetParam().text, {{"k", 1.0}}, {"t", "crank.angle"});
    FAIL() << "it was understood";
  } catch (const ExpressionError& error) {
    EXPECT_THAT(error.what(), HasSubstr(GetParam().message));
    EXPECT_EQ(error.position(), GetParam().position);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Texts, ExpressionRejects,
    testing::Values(BadExpression{"2*crnk.angle", 2, "'crnk.angle'"}, BadExpression{"t + + ", 0, "has no operand"},
                    BadExpression{"sin(t", 5, "')' is missing"}, BadExpression{"sin(t, 2)", 0, "too many"},
                    BadExpression{"t * ", 4, "unexpected end"}, BadExpression{"atan2(t)", 0, "too few"},
                    BadExpression{"k = 3", 2, "assign"}, BadExpression{"t <= 1 ? t = 2 : 1", 11, "assign"},
                    BadExpression{"t, 2", 1, "one value"}, BadExpression{"\"t\"", 1, "quotes"},
                    BadExpression{"", 0, "empty"}, BadExpression{"2 t", 2, "'t'"}, BadExpression{"t > 1 ? 2", 0, "':'"},
                    BadExpression{"t*_pi", 2, "'_pi'"}, BadExpression{"3*(t))", 5, "')'"},
                    BadExpression{"nosuch(t)", 0, "'nosuch'"}));

// muParser takes 20000 characters, and what is asked of each comparison makes a formula longer to it.
TEST(Expression, TellsThatAFormulaIsTooLong) {
  const auto repeat = [](const std::string& piece, int times) {
    std::string text = "t";
    for (int k = 0; k < times; ++k) text += piece;
    return text;
  };
  EXPECT_NO_THROW(ExpressionEvaluator(repeat("+t", 9000), {}, {"t"}));
  const auto expect_too_long = [](const std::string& text, std::size_t from, std::size_t to) {
    try {
      const ExpressionEvaluator evaluator(text, {}, {"t"});
      FAIL() << "it was understood";
    } catch (const ExpressionError& error) {
      EXPECT_THAT(error.what(), HasSubstr("too long: it may have 20000 characters"));
      EXPECT_GE(error.position(), from);
      EXPECT_LE(error.position(), to);
    }
  };
  expect_too_long(repeat("+t", 11000), 20000, 20000);
  // Of 18 to 21 characters each to muParser.
  expect_too_long(repeat("+(t>1)", 3000), 6 * 950, 6 * 1112);
  // Comparisons within comparisons, of all of which the text is kept.
  expect_too_long(repeat("<t", 9000), 2 * 1000, 2 * 1700);
}

TEST(Expression, TellsThatAFormulaNestsTooDeep) {
  const auto nest = [](const std::string& begin, int times) {
    std::string text;
    for (int k = 0; k < times; ++k) text += begin;
    return text + "t" + std::string(static_cast<std::size_t>(times), ')');
  };
  const double minus = -3.0;
  EXPECT_EQ(ExpressionEvaluator(nest("abs(", 200), {}, {"t"}).eval(&minus), 3.0);
  for (const int times : {201, 3000, 3900}) {
    try {
      const ExpressionEvaluator evaluator(nest("abs(", times), {}, {"t"});
      FAIL() << "it was understood";
    } catch (const ExpressionError& error) {
      EXPECT_THAT(error.what(), HasSubstr("its parentheses nest deeper than 200 levels"));
      EXPECT_EQ(error.position(), 4U * 200U + 3U);
    }
  }
}

// The time that it takes to refuse a formula grows with its length: seconds, where it grew with the cube of it.
TEST(Expression, RefusesWhatIsTooLongAtOnce) {
  std::string chain = "t";
  for (int k = 0; k < 9999; ++k) chain += "<t";
  std::string flat = "t";
  for (int k = 0; k < 2800; ++k) flat += "+abs(t)";
  const auto start = std::chrono::steady_clock::now();
  for (int k = 0; k < 20; ++k) {
    EXPECT_THROW(ExpressionEvaluator(chain, {}, {"t"}), ExpressionError);
    EXPECT_THROW(ExpressionEvaluator(flat, {}, {"t"}), ExpressionError);
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  EXPECT_LT(taken.count(), 5.0);
}

}  // namespace
}  // namespace gudgeon
