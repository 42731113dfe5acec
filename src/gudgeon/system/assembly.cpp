// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// From the guesses to closed loops of the ideal mechanism, on the branches asked for; then what clearance leaves free.
#include "gudgeon/system/assembly.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "gudgeon/system/assemblies.h"
#include "gudgeon/system/branches.h"
#include "gudgeon/system/closure_rank.h"
#include "gudgeon/system/compile_closures.h"
#include "gudgeon/system/loop_closer.h"
#include "gudgeon/system/loop_folds.h"
#include "gudgeon/system/loose_start.h"
#include "gudgeon/system/open_loop.h"
#include "gudgeon/system/play_start.h"
#include "gudgeon/system/poses.h"
#include "gudgeon/system/sparse_closures.h"
#include "gudgeon/system/start_rates.h"

namespace gudgeon {

namespace {

using Eigen::VectorXd;

// [rad] Angles that differ by less are the same number written twice.
constexpr double kSameGuess = 1e-9;
// A position is nearer to the guesses when the squares of its distances [rad, shares of the size] are less by this.
constexpr double kNearer = 1e-9;
// So often, and by such a share of a full turn or reach, it is looked beside a position that may be a dead centre.
constexpr int kLooksBeside = 4;
constexpr double kBeside = 0.05;
// Other starts that are tried where degrees of freedom are left, and there is no telling all assemblies.
constexpr int kScatteredStarts = 200;

double find_turn(double from, double to) { return std::remainder(to - from, 2.0 * std::numbers::pi); }

/// Bodies that nothing but clearance joints holds.
std::vector<bool> find_loose(const Mechanism& mechanism) {
  std::vector<bool> loose(mechanism.bodies.size(), false);
  for (const auto& [body, slide] : find_topology(mechanism).loose) loose[body] = true;
  return loose;
}

bool is_place(const GivenStart& given) {
  return given.kind == GivenStart::Kind::x || given.kind == GivenStart::Kind::y;
}

class Assembler {
 public:
  Assembler(const Mechanism& mechanism, double time)
      : mechanism_(make_ideal(mechanism)),
        topology_(find_topology(mechanism_)),
        tables_(compile_loops(mechanism_, topology_)),
        folds_(topology_, tables_),
        closer_(mechanism_, topology_, tables_, time),
        is_loose_(find_loose(mechanism)),
        given_(list_given_positions(mechanism_)) {
    // Bodies that clearance leaves loose are moved to their places afterwards.
    std::erase_if(given_, [&](const GivenStart& one) { return is_place(one) && is_loose_[one.index]; });
    guesses_ = make_guess();
    guessed_ = closer_.q;
  }

  /// Positions with closed loops, as near to the guesses as can be; false when there are none.
  bool close() {
    if (!close_from(guessed_) && !close_from_elsewhere()) return false;
    settle_branches();
    closer_.update();
    return true;
  }

  [[noreturn]] void throw_open() {
    if (mechanism_.drivers.size() > 1) throw_if_over_driven();
    throw_open_loop(mechanism_, tables_, closer_);
  }

  void find_rates() {
    closer_.v.setZero();
    closer_.update();
    std::vector<GivenStart> rates = list_undriven_rates(mechanism_, topology_);
    // What is loose gets its velocity with its place.
    std::erase_if(rates, [&](const GivenStart& one) {
      if (one.kind == GivenStart::Kind::displacement || !is_loose_[one.index]) return false;
      const bool held = one.kind == GivenStart::Kind::angle && closer_.find_quantity(one).gradient.empty();
      const bool loose_here = std::ranges::find(topology_.loose, one.index,
                                                [](const auto& entry) { return entry[0]; }) != topology_.loose.end();
      return held || (is_place(one) && !loose_here);
    });
    closer_.v = find_start_rates(mechanism_, topology_, tables_, closer_.workspace, rates);
    closer_.update();
  }

  Assembly describe() {
    closer_.update();
    Assembly assembly;
    assembly.poses = find_poses(mechanism_, topology_, closer_.workspace.coordinates);
    assembly.branches = find_branches();
    assembly.closure_residual =
        tables_.closures.empty() ? 0.0 : find_closure_gaps(closer_.workspace).cwiseAbs().maxCoeff();
    for (std::size_t b = 0; b < guesses_.size(); ++b) {
      const double given = mechanism_.bodies[b].start.angle.value_or(guesses_[b]);
      assembly.angle_changes.push_back(find_turn(given, assembly.poses[b].angle));
      if (std::abs(find_turn(guesses_[b], given)) > kSameGuess) assembly.held_bodies.push_back(static_cast<int>(b));
    }
    return assembly;
  }

  /// Every closed position, each described with the start rates.
  std::optional<std::vector<Assembly>> find_all() {
    if (!close_from(guessed_) && !close_from_elsewhere()) throw_open();
    const auto positions = find_assemblies(topology_, tables_, closer_, list_pinned_coordinates());
    if (!positions) return std::nullopt;
    std::vector<Assembly> all;
    for (const VectorXd& q : *positions) {
      closer_.q = q;
      all.push_back(describe());
    }
    return all;
  }

 private:
  // Fills q; returns the guessed angle of every body.
  std::vector<double> make_guess() {
    const CoordinateCounts& counts = tables_.counts;
    VectorXd& q = closer_.q;
    std::vector<bool> given(counts.n_turns(), false);
    for (std::size_t b = 1; b < mechanism_.bodies.size(); ++b) {
      const BodyNode& node = topology_.bodies[b];
      const auto& angle = mechanism_.bodies[b].start.angle;
      if (node.turn >= counts.n_free_turns || !angle || given[node.turn]) continue;
      q(node.turn) = *angle - node.offset;
      given[node.turn] = true;
    }
    for (int s = 0; s < counts.n_free_slides; ++s) {
      if (const int joint = topology_.free_slide_joint[s]; joint >= 0) {
        q(counts.n_free_turns + s) =
            std::get<Prismatic>(mechanism_.joints[joint].kind).start.displacement.value_or(0.0);
      }
    }
    closer_.update();
    guess_driven_angles(given);
    for (const auto& [body, slide] : topology_.loose) {
      const Body& description = mechanism_.bodies[body];
      const Coordinates& at = closer_.workspace.coordinates;
      const double angle = at.angle[topology_.bodies[body].turn] + topology_.bodies[body].offset;
      const Vec2 centre =
          description.start.position.value_or(Vec2{}) + make_rotation(angle) * description.center_of_mass;
      q(counts.n_free_turns + slide) = centre.x;
      q(counts.n_free_turns + slide + 1) = centre.y;
    }
    closer_.update();
    std::vector<double> guesses;
    for (const BodyNode& node : topology_.bodies)
      guesses.push_back(closer_.workspace.coordinates.angle[node.turn] + node.offset);
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
        const Coordinates& at = closer_.workspace.coordinates;
        const double asked = at.driven[rows.driver].value;
        const int guessed = is_known(body) ? against : body;
        closer_.q(guessed) = is_known(body) ? at.angle[body] - asked : at.angle[against] + asked;
        given[guessed] = true;
        closer_.update();
      }
    }
  }

  // Closes the loops near a position. Of the given values, those that turn out to be free are then had exactly.
  bool close_from(const VectorXd& start) {
    closer_.q = start;
    pinned_.clear();
    if (!closer_.close()) return false;
    VectorXd closed = closer_.q;
    int n_free = 0;
    pinned_ = closer_.select_free(given_, &n_free);
    if (static_cast<int>(pinned_.size()) < n_free && given_.size() > pinned_.size()) leave_dead_centre(closed);
    while (!pinned_.empty()) {
      for (const VectorXd& from : {start, closed}) {
        closer_.q = from;
        if (closer_.close(pinned_)) return true;
      }
      pinned_.pop_back();  // out of reach: no more than a guess
    }
    closer_.q = closed;
    closer_.update();
    return true;
  }

  // At a dead centre a given value may seem to have no say: looks beside it.
  void leave_dead_centre(VectorXd& closed) {
    std::vector<int> all(static_cast<std::size_t>(closer_.q.size()));
    std::iota(all.begin(), all.end(), 0);
    ScatteredStarts starts(tables_);
    for (int attempt = 0; attempt < kLooksBeside; ++attempt) {
      VectorXd scattered = closed;
      starts.scatter(all, scattered);
      closer_.q = closed + kBeside * scattered;
      if (!closer_.close()) continue;
      std::vector<GivenStart> free = closer_.select_free(given_);
      if (free.size() <= pinned_.size()) continue;
      pinned_ = std::move(free);
      closed = closer_.q;
    }
    closer_.q = closed;
    closer_.update();
  }

  [[nodiscard]] std::vector<int> list_pinned_coordinates() const {
    std::vector<int> pinned;
    for (const GivenStart& one : pinned_) {
      if (const int coordinate = closer_.find_quantity(one).find_coordinate(); coordinate >= 0) {
        pinned.push_back(coordinate);
      }
    }
    return pinned;
  }

  // Sum of squared distances from all given values.
  [[nodiscard]] double find_distance() const {
    double distance = 0.0;
    for (const GivenStart& one : given_) {
      const double unit = one.kind == GivenStart::Kind::angle ? 1.0 : closer_.size();
      const double way = find_way(one, closer_.find_quantity(one).value) / unit;
      distance += way * way;
    }
    return distance;
  }

  // Goes to the nearest of other closed positions that fulfil a wish; false when there is none.
  template <class Wish>
  bool go_to_nearest(const std::vector<VectorXd>& positions, const Wish& wish) {
    const VectorXd* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const VectorXd& q : positions) {
      closer_.q = q;
      closer_.update();
      const double distance = find_distance();
      if (distance < least && wish()) nearest = &q, least = distance;
    }
    if (nearest == nullptr) return false;
    closer_.q = *nearest;
    closer_.update();
    return true;
  }

  // All assemblies, or those met from scattered starts where degrees of freedom are left.
  std::vector<VectorXd> find_others() {
    if (auto all = find_assemblies(topology_, tables_, closer_, list_pinned_coordinates())) return *all;
    std::vector<VectorXd> met;
    ScatteredStarts starts(tables_);
    std::vector<int> moved;
    const std::vector<int> pinned = list_pinned_coordinates();
    for (int k = 0; k < tables_.counts.n_free(); ++k) {
      if (std::ranges::find(pinned, k) == pinned.end()) moved.push_back(k);
    }
    for (int n = 0; n < kScatteredStarts; ++n) {
      closer_.q = guessed_;
      starts.scatter(moved, closer_.q);
      if (closer_.close(pinned_)) met.push_back(closer_.q);
    }
    return met;
  }

  // Where the guesses lead to no closed position.
  bool close_from_elsewhere() {
    const VectorXd nearest_miss = closer_.q;
    const std::vector<VectorXd> others = find_others();
    if (go_to_nearest(others, [] { return true; })) return close_from(VectorXd(closer_.q));
    closer_.q = nearest_miss;
    closer_.update();
    return false;
  }

  // Two drivers on one degree of freedom leave loops open that close without them.
  void throw_if_over_driven() {
    Mechanism undriven = mechanism_;
    undriven.drivers.clear();
    for (Joint& joint : undriven.joints) joint.branch.reset();
    Assembler without(undriven, 0.0);
    if (!without.close()) return;
    const auto rank = find_row_rank(
        without.tables_, RowSpace(find_sparse_jacobian(without.tables_, without.closer_.workspace.coordinates)));
    const int n_free = without.tables_.counts.n_free() - rank.rank;
    if (n_free < static_cast<int>(mechanism_.drivers.size())) throw_over_driven(mechanism_, n_free);
  }

  // One a joint that closes a loop, in the order of the closures.
  std::vector<LoopBranch> find_branches() const {
    std::vector<LoopBranch> branches;
    for (const LoopFold& fold : folds_.list_by_closure()) {
      const Joint& joint = find_joint_of(fold);
      const auto [first, second] = anchors(joint.kind);
      branches.push_back(
          {joint.name, first.body, second.body, folds_.find_angle(fold, closer_.workspace.coordinates).sine});
    }
    return branches;
  }

  const Joint& find_joint_of(const LoopFold& fold) const {
    return mechanism_.joints[tables_.closures[fold.closure].joint];
  }

  // Mirrors loops that fold to the other side than asked for, or than displacements guessed for guides say.
  void settle_branches() {
    require_closing_branches(mechanism_, topology_);
    heed_displacements();
    for (const LoopFold& fold : folds_.folds()) {
      const Coordinates& at = closer_.workspace.coordinates;
      if (is_on_branch(find_joint_of(fold), folds_.find_angle(fold, at))) continue;
      const VectorXd before = closer_.q;
      if (folds_.mirror(fold, at, closer_.q.data()) && closer_.close(pinned_)) continue;
      closer_.q = before;
      closer_.update();
    }
    const auto is_wanted = [&] {
      return std::ranges::all_of(folds_.folds(), [&](const LoopFold& fold) {
        return is_on_branch(find_joint_of(fold), folds_.find_angle(fold, closer_.workspace.coordinates));
      });
    };
    if (is_wanted()) return;
    const VectorXd mirrored = closer_.q;
    if (go_to_nearest(find_others(), is_wanted)) return;
    closer_.q = mirrored;
    closer_.update();
    require_branches(mechanism_, tables_, folds_, closer_.workspace.coordinates);
  }

  // The displacement of a guide that closes a loop, and the place of a body, are no coordinates to begin from.
  void heed_displacements() {
    const bool unheeded = std::ranges::any_of(given_, [&](const GivenStart& one) {
      const StartQuantity quantity = closer_.find_quantity(one);
      return one.kind != GivenStart::Kind::angle && !quantity.gradient.empty() && quantity.find_coordinate() < 0 &&
             std::abs(find_way(one, quantity.value)) > kNearer * closer_.size();
    });
    if (!unheeded) return;
    double least = find_distance();
    for (const LoopFold& fold : folds_.folds()) {
      const VectorXd before = closer_.q;
      if (folds_.mirror(fold, closer_.workspace.coordinates, closer_.q.data()) && closer_.close(pinned_)) {
        const double distance = find_distance();
        if (distance < least - kNearer) {
          least = distance;
          continue;
        }
      }
      closer_.q = before;
      closer_.update();
    }
  }

  Mechanism mechanism_;
  Topology topology_;
  Tables tables_;
  LoopFolds folds_;
  LoopCloser closer_;
  std::vector<bool> is_loose_;      // one a body
  std::vector<GivenStart> given_;   // positions
  std::vector<GivenStart> pinned_;  // those had exactly
  std::vector<double> guesses_;     // [rad] one a body
  VectorXd guessed_;
};

Assembly assemble_with_play(const Mechanism& mechanism, Assembler& ideal, double time) {
  const bool closed = ideal.close();
  Assembly assembly = ideal.describe();
  if (!closed) {
    if (!close_within_play(mechanism, time, assembly)) ideal.throw_open();
    return assembly;
  }
  Assembly shifted = assembly;
  place_loose_bodies(mechanism, shifted);
  if (shift_within_play(mechanism, time, shifted)) return shifted;
  try {
    ideal.find_rates();
    assembly = ideal.describe();
  } catch (const ModelError&) {
    if (!move_within_play(mechanism, time, assembly)) throw;
  }
  place_loose_bodies(mechanism, assembly);
  return assembly;
}

}  // namespace

Assembly assemble(const Mechanism& mechanism, double time) {
  Assembler ideal(mechanism, time);
  Assembly assembly;
  if (std::ranges::any_of(mechanism.joints, [](const Joint& joint) { return has_clearance(joint.kind); })) {
    assembly = assemble_with_play(mechanism, ideal, time);
  } else {
    if (!ideal.close()) ideal.throw_open();
    ideal.find_rates();
    assembly = ideal.describe();
  }
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    const auto& given = mechanism.bodies[b].start.angle;
    if (given) assembly.angle_changes[b] = find_turn(*given, assembly.poses[b].angle);
  }
  std::erase_if(assembly.held_bodies, [&](int b) { return std::abs(assembly.angle_changes[b]) <= kSameGuess; });
  return assembly;
}

std::optional<Assembly> assemble_ideal(const Mechanism& mechanism) {
  Assembler ideal(mechanism, 0.0);
  if (!ideal.close()) return std::nullopt;
  try {
    ideal.find_rates();
  } catch (const ModelError&) {
    return std::nullopt;
  }
  return ideal.describe();
}

std::optional<std::vector<Assembly>> find_all_assemblies(const Mechanism& mechanism) {
  return Assembler(mechanism, 0.0).find_all();
}

}  // namespace gudgeon
