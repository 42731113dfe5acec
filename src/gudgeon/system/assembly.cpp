// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Gauss-Newton on the loop closures of the ideal mechanism, from the guessed angles and displacements.
#include "gudgeon/system/assembly.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "gudgeon/system/branches.h"
#include "gudgeon/system/closure_rank.h"
#include "gudgeon/system/dynamics.h"
#include "gudgeon/system/loop_folds.h"
#include "gudgeon/system/loose_start.h"
#include "gudgeon/system/poses.h"
#include "gudgeon/system/start_rates.h"

namespace gudgeon {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Closed is when the largest gap is at rounding of the mechanism's size.
constexpr double kClosedShare = 1e-13;
constexpr int kMostIterations = 200;
// [rad] Angles that differ by less are the same number written twice.
constexpr double kSameGuess = 1e-9;

double find_turn(double from, double to) { return std::remainder(to - from, 2.0 * std::numbers::pi); }

class Assembler {
 public:
  Assembler(const Mechanism& mechanism, double time)
      : mechanism_(make_ideal(mechanism)),
        time_(time),
        topology_(find_topology(mechanism_)),
        tables_(compile_tables(mechanism_, topology_)),
        folds_(mechanism_, topology_, tables_),
        workspace_(tables_),
        q_(VectorXd::Zero(tables_.counts.n_free())),
        v_(VectorXd::Zero(tables_.counts.n_free())) {
    for (const ClosureTerm& term : tables_.closure_terms) size_ = std::max(size_, norm(term.vector));
    for (const ClosureRows& rows : tables_.closures) {
      if (rows.kind == ClosureKind::angle) size_ = std::max(size_, 1.0);
    }
  }

  Assembly assemble() {
    const std::vector<double> guesses = make_guess();
    if (!close_loops()) throw_open_loop();
    settle_branches();
    update();
    v_ = find_start_rates(mechanism_, topology_, tables_, workspace_);
    Assembly assembly;
    update();
    assembly.poses = find_poses(mechanism_, topology_, workspace_.coordinates);
    assembly.branches = find_branches();
    assembly.closure_residual = tables_.closures.empty() ? 0.0 : find_closure_gaps(workspace_).cwiseAbs().maxCoeff();
    for (std::size_t b = 0; b < guesses.size(); ++b) {
      const double given = mechanism_.bodies[b].start.angle.value_or(guesses[b]);
      assembly.angle_changes.push_back(find_turn(given, assembly.poses[b].angle));
      if (std::abs(find_turn(guesses[b], given)) > kSameGuess) assembly.held_bodies.push_back(static_cast<int>(b));
    }
    return assembly;
  }

 private:
  void update() {
    update_coordinates(tables_, time_, q_.data(), v_.data(), workspace_.coordinates);
    update_closures(tables_, workspace_);
  }

  // Fills q_; returns the guessed angle of every body.
  std::vector<double> make_guess() {
    const CoordinateCounts& counts = tables_.counts;
    std::vector<bool> given(counts.n_turns(), false);
    for (std::size_t b = 1; b < mechanism_.bodies.size(); ++b) {
      const BodyNode& node = topology_.bodies[b];
      const auto& angle = mechanism_.bodies[b].start.angle;
      if (node.turn >= counts.n_free_turns || !angle || given[node.turn]) continue;
      q_(node.turn) = *angle - node.offset;
      given[node.turn] = true;
    }
    for (int s = 0; s < counts.n_free_slides; ++s) {
      if (const int joint = topology_.free_slide_joint[s]; joint >= 0) {
        q_(counts.n_free_turns + s) =
            std::get<Prismatic>(mechanism_.joints[joint].kind).start_displacement.value_or(0.0);
      }
    }
    update();
    guess_driven_angles(given);
    for (const auto& [body, slide] : topology_.loose) {
      const Body& description = mechanism_.bodies[body];
      const double angle = workspace_.coordinates.angle[topology_.bodies[body].turn] + topology_.bodies[body].offset;
      const Vec2 centre =
          description.start.position.value_or(Vec2{}) + make_rotation(angle) * description.center_of_mass;
      q_(counts.n_free_turns + slide) = centre.x;
      q_(counts.n_free_turns + slide + 1) = centre.y;
    }
    update();
    std::vector<double> guesses;
    for (const BodyNode& node : topology_.bodies)
      guesses.push_back(workspace_.coordinates.angle[node.turn] + node.offset);
    return guesses;
  }

  // Drivers between two moving bodies say where one of them is once the other is known.
  void guess_driven_angles(std::vector<bool>& given) {
    const CoordinateCounts& counts = tables_.counts;
    const auto is_known = [&](int turn) { return turn >= counts.n_free_turns || given[turn]; };
    // Bodies may hang on each other's angles; the last pass settles for one that nobody gave.
    const std::size_t n_passes = tables_.closures.size() + 1;
    for (std::size_t pass = 0; pass < n_passes; ++pass) {
      for (const ClosureRows& rows : tables_.closures) {
        if (rows.kind != ClosureKind::angle) continue;
        const auto& [body, against] = rows.angle_turn;
        if (pass + 1 == n_passes && !is_known(body) && !is_known(against)) given[against] = true;
        if (is_known(body) == is_known(against)) continue;
        const Coordinates& at = workspace_.coordinates;
        const double asked = at.driven[rows.driver].value;
        const int guessed = is_known(body) ? against : body;
        q_(guessed) = is_known(body) ? at.angle[body] - asked : at.angle[against] + asked;
        given[guessed] = true;
        update();
      }
    }
  }

  // Each step is the least change of the coordinates that closes the linearised loops, shortened so that no body turns
  // by more than half a radian and the gaps shrink.
  bool close_loops() {
    if (tables_.closures.empty()) return true;
    update();
    double error = find_closure_gaps(workspace_).norm();
    for (int iteration = 0; iteration < kMostIterations; ++iteration) {
      if (error <= kClosedShare * size_) return true;
      if (q_.size() == 0) return error <= 100.0 * kClosedShare * size_;  // drivers hold everything
      const MatrixXd jacobian = find_closure_jacobian(tables_, workspace_);
      Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
      solver.setThreshold(kRankThreshold);
      solver.compute(jacobian);
      const VectorXd step = solver.solve(-find_closure_gaps(workspace_));
      const double largest = step.size() > 0 ? step.cwiseAbs().maxCoeff() : 0.0;
      double share = largest > 0.5 ? 0.5 / largest : 1.0;
      const VectorXd start = q_;
      bool shrunk = false;
      for (int attempt = 0; attempt < 30 && !shrunk; ++attempt, share *= 0.5) {
        q_ = start + share * step;
        update();
        shrunk = find_closure_gaps(workspace_).norm() < error;
      }
      const double closed = find_closure_gaps(workspace_).norm();
      if (!shrunk) {
        q_ = start;
        update();
        return error <= 100.0 * kClosedShare * size_;  // rounding stops progress just above the aim
      }
      error = closed;
    }
    return false;
  }

  [[noreturn]] void throw_open_loop() {
    Diagnostics diagnostics;
    double widest = 0.0;
    for (const Vec2 gap : workspace_.closure_gap) widest = std::max(widest, norm(gap));
    // Gaps far below any length are named only where there are no others.
    const double least = std::min(1e-9 * size_, 0.5 * widest);
    for (std::size_t c = 0; c < tables_.closures.size(); ++c) {
      const double gap = norm(workspace_.closure_gap[c]);
      if (gap <= least) continue;
      if (tables_.closures[c].kind == ClosureKind::angle) {
        add_missed_angle(tables_.closures[c], gap, diagnostics);
        continue;
      }
      const Joint& joint = mechanism_.joints[tables_.closures[c].joint];
      const auto [first, second] = anchors(joint.kind);
      diagnostics.error("E-MODEL-070", "joints." + joint.name,
                        fmt::format("joint '{}' cannot be closed: {}.{} and {}.{} stay {:.6g} mm apart", joint.name,
                                    first.body, first.point, second.body, second.point, 1e3 * gap),
                        {"check lengths and pivots, or give start angles nearer to a position that closes"});
    }
    throw ModelError(diagnostics);
  }

  void add_missed_angle(const ClosureRows& rows, double gap, Diagnostics& diagnostics) const {
    const Driver& driver = mechanism_.drivers[tables_.driven[rows.driver].driver];
    const auto& angle = std::get<DrivenAngle>(driver.target);
    diagnostics.error("E-MODEL-070", "drivers." + driver.name,
                      fmt::format("driver '{}' cannot be followed: the angle of '{}' against '{}' stays {:.6g} deg off",
                                  driver.name, angle.body, angle.against, gap * 180.0 / std::numbers::pi),
                      {"check its start, lengths and pivots, or remove a driver that contradicts it"});
  }

  // One a joint that closes a loop, in the order of the closures.
  std::vector<LoopBranch> find_branches() const {
    std::vector<LoopBranch> branches;
    for (const LoopFold& fold : folds_.list_by_closure()) {
      const Joint& joint = find_joint_of(fold);
      const auto [first, second] = anchors(joint.kind);
      branches.push_back({joint.name, first.body, second.body, folds_.find_angle(fold, workspace_.coordinates).sine});
    }
    return branches;
  }

  const Joint& find_joint_of(const LoopFold& fold) const {
    return mechanism_.joints[tables_.closures[fold.closure].joint];
  }

  // Mirrors each loop that folds to the other side than asked for, and closes all of them again.
  void settle_branches() {
    require_closing_branches(mechanism_, topology_);
    update();
    for (const LoopFold& fold : folds_.folds()) {
      const Coordinates& at = workspace_.coordinates;
      if (is_on_branch(find_joint_of(fold), folds_.find_angle(fold, at)) || !folds_.mirror(fold, at, q_.data()))
        continue;
      update();
      if (!close_loops()) throw_open_loop();
    }
    require_branches(mechanism_, tables_, folds_, workspace_.coordinates);
  }

  Mechanism mechanism_;
  double time_;
  Topology topology_;
  Tables tables_;
  LoopFolds folds_;
  Workspace workspace_;
  VectorXd q_;
  VectorXd v_;
  double size_ = 0.0;  // longest vector of any closure [m]
};

}  // namespace

Assembly assemble(const Mechanism& mechanism, double time) {
  Assembly assembly = Assembler(mechanism, time).assemble();
  place_loose_bodies(mechanism, assembly);
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    const auto& given = mechanism.bodies[b].start.angle;
    if (given) assembly.angle_changes[b] = find_turn(*given, assembly.poses[b].angle);
  }
  std::erase_if(assembly.held_bodies, [&](int b) { return std::abs(assembly.angle_changes[b]) <= kSameGuess; });
  return assembly;
}

}  // namespace gudgeon
