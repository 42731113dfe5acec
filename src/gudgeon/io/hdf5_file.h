// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// HDF5 files over a driver of ours: changed behind a target, read as they were at one moment. Under an Hdf5Session.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "gudgeon/io/hdf5_driver.h"
#include "gudgeon/io/hdf5_handle.h"
#include "gudgeon/io/safe_file.h"

namespace gudgeon {

/// Opens the target's file, an empty one as a new HDF5 file, hands over its root group, and closes it. A failed write
/// is left in Hdf5Target::failure; a FileError out of change, or of the library, has no path yet.
void change_target(Hdf5Target& target, const std::filesystem::path& name, bool is_new,
                   const std::function<void(const Hdf5Handle& root)>& change);

/// The same for a partial file, where a failed write is a FileError with path and next step.
void change_inside(const PartialFile& partial, const std::function<void(const Hdf5Handle& root)>& change);

/// An HDF5 file open for reading, as it was at the moment it was opened, also while a run adds to it.
class Hdf5Source {
 public:
  /// FileError without path when it is not HDF5 or damaged.
  explicit Hdf5Source(const std::filesystem::path& file);

  [[nodiscard]] const Hdf5Handle& root() const { return root_; }

 private:
  struct Descriptor {
    int number = -1;
    ~Descriptor();
  };
  Descriptor descriptor_;
  std::unique_ptr<Hdf5Target> target_;  // where the library looks for it
  Hdf5Handle file_;
  Hdf5Handle root_;
};

}  // namespace gudgeon
