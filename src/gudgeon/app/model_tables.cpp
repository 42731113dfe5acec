// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Tables of what a model describes.
#include "gudgeon/app/model_tables.h"

#include <fmt/format.h>

#include <variant>

#include "gudgeon/app/table_units.h"
#include "gudgeon/base/curve.h"
#include "gudgeon/base/expression.h"
#include "gudgeon/report/table.h"

namespace gudgeon {
namespace {

std::string point_text(const Anchor& anchor) { return anchor.body + "." + anchor.point; }

/// "0.1 mm radial", "0.2 mm a side"; nothing for an ideal joint.
std::string play_text(const AnyJoint& joint) {
  if (!has_clearance(joint)) return {};
  const bool round = std::holds_alternative<RevoluteClearance>(joint);
  return fmt::format("{:.6g} mm {}", find_clearance(joint) / kMillimeter, round ? "radial" : "a side");
}

/// "coulomb_smooth" of an ideal joint that rubs, or of a contact; nothing without friction.
std::string friction_text(const AnyJoint& joint) {
  const JointFriction* ideal = find_friction(joint);
  const ContactProperties* contact = find_contact(joint);
  if (ideal == nullptr && contact == nullptr) return {};
  const AnyFriction& law = ideal != nullptr ? ideal->law : contact->friction;
  return std::holds_alternative<Frictionless>(law) ? std::string{} : std::string(law_name(law));
}

std::string function_text(const Function& function, std::string_view unit) {
  if (const auto* constant = std::get_if<double>(&function)) return fmt::format("{:.6g} {}", *constant, unit);
  if (const auto* expression = std::get_if<Expression>(&function)) return expression->text;
  const auto& curve = std::get<SampledCurve>(function);
  return fmt::format("{} points over {}{}", curve.arguments.size(), curve.over, curve.periodic ? ", periodic" : "");
}

/// Type of a load, what it acts on, and how strong it is.
struct LoadText {
  std::string type;
  std::string on;
  std::string strength;
};

LoadText describe(const ConstantForce& load) {
  return {"force", point_text(load.point), fmt::format("[{:.6g}, {:.6g}] N", load.force.x, load.force.y)};
}
LoadText describe(const ConstantTorque& load) { return {"torque", load.body, fmt::format("{:.6g} N m", load.torque)}; }
LoadText describe(const VariableForce& load) {
  const std::string axes = load.axes == kFrameName ? "" : fmt::format(" in the axes of {}", load.axes);
  return {"force", point_text(load.point),
          fmt::format("[{}, {}]{}", function_text(load.x, "N"), function_text(load.y, "N"), axes)};
}
LoadText describe(const VariableTorque& load) {
  const std::string against = load.against == kFrameName ? "" : " against " + load.against;
  return {"torque", load.body + against, function_text(load.torque, "N m")};
}
LoadText describe(const Spring& load) {
  return {"spring", fmt::format("{} to {}", point_text(load.first), point_text(load.second)),
          fmt::format("{:.6g} N/m, {:.6g} N s/m, free at {:.6g} mm", load.stiffness, load.damping,
                      load.free_length / kMillimeter)};
}
LoadText describe(const TorsionSpring& load) {
  return {"torsion_spring", fmt::format("{} to {}", load.first, load.second),
          fmt::format("{:.6g} N m/rad, {:.6g} N m s/rad, free at {:.6g} deg", load.stiffness, load.damping,
                      load.free_angle / kDegree)};
}
LoadText describe(const Bushing& load) {
  return {
      "bushing", fmt::format("{} to {}", point_text(load.first), point_text(load.second)),
      fmt::format("[{:.6g}, {:.6g}] N/m, {:.6g} N m/rad", load.stiffness.x, load.stiffness.y, load.angular_stiffness)};
}

/// Where a driver is at t = 0 [rad or m].
double find_start(const Driver& driver) {
  const double start_time = 0.0;
  if (const auto* expression = std::get_if<Expression>(&driver.motion)) {
    return ExpressionEvaluator(expression->text, expression->constants, {"t"}).eval(&start_time);
  }
  if (const auto* curve = std::get_if<SampledCurve>(&driver.motion)) {
    return make_motion_curve(*curve).eval(start_time).value;
  }
  return driver.start;
}

std::string describe_motion(const Driver& driver, double scale, std::string_view unit) {
  if (const auto* expression = std::get_if<Expression>(&driver.motion)) return expression->text;
  if (const auto* curve = std::get_if<SampledCurve>(&driver.motion)) return function_text(*curve, unit);
  return fmt::format("{:.6g} {}/s", driver.speed / scale, unit);
}

}  // namespace

std::string render_joints(const Mechanism& mechanism, bool color) {
  Table table({{"joint"}, {"type"}, {"from"}, {"to"}, {"play"}, {"friction"}});
  for (const Joint& joint : mechanism.joints) {
    const auto [first, second] = anchors(joint.kind);
    table.add_row({joint.name, std::string(joint_type(joint.kind)), point_text(first), point_text(second),
                   play_text(joint.kind), friction_text(joint.kind)});
  }
  return table.empty() ? std::string{} : render_title("Joints", color) + table.render(color);
}

std::string render_loads(const Mechanism& mechanism, bool color) {
  std::string text = render_title("Loads", color);
  text += mechanism.gravity == Vec2{}
              ? "  gravity: none\n"
              : fmt::format("  gravity: [{:.6g}, {:.6g}] m/s^2\n", mechanism.gravity.x, mechanism.gravity.y);
  Table table({{"load"}, {"type"}, {"on"}, {"strength"}});
  for (const Load& load : mechanism.loads) {
    const LoadText row = std::visit([](const auto& kind) { return describe(kind); }, load.kind);
    table.add_row({load.name, row.type, row.on, row.strength});
  }
  return table.empty() ? text : text + table.render(color);
}

std::string render_drivers(const Mechanism& mechanism, bool color) {
  Table table({{"driver"}, {"drives"}, {"at t = 0", Alignment::right}, {"speed or motion", Alignment::right}});
  for (const Driver& driver : mechanism.drivers) {
    const auto* angle = std::get_if<DrivenAngle>(&driver.target);
    const double scale = angle != nullptr ? kDegree : kMillimeter;
    const std::string unit = angle != nullptr ? "deg" : "mm";
    std::string target = "slide of ";
    if (angle != nullptr) {
      target = "angle of " + angle->body + (angle->against == kFrameName ? "" : " against " + angle->against);
    } else {
      target += std::get<DrivenSlide>(driver.target).joint;
    }
    table.add_row({driver.name, target, fmt::format("{:.6g} {}", find_start(driver) / scale, unit),
                   describe_motion(driver, scale, unit)});
  }
  return table.empty() ? std::string{} : render_title("Drivers", color) + table.render(color);
}

}  // namespace gudgeon
