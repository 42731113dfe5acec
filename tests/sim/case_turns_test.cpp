// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Cases that only count, on threads of their own.
#include "gudgeon/sim/case_turns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <thread>
#include <vector>

namespace gudgeon {
namespace {

constexpr int kPieces = 40;

// How far every case was, whenever one of them went on.
struct Watched {
  std::vector<int> pieces;
  std::vector<int> begun;  // cases in the order in which they began
  int n_running = 0;
  int most_running = 0;
  int widest_gap = 0;  // between cases that have begun, once all take turns
};

Watched run_cases(int n_cases, int n_turns) {
  CaseTurns turns(n_cases, n_turns);
  Watched watched;
  watched.pieces.assign(n_cases, 0);
  std::mutex mutex;
  int next = 0;
  int n_ended = 0;
  const auto work = [&] {
    while (true) {
      int index = 0;
      {
        const std::lock_guard lock(mutex);
        if (next == n_cases) return;
        index = next++;
      }
      turns.wait(index);
      {
        const std::lock_guard lock(mutex);
        watched.begun.push_back(index);
      }
      for (int piece = 1; piece <= kPieces; ++piece) {
        {
          const std::lock_guard lock(mutex);
          watched.most_running = std::max(watched.most_running, ++watched.n_running);
        }
        std::this_thread::yield();
        {
          const std::lock_guard lock(mutex);
          watched.pieces[index] = piece;
          if (n_cases - n_ended < 2 * n_turns && n_cases == n_turns + 1) {
            const auto [least, most] = std::ranges::minmax(watched.pieces);
            if (least < kPieces) watched.widest_gap = std::max(watched.widest_gap, most - least);
          }
          --watched.n_running;
        }
        turns.pass(index, static_cast<double>(piece) / kPieces);
      }
      {
        const std::lock_guard lock(mutex);
        ++n_ended;
      }
      turns.end();
    }
  };
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < std::min(2 * n_turns - 1, n_cases); ++i) threads.emplace_back(work);
  }
  return watched;
}

TEST(CaseTurns, AllEndAndNeverMoreRunThanThereAreTurns) {
  for (const int n_cases : {1, 2, 3, 5, 7, 12}) {
    for (const int n_turns : {1, 2, 3}) {
      const Watched watched = run_cases(n_cases, n_turns);
      EXPECT_LE(watched.most_running, n_turns) << n_cases;
      EXPECT_EQ(watched.pieces, std::vector<int>(n_cases, kPieces));
    }
  }
}

TEST(CaseTurns, OneTurnTakesCasesInTheirOrder) { EXPECT_EQ(run_cases(5, 1).begun, (std::vector{0, 1, 2, 3, 4})); }

// Three cases on two turns: nobody gets further ahead than the piece under way and the one that may follow before the
// case behind has noticed that it may go on.
TEST(CaseTurns, TheLastOnesStayLevel) { EXPECT_LE(run_cases(3, 2).widest_gap, 3); }

}  // namespace
}  // namespace gudgeon
