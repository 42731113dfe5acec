// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The correction against its definition: it closes the loops and is the least one in the metric of the kinetic energy.
#include "gudgeon/sim/closure_projection.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <random>

#include "gudgeon/system/body_motion.h"
#include "gudgeon/system/closure_rank.h"
#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

constexpr double kTolerance = 1e-12;

class Projected {
 public:
  explicit Projected(const Mechanism& mechanism)
      : assembly(assemble(mechanism)),
        system(compile(mechanism, assembly)),
        equations(system, {}),
        y(equations.size(), 0.0),
        slope(equations.size(), 0.0) {
    const State state = make_state(system, assembly);
    std::ranges::copy(state.q, y.begin());
    std::ranges::copy(state.v, y.begin() + n_free());
    eval();
  }

  [[nodiscard]] std::ptrdiff_t n_free() const { return static_cast<std::ptrdiff_t>(equations.n_free()); }
  void eval() { equations.eval(0.0, y.data(), slope.data()); }
  int project() { return ClosureProjection(system.tables, kTolerance, kTolerance).project(0.0, y, slope, equations); }

  // Adds `size` times a fixed random direction to positions (first = 0) or rates.
  void perturb(std::ptrdiff_t first, double size) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (std::ptrdiff_t i = 0; i < n_free(); ++i) y[first + i] += size * uniform(random);
    eval();
  }

  [[nodiscard]] Eigen::Map<const Eigen::VectorXd> part(std::ptrdiff_t first) const {
    return {y.data() + first, n_free()};
  }

  // H by polarization of the kinetic energy of all bodies at the present positions.
  Eigen::MatrixXd find_mass_matrix() {
    BodyMotionFinder motion(system);
    std::vector<double> v(n_free(), 0.0);
    const auto energy = [&] {
      update_coordinates(system.tables, 0.0, y.data(), v.data(), equations.workspace.coordinates);
      return find_kinetic_energy(system.mechanism, motion.update(equations.workspace));
    };
    Eigen::MatrixXd mass(n_free(), n_free());
    for (std::ptrdiff_t i = 0; i < n_free(); ++i) {
      for (std::ptrdiff_t j = 0; j < n_free(); ++j) {
        v.assign(n_free(), 0.0);
        v[i] += 1.0, v[j] += 1.0;
        const double both = energy();
        v[j] = i == j ? 0.0 : -1.0;
        mass(i, j) = i == j ? 0.5 * both : 0.5 * (both - energy());
      }
    }
    eval();
    return mass;
  }

  Assembly assembly;
  System system;
  MotionEquations equations;
  std::vector<double> y;
  std::vector<double> slope;
};

// J x = −residual, and Nᵀ H x = 0 for all motions N that the loops allow: no smaller correction would do.
void expect_least_correction(Projected& at, const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residual,
                             const Eigen::MatrixXd& mass, const Eigen::VectorXd& correction) {
  const double size = correction.norm();
  ASSERT_GT(size, 0.0);
  // Elimination without pivoting on well-conditioned matrices: 1e-9 leaves six digits of room.
  EXPECT_LT((jacobian * correction + residual).norm(), 1e-9 * jacobian.norm() * size) << at.system.mechanism.name;
  const Eigen::MatrixXd null_space = jacobian.fullPivLu().kernel();
  const Eigen::VectorXd along = null_space.transpose() * mass * correction;
  EXPECT_LT(along.norm(), 1e-9 * mass.norm() * null_space.norm() * size) << at.system.mechanism.name;
}

std::vector<Mechanism> make_loops() {
  return {oracle::make_four_bar(), oracle::make_slider_crank(), oracle::make_five_bar(), oracle::make_n_four_bar(3),
          oracle::make_six_bar_slide()};
}

TEST(ClosureProjection, PositionsComeBackByTheLeastCorrection) {
  for (const Mechanism& mechanism : make_loops()) {
    Projected at(mechanism);
    at.perturb(0, 1e-5);
    std::fill(at.y.begin() + at.n_free(), at.y.end(), 0.0);  // at rest no rates need correction
    at.eval();
    const double gap_before = find_largest(at.equations.workspace.closure_gap);
    ASSERT_GT(gap_before, 1e-8) << mechanism.name;
    const Eigen::VectorXd residual = find_closure_gaps(at.equations.workspace);
    const Eigen::MatrixXd jacobian = find_closure_jacobian(at.system.tables, at.equations.workspace);
    const Eigen::MatrixXd mass = at.find_mass_matrix();
    const Eigen::VectorXd before = at.part(0);
    EXPECT_EQ(at.project(), 1) << mechanism.name;
    expect_least_correction(at, jacobian, residual, mass, at.part(0) - before);
    // One linear correction leaves the square of the perturbation, with arms of up to a metre.
    EXPECT_LT(find_largest(at.equations.workspace.closure_gap), 1e-8) << mechanism.name;
    at.project();
    EXPECT_LT(find_largest(at.equations.workspace.closure_gap), kTolerance) << mechanism.name;
    EXPECT_EQ(at.project(), 0) << mechanism.name;
  }
}

TEST(ClosureProjection, RatesComeBackByTheLeastCorrection) {
  for (const Mechanism& mechanism : make_loops()) {
    Projected at(mechanism);
    at.project();
    at.perturb(at.n_free(), 1e-3);
    const Eigen::VectorXd residual = find_closure_rates(at.equations.workspace);
    const Eigen::MatrixXd jacobian = find_closure_jacobian(at.system.tables, at.equations.workspace);
    const Eigen::MatrixXd mass = at.find_mass_matrix();
    const Eigen::VectorXd positions = at.part(0);
    const Eigen::VectorXd before = at.part(at.n_free());
    EXPECT_EQ(at.project(), 1) << mechanism.name;
    EXPECT_EQ(positions, at.part(0)) << mechanism.name << ": positions were closed";
    expect_least_correction(at, jacobian, residual, mass, at.part(at.n_free()) - before);
    // Rates are linear: one correction closes them to rounding.
    EXPECT_LT(find_largest(at.equations.workspace.closure_rate), 1e-13) << mechanism.name;
  }
}

TEST(ClosureProjection, SlopeBelongsToTheCorrectedState) {
  Projected at(oracle::make_four_bar());
  at.perturb(0, 1e-4);
  at.perturb(at.n_free(), 1e-2);
  EXPECT_EQ(at.project(), 2);
  std::vector<double> slope = at.slope;
  at.eval();
  EXPECT_EQ(slope, at.slope);
}

TEST(ClosureProjection, LeavesAloneWhatIsClosedOrHasNoLoop) {
  for (const Mechanism& mechanism : {oracle::make_four_bar(), oracle::make_pendulum_chain(3)}) {
    Projected at(mechanism);
    at.project();
    const std::vector<double> before = at.y;
    EXPECT_EQ(at.project(), 0);
    EXPECT_EQ(at.y, before);
  }
}

// Beside a singular position a gap along the bars, which a small turn hardly changes, would ask for a jump: posts at 1
// and 2 urad and the beam between them leave 1e-12 m, and want to turn by 1e-6. The state stays, and what was
// evaluated.
TEST(ClosureProjection, RefusesJumpsBesideASingularPosition) {
  Projected at(oracle::make_n_four_bar(1));
  std::ranges::fill(at.y, 0.0);
  for (const auto& [name, angle] : {std::pair{"post_0", 1e-6}, {"beam_1", 1e-6}, {"post_1", 2e-6}}) {
    at.y[at.system.topology.bodies[find_body(at.system.mechanism, name)].turn] = angle;
  }
  at.eval();
  const std::vector<double> before = at.y;
  const std::vector<double> equations = at.equations.workspace.equations;
  EXPECT_EQ(at.project(), 0);
  EXPECT_EQ(at.y, before);
  EXPECT_EQ(at.equations.workspace.equations, equations) << "accelerations, which recorders read afterwards";
}

TEST(ClosureProjection, LargestOfAllGaps) {
  EXPECT_EQ(find_largest({}), 0.0);
  EXPECT_DOUBLE_EQ(find_largest({{0.1, 0.0}, {-0.3, 0.4}, {0.0, 0.2}}), 0.5);
}

// What a projection leaves alone is closed all the same where it is asked for.
TEST(ClosureProjection, ClosesWhatIsWithinTolerance) {
  for (const Mechanism& mechanism : make_loops()) {
    Projected at(mechanism);
    at.perturb(0, 1e-12);
    at.eval();
    const double before = find_largest(at.equations.workspace.closure_gap);
    ClosureProjection projection(at.system.tables, 1.0, 1.0);
    EXPECT_FALSE(projection.is_needed(at.equations.workspace)) << mechanism.name;
    EXPECT_TRUE(ClosureProjection(at.system.tables, 0.1 * before, 1.0).is_needed(at.equations.workspace))
        << mechanism.name;
    EXPECT_EQ(projection.project(0.0, at.y, at.slope, at.equations), 0) << mechanism.name;
    EXPECT_GE(projection.close(0.0, at.y, at.slope, at.equations), 1) << mechanism.name;
    // Rounding of positions of a metre.
    EXPECT_LT(find_largest(at.equations.workspace.closure_gap), 2e-15) << mechanism.name;
  }
}

}  // namespace
}  // namespace gudgeon
