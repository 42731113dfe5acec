// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rows that are redundant everywhere, and rows that only seem to be where the start is singular.
#include "gudgeon/system/redundancy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gudgeon/system/system.h"
#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

using testing::ElementsAre;
using Active = std::array<bool, 2>;

Redundancy find(const Mechanism& mechanism) {
  const Assembly assembly = assemble(mechanism);
  System system{mechanism, find_topology(mechanism), {}};
  system.tables = compile_tables(mechanism, system.topology);
  return find_redundancy(system.tables, 0.0, make_state(system, assembly).q);
}

Mechanism make_flat_n_four_bar(int n) {
  Mechanism mechanism = oracle::make_n_four_bar(n);
  for (Body& body : mechanism.bodies) {
    if (body.name.starts_with("post")) body.start = oracle::start_at(0.0);
  }
  return mechanism;
}

TEST(Redundancy, ThirdCrankOfAParallelogramSaysNothingNewAcross) {
  const Redundancy redundancy = find(oracle::make_parallelogram());
  EXPECT_EQ(redundancy.n_redundant_rows, 1);
  EXPECT_FALSE(redundancy.singular);
  EXPECT_THAT(redundancy.active, ElementsAre(Active{true, true}, Active{true, false}));
}

TEST(Redundancy, RedundantAndSingularAreToldApart) {
  // Laid flat, the parallelogram loses the x rows of both loops, but of its four rows one is redundant all the same.
  Mechanism mechanism = oracle::make_parallelogram();
  for (Body& body : mechanism.bodies) {
    if (body.name.starts_with("crank")) body.start = oracle::start_at(0.0);
  }
  const Redundancy redundancy = find(mechanism);
  EXPECT_TRUE(redundancy.singular);
  EXPECT_EQ(redundancy.n_redundant_rows, 1);
}

TEST(Redundancy, ThereIsNoneElsewhere) {
  for (const Mechanism& mechanism : oracle::make_all_mechanisms()) {
    if (mechanism.name == "parallelogram") continue;
    const Redundancy redundancy = find(mechanism);
    EXPECT_EQ(redundancy.n_redundant_rows, 0) << mechanism.name;
    EXPECT_FALSE(redundancy.singular) << mechanism.name;
    for (std::size_t c = 0; c < redundancy.active.size(); ++c) EXPECT_TRUE(redundancy.active[c][0]) << mechanism.name;
  }
}

TEST(Redundancy, FourBarsInOneLineAreSingularNotRedundant) {
  for (const int n : {1, 2, 3, 8}) {
    const Redundancy redundancy = find(make_flat_n_four_bar(n));
    EXPECT_TRUE(redundancy.singular) << n;
    EXPECT_EQ(redundancy.n_redundant_rows, 0) << n;
    for (const Active& active : redundancy.active) EXPECT_THAT(active, ElementsAre(true, true));
  }
}

TEST(Redundancy, DrivenParallelogramStaysRedundantAnywhere) {
  for (const double start : {0.4, 1.2, 2.5}) {
    Mechanism mechanism = oracle::make_parallelogram();
    for (Body& body : mechanism.bodies) {
      if (body.name.starts_with("crank")) body.start = oracle::start_at(start);
    }
    mechanism.drivers.push_back({"motor", DrivenAngle{"crank_0"}, start, 3.0});
    const Redundancy redundancy = find(mechanism);
    EXPECT_EQ(redundancy.n_redundant_rows, 1) << start;
    EXPECT_FALSE(redundancy.singular) << start;
  }
}

}  // namespace
}  // namespace gudgeon
