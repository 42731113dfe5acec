// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers to little-endian bytes to base64.
#include "gudgeon/report/html/block_store.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <iterator>

#include "gudgeon/report/html/base64.h"

namespace gudgeon {

namespace {

template <class Bits>
void append_little_endian(std::vector<unsigned char>& bytes, Bits bits) {
  for (std::size_t i = 0; i < sizeof(Bits); ++i) bytes.push_back(static_cast<unsigned char>(bits >> (8 * i) & 0xFFU));
}

}  // namespace

int BlockStore::add_signal(std::span<const double> values) {
  std::vector<unsigned char> bytes;
  bytes.reserve(4 * values.size());
  for (const double value : values)
    append_little_endian(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
  return add_block("f4", bytes);
}

int BlockStore::add_times(std::span<const double> values) {
  std::vector<unsigned char> bytes;
  bytes.reserve(8 * values.size());
  for (const double value : values) append_little_endian(bytes, std::bit_cast<std::uint64_t>(value));
  return add_block("f8", bytes);
}

int BlockStore::add_block(const char* type, std::span<const unsigned char> bytes) {
  const std::string text = encode_base64(bytes);
  fmt::format_to(std::back_inserter(html_),
                 "<script type=\"text/plain\" id=\"block-{}\" data-type=\"{}\">{}</script>\n", end_, type, text);
  return end_++;
}

}  // namespace gudgeon
