// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Letters, digits and four signs.
#include "gudgeon/app/file_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <string_view>

#include "gudgeon/base/stable_hash.h"

namespace gudgeon {
namespace {

// [bytes] File systems take 255; an ending, or two, comes behind.
constexpr std::size_t kLongest = 200;

}  // namespace

std::string make_file_name(std::string name) {
  const std::uint64_t hash = find_stable_hash(name);
  std::ranges::replace_if(
      name,
      [](unsigned char c) {
        return std::isalnum(c) == 0 && std::string_view("._-+").find(static_cast<char>(c)) == std::string_view::npos;
      },
      '_');
  if (name.size() > kLongest) name = fmt::format("{}_{:016x}", name.substr(0, kLongest - 17), hash);
  return name;
}

}  // namespace gudgeon
