// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The parameter tables of all laws of all families: what reader, writer, manual and bindings rely on.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <string>

#include "gudgeon/laws/damping/any.h"
#include "gudgeon/laws/friction/any.h"
#include "gudgeon/laws/normal/any.h"
#include "gudgeon/laws/wear/any.h"
#include "tests/laws/sample_law.h"

namespace gudgeon {
namespace {

bool is_snake_case(std::string_view text) {
  if (text.empty() || !std::islower(static_cast<unsigned char>(text.front()))) return false;
  return std::ranges::all_of(text, [](unsigned char c) { return std::islower(c) || std::isdigit(c) || c == '_'; });
}

template <class Any>
class LawFamily : public testing::Test {};
using Families = testing::Types<AnyNormalForce, AnyDamping, AnyFriction, AnyWear>;
TYPED_TEST_SUITE(LawFamily, Families);

TYPED_TEST(LawFamily, NamesAreUniqueAndFormulasGiven) {
  std::set<std::string_view> names;
  for_each_alternative<TypeParam>([&]<class Law> {
    EXPECT_TRUE(is_snake_case(Law::kName)) << Law::kName;
    EXPECT_TRUE(names.insert(Law::kName).second) << Law::kName << " twice";
    EXPECT_FALSE(std::string_view{Law::kFormula}.empty()) << Law::kName;
    EXPECT_EQ(law_name(TypeParam{Law{}}), Law::kName);
  });
  EXPECT_EQ(names.size(), std::variant_size_v<TypeParam>);
}

TYPED_TEST(LawFamily, ParametersHaveTheirOwnKeySymbolAndMember) {
  for_each_alternative<TypeParam>([]<class Law> {
    std::set<std::string_view> keys;
    std::set<std::string_view> symbols;
    Law law;
    std::set<const double*> members;
    for (const Parameter<Law>& parameter : Law::kParameters) {
      EXPECT_TRUE(is_snake_case(parameter.key)) << Law::kName << "." << parameter.key;
      EXPECT_TRUE(keys.insert(parameter.key).second) << Law::kName << "." << parameter.key << " twice";
      EXPECT_TRUE(symbols.insert(parameter.symbol).second) << Law::kName << "." << parameter.key;
      ASSERT_NE(parameter.member, nullptr);
      EXPECT_TRUE(members.insert(&(law.*parameter.member)).second) << parameter.key << " shares another's member";
      EXPECT_FALSE(parameter.meaning.empty()) << Law::kName << "." << parameter.key;
      // An exponent may stand raised.
      const std::string_view written = parameter.symbol == "n" ? "ⁿ" : parameter.symbol;
      EXPECT_NE(std::string_view{Law::kFormula}.find(written), std::string_view::npos)
          << Law::kName << ": " << written << " is not in the formula " << Law::kFormula;
    }
    // Every member is in the table: a law holds nothing but its parameters (an empty law still has size 1), and a
    // damping form of choice.
    std::size_t size = std::is_empty_v<Law> ? 0 : sizeof(Law);
    if constexpr (NestsDamping<Law>) size -= sizeof(law.damping);
    EXPECT_EQ(Law::kParameters.size(), size / sizeof(double)) << Law::kName;
  });
}

TYPED_TEST(LawFamily, DefaultsAreInRangeOrMustBeGiven) {
  for_each_alternative<TypeParam>([]<class Law> {
    const Law law;
    for (const Parameter<Law>& parameter : Law::kParameters) {
      const double value = law.*parameter.member;
      EXPECT_TRUE(std::isnan(value) || parameter.range.contains(value)) << Law::kName << "." << parameter.key;
      EXPECT_LT(parameter.range.minimum, parameter.range.maximum) << Law::kName << "." << parameter.key;
      EXPECT_FALSE(parameter.range.contains(kRequired)) << "what must be given is not a value";
    }
  });
}

TEST(ParameterRange, OpenEndsDoNotBelong) {
  EXPECT_FALSE(kPositive.contains(0.0));
  EXPECT_TRUE(kPositive.contains(1e-300));
  EXPECT_FALSE(kPositive.contains(kUnbounded));
  EXPECT_TRUE(kNotNegative.contains(0.0));
  EXPECT_FALSE(kNotNegative.contains(-1e-300));
  constexpr ParameterRange kRestitution{0.0, 1.0, true, false};
  EXPECT_FALSE(kRestitution.contains(0.0));
  EXPECT_TRUE(kRestitution.contains(1.0));
  EXPECT_FALSE(kRestitution.contains(1.0 + 1e-15));
}

}  // namespace
}  // namespace gudgeon
