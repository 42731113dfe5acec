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
#include <memory>
#include <utility>
#include <vector>

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

[[noreturn]] void fail(const std::filesystem::path& file, std::string_view what, int why) {
  throw FileError(fmt::format("{}: {}: {}; {}", file.string(), what, std::strerror(why), find_next_step(why)));
}

bool is_same_file(int descriptor, const std::filesystem::path& path) {
  struct stat opened {};
  struct stat there {};
  return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &there) == 0 && opened.st_ino == there.st_ino &&
         opened.st_dev == there.st_dev;
}

/// Opens the path empty for this process alone: two writers would mix their bytes. A lock ends with its process.
int open_alone(const std::filesystem::path& path) {
  while (true) {
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor < 0) fail(path, "cannot be created", errno);
    // Where a disk knows no locks, all goes on without.
    const bool is_taken = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    // Who held the lock may have put the file in place meanwhile: then it is not ours to empty.
    const bool is_ours = !is_taken && is_same_file(descriptor, path);
    const int why = is_ours && ::ftruncate(descriptor, 0) != 0 ? errno : 0;
    if (is_ours && (why == 0 || why == EINVAL)) return descriptor;  // EINVAL: a device that has no length
    ::close(descriptor);
    if (is_ours) fail(path, "cannot be created", why);
    if (is_taken) {
      throw FileError(
          fmt::format("{}: another run is writing it; wait for its end or choose another place", path.string()));
    }
  }
}

constexpr std::size_t kCopyPiece = 1u << 18;  // [bytes] large enough that calls cost nothing beside the disk

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

void PartialFile::write_old_version() {
  const int source = ::open(file_.c_str(), O_RDONLY | O_CLOEXEC);
  if (source < 0) fail(file_, "cannot be read", errno);
  const std::unique_ptr<const int, void (*)(const int*)> closing(&source, [](const int* open) { ::close(*open); });
  std::vector<std::byte> piece(kCopyPiece);
  while (true) {
    const ssize_t count = ::read(source, piece.data(), piece.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(file_, "cannot be read", errno);
    if (count == 0) return;
    write(std::span(piece).first(static_cast<std::size_t>(count)));
  }
}

void PartialFile::put_in_place() {
  if (::fsync(descriptor_) != 0 && errno != EINVAL) fail_write(errno);  // EINVAL: a place that knows no fsync
  const bool closed = ::close(std::exchange(descriptor_, -1)) == 0;
  if (closed && ::rename(path_.c_str(), file_.c_str()) == 0) return;
  const int why = errno;
  ::unlink(path_.c_str());
  if (!closed) fail_write(why);
  fail(file_, "cannot be put in place", why);
}

void PartialFile::fail_write(int why) const { fail(file_, "cannot be written", why); }

void write_whole(const std::filesystem::path& file, std::string_view text) {
  PartialFile partial(file);
  partial.write(std::as_bytes(std::span(text)));
  partial.put_in_place();
}

void check_target(const std::filesystem::path& file, bool overwrite) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return;  // nothing there; other troubles show when writing
  if (S_ISDIR(status.st_mode)) fail(file, "cannot be written", EISDIR);
  if (!S_ISREG(status.st_mode)) {
    throw FileError(fmt::format("{}: cannot be written: it is not a regular file; choose another name", file.string()));
  }
  if (!overwrite) {
    throw FileError(
        fmt::format("{}: exists already and is not replaced unasked; choose another name or allow "
                    "overwriting",
                    file.string()));
  }
}

void check_source(const std::filesystem::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) fail(file, "cannot be read", errno);
  if (S_ISDIR(status.st_mode)) fail(file, "cannot be read", EISDIR);
  if (!S_ISREG(status.st_mode)) {
    throw FileError(fmt::format("{}: cannot be read: it is not a regular file; choose another file", file.string()));
  }
  if (::access(file.c_str(), R_OK) != 0) fail(file, "cannot be read", errno);
}

}  // namespace gudgeon
