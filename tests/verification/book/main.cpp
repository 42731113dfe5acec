// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// verification_book render: prints the book of the entries that the verification tests left.
// verification_book compare PAGE: fails when the page is not what they say.
#include <fmt/format.h>

#include <cstring>
#include <fstream>
#include <sstream>

#include "tests/verification/book/render.h"

int main(int argc, char** argv) {
  const auto entries = gudgeon::book::read_entries(GUDGEON_BOOK_ENTRIES);
  const auto faults = gudgeon::book::read_faults(GUDGEON_BOOK_ENTRIES);
  if (argc == 2 && std::strcmp(argv[1], "render") == 0) {
    fmt::print("{}", gudgeon::book::render_book(entries, faults));
    return 0;
  }
  if (argc != 3 || std::strcmp(argv[1], "compare") != 0) {
    fmt::print(stderr, "usage: verification_book render | verification_book compare PAGE\n");
    return 2;
  }
  std::ifstream in(argv[2]);
  std::ostringstream page;
  page << in.rdbuf();
  const auto differences = gudgeon::book::compare_book(entries, faults, page.str());
  for (const std::string& difference : differences) fmt::print(stderr, "{}: {}\n", argv[2], difference);
  if (!differences.empty()) fmt::print(stderr, "`bash scripts/verification.sh` makes the page anew\n");
  return differences.empty() ? 0 : 1;
}
