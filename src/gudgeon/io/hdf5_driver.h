// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Where HDF5 reads and writes: a file descriptor of ours, pages that are not in the file yet, and the first failure.
// Under an Hdf5Session.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>

#include "gudgeon/io/hdf5_handle.h"

namespace gudgeon {

/// A file that HDF5 changes. What was there before is not touched: bytes before protected_end are changed in copies of
/// their pages, which GrowingFile::commit() brings into the file; what comes behind goes there directly.
/// Outlives the HDF5 file that is opened on it.
struct Hdf5Target {
  static constexpr std::size_t kPageSize = 4096;
  using Page = std::array<std::byte, kPageSize>;

  int descriptor = -1;                    ///< open for reading and writing; for reading alone where all is protected
  std::uint64_t protected_end = 0;        ///< [bytes]
  std::uint64_t end = 0;                  ///< [bytes] of what HDF5 has in it, once it is closed
  std::map<std::uint64_t, Page> pages{};  ///< changed ones, by number
  int failure = 0;                        ///< errno of the first write that failed; 0 when none did
};

/// Files opened with this access are the target's, whatever their name. The library is told of no failed write: it
/// cannot close a file whose writes fail, and would be left with it half closed for the rest of the process. What is
/// written after the first failure goes nowhere; who opened the file looks at failure once it is closed.
void use_target(const Hdf5Handle& access, Hdf5Target& target);

}  // namespace gudgeon
