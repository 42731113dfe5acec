// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One change after the other, each at a place of its own.
#include "tests/fuzz/mutation.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace gudgeon::fuzz {

namespace {

constexpr std::size_t kLongestPiece = 64;

constexpr std::array<std::string_view, 24> kOdd{"nan",  "-inf",  "1e400",     "5e-324", "-0.0",   "9223372036854775808",
                                                "-1",   "1_000", "0x1p-1074", "''",     "\"\"\"", "[[",
                                                "]",    "{",     "}",         "#",      "..",     "\\u0000",
                                                "\r\n", "\t",    "\x1b[2J",   "^9",     "°",      "="};

struct Piece {
  std::ptrdiff_t begin;
  std::ptrdiff_t end;
};

Piece choose_piece(const Bytes& bytes, Numbers& numbers) {
  const std::size_t begin = numbers.next(bytes.size());
  const std::size_t length = std::min(1 + numbers.next(kLongestPiece), bytes.size() - begin);
  return {static_cast<std::ptrdiff_t>(begin), static_cast<std::ptrdiff_t>(begin + length)};
}

std::ptrdiff_t choose_gap(const Bytes& bytes, Numbers& numbers) {
  return static_cast<std::ptrdiff_t>(numbers.next(bytes.size() + 1));
}

void insert_piece(Bytes& bytes, const Bytes& from, Numbers& numbers) {
  const Piece piece = choose_piece(from, numbers);
  const Bytes copy(from.begin() + piece.begin, from.begin() + piece.end);
  bytes.insert(bytes.begin() + choose_gap(bytes, numbers), copy.begin(), copy.end());
}

void insert_odd(Bytes& bytes, Numbers& numbers) {
  const std::string_view odd = kOdd[numbers.next(kOdd.size())];
  bytes.insert(bytes.begin() + choose_gap(bytes, numbers), odd.begin(), odd.end());
}

void change_once(Bytes& bytes, const Bytes& other, Numbers& numbers) {
  if (bytes.empty()) return insert_odd(bytes, numbers);
  switch (numbers.next(7)) {
    case 0:
      return bytes.resize(numbers.next(bytes.size()));
    case 1: {
      const Piece piece = choose_piece(bytes, numbers);
      bytes.erase(bytes.begin() + piece.begin, bytes.begin() + piece.end);
      return;
    }
    case 2:
      return insert_piece(bytes, bytes, numbers);
    case 3:
      return insert_piece(bytes, other.empty() ? bytes : other, numbers);
    case 4:
      bytes[numbers.next(bytes.size())] ^= static_cast<std::uint8_t>(1U << numbers.next(8));
      return;
    case 5:
      bytes[numbers.next(bytes.size())] = static_cast<std::uint8_t>(numbers.next(256));
      return;
    default:
      return insert_odd(bytes, numbers);
  }
}

}  // namespace

Bytes mutate(const Bytes& input, const Bytes& other, Numbers& numbers) {
  Bytes changed = input;
  const std::size_t n_changes = 1 + numbers.next(4);
  for (std::size_t k = 0; k < n_changes; ++k) change_once(changed, other, numbers);
  return changed;
}

}  // namespace gudgeon::fuzz
