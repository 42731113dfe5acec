// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Words for stages.
#include <array>
#include <charconv>
#include <string_view>

#include "gudgeon/report/figures/figure.h"

namespace gudgeon {

std::string label_stage(const std::string& stage) {
  static constexpr std::array kOrdinals{"no",    "first",   "second", "third", "fourth", "fifth",
                                        "sixth", "seventh", "eighth", "ninth", "tenth"};
  constexpr std::string_view kWorn = "wear_";
  if (stage == "no_wear") return "no wear";
  if (!stage.starts_with(kWorn)) return stage;
  std::size_t count = 0;
  const char* const end = stage.data() + stage.size();
  const auto [rest, error] = std::from_chars(stage.data() + kWorn.size(), end, count);
  if (error != std::errc{} || rest != end) return stage;
  if (count < kOrdinals.size()) return std::string(kOrdinals[count]) + " wear";
  return "wear " + std::to_string(count);
}

}  // namespace gudgeon
