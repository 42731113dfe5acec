// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// HDF5 files: changed while they are partial, so that a finished one is never touched; read straight from disk.
// Under an Hdf5Session.
#pragma once

#include <filesystem>
#include <functional>

#include "gudgeon/io/hdf5_handle.h"
#include "gudgeon/io/safe_file.h"

namespace gudgeon {

/// Opens the partial file, an empty one as a new HDF5 file, hands over its root group, and closes it. A full disk is a
/// FileError with path and next step; a FileError out of change, or of the library, has no path yet.
void change_inside(const PartialFile& partial, const std::function<void(const Hdf5Handle& root)>& change);

/// Opens a file on disk for reading. FileError without path when it is not HDF5 or damaged.
Hdf5Handle open_file(const std::filesystem::path& file);

}  // namespace gudgeon
