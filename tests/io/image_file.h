// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// HDF5 files made piece by piece.
#pragma once

#include <filesystem>
#include <functional>

#include "gudgeon/io/hdf5_dataset.h"
#include "gudgeon/io/hdf5_file.h"
#include "gudgeon/io/hdf5_node.h"
#include "gudgeon/io/safe_file.h"

namespace gudgeon::test {

inline void write_image(const std::filesystem::path& file, const std::function<void(const Hdf5Handle& root)>& fill) {
  const Hdf5Session session;
  PartialFile partial(file);
  change_inside(partial, fill);
  partial.put_in_place();
}

}  // namespace gudgeon::test
