// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The types that a variant may hold, one by one.
#pragma once

#include <type_traits>
#include <variant>

namespace gudgeon {

/// Calls visit.operator()<Alternative>() for every alternative of a variant, in order.
template <class Any, class Visitor>
constexpr void for_each_alternative(Visitor&& visitor) {
  [&]<class... Alternatives>(std::type_identity<std::variant<Alternatives...>>) {
    (visitor.template operator()<Alternatives>(), ...);
  }(std::type_identity<Any>{});
}

}  // namespace gudgeon
