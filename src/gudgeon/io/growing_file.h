// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// An HDF5 file that grows in place and is complete at any moment. Under an Hdf5Session.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "gudgeon/io/hdf5_driver.h"
#include "gudgeon/io/hdf5_handle.h"

namespace gudgeon {

/// What is added comes behind the file's end, where nobody looks; the few pages of it that change are kept in memory.
/// commit() brings the new end to the disk, writes the pages down in a journal beside the file, and puts them in place.
/// A kill before the journal is whole leaves the file as it was, one after it leaves the rest to the next opening.
class GrowingFile {
 public:
  /// Opens a finished file and ends a commit that was killed. FileError with path when that fails.
  explicit GrowingFile(std::filesystem::path file);
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;
  ~GrowingFile();  // rolls back

  [[nodiscard]] const std::filesystem::path& path() const { return file_; }
  /// Whether anything was changed since the last commit.
  [[nodiscard]] bool is_changed() const { return is_changed_; }

  /// Changes that readers do not see yet. FileError when they cannot be made: then everything since the last commit is
  /// undone. A FileError out of change has no path yet.
  void change(const std::function<void(const Hdf5Handle& root)>& change);
  /// Lets readers see the changes. FileError when that fails: then everything since the last commit is undone.
  void commit();
  /// Undoes everything since the last commit.
  void roll_back();

  /// What restore() needs to have the changes since the last commit again, in another process, whatever is changed
  /// after this. The bytes added are on the disk when it returns; FileError when they are not.
  std::string save_changes();
  /// Takes the changes up again; false when the bytes are not of this state of the file, which is then as it was.
  bool restore_changes(std::string_view saved);

 private:
  [[nodiscard]] bool is_ours() const;
  void require_ours() const;
  [[nodiscard]] Hdf5Target::Page read_committed_page() const;
  void note_committed(std::uint64_t end);
  void synchronize();
  void apply(std::uint64_t end);
  [[noreturn]] void fail(int why);

  std::filesystem::path file_;
  Hdf5Target target_;
  Hdf5Target::Page first_page_{};  // as committed; zeros behind the file's end
  std::uint64_t committed_end_ = 0;
  bool is_changed_ = false;
};

}  // namespace gudgeon
