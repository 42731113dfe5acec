// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Arcs distributed over cells: against each cell's overlap counted out, and what all of them hold together.
#include "gudgeon/geometry/arc_accumulator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace gudgeon {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

struct Arc {
  double angle;
  double width;
  double amount;
};

// Overlap of each cell with the arc and its copies whole turns away, as a share of the cell.
void add_overlaps(const Arc& arc, std::vector<double>& amounts) {
  const double cell = kTurn / static_cast<double>(amounts.size());
  const double first = std::remainder(arc.angle, kTurn) - 0.5 * arc.width;
  for (std::size_t k = 0; k < amounts.size(); ++k) {
    for (const double shift : {-kTurn, 0.0, kTurn}) {
      const double from = std::max(static_cast<double>(k) * cell, first + shift);
      const double to = std::min(static_cast<double>(k + 1) * cell, first + arc.width + shift);
      if (to > from) amounts[k] += arc.amount * (to - from) / cell;
    }
  }
}

std::vector<Arc> make_random_arcs(std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> angle(-20.0, 20.0);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<Arc> arcs;
  for (std::size_t k = 0; k < n; ++k) {
    const double width = share(random) * (k % 2 == 0 ? 0.02 : kTurn);  // narrower than a cell, and up to all of it
    arcs.push_back({angle(random), width, share(random)});
  }
  arcs.push_back({0.0, 0.3, 1.0});      // over the seam
  arcs.push_back({kTurn, 0.3, 1.0});    // the same again
  arcs.push_back({-1e-20, 1e-4, 1.0});  // wraps to the very end
  arcs.push_back({1.1, kTurn, 1.0});    // all around
  return arcs;
}

TEST(ArcAccumulator, AgreesWithOverlapsCountedOut) {
  for (const std::size_t n : {10u, 100u, 1000u}) {
    ArcAccumulator accumulator(n);
    std::vector<double> expected(n, 0.0);
    for (const Arc& arc : make_random_arcs(60, 11)) {
      accumulator.add_arc(arc.angle, arc.width, arc.amount);
      add_overlaps(arc, expected);
    }
    const std::vector<double> amounts = accumulator.sum();
    ASSERT_EQ(amounts.size(), n);
    // Positions of some 1000 cells round to 1e-13 of a cell, 64 times.
    for (std::size_t k = 0; k < n; ++k) EXPECT_NEAR(amounts[k], expected[k], 1e-11) << k << " of " << n;
  }
}

TEST(ArcAccumulator, ConservesWhatIsLaidDown) {
  for (const std::size_t n : {100u, 1000u, 4000u}) {
    ArcAccumulator accumulator(n);
    double expected = 0.0;
    for (const Arc& arc : make_random_arcs(5000, 12)) {
      accumulator.add_arc(arc.angle, arc.width, arc.amount);
      expected += arc.amount * arc.width;
    }
    const std::vector<double> amounts = accumulator.sum();
    const double held = kTurn / static_cast<double>(n) * std::accumulate(amounts.begin(), amounts.end(), 0.0);
    EXPECT_NEAR(held, expected, 1e-12 * expected) << n;  // rounding of 5000 additions
  }
}

// An arc that moves and grows, at many instants of its movement.
struct Movement {
  double angle;
  double width;
  double turn;
  double end_width;
};

const std::vector<Movement> kMovements{{1.0, 0.3, 0.2, 0.3},    {1.0, 0.3, -2.0, 0.1}, {6.2, 0.02, 0.5, 0.4},
                                       {0.1, 0.3, -0.4, 0.0},   {3.0, 0.0, 0.0, 1.1},  {-20.0, 0.7, 0.001, 0.69},
                                       {2.0, 0.5, -1e-13, 0.5}, {5.0, 0.4, 3.1, 0.4}};

TEST(ArcAccumulator, AgreesWithMovementsCountedOut) {
  constexpr int kInstants = 20000;
  for (const std::size_t n : {10u, 100u, 1000u}) {
    for (const Movement& move : kMovements) {
      ArcAccumulator accumulator(n);
      accumulator.add_sweep(accumulator.find_sweep(move.angle, move.width, move.turn, move.end_width), 2.0);
      const std::vector<double> amounts = accumulator.sum();
      ArcAccumulator counted(n);
      for (int i = 0; i < kInstants; ++i) {
        const double part = (i + 0.5) / kInstants;
        counted.add_arc(move.angle + part * move.turn, move.width + part * (move.end_width - move.width),
                        2.0 / kInstants);
      }
      const std::vector<double> expected = counted.sum();
      for (std::size_t k = 0; k < n; ++k) {
        // An end is within a cell for an instant more or less; sums of as many parts.
        EXPECT_NEAR(amounts[k], expected[k], 2.0 * 1.5 / kInstants) << k << " of " << n << ", " << move.turn;
        EXPECT_GE(amounts[k], -1e-12);
      }
    }
  }
}

TEST(ArcAccumulator, ConservesWhatMovementsLayDown) {
  for (const std::size_t n : {100u, 1000u, 100000u}) {
    ArcAccumulator accumulator(n);
    double expected = 0.0;
    for (const Movement& move : kMovements) {
      for (int k = 0; k < 50; ++k) {
        accumulator.add_sweep(accumulator.find_sweep(move.angle + k, move.width, move.turn, move.end_width), 1.0 + k);
        expected += (1.0 + k) * 0.5 * (move.width + move.end_width);
      }
    }
    const std::vector<double> amounts = accumulator.sum();
    const double held = kTurn / static_cast<double>(n) * std::accumulate(amounts.begin(), amounts.end(), 0.0);
    EXPECT_NEAR(held, expected, 1e-10 * expected) << n;  // rounding of places among 100 000 cells
  }
}

// What lies behind a moving arc has been covered for as long as the arc takes to pass: evenly, whatever the steps.
TEST(ArcAccumulator, StepsOfAMovementJoinWithoutASeam) {
  for (const double step : {0.003, 0.03, 0.4}) {
    ArcAccumulator accumulator(1000);
    constexpr double kWidth = 0.05;
    for (double at = 1.0; at < 5.0; at += step) {
      accumulator.add_sweep(accumulator.find_sweep(at, kWidth, step, kWidth), step / kWidth);
    }
    const std::vector<double> amounts = accumulator.sum();
    const auto cell = [](double angle) { return static_cast<std::size_t>(angle * 1000.0 / kTurn); };
    for (std::size_t k = cell(1.04); k < cell(4.9); ++k) EXPECT_NEAR(amounts[k], 1.0, 1e-11) << step;
  }
}

TEST(ArcAccumulator, MovesParabolas) {
  constexpr int kInstants = 4000;
  for (const Movement& move : kMovements) {
    ArcAccumulator accumulator(50);
    ArcAccumulator counted(50);
    accumulator.add_parabola(move.angle, 0.3, 2.0, move.turn);
    for (int i = 0; i < kInstants; ++i) {
      counted.add_parabola(move.angle + (i + 0.5) / kInstants * move.turn, 0.3, 2.0 / kInstants);
    }
    const std::vector<double> amounts = accumulator.sum();
    const std::vector<double> expected = counted.sum();
    for (std::size_t k = 0; k < 50; ++k) EXPECT_NEAR(amounts[k], expected[k], 1e-5) << k << ", " << move.turn;
  }
}

// The parabola over fine points of each cell and its copies whole turns away.
void add_parabola_points(const Arc& arc, std::vector<double>& amounts) {
  constexpr int kPoints = 2000;
  const double cell = kTurn / static_cast<double>(amounts.size());
  for (std::size_t k = 0; k < amounts.size(); ++k) {
    for (int i = 0; i < kPoints; ++i) {
      const double at = (static_cast<double>(k) + (i + 0.5) / kPoints) * cell;
      for (const double shift : {-kTurn, 0.0, kTurn}) {
        const double x = (at + shift - std::remainder(arc.angle, kTurn)) / (0.5 * arc.width);
        if (std::abs(x) < 1.0) amounts[k] += arc.amount * 1.5 * (1.0 - x * x) / kPoints;
      }
    }
  }
}

TEST(ArcAccumulator, AgreesWithParabolasCountedOut) {
  for (const Arc& arc : {Arc{1.0, 0.9, 2.0}, Arc{0.0, 1.3, 1.0}, Arc{-20.0, kTurn, 0.7}, Arc{6.28, 0.011, 3.0}}) {
    ArcAccumulator accumulator(50);
    std::vector<double> expected(50, 0.0);
    accumulator.add_parabola(arc.angle, arc.width, arc.amount);
    add_parabola_points(arc, expected);
    const std::vector<double> amounts = accumulator.sum();
    // Points miss the ends of a narrow arc by up to one of 2000, where the parabola is small.
    for (std::size_t k = 0; k < 50; ++k) EXPECT_NEAR(amounts[k], expected[k], 1e-5) << k << " of " << arc.angle;
  }
}

TEST(ArcAccumulator, ConservesWhatParabolasLayDown) {
  for (const std::size_t n : {1u, 7u, 100u, 1000u, 4000u}) {
    ArcAccumulator accumulator(n);
    double expected = 0.0;
    for (const Arc& arc : make_random_arcs(2000, 13)) {
      accumulator.add_parabola(arc.angle, arc.width, arc.amount);
      expected += arc.amount * arc.width;
    }
    const std::vector<double> amounts = accumulator.sum();
    const double held = kTurn / static_cast<double>(n) * std::accumulate(amounts.begin(), amounts.end(), 0.0);
    EXPECT_NEAR(held, expected, 1e-12 * expected) << n;  // rounding of 2000 additions
    EXPECT_GE(std::ranges::min(amounts), 0.0);
  }
}

TEST(ArcAccumulator, ParabolaPeaksHalfAsHighAgain) {
  ArcAccumulator accumulator(4000);
  accumulator.add_parabola(2.0, 0.5, 3.0);
  const std::vector<double> amounts = accumulator.sum();
  // The mean over a cell at the peak is less than the peak by a third of (half a cell over half the arc)² or so.
  EXPECT_NEAR(std::ranges::max(amounts), 4.5, 4.5 * 2e-5);
  ArcAccumulator nothing(100);
  nothing.add_parabola(2.0, 0.0, 3.0);
  EXPECT_EQ(nothing.sum(), std::vector<double>(100, 0.0)) << "an arc without width";
}

TEST(ArcAccumulator, PlacesAnArcOfOneCellInThatCell) {
  constexpr std::size_t kCells = 100;
  constexpr double kCell = kTurn / kCells;
  for (const std::size_t cell : {0u, 1u, 57u, 99u}) {
    ArcAccumulator accumulator(kCells);
    accumulator.add_arc((static_cast<double>(cell) + 0.5) * kCell, kCell, 3.0);
    const std::vector<double> amounts = accumulator.sum();
    for (std::size_t k = 0; k < kCells; ++k) {
      EXPECT_NEAR(amounts[k], k == cell ? 3.0 : 0.0, 1e-12) << k;  // a position among 100 cells rounds to 1e-14
    }
  }
}

TEST(ArcAccumulator, SplitsAnArcOverItsCells) {
  constexpr double kCell = kTurn / 8.0;
  ArcAccumulator accumulator(8);
  accumulator.add_arc(0.0, kCell, 2.0);           // half a cell on each side of the seam
  accumulator.add_arc(3.25 * kCell, kCell, 4.0);  // from 2.75 to 3.75
  const std::vector<double> expected{1.0, 0.0, 1.0, 3.0, 0.0, 0.0, 0.0, 1.0};
  const std::vector<double> amounts = accumulator.sum();
  for (std::size_t k = 0; k < 8; ++k) EXPECT_NEAR(amounts[k], expected[k], 1e-14) << k;  // rounding
}

TEST(ArcAccumulator, FullCircleReachesEveryCellOnce) {
  for (const double angle : {0.0, 0.1, std::numbers::pi, -2.0, 6.28}) {
    ArcAccumulator accumulator(1000);
    accumulator.add_arc(angle, kTurn, 1.0);
    for (const double amount : accumulator.sum()) EXPECT_NEAR(amount, 1.0, 1e-12);  // where the ends meet they round
  }
}

TEST(ArcAccumulator, PutsAPointIntoItsCellOnly) {
  constexpr double kCell = kTurn / 10.0;
  const std::vector<std::pair<double, std::size_t>> cases{
      {0.0, 0}, {0.99 * kCell, 0}, {1.01 * kCell, 1}, {9.99 * kCell, 9}, {-0.01, 9}, {kTurn + 0.01, 0}, {-1e-20, 0}};
  for (const auto& [angle, cell] : cases) {
    ArcAccumulator accumulator(10);
    accumulator.add_point(angle, 2.5);
    const std::vector<double> amounts = accumulator.sum();
    for (std::size_t k = 0; k < 10; ++k) EXPECT_EQ(amounts[k], k == cell ? 2.5 : 0.0) << angle << ", cell " << k;
  }
}

TEST(ArcAccumulator, AddsPointsToArcs) {
  ArcAccumulator accumulator(4);
  accumulator.add_arc(1.0, kTurn, 1.0);
  accumulator.add_point(2.0, 5.0);
  const std::vector<double> amounts = accumulator.sum();
  EXPECT_NEAR(amounts[1], 6.0, 1e-15);
  EXPECT_NEAR(amounts[2], 1.0, 1e-15);
}

}  // namespace
}  // namespace gudgeon
