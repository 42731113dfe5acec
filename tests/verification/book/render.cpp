// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Tables, and their comparison line by line.
#include "tests/verification/book/render.h"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

namespace gudgeon::book {

namespace {

constexpr const char* kPreface = R"(# Verification

Every number below is checked by a test each time the suite runs, and was written by it: `bash scripts/verification.sh`
makes this page anew, and a test fails when the page is not what the tests say. *Ours* may differ in its last digits from
one compiler or processor to another; it always keeps the tolerance. All quantities are in SI units and radians.

Beside these cases, the suite compares the engine with the dense textbook form (maximal coordinates, all constraints, one
dense solve) on random states of every kind of joint, driver and load: accelerations, efforts, reactions and energies to
1e-9 (`tests/system`, `tests/oracle`), and every law of every family with its properties (`tests/laws`).
)";

// test.sh reads the minutes here and tells what each part took of them.
constexpr const char* kBudget = R"(
## Time

What must never break is checked with every change, on two processors without a compiler cache, within 35 minutes. Each
part keeps to its share; what does not fit goes into `scripts/long_checks.sh`.

| part of the checks | minutes |
|---|---:|
| set-up | 2 |
| Release build | 9 |
| tests | 4 |
| sanitizer build | 9 |
| sanitizer tests | 11 |
| together | 35 |
)";

constexpr const char* kLongChecks = R"(
## Long checks

What takes hours is run before a larger change is closed, by `bash scripts/long_checks.sh | tee
tests/verification/long_checks.txt`: lives of ten thousand cycles, a thousand mechanisms of each random family, other
programs that read run files, ThreadSanitizer, other compilers and levels of optimization, the share of lines that the
tests run, and fuzzing. It last said:

```text
{}```
)";

constexpr const char* kFaults = R"(
## Faults tried

What tests do to runs and to their files, how often in a Release build, and what was lost by it.

| fault | tried | lost |
|---|---:|---|
)";

std::string render_fault(const Fault& fault) {
  return fmt::format("| {} | {} | {} {} |\n", fault.kind, fault.n_tried, fault.n_lost, fault.lost);
}

std::string render_line(const Line& line) {
  return fmt::format("| {} | {:.10g} | {:.10g} | {:.1e} | {:.1e} |\n", line.quantity, line.reference, line.ours,
                     std::abs(line.ours - line.reference), line.tolerance);
}

std::string render_entry(const Entry& entry) {
  std::string text = fmt::format("\n### {}\n\n{}\n\n- Source: {}\n- Tolerance: {}\n\n", entry.about.title,
                                 entry.about.checks, entry.about.source, entry.about.reason);
  text += "| quantity | reference | ours | error | tolerance |\n|---|---:|---:|---:|---:|\n";
  for (const Line& line : entry.lines) text += render_line(line);
  return text;
}

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// The cells of a table's line; none for other lines.
std::vector<std::string> split_cells(const std::string& line) {
  std::vector<std::string> cells;
  if (!line.starts_with("| ")) return cells;
  std::istringstream in(line.substr(2));
  for (std::string cell; std::getline(in, cell, '|');) {
    const auto last = cell.find_last_not_of(' ');
    const auto first = cell.find_first_not_of(' ');
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
  }
  return cells;
}

double read_number(const std::string& cell) {
  double number = std::nan("");
  std::istringstream(cell) >> number;
  return number;
}

/// Whether a printed line says the same as the one that would be printed now.
bool holds(const std::string& now, const std::string& printed) {
  if (now == printed) return true;
  const auto a = split_cells(now);
  const auto b = split_cells(printed);
  if (a.size() == 3 && b.size() == 3) {
    return a[0] == b[0] && a[2] == b[2] && read_number(a[1]) > 0.0 && read_number(b[1]) > 0.0;
  }
  if (a.size() != 5 || b.size() != 5 || a[0] != b[0] || a[1] != b[1] || a[4] != b[4]) return false;
  // Ours is printed with ten digits.
  const double difference = std::abs(read_number(a[2]) - read_number(b[2]));
  return difference <= read_number(a[4]) + 1e-9 * std::abs(read_number(a[1]));
}

}  // namespace

std::string render_book(const BookContents& contents) {
  std::string text = kPreface;
  for (const std::string& chapter : list_chapters()) {
    bool begun = false;
    for (const Entry& entry : contents.entries) {
      if (entry.about.chapter != chapter) continue;
      if (!begun) text += fmt::format("\n## {}\n", chapter);
      begun = true;
      text += render_entry(entry);
    }
  }
  text += kFaults;
  for (const Fault& fault : contents.faults) text += render_fault(fault);
  text += kBudget;
  text += fmt::format(kLongChecks, contents.long_checks);
  return text;
}

std::vector<std::string> compare_book(const BookContents& contents, const std::string& printed) {
  const auto now = split_lines(render_book(contents));
  const auto then = split_lines(printed);
  std::vector<std::string> differences;
  for (std::size_t k = 0; k < std::max(now.size(), then.size()); ++k) {
    const std::string is = k < now.size() ? now[k] : "(nothing)";
    const std::string was = k < then.size() ? then[k] : "(nothing)";
    if (holds(is, was)) continue;
    differences.push_back(fmt::format("line {}: the tests say\n  {}\nthe page says\n  {}", k + 1, is, was));
    // Once a line is missing, all that follow differ.
    if (split_cells(is).empty() || split_cells(was).empty()) break;
  }
  return differences;
}

}  // namespace gudgeon::book
