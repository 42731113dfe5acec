// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Journals as sealed bytes.
#include "gudgeon/io/page_journal.h"

#include <fstream>
#include <iterator>
#include <vector>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/base/state_archive.h"

namespace gudgeon {

namespace {

struct Entry {
  std::uint64_t number;
  Hdf5Target::Page page;
};

/// Saves or loads.
void transfer(StateArchive& archive, std::uint64_t& end, std::vector<Entry>& entries) {
  archive.require_text("pages of a run file");
  archive(end);
  archive.list(entries);
}

}  // namespace

std::filesystem::path find_journal(const std::filesystem::path& file) {
  std::filesystem::path journal = file;
  journal += ".journal";
  return journal;
}

std::string pack(const PageJournal& journal) {
  std::vector<Entry> entries;
  entries.reserve(journal.pages.size());
  for (const auto& [number, page] : journal.pages) entries.push_back({number, page});
  std::uint64_t end = journal.end;
  StateArchive archive;
  transfer(archive, end, entries);
  return archive.seal();
}

std::optional<PageJournal> unpack_journal(std::string_view bytes) {
  PageJournal journal;
  std::vector<Entry> entries;
  try {
    StateArchive archive(bytes);
    transfer(archive, journal.end, entries);
    archive.expect_end();
  } catch (const FileError&) {
    return std::nullopt;
  }
  for (const Entry& entry : entries) journal.pages.emplace(entry.number, entry.page);
  return journal;
}

std::optional<PageJournal> read_journal(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return std::nullopt;
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  return unpack_journal(bytes);
}

}  // namespace gudgeon
