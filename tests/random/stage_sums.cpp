// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// ∫ F dx, and ∫ |μ F v| dt.
#include "tests/random/stage_sums.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/oracle/textbook_curves.h"
#include "tests/random/recorded_motion.h"

namespace gudgeon::random {

namespace {

// Within a step wear is summed up by a rule of second order, whose weights are not negative.
constexpr double kWearTolerance = 1e-4;

double find_place(const RecordedMotion& motion, const CurveLoad& load, std::size_t sample) {
  const oracle::TextbookState state = motion.state(sample);
  const oracle::Textbook& textbook = motion.textbook();
  if (load.point.point.empty()) {
    return state.bodies[static_cast<std::size_t>(find_body(textbook.mechanism(), load.point.body))].angle;
  }
  const Vec2 position = textbook.eval_point(state, load.point).position;
  return load.curve.over.ends_with(".x") ? position.x : position.y;
}

// Of both surfaces together, each of which has the law.
struct WearLine {
  double volume_a_metre_and_newton = 0.0;  // or a joule
  bool by_friction = false;
  double friction_coefficient = 0.0;
};

WearLine find_wear_line(const ContactProperties& contact) {
  WearLine line;
  if (const auto* law = std::get_if<Archard>(&contact.bearing_wear)) line.volume_a_metre_and_newton = law->coefficient;
  if (const auto* law = std::get_if<EnergyWear>(&contact.bearing_wear)) {
    line.volume_a_metre_and_newton = law->coefficient;
    line.by_friction = true;
  }
  line.volume_a_metre_and_newton *= 2.0;
  if (const auto* law = std::get_if<CoulombSmooth>(&contact.friction)) {
    line.friction_coefficient = law->kinetic_coefficient;
  }
  return line;
}

}  // namespace

void expect_works_of_curves(const RandomModel& model, const StageRecord& stage) {
  constexpr double kTolerance = 1e-7;  // of the energy exchanged; the works' own is 1e-9
  const RecordedMotion motion(model.mechanism, stage);
  double work = 0.0;
  for (const CurveLoad& load : model.curves) {
    const double from = find_place(motion, load, 0);
    const double to = find_place(motion, load, motion.n_samples() - 1);
    work += oracle::TextbookCurve::of_load(load.curve).integrate(from, to);
  }
  EXPECT_NEAR(stage.energy.load_work, work, kTolerance * stage.energy.exchanged + 1e-12 * stage.energy.load_reach);
}

void expect_volumes(const RandomModel& model, const StageRecord& stage) {
  double by_friction = 0.0;  // [J] what the volumes tell of friction
  double at_most = 0.0;      // [J] what friction is at most at the volumes' way
  bool any_unworn = false;   // a joint whose friction no volume tells of
  for (const JointWear& wear : stage.wear) {
    EXPECT_NEAR(wear.removed_volume, wear.archard_volume, 1e-9 * std::abs(wear.archard_volume)) << wear.joint;
    const auto& joint = model.mechanism.joints[static_cast<std::size_t>(find_joint(model.mechanism, wear.joint))];
    const WearLine line = find_wear_line(*find_contact(joint.kind));
    if (line.volume_a_metre_and_newton == 0.0) {
      EXPECT_EQ(wear.archard_volume, 0.0) << wear.joint;
      any_unworn = true;
      continue;
    }
    const double sum = wear.archard_volume / (line.volume_a_metre_and_newton * model.study.wear_acceleration);
    (line.by_friction ? by_friction : at_most) += line.by_friction ? sum : sum * line.friction_coefficient;
  }
  if (any_unworn) return;
  const double friction = stage.energy.friction;
  if (by_friction > 0.0) {
    EXPECT_NEAR(by_friction, friction, kWearTolerance * friction);
  }
  if (at_most > 0.0) {
    EXPECT_GE(at_most, friction * (1.0 - kWearTolerance));
  }
}

}  // namespace gudgeon::random
