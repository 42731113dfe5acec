// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What every damping form gives back, by real impacts through the whole engine.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "gudgeon/laws/damping/delivered_restitution.h"
#include "gudgeon/sim/run_study.h"
#include "tests/verification/book/recorder.h"

namespace gudgeon {
namespace {

constexpr double kBearingRadius = 1.0;
constexpr double kClearance = 0.5;
constexpr double kSpeed = 3.0;

// A ball of 2 kg flies along x from the middle of a bearing, K = 1e6 N/m^1.5, and is followed until it flies back.
double find_rebound(const AnyNormalForce& law) {
  Mechanism mechanism;
  mechanism.name = "flight";
  mechanism.bodies.push_back({kFrameName, 0.0, 0.0, {}, {{"bearing", {0.0, 0.0}}}, {}});
  mechanism.bodies.push_back({"ball", 2.0, 1.0, {}, {{"journal", {0.0, 0.0}}}, {0.0, 0.0, Vec2{}, Vec2{kSpeed, 0.0}}});
  RevoluteClearance joint{{kFrameName, "bearing"}, {"ball", "journal"}, kBearingRadius, kClearance, 1.0, {}};
  // R_r = R_i R_j/c = 1 m, and E* is half of E for two equal surfaces without lateral contraction: K = 4/3 E* √R_r.
  joint.contact.bearing_material = joint.contact.journal_material = {"test", 1.5e6, 0.0};
  joint.contact.normal_force = law;
  mechanism.joints.push_back({"wall", joint});
  Study study;
  study.cycle_time = 0.25;
  study.cycles = 1;
  study.outputs_per_cycle = 10;
  study.compare_ideal = false;
  study.relative_tolerance = 1e-11;
  study.absolute_tolerance = 1e-13;
  const StageRecord stage = run_study(mechanism, study).back();
  EXPECT_EQ(stage.status, StageStatus::finished) << stage.message;
  return find_values(stage, "ball.x_velocity")->back() / -kSpeed;
}

TEST(Restitution, OfEveryDampingFormOverTheRestitutionAskedFor) {
  book::Recorder recorder(
      {"Normal force", "Restitution delivered by every damping form",
       "root of χ (1 + e) = ln[(1 + χ)/(1 − χ e)], whatever stiffness, mass and speed",
       "A ball strikes its bearing; the ratio of the speeds after and before, for each e asked for.",
       "the run's tolerance is 1e-11 a step; the rest is rounding of the gap, within which onset is located"});
  for_each_alternative<AnyDamping>([&]<class Damping>() {
    if constexpr (!std::same_as<Damping, NoDamping>) {
      for (const double asked : {0.1, 0.3, 0.5, 0.7, 0.9, 0.99}) {
        using Law = DampedHertz<Damping>;
        const Law law{asked, 1.5};
        recorder.verify(fmt::format("{}, e = {:g} [1]", Law::kName, asked),
                        find_delivered_restitution(law.damping_factor()), find_rebound(law), 1e-7);
      }
    }
  });
}

TEST(Restitution, OfTheLawsThatHaveADampingOfTheirOwn) {
  book::Recorder recorder(
      {"Normal force", "Restitution delivered by anagnostopoulos and bai_zhao",
       "the linear damper that is cut off where it would pull; the same root for bai_zhao",
       "The same ball under the laws that are no damping form on a Hertzian force.",
       "the run's tolerance is 1e-11 a step; the rest is rounding of the gap, within which onset is located"});
  for (const double asked : {0.1, 0.3, 0.5, 0.7, 0.9, 0.99}) {
    const Anagnostopoulos linear{1e6, 2.0, asked};
    recorder.verify(fmt::format("anagnostopoulos, e = {:g} [1]", asked), linear.delivered_restitution(),
                    find_rebound(linear), 1e-7);
    const BaiZhao hybrid{asked};
    recorder.verify(fmt::format("bai_zhao, e = {:g} [1]", asked), find_delivered_restitution(hybrid.damping_factor()),
                    find_rebound(hybrid), 1e-7);
  }
}

TEST(Restitution, PublishedTable) {
  book::Recorder recorder({"Normal force", "Restitution: published table", "table of the literature, five digits",
                           "The same for the paper's law, and for the one that solves the closed form.",
                           "one unit of the fifth digit"});
  constexpr std::array kAsked{0.1, 0.3, 0.5, 0.7, 0.9, 0.99};
  constexpr std::array kDelivered{.66527, .68422, .72524, .79597, .91318, .99015};
  for (std::size_t k = 0; k < kAsked.size(); ++k) {
    recorder.verify(fmt::format("lankarani_nikravesh, e = {:g} [1]", kAsked[k]), kDelivered[k],
                    find_rebound(LankaraniNikravesh{kAsked[k], 1.5}), 1e-5);
    recorder.verify(fmt::format("exact_restitution, e = {:g} [1]", kAsked[k]), kAsked[k],
                    find_rebound(DampedHertz<ExactRestitutionDamping>{kAsked[k], 1.5}), 1e-7);
  }
}

}  // namespace
}  // namespace gudgeon
