// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Mechanisms by chance, each beside the textbook form: accelerations, reactions and motion; its own joints stay closed,
// its energy adds up, or it stops and says why. What fails prints its model, to be run again.
//
// GUDGEON_RANDOM_SEEDS asks for that many seeds a family, GUDGEON_RANDOM_FIRST for another first one,
// GUDGEON_RANDOM_MODELS for a folder that all models are written to.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <thread>

#include "gudgeon/analysis/energy_audit.h"
#include "gudgeon/io/model_reader.h"
#include "gudgeon/io/resolved_model.h"
#include "gudgeon/sim/run_study.h"
#include "gudgeon/system/body_motion.h"
#include "tests/oracle/same_state.h"
#include "tests/oracle/textbook_start.h"
#include "tests/random/random_mechanism.h"
#include "tests/random/recorded_motion.h"
#include "tests/random/stage_sums.h"

namespace gudgeon::random {
namespace {

#ifdef GUDGEON_SANITIZE
constexpr int kSeedsAFamily = 4;
#else
constexpr int kSeedsAFamily = 40;
#endif
constexpr int kSeedsATest = 10;
/// [m, rad] Of the largest length, about 1 m.
constexpr double kLargestGap = 1e-9;
/// Relative, of samples between steps: their closures hold to the dense output's error, which tolerances of 1e-9 bound.
constexpr double kDynamicsTolerance = 1e-6;
constexpr double kMotionTolerance = 1e-7;  ///< [m, rad]
/// Steps over the bends and steps of curves, which the textbook's do not land on, are off by chance: their change as
/// they are halved says no more than what size that has.
constexpr double kErrorAtBends = 10.0;
/// A run that takes longer is taken for one that does not end: the longest takes a second or two.
constexpr std::chrono::seconds kLongestRun{120};

int read_number(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::atoi(text);
}

/// Runs the study, but not for ever.
std::vector<StageRecord> run_limited(const Mechanism& mechanism, const Study& study) {
  std::stop_source stop;
  std::jthread watch([&](const std::stop_token& done) {
    const auto end = std::chrono::steady_clock::now() + kLongestRun;
    while (!done.stop_requested() && std::chrono::steady_clock::now() < end) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    stop.request_stop();
  });
  RunHooks hooks;
  hooks.stop = stop.get_token();
  return run_study(mechanism, study, hooks);
}

/// The textbook's end of the motion; through a jump, with the loads before and after it.
TextbookEnd find_textbook_end(const RandomModel& model, const RecordedMotion& motion) {
  const double end = motion.time(motion.n_samples() - 1);
  if (model.jump_time == 0.0) return integrate(motion.textbook(), motion.state(0), 0.0, end);
  const TextbookEnd middle = integrate(oracle::Textbook(model.before), motion.state(0), 0.0, model.jump_time);
  TextbookEnd found = integrate(oracle::Textbook(model.after), middle.state, model.jump_time, end);
  found.error += middle.error;
  return found;
}

bool has_curves(const Mechanism& mechanism) {
  const auto is_curve = [](const Function& function) { return std::holds_alternative<SampledCurve>(function); };
  return std::ranges::any_of(mechanism.loads, [&](const Load& load) {
    if (const auto* torque = std::get_if<VariableTorque>(&load.kind)) return is_curve(torque->torque);
    const auto* force = std::get_if<VariableForce>(&load.kind);
    return force != nullptr && (is_curve(force->x) || is_curve(force->y));
  });
}

void expect_same_motion(const RandomModel& model, const StageRecord& stage) {
  const RecordedMotion motion(model.mechanism, stage);
  for (std::size_t k = 0; k < motion.n_samples(); k += 4) {
    SCOPED_TRACE(fmt::format("at t = {} s", motion.time(k)));
    EXPECT_LT(find_largest_gap(motion, k), kLargestGap);
    if (motion.time(k) != model.jump_time) expect_same_dynamics(motion, k, kDynamicsTolerance);
  }
  const std::size_t last = motion.n_samples() - 1;
  const TextbookEnd end = find_textbook_end(model, motion);
  // Where the textbook's own steps are too long, it says less, and nothing where it has lost the motion.
  if (!(end.error < 1e-3)) return;
  const double factor = has_curves(model.mechanism) ? kErrorAtBends : 2.0;
  EXPECT_LT(find_distance(motion.state(last), end.state), kMotionTolerance + factor * end.error);
}

/// With journals pressed into their bearings, bodies accelerate as the textbook has it.
void expect_same_pressed_start(const Mechanism& mechanism) {
  std::optional<oracle::TextbookState> pressed;
  try {
    pressed = oracle::make_pressed_state(mechanism);
  } catch (const std::runtime_error&) {
    return;  // a closed loop does not permit these eccentricities
  }
  oracle::EngineAt engine(mechanism, oracle::make_pressed_start(mechanism));
  engine.equations.eval(0.0, engine.y.data(), engine.slope.data());
  const std::vector<BodyMotion> motions = BodyMotionFinder(engine.system).update(engine.equations.workspace);
  const oracle::TextbookSolution solution = oracle::Textbook(mechanism).solve(*pressed, 0.0);
  double scale = 1.0;
  for (const auto& a : solution.accelerations) scale = std::max({scale, norm(a.center), std::abs(a.angle)});
  for (std::size_t b = 1; b < motions.size(); ++b) {
    const std::string& name = mechanism.bodies[b].name;
    EXPECT_LT(norm(motions[b].acceleration - solution.accelerations[b].center), 1e-7 * scale) << name;
    EXPECT_NEAR(motions[b].angle_acceleration, solution.accelerations[b].angle, 1e-7 * scale) << name;
  }
}

void expect_closed_joints(const Mechanism& mechanism, const StageRecord& stage) {
  const RecordedMotion motion(mechanism, stage);
  for (std::size_t k = 0; k < motion.n_samples(); ++k) {
    // Samples lie between steps, whose dense output the default tolerance bounds; the last one is a step's end.
    EXPECT_LT(find_largest_gap(motion, k), k + 1 < motion.n_samples() ? 1e-6 : kLargestGap);
  }
}

/// Whether the run went to its end.
bool check_run(const RandomModel& model) {
  const std::vector<StageRecord> stages = run_limited(model.mechanism, model.study);
  for (const StageRecord& stage : stages) {
    EXPECT_NE(stage.status, StageStatus::stopped) << "does not end; reached " << stage.end_time << " s";
    if (stage.status == StageStatus::failed) {
      EXPECT_NE(stage.message.find("E-NUM-"), std::string::npos) << stage.message;
      fmt::print("{} stops: {}\n", model.mechanism.name, stage.message);
      return false;
    }
    // Impacts of a tenth of a second exchange little: an energy balance that misses its bound is told, as a stop is.
    if (!stage.wear.empty() && is_unbalanced(stage)) {
      fmt::print("{}: {}\n", model.mechanism.name, explain_imbalance(stage));
      return false;
    }
    EXPECT_EQ(explain_imbalance(stage), "");
    if (stage.wear.empty()) {
      expect_same_motion(model, stage);
      if (!model.curves.empty()) expect_works_of_curves(model, stage);
    } else {
      expect_closed_joints(model.mechanism, stage);
      expect_volumes(model, stage);
    }
  }
  return true;
}

bool check_seed(Family family, std::uint64_t seed) {
  const RandomModel model = make_model(family, seed);
  const std::string text = write_resolved_model(model.mechanism, model.study);
  SCOPED_TRACE("seed " + std::to_string(seed) + ":\n" + text);
  if (const char* folder = std::getenv("GUDGEON_RANDOM_MODELS")) {
    std::ofstream(fmt::format("{}/{}.toml", folder, model.mechanism.name)) << text;
  }
  const ModelFile file = read_model_text(model.mechanism.name, text);
  EXPECT_FALSE(file.diagnostics.has_errors()) << render(file.diagnostics, file.source);
  try {
    if (family == Family::clearances) expect_same_pressed_start(model.mechanism);
    const bool finished = check_run(model);
    EXPECT_TRUE(model.can_move || family == Family::clearances) << "the textbook has no motion for the driver";
    return finished;
  } catch (const ModelError& error) {
    // A driver may hold on to what cannot move, or to an angle that is held already, and is told so.
    const std::string& code = error.diagnostics().items().front().code;
    EXPECT_TRUE(!model.can_move && (code == "E-MODEL-072" || code == "E-MODEL-061"))
        << render(error.diagnostics(), file.source);
  }
  return false;
}

struct Block {
  Family family = Family::trees;
  int first = 0;
  int n_seeds = 0;
};

class RandomMechanisms : public testing::TestWithParam<Block> {};

TEST_P(RandomMechanisms, MoveAsTheTextbookSays) {
  const Block block = GetParam();
  const int first = read_number("GUDGEON_RANDOM_FIRST", 1) + block.first;
  int n_finished = 0;
  for (int i = 0; i < block.n_seeds; ++i) {
    if (check_seed(block.family, static_cast<std::uint64_t>(first + i))) ++n_finished;
  }
  // Loops lock by chance; that most do would be a fault.
  EXPECT_GE(n_finished, block.n_seeds / 2);
}

std::vector<Block> list_blocks() {
  const int n_seeds = read_number("GUDGEON_RANDOM_SEEDS", kSeedsAFamily);
  std::vector<Block> blocks;
  for (const Family family : {Family::trees, Family::loops, Family::driven, Family::redundant, Family::loads,
                              Family::curves, Family::steps, Family::clearances}) {
    for (int first = 0; first < n_seeds; first += kSeedsATest) {
      blocks.push_back({family, first, std::min(kSeedsATest, n_seeds - first)});
    }
  }
  return blocks;
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomMechanisms, testing::ValuesIn(list_blocks()),
                         [](const testing::TestParamInfo<Block>& entry) {
                           return fmt::format("{}_{}", name_family(entry.param.family), entry.param.first);
                         });

}  // namespace
}  // namespace gudgeon::random
