// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Where pictures are written to.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace gudgeon {

/// DIR/NAME.FORMAT; what file systems might not take in the name becomes '_'.
std::filesystem::path make_picture_path(const std::filesystem::path& directory, std::string name,
                                        std::string_view format);

/// Makes the directory where it is missing; FileError where it cannot be made.
void make_picture_directory(const std::filesystem::path& directory);

}  // namespace gudgeon
