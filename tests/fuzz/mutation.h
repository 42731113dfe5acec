// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Changes of an input, chosen by numbers that are the same at every run and on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gudgeon::fuzz {

using Bytes = std::vector<std::uint8_t>;

/// A linear congruential generator with Knuth's factor.
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(seed) {}
  std::size_t next(std::size_t below) {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::size_t>(state_ >> 33U) % below;
  }

 private:
  std::uint64_t state_;
};

/// The input with one to four changes: cut off, a piece left out, repeated or taken from the other input, a byte or bit
/// changed, a number or mark put in that readers stumble over.
Bytes mutate(const Bytes& input, const Bytes& other, Numbers& numbers);

}  // namespace gudgeon::fuzz
