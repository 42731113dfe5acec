// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// verification_book render: prints the book of the entries that the verification tests left.
// verification_book compare PAGE: fails when the page is not what they say.
#include <fmt/format.h>

#include <cstring>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/verification/book/render.h"

namespace {

std::string read_file(const char* name) {
  std::ifstream in(name);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

}  // namespace

int main(int argc, char** argv) {
  const gudgeon::book::BookContents contents{gudgeon::book::read_entries(GUDGEON_BOOK_ENTRIES),
                                             gudgeon::book::read_faults(GUDGEON_BOOK_ENTRIES),
                                             read_file(GUDGEON_LONG_CHECKS)};
  if (argc == 2 && std::strcmp(argv[1], "render") == 0) {
    fmt::print("{}", gudgeon::book::render_book(contents));
    return 0;
  }
  if (argc != 3 || std::strcmp(argv[1], "compare") != 0) {
    fmt::print(stderr, "usage: verification_book render | verification_book compare PAGE\n");
    return 2;
  }
  const auto differences = gudgeon::book::compare_book(contents, read_file(argv[2]));
  for (const std::string& difference : differences) fmt::print(stderr, "{}: {}\n", argv[2], difference);
  if (!differences.empty()) fmt::print(stderr, "`bash scripts/verification.sh` makes the page anew\n");
  return differences.empty() ? 0 : 1;
}
