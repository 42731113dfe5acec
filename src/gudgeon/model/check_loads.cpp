// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rules for loads: what they act on, and the ranges of springs.
#include <fmt/format.h>

#include "gudgeon/model/check_rules.h"

namespace gudgeon {

namespace {

class LoadCheck {
 public:
  LoadCheck(CheckRules& rules, const std::string& name)
      : rules_(rules), subject_(fmt::format("load '{}'", name)), path_(fmt::format("loads.{}", name)) {}

  void operator()(const ConstantForce& load) {
    check_anchor(rules_, subject_, path_ + ".point", load.point);
    rules_.check_finite(subject_, path_ + ".force", load.force);
    if (load.point.body == kFrameName) remark_frame(".point");
  }

  void operator()(const ConstantTorque& load) {
    check_body(".body", load.body);
    check_number("torque", load.torque, dimension::kTorque, {});
    if (load.body == kFrameName) remark_frame(".body");
  }

  void operator()(const VariableForce& load) {
    check_anchor(rules_, subject_, path_ + ".point", load.point);
    check_body(".axes", load.axes);
    check_function(rules_, {subject_ + ": x of force", path_, "force.0", dimension::kForce}, load.x);
    check_function(rules_, {subject_ + ": y of force", path_, "force.1", dimension::kForce}, load.y);
    if (load.point.body == kFrameName) remark_frame(".point");
  }

  void operator()(const VariableTorque& load) {
    const bool body = check_body(".body", load.body);
    const bool against = check_body(".against", load.against);
    if (body && against) check_different(".against", load.body, load.against);
    check_function(rules_, {subject_ + ": torque", path_, "torque", dimension::kTorque}, load.torque);
  }

  void operator()(const Spring& load) {
    check_points(load.first, load.second);
    check_number("stiffness", load.stiffness, dimension::kStiffness, kNotNegative);
    check_number("damping", load.damping, dimension::kDamping, kNotNegative);
    check_number("free_length", load.free_length, dimension::kLength, kNotNegative);
    remark_idle(load.stiffness == 0.0 && load.damping == 0.0);
  }

  void operator()(const TorsionSpring& load) {
    const bool first = check_body(".between.0", load.first);
    const bool second = check_body(".between.1", load.second);
    if (first && second) check_different(".between", load.first, load.second);
    check_number("stiffness", load.stiffness, dimension::kAngularStiffness, kNotNegative);
    check_number("damping", load.damping, dimension::kAngularDamping, kNotNegative);
    check_number("free_angle", load.free_angle, dimension::kAngle, {});
    remark_idle(load.stiffness == 0.0 && load.damping == 0.0);
  }

  void operator()(const Bushing& load) {
    check_points(load.first, load.second);
    check_number("stiffness.0", load.stiffness.x, dimension::kStiffness, kNotNegative);
    check_number("stiffness.1", load.stiffness.y, dimension::kStiffness, kNotNegative);
    check_number("damping.0", load.damping.x, dimension::kDamping, kNotNegative);
    check_number("damping.1", load.damping.y, dimension::kDamping, kNotNegative);
    check_number("angular_stiffness", load.angular_stiffness, dimension::kAngularStiffness, kNotNegative);
    check_number("angular_damping", load.angular_damping, dimension::kAngularDamping, kNotNegative);
    check_number("free_angle", load.free_angle, dimension::kAngle, {});
    remark_idle(load.stiffness == Vec2{} && load.damping == Vec2{} && load.angular_stiffness == 0.0 &&
                load.angular_damping == 0.0);
  }

 private:
  void check_number(const std::string& key, double value, Dimension dimension, const ParameterRange& range) {
    const bool free = range.minimum == -kUnbounded;
    // "stiffness.0" is the x component.
    const auto dot = key.find('.');
    const std::string subject =
        dot == std::string::npos ? subject_ : fmt::format("{}: {}", subject_, key.substr(0, dot));
    rules_.check_range(free ? "E-MODEL-005" : "E-MODEL-052", {subject, path_ + "." + key, value, dimension}, range);
  }

  bool check_body(const char* key, const std::string& body) {
    if (rules_.names.find_body(body) >= 0) return true;
    rules_.report_unknown("E-MODEL-050", path_ + key, fmt::format("{} acts on unknown body '{}'", subject_, body), body,
                          "bodies", list_names(rules_.mechanism.bodies));
    return false;
  }

  void check_different(const char* key, const std::string& first, const std::string& second) {
    if (first != second) return;
    rules_.diagnostics.error("E-MODEL-051", path_ + key,
                             fmt::format("{} acts on body '{}' and against it, which does nothing", subject_, first));
  }

  void check_points(const Anchor& first, const Anchor& second) {
    check_anchor(rules_, subject_, path_ + ".between.0", first);
    check_anchor(rules_, subject_, path_ + ".between.1", second);
    if (first.body != second.body || first.body.empty()) return;
    rules_.diagnostics.error("E-MODEL-051", path_ + ".between",
                             fmt::format("{} connects body '{}' with itself", subject_, first.body));
  }

  void remark_frame(const char* key) {
    rules_.diagnostics.remark("R-MODEL-108", path_ + key,
                              fmt::format("{} acts on the frame alone, which does not move", subject_));
  }

  void remark_idle(bool idle) {
    if (!idle) return;
    rules_.diagnostics.remark("R-MODEL-109", path_, fmt::format("{} has neither stiffness nor damping", subject_));
  }

  CheckRules& rules_;
  std::string subject_;
  std::string path_;
};

}  // namespace

void check_loads(CheckRules& rules) {
  for (const Load& load : rules.mechanism.loads) std::visit(LoadCheck{rules, load.name}, load.kind);
}

}  // namespace gudgeon
