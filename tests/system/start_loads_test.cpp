// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Loads without a finite value at the start are all named; those that lose it later are not.
#include "gudgeon/system/start_loads.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

using testing::HasSubstr;

std::vector<Diagnostic> find_lost(const std::vector<Load>& loads) {
  Mechanism mechanism = oracle::make_four_bar();
  mechanism.loads.insert(mechanism.loads.end(), loads.begin(), loads.end());
  Diagnostics found;
  check_start_loads(mechanism, assemble(mechanism), found);
  return {found.items().begin(), found.items().end()};
}

VariableTorque torque_of(const std::string& text) { return {"crank", kFrameName, Expression{text, {}}}; }

TEST(StartLoads, EveryFormulaWithoutAValueIsNamed) {
  const VariableForce force{{"crank", "b"}, Expression{"2*t", {}}, Expression{"log(t - 1)", {}}, "rocker"};
  const auto found = find_lost({{"pole", torque_of("1/t")}, {"good", torque_of("1 + t")}, {"root", force}});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].code, "E-MODEL-089");
  EXPECT_EQ(found[0].path, "loads.root.force.1") << "not x, although the axes turn both into NaN";
  EXPECT_THAT(found[0].message, HasSubstr("y of force \"log(t - 1)\" has no finite value at the start"));
  EXPECT_EQ(found[1].path, "loads.pole.torque");
}

TEST(StartLoads, TheAssembledStartCounts) {
  const Mechanism mechanism = oracle::make_four_bar();
  const std::string angle = std::to_string(assemble(mechanism).poses[2].angle);
  EXPECT_EQ(find_lost({{"x", torque_of("sqrt(coupler.angle - (" + angle + ") - 0.01)")}}).size(), 1U);
  EXPECT_TRUE(find_lost({{"x", torque_of("sqrt(coupler.angle - (" + angle + ") + 0.01)")}}).empty());
  EXPECT_TRUE(find_lost({{"later", torque_of("1/(t - 0.5)")}}).empty());
}

}  // namespace
}  // namespace gudgeon
