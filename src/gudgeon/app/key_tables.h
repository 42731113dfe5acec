// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The keys of a model file as text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gudgeon {

/// The page docs/guide/keys.md.
std::string render_keys_page();
/// The tables of a section or type, or those that have a key of that name, for a terminal; all when the name is empty,
/// nothing when none has it.
std::string render_keys(std::string_view name);
/// The names that render_keys knows.
std::vector<std::string> list_key_names();

}  // namespace gudgeon
