// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A hash that is the same in every build and on every machine.
#pragma once

#include <cstdint>
#include <string_view>

namespace gudgeon {

/// Fowler, Noll and Vo's hash 1a of 64 bits.
constexpr std::uint64_t find_stable_hash(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return hash;
}

}  // namespace gudgeon
