// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Loads that depend on the state, compiled: where they act, and where the numbers they depend on are found.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "gudgeon/base/curve.h"
#include "gudgeon/base/expression.h"
#include "gudgeon/base/formula_breaks.h"
#include "gudgeon/base/state_archive.h"
#include "gudgeon/base/vec2.h"
#include "gudgeon/model/channel_names.h"
#include "gudgeon/model/function.h"

namespace gudgeon {

/// What one load does at one instant. A load between two bodies acts on its second; its first feels the opposite, at
/// the same place.
struct LoadEffect {
  Vec2 force;                  ///< [N] on the load's point, in the frame's axes
  double torque = 0.0;         ///< [N m] on its body, beside that force
  double pull = 0.0;           ///< F [N] of a spring, > 0 draws its points together
  double length = 0.0;         ///< L [m] of a spring
  double twist = 0.0;          ///< θ [rad] of a torsion spring or bushing: second angle minus first
  Vec2 offset;                 ///< r [m] of a bushing, in the first body's axes
  double stored_energy = 0.0;  ///< [J] in a spring
  double storing_power = 0.0;  ///< [W] its rate
  double damper_power = 0.0;   ///< [W] lost, >= 0
  double work_power = 0.0;     ///< [W] done on the mechanism by a variable force or torque
};

/// Where the value of one state channel is found.
struct ChannelSource {
  StateChannel::Quantity quantity = StateChannel::Quantity::time;
  int row = 0;          ///< of the point; of the second point of a displacement
  int origin_row = 0;   ///< of the first point of a displacement
  int turn = 0;         ///< of the body, or of the line of a displacement
  double offset = 0.0;  ///< body angle − turn angle [rad]
  Vec2 axis;            ///< of the line, in that turn's axes
  int slide = -1;       ///< of a displacement that is a coordinate; otherwise it is measured between the points
};

/// A number that may change: an expression or a curve where there is one, otherwise the constant.
struct LoadFunction {
  double constant = 0.0;
  int expression = -1;  ///< index into LoadTables::expressions
  int curve = -1;       ///< index into LoadTables::curves
  int channel = 0;      ///< the curve's argument, index into LoadTables::channels
};

/// Two turns between which a torque acts.
struct TurnCouple {
  int first_turn = 0;
  int second_turn = 0;
  int first_index = 0;  ///< equation of the first turn
  int second_index = 0;
  double offset = 0.0;  ///< of the bodies' relative angle against the turns' [rad]
};

struct ForceLoad {
  int load = 0;  ///< index into Mechanism::loads
  int row = 0;
  int axes_turn = 0;
  Rotation axes;  ///< of the axes' body in its turn
  LoadFunction x;
  LoadFunction y;
};

struct TorqueLoad {
  int load = 0;
  TurnCouple couple;
  LoadFunction torque;
};

struct SpringLoad {
  int load = 0;
  int first_row = 0;
  int second_row = 0;
  double stiffness = 0.0;    ///< k [N/m]
  double damping = 0.0;      ///< d [N s/m]
  double free_length = 0.0;  ///< L₀ [m]
};

struct TorsionLoad {
  int load = 0;
  TurnCouple couple;
  double stiffness = 0.0;   ///< k [N m/rad]
  double damping = 0.0;     ///< d [N m s/rad]
  double free_angle = 0.0;  ///< θ₀ [rad]
};

struct BushingLoad {
  TorsionLoad torsion;
  int first_row = 0;
  int second_row = 0;
  Rotation axes;   ///< of the first body in its turn
  Vec2 stiffness;  ///< k [N/m] along the first body's x and y
  Vec2 damping;    ///< d [N s/m]
};

struct LoadTables {
  std::vector<ForceLoad> forces;
  std::vector<TorqueLoad> torques;
  std::vector<SpringLoad> springs;
  std::vector<TorsionLoad> torsions;
  std::vector<BushingLoad> bushings;

  std::vector<ChannelSource> channels;     ///< only those that a load depends on
  std::vector<std::string> channel_names;  ///< in the same order: the variables of the expressions
  std::vector<Expression> expressions;
  std::vector<Curve> curves;
  std::vector<LoadEffect> effects;  ///< one a load of the mechanism: the constant ones; zero where it varies

  /// Whether any load depends on the state or the time.
  [[nodiscard]] bool vary() const {
    return !(forces.empty() && torques.empty() && springs.empty() && torsions.empty() && bushings.empty());
  }
};

/// Which pieces of the formulas are in force, whatever their arguments are: one entry a break, formula after formula.
/// Where a motion slides along breaks, pushed back onto each from both sides, formulas are mixed of two lists.
struct HeldPieces {
  std::vector<int> pieces;     ///< kFreePiece where the argument decides
  std::vector<int> others;     ///< those on the other side
  std::vector<double> shares;  ///< of the others in the mixture [1], one a formula
  std::vector<int> slides;     ///< the slide that a formula is mixed for, one a formula; -1 without
  std::vector<int> surfaces;   ///< the break that each slide goes along; the first n_slides are meant
  int n_slides = 0;

  void transfer(StateArchive& archive) { archive(pieces, others, shares, slides, surfaces, n_slides); }
  /// Goes on without mixtures.
  void stop_slides() noexcept {
    std::ranges::fill(shares, 0.0);
    std::ranges::fill(slides, -1);
    n_slides = 0;
  }
  /// The share of one slide's other side.
  void set_share(int slide, double share) noexcept {
    for (std::size_t f = 0; f < slides.size(); ++f) {
      if (slides[f] == slide) shares[f] = share;
    }
  }
  [[nodiscard]] double find_share(int slide) const noexcept {
    const auto formula = std::ranges::find(slides, slide);
    return formula == slides.end() ? 0.0 : shares[static_cast<std::size_t>(formula - slides.begin())];
  }
};

/// What an evaluation writes for the loads.
struct LoadScratch {
  explicit LoadScratch(const LoadTables& tables) : channel_values(tables.channels.size()), effects(tables.effects) {
    for (const Expression& expression : tables.expressions) {
      evaluators.emplace_back(expression.text, expression.constants, tables.channel_names);
      first_break.push_back(breaks.size());
      breaks.resize(breaks.size() + evaluators.back().breaks().size());
    }
    held.pieces.assign(breaks.size(), kFreePiece);
    held.others = held.pieces;
    held.shares.assign(evaluators.size(), 0.0);
    held.slides.assign(evaluators.size(), -1);
    held.surfaces.assign(evaluators.size(), -1);
  }

  void transfer(StateArchive& archive) {
    archive(channel_values, breaks, held, effects, constant_power, work_power, damper_power, storing_power);
  }

  std::vector<double> channel_values;
  std::vector<ExpressionEvaluator> evaluators;  ///< not to be shared by threads
  std::vector<std::size_t> first_break;         ///< of each formula, in the lists of breaks
  std::vector<BreakState> breaks;               ///< of all formulas
  HeldPieces held;                              ///< not written by an evaluation
  std::vector<LoadEffect> effects;              ///< one a load of the mechanism
  double constant_power = 0.0;                  ///< [W] of constant forces and torques, gravity among them
  double work_power = 0.0;                      ///< [W] sums over all other loads
  double damper_power = 0.0;
  double storing_power = 0.0;
};

}  // namespace gudgeon
