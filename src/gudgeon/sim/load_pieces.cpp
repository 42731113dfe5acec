// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Which pieces a motion goes into, and when it slides between them.
#include <algorithm>
#include <cmath>

#include "gudgeon/sim/load_breaks.h"

namespace gudgeon {

namespace {

// Arguments are one and the same, but for a factor, where the cosine between their rates is one within this: rates are
// differences, good to nine digits and mostly more.
constexpr double kSameDirection = 1e-9;
// Arguments that are slid along together may come apart by what one alone would move in this share of a cycle.
constexpr double kDriftShare = 1e-6;

bool slides(const HeldPieces& held, std::size_t k) noexcept { return held.pieces[k] != held.others[k]; }

}  // namespace

void LoadBreaks::move_ahead(const std::vector<double>& y, const std::vector<double>& slope) noexcept {
  for (std::size_t i = 0; i < state_.size(); ++i) state_[i] = y[i] + ahead_ * slope[i];
}

// The pieces that all arguments are in a little ahead.
void LoadBreaks::read_pieces(double t, const std::vector<double>& y, const std::vector<double>& slope,
                             MotionEquations& equations, Pieces& pieces) noexcept {
  HeldPieces& held = scratch_.loads.held;
  std::ranges::fill(held.pieces, kFreePiece);
  std::ranges::fill(held.others, kFreePiece);
  held.stop_slides();
  move_ahead(y, slope);
  if (n_stalls_ > 0) {  // from rest only the slope there tells where it goes
    eval(t + ahead_, state_, later_slope_, equations);
    move_ahead(y, later_slope_);
  }
  measure(t + ahead_, state_.data(), equations);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const BreakState& state = scratch_.loads.breaks[k];
    pieces[k] = state.met ? state.piece : kFreePiece;
  }
}

// Whether two lists are the same but for what is slid along, and what was: where a slide ends, its mixture has told the
// side, which an argument that is zero but for rounding cannot.
bool LoadBreaks::agree(const Pieces& one, const Pieces& other, const HeldPieces& held) const noexcept {
  for (std::size_t k = 0; k < one.size(); ++k) {
    if (one[k] != other[k] && !slides(held, k) && is_decided_[k] == 0) return false;
  }
  return true;
}

// Whether a break comes into play that was behind a condition: its argument may be one that is slid along already.
bool LoadBreaks::meets_others(const HeldPieces& held) const noexcept {
  for (std::size_t k = 0; k < tried_[0].size(); ++k) {
    if (!slides(held, k) && held.pieces[k] == kFreePiece && tried_[0][k] != kFreePiece) return true;
  }
  return false;
}

// Slides begin anew, from one of their sides.
void LoadBreaks::forget_slides(HeldPieces& held) noexcept {
  for (std::size_t k = 0; k < tried_[0].size(); ++k) {
    if (!slides(held, k)) continue;
    tried_[0][k] = held.others[k] = held.pieces[k];
    reach_[k] = std::numeric_limits<double>::infinity();
  }
  held.stop_slides();
}

// Each choice of pieces moves the motion somewhere: a choice is right when it moves into the pieces it is made of.
// Where two choices move it into each other, it slides between them.
bool LoadBreaks::choose_pieces(double t, const std::vector<double>& y, std::vector<double>& slope,
                               MotionEquations& equations) {
  HeldPieces& held = equations.workspace.loads.held;
  if (has_drifted(t, y, equations)) return false;
  read_pieces(t, y, slope, equations, tried_[0]);
  std::ranges::fill(is_decided_, 0);
  if (held.n_slides > 0 && meets_others(held)) forget_slides(held);
  int n_new = 0;
  for (int k = 0; k < kMostTries; ++k) {
    Pieces& tried = tried_[k];
    for (std::size_t b = 0; b < tried.size(); ++b) {
      if (!slides(held, b) && is_decided_[b] == 0) held.pieces[b] = held.others[b] = tried[b];
    }
    eval(t, y, slope, equations);
    if (!end_slides(t, y, slope, equations, n_new)) return false;
    for (std::size_t b = 0; b < tried.size(); ++b) {
      if (!slides(held, b)) tried[b] = held.pieces[b];
    }
    read_pieces(t, y, slope, equations, next_);
    if (agree(next_, tried, held)) return true;
    n_new = 0;
    if (k > 0 && agree(next_, tried_[k - 1], held)) {
      const int n_before = held.n_slides;
      if (!begin_slides(t, y, slope, equations, tried_[k - 1], tried)) return false;
      n_new = held.n_slides - n_before;
    }
    tried_[k + 1] = next_;
  }
  for (std::size_t b = 0; b < next_.size(); ++b) {
    if (tried_[kMostTries][b] != tried_[kMostTries - 1][b]) is_restless_[b] = 1;
  }
  return false;
}

// Ends slides whose mixture is none, that farthest from one first; the last n_new may be at its edge. False where a
// mixture cannot be found.
bool LoadBreaks::end_slides(double t, const std::vector<double>& y, std::vector<double>& slope,
                            MotionEquations& equations, int n_new) {
  HeldPieces& held = equations.workspace.loads.held;
  while (held.n_slides > 0) {
    int worst = -1;
    double most = 0.0;
    for (int s = 0; s < held.n_slides; ++s) {
      const double share = held.find_share(s);
      if (!std::isfinite(share)) return false;
      const double beyond = std::max(-share, share - 1.0);
      const bool ends = s < held.n_slides - n_new ? beyond >= 0.0 : beyond > 0.0;
      if (ends && (worst < 0 || beyond > most)) worst = s, most = beyond;
    }
    if (worst < 0) return true;
    if (worst >= held.n_slides - n_new) --n_new;
    end_slide(worst, held);
    eval(t, y, slope, equations);
  }
  return true;
}

void LoadBreaks::end_slide(int slide, HeldPieces& held) noexcept {
  const bool to_others = held.find_share(slide) > 0.5;
  for (std::size_t k = 0; k < formula_of_.size(); ++k) {
    if (held.slides[formula_of_[k]] != slide || !slides(held, k)) continue;
    (to_others ? held.pieces : held.others)[k] = (to_others ? held.others : held.pieces)[k];
    reach_[k] = std::numeric_limits<double>::infinity();
    is_decided_[k] = 1;
  }
  held.set_share(slide, 0.0);
  for (int& one : held.slides) {
    if (one == slide) one = -1;
    if (one > slide) --one;
  }
  std::shift_left(held.surfaces.begin() + slide, held.surfaces.end(), 1);
  --held.n_slides;
}

// Both choices move the motion into the other: it stays between, on as many breaks as change independently.
bool LoadBreaks::begin_slides(double t, const std::vector<double>& y, std::vector<double>& slope,
                              MotionEquations& equations, const Pieces& one, const Pieces& other) {
  HeldPieces& held = equations.workspace.loads.held;
  if (!list_turned(one, other, held)) return false;
  for (const int k : turned_) {
    held.pieces[static_cast<std::size_t>(k)] = one[static_cast<std::size_t>(k)];
    held.others[static_cast<std::size_t>(k)] = other[static_cast<std::size_t>(k)];
  }
  for (std::size_t f = 0; f <= turned_formulas_.size(); ++f) {
    if (f > 0) held.shares[static_cast<std::size_t>(turned_formulas_[f - 1])] = 1.0;
    eval(t, y, slope, equations);
    equations.find_argument_rates(t, y.data(), turned_, equations.workspace, turned_rates_.data() + f * turned_.size());
    if (f > 0) held.shares[static_cast<std::size_t>(turned_formulas_[f - 1])] = 0.0;
  }
  if (!join_slides(held)) return false;
  eval(t, y, slope, equations);
  return true;
}

// Breaks that are on other sides in both choices, and the formulas that hold them.
bool LoadBreaks::list_turned(const Pieces& one, const Pieces& other, const HeldPieces& held) noexcept {
  turned_.clear();
  turned_formulas_.clear();
  bool is_possible = true;
  for (std::size_t k = 0; k < one.size(); ++k) {
    if (one[k] == other[k] || slides(held, k) || is_decided_[k] != 0) continue;
    is_restless_[k] = 1;
    const int formula = static_cast<int>(formula_of_[k]);
    is_possible = is_possible && held.slides[formula_of_[k]] < 0;
    turned_.push_back(static_cast<int>(k));
    if (turned_formulas_.empty() || turned_formulas_.back() != formula) turned_formulas_.push_back(formula);
  }
  return is_possible && !turned_.empty();
}

// Breaks whose arguments are one and the same are slid along together. A formula can be mixed for one slide only.
bool LoadBreaks::join_slides(HeldPieces& held) noexcept {
  const std::size_t n = turned_.size();
  const auto dot = [&](std::size_t a, std::size_t b) {
    double sum = 0.0;
    for (std::size_t f = 0; f <= turned_formulas_.size(); ++f)
      sum += turned_rates_[f * n + a] * turned_rates_[f * n + b];
    return sum;
  };
  for (std::size_t a = 0; a < n; ++a) {
    const auto k = static_cast<std::size_t>(turned_[a]);
    // Behind a condition that is not met on both sides.
    if (held.pieces[k] == kFreePiece || held.others[k] == kFreePiece) continue;
    int slide = -1;
    for (std::size_t b = 0; b < a && slide < 0; ++b) {
      const double both = std::sqrt(dot(a, a) * dot(b, b));
      if (std::abs(dot(a, b)) >= (1.0 - kSameDirection) * both) {
        slide = held.slides[formula_of_[static_cast<std::size_t>(turned_[b])]];
      }
    }
    int& own = held.slides[formula_of_[k]];
    if (slide < 0) {
      if (own >= 0 || held.n_slides == MotionEquations::kMostSlides) return false;
      slide = held.n_slides++;
      held.surfaces[static_cast<std::size_t>(slide)] = static_cast<int>(k);
    }
    if (own >= 0 && own != slide) return false;
    own = slide;
    reach_[k] = kDriftShare * cycle_time_ * std::sqrt(dot(a, a));
  }
  return true;
}

// Whether what is slid along together has come apart.
bool LoadBreaks::has_drifted(double t, const std::vector<double>& y, MotionEquations& equations) noexcept {
  const HeldPieces& held = equations.workspace.loads.held;
  if (held.n_slides == 0) return false;
  scratch_.loads.held = held;
  measure(t, y.data(), equations);
  bool drifted = false;
  for (std::size_t k = 0; k < formula_of_.size(); ++k) {
    if (!slides(held, k) || !(std::abs(scratch_.loads.breaks[k].argument) > reach_[k])) continue;
    is_restless_[k] = 1;
    drifted = true;
  }
  return drifted;
}

}  // namespace gudgeon
