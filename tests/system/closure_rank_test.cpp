// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The closure Jacobian against finite differences of gaps and rates, and the rank of rows.
#include "gudgeon/system/closure_rank.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "gudgeon/system/dynamics.h"
#include "gudgeon/system/sparse_closures.h"
#include "gudgeon/system/system.h"
#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using testing::ElementsAre;

using Active = std::array<bool, 2>;

// Positions off the closed ones as well: a line's turning normal counts only where there is a gap.
class ClosuresOfMechanism : public testing::TestWithParam<Mechanism> {
 protected:
  ClosuresOfMechanism() {
    std::mt19937 random(17);
    std::uniform_real_distribution<double> uniform(-0.4, 0.4);
    for (Index k = 0; k < q.size(); ++k) q(k) = start.q[static_cast<std::size_t>(k)] + uniform(random);
    for (Index k = 0; k < v.size(); ++k) v(k) = 5.0 * uniform(random);
  }

  void update(const VectorXd& position, const VectorXd& rates) {
    update_coordinates(system.tables, 0.03, position.data(), rates.data(), workspace.coordinates);
    update_closures(system.tables, workspace);
  }

  System system = compile(GetParam(), assemble(GetParam()));
  Workspace workspace{system.tables};
  State start = make_state(system, assemble(GetParam()));
  VectorXd q{static_cast<Index>(start.q.size())};
  VectorXd v{static_cast<Index>(start.q.size())};
};

TEST_P(ClosuresOfMechanism, JacobianIsTheDerivativeOfTheGaps) {
  update(q, v);
  const MatrixXd jacobian = find_closure_jacobian(system.tables, workspace);
  ASSERT_EQ(jacobian.rows(), 2 * static_cast<Index>(system.tables.closures.size()));
  ASSERT_EQ(jacobian.cols(), q.size());
  constexpr double kStep = 1e-5;
  for (Index k = 0; k < q.size(); ++k) {
    update(q + kStep * VectorXd::Unit(q.size(), k), v);
    const VectorXd after = find_closure_gaps(workspace);
    update(q - kStep * VectorXd::Unit(q.size(), k), v);
    const VectorXd difference = (after - find_closure_gaps(workspace)) / (2.0 * kStep);
    for (Index row = 0; row < difference.size(); ++row) {
      // Lengths of order one: the step squared, and rounding over the step.
      EXPECT_NEAR(jacobian(row, k), difference(row), 1e-9) << "row " << row << ", column " << k;
    }
  }
}

TEST_P(ClosuresOfMechanism, RatesAreThoseOfJacobianAndDrivers) {
  update(q, VectorXd::Zero(v.size()));
  const VectorXd driven = find_closure_rates(workspace);
  update(q, v);
  const VectorXd expected = find_closure_jacobian(system.tables, workspace) * v + driven;
  const VectorXd rates = find_closure_rates(workspace);
  for (Index row = 0; row < rates.size(); ++row) EXPECT_NEAR(rates(row), expected(row), 1e-13 * (1.0 + v.norm()));
}

INSTANTIATE_TEST_SUITE_P(AllMechanisms, ClosuresOfMechanism, testing::ValuesIn(oracle::make_all_mechanisms()),
                         [](const auto& mechanism) {
                           return mechanism.param.name + "_" + std::to_string(mechanism.index);
                         });

TEST(RowRank, PrefersEarlierRows) {
  const Mechanism mechanism = oracle::make_parallelogram();
  const Tables tables = compile_tables(mechanism, find_topology(mechanism));
  MatrixXd jacobian(4, 4);
  jacobian << 1, 2, 0, 0,  //
      2, 4, 0, 0,          // twice the first
      0, 0, 3, 1,          //
      1, 2, 3, 1;          // the sum of the first and third
  const RowRank rank = find_row_rank(tables, RowSpace(jacobian.sparseView()));
  EXPECT_EQ(rank.rank, 2);
  EXPECT_THAT(rank.active, ElementsAre(Active{true, false}, Active{true, false}));
}

TEST(RowRank, CountsASmallButRealRow) {
  const Mechanism mechanism = oracle::make_parallelogram();
  const Tables tables = compile_tables(mechanism, find_topology(mechanism));
  MatrixXd jacobian = MatrixXd::Identity(4, 4);
  jacobian(3, 3) = 10.0 * kRankThreshold;
  EXPECT_EQ(find_row_rank(tables, RowSpace(jacobian.sparseView())).rank, 4);
  jacobian(3, 3) = 0.1 * kRankThreshold;
  EXPECT_EQ(find_row_rank(tables, RowSpace(jacobian.sparseView())).rank, 3);
}

TEST(RowRank, IgnoresTheSecondRowOfALine) {
  const Mechanism mechanism = oracle::make_slider_crank();
  const Tables tables = compile_tables(mechanism, find_topology(mechanism));
  const RowRank rank = find_row_rank(tables, RowSpace(MatrixXd(MatrixXd::Identity(2, 2)).sparseView()));
  EXPECT_EQ(rank.rank, 1);
  EXPECT_THAT(rank.active, ElementsAre(Active{true, false}));
}

}  // namespace
}  // namespace gudgeon
