// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A mechanism compiled to constants: what the right-hand side reads, and nothing else.
//
// Unknowns, rows and driven coordinates are numbered together: [free turns | free slides | closure rows | driven turns
// | driven slides | one bin]. The bin takes what belongs to no equation (the frame), so that loops need no branches.
// Matrix entries are numbered slots: [those of the elimination | couplings with driven coordinates | one bin].
// Couplings among driven coordinates have slots only where a driver accelerates.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "gudgeon/system/contact_force.h"
#include "gudgeon/system/elimination.h"
#include "gudgeon/system/friction_joint.h"
#include "gudgeon/system/load_tables.h"
#include "gudgeon/system/point_chain.h"
#include "gudgeon/system/topology.h"

namespace gudgeon {

/// Kinetic coupling of two turns i, j whose terms are constant vectors a, b on the same bodies:
/// C = Σ m (R_i a)·(R_j b) = dot cos Δ − cross sin Δ,  S = Σ m (R_i a)×(R_j b) = cross cos Δ + dot sin Δ,  Δ = θ_j −
/// θ_i.
struct TurnPair {
  int turn_i;
  int turn_j;
  double dot;    ///< Σ m a·b [kg m^2]
  double cross;  ///< Σ m a×b [kg m^2]
  int slot;      ///< of H_ij
  int index_i;   ///< equation of turn i
  int index_j;
};

/// C and S of a pair.
struct TurnedProducts {
  double dot;
  double cross;
};

inline TurnedProducts turn_products(double dot, double cross, Rotation i, Rotation j) noexcept {
  const double cosine = i.c * j.c + i.s * j.s;
  const double sine = i.c * j.s - i.s * j.c;
  return {dot * cosine - cross * sine, cross * cosine + dot * sine};
}

/// The same for terms of which at least one is scaled by a slide.
struct SlidePair {
  int turn_i;
  int slide_i;
  int turn_j;
  int slide_j;
  double dot;
  double cross;
  bool is_self;  ///< both terms are the same one
  int slot_tt;   ///< of (turn i, turn j)
  int slot_ts;   ///< of (turn i, slide j)
  int slot_st;   ///< of (slide i, turn j)
  int slot_ss;   ///< of (slide i, slide j)
  int index_ti;
  int index_si;
  int index_tj;
  int index_sj;
};

/// Constant forces F (gravity among them) on points that share a term a: potential U = −c (dot cos θ + cross sin θ).
struct FieldTerm {
  int turn;
  int slide;
  double dot;    ///< Σ a·F
  double cross;  ///< Σ a×F
  int index_turn;
  int index_slide;
};

/// A constant torque τ [N m] on a turn.
struct TurnTorque {
  int turn;
  double torque;
  int index;
};

/// One term of a closure: second point minus first.
struct ClosureTerm {
  int turn;
  int slide;
  Vec2 vector;
  int slot_turn[2];   ///< of (row, turn), a row
  int slot_slide[2];  ///< of (row, slide)
};

/// A sum of terms that must vanish: both components, or only the one along a normal that turns with a body; or the
/// difference of two turns that must be the one a driver asks for.
struct ClosureRows {
  int joint;   ///< -1 for a driver's
  int driver;  ///< index into Tables::driven; -1 for a joint's
  ClosureKind kind;
  int first_term;
  int end_term;
  bool active[2];     ///< a redundant row is measured but not enforced
  int row[2];         ///< index of its equation (the bin when not active)
  int line_turn;      ///< turn of the normal
  Vec2 normal;        ///< in that turn's axes
  int slot_normal;    ///< of (row, line_turn)
  int angle_turn[2];  ///< turns of the body and of the one it is driven against
};

/// Matrix entry of a driven coordinate with an unknown, for the driver's effort and for what its acceleration asks of
/// the unknown; or with another driven coordinate or itself.
struct Coupling {
  int driven;  ///< index of the driven coordinate's equation
  int other;   ///< index of the unknown or row, or of the other driven coordinate
  int slot;
};

/// The contacts of one clearance joint, which stand together, and how many surfaces either body has in it.
struct ContactGroup {
  int joint;
  int first_contact;
  int end_contact;
  int n_bearing_surfaces;
  int n_journal_surfaces;
};

struct Tables {
  CoordinateCounts counts;
  int n_rows = 0;      ///< active closure rows
  int n_solve = 0;     ///< unknowns and active rows
  int n_indices = 0;   ///< all equations and the bin
  int n_slots = 0;     ///< all matrix entries and the bin
  int n_bristles = 0;  ///< contacts, then ideal joints, whose friction law has one

  std::vector<double> constant_values;  ///< matrix entries that never change; zeros elsewhere
  std::vector<double> turn_inertia;     ///< of each turn's motion alone [kg m^2]: diagonal of H without slides
  std::vector<TurnPair> turn_pairs;
  std::vector<SlidePair> slide_pairs;
  std::vector<FieldTerm> fields;
  std::vector<TurnTorque> torques;
  std::vector<ClosureTerm> closure_terms;
  std::vector<ClosureRows> closures;
  std::vector<Coupling> couplings;         ///< of driven coordinates with unknowns and rows
  std::vector<Coupling> driven_couplings;  ///< of driven coordinates among each other; none when all move uniformly
  std::vector<DrivenMotion> driven;        ///< one a driver: turns, slides, then those of angle closures
  bool drivers_accelerate = false;         ///< at least one driver does not move uniformly
  Elimination elimination;
  std::vector<double> usual_pivots;  ///< of the elimination at the start; none until they are known

  PointChain points;                  ///< that contacts and variable loads act on or look at
  std::vector<int> chain_index_turn;  ///< equation of each chain row's turn
  std::vector<int> chain_index_slide;
  std::vector<Contact> contacts;
  std::vector<ContactGroup> contact_groups;  ///< one a clearance joint
  LoadTables loads;
  std::vector<FrictionJoint> friction_joints;             ///< one an ideal joint with friction
  std::shared_ptr<const FrictionBodies> friction_bodies;  ///< none where no ideal joint has friction

  [[nodiscard]] int bin_index() const { return n_indices - 1; }
  [[nodiscard]] int find_turn_index(int turn) const;
  [[nodiscard]] int find_slide_index(int slide) const;
};

/// Which rows of which closures are enforced; one entry a closure.
using ActiveRows = std::vector<std::array<bool, 2>>;

/// Compiles a mechanism. Without a choice of rows, all of them are active.
Tables compile_tables(const Mechanism& mechanism, const Topology& topology, const ActiveRows* active_rows = nullptr);

}  // namespace gudgeon
