// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Finds the name that was meant: the Damerau-Levenshtein distance counts inserted, lost, changed and swapped letters.
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "gudgeon/base/diagnostics.h"

namespace gudgeon {

namespace {

constexpr std::size_t kLongestName = 1000;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same_but_case(std::string_view a, std::string_view b) { return std::ranges::equal(a, b, {}, lower, lower); }

// Three rows of the distance table are enough: the last but one serves the swaps.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, changed});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

std::string join_names(std::span<const std::string> names) {
  std::string joined;
  for (const std::string& name : names) {
    if (!joined.empty()) joined += ", ";
    joined += name;
  }
  return joined;
}

const std::string* find_nearest(std::string_view name, std::span<const std::string> candidates) {
  // A third of the letters may be wrong; names of one or two letters may have one wrong letter or the wrong case.
  const std::size_t threshold = name.size() < 2 ? 0 : std::max<std::size_t>(1, (name.size() + 1) / 3);
  const std::string* nearest = nullptr;
  std::size_t least = threshold + 1;
  for (const std::string& candidate : candidates) {
    // So many letters more or fewer are wrong at least; no name of ours is longer than a path of a model.
    const std::size_t longer = std::max(name.size(), candidate.size());
    if (longer - std::min(name.size(), candidate.size()) >= least || longer > kLongestName) continue;
    const std::size_t found = same_but_case(name, candidate) ? std::min<std::size_t>(1, distance(name, candidate))
                                                             : distance(name, candidate);
    // Nothing in common is not near.
    if (found >= least || (found >= std::max(name.size(), candidate.size()) && found > 0)) continue;
    least = found;
    nearest = &candidate;
  }
  return nearest;
}

std::string suggest(std::string_view name, std::span<const std::string> candidates) {
  const std::string* nearest = find_nearest(name, candidates);
  return nearest == nullptr ? std::string{} : fmt::format("Did you mean '{}'?", *nearest);
}

}  // namespace gudgeon
