// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A block that every friction law slows down, v̇ = −g μ(v), as a wheel under a brake shoe in the whole engine. Between
// two samples time passes by ∫ dv/(g μ) and the distance grows by ∫ v dv/(g μ): closed forms, worked out on paper;
// where there is none, a quadrature of the formula written out here.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <functional>

#include "tests/verification/book/recorder.h"
#include "tests/verification/brake.h"

namespace gudgeon {
namespace {

constexpr double kGravity = 9.81;
constexpr double kMuS = 0.25;
constexpr double kMuK = 0.15;
constexpr double kDeceleration = kMuK * kGravity;

// The run's tolerance is 1e-11 a step, and the motion is smooth: what is left [s, m] is below it.
constexpr double kSmall = 1e-11;
// The shoe has come to rest to rounding: exp(−10 000/s · 20 ms).
constexpr double kSettled = 0.02;

// An antiderivative of 1/(g μ) or v/(g μ).
using Integral = std::function<double(double)>;

struct Slide {
  std::string name;
  AnyFriction law;
  double speed = 0.5;  // [m/s] at the start
  double end = 0.3;    // [s]
  Integral time;       // none: not compared
  Integral distance;
};

StageRecord run_slide(const AnyFriction& law, double speed, double end) {
  Study study;
  study.cycle_time = end;
  study.cycles = 1;
  study.outputs_per_cycle = 300;
  study.relative_tolerance = 1e-11;
  study.absolute_tolerance = 1e-13;
  study.compare_ideal = false;
  const auto stages = run_study(make_brake({1.0, kGravity, speed, law}), study);
  EXPECT_EQ(stages.back().status, StageStatus::finished) << stages.back().message;
  return stages.back();
}

void verify_slide(book::Recorder& recorder, const Slide& slide) {
  const StageRecord stage = run_slide(slide.law, slide.speed, slide.end);
  const auto& speeds = *find_values(stage, "wheel.angle_rate");
  const auto& places = *find_values(stage, "wheel.angle");
  const auto first = static_cast<std::size_t>(kSettled / slide.end * 300.0) + 1;
  const double before = speeds[first];
  const double after = speeds.back();
  if (slide.time) {
    recorder.verify(fmt::format("{}: time from {:.3f} to {:.3f} m/s [s]", slide.name, before, after),
                    slide.time(before) - slide.time(after), stage.time.back() - stage.time[first], kSmall);
  }
  if (slide.distance) {
    recorder.verify(fmt::format("{}: distance from {:.3f} to {:.3f} m/s [m]", slide.name, before, after),
                    slide.distance(before) - slide.distance(after), places.back() - places[first], kSmall);
  }
}

// sinh(v/v_t) falls exponentially, and so does exp(3 v/v_t) − 1.
std::vector<Slide> make_smooth_slides() {
  constexpr double kRate = 3.0 / 0.1;
  return {{"frictionless", Frictionless{}, 0.5, 0.3, {}, [](double) { return 0.0; }},
          {"coulomb_smooth",
           CoulombSmooth{kMuK, 0.05},
           0.5,
           0.33,
           [](double v) { return 0.05 / kDeceleration * std::log(std::sinh(v / 0.05)); },
           {}},
          {"threlfall",
           Threlfall{kMuK, 0.1},
           0.4,
           0.3,
           [](double v) { return std::log(std::expm1(kRate * v)) / (kRate * kDeceleration); },
           {}}};
}

// Uniformly slowed down to v₁, exponentially towards v₀ from there.
std::vector<Slide> make_ramp_slides() {
  constexpr double kRelaxation = 0.08 / kDeceleration;
  const CoulombRamp law{kMuK, 0.02, 0.1};
  return {{"coulomb_ramp, above v₁", law, 0.5, 0.25, [](double v) { return v / kDeceleration; },
           [](double v) { return 0.5 * v * v / kDeceleration; }},
          {"coulomb_ramp, below v₁", law, 0.099, 0.1, [](double v) { return kRelaxation * std::log(v - 0.02); },
           [](double v) { return kRelaxation * (v + 0.02 * std::log(v - 0.02)); }}};
}

// Beyond v_t p = exp(ξ (v − v_t)) obeys ṗ = −ξ g (μ_k p + μ_s − μ_k); below, with u = v/v_t,
// ∫ du/(u (2 − u)) = ½ ln(u/(2 − u)) and ∫ u du/(u (2 − u)) = −ln(2 − u).
std::vector<Slide> make_bengisu_akay_slides() {
  constexpr double kPeak = 0.05;
  constexpr double kRate = 12.0;
  constexpr double kScale = kPeak / (kMuS * kGravity);
  const BengisuAkay law{kMuS, kMuK, kPeak, kRate};
  return {
      {"bengisu_akay, above v_t",
       law,
       0.4,
       0.15,
       [](double v) { return std::log(kMuK * std::exp(kRate * (v - kPeak)) + kMuS - kMuK) / (kRate * kDeceleration); },
       {}},
      {"bengisu_akay, below v_t", law, 0.999 * kPeak, 0.06,
       [](double v) { return kScale * 0.5 * std::log(v / (2.0 * kPeak - v)); },
       [](double v) { return -kScale * kPeak * std::log(2.0 - v / kPeak); }}};
}

// Where tanh is 1. stribeck_smooth: with q = v², x = ½ ∫ (v_s² + q) dq/(μ_k q + μ_s v_s²)/g. lugre_steady with γ = 2:
// with p = exp(v²/v_s²), x = v_s²/(2 g) ∫ dp/(μ_k p + μ_s − μ_k); with viscous friction alone v + μ_k/σ₂ falls
// exponentially.
std::vector<Slide> make_stribeck_slides() {
  constexpr double kS = 0.1;
  constexpr double kS2 = kS * kS;
  constexpr double kViscous = 0.3;
  constexpr double kOffset = kMuK / kViscous;
  const double root = kS * std::sqrt(kMuS / kMuK);
  return {{"stribeck_smooth", StribeckSmooth{kMuS, kMuK, kS, 0.0, 1e-4}, 0.5, 0.28,
           [root](double v) { return (v + (kS2 - root * root) / root * std::atan(v / root)) / kDeceleration; },
           [](double v) {
             return 0.5 / kDeceleration * (v * v + kS2 * (1.0 - kMuS / kMuK) * std::log(kMuK * v * v + kMuS * kS2));
           }},
          {"lugre_steady",
           LugreSteady{kMuS, kMuK, kS, 2.0, 0.0, 1e-4},
           0.5,
           0.28,
           {},
           [](double v) { return kS2 / (2.0 * kDeceleration) * std::log(kMuK * std::exp(v * v / kS2) + kMuS - kMuK); }},
          {"lugre_steady, viscous", LugreSteady{kMuK, kMuK, kS, 2.0, kViscous, 1e-4}, 0.5, 0.2,
           [](double v) { return std::log(v + kOffset) / (kGravity * kViscous); },
           [](double v) { return (v - kOffset * std::log(v + kOffset)) / (kGravity * kViscous); }}};
}

// No closed form: the formula of the literature, integrated by Gauss and Kronrod.
Slide make_brown_mcphee_slide() {
  constexpr double kPeak = 0.08;
  constexpr double kViscous = 0.2;
  const auto deceleration = [](double v) {
    const double r = v / kPeak;
    const double bump = r / std::pow(0.25 * r * r + 0.75, 2.0);
    return kGravity * (kMuK * std::tanh(4.0 * r) + (kMuS - kMuK) * bump + kViscous * v);
  };
  using Rule = boost::math::quadrature::gauss_kronrod<double, 61>;
  const auto time = [=](double v) {
    return Rule::integrate([=](double u) { return 1.0 / deceleration(u); }, 0.01, v, 15, 1e-13);
  };
  const auto distance = [=](double v) {
    return Rule::integrate([=](double u) { return u / deceleration(u); }, 0.01, v, 15, 1e-13);
  };
  return {"brown_mcphee", BrownMcPhee{kMuS, kMuK, kViscous, kPeak}, 0.5, 0.18, time, distance};
}

TEST(SlidingBlock, UnderEveryLawWithoutBristle) {
  book::Recorder recorder(
      {"Friction", "A block slides under each law",
       "closed forms ∫ dv/(g μ) and ∫ v dv/(g μ); brown_mcphee by Gauss-Kronrod quadrature",
       "A wheel under a brake shoe, through the whole engine: between two samples of the speed, the "
       "time and the distance at the rim.",
       "the run's tolerance is 1e-11 a step, and the motion is smooth"});
  for (const auto& slides :
       {make_smooth_slides(), make_ramp_slides(), make_bengisu_akay_slides(), make_stribeck_slides()}) {
    for (const Slide& slide : slides) {
      if (slide.name == "frictionless") {
        recorder.verify("frictionless: speed after 0.3 s [m/s]", 0.5,
                        find_values(run_slide(slide.law, 0.5, 0.3), "wheel.angle_rate")->back(), kSmall);
      } else {
        verify_slide(recorder, slide);
      }
    }
  }
  verify_slide(recorder, make_brown_mcphee_slide());
}

// Over a slip x a bristle of i = 1 comes nearer to its end, μ = μ_k − (μ_k − μ₁) exp(−σ₀ x/μ_k), so that
// v₁² − v² = 2 g [μ_k x − (μ_k − μ₁) μ_k/σ₀ (1 − exp(−σ₀ x/μ_k))]. LuGre with one level and no damping is the same.
TEST(SlidingBlock, UnderBristles) {
  book::Recorder recorder(
      {"Friction", "A block slides over bristles", "closed form: the bristle yields exponentially over the distance",
       "The same wheel under dahl, and under lugre of one level. Soft bristles, so that they yield over "
       "centimetres.",
       "the run's tolerance is 1e-11 a step, and the motion is smooth"});
  constexpr double kSoft = 5.0;  // [1/m]
  Lugre lugre;
  lugre.static_coefficient = lugre.kinetic_coefficient = kMuK;
  lugre.bristle_stiffness = kSoft;
  for (const AnyFriction& law : {AnyFriction{Dahl{kMuK, kSoft, 1.0}}, AnyFriction{lugre}}) {
    const StageRecord stage = run_slide(law, 0.5, 0.3);
    const auto at = [&](const char* channel, std::size_t k) { return find_values(stage, channel)->at(k); };
    const std::size_t first = 30;
    const std::size_t last = stage.time.size() - 1;
    const double start = kSoft * at("pad.bristle", first);
    const double slip = at("wheel.angle", last) - at("wheel.angle", first);
    const double yielded = -std::expm1(-kSoft * slip / kMuK);
    const double lost = 2.0 * kGravity * (kMuK * slip - (kMuK - start) * kMuK / kSoft * yielded);
    const std::string name(law_name(law));
    recorder.verify(name + ": bristle after the slide [m]", (kMuK - (kMuK - start) * (1.0 - yielded)) / kSoft,
                    at("pad.bristle", last), kSmall);
    recorder.verify(name + ": v² lost over the slide [m²/s²]", lost,
                    std::pow(at("wheel.angle_rate", first), 2) - std::pow(at("wheel.angle_rate", last), 2), kSmall);
  }
}

}  // namespace
}  // namespace gudgeon
