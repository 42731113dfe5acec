// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// JSON, written value by value.
#pragma once

#include <string>
#include <string_view>

namespace gudgeon {

/// Commas and quotes are its business; braces must be closed by the caller. Safe inside an HTML script element.
class JsonText {
 public:
  void begin_object() { begin('{'); }
  void begin_array() { begin('['); }
  void end_object() { end('}'); }
  void end_array() { end(']'); }
  /// The name of the next value in an object.
  void key(std::string_view name);
  void add(std::string_view text);
  void add(const char* text) { add(std::string_view(text)); }
  /// Infinities and NaN, which JSON does not know, become null.
  void add(double value);
  void add(int value);
  void add(bool value);

  /// A value that is JSON already.
  void add_json(std::string_view json);

  template <class Value>
  void put(std::string_view name, const Value& value) {
    key(name);
    add(value);
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void begin(char brace);
  void end(char brace);
  void separate();
  std::string text_;
};

}  // namespace gudgeon
