// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Faults as files: two numbers and two lines of text.
#include "tests/verification/book/fault.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>

namespace gudgeon::book {

void write_fault(const std::string& test, const Fault& fault) {
  std::string name = test;
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  const std::filesystem::path directory = GUDGEON_BOOK_ENTRIES;
  std::filesystem::create_directories(directory);
  std::ofstream(directory / (name + ".fault"))
      << fmt::format("{} {}\n{}\n{}\n", fault.n_tried, fault.n_lost, fault.kind, fault.lost);
}

std::vector<Fault> read_faults(const std::string& directory) {
  std::map<std::string, Fault> kinds;
  if (!std::filesystem::is_directory(directory)) return {};
  for (const auto& file : std::filesystem::directory_iterator(directory)) {
    if (file.path().extension() != ".fault") continue;
    std::ifstream in(file.path());
    Fault one;
    in >> one.n_tried >> one.n_lost >> std::ws;
    std::getline(in, one.kind);
    std::getline(in, one.lost);
    Fault& all = kinds[one.kind];
    one.n_tried += all.n_tried;
    one.n_lost += all.n_lost;
    all = one;
  }
  std::vector<Fault> faults;
  for (const auto& [kind, fault] : kinds) faults.push_back(fault);
  return faults;
}

}  // namespace gudgeon::book
