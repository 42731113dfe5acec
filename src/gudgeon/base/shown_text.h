// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Text from outside made fit to be shown: nothing in it commands a terminal, and a long one is cut.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace gudgeon {

/// Takes the next code point off UTF-8 text, which must not be empty; nothing for a byte that begins none, which is
/// taken off alone.
std::optional<char32_t> take_code_point(std::string_view& text);

/// Whether a code point commands instead of showing: the control characters (newline and tab are none here), marks that
/// turn the direction of writing, and the separators of lines and paragraphs.
bool is_control(char32_t code);

/// The first control character of a text as "U+001B"; empty without any.
std::string find_control(std::string_view text);

/// Every control character as "\u001B", every byte that is no UTF-8 as "\xFF"; newlines and tabs stay.
std::string show_controls(std::string_view text);

/// The same where a text has one line only: newlines and tabs are control characters, too.
std::string show_line(std::string_view text);

/// A text of more code points than that as its beginning and its end, and between them how many are left out.
std::string shorten(std::string_view text, std::size_t most);

}  // namespace gudgeon
