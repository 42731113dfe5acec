// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Every diagnostic that gudgeon has, by its code, and what it means: the manual's page and `gudgeon diagnostics` are
// made from it. What is said of a model beside it is up to who finds it.
#pragma once

#include <span>
#include <string_view>

namespace gudgeon {

struct DiagnosticEntry {
  std::string_view code;     ///< "E-MODEL-013"
  std::string_view meaning;  ///< what is wrong or remarkable, without a model at hand
};

/// All of them, in the order of the manual: by what they are about, then errors, warnings and remarks by their numbers.
std::span<const DiagnosticEntry> list_diagnostics();

/// "error", "warning" or "remark", from the letter of the code.
std::string_view severity_of(std::string_view code);

}  // namespace gudgeon
