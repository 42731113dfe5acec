// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The restitution of every damping form: closed form against tabulated values and against impacts run in time.
#include "gudgeon/laws/damping/delivered_restitution.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <string_view>

#include "gudgeon/laws/normal/any.h"
#include "tests/laws/rebound.h"
#include "tests/laws/sample_law.h"

namespace gudgeon {
namespace {

constexpr std::array kAsked{0.1, 0.3, 0.5, 0.7, 0.9, 0.99};

using Row = std::array<double, 6>;
const std::map<std::string_view, Row> kDelivered{
    {"lankarani_nikravesh", {.66527, .68422, .72524, .79597, .91318, .99015}},
    {"hunt_crossley", {.51583, .58129, .66296, .76800, .90902, .99010}},
    {"herbert_mcwhannell", {.49070, .51997, .59362, .72268, .90089, .99000}},
    {"lee_wang", {.68666, .73900, .79920, .86934, .95237, .99502}},
    {"zhiying_qishao", {.21747, .32670, .48261, .67957, .89592, .98995}},
    {"gonthier", {.10099, .30422, .48774, .66958, .87644, .98678}},
    {"flores", {.06944, .25621, .47044, .68318, .89392, .98934}},
    {"hu_guo", {.07407, .27066, .48774, .69730, .89990, .99000}},
    {"carvalho_martins", {.12894, .30397, .50017, .69997, .90000, .99000}},
    {"exact_restitution", {.1, .3, .5, .7, .9, .99}},
    {"bai_zhao", {.21747, .32670, .48261, .67957, .89592, .98995}}};  // the damping of zhiying_qishao

TEST(DeliveredRestitution, AgreesWithTheTable) {
  int n_forms = 0;
  for_each_alternative<AnyDamping>([&]<class Damping> {
    if constexpr (requires(Damping damping) { damping.restitution; }) {
      ++n_forms;
      for (std::size_t i = 0; i < kAsked.size(); ++i) {
        const double factor = Damping{kAsked[i]}.damping_factor();
        EXPECT_NEAR(find_delivered_restitution(factor), kDelivered.at(Damping::kName)[i],
                    5.1e-6)  // printed to 5 digits
            << Damping::kName;
      }
    }
  });
  EXPECT_EQ(n_forms, 10);
}

TEST(DeliveredRestitution, IsWhatEveryLawReturns) {
  int n_laws = 0;
  for_each_alternative<AnyNormalForce>([&]<class Law> {
    if constexpr (requires(Law law) { law.restitution; }) {
      ++n_laws;
      for (std::size_t i = 0; i < kAsked.size(); ++i) {
        auto law = make_sample_law<Law>();
        law.restitution = kAsked[i];
        double closed = 0.0;
        if constexpr (std::same_as<Law, Anagnostopoulos>) {
          law.stiffness = 1e6;
          law.effective_mass = kReboundMass;
          closed = law.delivered_restitution();
        } else {
          closed = find_delivered_restitution(law.damping_factor());
          EXPECT_NEAR(closed, kDelivered.at(Law::kName)[i], 5.1e-6) << Law::kName;
        }
        EXPECT_NEAR(run_rebound(law).restitution, closed, 1e-6) << Law::kName << " at " << kAsked[i];
      }
    }
  });
  EXPECT_EQ(n_laws, 12);
}

TEST(DeliveredRestitution, DoesNotDependOnTheElasticForce) {
  int n_laws = 0;
  for_each_alternative<AnyNormalForce>([&]<class Law> {
    if constexpr (NestsDamping<Law>) {
      ++n_laws;
      Law law;
      EXPECT_NEAR(run_rebound(law).restitution, 1.0, 1e-6) << Law::kName;
      for (const double asked : {0.1, 0.5, 0.9}) {
        law.damping = ExactRestitutionDamping{asked};
        EXPECT_NEAR(run_rebound(law).restitution, asked, 1e-6) << Law::kName;
      }
    }
  });
  EXPECT_EQ(n_laws, 8);
}

TEST(DeliveredRestitution, HasItsLimits) {
  EXPECT_EQ(find_delivered_restitution(0.0), 1.0);
  EXPECT_NEAR(find_delivered_restitution(1e-5), 1.0 - 2e-5 / 3.0, 1e-10);
  EXPECT_NEAR(find_delivered_restitution(1e-12), 1.0 - 2e-12 / 3.0, 2e-16);  // the last bit
  EXPECT_LT(find_delivered_restitution(1e6), 1e-5);
}

TEST(ExactRestitution, HasTheTabulatedFactors) {
  constexpr Row kFactors{9.998159, 3.087082, 1.432751, .634828, .166482, .015151};
  for (std::size_t i = 0; i < kAsked.size(); ++i) {
    EXPECT_NEAR(ExactRestitutionDamping{kAsked[i]}.damping_factor(), kFactors[i], 5e-7);  // printed to 6 decimals
  }
}

TEST(ExactRestitution, DeliversWhatItIsAskedFor) {
  for (double e = 1e-3; e < 1.0; e += 1e-3) {
    EXPECT_NEAR(find_delivered_restitution(ExactRestitutionDamping{e}.damping_factor()), e, 4e-16) << e;
  }
  for (const double loss : {1e-4, 1e-8, 1e-12}) {
    const double factor = ExactRestitutionDamping{1.0 - loss}.damping_factor();
    // χ = 3/2 (1 − e) + 3/2 (1 − e)² …; 1 − e is known to 1e-16.
    EXPECT_NEAR(factor, 1.5 * loss + 1.5 * loss * loss, 3.0 * loss * loss * loss + 3e-16);
  }
  EXPECT_EQ(ExactRestitutionDamping{1.0}.damping_factor(), 0.0);
  EXPECT_NEAR(ExactRestitutionDamping{1e-3}.damping_factor(), 1e3, 1e-9);
}

TEST(ExactRestitution, SatisfiesItsEquation) {
  for (const double e : {0.05, 0.2, 0.4, 0.6, 0.8}) {
    const double factor = ExactRestitutionDamping{e}.damping_factor();
    EXPECT_NEAR(factor * (1.0 + e), std::log((1.0 + factor) / (1.0 - factor * e)), 1e-7) << e;  // 1 − χe is small
  }
}

TEST(Rebound, HasTheDepthOfTheClosedForm) {
  for_each_alternative<AnyDamping>([]<class Damping> {
    if constexpr (requires(Damping damping) { damping.restitution; }) {
      for (const double exponent : {1.5, 2.0}) {
        const DampedHertz<Damping> law{0.6, exponent};
        const double chi = law.damping_factor();
        const double energy = (exponent + 1.0) * kReboundMass * 9.0 / 1e6 * (chi - std::log1p(chi)) / (chi * chi);
        const double depth = std::pow(energy, 1.0 / (exponent + 1.0));
        EXPECT_NEAR(run_rebound(law).peak_penetration, depth, 1e-6 * depth) << Damping::kName;
      }
    }
  });
}

TEST(Rebound, OfHertzHasTheReferenceNumbers) {
  const Rebound rebound = run_rebound(Hertz{});
  EXPECT_NEAR(rebound.peak_penetration, 0.0138316187, 5e-9);  // the nearest step is below the peak by its square
  EXPECT_NEAR(rebound.peak_force, 1626.70766, 1e-3);
  EXPECT_NEAR(rebound.duration, 0.0135700858, 2e-9);
}

}  // namespace
}  // namespace gudgeon
