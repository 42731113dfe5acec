// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Plain POSIX writing, because only there every failure has its own reason.
#include "gudgeon/io/safe_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "gudgeon/base/diagnostics.h"

namespace gudgeon {

namespace {

std::string_view find_next_step(int why) {
  switch (why) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return "make room or choose another disk; what was finished before is kept";
    case EACCES:
    case EPERM:
    case EROFS:
      return "choose a place you may use, or change its permissions";
    case ENOENT:
    case ENOTDIR:
      return "check the path";
    case EISDIR:
      return "choose another file name";
    default:
      return "check the disk and try again";
  }
}

}  // namespace

void fail_file(const std::filesystem::path& file, std::string_view what, int why) {
  throw FileError(fmt::format("{}: {}: {}; {}", file.string(), what, std::strerror(why), find_next_step(why)));
}

bool is_same_file(int descriptor, const std::filesystem::path& path) {
  struct stat opened {};
  struct stat there {};
  return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &there) == 0 && opened.st_ino == there.st_ino &&
         opened.st_dev == there.st_dev;
}

namespace {

bool is_regular(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

/// Opens the path empty for this process alone: two writers would mix their bytes. A lock ends with its process.
int open_alone(const std::filesystem::path& path) {
  while (true) {
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
    if (descriptor < 0 && errno != ELOOP) fail_file(path, "cannot be created", errno);
    if (descriptor < 0 || !is_regular(descriptor)) {
      if (descriptor >= 0) ::close(descriptor);
      throw FileError(
          fmt::format("{}: cannot be created: what is there is no regular file (a link to another, or a device); move "
                      "it away",
                      path.string()));
    }
    // Where a disk knows no locks, all goes on without.
    const bool is_taken = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    // Who held the lock may have put the file in place meanwhile: then it is not ours to empty.
    const bool is_ours = !is_taken && is_same_file(descriptor, path);
    const int why = is_ours && ::ftruncate(descriptor, 0) != 0 ? errno : 0;
    if (is_ours && why == 0) return descriptor;
    ::close(descriptor);
    if (is_ours) fail_file(path, "cannot be created", why);
    if (is_taken) {
      throw FileError(
          fmt::format("{}: another run is writing it; wait for its end or choose another place", path.string()));
    }
  }
}

/// The name is on the disk, too; where directories know no fsync, all goes on without.
void synchronize_directory(const std::filesystem::path& file) {
  const std::filesystem::path directory = file.has_parent_path() ? file.parent_path() : ".";
  const int descriptor = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

std::filesystem::path find_partial(const std::filesystem::path& file) {
  std::filesystem::path partial = file;
  partial += ".partial";
  return partial;
}

PartialFile::PartialFile(std::filesystem::path file)
    : file_(std::move(file)), path_(find_partial(file_)), descriptor_(open_alone(path_)) {}

PartialFile::~PartialFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  ::unlink(path_.c_str());
}

bool PartialFile::is_empty() const {
  struct stat status {};
  return ::fstat(descriptor_, &status) != 0 || status.st_size == 0;
}

void PartialFile::write(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail_write(errno);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void PartialFile::put_in_place() {
  if (::fsync(descriptor_) != 0 && errno != EINVAL) fail_write(errno);  // EINVAL: a place that knows no fsync
  if (!is_same_file(descriptor_, path_)) {
    ::close(std::exchange(descriptor_, -1));
    throw FileError(
        fmt::format("{}: another program took {} away while it was written; run again where nothing else "
                    "writes",
                    file_.string(), path_.filename().string()));
  }
  const bool is_there = ::rename(path_.c_str(), file_.c_str()) == 0;
  const int why = errno;
  if (!is_there) ::unlink(path_.c_str());
  ::close(std::exchange(descriptor_, -1));
  if (!is_there) fail_file(file_, "cannot be put in place", why);
  synchronize_directory(file_);
}

void PartialFile::fail_write(int why) const { fail_file(file_, "cannot be written", why); }

void write_whole(const std::filesystem::path& file, std::string_view text) {
  PartialFile partial(file);
  partial.write(std::as_bytes(std::span(text)));
  partial.put_in_place();
}

void check_target(const std::filesystem::path& file, bool overwrite) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return;  // nothing there; other errors show when writing
  if (S_ISDIR(status.st_mode)) fail_file(file, "cannot be written", EISDIR);
  if (!S_ISREG(status.st_mode)) {
    throw FileError(fmt::format("{}: cannot be written: it is not a regular file; choose another name", file.string()));
  }
  if (!overwrite) {
    throw FileError(
        fmt::format("{}: already exists; use --overwrite to replace it, or choose another name", file.string()));
  }
}

void check_source(const std::filesystem::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) fail_file(file, "cannot be read", errno);
  if (S_ISDIR(status.st_mode)) fail_file(file, "cannot be read", EISDIR);
  if (!S_ISREG(status.st_mode)) {
    throw FileError(fmt::format("{}: cannot be read: it is not a regular file; choose another file", file.string()));
  }
  if (::access(file.c_str(), R_OK) != 0) fail_file(file, "cannot be read", errno);
}

}  // namespace gudgeon
