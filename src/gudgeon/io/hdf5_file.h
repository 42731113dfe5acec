// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// HDF5 files: built in memory as an image and written by us, so that a full disk is an ordinary error and never
// leaves the library half closed; read straight from disk. Under an Hdf5Session.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>

#include "gudgeon/io/hdf5_handle.h"

namespace gudgeon {

/// A file in memory that can be added to, and its bytes once it is finished.
class Hdf5Image {
 public:
  /// An empty file.
  Hdf5Image();
  /// Starts as a copy of the bytes of a file.
  explicit Hdf5Image(std::span<const std::byte> bytes);
  Hdf5Image(Hdf5Image&&) noexcept;
  ~Hdf5Image();

  [[nodiscard]] const Hdf5Handle& file() const { return file_; }
  /// Closes the file; every object in it must have been closed.
  void finish();
  /// Of the finished file. Needs no session any more.
  [[nodiscard]] std::span<const std::byte> bytes() const;

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;  // declared first: the file hands its bytes over while it closes
  Hdf5Handle file_;
};

/// Opens a file on disk for reading. FileError without path when it is not HDF5 or damaged.
Hdf5Handle open_file(const std::filesystem::path& file);

}  // namespace gudgeon
