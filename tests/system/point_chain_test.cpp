// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Points along paths: position against plain sums, velocity and acceleration against finite differences, sharing.
#include "gudgeon/system/point_chain.h"

#include <gtest/gtest.h>

#include "tests/oracle/mechanisms.h"
#include "tests/system/smooth_motion.h"

namespace gudgeon {
namespace {

class ChainOfMechanism : public testing::TestWithParam<Mechanism> {
 protected:
  void SetUp() override {
    for (std::size_t b = 0; b < GetParam().bodies.size(); ++b) {
      for (const Point& point : GetParam().bodies[b].points) add_path(static_cast<int>(b), point.position);
      add_path(static_cast<int>(b), {0.31, -0.17});
    }
  }

  void add_path(int body, Vec2 local) {
    paths.push_back(topology.find_path(body, local));
    ends.push_back(chain.add(paths.back(), topology.counts));
  }

  [[nodiscard]] std::vector<PointChain::PointMotion> find_motions(double t) const {
    std::vector<PointChain::PointMotion> motions(chain.rows().size());
    chain.find_motions(motion.eval(t), motions.data());
    return motions;
  }

  Topology topology = find_topology(GetParam());
  SmoothMotion motion{topology.counts, 5};
  PointChain chain;
  std::vector<Path> paths;
  std::vector<int> ends;
};

constexpr double kChainStep = 1e-5;
// Third derivatives of these motions are below 1e3, times the step squared; rounding is 1e-16 over the step.
constexpr double kChainTolerance = 1e-7;

TEST_P(ChainOfMechanism, PositionsAreTheSumsOfTheirPaths) {
  for (const double t : {0.0, 0.7, 1.9}) {
    const Coordinates at = motion.eval(t);
    const auto motions = find_motions(t);
    for (std::size_t k = 0; k < paths.size(); ++k) {
      Vec2 sum;
      for (const Term& term : paths[k]) {
        const double c = std::cos(at.angle[term.turn]);
        const double s = std::sin(at.angle[term.turn]);
        sum +=
            at.slide[term.slide] * Vec2{c * term.vector.x - s * term.vector.y, s * term.vector.x + c * term.vector.y};
      }
      EXPECT_NEAR(norm(motions[ends[k]].position - sum), 0.0, 1e-14);  // sums of a few lengths of order one
    }
  }
}

TEST_P(ChainOfMechanism, VelocitiesAreDerivatives) {
  for (const double t : {0.1, 0.9, 2.3}) {
    const auto before = find_motions(t - kChainStep);
    const auto at = find_motions(t);
    const auto after = find_motions(t + kChainStep);
    for (std::size_t r = 0; r < at.size(); ++r) {
      const Vec2 difference = (0.5 / kChainStep) * (after[r].position - before[r].position);
      EXPECT_NEAR(norm(at[r].velocity - difference), 0.0, kChainTolerance) << "row " << r;
    }
  }
}

TEST_P(ChainOfMechanism, AccelerationsAreDerivatives) {
  for (const double t : {0.1, 0.9, 2.3}) {
    const auto before = find_motions(t - kChainStep);
    const auto after = find_motions(t + kChainStep);
    std::vector<Vec2> accelerations(chain.rows().size());
    chain.find_accelerations(motion.eval(t), find_motions(t).data(), motion.find_angle_accelerations(t).data(),
                             motion.find_slide_accelerations(t).data(), accelerations.data());
    for (std::size_t r = 0; r < accelerations.size(); ++r) {
      const Vec2 difference = (0.5 / kChainStep) * (after[r].velocity - before[r].velocity);
      EXPECT_NEAR(norm(accelerations[r] - difference), 0.0, kChainTolerance) << "row " << r;
    }
  }
}

TEST_P(ChainOfMechanism, AddingAgainAddsNothing) {
  const std::size_t n_rows = chain.rows().size();
  for (std::size_t k = 0; k < paths.size(); ++k) EXPECT_EQ(chain.add(paths[k], topology.counts), ends[k]);
  EXPECT_EQ(chain.rows().size(), n_rows);
  for (std::size_t r = 0; r < n_rows; ++r) EXPECT_LT(chain.rows()[r].predecessor, static_cast<int>(r));
}

INSTANTIATE_TEST_SUITE_P(AllMechanisms, ChainOfMechanism, testing::ValuesIn(oracle::make_all_mechanisms()),
                         [](const auto& mechanism) {
                           return mechanism.param.name + "_" + std::to_string(mechanism.index);
                         });

TEST(PointChain, SharesWhatPathsHaveInCommon) {
  const CoordinateCounts counts{2, 0, 0, 0};
  const Term base{2, 0, {1.0, 2.0}};
  PointChain chain;
  const int first = chain.add({base, {0, 0, {3.0, 0.0}}, {1, 0, {4.0, 0.0}}}, counts);
  const int second = chain.add({base, {0, 0, {3.0, 0.0}}, {1, 0, {5.0, 0.0}}}, counts);
  const int third = chain.add({base, {0, 0, {3.5, 0.0}}, {1, 0, {4.0, 0.0}}}, counts);
  EXPECT_EQ(chain.rows().size(), 6u);
  EXPECT_EQ(chain.rows()[first].predecessor, chain.rows()[second].predecessor);
  EXPECT_NE(chain.rows()[first].predecessor, chain.rows()[third].predecessor) << "equal terms after different ones";
}

TEST(PointChain, EmptyPathIsTheOrigin) {
  const CoordinateCounts counts{1, 0, 1, 0};
  PointChain chain;
  ASSERT_EQ(chain.add({}, counts), 0);
  std::vector<PointChain::PointMotion> motions(1);
  chain.find_motions(SmoothMotion(counts, 1).eval(0.4), motions.data());
  EXPECT_EQ(motions[0].position, (Vec2{0.0, 0.0}));
  EXPECT_EQ(motions[0].velocity, (Vec2{0.0, 0.0}));
}

}  // namespace
}  // namespace gudgeon
