// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rules for loads: what they act on, and the ranges of springs.
#include <fmt/format.h>

#include "gudgeon/model/check_fields.h"

namespace gudgeon {

namespace {

class LoadCheck {
 public:
  LoadCheck(CheckRules& rules, const std::string& name)
      : rules_(rules), subject_(fmt::format("load '{}'", name)), path_(fmt::format("loads.{}", name)) {}

  /// What its keys say, then what they say together.
  template <class Kind>
  void operator()(const Kind& load) {
    FieldCheck(rules_, subject_, path_).check(load);
    check_rest(load);
  }

 private:
  void check_rest(const ConstantForce& load) { remark_frame(".point", load.point.body); }

  void check_rest(const ConstantTorque& load) {
    check_body(".body", load.body);
    remark_frame(".body", load.body);
  }

  void check_rest(const VariableForce& load) {
    check_body(".axes", load.axes);
    remark_frame(".point", load.point.body);
  }

  void check_rest(const VariableTorque& load) {
    const bool body = check_body(".body", load.body);
    const bool against = check_body(".against", load.against);
    if (body && against) check_different(".against", load.body, load.against);
  }

  void check_rest(const Spring& load) {
    check_points(load.first, load.second);
    remark_idle(load.stiffness == 0.0 && load.damping == 0.0);
  }

  void check_rest(const TorsionSpring& load) {
    const bool first = check_body(".between.0", load.first);
    const bool second = check_body(".between.1", load.second);
    if (first && second) check_different(".between", load.first, load.second);
    remark_idle(load.stiffness == 0.0 && load.damping == 0.0);
  }

  void check_rest(const Bushing& load) {
    check_points(load.first, load.second);
    remark_idle(load.stiffness == Vec2{} && load.damping == Vec2{} && load.angular_stiffness == 0.0 &&
                load.angular_damping == 0.0);
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
    if (first.body != second.body || first.body.empty()) return;
    rules_.diagnostics.error("E-MODEL-051", path_ + ".between",
                             fmt::format("{} connects body '{}' with itself", subject_, first.body));
  }

  void remark_frame(const char* key, const std::string& body) {
    if (body != kFrameName) return;
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
