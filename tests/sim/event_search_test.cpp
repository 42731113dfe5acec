// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The search for a step's length, against quantities with known roots.
#include "gudgeon/sim/event_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace gudgeon {
namespace {

using SearchOutcome = EventSearch::Outcome;
using Side = EventSearch::Side;
using Quantity = std::function<WatchedValue(double)>;

struct SearchResult {
  SearchOutcome outcome;
  double length;
  WatchedValue end;
  int n_tries;
};

// As a step would be tried: the quantity is known at no other place than the ends of the tries.
SearchResult search_for(Side side, double longest, double expected, double window, const Quantity& quantity) {
  EventSearch search(side, longest, expected, quantity(0.0), quantity(longest));
  int n_tries = 0;
  double last = 0.0;
  for (bool goes_on = true; goes_on; ++n_tries) {
    last = search.length();
    const WatchedValue end = quantity(last);
    goes_on = std::isfinite(end.value) ? search.note(end, window) : search.note_failure();
    EXPECT_TRUE(!goes_on || !search.is_current());
  }
  EXPECT_EQ(search.is_current(), last == search.length());
  return {search.outcome(), search.length(), quantity(search.length()), n_tries};
}

// Rises through zero at 0.3, ever faster.
WatchedValue rise(double h) { return {std::expm1(h - 0.3), std::exp(h - 0.3)}; }

TEST(EventSearch, EndsAHairOnTheSideThatWasAskedFor) {
  for (const double window : {1e-6, 1e-10, 1e-15}) {
    for (const double expected : {0.3, 0.2999, 0.05, 0.99}) {
      const SearchResult before = search_for(Side::before, 1.0, expected, window, rise);
      EXPECT_EQ(before.outcome, SearchOutcome::found);
      EXPECT_LE(before.end.value, 0.0);
      EXPECT_GE(before.end.value, -2.0 * window);
      const SearchResult past = search_for(Side::past, 1.0, expected, window, rise);
      EXPECT_EQ(past.outcome, SearchOutcome::found);
      EXPECT_GE(past.end.value, 0.0);
      EXPECT_LE(past.end.value, 2.0 * window);
      EXPECT_LE(past.n_tries, 8) << expected;
    }
  }
  EXPECT_EQ(search_for(Side::before, 1.0, 0.3 - 1e-7, 1e-9, rise).n_tries, 2);
}

// Below what rounding tells the bracket closes, and the end is on the right side all the same.
TEST(EventSearch, StaircaseEndsOnTheRightSide) {
  const auto stairs = [](double h) { return WatchedValue{1e-9 * std::floor((h - 0.3) * 1e9) + 0.5e-9, 1.0}; };
  const SearchResult before = search_for(Side::before, 1.0, 0.301, 1e-14, stairs);
  EXPECT_EQ(before.outcome, SearchOutcome::found);
  EXPECT_LE(before.end.value, 0.0);
  EXPECT_NEAR(before.length, 0.3, 1e-9);
  const SearchResult past = search_for(Side::past, 1.0, 0.301, 1e-14, stairs);
  EXPECT_EQ(past.outcome, SearchOutcome::found);
  EXPECT_GE(past.end.value, 0.0);
  EXPECT_NEAR(past.length, 0.3, 1e-9);
}

// A parabola whose top is this high above zero, or below it.
Quantity arch(double height) {
  return [height](double h) { return WatchedValue{height - (h - 0.5) * (h - 0.5), -2.0 * (h - 0.5)}; };
}

TEST(EventSearch, ArchIsMetWhereItRises) {
  for (const double height : {1e-2, 1e-6, 1e-10}) {
    for (const double expected : {0.5 - std::sqrt(height), 0.5, 0.5 + 1e-5}) {
      const SearchResult result = search_for(Side::before, 1.0, expected, 1e-15, arch(height));
      EXPECT_EQ(result.outcome, SearchOutcome::found) << height << ' ' << expected;
      EXPECT_LE(result.end.value, 0.0);
      EXPECT_GE(result.end.value, -3e-15);  // the parabola's own rounding is 1e-16
      EXPECT_NEAR(result.length, 0.5 - std::sqrt(height), 1e-9);
    }
  }
}

TEST(EventSearch, ArchThatStaysBelowIsNoChange) {
  for (const double depth : {1e-2, 1e-8, 1e-13}) {
    for (const double expected : {0.45, 0.5, 0.5 + 1e-7}) {
      const SearchResult result = search_for(Side::before, 1.0, expected, 1e-15, arch(-depth));
      EXPECT_EQ(result.outcome, SearchOutcome::none) << depth << ' ' << expected;
      EXPECT_LE(result.n_tries, 25);
    }
  }
}

// A contact that was met a hair before its surfaces touch: minus its penetration begins above zero and falls.
TEST(EventSearch, WhatBeginsAHairAboveHasToTurnFirst) {
  const double hair = 1e-10;
  // Touches, and parts at 0.8.
  const auto touch = [&](double h) { return WatchedValue{hair + h * (h - 0.8), 2.0 * h - 0.8}; };
  SearchResult result = search_for(Side::past, 1.0, 0.8, 1e-13, touch);
  EXPECT_EQ(result.outcome, SearchOutcome::found);
  EXPECT_NEAR(result.length, 0.8, 1e-9);
  EXPECT_GE(result.end.value, 0.0);
  // Turns back before it touches; nothing but its turning point says so.
  const auto miss = [&](double h) { return WatchedValue{hair + h * (h - 1e-5), 2.0 * h - 1e-5}; };
  for (const double expected : {0.0, 5e-6, 1e-3}) {
    result = search_for(Side::past, 1.0, expected, 1e-14, miss);
    EXPECT_EQ(result.outcome, SearchOutcome::found) << expected;
    EXPECT_GE(result.end.rate, 0.0);
    EXPECT_GT(result.end.value, 0.0);
    EXPECT_LE(result.end.value, 2.0 * hair);
  }
}

TEST(EventSearch, AboveFromTheFirstMomentOn) {
  // On the way up: the change is there from the start.
  const auto up = [](double h) { return WatchedValue{h == 0.0 ? -1e-18 : 1e-3 + h, 1.0}; };
  SearchResult result = search_for(Side::before, 1.0, 0.2, 1e-15, up);
  EXPECT_EQ(result.outcome, SearchOutcome::found);
  EXPECT_EQ(result.length, 0.0);
  // On the way down: the step is not to be trusted.
  const auto down = [](double h) { return WatchedValue{h == 0.0 ? -1e-3 : 1e-3, h == 0.0 ? -1.0 : 1.0}; };
  result = search_for(Side::before, 1.0, 0.2, 1e-15, down);
  EXPECT_EQ(result.outcome, SearchOutcome::impossible);
}

TEST(EventSearch, StepsThatFailAreShortened) {
  const auto broken = [](double h) {
    return h > 0.4 ? WatchedValue{std::numeric_limits<double>::quiet_NaN(), 0.0} : rise(h);
  };
  const SearchResult result = search_for(Side::before, 1.0, 0.9, 1e-12, broken);
  EXPECT_EQ(result.outcome, SearchOutcome::found);
  EXPECT_NEAR(result.length, 0.3, 1e-11);
}

}  // namespace
}  // namespace gudgeon
