// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Cases on threads of their own, told one by one what to do.
#include "gudgeon/sim/case_turns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <memory>
#include <semaphore>
#include <thread>
#include <vector>

namespace gudgeon {
namespace {

// Does what it is told, and has a turn or not.
class ScriptedCase {
 public:
  ScriptedCase(CaseTurns& turns, int index) : turns_(turns), index_(index), thread_([this] { work(); }) {}
  ~ScriptedCase() {
    tell([] { return false; });
  }

  void begin() {
    tell([this] {
      turns_.wait(index_);
      has_turn_ = true;
      return true;
    });
  }
  // From a case that is to go on: returns when it does.
  void pass_and_go_on(double progress) {
    pass(progress);
    free_.acquire();
    free_.release();
  }
  void pass(double progress) {
    tell([this, progress] {
      has_turn_ = false;
      turns_.pass(index_, progress);
      has_turn_ = true;
      return true;
    });
  }
  void end() {
    tell([this] {
      has_turn_ = false;
      turns_.end(index_);
      return true;
    });
  }
  [[nodiscard]] bool has_turn() const { return has_turn_; }

 private:
  void tell(std::function<bool()> what) {
    free_.acquire();
    what_ = std::move(what);
    told_.release();
  }
  void work() {
    for (bool goes_on = true; goes_on;) {
      told_.acquire();
      goes_on = what_();
      free_.release();
    }
  }

  CaseTurns& turns_;
  int index_;
  std::atomic<bool> has_turn_ = false;
  std::function<bool()> what_;
  std::binary_semaphore free_{1};
  std::binary_semaphore told_{0};
  std::jthread thread_;
};

struct Script {
  Script(int n_cases, int n_turns) : turns(n_cases, n_turns) {
    for (int k = 0; k < n_cases; ++k) cases.push_back(std::make_unique<ScriptedCase>(turns, k));
  }
  // Waits until exactly these have turns.
  void expect(const std::vector<int>& running) {
    const auto are_there = [&] {
      for (int k = 0; k < static_cast<int>(cases.size()); ++k) {
        if (cases[k]->has_turn() != (std::ranges::count(running, k) > 0)) return false;
      }
      return true;
    };
    wait_until(are_there);
  }
  void expect_waiting(int n) {
    wait_until([&] { return turns.count_waiting() == n; });
  }
  // Who waits for what does not come has failed; as its cases wait, too, there is no way on.
  template <class Condition>
  void wait_until(Condition&& condition) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!condition()) {
      if (std::chrono::steady_clock::now() > deadline) {
        std::cerr << "the turns are not where they are expected\n";
        std::abort();
      }
      std::this_thread::yield();
    }
  }

  CaseTurns turns;
  std::vector<std::unique_ptr<ScriptedCase>> cases;
};

TEST(CaseTurns, TakesCasesInTheirOrderHoweverTheyCome) {
  Script script(4, 1);
  script.cases[0]->begin();
  script.expect({0});
  for (const int k : {3, 2, 1}) script.cases[k]->begin();
  script.expect_waiting(3);
  for (const int k : {0, 1, 2}) {
    script.cases[k]->end();
    script.expect({k + 1});
  }
  script.cases[3]->end();
  script.expect({});
}

TEST(CaseTurns, GoesOnToTheEndWhileMoreThanTwoATurnAreLeft) {
  Script script(4, 2);
  for (const int k : {0, 1}) script.cases[k]->begin();
  script.expect({0, 1});
  script.cases[2]->begin();
  script.expect_waiting(1);
  script.cases[0]->pass_and_go_on(0.99);
  script.expect({0, 1});
  EXPECT_EQ(script.turns.count_waiting(), 1);
  script.cases[0]->end();
  script.expect({1, 2});
  for (const int k : {1, 2}) script.cases[k]->end();
}

// Three equal cases on two turns: the third begins when the others are half done, and all end together.
TEST(CaseTurns, LetsTheLastOnesEndTogether) {
  Script script(3, 2);
  for (const int k : {0, 1}) script.cases[k]->begin();
  script.expect({0, 1});
  script.cases[2]->begin();
  script.expect_waiting(1);
  for (const double progress : {0.2, 0.45}) {
    for (const int k : {0, 1}) script.cases[k]->pass_and_go_on(progress);
  }
  script.cases[1]->pass_and_go_on(0.55);
  script.cases[0]->pass(0.55);  // what is left of the third is now more than half of all that is left
  script.expect({1, 2});
  script.cases[2]->pass_and_go_on(0.3);  // the first is ahead of it
  script.cases[1]->pass_and_go_on(0.9);
  script.cases[1]->end();
  script.expect({0, 2});
  for (const int k : {0, 2}) script.cases[k]->end();
}

// Two of four are nearly done: they are not held back, for the other two can begin then.
TEST(CaseTurns, DoesNotHoldBackWhoIsNearlyDone) {
  Script script(4, 2);
  for (const int k : {0, 1}) script.cases[k]->begin();
  script.expect({0, 1});
  for (const int k : {2, 3}) script.cases[k]->begin();
  script.expect_waiting(2);
  script.cases[1]->pass_and_go_on(0.99);
  script.cases[0]->end();
  script.expect({1, 2});
  script.cases[1]->pass_and_go_on(0.995);
  script.cases[1]->end();
  script.expect({2, 3});
  for (const int k : {2, 3}) script.cases[k]->end();
}

TEST(CaseTurns, NeverMoreRunThanThereAreTurns) {
  for (const int n_cases : {1, 2, 3, 5, 12}) {
    for (const int n_turns : {1, 2, 3}) {
      CaseTurns turns(n_cases, n_turns);
      std::atomic<int> next = 0;
      std::atomic<int> n_running = 0;
      std::atomic<int> most_running = 0;
      std::atomic<int> n_ended = 0;
      const auto note = [&] {
        const int now = ++n_running;
        for (int most = most_running; now > most && !most_running.compare_exchange_weak(most, now);) {
        }
      };
      {
        std::vector<std::jthread> threads;
        for (int t = 0; t < std::min(2 * n_turns - 1, n_cases); ++t) {
          threads.emplace_back([&] {
            for (int k = next++; k < n_cases; k = next++) {
              turns.wait(k);
              note();
              for (int piece = 1; piece < 40; ++piece) {
                --n_running;
                turns.pass(k, piece / 40.0);
                note();
              }
              --n_running;
              ++n_ended;
              turns.end(k);
            }
          });
        }
      }
      EXPECT_EQ(n_ended, n_cases);
      EXPECT_LE(most_running, n_turns) << n_cases;
    }
  }
}

}  // namespace
}  // namespace gudgeon
