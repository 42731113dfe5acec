// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Laws to test a whole family with: defaults, and a permitted value for everything that must be given.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <variant>

#include "gudgeon/laws/law.h"

namespace gudgeon {

/// testing::Types of a family's variant.
template <class Any>
struct AlternativesOf;
template <class... Laws>
struct AlternativesOf<std::variant<Laws...>> {
  using Types = testing::Types<Laws...>;
};

/// The law with its defaults; every required parameter is 0.12, which all ranges permit, and a damping form of choice
/// is the family's first.
template <class Law>
Law make_sample_law() {
  Law law;
  for (const Parameter<Law>& parameter : Law::kParameters) {
    if (!std::isnan(law.*parameter.member)) continue;
    law.*parameter.member = 0.12;
    EXPECT_TRUE(parameter.range.contains(0.12)) << parameter.key;
  }
  if constexpr (NestsDamping<Law>) law.damping = std::variant_alternative_t<0, decltype(law.damping)>{};
  return law;
}

}  // namespace gudgeon
