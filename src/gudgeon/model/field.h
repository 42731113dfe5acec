// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The keys of a table of the model file, declared once beside what they are stored in. A description has a tuple of
// them, kFields; reader, writer of the resolved model, checks, the manual's page and the schema for editors walk it.
#pragma once

#include <string_view>
#include <tuple>

#include "gudgeon/base/parameter_table.h"
#include "gudgeon/base/quantity.h"

namespace gudgeon {

/// What a text names.
enum class Names { nothing, body, joint, driver, channel };

/// What is known of a key besides what it is stored in.
struct FieldTraits {
  bool required = false;                  ///< otherwise the value of a default-constructed owner holds
  std::string_view unless = {};           ///< key that takes the place of a required one
  Dimension dimension = {};               ///< of its numbers
  std::string_view symbol = {};           ///< in formulas
  ParameterRange range = {};              ///< of its numbers, each component of a vector
  std::string_view code = "E-MODEL-005";  ///< of a number out of range
  Names names = Names::nothing;           ///< what a text is the name of
  std::string_view absent = {};           ///< what holds when it is absent, where that is not the owner's default
  std::string_view meaning = {};
};

/// One key and the member it is stored in.
template <class Owner, class Value>
struct Field {
  std::string_view key;
  Value Owner::*member;
  FieldTraits traits;
};

/// One key whose array of two is stored in two members: between = ["crank.A", "rod.A"].
template <class Owner, class Value>
struct PairField {
  std::string_view key;
  Value Owner::*first;
  Value Owner::*second;
  FieldTraits traits;
};

template <class Owner, class Value>
constexpr Field<Owner, Value> field(std::string_view key, Value Owner::*member, const FieldTraits& traits) {
  return {key, member, traits};
}

template <class Owner, class Value>
constexpr PairField<Owner, Value> field(std::string_view key, Value Owner::*first, Value Owner::*second,
                                        const FieldTraits& traits) {
  return {key, first, second, traits};
}

/// What has a table of its keys.
template <class Owner>
concept Described = requires {
  std::tuple_size<std::remove_cvref_t<decltype(Owner::kFields)>>::value;
};

/// What stands as a table within its owner's; what has a name stands in a section of its own.
template <class Value>
concept TableWithin = Described<Value> && !requires(const Value value) {
  value.name;
};

/// Calls visit(field) for each key of a tuple of them, in order.
template <class Fields, class Visitor>
constexpr void for_each_field(const Fields& fields, Visitor&& visit) {
  std::apply([&](const auto&... each) { (visit(each), ...); }, fields);
}

}  // namespace gudgeon
