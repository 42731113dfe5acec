// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// From topology to tables: numbering of equations, the matrix pattern, and every constant.
#include <algorithm>
#include <cmath>
#include <set>

#include "gudgeon/system/compile_closures.h"
#include "gudgeon/system/compile_contacts.h"
#include "gudgeon/system/compile_friction.h"
#include "gudgeon/system/compile_loads.h"
#include "gudgeon/system/kinetic_terms.h"
#include "gudgeon/system/tables.h"

namespace gudgeon {

int Tables::find_turn_index(int turn) const {
  if (turn < counts.n_free_turns) return turn;
  return turn == counts.frame_turn() ? bin_index() : n_solve + (turn - counts.n_free_turns);
}

int Tables::find_slide_index(int slide) const {
  if (slide < counts.n_free_slides) return counts.n_free_turns + slide;
  return slide == counts.unit_slide() ? bin_index() : n_solve + counts.n_driven_turns + (slide - counts.n_free_slides);
}

namespace {

class TableCompiler {
 public:
  TableCompiler(const Mechanism& mechanism, const Topology& topology, const ActiveRows* active_rows)
      : mechanism_(mechanism), topology_(topology) {
    tables_.counts = topology.counts;
    tables_.driven = topology.driven;
    choose_difference_steps(mechanism, tables_.driven);
    tables_.drivers_accelerate = !std::ranges::all_of(tables_.driven, &DrivenMotion::is_uniform);
    for (std::size_t c = 0; c < topology.closures.size(); ++c) {
      active_.push_back(active_rows != nullptr ? (*active_rows)[c]
                                               : std::array<bool, 2>{true, count_rows(topology.closures[c].kind) == 2});
      tables_.n_rows += active_.back()[0] + active_.back()[1];
    }
    tables_.n_solve = topology.counts.n_free() + tables_.n_rows;
    tables_.n_indices = tables_.n_solve + topology.counts.n_driven() + 1;
  }

  Tables compile_loops() {
    compile_closures(mechanism_, topology_, active_, tables_);
    return std::move(tables_);
  }

  Tables compile() {
    kinetic_ = sum_kinetic_terms(mechanism_, topology_);
    compile_closures(mechanism_, topology_, active_, tables_);
    collect_pattern();
    number_slots();
    fill_kinetic_tables();
    fill_closure_slots();
    compile_contacts(mechanism_, topology_, tables_);
    compile_loads(mechanism_, topology_, tables_);
    compile_friction(mechanism_, topology_, tables_);
    index_points();
    settle_idle_turns();
    return std::move(tables_);
  }

 private:
  // All pairs of equations that share a matrix entry.
  void collect_pattern() {
    for (const auto& [keys, products] : kinetic_.pairs) {
      const int first[2] = {tables_.find_turn_index(keys[0].turn), tables_.find_slide_index(keys[0].slide)};
      const int second[2] = {tables_.find_turn_index(keys[1].turn), tables_.find_slide_index(keys[1].slide)};
      for (const int a : first) {
        for (const int b : second) add_to_pattern(a, b);
      }
    }
    for (const ClosureRows& rows : tables_.closures) {
      for (int k = 0; k < 2; ++k) {
        for (int t = rows.first_term; t < rows.end_term; ++t) {
          add_to_pattern(rows.row[k], tables_.find_turn_index(tables_.closure_terms[t].turn));
          add_to_pattern(rows.row[k], tables_.find_slide_index(tables_.closure_terms[t].slide));
        }
        if (rows.kind == ClosureKind::line) add_to_pattern(rows.row[k], tables_.find_turn_index(rows.line_turn));
      }
      if (rows.kind != ClosureKind::angle) continue;
      for (const int turn : rows.angle_turn) add_to_pattern(rows.row[0], tables_.find_turn_index(turn));
    }
  }

  void add_to_pattern(int a, int b) {
    const int bin = tables_.bin_index();
    if (a != b && a != bin && b != bin) pattern_.insert({std::max(a, b), std::min(a, b)});
  }

  void number_slots() {
    std::vector<std::pair<int, int>> solve_pattern;
    for (const auto& [high, low] : pattern_) {
      if (high < tables_.n_solve) solve_pattern.emplace_back(high, low);
    }
    tables_.elimination = Elimination(tables_.n_solve, tables_.n_rows, solve_pattern);
    int slot = tables_.elimination.n_values();
    for (const auto& [high, low] : pattern_) {
      if (high < tables_.n_solve || (low >= tables_.n_solve && !tables_.drivers_accelerate)) continue;
      (low < tables_.n_solve ? tables_.couplings : tables_.driven_couplings).push_back({high, low, slot});
      coupling_slot_[{high, low}] = slot++;
    }
    for (int k = 0; tables_.drivers_accelerate && k < tables_.counts.n_driven(); ++k) {
      const int driven = tables_.n_solve + k;
      tables_.driven_couplings.push_back({driven, driven, slot});
      coupling_slot_[{driven, driven}] = slot++;
    }
    tables_.n_slots = slot + 1;
  }

  [[nodiscard]] int find_slot(int a, int b) const {
    const int bin_slot = tables_.n_slots - 1;
    const auto [low, high] = std::minmax(a, b);
    if (high == tables_.bin_index()) return bin_slot;
    if (high < tables_.n_solve) return tables_.elimination.find_slot(high, low);
    const auto found = coupling_slot_.find({high, low});
    return found == coupling_slot_.end() ? bin_slot : found->second;
  }

  void fill_kinetic_tables() {
    const CoordinateCounts& counts = topology_.counts;
    tables_.constant_values.assign(tables_.n_slots, 0.0);
    tables_.turn_inertia = kinetic_.turn_inertia;
    for (int turn = 0; turn < counts.frame_turn(); ++turn) {
      const int index = tables_.find_turn_index(turn);
      tables_.constant_values[find_slot(index, index)] += kinetic_.turn_inertia[turn];
    }
    for (const auto& [keys, products] : kinetic_.pairs) {
      if (keys[0].slide == counts.unit_slide() && keys[1].slide == counts.unit_slide()) {
        add_turn_pair(keys[0].turn, keys[1].turn, products);
      } else {
        add_slide_pair(keys[0], keys[1], products);
      }
    }
    for (const auto& [key, products] : kinetic_.fields) {
      tables_.fields.push_back({key.turn, key.slide, products.dot, products.cross, tables_.find_turn_index(key.turn),
                                tables_.find_slide_index(key.slide)});
    }
    for (int turn = 0; turn < counts.n_turns(); ++turn) {
      if (kinetic_.turn_torque[turn] == 0.0) continue;
      tables_.torques.push_back({turn, kinetic_.turn_torque[turn], tables_.find_turn_index(turn)});
    }
  }

  void add_turn_pair(int i, int j, const Products& products) {
    const int frame = topology_.counts.frame_turn();
    if (i == frame || j == frame) return;
    const int index_i = tables_.find_turn_index(i);
    const int index_j = tables_.find_turn_index(j);
    if (i == j) {
      tables_.constant_values[find_slot(index_i, index_i)] += products.dot;
      tables_.turn_inertia[i] += products.dot;
      return;
    }
    tables_.turn_pairs.push_back({i, j, products.dot, products.cross, find_slot(index_i, index_j), index_i, index_j});
  }

  void add_slide_pair(TermKey i, TermKey j, const Products& products) {
    const int ti = tables_.find_turn_index(i.turn);
    const int si = tables_.find_slide_index(i.slide);
    const int tj = tables_.find_turn_index(j.turn);
    const int sj = tables_.find_slide_index(j.slide);
    tables_.slide_pairs.push_back({i.turn, i.slide, j.turn, j.slide, products.dot, products.cross, i == j,
                                   find_slot(ti, tj), find_slot(ti, sj), find_slot(si, tj), find_slot(si, sj), ti, si,
                                   tj, sj});
  }

  void fill_closure_slots() {
    for (ClosureRows& rows : tables_.closures) {
      for (int t = rows.first_term; t < rows.end_term; ++t) {
        ClosureTerm& term = tables_.closure_terms[t];
        for (int k = 0; k < 2; ++k) {
          term.slot_turn[k] = find_slot(rows.row[k], tables_.find_turn_index(term.turn));
          term.slot_slide[k] = find_slot(rows.row[k], tables_.find_slide_index(term.slide));
        }
      }
      rows.slot_normal = find_slot(rows.row[0], tables_.find_turn_index(rows.line_turn));
      if (rows.kind != ClosureKind::angle) continue;
      tables_.constant_values[find_slot(rows.row[0], tables_.find_turn_index(rows.angle_turn[0]))] += 1.0;
      tables_.constant_values[find_slot(rows.row[0], tables_.find_turn_index(rows.angle_turn[1]))] -= 1.0;
    }
  }

  void index_points() {
    for (const PointChain::Row& row : tables_.points.rows()) {
      tables_.chain_index_turn.push_back(tables_.find_turn_index(row.turn));
      tables_.chain_index_slide.push_back(tables_.find_slide_index(row.slide));
    }
  }

  // A turn that nothing has inertia about and nothing acts on has the equation 0 = 0, as a point mass has that turns on
  // a pin at its centre. Its rate stays what it is, whatever inertia stands there; it carries no energy.
  void settle_idle_turns() {
    double moment = 0.0;  // [kg m^2] of the size of the mechanism's
    double size = 0.0;    // [m]
    for (const Body& body : mechanism_.bodies) {
      double reach = norm(body.center_of_mass);
      for (const Point& point : body.points) reach = std::max(reach, norm(point.position));
      moment += body.mass * reach * reach + body.inertia;
      size = std::max(size, reach);
    }
    for (int turn = 0; turn < topology_.counts.n_free_turns; ++turn) {
      const int index = tables_.find_turn_index(turn);
      if (is_idle(turn, moment, size)) tables_.constant_values[find_slot(index, index)] = moment > 0.0 ? moment : 1.0;
    }
  }

  // Rounding of a centre of mass that lies on a pin counts as nothing.
  [[nodiscard]] bool is_idle(int turn, double moment, double size) const {
    constexpr double kNoMoment = 1e-20;  // the square of
    constexpr double kNoArm = 1e-10;
    if (tables_.turn_inertia[turn] > kNoMoment * moment) return false;
    const auto couples = [&](int first, int second, double dot, double cross) {
      return (first == turn || second == turn) && std::max(std::abs(dot), std::abs(cross)) > kNoArm * moment;
    };
    const auto turns_with = [&](const TurnCouple& couple) {
      return couple.first_turn == turn || couple.second_turn == turn;
    };
    const LoadTables& loads = tables_.loads;
    return std::ranges::none_of(tables_.turn_pairs,
                                [&](const TurnPair& p) { return couples(p.turn_i, p.turn_j, p.dot, p.cross); }) &&
           std::ranges::none_of(tables_.slide_pairs,
                                [&](const SlidePair& p) {
                                  return (p.turn_i == turn || p.turn_j == turn) &&
                                         std::max(std::abs(p.dot), std::abs(p.cross)) > 0.0;
                                }) &&
           std::ranges::none_of(tables_.torques, [&](const TurnTorque& torque) { return torque.turn == turn; }) &&
           std::ranges::none_of(tables_.closure_terms, [&](const ClosureTerm& term) { return term.turn == turn; }) &&
           std::ranges::none_of(tables_.closures,
                                [&](const ClosureRows& rows) {
                                  return rows.line_turn == turn || rows.angle_turn[0] == turn ||
                                         rows.angle_turn[1] == turn;
                                }) &&
           std::ranges::none_of(
               tables_.points.rows(),
               [&](const PointChain::Row& row) { return row.turn == turn && norm(row.vector) > kNoArm * size; }) &&
           std::ranges::none_of(
               tables_.contacts,
               [&](const Contact& contact) { return contact.bearing_turn == turn || contact.journal_turn == turn; }) &&
           std::ranges::none_of(
               tables_.friction_joints,
               [&](const FrictionJoint& joint) { return joint.first_turn == turn || joint.second_turn == turn; }) &&
           std::ranges::none_of(loads.torques, [&](const TorqueLoad& load) { return turns_with(load.couple); }) &&
           std::ranges::none_of(loads.torsions, [&](const TorsionLoad& load) { return turns_with(load.couple); }) &&
           std::ranges::none_of(loads.bushings,
                                [&](const BushingLoad& load) { return turns_with(load.torsion.couple); });
  }

  const Mechanism& mechanism_;
  const Topology& topology_;
  KineticTerms kinetic_;
  Tables tables_;
  ActiveRows active_;
  std::set<std::pair<int, int>> pattern_;  // (higher index, lower index)
  std::map<std::pair<int, int>, int> coupling_slot_;
};

}  // namespace

Tables compile_tables(const Mechanism& mechanism, const Topology& topology, const ActiveRows* active_rows) {
  return TableCompiler(mechanism, topology, active_rows).compile();
}

Tables compile_loops(const Mechanism& mechanism, const Topology& topology) {
  return TableCompiler(mechanism, topology, nullptr).compile_loops();
}

}  // namespace gudgeon
