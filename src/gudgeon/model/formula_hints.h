// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What was probably meant by a formula that is written as in another language.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gudgeon {

/// How a formula says what this name says elsewhere, "if" or "and"; empty when the name is not known for anything.
std::string find_word_hint(std::string_view name);

/// Notes on symbols and numbers that other languages have: "**", "%", a decimal comma, a function without parentheses.
std::vector<std::string> list_symbol_hints(const std::string& formula);

}  // namespace gudgeon
