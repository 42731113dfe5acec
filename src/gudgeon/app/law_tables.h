// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Every law with its formula and parameters, read off the laws themselves.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gudgeon {

/// One law of one family, in text.
struct LawEntry {
  std::string family;  ///< "friction"
  std::string name;    ///< "lugre"
  std::string formula;
  std::vector<std::vector<std::string>> parameters;  ///< rows of key, symbol, unit, range, default, meaning
};

/// All laws of all families: normal force, damping, friction, wear.
std::vector<LawEntry> list_laws();

/// The page docs/guide/laws.md.
std::string render_laws_page();
/// The laws of a family or the one law of a name, for a terminal; all when the name is empty, nothing when none has it.
std::string render_laws(std::string_view name);

}  // namespace gudgeon
