// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Given values beside those of the assembled poses.
#include "gudgeon/system/start_remarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gudgeon/system/motion_chart.h"
#include "gudgeon/system/start_quantity.h"

namespace gudgeon {

namespace {

using Kind = GivenStart::Kind;

constexpr double kDegrees = 180.0 / std::numbers::pi;  // [deg/rad]
// [rad, shares of the size] What differs by less is the same number written twice.
constexpr double kSameStart = 1e-9;
// Rates are had to so much of themselves.
constexpr double kSameRate = 1e-9;
// So many guesses are named.
constexpr std::size_t kMostNamed = 3;

bool is_driven_angle(const Mechanism& mechanism, const std::string& body) {
  return std::ranges::any_of(mechanism.drivers, [&](const Driver& driver) {
    const auto* angle = std::get_if<DrivenAngle>(&driver.target);
    return angle != nullptr && angle->body == body;
  });
}

// The driver of a body's angle against the frame, or of a guide; nullptr without one.
const Driver* find_driver(const Mechanism& mechanism, const GivenStart& given) {
  const auto found = std::ranges::find_if(mechanism.drivers, [&](const Driver& driver) {
    if (const auto* slide = std::get_if<DrivenSlide>(&driver.target)) {
      return given.kind == Kind::displacement && slide->joint == mechanism.joints[given.index].name;
    }
    const auto& angle = std::get<DrivenAngle>(driver.target);
    return given.kind == Kind::angle && angle.against == kFrameName && angle.body == mechanism.bodies[given.index].name;
  });
  return found == mechanism.drivers.end() ? nullptr : &*found;
}

// Displacement of a guide and its rate, as its first body sees it.
std::pair<double, double> find_sliding(const Mechanism& mechanism, const Assembly& assembly, const Prismatic& guide) {
  const auto find_motion = [&](const Anchor& anchor) {
    const int body = find_body(mechanism, anchor.body);
    const BodyPose& pose = assembly.poses[body];
    const Vec2 place = pose.find_point(find_point(mechanism.bodies[body], anchor.point)->position);
    return std::pair{place, pose.velocity + pose.angle_rate * perp(place - pose.position)};
  };
  const auto [first, first_velocity] = find_motion(guide.first);
  const auto [second, second_velocity] = find_motion(guide.second);
  const BodyPose& carrier = assembly.poses[find_body(mechanism, guide.first.body)];
  const Rotation along = make_rotation(carrier.angle + guide.direction);
  const Vec2 axis{along.c, along.s};
  const Vec2 apart = second - first;
  return {dot(axis, apart), dot(axis, second_velocity - first_velocity) + carrier.angle_rate * cross(axis, apart)};
}

// What the assembled mechanism has in place of a given position, and of a given rate.
std::pair<double, double> find_had(const Mechanism& mechanism, const Assembly& assembly, const GivenStart& given) {
  if (given.kind == Kind::displacement) {
    return find_sliding(mechanism, assembly, std::get<Prismatic>(mechanism.joints[given.index].kind));
  }
  const BodyPose& pose = assembly.poses[given.index];
  if (given.kind == Kind::angle) return {pose.angle, pose.angle_rate};
  return given.kind == Kind::x ? std::pair{pose.position.x, pose.velocity.x}
                               : std::pair{pose.position.y, pose.velocity.y};
}

void remark_held_angles(const Mechanism& mechanism, const Assembly& assembly, Diagnostics& diagnostics) {
  for (const int b : assembly.held_bodies) {
    const Body& body = mechanism.bodies[b];
    if (is_driven_angle(mechanism, body.name)) continue;
    const double given = *body.start.angle;
    diagnostics.remark(
        "R-MODEL-110", "bodies." + body.name + ".start.angle",
        fmt::format("body '{}': its start angle is {:.6g} deg, and it starts at {:.6g} deg", body.name,
                    kDegrees * given, kDegrees * (given + assembly.angle_changes[b])),
        {"its joints, a slot taken as an ideal guide among them, or a body tied to it leave it no other angle"});
  }
}

void remark_driven_rates(const Mechanism& mechanism, const Assembly& assembly, Diagnostics& diagnostics) {
  for (const GivenStart& given : list_given_rates(mechanism)) {
    const Driver* driver = find_driver(mechanism, given);
    if (driver == nullptr) continue;
    const double had = find_had(mechanism, assembly, given).second;
    if (std::abs(had - given.value) <= kSameRate * std::max(std::abs(had), std::abs(given.value))) continue;
    diagnostics.remark(
        "R-MODEL-107", given.path,
        fmt::format("{} is {:.6g} {unit}, driver '{}' starts with {:.6g} {unit}; the driver's holds", given.name,
                    given.value, driver->name, had, fmt::arg("unit", given.kind == Kind::angle ? "rad/s" : "m/s")));
  }
}

struct GuessChange {
  GivenStart given;
  double change = 0.0;  // [rad, m]
  double share = 0.0;   // [rad, shares of the size]
};

std::string describe_change(const GuessChange& one) {
  const bool turns = one.given.kind == Kind::angle;
  const double unit = turns ? kDegrees : 1e3;
  return fmt::format("{} is {:.6g} {}, and it starts {:.3g} {} from there", one.given.name, unit * one.given.value,
                     turns ? "deg" : "mm", unit * std::abs(one.change), turns ? "deg" : "mm");
}

void remark_guesses(const Mechanism& mechanism, const Assembly& assembly, Diagnostics& diagnostics) {
  const double size = find_longest_arm(mechanism);
  std::vector<GuessChange> changes;
  for (const GivenStart& given : list_given_positions(mechanism)) {
    if (find_driver(mechanism, given) != nullptr) continue;
    if (given.kind == Kind::angle && std::ranges::find(assembly.held_bodies, given.index) != assembly.held_bodies.end())
      continue;
    const double change = -find_way(given, find_had(mechanism, assembly, given).first);
    const double share = std::abs(change) / (given.kind == Kind::angle ? 1.0 : size);
    if (share > kSameStart) changes.push_back({given, change, share});
  }
  if (changes.empty()) return;
  std::ranges::sort(changes, std::ranges::greater{}, &GuessChange::share);
  std::vector<std::string> notes;
  for (std::size_t k = 1; k < std::min(changes.size(), kMostNamed); ++k) notes.push_back(describe_change(changes[k]));
  if (changes.size() > kMostNamed) notes.push_back(fmt::format("and {} more", changes.size() - kMostNamed));
  notes.emplace_back("what closed loops determine is a guess, which chooses the branch");
  diagnostics.remark("R-MODEL-111", changes.front().given.path, describe_change(changes.front()), notes);
}

// How far off the middle of its bearing a journal starts [m]; across, where it lies in a slot.
double find_eccentricity(const Mechanism& mechanism, const Assembly& assembly, const AnyJoint& joint) {
  const auto [first, second] = anchors(joint);
  const auto find_place = [&](const Anchor& anchor) {
    const int body = find_body(mechanism, anchor.body);
    return assembly.poses[body].find_point(find_point(mechanism.bodies[body], anchor.point)->position);
  };
  const Vec2 apart = find_place(second) - find_place(first);
  const double angle = assembly.poses[find_body(mechanism, first.body)].angle;
  return std::visit(
      [&]<class JointKind>(const JointKind& kind) {
        if constexpr (requires { kind.bearing_length; }) {
          const Rotation along = make_rotation(angle + kind.direction);
          return std::abs(cross(Vec2{along.c, along.s}, apart));
        } else {
          return norm(apart);
        }
      },
      joint);
}

void remark_off_centre(const Mechanism& mechanism, const Assembly& assembly, Diagnostics& diagnostics) {
  for (const Joint& joint : mechanism.joints) {
    if (!has_clearance(joint.kind)) continue;
    const double off = find_eccentricity(mechanism, assembly, joint.kind);
    const double clearance = find_clearance(joint.kind);
    if (off <= kSameStart * clearance) continue;
    diagnostics.remark("R-MODEL-112", "joints." + joint.name,
                       fmt::format("joint '{}': its journal starts {:.4g} mm off the middle of its bearing; its "
                                   "clearance is {:.4g} mm",
                                   joint.name, 1e3 * off, 1e3 * clearance));
  }
}

}  // namespace

Diagnostics remark_start(const Mechanism& mechanism, const Assembly& assembly) {
  Diagnostics diagnostics;
  remark_held_angles(mechanism, assembly, diagnostics);
  remark_driven_rates(mechanism, assembly, diagnostics);
  remark_guesses(mechanism, assembly, diagnostics);
  remark_off_centre(mechanism, assembly, diagnostics);
  return diagnostics;
}

Diagnostics remark_ideal_start(const Mechanism& mechanism, const Study& study) {
  Diagnostics diagnostics;
  const bool compares = study.compare_ideal && std::ranges::any_of(mechanism.joints, [](const Joint& joint) {
                          return has_clearance(joint.kind);
                        });
  if (!compares || assemble_ideal(mechanism)) return diagnostics;
  diagnostics.remark("R-MODEL-113", "study.compare_ideal",
                     "there is no ideal mechanism to compare with: it closes, or starts as asked, only thanks to its "
                     "clearance",
                     {"the run leaves its ideal stage out"});
  return diagnostics;
}

}  // namespace gudgeon
