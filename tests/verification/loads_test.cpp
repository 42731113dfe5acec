// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Springs, bushings and loads by formula: closed forms, an independent integration of the textbook form, and ledgers.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <complex>

#include "gudgeon/analysis/energy_audit.h"
#include "gudgeon/sim/run_study.h"
#include "gudgeon/system/assembly.h"
#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"
#include "tests/oracle/textbook.h"
#include "tests/verification/book/recorder.h"
#include "tests/verification/momenta.h"

namespace gudgeon {
namespace {

const std::string kChapter = "Loads and drivers";
const std::string kTight = "the run's tolerance is 1e-11, over some ten periods";
constexpr double kClose = 1e-9;

StageRecord run_for(const Mechanism& mechanism, double duration, int outputs, double tolerance) {
  Study study;
  study.cycle_time = duration;
  study.cycles = 1;
  study.outputs_per_cycle = outputs;
  study.relative_tolerance = tolerance;
  study.absolute_tolerance = 1e-2 * tolerance;
  study.compare_ideal = false;
  const auto stages = run_study(mechanism, study);
  EXPECT_EQ(stages.back().status, StageStatus::finished) << mechanism.name << ": " << stages.back().message;
  return stages.back();
}

// The largest difference of a channel from a function of the time.
template <class Expected>
double find_error(const StageRecord& stage, const std::string& channel, Expected&& expected) {
  const std::vector<double>& values = *find_values(stage, channel);
  double error = 0.0;
  for (std::size_t k = 0; k < values.size(); ++k)
    error = std::max(error, std::abs(values[k] - expected(stage.time[k])));
  return error;
}

// A mode of λ² + 2 δ λ + ω² = 0 from a start value and rate.
struct DampedMode {
  double square;  // ω² [1/s²]
  double decay;   // δ [1/s]
  double value;
  double rate;

  [[nodiscard]] double eval(double t) const {
    const double w = std::sqrt(square - decay * decay);
    return std::exp(-decay * t) * (value * std::cos(w * t) + (rate + decay * value) / w * std::sin(w * t));
  }
};

TEST(Loads, MassOnASpringAndDamper) {
  book::Recorder recorder({kChapter, "Mass, spring and damper", "closed form e^(−δt)(a cos ωt + b sin ωt)",
                           "A block on an oblique guide between a spring and a damper: frequency, decay and phase.",
                           kTight});
  Mechanism mechanism = oracle::make_empty("oscillator", {}, {{"wall", {0.1, -0.2}}});
  mechanism.bodies.push_back({"block", 2.3, 0.01, {0.02, 0.03}, {{"eye", {0.0, 0.0}}}, {}});
  Prismatic guide = oracle::make_slide({kFrameName, "wall"}, {"block", "eye"}, 0.4, 0.0, 0.45);
  guide.start.speed = 0.6;
  mechanism.joints.push_back({"guide", guide});
  mechanism.loads.push_back({"spring", Spring{{kFrameName, "wall"}, {"block", "eye"}, 180.0, 3.2, 0.3}});
  const StageRecord stage = run_for(mechanism, 7.0, 350, 1e-11);
  const DampedMode mode{180.0 / 2.3, 0.5 * 3.2 / 2.3, 0.15, 0.6};
  const double error = find_error(stage, "spring.length", [&](double t) { return 0.3 + mode.eval(t); });
  recorder.verify("largest error of the length over 7 s [m]", 0.0, error, kClose);
  recorder.verify("length at 7 s [m]", 0.3 + mode.eval(7.0), find_values(stage, "spring.length")->back(), kClose);
  const EnergyBalance& balance = stage.energy;
  recorder.verify("energy lost in the damper [J]", balance.initial_energy - balance.kinetic - balance.potential,
                  balance.damper_loss, kClose);
}

TEST(Loads, TorsionalPendulum) {
  book::Recorder recorder({kChapter, "Torsional pendulum", "closed form e^(−δt)(a cos ωt + b sin ωt)",
                           "Two discs on one axis with a torsion spring between them: they swing against each other.",
                           kTight});
  Mechanism mechanism = oracle::make_empty("torsion", {}, {{"axis", {0.3, 0.1}}});
  for (const auto& [name, inertia, angle, rate] : {std::tuple{"left", 0.02, 0.2, 1.5}, {"right", 0.05, 1.1, -0.4}}) {
    mechanism.bodies.push_back({name, 1.0, inertia, {}, {{"hub", {0.0, 0.0}}}, oracle::start_turning(angle, rate)});
    oracle::add_revolute(mechanism, name, {kFrameName, "axis"}, {name, "hub"});
  }
  mechanism.loads.push_back({"shaft", TorsionSpring{"left", "right", 6.5, 0.004, 0.35}});
  const StageRecord stage = run_for(mechanism, 3.0, 300, 1e-11);
  const double reduced = 0.02 * 0.05 / 0.07;
  const DampedMode mode{6.5 / reduced, 0.5 * 0.004 / reduced, 0.9 - 0.35, -1.9};
  recorder.verify("largest error of the twist over 3 s [rad]", 0.0,
                  find_error(stage, "shaft.twist", [&](double t) { return 0.35 + mode.eval(t); }), kClose);
  const double mean = (0.02 * 0.2 + 0.05 * 1.1) / 0.07;
  const double drift = (0.02 * 1.5 - 0.05 * 0.4) / 0.07;
  const auto left = [&](double t) { return mean + drift * t - 0.05 / 0.07 * (0.35 + mode.eval(t)); };
  recorder.verify("largest error of the left disc's angle [rad]", 0.0, find_error(stage, "left.angle", left), kClose);
}

TEST(Loads, ModesOfABushing) {
  book::Recorder recorder({kChapter, "Body in a bushing", "closed forms of the three modes",
                           "A body loose from everything but a bushing at its centre of mass, held to an oblique "
                           "bracket: along x and y of the bracket and around it swing on their own.",
                           kTight});
  Mechanism mechanism = oracle::make_empty("bushing", {}, {{"foot", {0.1, 0.2}}});
  mechanism.bodies.push_back({"bracket", 1.0, 0.1, {}, {{"foot", {0.0, 0.0}}, {"seat", {0.3, 0.1}}}, {}});
  mechanism.joints.push_back({"weld", Rigid{{kFrameName, "foot"}, {"bracket", "foot"}, 0.7}});
  const Rotation axes = make_rotation(0.7);
  BodyStart start = oracle::start_turning(0.9, 2.0);
  const Vec2 seat = Vec2{0.1, 0.2} + axes * Vec2{0.3, 0.1};
  start.position = seat + axes * Vec2{0.04, -0.03};
  start.velocity = axes * Vec2{-0.2, 0.5};
  mechanism.bodies.push_back({"pod", 1.7, 0.02, {}, {{"eye", {0.0, 0.0}}}, start});
  mechanism.loads.push_back(
      {"mount", Bushing{{"bracket", "seat"}, {"pod", "eye"}, {400.0, 90.0}, {1.1, 0.7}, 3.0, 0.01, 0.05}});
  const StageRecord stage = run_for(mechanism, 4.0, 400, 1e-11);
  const DampedMode along{400.0 / 1.7, 0.5 * 1.1 / 1.7, 0.04, -0.2};
  const DampedMode across{90.0 / 1.7, 0.5 * 0.7 / 1.7, -0.03, 0.5};
  const DampedMode around{3.0 / 0.02, 0.5 * 0.01 / 0.02, 0.2 - 0.05, 2.0};
  recorder.verify("largest error along the bracket's x [m]", 0.0,
                  find_error(stage, "mount.x_offset", [&](double t) { return along.eval(t); }), kClose);
  recorder.verify("largest error along its y [m]", 0.0,
                  find_error(stage, "mount.y_offset", [&](double t) { return across.eval(t); }), kClose);
  recorder.verify("largest error of the twist [rad]", 0.0,
                  find_error(stage, "mount.twist", [&](double t) { return 0.05 + around.eval(t); }), kClose);
}

// z = x + i y of the pod against the hub: m z̈ = −k z − d (ż − iωz), because the damper turns with its carrier.
TEST(Loads, BushingOnATurningCarrier) {
  book::Recorder recorder({kChapter, "Bushing on a turning carrier", "closed form by the roots of mλ² + dλ + k − iωd",
                           "A bushing, alike in both directions, turns at 5 rad/s and drags a body into a whirl: what "
                           "its damper feels is the motion as its own carrier sees it.",
                           kTight});
  constexpr double kMass = 1.4, kStiffness = 120.0, kDamping = 2.5, kRate = 5.0;
  Mechanism mechanism = oracle::make_empty("whirl", {}, {{"hub", {-0.2, 0.15}}});
  mechanism.bodies.push_back({"rotor", 1.0, 0.1, {}, {{"hub", {0.0, 0.0}}}, {}});
  oracle::add_revolute(mechanism, "hub", {kFrameName, "hub"}, {"rotor", "hub"});
  mechanism.drivers.push_back({"motor", DrivenAngle{"rotor"}, 0.3, kRate});
  BodyStart start = oracle::start_turning(0.0, 0.0);
  start.position = {-0.2 + 0.08, 0.15 - 0.02};
  start.velocity = {0.3, 0.7};
  mechanism.bodies.push_back({"pod", kMass, 0.01, {}, {{"eye", {0.0, 0.0}}}, start});
  mechanism.loads.push_back(
      {"mount",
       Bushing{{"rotor", "hub"}, {"pod", "eye"}, {kStiffness, kStiffness}, {kDamping, kDamping}, 0.0, 0.0, 0.0}});
  const StageRecord stage = run_for(mechanism, 4.0, 400, 1e-11);
  using Complex = std::complex<double>;
  const Complex root =
      std::sqrt(Complex(kDamping * kDamping - 4.0 * kMass * kStiffness, 4.0 * kMass * kRate * kDamping));
  const Complex first = (-kDamping + root) / (2.0 * kMass);
  const Complex second = (-kDamping - root) / (2.0 * kMass);
  const Complex place(0.08, -0.02), speed(0.3, 0.7);
  const Complex weight = (speed - second * place) / (first - second);
  const auto z = [&](double t) { return weight * std::exp(first * t) + (place - weight) * std::exp(second * t); };
  recorder.verify("largest error of x over 4 s [m]", 0.0,
                  find_error(stage, "pod.x", [&](double t) { return -0.2 + z(t).real(); }), kClose);
  recorder.verify("largest error of y over 4 s [m]", 0.0,
                  find_error(stage, "pod.y", [&](double t) { return 0.15 + z(t).imag(); }), kClose);
}

// Two loose bodies on one bushing and one spring: what they do to each other moves neither their common centre nor
// their common angular momentum.
TEST(Loads, LeaveALoosePairItsMomentum) {
  book::Recorder recorder({kChapter, "Momentum of a loose pair", "conservation of momentum and angular momentum",
                           "Two bodies loose from everything, tied by a bushing, a spring and a torque.",
                           "the run's tolerance is 1e-11"});
  Mechanism mechanism = oracle::make_empty("pair", {}, {});
  BodyStart left = oracle::start_turning(0.4, 3.0);
  left.position = {0.1, 0.2};
  left.velocity = {0.5, -0.3};
  mechanism.bodies.push_back({"left", 1.3, 0.03, {0.02, 0.01}, {{"a", {0.1, 0.0}}, {"b", {-0.1, 0.05}}}, left});
  BodyStart right = oracle::start_turning(-0.2, -1.0);
  right.position = {0.35, 0.25};
  right.velocity = {-0.1, 0.6};
  mechanism.bodies.push_back({"right", 0.8, 0.02, {-0.01, 0.03}, {{"a", {-0.1, 0.0}}, {"b", {0.1, 0.1}}}, right});
  mechanism.loads.push_back(
      {"mount", Bushing{{"left", "a"}, {"right", "a"}, {300.0, 80.0}, {2.0, 0.5}, 4.0, 0.02, 0.1}});
  mechanism.loads.push_back({"rope", Spring{{"left", "b"}, {"right", "b"}, 60.0, 0.4, 0.3}});
  mechanism.loads.push_back({"twist", VariableTorque{"right", "left", Expression{"0.3 * sin(7 * t)", {}}}});
  const StageRecord stage = run_for(mechanism, 2.0, 50, 1e-11);
  const auto before = find_momenta(mechanism, stage, 0);
  const auto after = find_momenta(mechanism, stage, stage.time.size() - 1);
  recorder.verify("momentum along x after 2 s [N s]", before[0], after[0], kClose);
  recorder.verify("momentum along y [N s]", before[1], after[1], kClose);
  recorder.verify("angular momentum [N m s]", before[2], after[2], kClose);
}

// The dense textbook form by another integrator, from the same start.
std::vector<oracle::TextbookBody> integrate_textbook(const Mechanism& mechanism, double end) {
  const oracle::Textbook textbook(mechanism);
  oracle::TextbookState state = textbook.make_state();
  const Assembly assembly = assemble(mechanism);
  std::vector<double> y;
  for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
    const BodyPose& pose = assembly.poses[b];
    const auto body = textbook.place(static_cast<int>(b), pose.position, pose.angle, pose.velocity, pose.angle_rate);
    y.insert(y.end(), {body.center.x, body.center.y, body.angle, body.velocity.x, body.velocity.y, body.angle_rate});
  }
  const auto unpack = [&](const std::vector<double>& from) {
    for (std::size_t b = 1; b < state.bodies.size(); ++b) {
      const double* at = from.data() + 6 * (b - 1);
      state.bodies[b] = {{at[0], at[1]}, at[2], {at[3], at[4]}, at[5]};
    }
  };
  const auto slope = [&](const std::vector<double>& from, std::vector<double>& rates, double t) {
    unpack(from);
    const auto accelerations = textbook.solve(state, t).accelerations;
    for (std::size_t b = 1; b < state.bodies.size(); ++b) {
      const oracle::TextbookBody& body = state.bodies[b];
      const auto& a = accelerations[b];
      const double values[6] = {body.velocity.x, body.velocity.y, body.angle_rate, a.center.x, a.center.y, a.angle};
      std::copy_n(values, 6, rates.begin() + static_cast<std::ptrdiff_t>(6 * (b - 1)));
    }
  };
  namespace odeint = boost::numeric::odeint;
  const auto stepper = odeint::make_controlled<odeint::runge_kutta_fehlberg78<std::vector<double>>>(1e-12, 1e-12);
  odeint::integrate_adaptive(stepper, slope, y, 0.0, end, 1e-3);
  unpack(y);
  return state.bodies;
}

TEST(Loads, MoveAsTheTextbookFormDoes) {
  for (const Mechanism& mechanism :
       {oracle::make_sprung_four_bar(), oracle::make_press(), oracle::make_controlled_arm(),
        oracle::make_pod_on_bushing(), oracle::make_torsion_chain(), oracle::make_loaded_driven_slide()}) {
    book::Recorder recorder(
        {kChapter, fmt::format("{} against the textbook form", mechanism.name),
         "maximal coordinates, dense matrices, loads written anew, integrated by Boost's "
         "Runge-Kutta-Fehlberg 7(8) at 1e-12",
         "One second of motion, from the same start.",
         "both integrations are good to some 1e-11 a step, and the textbook form drifts off its constraints"});
    const auto expected = integrate_textbook(mechanism, 1.0);
    const StageRecord stage = run_for(mechanism, 1.0, 10, 1e-11);
    for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
      const std::string& name = mechanism.bodies[b].name;
      const auto last = [&](const char* ending) { return find_values(stage, name + ending)->back(); };
      recorder.verify(name + ".x [m]", expected[b].center.x, last(".x"), kClose);
      recorder.verify(name + ".y [m]", expected[b].center.y, last(".y"), kClose);
      recorder.verify(name + ".angle [rad]", expected[b].angle, last(".angle"), kClose);
    }
  }
}

TEST(Loads, LedgersClose) {
  for (const auto& [tolerance, bound] : {std::pair{1e-7, kEnergyTolerance}, {1e-10, 1e-9}}) {
    book::Recorder recorder({"Energy", fmt::format("Ledgers under loads, tolerance {:g}", tolerance),
                             "zero in exact arithmetic",
                             "Work of forces by formula, losses in dampers and energy in springs add up.",
                             "ten times the tolerance, from local errors"});
    for (const Mechanism& mechanism : oracle::make_loaded_mechanisms()) {
      // The crank of the one with clearance turns once in 12 ms.
      const bool loose = mechanism.name == "loaded_clearance";
      const EnergyBalance balance = run_for(mechanism, loose ? 0.024 : 1.0, 10, tolerance).energy;
      recorder.verify(mechanism.name + ": |residual| / exchanged [1]", 0.0, check_energy(balance).relative, bound);
      EXPECT_GT(std::abs(balance.load_work) + std::abs(balance.damper_loss), 0.0) << mechanism.name;
      EXPECT_GE(balance.damper_loss, 0.0) << mechanism.name;
    }
  }
}

}  // namespace
}  // namespace gudgeon
