// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Escapes and separators.
#include "gudgeon/report/html/json_text.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "gudgeon/base/shown_text.h"

namespace gudgeon {

void JsonText::separate() {
  if (text_.empty()) return;
  const char last = text_.back();
  if (last != '{' && last != '[' && last != ':') text_ += ',';
}

void JsonText::begin(char brace) {
  separate();
  text_ += brace;
}

void JsonText::end(char brace) { text_ += brace; }

void JsonText::key(std::string_view name) {
  add(name);
  text_ += ':';
}

void JsonText::add(std::string_view text) {
  separate();
  text_ += '"';
  for (const char c : show_controls(text)) {
    if (c == '"' || c == '\\') {
      text_ += '\\';
      text_ += c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == '<') {  // '<' could end the script element
      fmt::format_to(std::back_inserter(text_), "\\u{:04x}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    } else {
      text_ += c;
    }
  }
  text_ += '"';
}

void JsonText::add_json(std::string_view json) {
  separate();
  text_ += json;
}

void JsonText::add(double value) {
  separate();
  if (std::isfinite(value)) {
    fmt::format_to(std::back_inserter(text_), "{}", value);
  } else {
    text_ += "null";
  }
}

void JsonText::add(int value) {
  separate();
  fmt::format_to(std::back_inserter(text_), "{}", value);
}

void JsonText::add(bool value) {
  separate();
  text_ += value ? "true" : "false";
}

}  // namespace gudgeon
