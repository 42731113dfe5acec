// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The words that the reader reads.
#include "gudgeon/io/field_writer.h"

#include <algorithm>

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

/// The lines of a table of its own.
template <Described Owner>
std::string lines_of(const Owner& owner, SharedTableNames& shared) {
  TomlLines lines;
  FieldWriter(lines, shared).write(owner);
  return lines.text();
}

}  // namespace

std::string SharedTableNames::name_of(const Material& material) {
  return find_name(materials_, material.name, lines_of(material, *this));
}

std::string SharedTableNames::name_of(const ContactProperties& contact) {
  return find_name(contacts_, contact.name, lines_of(contact, *this));
}

void SharedTableNames::write(TomlLines& out) const {
  const auto write_all = [&](std::string_view section, const Tables& tables) {
    for (const auto& [name, text] : tables) {
      out.header(section, name);
      out.raw(text);
    }
  };
  write_all("contacts", contacts_);
  write_all("materials", materials_);
}

/// The name under which that text is written: the wished one unless another text has it.
std::string SharedTableNames::find_name(Tables& tables, const std::string& wished, const std::string& text) {
  std::string name = wished;
  for (int i = 2;; ++i) {
    bool taken = false;
    for (const auto& [known_name, known_text] : tables) {
      if (known_name != name) continue;
      if (known_text == text) return name;
      taken = true;
    }
    if (!taken) break;
    name = fmt::format("{}_{}", wished, i);
  }
  tables.emplace_back(name, text);
  return name;
}

void FieldWriter::write_function(std::string_view key, const FieldTraits& traits, const Function& value,
                                 Interpolation fallback) {
  out_.line(key, function_text(traits, value, fallback));
}

void FieldWriter::write_constants() {
  std::string text;
  for (const auto& [name, value] : constants_) {
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", name, toml_number(value));
  }
  if (!text.empty()) out_.line("constants", fmt::format("{{ {} }}", text));
  constants_.clear();
}

void FieldWriter::write_value(std::string_view key, const FieldTraits& traits, const std::vector<Point>& points) {
  for (const Point& point : points) {
    out_.line(fmt::format("{}.{}", key, point.name), toml_vector(point.position, traits.dimension));
  }
}

void FieldWriter::write_value(std::string_view key, const FieldTraits& /*traits*/,
                              const std::vector<ReferenceValue>& values) {
  for (const ReferenceValue& value : values) {
    out_.raw(fmt::format("\n[[study.{}]]\n", key));
    write(value);
  }
}

std::string FieldWriter::text_of(const FieldTraits& /*traits*/, const std::vector<double>& values) {
  return numbers_text(values);
}

std::string FieldWriter::function_text(const FieldTraits& traits, const Function& value, Interpolation fallback) {
  if (const auto* constant = std::get_if<double>(&value)) return toml_quantity(*constant, traits.dimension);
  if (const auto* curve = std::get_if<SampledCurve>(&value)) return curve_text(*curve, fallback, traits.dimension);
  const auto& expression = std::get<Expression>(value);
  for (const auto& constant : expression.constants) {
    if (std::ranges::find(constants_, constant) == constants_.end()) constants_.push_back(constant);
  }
  return expression_text(expression);
}

}  // namespace gudgeon
