// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Three bytes become four characters.
#include "gudgeon/report/html/base64.h"

#include <algorithm>

namespace gudgeon {

std::string encode_base64(std::span<const std::uint8_t> bytes) {
  static constexpr char kAlphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - k);
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < 3; ++i) group = group << 8U | (i < n ? bytes[k + i] : 0U);
    for (std::size_t i = 0; i < 4; ++i) text += i <= n ? kAlphabet[group >> (18U - 6U * i) & 63U] : '=';
  }
  return text;
}

}  // namespace gudgeon
