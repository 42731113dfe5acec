// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Checks a description by its table of keys: ranges of numbers, points that exist, functions that can be evaluated.
#pragma once

#include <optional>
#include <string>

#include "gudgeon/model/check_rules.h"

namespace gudgeon {

/// Whether every number of a description is within its range.
template <Described Owner>
bool is_within_ranges(const Owner& owner) {
  bool good = true;
  for_each_field(Owner::kFields, [&]<class One>(const One& one) {
    if constexpr (requires {
                    { owner.*one.member } -> std::same_as<const double&>;
                  }) {
      good = good && one.traits.range.contains(owner.*one.member);
    }
  });
  return good;
}

class FieldCheck {
 public:
  /// The subject names the owner for the user, "joint 'A'"; the path is that of its table.
  FieldCheck(CheckRules& rules, std::string subject, std::string path)
      : rules_(rules), subject_(std::move(subject)), path_(std::move(path)) {}

  template <Described Owner>
  void check(const Owner& owner) {
    check(Owner::kFields, owner);
  }
  /// Those of its keys.
  template <class Fields, class Owner>
  void check(const Fields& fields, const Owner& owner) {
    for_each_field(fields, [&](const auto& one) { check_field(one, owner); });
  }

 private:
  template <class Owner, class Value>
  void check_field(const Field<Owner, Value>& one, const Owner& owner) {
    check_value(std::string(one.key), one.traits, owner.*one.member);
  }
  /// The sizes beside a law.
  template <class Owner>
  void check_field(const Field<Owner, std::optional<JointFriction>>& one, const Owner& owner) {
    const std::optional<JointFriction>& friction = owner.*one.member;
    if (!friction) return;
    FieldCheck(rules_, subject_, path_ + "." + std::string(one.key)).check(Owner::kFrictionFields, *friction);
  }
  template <class Owner, class Value>
  void check_field(const PairField<Owner, Value>& one, const Owner& owner) {
    check_value(std::string(one.key) + ".0", one.traits, owner.*one.first);
    check_value(std::string(one.key) + ".1", one.traits, owner.*one.second);
  }

  // Of all other kinds every value is right, or the rule is the section's own.
  template <class Value>
  void check_value(const std::string& /*key*/, const FieldTraits& /*traits*/, const Value& /*value*/) {}
  void check_value(const std::string& key, const FieldTraits& traits, const double& value);
  void check_value(const std::string& key, const FieldTraits& traits, const int& value);
  void check_value(const std::string& key, const FieldTraits& traits, const Vec2& value);
  void check_value(const std::string& key, const FieldTraits& traits, const Anchor& value);
  void check_value(const std::string& key, const FieldTraits& traits, const Function& value);
  void check_value(const std::string& key, const FieldTraits& traits, const std::vector<Point>& value);
  template <class Value>
  void check_value(const std::string& key, const FieldTraits& traits, const std::optional<Value>& value) {
    if (value) check_value(key, traits, *value);
  }
  /// A table within.
  template <TableWithin Value>
  void check_value(const std::string& key, const FieldTraits& /*traits*/, const Value& value) {
    FieldCheck(rules_, subject_, path_ + "." + key).check(value);
  }

  CheckRules& rules_;
  std::string subject_;
  std::string path_;
};

}  // namespace gudgeon
