// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Reads all of a run file, so that damage anywhere in it is found.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace gudgeon {

struct RunVerification {
  std::int64_t format_version = 0;
  bool has_checksums = false;  ///< files of format 1 have none: their numbers may be damaged unseen
  std::size_t n_stages = 0;
  std::size_t n_datasets = 0;        ///< that were read whole
  std::vector<std::string> errors;   ///< what is damaged or cannot be, one line each; none in a sound file
  std::vector<std::string> remarks;  ///< what lies beside it and is not used, one line each
};

/// FileError when the file cannot be opened as a run file at all.
RunVerification verify_run(const std::filesystem::path& file);

/// FileError that names everything damaged.
RunVerification require_sound(const std::filesystem::path& file);

}  // namespace gudgeon
