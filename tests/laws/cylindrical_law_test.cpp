// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The laws of cylinders: each as it is printed, its limits, the end of its range, and Persson's against the contact
// problem of plane elasticity.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <numbers>

#include "gudgeon/laws/normal/any.h"

namespace gudgeon {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kBearingRadius = 15e-3;
constexpr double kWidth = 20e-3;
constexpr double kModulus = 1.1e11;

NormalContact make_contact(double penetration, double clearance) {
  return {penetration, 0.0, 0.1, 0.0, 0.0, kBearingRadius, kBearingRadius - clearance, kWidth, kModulus};
}

// Penetration of a force per width as the literature prints it.
using Printed = std::function<double(double load, double clearance)>;

template <class Law>
void expect_inverse(const Printed& printed, double end) {
  for (const double clearance : {0.05e-3, 0.5e-3, 2e-3}) {
    for (const double share : {1e-6, 1e-3, 0.1, 0.5, 0.9, 0.999}) {
      const double penetration = share * end * clearance;
      const double force = Law{}(make_contact(penetration, clearance)).force;
      EXPECT_NEAR(printed(force / kWidth, clearance), penetration, 1e-12 * penetration) << Law::kName << " " << share;
    }
    EXPECT_TRUE(std::isnan(Law{}(make_contact(1.001 * end * clearance, clearance)).force)) << Law::kName;
    EXPECT_TRUE(std::isnan(Law{}(make_contact(1.001 * end * clearance, clearance)).elastic_energy));
  }
}

double half_width(double load, double clearance) {
  const double journal = kBearingRadius - clearance;
  return std::sqrt(4.0 * load * kBearingRadius * journal / clearance / (kPi * kModulus));
}

TEST(CylindricalLaw, InvertsJohnson) {
  expect_inverse<Johnson>(
      [](double f, double c) { return f / (kPi * kModulus) * (std::log(4.0 * kPi * kModulus * c / f) - 1.0); },
      4.0 * std::exp(-2.0));
  // The same by Hertz's half width, as Johnson's eq. (5.57) has it for each cylinder.
  expect_inverse<Johnson>(
      [](double f, double c) {
        const double a = half_width(f, c);
        return f / (kPi * kModulus) * (std::log(4.0 * kBearingRadius / a * 4.0 * (kBearingRadius - c) / a) - 1.0);
      },
      4.0 * std::exp(-2.0));
}

TEST(CylindricalLaw, InvertsRadzimovsky) {
  expect_inverse<Radzimovsky>(
      [](double f, double c) {
        const double b = 2.0 * half_width(f, c);
        return f / (kPi * kModulus) *
               (2.0 / 3.0 + std::log(4.0 * kBearingRadius / b) + std::log(4.0 * (kBearingRadius - c) / b));
      },
      std::exp(2.0 / 3.0 - 1.0));
}

TEST(CylindricalLaw, RadzimovskysConstantIsThatOfAParabolicPressure) {
  // ∫ p ln|s| ds over −1 to 1 of a pressure of load 1, by the midpoint rule in s = sin u.
  const auto mean_logarithm = [](const std::function<double(double)>& pressure) {
    constexpr int kSteps = 200000;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
      const double u = 0.5 * kPi * (i + 0.5) / kSteps;
      sum += 2.0 * pressure(std::sin(u)) * std::log(std::sin(u)) * std::cos(u);
    }
    return sum * 0.5 * kPi / kSteps;
  };
  const double elliptic = mean_logarithm([](double s) { return 2.0 / kPi * std::sqrt(1.0 - s * s); });
  const double parabolic = mean_logarithm([](double s) { return 0.75 * (1.0 - s * s); });
  // Two half-planes sink by −2/(π E) of that each, so Johnson's −1 grows by twice the difference.
  const double constant = -1.0 + 2.0 * (elliptic - parabolic);
  EXPECT_NEAR(constant, 2.0 / 3.0 - 2.0 * std::log(2.0), 1e-5);  // the logarithm costs the rule its order
  const NormalContact contact = make_contact(1e-5, 0.5e-3);
  const double load = Radzimovsky{}(contact).force / kWidth;
  EXPECT_NEAR(kPi * kModulus * 1e-5 / load - std::log(4.0 * kPi * kModulus * 0.5e-3 / load), constant, 1e-5);
}

TEST(CylindricalLaw, InvertsEsdu) {
  expect_inverse<Esdu78035>(
      [](double f, double c) { return f / (kPi * kModulus) * (std::log(4.0 * kPi * kModulus * c / f) + 1.0); }, 4.0);
}

TEST(CylindricalLaw, InvertsTheLawsOfTheWidth) {
  const auto printed = [](double f, double c) {
    const double force = f * kWidth;
    const double sigma = 1.0 / (kPi * kModulus);  // σ_i + σ_j
    return force * sigma / kWidth *
           (std::log(std::pow(kWidth, 3) * c / (force * kBearingRadius * (kBearingRadius - c) * sigma)) + 1.0);
  };
  for (const double clearance : {0.05e-3, 0.5e-3}) {
    const double end = kWidth * kWidth * clearance / (kBearingRadius * (kBearingRadius - clearance));
    for (const double share : {1e-6, 0.01, 0.5, 0.99}) {
      const NormalContact contact = make_contact(share * end, clearance);
      const double force = Goldsmith{}(contact).force;
      EXPECT_NEAR(printed(force / kWidth, clearance), share * end, 1e-12 * end * share);
      EXPECT_EQ(DubowskyFreudenstein{}(contact).force, force);
    }
    EXPECT_TRUE(std::isnan(Goldsmith{}(make_contact(1.001 * end, clearance)).force));
  }
}

// The ends as the laws' own formulas have them: dδ/dF = 0.
template <class Law>
void expect_end(double force, double penetration, double clearance) {
  const NormalContact contact = make_contact(1e-6, clearance);
  const LawEnd end = Law{}.find_end(contact);
  EXPECT_NEAR(end.force, force, 1e-12 * force) << Law::kName;
  EXPECT_NEAR(end.penetration, penetration, 1e-12 * penetration) << Law::kName;
  EXPECT_TRUE(std::isnan(Law{}(make_contact(1.0000001 * end.penetration, clearance)).force)) << Law::kName;
  // Towards it F comes with the root of what is left.
  const double near = Law{}(make_contact((1.0 - 1e-8) * end.penetration, clearance)).force;
  EXPECT_LT(near, force);
  EXPECT_NEAR(near, force, 2e-4 * force) << Law::kName;
}

TEST(CylindricalLaw, EndsWhereItSays) {
  for (const double clearance : {0.02e-3, 0.5e-3}) {
    const double line = kPi * kModulus * kWidth;
    const double radius = kBearingRadius * (kBearingRadius - clearance) / clearance;
    const double e = std::numbers::e;
    expect_end<Johnson>(4.0 * line * clearance / (e * e), 4.0 * clearance / (e * e), clearance);
    expect_end<Radzimovsky>(line * clearance * std::exp(-1.0 / 3.0), std::exp(-1.0 / 3.0) * clearance, clearance);
    expect_end<Esdu78035>(4.0 * line * clearance, 4.0 * clearance, clearance);
    expect_end<Goldsmith>(line * kWidth * kWidth / radius, kWidth * kWidth / radius, clearance);
    expect_end<DubowskyFreudenstein>(line * kWidth * kWidth / radius, kWidth * kWidth / radius, clearance);
    const LawEnd persson = Persson{}.find_end(make_contact(1e-6, clearance));
    EXPECT_NEAR(persson.penetration, 10.093 * clearance, 1e-3 * clearance);
    EXPECT_EQ(persson.force, std::numeric_limits<double>::infinity());
  }
}

TEST(CylindricalLaw, SolvesTheLogDifference) {
  for (const double t : {1.001, 1.1, 1.9, 3.0, 10.0, 40.0, 700.0}) {
    const double tolerance = 1e-15 * t * t / (t - 1.0);  // rounding of t − ln t over its slope
    EXPECT_NEAR(solve_log_difference(t - std::log(t)), t, tolerance);
  }
}

TEST(Liu, IsHertzsPressureOverItsArc) {
  for (const double penetration : {1e-6, 1e-5, 1e-4, 2e-3}) {
    const double clearance = 0.5e-3;
    const double arc = std::acos(clearance / (clearance + penetration));
    const double radius = kBearingRadius;
    const double peak = kModulus * penetration / (2.0 * radius);
    const double force = 0.5 * kPi * peak * 2.0 * radius * std::sin(0.5 * arc) * kWidth;  // of a half ellipse
    EXPECT_NEAR(Liu{}(make_contact(penetration, clearance)).force, force, 1e-9 * force);  // arccos near 1
  }
}

TEST(Liu, HasOneEnergyOnBothSidesOfItsSwitch) {
  EXPECT_NEAR(integrate_liu(0.05 * (1.0 - 1e-15)), integrate_liu(0.05), 1e-12 * integrate_liu(0.05));
  EXPECT_NEAR(integrate_liu(1e-8), 0.4e-20, 1e-28);
}

TEST(BaiZhao, HasThePublishedStiffness) {
  for (const double penetration : {1e-7, 1e-5, 5e-4}) {
    const double clearance = 0.5e-3;
    const double sum = clearance + penetration;
    const double gap = 3.0 * clearance + 2.0 * penetration;
    const double stiffness =
        kPi / 8.0 * kModulus * kWidth * std::sqrt(2.0 * penetration * gap * gap / (sum * sum * sum));
    const double step = 1e-5 * penetration;
    const auto force = [&](double d) { return BaiZhao{}(make_contact(d, clearance)).elastic_force; };
    const double slope = (force(penetration + step) - force(penetration - step)) / (2.0 * step);
    EXPECT_NEAR(slope, stiffness, 1e-9 * stiffness);  // the step squared
  }
}

TEST(Persson, IsHertzsLineContactForALightLoad) {
  // Hertz's half width and the arc on which the circles overlap agree.
  const double clearance = 2e-3;
  const double penetration = 1e-9;
  const double load = Persson{}(make_contact(penetration, clearance)).force / kWidth;
  EXPECT_NEAR(load, 0.5 * kPi * kModulus * penetration, 1e-6 * load);
  const double arc = std::acos(clearance / (clearance + penetration));
  const double relative = std::sqrt(clearance / (kBearingRadius * (kBearingRadius - clearance)));
  // a = R ε for radii that nearly agree; here by the mean √(R_i R_j)
  EXPECT_NEAR(half_width(load, clearance),
              arc * clearance / (relative * relative) / std::sqrt(kBearingRadius * (kBearingRadius - clearance)),
              1e-6 * half_width(load, clearance));
}

// A disc in a hole of its own radius but for ΔR, both elastic alike and without friction: a pressure p = Σ p_n cos nθ
// parts their surfaces by R/E* [p_0 + Σ_{n>=2} 2n/(n² − 1) p_n cos nθ] (Michell), which must be Δ cos θ − ΔR on the
// arc.
double find_conforming_load(double arc) {  // over E* ΔR
  constexpr int kTerms = 8;
  constexpr int kSteps = 2000;
  constexpr int kHarmonics = 3000;
  constexpr int kPoints = 40;
  // p is √(cos θ − cos ε) by powers of itself, at midpoints of u in sin(θ/2) = sin(ε/2) sin u.
  Eigen::ArrayXd angle(kSteps);
  Eigen::MatrixXd weight(kSteps, kTerms);
  for (int m = 0; m < kSteps; ++m) {
    const double u = 0.5 * kPi * (m + 0.5) / kSteps;
    const double s = std::sin(0.5 * arc) * std::sin(u);
    const double c = std::sin(0.5 * arc) * std::cos(u);
    angle(m) = 2.0 * std::asin(s);
    for (int k = 0; k < kTerms; ++k) {
      weight(m, k) = std::pow(std::cos(u), 2 * k) * 2.0 * c * c / std::sqrt(1.0 - s * s) * 0.5 * kPi / kSteps;
    }
  }
  const Eigen::ArrayXd place = arc * (Eigen::ArrayXd::LinSpaced(kPoints, 0.5, kPoints - 0.5)) / kPoints;
  Eigen::MatrixXd gap(kPoints, kTerms + 1);
  gap.leftCols(kTerms).rowwise() = weight.colwise().sum() / kPi;
  for (int n = 2; n < kHarmonics; ++n) {
    const Eigen::RowVectorXd harmonic = 2.0 / kPi * (angle * n).cos().matrix().transpose() * weight;
    gap.leftCols(kTerms) += 2.0 * n / (n * n - 1.0) * (place * n).cos().matrix() * harmonic;
  }
  gap.col(kTerms) = -place.cos().matrix();
  const Eigen::VectorXd solution = gap.colPivHouseholderQr().solve(Eigen::VectorXd::Constant(kPoints, -1.0));
  return (2.0 * angle.cos().matrix().transpose() * weight).dot(solution.head(kTerms));
}

TEST(Persson, SolvesTheConformingContact) {
  for (const double degrees : {20.0, 50.0, 70.0, 80.0}) {
    const double arc = degrees * kPi / 180.0;
    const double clearance = 0.5e-3;
    const NormalContact contact = make_contact(clearance / std::cos(arc) - clearance, clearance);
    const double expected = kModulus * clearance * find_conforming_load(arc) * kWidth;
    EXPECT_NEAR(Persson{}(contact).force, expected, 3e-5 * expected) << degrees;  // harmonics beyond the last
  }
}

TEST(Persson, EndsWhereItsForceIsInfinite) {
  EXPECT_NEAR(2.0 - std::log1p(kPerssonLimit) - 2.0 * kPerssonLimit * kPerssonLimit, 0.0, 1e-15);
  const double clearance = 0.5e-3;
  EXPECT_GT(Persson{}(make_contact(10.09 * clearance, clearance)).force, 0.0);
  EXPECT_TRUE(std::isnan(Persson{}(make_contact(10.1 * clearance, clearance)).force));
}

TEST(Persson, IntegratesItsEnergy) {
  // Midpoints refined far beyond the Gauss points, over δ.
  const double clearance = 0.5e-3;
  for (const double end : {0.5, 0.84, 0.88, 5.0, 9.9}) {  // in ΔR; the residue joins at b² = 0.3, δ = 0.857 ΔR
    constexpr int kSteps = 100000;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
      const auto force = [&](double share) {
        return Persson{}(make_contact((i + share) / kSteps * end * clearance, clearance)).force;
      };
      const double root = std::sqrt(0.6);  // three Gauss points
      sum += (5.0 * force(0.5 - 0.5 * root) + 8.0 * force(0.5) + 5.0 * force(0.5 + 0.5 * root)) / 18.0;
    }
    const double energy = sum * end * clearance / kSteps;
    EXPECT_NEAR(Persson{}(make_contact(end * clearance, clearance)).elastic_energy, energy, 2e-11 * energy)
        << end;  // 16 Gauss points
  }
}

TEST(Persson, IsStifferThanLiuByTheArc) {
  const double clearance = 0.5e-3;
  const double arc = std::acos(1.0 / 1.001);
  const NormalContact contact = make_contact(1e-3 * clearance, clearance);
  const double ratio = Liu{}(contact).force / Persson{}(contact).force;
  EXPECT_NEAR(ratio, std::sin(0.5 * arc), 1e-3 * ratio);  // to first order in δ/ΔR
}

TEST(Pereira, HasItsValueInMillimetres) {
  // ΔR = 0.5 mm: n = (0.0151·0.5 + 1.151)·0.5^(−0.005); δ = 0.01 mm, w = 20 mm, E* = 110 000 MPa.
  const double wide = std::pow(0.5, -0.005) * 1.15855;
  EXPECT_NEAR(Pereira{}(make_contact(1e-5, 0.5e-3)).force,
              (0.965 * 0.5 + 0.0965) * 20.0 * 110000.0 / 0.5 * std::pow(0.01, wide), 1e-6);
  // ΔR = 0.05 mm: Y = 1.51 (ln 50)^(−0.151).
  const double tight = std::pow(0.05, -0.005) * 1.51 * std::pow(std::log(50.0), -0.151);
  EXPECT_NEAR(Pereira{}(make_contact(1e-5, 0.05e-3)).force,
              (0.965 * 0.05 + 0.0965) * 20.0 * 110000.0 / 0.05 * std::pow(0.01, tight), 1e-6);
}

TEST(Pereira, HardlyStepsWhereItsBranchesMeet) {
  const double below = Pereira{}(make_contact(1e-5, 0.349539e-3)).force;
  const double above = Pereira{}(make_contact(1e-5, 0.349541e-3)).force;
  EXPECT_NEAR(below, above, 1e-3 * above);  // Y differs by 1e-4 and stands over ln(0.01) = −4.6
}

}  // namespace
}  // namespace gudgeon
