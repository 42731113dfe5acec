// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Pairs, slides, loads, contacts and closures, each from its own table; equations are numbered as in
// docs/theory/dynamics.md. Throughout, Δ = θ_j − θ_i and, summed over the bodies that have both terms,
// C = (Σ m a·b) cos Δ − (Σ m a×b) sin Δ,  S = (Σ m a×b) cos Δ + (Σ m a·b) sin Δ      (Eq. D3)
#include "gudgeon/system/equations.h"

#include <algorithm>

#include "gudgeon/system/load_forces.h"

namespace gudgeon {

namespace {

// H_ij = C,  Q_i += S θ̇_j²,  Q_j −= S θ̇_i²      (Eq. D4)
void add_turn_pairs(const Tables& tables, Workspace& ws) noexcept {
  const Rotation* rotation = ws.coordinates.rotation.data();
  const double* rate = ws.coordinates.angle_rate.data();
  for (const TurnPair& pair : tables.turn_pairs) {
    const auto [c, s] = turn_products(pair.dot, pair.cross, rotation[pair.turn_i], rotation[pair.turn_j]);
    ws.values[pair.slot] = c;
    ws.equations[pair.index_i] += s * rate[pair.turn_j] * rate[pair.turn_j];
    ws.equations[pair.index_j] -= s * rate[pair.turn_i] * rate[pair.turn_i];
  }
}

// With p = c_p R_i a and q = c_q R_j b, virtual work δp·q̈ + δq·p̈ (of a term with itself δp·p̈ alone):
// H(θ_i, θ_j) = c_p c_q C,  H(θ_i, c_q) = c_p S,  H(c_p, c_q) = C,  H(c_p, θ_j) = −c_q S
// Q(θ_i) += c_p (c_q θ̇_j² S − 2 ċ_q θ̇_j C),  Q(c_p) += c_q θ̇_j² C + 2 ċ_q θ̇_j S, and i, j exchanged      (Eq. D5)
void add_slide_pairs(const Tables& tables, Workspace& ws) noexcept {
  const Coordinates& at = ws.coordinates;
  for (const SlidePair& pair : tables.slide_pairs) {
    const auto [c, s] = turn_products(pair.dot, pair.cross, at.rotation[pair.turn_i], at.rotation[pair.turn_j]);
    const double cp = at.slide[pair.slide_i];
    const double cq = at.slide[pair.slide_j];
    const double rate_i = at.angle_rate[pair.turn_i];
    const double rate_j = at.angle_rate[pair.turn_j];
    const double along_q = cq * rate_j * rate_j;  // −q̈ along R_j b, for constant coordinates' rates
    const double across_q = 2.0 * at.slide_rate[pair.slide_j] * rate_j;  // q̈ across it
    ws.equations[pair.index_ti] += cp * (along_q * s - across_q * c);
    ws.equations[pair.index_si] += along_q * c + across_q * s;
    if (pair.is_self) {
      ws.values[pair.slot_tt] += cp * cp * c;
      ws.values[pair.slot_ss] += c;
      continue;
    }
    const double along_p = cp * rate_i * rate_i;
    const double across_p = 2.0 * at.slide_rate[pair.slide_i] * rate_i;
    ws.equations[pair.index_tj] -= cq * (along_p * s + across_p * c);
    ws.equations[pair.index_sj] += along_p * c - across_p * s;
    // Terms of one turn meet in its diagonal entry, once for either order.
    ws.values[pair.slot_tt] += (pair.turn_i == pair.turn_j ? 2.0 : 1.0) * cp * cq * c;
    ws.values[pair.slot_ts] += cp * s;
    ws.values[pair.slot_st] -= cq * s;
    ws.values[pair.slot_ss] += c;
  }
}

// Q(θ) += c [(Σ a×F) cos θ − (Σ a·F) sin θ],  Q(c) += (Σ a·F) cos θ + (Σ a×F) sin θ      (Eq. D6)
void add_constant_loads(const Tables& tables, Workspace& ws) noexcept {
  const Coordinates& at = ws.coordinates;
  const int unit_slide = tables.counts.unit_slide();
  double power = 0.0;
  for (const FieldTerm& field : tables.fields) {
    const Rotation r = at.rotation[field.turn];
    const double torque = at.slide[field.slide] * (field.cross * r.c - field.dot * r.s);
    ws.equations[field.index_turn] += torque;
    power += at.angle_rate[field.turn] * torque;
    if (field.slide == unit_slide) continue;
    const double force = field.dot * r.c + field.cross * r.s;
    ws.equations[field.index_slide] += force;
    power += at.slide_rate[field.slide] * force;
  }
  for (const TurnTorque& torque : tables.torques) {
    ws.equations[torque.index] += torque.torque;
    power += at.angle_rate[torque.turn] * torque.torque;
  }
  ws.loads.constant_power = power;
}

// All gaps before all forces: the long chains of operations of several contacts then run side by side.
void add_contacts(const Tables& tables, std::span<const ContactMode> contact_modes, Workspace& ws) noexcept {
  for (std::size_t k = 0; k < tables.contacts.size(); ++k) {
    if (!contact_modes[k].in_contact) continue;
    const Contact& contact = tables.contacts[k];
    ws.contact_motions[k] = find_contact_motion(contact, ws);
    update_gap(contact.surfaces, ws.contact_motions[k], ws.contact_forces[k].gap);
  }
  for (std::size_t k = 0; k < tables.contacts.size(); ++k) {
    if (!contact_modes[k].in_contact) continue;
    const Contact& contact = tables.contacts[k];
    const double bristle = contact.bristle < 0 ? 0.0 : ws.bristles[contact.bristle];
    ContactForces& forces = ws.contact_forces[k];
    update_contact_forces(contact, ws.contact_motions[k], contact_modes[k], bristle, forces);
    ws.touches[k] = true;
    ws.point_loads[contact.journal_row] += forces.force_on_journal;
    ws.point_loads[contact.bearing_row] -= forces.force_on_journal;
    ws.equations[contact.journal_index] += forces.torque_on_journal;
    ws.equations[contact.bearing_index] += forces.torque_on_bearing;
  }
}

// Virtual work of each row's force f, handed down to the row it starts from:
// Q(θ) += c (R a × f),  Q(c) += R a · f      (Eq. D7)
inline void hand_loads_down(const Tables& tables, const Workspace& ws, Vec2* loads, double* equations) noexcept {
  const auto& rows = tables.points.rows();
  const int unit_slide = tables.counts.unit_slide();
  const int bin = tables.bin_index();
  for (std::size_t r = rows.size(); r-- > 0;) {
    const PointChain::Row& row = rows[r];
    const Vec2 load = loads[r];
    if (row.predecessor >= 0) loads[row.predecessor] += load;
    const bool slides = row.slide != unit_slide;
    if (!slides && tables.chain_index_turn[r] == bin) continue;  // moves with no coordinate of its own
    const Vec2 arm = ws.point_motions[r].arm;
    equations[tables.chain_index_turn[r]] += ws.coordinates.slide[row.slide] * cross(arm, load);
    if (slides) equations[tables.chain_index_slide[r]] += dot(arm, load);
  }
}

// All that acts at points; nothing is done for them where nothing acts.
void add_forces_at_points(const Tables& tables, double t, std::span<const ContactMode> contact_modes,
                          Workspace& ws) noexcept {
  bool any = tables.loads.vary();
  for (std::size_t k = 0; k < tables.contacts.size(); ++k) {
    any = any || contact_modes[k].in_contact;
    if (contact_modes[k].in_contact || !ws.touches[k]) continue;
    ws.contact_forces[k] = {};
    ws.touches[k] = false;
  }
  if (!any) return;
  update_point_motions(tables, ws);
  std::ranges::fill(ws.point_loads, Vec2{});
  add_contacts(tables, contact_modes, ws);
  if (tables.loads.vary()) add_variable_loads(tables, t, ws);
  hand_loads_down(tables, ws, ws.point_loads.data(), ws.equations.data());
}

// Position, velocity and velocity-dependent acceleration of a closure's sum φ = Σ c R(θ) a, the last
// b = Σ −c θ̇² R a + 2 ċ θ̇ ⊥(R a)      (Eq. D10)
struct LoopMotion {
  Vec2 gap;
  Vec2 rate;
  Vec2 bias;
};

inline void add_term(LoopMotion& loop, const Coordinates& at, const ClosureTerm& term, Vec2 arm) noexcept {
  const double scale = at.slide[term.slide];
  const double rate = at.angle_rate[term.turn];
  const double sliding = at.slide_rate[term.slide];
  loop.gap += scale * arm;
  loop.rate += sliding * arm + (scale * rate) * perp(arm);
  loop.bias += (-scale * rate * rate) * arm + (2.0 * sliding * rate) * perp(arm);
}

// The same of a constant length.
inline void add_arm(LoopMotion& loop, double rate, Vec2 arm) noexcept {
  loop.gap += arm;
  loop.rate += rate * perp(arm);
  loop.bias += (-rate * rate) * arm;
}

// φ = r_second − r_first = Σ c R(θ) a,  J(θ) = c ⊥(R a),  J(c) = R a      (Eq. D8)
// Most terms have a constant length. They are worth a branch: all of what they would add for a slide goes to the one
// bin, each addition waiting for the last.
void add_point_closure(const Tables& tables, const ClosureRows& rows, LoopMotion& loop, Workspace& ws) noexcept {
  const Coordinates& at = ws.coordinates;
  const int unit_slide = tables.counts.unit_slide();
  for (int t = rows.first_term; t < rows.end_term; ++t) {
    const ClosureTerm& term = tables.closure_terms[t];
    const Vec2 arm = at.rotation[term.turn] * term.vector;
    if (term.slide == unit_slide) {
      add_arm(loop, at.angle_rate[term.turn], arm);
      ws.values[term.slot_turn[0]] -= arm.y;
      ws.values[term.slot_turn[1]] += arm.x;
      continue;
    }
    add_term(loop, at, term, arm);
    ws.values[term.slot_turn[0]] -= at.slide[term.slide] * arm.y;
    ws.values[term.slot_turn[1]] += at.slide[term.slide] * arm.x;
    ws.values[term.slot_slide[0]] += arm.x;
    ws.values[term.slot_slide[1]] += arm.y;
  }
}

// φ = n·d,  φ̇ = n·ḋ + θ̇_l n×d,  J(θ) = c (R a)×n,  J(c) = (R a)·n,  J(θ_l) += n×d      (Eq. D9)
// b = n·b_sum + 2 θ̇_l n×ḋ − θ̇_l² n·d, as n turns with its body at θ̇_l      (Eq. D10)
void add_line_closure(const Tables& tables, const ClosureRows& rows, LoopMotion& loop, Workspace& ws) noexcept {
  const Coordinates& at = ws.coordinates;
  const Vec2 normal = at.rotation[rows.line_turn] * rows.normal;
  for (int t = rows.first_term; t < rows.end_term; ++t) {
    const ClosureTerm& term = tables.closure_terms[t];
    const Vec2 arm = at.rotation[term.turn] * term.vector;
    add_term(loop, at, term, arm);
    ws.values[term.slot_turn[0]] += at.slide[term.slide] * cross(arm, normal);
    ws.values[term.slot_slide[0]] += dot(arm, normal);
  }
  ws.values[rows.slot_normal] += cross(normal, loop.gap);
  const double turning = at.angle_rate[rows.line_turn];
  const double bias =
      dot(normal, loop.bias) + 2.0 * turning * cross(normal, loop.rate) - turning * turning * dot(normal, loop.gap);
  loop = {{dot(normal, loop.gap), 0.0}, {dot(normal, loop.rate) + turning * cross(normal, loop.gap), 0.0}, {bias, 0.0}};
}

// φ = θ_i − θ_k − f(t) with the motion f that the driver asks for; b = −f̈ and J is constant      (Eqs. D9a, D10)
void add_angle_closure(const ClosureRows& rows, const Coordinates& at, LoopMotion& loop) noexcept {
  const DrivenValue& asked = at.driven[rows.driver];
  loop.gap.x = at.angle[rows.angle_turn[0]] - at.angle[rows.angle_turn[1]] - asked.value;
  loop.rate.x = at.angle_rate[rows.angle_turn[0]] - at.angle_rate[rows.angle_turn[1]] - asked.rate;
  loop.bias.x = -asked.acceleration;
}

// γ = −b − 2 α φ̇ − β² φ      (Eq. D11)
void add_closures(const Tables& tables, Feedback feedback, Workspace& ws) noexcept {
  for (std::size_t c = 0; c < tables.closures.size(); ++c) {
    const ClosureRows& rows = tables.closures[c];
    LoopMotion loop;
    switch (rows.kind) {
      case ClosureKind::point:
        add_point_closure(tables, rows, loop, ws);
        break;
      case ClosureKind::line:
        add_line_closure(tables, rows, loop, ws);
        break;
      case ClosureKind::angle:
        add_angle_closure(rows, ws.coordinates, loop);
        break;
    }
    const Vec2 demand = -(loop.bias + 2.0 * feedback.alpha * loop.rate + feedback.beta * feedback.beta * loop.gap);
    ws.equations[rows.row[0]] = demand.x;
    if (rows.kind == ClosureKind::point) ws.equations[rows.row[1]] = demand.y;
    ws.closure_gap[c] = loop.gap;
    ws.closure_rate[c] = loop.rate;
  }
}

// Known accelerations ẍ_d stand on the right-hand side of the unknowns, the rows and the driven coordinates' own
// equations: Q − H_fd ẍ_d, γ − J_d ẍ_d      (Eq. D11)
void subtract_driven_accelerations(const Tables& tables, Workspace& ws) noexcept {
  const auto acceleration = [&](int index) { return ws.coordinates.driven[index - tables.n_solve].acceleration; };
  for (const Coupling& coupling : tables.couplings) {
    ws.equations[coupling.other] -= ws.values[coupling.slot] * acceleration(coupling.driven);
  }
  for (const Coupling& coupling : tables.driven_couplings) {
    ws.equations[coupling.other] -= ws.values[coupling.slot] * acceleration(coupling.driven);
    if (coupling.other == coupling.driven) continue;
    ws.equations[coupling.driven] -= ws.values[coupling.slot] * acceleration(coupling.other);
  }
}

}  // namespace

void assemble_equations(const Tables& tables, double t, std::span<const ContactMode> contact_modes, Feedback feedback,
                        Workspace& workspace) noexcept {
  std::ranges::copy(tables.constant_values, workspace.values.begin());
  std::ranges::fill(workspace.equations, 0.0);
  add_turn_pairs(tables, workspace);
  add_slide_pairs(tables, workspace);
  add_constant_loads(tables, workspace);
  add_forces_at_points(tables, t, contact_modes, workspace);
  add_closures(tables, feedback, workspace);
  if (tables.drivers_accelerate) subtract_driven_accelerations(tables, workspace);
}

void add_point_loads(const Tables& tables, const Workspace& workspace, std::span<Vec2> loads,
                     std::span<double> equations) noexcept {
  hand_loads_down(tables, workspace, loads.data(), equations.data());
}

void update_closures(const Tables& tables, Workspace& workspace) noexcept {
  const Coordinates& at = workspace.coordinates;
  for (std::size_t c = 0; c < tables.closures.size(); ++c) {
    const ClosureRows& rows = tables.closures[c];
    LoopMotion loop;
    if (rows.kind == ClosureKind::angle) add_angle_closure(rows, at, loop);
    for (int t = rows.first_term; t < rows.end_term; ++t) {
      const ClosureTerm& term = tables.closure_terms[t];
      add_term(loop, at, term, at.rotation[term.turn] * term.vector);
    }
    if (rows.kind == ClosureKind::line) {
      const Vec2 normal = at.rotation[rows.line_turn] * rows.normal;
      loop.rate = {dot(normal, loop.rate) + at.angle_rate[rows.line_turn] * cross(normal, loop.gap), 0.0};
      loop.gap = {dot(normal, loop.gap), 0.0};
    }
    workspace.closure_gap[c] = loop.gap;
    workspace.closure_rate[c] = loop.rate;
  }
}

}  // namespace gudgeon
