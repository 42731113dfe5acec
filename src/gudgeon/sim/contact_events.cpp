// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Root-finding on dense output.
#include "gudgeon/sim/contact_events.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "gudgeon/sim/worn_flight.h"

namespace gudgeon {

namespace {

// Parts of a step that are looked at one by one once a hidden crossing is possible: at least so many, and on worn
// surfaces, whose gap may change from cell to cell, so many for each cell passed, of which those are left out
// in which it cannot close.
constexpr int kParts = 8;
constexpr double kPartsPerCell = 2.0;
constexpr double kMostParts = 1e6;
// A cubic through the ends of a step may miss the true gap by this share of how far the gap could move in it.
constexpr double kMargin = 0.1;
// Shares of a step are found to so many bits: where surfaces graze, what is lost here is magnified.
constexpr int kShareBits = 45;

// Whether the cubic with these values and slopes (per unit of share) at both ends comes above -margin in between.
bool may_rise_above(double value_a, double slope_a, double value_b, double slope_b, double margin) {
  const double difference = value_b - value_a;
  for (int k = 1; k < kParts; ++k) {
    const double s = static_cast<double>(k) / kParts;
    const double r = 1.0 - s;
    const double value = value_a + s * (difference + r * ((slope_a - difference) * r - (slope_b - difference) * s));
    if (value > -margin) return true;
  }
  return false;
}

double count_cells(const RadialProfile& profile) {
  return static_cast<double>(profile.cell_depths().size()) / (2.0 * std::numbers::pi);
}

GapState find_gap_state(const RevoluteSurfaces& surfaces, const RelativeMotion& motion) noexcept {
  const RevoluteGap gap = find_revolute_gap(surfaces, motion);
  const double turning = gap.eccentricity > 0.0 ? cross(gap.normal, motion.velocity) / gap.eccentricity : 0.0;
  const double fastest = std::max(std::abs(turning - motion.bearing_rate), std::abs(turning - motion.journal_rate));
  const double per_radian = std::max(count_cells(surfaces.bearing_wear), count_cells(surfaces.journal_wear));
  return {gap.eccentricity - surfaces.least_clearance(),
          dot(gap.normal, motion.velocity),
          fastest * per_radian,
          gap.penetration,
          gap.penetration_rate,
          0.0,
          0.0};
}

void set_overrun(const GuideSurfaces& surfaces, double position, double position_rate, GapState& state) noexcept {
  state.overrun = std::abs(position) - surfaces.half_length;
  state.overrun_rate = std::copysign(1.0, position) * position_rate;
}

GapState find_gap_state(const GuideSurfaces& surfaces, const RelativeMotion& motion) noexcept {
  const GuideGap gap = find_guide_gap(surfaces, motion);
  const double per_meter =
      static_cast<double>(surfaces.bearing_wear.cell_depths().size()) / (2.0 * surfaces.half_length);
  const double sliding = std::abs(gap.position_rate) * per_meter;
  const double rolling = std::abs(motion.journal_rate - motion.bearing_rate) * count_cells(surfaces.journal_wear);
  GapState state{gap.reach, gap.reach_rate, std::max(sliding, rolling), gap.penetration, gap.penetration_rate};
  set_overrun(surfaces, gap.bearing_position, gap.position_rate, state);
  return state;
}

// What the gap of a contact that presses tells.
GapState find_gap_state(const Contact& contact, const ContactGap& gap, const Workspace& workspace) noexcept {
  GapState state;
  state.penetration = gap.penetration;
  state.penetration_rate = gap.penetration_rate;
  if (const auto* slot = std::get_if<GuideSurfaces>(&contact.surfaces)) {
    const RelativeMotion motion = find_contact_motion(contact, workspace);
    const Vec2 along = -slot->side * perp(gap.normal);
    const double rate = dot(along, motion.velocity) + motion.bearing_rate * cross(along, motion.offset);
    set_overrun(*slot, gap.bearing_position, rate, state);
  }
  return state;
}

}  // namespace

ContactEvents::ContactEvents(const Tables& tables)
    : tables_(&tables), interpolated_(2 * static_cast<std::size_t>(tables.counts.n_free())) {}

void ContactEvents::find_gaps(Workspace& workspace, std::vector<GapState>& gaps) const noexcept {
  update_point_motions(*tables_, workspace);
  for (std::size_t k = 0; k < gaps.size(); ++k) gaps[k] = find_gap(k, workspace);
}

void ContactEvents::find_gaps(Workspace& workspace, std::span<const ContactMode> contact_modes,
                              std::vector<GapState>& gaps) const noexcept {
  const bool all_known = std::ranges::all_of(contact_modes, &ContactMode::in_contact);
  if (!all_known) update_point_motions(*tables_, workspace);
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    if (contact_modes[k].in_contact) {
      gaps[k] = find_gap_state(tables_->contacts[k], workspace.contact_forces[k].gap, workspace);
    } else {
      gaps[k] = find_gap(k, workspace);
    }
  }
}

GapState ContactEvents::find_gap(std::size_t contact, const Workspace& workspace) const noexcept {
  const Contact& at = tables_->contacts[contact];
  const RelativeMotion motion = find_contact_motion(at, workspace);
  return std::visit([&](const auto& surfaces) { return find_gap_state(surfaces, motion); }, at.surfaces);
}

GapState ContactEvents::find_gap_at(double share, std::size_t contact, const DenseStep& step, Workspace& workspace) {
  const std::size_t n_free = interpolated_.size() / 2;
  step.interpolate(share, 2 * n_free, interpolated_.data());
  update_coordinates(*tables_, step.start_time() + share * step.step(), interpolated_.data(),
                     interpolated_.data() + n_free, workspace.coordinates);
  update_point_motions(*tables_, workspace);
  return find_gap(contact, workspace);
}

// Angles that have turned often are known less well, and what drivers ask for no better than time is.
double ContactEvents::find_gap_rounding(std::size_t contact, double time, const Workspace& workspace) const noexcept {
  const Coordinates& at = workspace.coordinates;
  double size = 0.0;
  for (const int end : {tables_->contacts[contact].bearing_row, tables_->contacts[contact].journal_row}) {
    for (int r = end; r >= 0; r = tables_->points.rows()[r].predecessor) {
      const PointChain::Row& row = tables_->points.rows()[r];
      const double turned = 1.0 + std::abs(at.angle[row.turn]) + std::abs(at.angle_rate[row.turn]) * time;
      const double slid = std::abs(at.slide[row.slide]) * turned + std::abs(at.slide_rate[row.slide]) * time;
      size += norm(row.vector) * slid;
    }
  }
  return std::numeric_limits<double>::epsilon() * size;
}

// First share in [0, limit] at which sign δ rises above zero. What begins above zero and falls has to turn first.
std::optional<double> ContactEvents::find_crossing(std::size_t contact, double sign, double limit, int n_parts,
                                                   const GapState& start, const DenseStep& step, Workspace& workspace) {
  const auto look = [&](double share) { return find_gap_at(share, contact, step, workspace); };
  const auto value = [&](double share) { return sign * look(share).penetration; };
  const auto rate = [&](double share) { return sign * look(share).penetration_rate; };
  const auto refine = [](auto&& f, double a, double fa, double b, double fb) {
    std::uintmax_t most = 60;
    const auto bracket =
        boost::math::tools::toms748_solve(f, a, b, fa, fb, boost::math::tools::eps_tolerance<double>(kShareBits), most);
    return 0.5 * (bracket.first + bracket.second);
  };
  double before = 0.0;
  double value_before = sign * start.penetration;
  double rate_before = sign * start.penetration_rate;
  const bool over_cells = sign > 0.0 && n_parts > kParts;
  for (int part = 1; part <= n_parts; ++part) {
    if (over_cells) {
      const int clear = find_clear_part(contact, limit, n_parts, part - 1, step, workspace);
      if (clear == n_parts) break;
      before = limit * clear / n_parts;
      rate_before = rate(before);
      part = clear + 1;
    }
    const double after = limit * part / n_parts;
    double top = after;
    const GapState there = look(after);
    double value_top = sign * there.penetration;
    double rate_top = sign * there.penetration_rate;
    const double value_after = value_top;
    const double rate_after = rate_top;
    if (value_top <= 0.0 && rate_before > 0.0 && rate_after < 0.0) {
      top = refine(rate, before, rate_before, after, rate_after);
      value_top = value(top);
      rate_top = 0.0;
    }
    const bool falls = value_before > 0.0 && rate_before < 0.0;
    if (value_top > 0.0 && !(falls && rate_top <= 0.0)) {
      double bottom = before;
      double value_bottom = value_before;
      if (rate_before < 0.0 && rate_top > 0.0) {
        bottom = refine(rate, before, rate_before, top, rate_top);
        value_bottom = value(bottom);
      }
      return value_bottom < 0.0 ? refine(value, bottom, value_bottom, top, value_top) : bottom;
    }
    before = after;
    value_before = value_after;
    rate_before = rate_after;
  }
  return std::nullopt;
}

// The part of a flight over worn surfaces behind those from `part` on in which they cannot touch, taken together as
// many as can be.
int ContactEvents::find_clear_part(std::size_t contact, double limit, int n_parts, int part, const DenseStep& step,
                                   Workspace& workspace) {
  const Contact& at = tables_->contacts[contact];
  const auto look = [&](int end_of_part) {
    find_gap_at(limit * end_of_part / n_parts, contact, step, workspace);
    return find_worn_flight(at.surfaces, find_contact_motion(at, workspace));
  };
  WornFlight before = look(part);
  int stride = n_parts - part;
  while (part < n_parts && stride > 0) {
    const int next = std::min(part + stride, n_parts);
    const WornFlight after = look(next);
    const double duration = limit * (next - part) / n_parts * step.step();
    if (find_greatest_penetration(at.surfaces, before, after, duration) < 0.0) {
      part = next;
      before = after;
      stride *= 2;
    } else {
      stride = (next - part) / 2;
    }
  }
  return part;
}

// How closely a step must be looked at; zero when nothing can have happened to the contact inside it.
int ContactEvents::count_parts(std::size_t contact, bool in_contact, double h, const GapState& start,
                               const GapState& end) const {
  const auto may_rise = [&](double value_a, double rate_a, double value_b, double rate_b) {
    if (value_a > 0.0 && value_b > 0.0) return true;
    const double slope_a = rate_a * h;
    const double slope_b = rate_b * h;
    const double margin = kMargin * std::max(std::abs(slope_a), std::abs(slope_b));
    return may_rise_above(value_a, slope_a, value_b, slope_b, margin);
  };
  if (in_contact) {
    // A contact begins with its surfaces a hair apart: it may close and part again, or never close.
    const bool opens = end.penetration < 0.0;
    const bool may_open =
        may_rise(-start.penetration, -start.penetration_rate, -end.penetration, -end.penetration_rate);
    return opens || (may_open && start.penetration_rate < 0.0 && end.penetration_rate > 0.0) ? kParts : 0;
  }
  // What the least depths would leave changes smoothly even where the surfaces do not. Where it could come and go
  // within the step at the speeds of its ends, the flight may wind more than a cubic does.
  const double furthest = h * std::max(std::abs(start.reach_rate), std::abs(end.reach_rate));
  const bool is_near = furthest > -std::max(start.reach, end.reach);
  const bool closes = end.penetration > 0.0;
  if (!closes && !is_near && !may_rise(start.reach, start.reach_rate, end.reach, end.reach_rate)) return 0;
  if (!is_worn(tables_->contacts[contact].surfaces)) return kParts;
  const double passed = h * std::max(start.cell_rate, end.cell_rate);
  return std::max(kParts, static_cast<int>(std::min(kPartsPerCell * passed, kMostParts)));
}

std::optional<ContactChange> ContactEvents::find_first_change(const DenseStep& step,
                                                              std::span<const ContactMode> contact_modes,
                                                              const std::vector<GapState>& start,
                                                              const std::vector<GapState>& end, Workspace& workspace) {
  std::optional<ContactChange> first;
  for (std::size_t k = 0; k < contact_modes.size(); ++k) {
    const bool in_contact = contact_modes[k].in_contact;
    const int n_parts = count_parts(k, in_contact, step.step(), start[k], end[k]);
    if (n_parts == 0) continue;
    const auto crossing =
        find_crossing(k, in_contact ? -1.0 : 1.0, first ? first->share : 1.0, n_parts, start[k], step, workspace);
    if (crossing) first = ContactChange{k, *crossing};
  }
  return first;
}

// A slide along the slot may turn back once between two ends of a step; more often would take a longer one.
std::optional<double> ContactEvents::find_hidden_overrun(const DenseStep& step, const std::vector<GapState>& start,
                                                         const std::vector<GapState>& end, Workspace& workspace) {
  for (std::size_t k = 0; k < start.size(); ++k) {
    if (end[k].overrun > 0.0 || !(start[k].overrun_rate > 0.0 && end[k].overrun_rate < 0.0)) continue;
    const double rise = start[k].overrun + step.step() * start[k].overrun_rate;
    const double fall = end[k].overrun - step.step() * end[k].overrun_rate;
    if (std::max(rise, fall) <= 0.0) continue;
    const auto look = [&](double share) { return find_gap_at(share, k, step, workspace); };
    std::uintmax_t most = 60;
    const auto top = boost::math::tools::toms748_solve([&](double share) { return look(share).overrun_rate; }, 0.0, 1.0,
                                                       start[k].overrun_rate, end[k].overrun_rate,
                                                       boost::math::tools::eps_tolerance<double>(kShareBits), most);
    if (look(top.first).overrun > 0.0) return top.first;
  }
  return std::nullopt;
}

}  // namespace gudgeon
