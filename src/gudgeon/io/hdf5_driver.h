// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Where HDF5 writes: a file descriptor of ours, and the first failure there. Under an Hdf5Session.
#pragma once

#include "gudgeon/io/hdf5_handle.h"

namespace gudgeon {

/// Outlives the HDF5 file that is opened on it.
struct Hdf5Target {
  int descriptor = -1;  ///< open for reading and writing
  int failure = 0;      ///< errno of the first write that failed; 0 when none did
};

/// Files opened with this access are the target's, whatever their name. The library is told of no failed write: it
/// cannot close a file whose writes fail, and would be left with it half closed for the rest of the process. What is
/// written after the first failure goes nowhere; who opened the file looks at failure once it is closed.
void use_target(const Hdf5Handle& access, Hdf5Target& target);

}  // namespace gudgeon
