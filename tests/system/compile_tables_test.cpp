// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What a mechanism compiles to: counts, numbering, constants that can be told by hand, couplings with drivers.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "gudgeon/system/tables.h"
#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

Tables compile_all(const Mechanism& mechanism) { return compile_tables(mechanism, find_topology(mechanism)); }

TEST(CompileTables, NineBarHasFiveAnglesAndOneRow) {
  const Tables tables = compile_all(oracle::make_nine_bar());
  EXPECT_EQ(tables.n_rows, 1);
  EXPECT_EQ(tables.n_solve, 6);
  EXPECT_EQ(tables.n_indices, 6 + 2 + 1);
  EXPECT_EQ(tables.elimination.size(), 6);
  EXPECT_EQ(tables.contacts.size(), 2u);
  EXPECT_EQ(tables.couplings.size(), 0u) << "a driven crank meets the rest only in its clearance";
  EXPECT_TRUE(tables.slide_pairs.empty());
}

TEST(CompileTables, IdealNineBarCouplesItsDrivers) {
  const Tables tables = compile_all(make_ideal(oracle::make_nine_bar()));
  EXPECT_EQ(tables.n_rows, 5);
  EXPECT_EQ(tables.n_solve, 10);
  EXPECT_TRUE(tables.contacts.empty());
  // Each crank with its rod's angle and with the two rows that close at D.
  EXPECT_EQ(tables.couplings.size(), 6u);
  for (const Coupling& coupling : tables.couplings) {
    EXPECT_GE(coupling.driven, tables.n_solve);
    EXPECT_LT(coupling.other, tables.n_solve);
    EXPECT_GE(coupling.slot, tables.elimination.n_values());
    EXPECT_LT(coupling.slot, tables.n_slots - 1);
  }
}

TEST(CompileTables, NumbersEquationsWithoutGaps) {
  for (const Mechanism& mechanism : oracle::make_all_mechanisms()) {
    const Tables tables = compile_all(mechanism);
    std::multiset<int> indices;
    for (int turn = 0; turn < tables.counts.n_turns(); ++turn) indices.insert(tables.find_turn_index(turn));
    for (int slide = 0; slide < tables.counts.n_slides(); ++slide) indices.insert(tables.find_slide_index(slide));
    for (const ClosureRows& rows : tables.closures) {
      for (int k = 0; k < count_rows(rows.kind); ++k) indices.insert(rows.row[k]);
    }
    // The frame and the unit slide share the bin; everything else stands alone.
    EXPECT_EQ(indices.count(tables.bin_index()), 2u) << mechanism.name;
    for (int k = 0; k < tables.bin_index(); ++k) EXPECT_EQ(indices.count(k), 1u) << mechanism.name << " " << k;
  }
}

TEST(CompileTables, DiagonalOfAPendulumIsItsInertiaAboutThePivot) {
  const Mechanism mechanism = oracle::make_pendulum_chain(1);
  const Tables tables = compile_all(mechanism);
  const Body& bar = mechanism.bodies[1];
  EXPECT_DOUBLE_EQ(tables.constant_values[tables.elimination.find_slot(0, 0)],
                   bar.inertia + bar.mass * dot(bar.center_of_mass, bar.center_of_mass));
}

TEST(CompileTables, PairsOfAngleAreThoseOfAncestors) {
  EXPECT_EQ(compile_all(oracle::make_pendulum_chain(5)).turn_pairs.size(), 10u);
  // Two cranks, each with its own rod and no other.
  const Tables tables = compile_all(oracle::make_five_bar());
  EXPECT_EQ(tables.turn_pairs.size(), 2u);
}

TEST(CompileTables, LeavesOutRowsThatAreNotActive) {
  const Mechanism mechanism = oracle::make_parallelogram();
  const Topology topology = find_topology(mechanism);
  const ActiveRows active{{true, true}, {true, false}};
  const Tables tables = compile_tables(mechanism, topology, &active);
  EXPECT_EQ(tables.n_rows, 3);
  EXPECT_EQ(tables.n_solve, 7);
  EXPECT_EQ(tables.closures[1].row[1], tables.bin_index());
  EXPECT_EQ(tables.closures[1].row[0], 6);
}

TEST(CompileTables, ContactsTakeRadiiAndLawsFromTheJoint) {
  const Mechanism mechanism = oracle::make_nine_bar();
  const Tables tables = compile_all(mechanism);
  for (const Contact& contact : tables.contacts) {
    const auto& surfaces = std::get<RevoluteSurfaces>(contact.surfaces);
    EXPECT_DOUBLE_EQ(surfaces.bearing_radius, 15e-3);
    EXPECT_DOUBLE_EQ(surfaces.journal_radius, 14.5e-3);
    EXPECT_DOUBLE_EQ(contact.width, 20e-3);
    EXPECT_FALSE(surfaces.is_worn());
    // 4/(3 · 2 · 0.91/200e9)
    EXPECT_NEAR(contact.stiffness_factor, 4.0 / (6.0 * 0.91 / 200e9), 1e-4);
    EXPECT_NE(contact.bearing_row, contact.journal_row);
    EXPECT_GE(contact.bearing_turn, tables.counts.n_free_turns) << "the bearing is on the driven crank";
    EXPECT_LT(contact.journal_turn, tables.counts.n_free_turns);
    EXPECT_EQ(contact.journal_index, tables.find_turn_index(contact.journal_turn));
    EXPECT_EQ(contact.bearing_index, tables.find_turn_index(contact.bearing_turn));
  }
  EXPECT_EQ(mechanism.joints[tables.contacts[0].joint].name, "A");
  EXPECT_EQ(mechanism.joints[tables.contacts[1].joint].name, "B");
}

}  // namespace
}  // namespace gudgeon
