// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Plain POSIX writing, because only there every failure has its own reason.
#include "gudgeon/io/safe_file.h"

#include <fcntl.h>
#include <fmt/format.h>
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

[[noreturn]] void fail(const std::filesystem::path& file, std::string_view what, int why) {
  throw FileError(fmt::format("{}: {}: {}; {}", file.string(), what, std::strerror(why), find_next_step(why)));
}

/// An open file descriptor.
class Descriptor {
 public:
  Descriptor(const std::filesystem::path& file, int flags) : number_(::open(file.c_str(), flags | O_CLOEXEC, 0666)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }

  [[nodiscard]] int number() const { return number_; }
  int close() { return number_ < 0 ? 0 : ::close(std::exchange(number_, -1)); }

 private:
  int number_;
};

/// Takes the partial file away unless it was kept.
class PartialFile {
 public:
  explicit PartialFile(std::filesystem::path path) : path_(std::move(path)) {}
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;
  ~PartialFile() {
    if (!kept_) ::unlink(path_.c_str());
  }
  void keep() { kept_ = true; }

 private:
  std::filesystem::path path_;
  bool kept_ = false;
};

/// Writes everything down to the disk; the errno of what failed, or 0.
int write_bytes(Descriptor& target, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(target.number(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  if (::fsync(target.number()) != 0 && errno != EINVAL) return errno;  // EINVAL: a place that knows no fsync
  return target.close() == 0 ? 0 : errno;
}

}  // namespace

std::filesystem::path find_partial(const std::filesystem::path& file) {
  std::filesystem::path partial = file;
  partial += ".partial";
  return partial;
}

void write_whole(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  const std::filesystem::path path = find_partial(file);
  Descriptor target(path, O_WRONLY | O_CREAT | O_TRUNC);
  if (target.number() < 0) fail(path, "cannot be created", errno);
  PartialFile partial(path);
  if (const int why = write_bytes(target, bytes); why != 0) fail(file, "cannot be written", why);
  if (::rename(path.c_str(), file.c_str()) != 0) fail(file, "cannot be put in place", errno);
  partial.keep();
}

void write_whole(const std::filesystem::path& file, std::string_view text) {
  write_whole(file, std::as_bytes(std::span(text)));
}

std::vector<std::byte> read_whole(const std::filesystem::path& file) {
  check_source(file);
  const Descriptor source(file, O_RDONLY);
  struct stat status {};
  if (source.number() < 0 || ::fstat(source.number(), &status) != 0) fail(file, "cannot be read", errno);
  std::vector<std::byte> bytes(static_cast<std::size_t>(status.st_size));
  std::span<std::byte> rest(bytes);
  while (!rest.empty()) {
    const ssize_t count = ::read(source.number(), rest.data(), rest.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail(file, "cannot be read", count < 0 ? errno : EIO);
    rest = rest.subspan(static_cast<std::size_t>(count));
  }
  return bytes;
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
