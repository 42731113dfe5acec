// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Names that every file system takes.
#include "gudgeon/app/picture_files.h"

#include <fmt/format.h>

#include <utility>

#include "gudgeon/app/file_names.h"
#include "gudgeon/base/diagnostics.h"

namespace gudgeon {

std::filesystem::path make_picture_path(const std::filesystem::path& directory, std::string name,
                                        std::string_view format) {
  return directory / fmt::format("{}.{}", make_file_name(std::move(name)), format);
}

void make_picture_directory(const std::filesystem::path& directory) {
  std::error_code failure;
  std::filesystem::create_directories(directory, failure);
  if (!failure) return;
  throw FileError(fmt::format("directory '{}' cannot be made: {}", directory.string(), failure.message()));
}

}  // namespace gudgeon
