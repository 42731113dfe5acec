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

/// What the tests left for the book, and what scripts/long_checks.sh printed when it last ran.
struct BookContents {
  std::vector<Entry> entries;
  std::vector<Fault> faults;
  std::string long_checks;
};

std::string render_book(const BookContents& contents);

/// What of a printed book is not what the contents say, in words; empty when it holds. Our numbers may differ from the
/// printed ones by the tolerance of their line: the last digits depend on compiler and processor. So does how often a
/// fault was tried, but not what was lost.
std::vector<std::string> compare_book(const BookContents& contents, const std::string& printed);

}  // namespace gudgeon::book
