// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Each file is a byte of the lock file, whose place follows from its name: one descriptor holds any number of them.
#include "gudgeon/io/run_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/base/stable_hash.h"
#include "gudgeon/io/safe_file.h"

namespace gudgeon {

namespace {

/// Without the sign of a file offset.
off_t find_place(const std::string& name) { return static_cast<off_t>(find_stable_hash(name) >> 2U); }

/// 0, or why the lock is not ours. The length 0 means all of the file.
int lock_range(int descriptor, off_t place, off_t length) {
  struct flock range {};
  range.l_type = F_WRLCK;
  range.l_whence = SEEK_SET;
  range.l_start = place;
  range.l_len = length;
  return ::fcntl(descriptor, F_OFD_SETLK, &range) == 0 ? 0 : errno;
}

bool is_taken(int why) { return why == EAGAIN || why == EACCES; }

/// Opening it failed: the directory takes no new file, or the lock file that is there is another's.
[[noreturn]] void refuse_lock(const std::filesystem::path& path, int why) {
  if (why != EACCES && why != EPERM && why != EROFS) fail_file(path, "cannot be created", why);
  std::error_code unknown;
  if (std::filesystem::exists(std::filesystem::symlink_status(path, unknown)) && why != EROFS) {
    throw FileError(
        fmt::format("{}: the lock file is there and may not be written: {}; remove it when no other user's "
                    "run is under way in this directory, or give another directory with -o",
                    path.string(), std::strerror(why)));
  }
  const std::filesystem::path directory = path.has_parent_path() ? path.parent_path() : ".";
  throw FileError(
      fmt::format("{}: no file can be made in this directory: {}; give another one with -o, or change its "
                  "permissions",
                  directory.string(), std::strerror(why)));
}

int open_lock(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
  const int why = errno;
  std::error_code none;
  const std::filesystem::file_status there = std::filesystem::symlink_status(path, none);
  if (!std::filesystem::is_regular_file(there) && std::filesystem::exists(there)) {
    if (descriptor >= 0) ::close(descriptor);
    throw FileError(fmt::format("{}: cannot be locked: what is there is no regular file; move it away", path.string()));
  }
  if (descriptor < 0) refuse_lock(path, why);
  return descriptor;
}

}  // namespace

RunLock::RunLock(std::filesystem::path directory, std::span<const std::filesystem::path> files)
    : path_(std::move(directory) / ".gudgeon.lock"), descriptor_(-1) {
  // Whoever was last may take the file away between our opening and our locking it: then it is opened anew.
  do {
    if (descriptor_ >= 0) ::close(descriptor_);
    descriptor_ = open_lock(path_);
    for (const std::filesystem::path& file : files) {
      if (!is_taken(lock_range(descriptor_, find_place(file.filename().string()), 1))) continue;
      ::close(descriptor_);
      throw FileError(fmt::format("{}: another run is writing it; wait for its end or give another directory with -o",
                                  file.string()));
    }
  } while (!is_same_file(descriptor_, path_));
}

RunLock::~RunLock() {
  // All of it is to be had when nobody else holds a part.
  if (lock_range(descriptor_, 0, 0) == 0) ::unlink(path_.c_str());
  ::close(descriptor_);
}

}  // namespace gudgeon
