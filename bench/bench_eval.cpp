// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One right-hand side: the tables of absolute angles beside the textbook form, dense and sparse, and, for the nine-bar,
// beside one written by hand. Columns: nanoseconds of each, textbook over gudgeon, gudgeon over hand-written, with the
// quartiles over the rounds.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <optional>

#include "bench/hand_written/nine_bar.h"
#include "bench/paired_rounds.h"
#include "bench/spread_columns.h"
#include "bench/textbook/maximal_form.h"
#include "tests/oracle/mechanisms.h"
#include "tests/oracle/same_state.h"

namespace gudgeon::bench {
namespace {

constexpr double kTurnTime = 1e-4;  // [s] long against the clock's grain, short against what disturbs the machine
constexpr double kNanoseconds = 1e9;
constexpr Feedback kPaperFeedback{5.0, 5.0};

struct EvalCase {
  Mechanism mechanism;
  bool in_contact = false;
  bool by_hand = false;
  bool dense = true;  // the dense form is left out where it would take seconds
};

Contestant make_engine(const EvalCase& at, const oracle::SameState& state) {
  auto engine = std::make_shared<oracle::EngineAt>(at.mechanism, state);
  // A bristle half way to slipping, so that it moves.
  for (const Contact& contact : engine->system.tables.contacts) {
    if (contact.bristle >= 0) {
      engine->y[2 * engine->equations.n_free() + static_cast<std::size_t>(contact.bristle)] =
          0.5 * contact.bristle_scale;
    }
  }
  return make_contestant("gudgeon", [engine] {
    engine->equations.eval(0.0, engine->y.data(), engine->slope.data());
    benchmark::DoNotOptimize(engine->slope.data());
    benchmark::ClobberMemory();
  });
}

Contestant make_textbook(const EvalCase& at, const oracle::SameState& state, textbook::SaddleSolver::Kind kind) {
  auto form = std::make_shared<textbook::MaximalForm>(at.mechanism, kPaperFeedback, kind);
  form->contact_modes = state.contact_modes;
  auto y = std::make_shared<std::vector<double>>(form->make_state(state.assembly.poses));
  auto slope = std::make_shared<std::vector<double>>(form->size());
  return make_contestant(kind == textbook::SaddleSolver::Kind::dense ? "textbook" : "sparse", [=] {
    form->eval(0.0, y->data(), slope->data());
    benchmark::DoNotOptimize(slope->data());
    benchmark::ClobberMemory();
  });
}

Contestant make_hand_written(const EvalCase& at, const oracle::SameState& state) {
  using hand_written::NineBar;
  auto press = std::make_shared<NineBar>(NineBar{state.contact_modes[0], state.contact_modes[1]});
  auto y = std::make_shared<std::vector<double>>(2 * NineBar::kCoordinates);
  for (int i = 0; i < NineBar::kCoordinates; ++i) {
    const BodyPose& pose = state.assembly.poses[find_body(at.mechanism, NineBar::kBodies[i])];
    (*y)[i] = pose.angle;
    (*y)[NineBar::kCoordinates + i] = pose.angle_rate;
  }
  auto slope = std::make_shared<std::vector<double>>(y->size());
  return make_contestant("hand_written", [=] {
    press->eval(0.0, y->data(), slope->data());
    benchmark::DoNotOptimize(slope->data());
    benchmark::ClobberMemory();
  });
}

// The same columns for every case: a CSV needs them.
void put_columns(benchmark::State& bench, const PairedRounds& rounds) {
  for (const char* name : {"gudgeon", "textbook", "sparse", "hand_written"}) {
    const auto k = rounds.find(name);
    bench.counters[std::string(name) + "_ns"] = k ? kNanoseconds * rounds.find_time(*k).median : std::nan("");
  }
  const auto ratio = [&](std::optional<std::size_t> k, std::optional<std::size_t> base) -> std::optional<Spread> {
    if (!k || !base) return std::nullopt;
    return rounds.find_ratio(*k, *base);
  };
  put_spread(bench, "textbook/gudgeon", ratio(rounds.find("textbook"), 0));
  put_spread(bench, "sparse/gudgeon", ratio(rounds.find("sparse"), 0));
  put_spread(bench, "gudgeon/hand_written", ratio(0, rounds.find("hand_written")));
}

void eval(benchmark::State& bench, const EvalCase& at) {
  const oracle::SameState state =
      at.in_contact ? oracle::make_pressed_start(at.mechanism) : oracle::make_free_start(at.mechanism);
  std::vector<Contestant> contestants{make_engine(at, state)};
  if (at.dense) contestants.push_back(make_textbook(at, state, textbook::SaddleSolver::Kind::dense));
  contestants.push_back(make_textbook(at, state, textbook::SaddleSolver::Kind::sparse));
  if (at.by_hand) contestants.push_back(make_hand_written(at, state));
  PairedRounds rounds(std::move(contestants), kTurnTime);
  for (auto _ : bench) bench.SetIterationTime(rounds.run());
  put_columns(bench, rounds);
}

Mechanism make_bristle_nine_bar() {
  Mechanism mechanism = oracle::make_nine_bar();
  for (Joint& joint : mechanism.joints) {
    auto* clearance = std::get_if<RevoluteClearance>(&joint.kind);
    if (clearance != nullptr) clearance->contact.friction = Lugre{0.15, 0.10, 1e-3, 2.0, 1e5, 400.0, 0.0};
  }
  return mechanism;
}

void add(const std::string& name, const EvalCase& at) {
  benchmark::RegisterBenchmark(name.c_str(), [at](benchmark::State& bench) { eval(bench, at); })->UseManualTime();
}

void add_all() {
  add("pendulum_chain_5", {oracle::make_pendulum_chain(5)});
  add("pendulum_chain_20", {oracle::make_pendulum_chain(20)});
  add("slider_crank", {oracle::make_slider_crank()});
  add("four_bar", {oracle::make_four_bar()});
  add("nine_bar_open", {oracle::make_nine_bar(), false, true});
  add("nine_bar_contact", {oracle::make_nine_bar(), true, true});
  add("nine_bar_bristles", {make_bristle_nine_bar(), true});
  for (const int n : {1, 2, 5, 10, 20, 40, 100, 200, 400, 1000}) {
    add("n_four_bar_" + std::to_string(n), {oracle::make_n_four_bar(n), false, false, n <= 40});
  }
}

}  // namespace
}  // namespace gudgeon::bench

int main(int argc, char** argv) {
  gudgeon::bench::add_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
}
