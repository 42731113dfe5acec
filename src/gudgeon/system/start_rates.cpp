// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Least squares over closures and given rates.
#include "gudgeon/system/start_rates.h"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/system/closure_rank.h"

namespace gudgeon {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// One coordinate's rate, and where the description asks for it.
struct GivenRate {
  Index column;
  double rate;
  std::string path;
};

std::vector<GivenRate> collect_given_rates(const Mechanism& mechanism, const Topology& topology,
                                           const Coordinates& at) {
  const CoordinateCounts& counts = topology.counts;
  std::vector<GivenRate> given;
  for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
    const Body& body = mechanism.bodies[b];
    const BodyNode& node = topology.bodies[b];
    if (body.start.angle_rate && node.turn < counts.n_free_turns) {
      given.push_back({node.turn, *body.start.angle_rate, "bodies." + body.name + ".start.angle_rate"});
    }
  }
  for (int s = 0; s < counts.n_free_slides; ++s) {
    const int joint = topology.free_slide_joint[s];
    if (joint < 0) continue;
    const auto& speed = std::get<Prismatic>(mechanism.joints[joint].kind).start_speed;
    if (!speed) continue;
    given.push_back({counts.n_free_turns + s, *speed, "joints." + mechanism.joints[joint].name + ".start.speed"});
  }
  for (const auto& [body, slide] : topology.loose) {
    const Body& description = mechanism.bodies[body];
    if (!description.start.velocity) continue;
    const BodyNode& node = topology.bodies[body];
    const Vec2 arm = make_rotation(at.angle[node.turn] + node.offset) * description.center_of_mass;
    // A driven body's rate is its driver's; a free one's is zero so far.
    const Vec2 turning = description.start.angle_rate.value_or(at.angle_rate[node.turn]) * perp(arm);
    const Vec2 velocity = *description.start.velocity + turning;
    given.push_back({counts.n_free_turns + slide, velocity.x, "bodies." + description.name});
    given.push_back({counts.n_free_turns + slide + 1, velocity.y, "bodies." + description.name});
  }
  return given;
}

[[noreturn]] void throw_rate_conflict(const VectorXd& rest, const std::vector<GivenRate>& given) {
  Diagnostics diagnostics;
  for (std::size_t k = 0; k < given.size(); ++k) {
    diagnostics.error(
        "E-MODEL-071", given[k].path,
        fmt::format("start rates conflict: '{}' is missed by {:.3g} (SI)", given[k].path, rest(static_cast<Index>(k))),
        {"give as many start rates as the mechanism has degrees of freedom, no more"});
  }
  if (given.empty()) {
    diagnostics.error("E-MODEL-072", "", "the drivers ask for speeds that the joints do not permit here",
                      {"the start position is singular or the drivers contradict each other"});
  }
  throw ModelError(diagnostics);
}

}  // namespace

VectorXd find_start_rates(const Mechanism& mechanism, const Topology& topology, const Tables& tables,
                          const Workspace& workspace) {
  const std::vector<GivenRate> given = collect_given_rates(mechanism, topology, workspace.coordinates);
  const auto n_given = static_cast<Index>(given.size());
  const MatrixXd jacobian = find_closure_jacobian(tables, workspace);
  MatrixXd matrix = MatrixXd::Zero(jacobian.rows() + n_given, jacobian.cols());
  VectorXd right(matrix.rows());
  if (matrix.rows() == 0) return VectorXd::Zero(jacobian.cols());
  // With v = 0 the closure rates are what the drivers ask for.
  matrix.topRows(jacobian.rows()) = jacobian;
  right.head(jacobian.rows()) = -find_closure_rates(workspace);
  for (Index k = 0; k < n_given; ++k) {
    const GivenRate& rate = given[static_cast<std::size_t>(k)];
    matrix(jacobian.rows() + k, rate.column) = 1.0;
    right(jacobian.rows() + k) = rate.rate;
  }
  VectorXd rates(matrix.cols());
  if (rates.size() > 0) {
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
    solver.setThreshold(kRankThreshold);
    solver.compute(matrix);
    rates = solver.solve(right);
  }
  const VectorXd rest = matrix * rates - right;
  if (rest.cwiseAbs().maxCoeff() > 1e-9 * right.cwiseAbs().maxCoeff()) throw_rate_conflict(rest.tail(n_given), given);
  return rates;
}

}  // namespace gudgeon
