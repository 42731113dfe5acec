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
};

/// Beside the file: "x.h5.journal".
std::filesystem::path find_journal(const std::filesystem::path& file);

/// As bytes with a checksum.
std::string pack(const PageJournal& journal);
/// Nothing when the bytes are not a whole journal.
std::optional<PageJournal> unpack_journal(std::string_view bytes);

/// Nothing when there is none, or none that is whole: then the file was not changed.
std::optional<PageJournal> read_journal(const std::filesystem::path& path);

}  // namespace gudgeon
