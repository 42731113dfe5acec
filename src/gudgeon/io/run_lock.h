// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One run at a time for each run file, from before the first is looked at until the last is written.
#pragma once

#include <filesystem>
#include <span>

namespace gudgeon {

/// Holds files of one directory. The lock is on a file of its own beside them, ".gudgeon.lock", which is never renamed
/// and goes with the last run that has it; a lock ends with its process, whatever ends that. Where a disk knows no
/// locks, all goes on without: writers then find out before they add anything (GrowingFile).
class RunLock {
 public:
  /// FileError when another run holds any of them, or nothing can be written there.
  RunLock(std::filesystem::path directory, std::span<const std::filesystem::path> files);
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;
  ~RunLock();

 private:
  std::filesystem::path path_;
  int descriptor_;
};

}  // namespace gudgeon
