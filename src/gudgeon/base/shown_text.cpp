// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// UTF-8, code point by code point.
#include "gudgeon/base/shown_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace gudgeon {

namespace {

bool is_plain(char c) { return (c >= ' ' && c <= '~') || c == '\n' || c == '\t'; }

/// Bytes that code points of that first byte take; 0 when none begins with it.
std::size_t count_bytes(unsigned char first) {
  if (first < 0x80) return 1;
  if (first < 0xC2 || first > 0xF4) return 0;
  return first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
}

/// The first `count` code points of a text.
std::string_view take_first(std::string_view text, std::size_t count) {
  std::string_view rest = text;
  for (std::size_t k = 0; k < count && !rest.empty(); ++k) take_code_point(rest);
  return text.substr(0, text.size() - rest.size());
}

/// Code points that are to be hidden, and bytes that are none, as their numbers.
template <class IsHidden>
std::string show(std::string_view text, IsHidden is_hidden) {
  std::string shown;
  while (!text.empty()) {
    const std::string_view from = text;
    const std::optional<char32_t> code = take_code_point(text);
    const std::string_view piece = from.substr(0, from.size() - text.size());
    if (!code) {
      fmt::format_to(std::back_inserter(shown), "\\x{:02X}", static_cast<unsigned char>(piece.front()));
    } else if (is_hidden(*code)) {
      fmt::format_to(std::back_inserter(shown), "\\u{:04X}", static_cast<unsigned>(*code));
    } else {
      shown += piece;
    }
  }
  return shown;
}

std::size_t count_code_points(std::string_view text) {
  std::size_t count = 0;
  for (; !text.empty(); ++count) take_code_point(text);
  return count;
}

}  // namespace

std::optional<char32_t> take_code_point(std::string_view& text) {
  const auto first = static_cast<unsigned char>(text.front());
  const std::size_t length = count_bytes(first);
  const bool whole = length > 0 && length <= text.size() && std::ranges::all_of(text.substr(1, length - 1), [](char c) {
                       return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
                     });
  if (!whole) {
    text.remove_prefix(1);
    return std::nullopt;
  }
  char32_t code = length == 1 ? first : first & (0xFFU >> (length + 1));
  for (std::size_t k = 1; k < length; ++k) code = (code << 6U) | (static_cast<unsigned char>(text[k]) & 0x3FU);
  text.remove_prefix(length);
  return code;
}

bool is_control(char32_t code) {
  if (code == U'\n' || code == U'\t') return false;
  return code < 0x20 || (code >= 0x7F && code <= 0x9F) || code == 0x200E || code == 0x200F ||
         (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

std::string find_control(std::string_view text) {
  while (!text.empty()) {
    const std::optional<char32_t> code = take_code_point(text);
    if (code && is_control(*code)) return fmt::format("U+{:04X}", static_cast<unsigned>(*code));
  }
  return {};
}

std::string show_controls(std::string_view text) {
  return std::ranges::all_of(text, is_plain) ? std::string{text} : show(text, is_control);
}

std::string show_line(std::string_view text) {
  if (std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~'; })) return std::string{text};
  return show(text, [](char32_t code) { return code == U'\n' || code == U'\t' || is_control(code); });
}

std::string shorten(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string{text};
  const std::size_t count = count_code_points(text);
  if (count <= most) return std::string{text};
  // Two thirds of what is shown is the beginning: it says what is meant.
  const std::size_t n_first = 2 * most / 3;
  const std::size_t n_left_out = count - most;
  const std::string_view first = take_first(text, n_first);
  const std::string_view last = text.substr(take_first(text, n_first + n_left_out).size());
  return fmt::format("{} … ({} characters left out) … {}", first, n_left_out, last);
}

}  // namespace gudgeon
