// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What all laws of all families share: a name, a formula in text, and one table of parameters.
#pragma once

#include <concepts>
#include <string_view>
#include <type_traits>
#include <variant>

#include "gudgeon/base/alternatives.h"
#include "gudgeon/base/parameter_table.h"

namespace gudgeon {

/// A law is a value: default-constructible parameters, a name, a formula and a parameter table. A law whose parameters
/// must fit each other also has find_conflict(): why they do not, empty when they do.
template <class Law>
concept LawValue = std::default_initializable<Law> && std::copyable<Law> && requires {
  { Law::kName } -> std::convertible_to<std::string_view>;
  { Law::kFormula } -> std::convertible_to<std::string_view>;
  { Law::kParameters.size() } -> std::convertible_to<std::size_t>;
};

/// A law that holds a damping form of the user's choice, a variant of its own.
template <class Law>
concept NestsDamping = requires(const Law law) {
  std::variant_size<std::remove_cvref_t<decltype(law.damping)>>::value;
};

/// The name of the law that a family's variant holds.
template <class... Laws>
constexpr std::string_view law_name(const std::variant<Laws...>& law) {
  return std::visit([]<class Law>(const Law&) { return std::string_view{Law::kName}; }, law);
}

}  // namespace gudgeon
