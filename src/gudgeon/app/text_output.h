// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Text to the terminal, where a failure to write is an error like any other.
#pragma once

#include <string_view>

#include "gudgeon/app/exit_code.h"

namespace gudgeon {

/// Puts the null device where standard input, output or error is closed: a file opened later would get its number, and
/// the text meant for it. To be called before any file is opened; FileError when there is no null device.
void open_closed_streams();

/// What was asked for. Control characters are shown, not sent: nothing that a model or a run file holds commands the
/// terminal. FileError when standard output takes no more, or was closed from the start.
void write_stdout(std::string_view text);
/// The same for what files hold, their paths and summaries; where standard output was closed from the start, nobody
/// wants it.
void write_receipt(std::string_view text);
/// A list that a name chose from. Where it chose nothing the usage is wrong: says so, and the next step if there is
/// one.
ExitCode print_listing(std::string_view text, std::string_view complaint, std::string_view next_step);
/// FileError when standard output takes no more.
void flush_stdout();

/// Whether standard output is a terminal that wants colour (NO_COLOR is not set).
bool find_color_wanted();

/// Messages, after what standard output was given before; nobody is left to be told when they cannot be written.
void write_stderr(std::string_view text);
/// The same as it is: for what moves the cursor.
void write_display(std::string_view text);

}  // namespace gudgeon
