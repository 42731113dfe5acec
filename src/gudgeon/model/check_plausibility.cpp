// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Values that are possible, but look like a slip of the unit: an inertia no body of that size has, a length far beyond
// all others.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "gudgeon/geometry/longest_distance.h"
#include "gudgeon/model/check_rules.h"

namespace gudgeon {

namespace {

/// Of the distance from a body's centre of mass to its farthest point, and of the longest body: bodies reach beyond the
/// points that joints hold on to, a crank's flywheel by a few times.
constexpr double kLargestGyration = 5.0;
constexpr double kLargestPart = 2.0;
/// Millimetres taken for metres are a thousand times; machines of one kind of part and another are not.
constexpr double kFarBeyond = 100.0;

/// A length of the model as the user gave it.
struct Length {
  std::string subject;  ///< "joint 'guide': start displacement"
  std::string path;
  double value = 0.0;  ///< [m] its size
};

/// The largest distance between any two of a body's points and its centre of mass.
double find_extent(const Body& body) {
  std::vector<Vec2> places;
  for (const Point& point : body.points) places.push_back(point.position);
  if (body.name != kFrameName) places.push_back(body.center_of_mass);
  return find_longest_distance(places);
}

double find_reach(const Body& body) {
  double reach = 0.0;
  for (const Point& point : body.points) reach = std::max(reach, norm(point.position - body.center_of_mass));
  return reach;
}

/// "1.58 m", or below a metre "75 mm".
std::string print_length(double meters) {
  return meters < 1.0 ? fmt::format("{:.3g} mm", 1e3 * meters) : fmt::format("{:.3g} m", meters);
}

/// Bodies whose angle an ideal guide or a weld of the frame keeps: their inertia is of no account. One entry a body.
std::vector<bool> list_kept_from_turning(const CheckRules& rules) {
  std::vector<bool> kept(rules.mechanism.bodies.size(), false);
  for (const Joint& joint : rules.mechanism.joints) {
    if (!std::holds_alternative<Prismatic>(joint.kind) && !std::holds_alternative<Rigid>(joint.kind)) continue;
    const auto [first, second] = anchors(joint.kind);
    if (first.body != kFrameName && second.body != kFrameName) continue;
    const int body = rules.names.find_body(first.body == kFrameName ? second.body : first.body);
    if (body >= 0) kept[body] = true;
  }
  return kept;
}

void remark_inertia(CheckRules& rules, const Body& body, double largest_extent) {
  const double gyration = std::sqrt(body.inertia / body.mass);
  // A flywheel is larger than the crank it sits on, but not far larger than all of the mechanism.
  const double reach = find_reach(body);
  const double limit = std::max(kLargestGyration * reach, kLargestPart * largest_extent);
  if (!(limit > 0.0) || !(gyration > limit) || !std::isfinite(gyration)) return;
  const std::string path = fmt::format("bodies.{}.inertia", body.name);
  const std::string seen = reach > 0.0
                               ? fmt::format("its farthest point is {} from its centre of mass", print_length(reach))
                               : fmt::format("the largest body is {} long", print_length(largest_extent));
  std::vector<std::string> notes;
  if (const double extent = find_extent(body); extent > 0.0) {
    notes.push_back(fmt::format("a slender bar of {} and {:.3g} kg has {:.2g} kg m^2", print_length(extent), body.mass,
                                body.mass * extent * extent / 12.0));
  }
  rules.diagnostics.remark(
      "R-MODEL-130", path,
      fmt::format("body '{}': inertia is {}, a radius of gyration of {} for its {:.3g} kg, while {}", body.name,
                  rules.describe({"", path, body.inertia, dimension::kInertia}), print_length(gyration), body.mass,
                  seen),
      std::move(notes));
}

void add_length(std::vector<Length>& lengths, std::string subject, std::string path, std::optional<double> value) {
  if (value && std::abs(*value) > 0.0) lengths.push_back({std::move(subject), std::move(path), std::abs(*value)});
}

/// One of every body, start displacement, free length and driven slide.
std::vector<Length> list_lengths(const Mechanism& mechanism) {
  std::vector<Length> lengths;
  for (const Body& body : mechanism.bodies) {
    add_length(lengths, fmt::format("body '{}': its extent", body.name), fmt::format("bodies.{}.points", body.name),
               find_extent(body));
  }
  for (const Joint& joint : mechanism.joints) {
    const auto* slide = std::get_if<Prismatic>(&joint.kind);
    if (slide == nullptr) continue;
    add_length(lengths, fmt::format("joint '{}': start displacement", joint.name),
               fmt::format("joints.{}.start.displacement", joint.name), slide->start.displacement);
  }
  for (const Load& load : mechanism.loads) {
    const auto* spring = std::get_if<Spring>(&load.kind);
    if (spring == nullptr) continue;
    add_length(lengths, fmt::format("load '{}': free_length", load.name),
               fmt::format("loads.{}.free_length", load.name), spring->free_length);
  }
  for (const Driver& driver : mechanism.drivers) {
    if (!std::holds_alternative<DrivenSlide>(driver.target) || !driver.is_uniform()) continue;
    add_length(lengths, fmt::format("driver '{}': start", driver.name), fmt::format("drivers.{}.start", driver.name),
               driver.start);
  }
  return lengths;
}

/// The middle one of all lengths but one of that value; nothing when it is the only one.
std::optional<double> find_usual_length(const std::vector<double>& sorted, double but) {
  if (sorted.size() < 2) return std::nullopt;
  const std::size_t middle = (sorted.size() - 1) / 2;
  return but > sorted[middle] ? sorted[middle] : sorted[middle + 1];
}

void remark_lengths(CheckRules& rules) {
  const std::vector<Length> lengths = list_lengths(rules.mechanism);
  std::vector<double> sorted;
  for (const Length& length : lengths) sorted.push_back(length.value);
  std::ranges::sort(sorted);
  for (const Length& length : lengths) {
    const std::optional<double> usual = find_usual_length(sorted, length.value);
    if (!usual || !(length.value > kFarBeyond * *usual) || !std::isfinite(length.value)) continue;
    rules.diagnostics.remark("R-MODEL-131", length.path,
                             fmt::format("{} is {}, {:.0f} times the usual length of this model, {}", length.subject,
                                         print_length(length.value), length.value / *usual, print_length(*usual)),
                             {"a number without unit is in metres"});
  }
}

}  // namespace

void check_plausibility(CheckRules& rules) {
  double largest_extent = 0.0;
  for (const Body& body : rules.mechanism.bodies) largest_extent = std::max(largest_extent, find_extent(body));
  const std::vector<bool> kept = list_kept_from_turning(rules);
  for (std::size_t b = 0; b < kept.size(); ++b) {
    const Body& body = rules.mechanism.bodies[b];
    if (body.name != kFrameName && !kept[b]) remark_inertia(rules, body, largest_extent);
  }
  remark_lengths(rules);
}

}  // namespace gudgeon
