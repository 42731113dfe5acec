// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Opening HDF5 files over our driver.
#include "gudgeon/io/hdf5_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <hdf5.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/hdf5_node.h"
#include "gudgeon/io/page_journal.h"

namespace gudgeon {

namespace {

/// The file format of HDF5 1.10 has checksums on all metadata: damage is noticed instead of followed.
Hdf5Handle make_access(Hdf5Target& target) {
  Hdf5Handle access = check_id(H5Pcreate(H5P_FILE_ACCESS), "cannot make file access", "fapl");
  check_status(H5Pset_libver_bounds(access.id(), H5F_LIBVER_V110, H5F_LIBVER_V110), "cannot set", "file format");
  use_target(access, target);
  return access;
}

Hdf5Handle make_file(const std::filesystem::path& name, const Hdf5Handle& access) {
  const Hdf5Handle creation = check_id(H5Pcreate(H5P_FILE_CREATE), "cannot make file creation", "fcpl");
  keep_order(creation);
  check_status(H5Pset_est_link_info(creation.id(), 8, 12), "cannot make room in group", "/");
  return check_id(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), "cannot open", "/");
}

int open_descriptor(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw FileError(std::strerror(errno));
  return descriptor;
}

/// What a commit under way, or one that was killed, changes; the first page, where the file's end stands and what hangs
/// from its root, is taken once, so that both are of one moment.
std::unique_ptr<Hdf5Target> find_source(const std::filesystem::path& file, int descriptor) {
  auto target = std::make_unique<Hdf5Target>();
  target->descriptor = descriptor;
  target->protected_end = std::numeric_limits<std::uint64_t>::max();
  if (std::optional<PageJournal> journal = read_journal(file, descriptor)) {
    target->pages = std::move(journal->pages);
  } else {
    const ssize_t count = ::pread(descriptor, target->pages[0].data(), Hdf5Target::kPageSize, 0);
    if (count < 0) throw FileError(std::strerror(errno));
  }
  return target;
}

Hdf5Handle open_source(const std::filesystem::path& file, Hdf5Target& target) {
  if (H5Fis_hdf5(file.c_str()) <= 0) throw FileError("it is not an HDF5 file");
  const Hdf5Handle access = make_access(target);
  return check_id(H5Fopen(file.c_str(), H5F_ACC_RDONLY, access.id()), "cannot open", "/");
}

}  // namespace

void change_target(Hdf5Target& target, const std::filesystem::path& name, bool is_new,
                   const std::function<void(const Hdf5Handle& root)>& change) {
  const Hdf5Handle access = make_access(target);
  const Hdf5Handle file =
      is_new ? make_file(name, access) : check_id(H5Fopen(name.c_str(), H5F_ACC_RDWR, access.id()), "cannot open", "/");
  change(open_root(file));
  check_status(H5Fflush(file.id(), H5F_SCOPE_GLOBAL), "cannot flush", "/");
}

void change_inside(const PartialFile& partial, const std::function<void(const Hdf5Handle& root)>& change) {
  Hdf5Target target;
  target.descriptor = partial.descriptor();
  try {
    change_target(target, partial.path(), partial.is_empty(), change);
  } catch (const FileError&) {
    // What is missing on the disk may be what the library stumbled over.
    if (target.failure == 0) throw;
  }
  if (target.failure != 0) partial.fail_write(target.failure);
}

Hdf5Source::Descriptor::~Descriptor() {
  if (number >= 0) ::close(number);
}

Hdf5Source::Hdf5Source(const std::filesystem::path& file)
    : descriptor_{open_descriptor(file)},
      target_(find_source(file, descriptor_.number)),
      file_(open_source(file, *target_)),
      root_(open_root(file_)) {}

}  // namespace gudgeon
