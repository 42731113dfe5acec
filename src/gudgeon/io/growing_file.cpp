// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Changes in pages, journals, and asking whether the file is still ours.
#include "gudgeon/io/growing_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/hdf5_file.h"
#include "gudgeon/io/page_journal.h"
#include "gudgeon/io/safe_file.h"

namespace gudgeon {

namespace {

constexpr std::string_view kTakenAway =
    "another program replaced or changed it while the run went on; what this run finished since is not in it: run "
    "again where nothing else writes";

std::uint64_t find_size(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
}

/// 0, or why it failed.
int write_page(int descriptor, std::uint64_t number, const Hdf5Target::Page& page) {
  std::span<const std::byte> rest(page);
  std::uint64_t address = number * Hdf5Target::kPageSize;
  while (!rest.empty()) {
    const ssize_t count = ::pwrite(descriptor, rest.data(), rest.size(), static_cast<off_t>(address));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    rest = rest.subspan(static_cast<std::size_t>(count));
    address += static_cast<std::uint64_t>(count);
  }
  return 0;
}

}  // namespace

GrowingFile::GrowingFile(std::filesystem::path file) : file_(std::move(file)) {
  check_source(file_);
  target_.descriptor = ::open(file_.c_str(), O_RDWR | O_CLOEXEC);
  if (target_.descriptor < 0) fail_file(file_, "cannot be written", errno);
  try {
    if (std::optional<PageJournal> journal = read_journal(file_, target_.descriptor)) {
      target_.pages = std::move(journal->pages);
      apply(journal->end);
    }
    // Its end is where HDF5 says; what a kill left behind that is still there.
    target_.protected_end = std::numeric_limits<std::uint64_t>::max();
    change_target(target_, file_, false, [](const Hdf5Handle&) {});
  } catch (const FileError& error) {
    ::close(target_.descriptor);
    throw FileError(fmt::format("{}: cannot be added to: {}", file_.string(), error.what()));
  }
  target_.pages.clear();
  note_committed(target_.end);
}

GrowingFile::~GrowingFile() {
  roll_back();
  ::close(target_.descriptor);
}

bool GrowingFile::is_ours() const {
  return is_same_file(target_.descriptor, file_) && find_size(target_.descriptor) >= committed_end_ &&
         read_committed_page() == first_page_;
}

void GrowingFile::require_ours() const {
  if (!is_ours()) throw FileError(fmt::format("{}: {}", file_.string(), kTakenAway));
}

void GrowingFile::change(const std::function<void(const Hdf5Handle& root)>& change) {
  require_ours();
  is_changed_ = true;
  try {
    change_target(target_, file_, false, change);
  } catch (const FileError&) {
    if (target_.failure == 0) {
      roll_back();
      throw;
    }
  }
  if (target_.failure != 0) fail(target_.failure);
}

void GrowingFile::synchronize() {
  if (::fsync(target_.descriptor) != 0 && errno != EINVAL) fail(errno);  // EINVAL: a place that knows no fsync
}

void GrowingFile::commit() {
  if (!is_changed_) return;
  require_ours();
  synchronize();
  std::erase_if(target_.pages,
                [&](const auto& entry) { return read_page(target_.descriptor, entry.first) == entry.second; });
  try {
    write_whole(find_journal(file_), pack({target_.end, target_.pages, first_page_}));
  } catch (const FileError&) {
    roll_back();
    throw;
  }
  apply(target_.end);
}

// The journal is whole: from here on every failure is mended by whoever opens the file next.
void GrowingFile::apply(std::uint64_t end) {
  committed_end_ = end;  // the journal leads there: what lies before it is not cut off any more
  int why = 0;
  // The first page names the new end, which others may point behind: it goes first, and they are in order.
  for (const auto& [number, page] : target_.pages) {
    if (why == 0) why = write_page(target_.descriptor, number, page);
  }
  if (why == 0 && find_size(target_.descriptor) != end) {
    why = ::ftruncate(target_.descriptor, static_cast<off_t>(end)) == 0 ? 0 : errno;
  }
  if (why == 0 && ::fsync(target_.descriptor) != 0 && errno != EINVAL) why = errno;
  target_.pages.clear();
  if (why != 0) fail_file(file_, "cannot be written", why);
  ::unlink(find_journal(file_).c_str());
  note_committed(end);
}

void GrowingFile::note_committed(std::uint64_t end) {
  committed_end_ = end;
  first_page_ = read_committed_page();
  target_.end = end;
  target_.protected_end = end;
  is_changed_ = false;
}

Hdf5Target::Page GrowingFile::read_committed_page() const {
  Hdf5Target::Page page = read_page(target_.descriptor, 0);
  const auto n_committed = static_cast<std::ptrdiff_t>(std::min<std::uint64_t>(committed_end_, page.size()));
  std::fill(page.begin() + n_committed, page.end(), std::byte{0});
  return page;
}

void GrowingFile::roll_back() {
  target_.pages.clear();
  target_.failure = 0;
  target_.protected_end = committed_end_;
  target_.end = committed_end_;
  is_changed_ = false;
  // What cannot be cut off does no harm behind the file's end.
  if (is_ours() && find_size(target_.descriptor) > committed_end_) {
    [[maybe_unused]] const int ignored = ::ftruncate(target_.descriptor, static_cast<off_t>(committed_end_));
  }
}

void GrowingFile::fail(int why) {
  roll_back();
  fail_file(file_, "cannot be written", why);
}

std::string GrowingFile::save_changes() {
  require_ours();
  synchronize();
  // What is in the file now is not touched again before the next commit.
  target_.protected_end = target_.end;
  return pack({target_.end, target_.pages, first_page_});
}

bool GrowingFile::restore_changes(std::string_view saved) {
  std::optional<PageJournal> changes = unpack_journal(saved);
  if (!changes) return false;
  const bool fits =
      changes->first_before == first_page_ && find_size(target_.descriptor) >= changes->end && !is_changed_;
  if (!fits) return false;
  target_.pages = std::move(changes->pages);
  target_.end = changes->end;
  target_.protected_end = changes->end;
  is_changed_ = true;
  return true;
}

}  // namespace gudgeon
