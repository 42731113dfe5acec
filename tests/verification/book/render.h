// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The book as Markdown, and whether a printed one still holds.
#pragma once

#include <string>
#include <vector>

#include "tests/verification/book/entry.h"

namespace gudgeon::book {

std::string render_book(const std::vector<Entry>& entries);

/// What of a printed book is not what the entries say, in words; empty when it holds. Our numbers may differ from the
/// printed ones by the tolerance of their line: the last digits depend on compiler and processor.
std::vector<std::string> compare_book(const std::vector<Entry>& entries, const std::string& printed);

}  // namespace gudgeon::book
