// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Writes a description by its table of keys, as a model file that reads back the same.
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "gudgeon/io/toml_lines.h"
#include "gudgeon/laws/law.h"
#include "gudgeon/model/mechanism.h"
#include "gudgeon/model/study.h"

namespace gudgeon {

/// Materials and contacts, which descriptions hold by value and a model file by name. Two that share a name may differ
/// when a program made them.
class SharedTableNames {
 public:
  std::string name_of(const Material& material);
  std::string name_of(const ContactProperties& contact);
  /// [contacts.NAME], then [materials.NAME].
  void write(TomlLines& out) const;

 private:
  using Tables = std::vector<std::pair<std::string, std::string>>;
  static std::string find_name(Tables& tables, const std::string& wished, const std::string& text);

  Tables contacts_;  // names and texts
  Tables materials_;
};

class FieldWriter {
 public:
  FieldWriter(TomlLines& out, SharedTableNames& shared) : out_(out), shared_(shared) {}

  template <Described Owner>
  void write(const Owner& owner) {
    write(Owner::kFields, owner);
  }
  /// Those of its keys.
  template <class Fields, class Owner>
  void write(const Fields& fields, const Owner& owner) {
    for_each_field(fields, [&](const auto& one) { write_field(one, owner); });
    write_constants();
  }

  /// A function, its constants left to write_constants.
  void write_function(std::string_view key, const FieldTraits& traits, const Function& value, Interpolation fallback);
  /// The constants of all formulas written so far in one table, as they share them in a model file.
  void write_constants();

 private:
  template <class Owner, class Value>
  void write_field(const Field<Owner, Value>& one, const Owner& owner) {
    write_value(one.key, one.traits, owner.*one.member);
  }
  /// A law, with the sizes that a joint of that type has beside it.
  template <class Owner>
  void write_field(const Field<Owner, std::optional<JointFriction>>& one, const Owner& owner) {
    const std::optional<JointFriction>& friction = owner.*one.member;
    if (friction) {
      out_.line(one.key,
                fmt::format("{{ {}, {} }}", entries_of(friction->law), entries_of(Owner::kFrictionFields, *friction)));
    }
  }
  template <class Owner, class Value>
  void write_field(const PairField<Owner, Value>& one, const Owner& owner) {
    out_.line(one.key,
              fmt::format("[{}, {}]", text_of(one.traits, owner.*one.first), text_of(one.traits, owner.*one.second)));
  }

  template <class Value>
  void write_value(std::string_view key, const FieldTraits& traits, const Value& value) {
    if (const std::optional<std::string> text = text_of(traits, value)) out_.line(key, *text);
  }
  void write_value(std::string_view key, const FieldTraits& traits, const std::vector<Point>& points);
  void write_value(std::string_view key, const FieldTraits& traits, const std::vector<ReferenceValue>& values);

  // What stands behind "key = "; nothing for what is not set.
  static std::string text_of(const FieldTraits& traits, double value) { return toml_quantity(value, traits.dimension); }
  static std::string text_of(const FieldTraits& traits, Vec2 value) { return toml_vector(value, traits.dimension); }
  static std::string text_of(const FieldTraits& traits, const std::vector<double>& values);
  template <std::same_as<int> Count>
  static std::string text_of(const FieldTraits& /*traits*/, Count value) {
    return fmt::format("{}", value);
  }
  template <std::same_as<bool> Switch>
  static std::string text_of(const FieldTraits& /*traits*/, Switch value) {
    return value ? "true" : "false";
  }
  template <class Choice>
  requires std::is_enum_v<Choice>
  static std::string text_of(const FieldTraits& /*traits*/, Choice value) {
    return toml_text(choice_name<Choice>(choices(value), value));
  }
  static std::string text_of(const FieldTraits& /*traits*/, const std::string& value) { return toml_text(value); }
  static std::string text_of(const FieldTraits& /*traits*/, const Anchor& value) { return toml_point(value); }
  template <std::same_as<Function> Any>
  std::string text_of(const FieldTraits& traits, const Any& value) {
    return function_text(traits, value, kLoadInterpolation);
  }
  template <std::same_as<Material> Shared>
  std::string text_of(const FieldTraits& /*traits*/, const Shared& value) {
    return toml_text(shared_.name_of(value));
  }
  template <std::same_as<ContactProperties> Shared>
  std::string text_of(const FieldTraits& /*traits*/, const Shared& value) {
    return toml_text(shared_.name_of(value));
  }
  template <LawValue... Laws>
  static std::string text_of(const FieldTraits& /*traits*/, const std::variant<Laws...>& value) {
    return fmt::format("{{ {} }}", entries_of(value));
  }
  template <class Value>
  std::optional<std::string> text_of(const FieldTraits& traits, const std::optional<Value>& value) {
    if (!value) return std::nullopt;
    return text_of(traits, *value);
  }
  /// A table within, on one line.
  template <TableWithin Value>
  std::optional<std::string> text_of(const FieldTraits& /*traits*/, const Value& value) {
    const std::string entries = entries_of(Value::kFields, value);
    if (entries.empty()) return std::nullopt;
    return fmt::format("{{ {} }}", entries);
  }

  // "key = value, key = value" of what is set.
  template <class Fields, class Owner>
  std::string entries_of(const Fields& fields, const Owner& owner) {
    std::string entries;
    for_each_field(fields, [&](const auto& one) {
      const std::optional<std::string> text = text_of(one.traits, owner.*one.member);
      if (text) entries += fmt::format("{}{} = {}", entries.empty() ? "" : ", ", one.key, *text);
    });
    return entries;
  }
  template <LawValue... Laws>
  static std::string entries_of(const std::variant<Laws...>& any) {
    return std::visit(
        []<class Law>(const Law& law) {
          std::string entries = fmt::format("law = \"{}\"", Law::kName);
          for (const Parameter<Law>& parameter : Law::kParameters) {
            entries +=
                fmt::format(", {} = {}", parameter.key, toml_quantity(law.*parameter.member, parameter.dimension));
          }
          if constexpr (NestsDamping<Law>) entries += fmt::format(", damping = {{ {} }}", entries_of(law.damping));
          return entries;
        },
        any);
  }

  std::string function_text(const FieldTraits& traits, const Function& value, Interpolation fallback);

  TomlLines& out_;
  SharedTableNames& shared_;
  std::vector<std::pair<std::string, double>> constants_;  // of the formulas so far
};

}  // namespace gudgeon
