// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Reads a description by its table of keys. What is wrong becomes a diagnostic; a value that cannot be read is NaN or
// that of a default-constructed owner.
#pragma once

#include <concepts>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "gudgeon/io/read_function.h"
#include "gudgeon/io/read_law.h"
#include "gudgeon/io/table_reader.h"
#include "gudgeon/model/mechanism.h"
#include "gudgeon/model/study.h"

namespace gudgeon {

/// What other tables of the file name, and a description holds by value.
struct SharedTables {
  std::span<const Material> materials = {};
  std::span<const ContactProperties> contacts = {};
};

class FieldReader {
 public:
  explicit FieldReader(TableReader& table, const SharedTables& shared = {}) : table_(table), shared_(shared) {}

  template <Described Owner>
  void read(Owner& owner) {
    read(Owner::kFields, owner);
  }
  /// Those of its keys.
  template <class Fields, class Owner>
  void read(const Fields& fields, Owner& owner) {
    for_each_field(fields, [&](const auto& one) { read_field(one, owner); });
  }

 private:
  template <class Owner, class Value>
  void read_field(const Field<Owner, Value>& one, Owner& owner) {
    read_value(one.key, one.traits, owner.*one.member);
  }
  /// A law, with the sizes that a joint of that type has beside it.
  template <class Owner>
  void read_field(const Field<Owner, std::optional<JointFriction>>& one, Owner& owner) {
    auto within = table_.find_table(one.key, subject_of(one.key));
    if (!within) return;
    JointFriction& friction = (owner.*one.member).emplace();
    friction.law = read_law<AnyFriction>(*within);
    FieldReader(*within).read(Owner::kFrictionFields, friction);
    within->check_unknown_keys();
  }
  template <class Owner, class Value>
  void read_field(const PairField<Owner, Value>& one, Owner& owner) {
    read_pair(one.key, one.traits, owner.*one.first, owner.*one.second);
  }

  void read_value(std::string_view key, const FieldTraits& traits, double& value);
  void read_value(std::string_view key, const FieldTraits& traits, std::optional<double>& value);
  void read_value(std::string_view key, const FieldTraits& traits, Vec2& value);
  void read_value(std::string_view key, const FieldTraits& traits, std::optional<Vec2>& value);
  void read_value(std::string_view key, const FieldTraits& traits, int& value);
  void read_value(std::string_view key, const FieldTraits& traits, bool& value);
  void read_value(std::string_view key, const FieldTraits& traits, std::string& value);
  void read_value(std::string_view key, const FieldTraits& traits, Anchor& value);
  void read_value(std::string_view key, const FieldTraits& traits, Function& value);
  void read_value(std::string_view key, const FieldTraits& traits, Material& value);
  void read_value(std::string_view key, const FieldTraits& traits, ContactProperties& value);
  void read_value(std::string_view key, const FieldTraits& traits, std::vector<Point>& value);
  void read_value(std::string_view key, const FieldTraits& traits, std::vector<double>& value);
  void read_value(std::string_view key, const FieldTraits& traits, std::vector<ReferenceValue>& value);

  template <class Choice>
  requires std::is_enum_v<Choice>
  void read_value(std::string_view key, const FieldTraits& /*traits*/, Choice& value) {
    table_.update_choice<Choice>(key, choices(Choice{}), value);
  }
  template <class Choice>
  requires std::is_enum_v<Choice>
  void read_value(std::string_view key, const FieldTraits& traits, std::optional<Choice>& value) {
    if (table_.find(key) != nullptr) read_value(key, traits, value.emplace());
  }
  /// A table within.
  template <TableWithin Value>
  void read_value(std::string_view key, const FieldTraits& /*traits*/, Value& value) {
    auto within = table_.find_table(key, subject_of(key));
    if (!within) return;
    FieldReader(*within, shared_).read(value);
    within->check_unknown_keys();
  }
  /// A law of a family.
  template <LawValue... Laws>
  void read_value(std::string_view key, const FieldTraits& /*traits*/, std::variant<Laws...>& value) {
    auto within = table_.find_table(key, subject_of(key));
    if (!within) return;
    value = read_law<std::variant<Laws...>>(*within);
    within->check_unknown_keys();
  }

  void read_pair(std::string_view key, const FieldTraits& traits, Anchor& first, Anchor& second);
  void read_pair(std::string_view key, const FieldTraits& traits, std::string& first, std::string& second);
  void read_pair(std::string_view key, const FieldTraits& traits, Function& first, Function& second);

  [[nodiscard]] std::string subject_of(std::string_view key) const;
  /// The array of two at a required key; nullptr when it is none, which is reported.
  const DocumentNode::Array* find_pair(std::string_view key, std::string_view rule);
  /// The constants beside the formulas of this table.
  const std::vector<std::pair<std::string, double>>& constants();

  TableReader& table_;
  SharedTables shared_;
  std::optional<std::vector<std::pair<std::string, double>>> constants_;  // read when a function first asks for them
};

}  // namespace gudgeon
