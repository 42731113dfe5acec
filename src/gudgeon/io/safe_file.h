// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Whole files in and out: a file under its final name is always complete, whatever stops us.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace gudgeon {

/// Beside the file, where its next version grows: "x.h5.partial".
std::filesystem::path find_partial(const std::filesystem::path& file);

/// The next version of a file, growing beside it. It goes with this object unless it was put in place.
class PartialFile {
 public:
  /// Makes it empty, over what a kill may have left there; FileError when it cannot be made, or grows under another
  /// writer's hands.
  explicit PartialFile(std::filesystem::path file);
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;
  ~PartialFile();

  /// That it will replace.
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Open for reading and writing.
  [[nodiscard]] int descriptor() const { return descriptor_; }
  [[nodiscard]] bool is_empty() const;

  /// FileError when the bytes do not fit on the disk.
  void write(std::span<const std::byte> bytes);
  /// Brings it to the disk and renames it over the file. FileError when that fails.
  void put_in_place();
  /// FileError of the file that a write failed with that errno.
  [[noreturn]] void fail_write(int why) const;

 private:
  std::filesystem::path file_;
  std::filesystem::path path_;
  int descriptor_;
};

/// Writes the bytes to the partial file, to the disk, and then renames it over the file. On any failure the file is
/// as it was, the partial one is gone, and a FileError says which file, what failed, why and what to do.
void write_whole(const std::filesystem::path& file, std::string_view text);

/// FileError "file: what: why; next step" of that errno.
[[noreturn]] void fail_file(const std::filesystem::path& file, std::string_view what, int why);
/// Whether the path leads to what the descriptor was opened on.
[[nodiscard]] bool is_same_file(int descriptor, const std::filesystem::path& path);

/// FileError when the path cannot take a new file: a directory stands there, or a file that may not be replaced.
void check_target(const std::filesystem::path& file, bool overwrite);
/// FileError when there is no readable regular file.
void check_source(const std::filesystem::path& file);

}  // namespace gudgeon
