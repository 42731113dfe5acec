// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The list of diagnostics as text.
#pragma once

#include <string>
#include <string_view>

namespace gudgeon {

/// The page docs/guide/diagnostics.md.
std::string render_diagnostics_page();
/// The one of a code, or all whose code begins so, "E-NUM", for a terminal; all when it is empty, nothing when none
/// does.
std::string render_diagnostics(std::string_view code);

}  // namespace gudgeon
