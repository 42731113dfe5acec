// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Summation over bodies and loads.
#include "gudgeon/system/kinetic_terms.h"

namespace gudgeon {

std::map<TermKey, Vec2> merge_terms(const Path& path) {
  std::map<TermKey, Vec2> merged;
  for (const Term& term : path) merged[{term.turn, term.slide}] += term.vector;
  return merged;
}

namespace {

/// Pairs of terms, a row for each first key. Terms of a body come in order, and mostly where another body had them.
class PairSums {
 public:
  void add(double mass, const std::map<TermKey, Vec2>& terms) {
    for (auto first = terms.begin(); first != terms.end(); ++first) {
      Row& row = rows_[first->first];
      auto place = row.begin();
      for (auto second = first; second != terms.end(); ++second, ++place) {
        if (place == row.end() || place->first != second->first) place = row.lower_bound(second->first);
        if (place == row.end() || place->first != second->first)
          place = row.emplace_hint(place, second->first, Products{});
        place->second.add(mass, first->second, second->second);
      }
    }
  }

  [[nodiscard]] std::map<std::array<TermKey, 2>, Products> list() const {
    std::map<std::array<TermKey, 2>, Products> pairs;
    for (const auto& [first, row] : rows_) {
      for (const auto& [second, products] : row) pairs.emplace_hint(pairs.end(), std::array{first, second}, products);
    }
    return pairs;
  }

 private:
  using Row = std::map<TermKey, Products>;
  std::map<TermKey, Row> rows_;
};

}  // namespace

KineticTerms sum_kinetic_terms(const Mechanism& mechanism, const Topology& topology) {
  KineticTerms sums;
  PairSums pairs;
  sums.turn_inertia.assign(topology.counts.n_turns(), 0.0);
  sums.turn_torque.assign(topology.counts.n_turns(), 0.0);
  const auto add_force = [&](const Path& path, Vec2 force) {
    for (const auto& [key, vector] : merge_terms(path)) sums.fields[key].add(1.0, vector, force);
  };

  for (int b = 1; b < static_cast<int>(mechanism.bodies.size()); ++b) {
    const Body& body = mechanism.bodies[b];
    const Path path = topology.find_path(b, body.center_of_mass);
    sums.turn_inertia[topology.bodies[b].turn] += body.inertia;
    add_force(path, body.mass * mechanism.gravity);
    pairs.add(body.mass, merge_terms(path));
  }
  sums.pairs = pairs.list();

  const NameIndex names(mechanism);
  for (const Load& load : mechanism.loads) {
    if (const auto* force = std::get_if<ConstantForce>(&load.kind)) {
      const JointEnd end = find_end(names, force->point);
      add_force(topology.find_path(end.body, end.point), force->force);
    } else if (const auto* torque = std::get_if<ConstantTorque>(&load.kind)) {
      sums.turn_torque[topology.bodies[names.find_body(torque->body)].turn] += torque->torque;
    }
  }
  return sums;
}

}  // namespace gudgeon
