// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One line of the verification book, and how it travels from a test to the book.
#pragma once

#include <string>
#include <vector>

namespace gudgeon::book {

/// What a case of the book is about.
struct Case {
  std::string chapter;  ///< "Motion", "Normal force" … one of list_chapters()
  std::string title;    ///< "A01 planar pendulum"
  std::string source;   ///< where the reference comes from
  std::string checks;   ///< what a failure would mean
  std::string reason;   ///< why the tolerance is what it is
};

/// One number of a case.
struct Line {
  std::string quantity;  ///< with its unit
  double reference = 0.0;
  double ours = 0.0;
  double tolerance = 0.0;  ///< of |ours − reference|
};

struct Entry {
  Case about;
  std::vector<Line> lines;
};

/// Chapters in the order of the book.
const std::vector<std::string>& list_chapters();

/// Writes one entry to a file of the directory, under a name made from chapter and title.
void write_entry(const std::string& directory, const Entry& entry);
/// All entries of the directory, in the order of the book.
std::vector<Entry> read_entries(const std::string& directory);

}  // namespace gudgeon::book
