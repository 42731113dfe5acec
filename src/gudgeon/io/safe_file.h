// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Whole files in and out: a file under its final name is always complete, whatever stops us.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace gudgeon {

/// Beside the file, where its next version grows: "x.h5.partial".
std::filesystem::path find_partial(const std::filesystem::path& file);

/// Writes the bytes to the partial file, to the disk, and then renames it over the file. On any failure the file is
/// as it was, the partial one is gone, and a FileError says which file, what failed, why and what to do.
void write_whole(const std::filesystem::path& file, std::span<const std::byte> bytes);
void write_whole(const std::filesystem::path& file, std::string_view text);

/// All bytes of a file; FileError when it cannot be read.
std::vector<std::byte> read_whole(const std::filesystem::path& file);

/// FileError when the path cannot take a new file: a directory stands there, or a file that may not be replaced.
void check_target(const std::filesystem::path& file, bool overwrite);
/// FileError when there is no readable regular file.
void check_source(const std::filesystem::path& file);

}  // namespace gudgeon
