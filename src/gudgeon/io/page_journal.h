// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Changes of a file that are written down beside it before they are made, so that a kill between two of them is mended.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "gudgeon/io/hdf5_driver.h"

namespace gudgeon {

struct PageJournal {
  std::uint64_t end = 0;                              ///< [bytes] of the file once it is changed
  std::map<std::uint64_t, Hdf5Target::Page> pages{};  ///< by number
  Hdf5Target::Page first_before{};                    ///< the file's first page as it was
};

/// Beside the file: "x.h5.journal".
std::filesystem::path find_journal(const std::filesystem::path& file);

/// As bytes with a checksum.
std::string pack(const PageJournal& journal);
/// Nothing when the bytes are not a whole journal.
std::optional<PageJournal> unpack_journal(std::string_view bytes);

/// The journal beside the file, which is open for reading. Nothing when there is none that is whole, as the file was
/// not changed then; nor when it is of another file: the first page is neither as it was nor as it will be, nor part of
/// each.
std::optional<PageJournal> read_journal(const std::filesystem::path& file, int descriptor);

/// Whether the journal beside the file is whole, but of another file: it was copied there, and is not used.
bool has_foreign_journal(const std::filesystem::path& file);

/// The page as it is on the disk, zeros beyond its end.
Hdf5Target::Page read_page(int descriptor, std::uint64_t number);

}  // namespace gudgeon
