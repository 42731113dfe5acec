// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One kind of fault that tests try, and how it travels from a test to the book.
#pragma once

#include <string>
#include <vector>

namespace gudgeon::book {

struct Fault {
  std::string kind;  ///< "a kill while stages are written"
  int n_tried = 0;
  int n_lost = 0;
  std::string lost;  ///< what could be lost: "finished stages"
};

/// Writes what a test tried among the entries of the book; a test of the same name replaces it.
void write_fault(const std::string& test, const Fault& fault);
/// All kinds in the directory in the order of their names, each once: tests of one kind are added up.
std::vector<Fault> read_faults(const std::string& directory);

}  // namespace gudgeon::book
