// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The book as Markdown, and whether a printed one still holds.
#pragma once

#include <string>
#include <vector>

#include "tests/verification/book/entry.h"
#include "tests/verification/book/fault.h"

namespace gudgeon::book {

std::string render_book(const std::vector<Entry>& entries, const std::vector<Fault>& faults);

/// What of a printed book is not what the entries say, in words; empty when it holds. Our numbers may differ from the
/// printed ones by the tolerance of their line: the last digits depend on compiler and processor. So does how often a
/// fault was tried, but not what was lost.
std::vector<std::string> compare_book(const std::vector<Entry>& entries, const std::vector<Fault>& faults,
                                      const std::string& printed);

}  // namespace gudgeon::book
