// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Least squares of eccentricities within the positions that the ideal joints permit.
#include "gudgeon/system/play_start.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "gudgeon/system/closure_rank.h"
#include "gudgeon/system/loop_closer.h"
#include "gudgeon/system/loose_start.h"
#include "gudgeon/system/poses.h"
#include "gudgeon/system/start_rates.h"
#include "gudgeon/system/system.h"

namespace gudgeon {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// [shares of the clearance] What is off the middle by less is rounding of what was given.
constexpr double kClearlyOff = 1e-2;
// [rad, m] Values that differ by less are the same number written twice.
constexpr double kSameValue = 1e-9;
constexpr int kMostPlaySteps = 100;
// [rad, m] Least squares have settled.
constexpr double kSettledPlay = 1e-14;

// A body that a guide holds and no other ideal joint.
bool hangs_on_guide(const Mechanism& mechanism, int body) {
  int n_guides = 0;
  int n_others = 0;
  for (const Joint& joint : mechanism.joints) {
    if (has_clearance(joint.kind)) continue;
    const auto [first, second] = anchors(joint.kind);
    const std::string& name = mechanism.bodies[body].name;
    if (first.body != name && second.body != name) continue;
    ++(std::holds_alternative<Prismatic>(joint.kind) ? n_guides : n_others);
  }
  return n_guides == 1 && n_others == 0;
}

// Whether a start value says where on its guide such a body is.
bool places_on_guide(const Mechanism& mechanism, const GivenStart& given) {
  if (given.kind == GivenStart::Kind::angle) return false;
  if (given.kind != GivenStart::Kind::displacement) return hangs_on_guide(mechanism, given.index);
  const auto [first, second] = anchors(mechanism.joints[given.index].kind);
  return hangs_on_guide(mechanism, find_body(mechanism, first.body)) ||
         hangs_on_guide(mechanism, find_body(mechanism, second.body));
}

class PlayStart {
 public:
  PlayStart(const Mechanism& mechanism, double time, const Assembly& from)
      : system_{mechanism, find_topology(mechanism), {}},
        tables_(system_.tables = compile_tables(mechanism, system_.topology)),
        closer_(system_.mechanism, system_.topology, system_.tables, time) {
    const State state = make_state(system_, from);
    closer_.q = VectorXd::Map(state.q.data(), static_cast<Index>(state.q.size()));
    start_ = closer_.q;
  }

  /// Ideal joints closed and given values had, journals as near to the middle as can be; false when joints stay open.
  bool close(const std::vector<GivenStart>& given) {
    closer_.q = start_;
    if (!closer_.close()) return false;
    if (start_.size() == 0) return true;  // drivers prescribe everything
    pinned_ = closer_.select_free(given);
    if (!closer_.close(pinned_)) return false;
    for (int iteration = 0; iteration < kMostPlaySteps; ++iteration) {
      const VectorXd step = find_step();
      closer_.q += step;
      closer_.update();
      if (step.size() == 0 || step.cwiseAbs().maxCoeff() <= kSettledPlay * std::max(1.0, closer_.size())) break;
    }
    return closer_.close(pinned_);
  }

  /// Displacements and places that are missed, behind all values that are had; none where nothing is missed.
  std::vector<GivenStart> list_missed_places() {
    closer_.q = start_;
    closer_.update();
    std::vector<GivenStart> had;
    std::vector<GivenStart> missed;
    for (const GivenStart& given : list_given_positions(system_.mechanism)) {
      const bool is_had = std::abs(find_way(given, closer_.find_quantity(given).value)) <= kSameValue;
      if (is_had) had.push_back(given);
      if (!is_had && places_on_guide(system_.mechanism, given)) missed.push_back(given);
    }
    if (missed.empty()) return missed;
    had.insert(had.end(), missed.begin(), missed.end());
    return had;
  }

  /// [shares of the clearance] How far the farthest journal is off the middle.
  [[nodiscard]] double find_farthest() const {
    double farthest = 0.0;
    for (const StartQuantity& gap : list_play()) farthest = std::max(farthest, std::abs(gap.value));
    return farthest;
  }

  void find_rates() {
    closer_.v.setZero();
    closer_.update();
    const std::vector<StartQuantity> gaps = list_play();
    WishedRates wished{make_matrix(gaps), VectorXd(static_cast<Index>(gaps.size()))};
    for (std::size_t k = 0; k < gaps.size(); ++k) wished.right(static_cast<Index>(k)) = -gaps[k].rate;
    closer_.v = find_start_rates(system_.mechanism, system_.topology, tables_, closer_.workspace,
                                 list_undriven_rates(system_.mechanism, system_.topology), wished);
  }

  std::vector<BodyPose> find_poses() {
    closer_.update();
    return gudgeon::find_poses(system_.mechanism, system_.topology, closer_.workspace.coordinates);
  }

 private:
  // From here to the least squares of the linearised gaps, closures and given values held.
  VectorXd find_step() {
    const MatrixXd closures = find_closure_jacobian(tables_, closer_.workspace);
    const auto n_pinned = static_cast<Index>(pinned_.size());
    MatrixXd held(closures.rows() + n_pinned, closer_.q.size());
    VectorXd right(held.rows());
    held.topRows(closures.rows()) = closures;
    right.head(closures.rows()) = -find_closure_gaps(closer_.workspace);
    for (Index k = 0; k < n_pinned; ++k) {
      const GivenStart& given = pinned_[static_cast<std::size_t>(k)];
      const StartQuantity quantity = closer_.find_quantity(given);
      held.row(closures.rows() + k) = quantity.make_row(closer_.q.size());
      right(closures.rows() + k) = find_way(given, quantity.value);
    }
    const std::vector<StartQuantity> gaps = list_play();
    VectorXd wished(static_cast<Index>(gaps.size()));
    for (std::size_t k = 0; k < gaps.size(); ++k) wished(static_cast<Index>(k)) = -gaps[k].value;
    return solve_in_order(held, right, make_matrix(gaps), wished);
  }

  [[nodiscard]] MatrixXd make_matrix(const std::vector<StartQuantity>& quantities) const {
    MatrixXd matrix(static_cast<Index>(quantities.size()), closer_.q.size());
    if (matrix.size() == 0) return matrix;
    for (std::size_t k = 0; k < quantities.size(); ++k) {
      matrix.row(static_cast<Index>(k)) = quantities[k].make_row(closer_.q.size());
    }
    return matrix;
  }

  // How far every journal is off the middle of its bearing, in shares of the clearance.
  [[nodiscard]] std::vector<StartQuantity> list_play() const {
    std::vector<StartQuantity> gaps;
    for (const Joint& joint : system_.mechanism.joints) {
      std::visit([&](const auto& kind) { add_play(kind, gaps); }, joint.kind);
    }
    return gaps;
  }

  void add_play(const auto&, std::vector<StartQuantity>&) const {}

  void add_play(const RevoluteClearance& joint, std::vector<StartQuantity>& gaps) const {
    for (const Vec2 direction : {Vec2{1.0, 0.0}, Vec2{0.0, 1.0}}) {
      add(find_gap(joint, direction), 1.0 / joint.radial_clearance, gaps);
    }
  }

  void add_play(const PinInSlotClearance& joint, std::vector<StartQuantity>& gaps) const {
    add(find_gap(joint, find_across(joint.direction)), 1.0 / joint.clearance, gaps);
  }

  // A tilted block is off by what its ends are.
  void add_play(const PrismaticClearance& joint, std::vector<StartQuantity>& gaps) const {
    add(find_gap(joint, find_across(joint.direction)), 1.0 / joint.clearance, gaps);
    const int bearing = find_body(system_.mechanism, joint.bearing.body);
    const int journal = find_body(system_.mechanism, joint.journal.body);
    const Coordinates& at = closer_.workspace.coordinates;
    StartQuantity tilt = find_angle(system_.topology, journal, at);
    const StartQuantity against = find_angle(system_.topology, bearing, at);
    tilt.value -= against.value + joint.relative_angle;
    tilt.value = std::remainder(tilt.value, 2.0 * std::numbers::pi);
    tilt.rate -= against.rate;
    for (const auto& [coordinate, derivative] : against.gradient) tilt.gradient.emplace_back(coordinate, -derivative);
    add(tilt, 0.5 * joint.journal_length / joint.clearance, gaps);
  }

  static Vec2 find_across(double direction) {
    const Rotation line = make_rotation(direction);
    return {-line.s, line.c};
  }

  template <ClearanceJoint Kind>
  [[nodiscard]] StartQuantity find_gap(const Kind& joint, Vec2 direction) const {
    const auto find_local = [&](const Anchor& anchor) {
      const Body& body = system_.mechanism.bodies[find_body(system_.mechanism, anchor.body)];
      return find_point(body, anchor.point)->position;
    };
    const int bearing = find_body(system_.mechanism, joint.bearing.body);
    const int journal = find_body(system_.mechanism, joint.journal.body);
    const DirectedWay way{bearing, find_local(joint.bearing), journal, find_local(joint.journal), bearing, direction};
    return find_quantity(system_.topology, way, closer_.workspace.coordinates);
  }

  static void add(StartQuantity gap, double scale, std::vector<StartQuantity>& gaps) {
    gap.value *= scale;
    gap.rate *= scale;
    for (auto& entry : gap.gradient) entry.second *= scale;
    gaps.push_back(std::move(gap));
  }

  System system_;
  Tables& tables_;
  LoopCloser closer_;
  VectorXd start_;
  std::vector<GivenStart> pinned_;
};

}  // namespace

bool close_within_play(const Mechanism& mechanism, double time, Assembly& assembly) {
  PlayStart start(mechanism, time, assembly);
  Assembly found = assembly;
  for (const auto& given : {list_given_positions(mechanism), std::vector<GivenStart>{}}) {
    if (!start.close(given)) continue;
    found.poses = start.find_poses();
    if (!lies_within_play(mechanism, found)) continue;
    start.find_rates();
    assembly.poses = start.find_poses();
    return true;
  }
  return false;
}

bool shift_within_play(const Mechanism& mechanism, double time, Assembly& assembly) {
  const std::vector<GivenStart> all = list_given_positions(mechanism);
  if (std::ranges::none_of(all, [&](const GivenStart& one) { return places_on_guide(mechanism, one); })) return false;
  PlayStart start(mechanism, time, assembly);
  const std::vector<GivenStart> given = start.list_missed_places();
  if (given.empty() || !start.close(given) || !(start.find_farthest() > kClearlyOff)) return false;
  Assembly found = assembly;
  found.poses = start.find_poses();
  if (!lies_within_play(mechanism, found)) return false;
  start.find_rates();
  assembly.poses = start.find_poses();
  return true;
}

bool move_within_play(const Mechanism& mechanism, double time, Assembly& assembly) {
  PlayStart start(mechanism, time, assembly);
  try {
    start.find_rates();
  } catch (const ModelError&) {
    return false;
  }
  const std::vector<BodyPose> poses = start.find_poses();
  for (std::size_t b = 0; b < poses.size(); ++b) {
    assembly.poses[b].velocity = poses[b].velocity;
    assembly.poses[b].angle_rate = poses[b].angle_rate;
  }
  return true;
}

}  // namespace gudgeon
