// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Text to the terminal, where a failure to write is an error like any other.
#pragma once

#include <string_view>

namespace gudgeon {

/// Control characters are shown, not sent: nothing that a model or a run file holds commands the terminal. FileError
/// when standard output takes no more.
void write_stdout(std::string_view text);
void flush_stdout();

/// Whether standard output is a terminal that wants colour (NO_COLOR is not set).
bool find_color_wanted();

/// Messages, after what standard output was given before; nobody is left to be told when they cannot be written.
void write_stderr(std::string_view text);
/// The same as it is: for what moves the cursor.
void write_display(std::string_view text);

}  // namespace gudgeon
