// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Partial files by our own driver, finished files by HDF5's default one.
#include "gudgeon/io/hdf5_file.h"

#include <hdf5.h>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/hdf5_driver.h"
#include "gudgeon/io/hdf5_node.h"

namespace gudgeon {

namespace {

/// The file format of HDF5 1.10 has checksums on all metadata: damage is noticed instead of followed.
Hdf5Handle make_access() {
  Hdf5Handle access = check_id(H5Pcreate(H5P_FILE_ACCESS), "cannot make file access", "fapl");
  check_status(H5Pset_libver_bounds(access.id(), H5F_LIBVER_V110, H5F_LIBVER_V110), "cannot set", "file format");
  return access;
}

/// Changes the file behind the target; the library has let go of it when this returns or throws.
void change_target(Hdf5Target& target, const char* name, bool is_new,
                   const std::function<void(const Hdf5Handle& root)>& change) {
  const Hdf5Handle access = make_access();
  use_target(access, target);
  const Hdf5Handle file = check_id(
      is_new ? H5Fcreate(name, H5F_ACC_TRUNC, H5P_DEFAULT, access.id()) : H5Fopen(name, H5F_ACC_RDWR, access.id()),
      "cannot open", "/");
  change(open_root(file));
  check_status(H5Fflush(file.id(), H5F_SCOPE_GLOBAL), "cannot flush", "/");
}

}  // namespace

void change_inside(const PartialFile& partial, const std::function<void(const Hdf5Handle& root)>& change) {
  Hdf5Target target{partial.descriptor()};
  try {
    change_target(target, partial.path().c_str(), partial.is_empty(), change);
  } catch (const FileError&) {
    // What is missing on the disk may be what the library stumbled over.
    if (target.failure == 0) throw;
  }
  if (target.failure != 0) partial.fail_write(target.failure);
}

Hdf5Handle open_file(const std::filesystem::path& file) {
  if (H5Fis_hdf5(file.c_str()) <= 0) throw FileError("it is not an HDF5 file");
  const Hdf5Handle access = make_access();
  // a finished file is only ever replaced, never changed, so no lock is needed (some network disks have none)
  check_status(H5Pset_file_locking(access.id(), false, true), "cannot set", "file locking");
  return check_id(H5Fopen(file.c_str(), H5F_ACC_RDONLY, access.id()), "cannot open", "/");
}

}  // namespace gudgeon
