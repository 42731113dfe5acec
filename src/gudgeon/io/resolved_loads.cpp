// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Functions, drivers and loads in the words that the reader reads.
#include "gudgeon/io/resolved_loads.h"

#include <algorithm>
#include <initializer_list>
#include <vector>

#include "gudgeon/model/channel_names.h"

namespace gudgeon {

namespace {

std::string numbers_text(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ", ") + toml_number(number);
  return "[" + text + "]";
}

/// A cut-off or a tolerance in SI, told apart by its unit.
std::string smoothing_text(const SampledCurve& curve, Dimension dimension) {
  if (!curve.smoothing) return {};
  const Dimension over = find_channel_dimension(curve.over).value_or(dimension::kTime);
  const bool cut_off = curve.smoothing->frequency > 0.0;
  const Dimension unit = cut_off ? find_inverse(over) : dimension;
  return ", smoothing = " + toml_quantity(cut_off ? curve.smoothing->frequency : curve.smoothing->tolerance, unit);
}

std::string curve_text(const SampledCurve& curve, Interpolation fallback, Dimension dimension) {
  const Interpolation kind = curve.smoothing ? Interpolation::spline : curve.interpolation.value_or(fallback);
  return fmt::format("{{ over = {}, arguments = {}, values = {}, periodic = {}, interpolation = \"{}\"{} }}",
                     toml_text(curve.over), numbers_text(curve.arguments), numbers_text(curve.values),
                     curve.periodic ? "true" : "false", choice_name<Interpolation>(kInterpolations, kind),
                     smoothing_text(curve, dimension));
}

/// In parentheses where it would be taken for a quantity, "2*m".
std::string expression_text(const Expression& expression) {
  const bool like_quantity = std::holds_alternative<Quantity>(parse_quantity(expression.text));
  return toml_text(like_quantity ? "(" + expression.text + ")" : expression.text);
}

std::string function_text(const Function& function, Dimension dimension) {
  if (const auto* constant = std::get_if<double>(&function)) return toml_quantity(*constant, dimension);
  if (const auto* expression = std::get_if<Expression>(&function)) return expression_text(*expression);
  return curve_text(std::get<SampledCurve>(function), kLoadInterpolation, dimension);
}

/// The constants of all formulas of a load or driver in one table, as they share them in a model file.
void write_constants(std::initializer_list<const Function*> functions, TomlLines& out) {
  std::vector<std::pair<std::string, double>> constants;
  for (const Function* function : functions) {
    const auto* expression = std::get_if<Expression>(function);
    if (expression == nullptr) continue;
    for (const auto& constant : expression->constants) {
      if (std::ranges::find(constants, constant) == constants.end()) constants.push_back(constant);
    }
  }
  std::string text;
  for (const auto& [name, value] : constants) {
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", name, toml_number(value));
  }
  if (!text.empty()) out.line("constants", fmt::format("{{ {} }}", text));
}

void write_kind(const ConstantForce& load, TomlLines& out) {
  out.line("type", "\"force\"");
  out.line("point", toml_point(load.point));
  out.line("force", toml_vector(load.force, dimension::kForce));
}

void write_kind(const ConstantTorque& load, TomlLines& out) {
  out.line("type", "\"torque\"");
  out.line("body", toml_text(load.body));
  out.line("torque", toml_quantity(load.torque, dimension::kTorque));
}

void write_kind(const VariableForce& load, TomlLines& out) {
  out.line("type", "\"force\"");
  out.line("point", toml_point(load.point));
  out.line("axes", toml_text(load.axes));
  out.line("force",
           fmt::format("[{}, {}]", function_text(load.x, dimension::kForce), function_text(load.y, dimension::kForce)));
  write_constants({&load.x, &load.y}, out);
}

void write_kind(const VariableTorque& load, TomlLines& out) {
  out.line("type", "\"torque\"");
  out.line("body", toml_text(load.body));
  out.line("against", toml_text(load.against));
  out.line("torque", function_text(load.torque, dimension::kTorque));
  write_constants({&load.torque}, out);
}

void write_kind(const Spring& load, TomlLines& out) {
  out.line("type", "\"spring\"");
  out.line("between", fmt::format("[{}, {}]", toml_point(load.first), toml_point(load.second)));
  out.line("stiffness", toml_quantity(load.stiffness, dimension::kStiffness));
  out.line("damping", toml_quantity(load.damping, dimension::kDamping));
  out.line("free_length", toml_quantity(load.free_length, dimension::kLength));
}

void write_kind(const TorsionSpring& load, TomlLines& out) {
  out.line("type", "\"torsion_spring\"");
  out.line("between", fmt::format("[{}, {}]", toml_text(load.first), toml_text(load.second)));
  out.line("stiffness", toml_quantity(load.stiffness, dimension::kAngularStiffness));
  out.line("damping", toml_quantity(load.damping, dimension::kAngularDamping));
  out.line("free_angle", toml_quantity(load.free_angle, dimension::kAngle));
}

void write_kind(const Bushing& load, TomlLines& out) {
  out.line("type", "\"bushing\"");
  out.line("between", fmt::format("[{}, {}]", toml_point(load.first), toml_point(load.second)));
  out.line("stiffness", toml_vector(load.stiffness, dimension::kStiffness));
  out.line("damping", toml_vector(load.damping, dimension::kDamping));
  out.line("angular_stiffness", toml_quantity(load.angular_stiffness, dimension::kAngularStiffness));
  out.line("angular_damping", toml_quantity(load.angular_damping, dimension::kAngularDamping));
  out.line("free_angle", toml_quantity(load.free_angle, dimension::kAngle));
}

}  // namespace

void write_driver(const Driver& driver, TomlLines& out) {
  out.header("drivers", driver.name);
  const auto* angle = std::get_if<DrivenAngle>(&driver.target);
  if (angle != nullptr) {
    out.line("body", toml_text(angle->body));
    out.line("against", toml_text(angle->against));
  } else {
    out.line("slide", toml_text(std::get<DrivenSlide>(driver.target).joint));
  }
  if (const auto* expression = std::get_if<Expression>(&driver.motion)) {
    out.line("motion", expression_text(*expression));
    const Function motion = *expression;
    write_constants({&motion}, out);
  } else if (const auto* curve = std::get_if<SampledCurve>(&driver.motion)) {
    out.line("motion",
             curve_text(*curve, kMotionInterpolation, angle != nullptr ? dimension::kAngle : dimension::kLength));
  } else {
    out.line("start", toml_quantity(driver.start, angle != nullptr ? dimension::kAngle : dimension::kLength));
    out.line("speed", toml_quantity(driver.speed, angle != nullptr ? dimension::kAngularSpeed : dimension::kSpeed));
  }
}

void write_load(const Load& load, TomlLines& out) {
  out.header("loads", load.name);
  std::visit([&](const auto& kind) { write_kind(kind, out); }, load.kind);
}

}  // namespace gudgeon
