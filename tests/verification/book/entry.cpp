// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Entries as files: five lines of text, then a line a number.
#include "tests/verification/book/entry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace gudgeon::book {

namespace {

std::string make_file_name(const Entry& entry) {
  std::string name = entry.about.chapter + "_" + entry.about.title;
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name + ".entry";
}

std::size_t find_chapter(const Entry& entry) {
  const auto& chapters = list_chapters();
  const auto found = std::ranges::find(chapters, entry.about.chapter);
  if (found == chapters.end()) throw std::runtime_error("the book has no chapter '" + entry.about.chapter + "'");
  return static_cast<std::size_t>(found - chapters.begin());
}

Entry read_entry(const std::filesystem::path& file) {
  std::ifstream in(file);
  Entry entry;
  for (std::string* text :
       {&entry.about.chapter, &entry.about.title, &entry.about.source, &entry.about.checks, &entry.about.reason}) {
    std::getline(in, *text);
  }
  Line line;
  while (in >> line.reference >> line.ours >> line.tolerance && std::getline(in >> std::ws, line.quantity)) {
    entry.lines.push_back(line);
  }
  return entry;
}

}  // namespace

const std::vector<std::string>& list_chapters() {
  static const std::vector<std::string> chapters{"Motion",
                                                 "Kinematics and statics",
                                                 "Loads and drivers",
                                                 "Normal force",
                                                 "Friction",
                                                 "Clearance in guides",
                                                 "Wear",
                                                 "Energy",
                                                 "Convergence"};
  return chapters;
}

void write_entry(const std::string& directory, const Entry& entry) {
  std::filesystem::create_directories(directory);
  find_chapter(entry);
  std::ofstream out(std::filesystem::path(directory) / make_file_name(entry));
  out << fmt::format("{}\n{}\n{}\n{}\n{}\n", entry.about.chapter, entry.about.title, entry.about.source,
                     entry.about.checks, entry.about.reason);
  for (const Line& line : entry.lines) {
    out << fmt::format("{:.17g} {:.17g} {:.17g} {}\n", line.reference, line.ours, line.tolerance, line.quantity);
  }
}

std::vector<Entry> read_entries(const std::string& directory) {
  std::vector<Entry> entries;
  if (!std::filesystem::is_directory(directory)) return entries;
  for (const auto& file : std::filesystem::directory_iterator(directory)) {
    if (file.path().extension() == ".entry") entries.push_back(read_entry(file.path()));
  }
  std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
    return std::pair(find_chapter(a), a.about.title) < std::pair(find_chapter(b), b.about.title);
  });
  return entries;
}

}  // namespace gudgeon::book
