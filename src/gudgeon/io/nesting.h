// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// How deep a TOML text nests, found before it is parsed: the TOML library takes a tree down level by level on the
// stack, and limits brackets only, not the dots of keys and headers.
#pragma once

#include <optional>
#include <string_view>

namespace gudgeon {

/// No model nests deeper than seven levels.
inline constexpr int kDeepestNesting = 32;

/// A place in a text; line and column [code points] count from 1.
struct NestingPlace {
  int line = 1;
  int column = 1;
};

/// Where tables and arrays in one another first come to more than kDeepestNesting levels; nothing where they do not.
/// Any text can be asked; of one that is not valid TOML, all before its first error counts.
std::optional<NestingPlace> find_deep_nesting(std::string_view text);

}  // namespace gudgeon
