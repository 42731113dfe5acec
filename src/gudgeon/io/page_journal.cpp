// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Journals as sealed bytes.
#include "gudgeon/io/page_journal.h"

#include <fcntl.h>
#include <unistd.h>

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
void transfer(StateArchive& archive, PageJournal& journal, std::vector<Entry>& entries) {
  archive.require_text("pages of a run file");
  archive(journal.end, journal.first_before);
  archive.list(entries);
}

bool is_of_file(const PageJournal& journal, int descriptor) {
  const Hdf5Target::Page now = read_page(descriptor, 0);
  const auto first = journal.pages.find(0);
  const Hdf5Target::Page& after = first == journal.pages.end() ? journal.first_before : first->second;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (now[i] != journal.first_before[i] && now[i] != after[i]) return false;
  }
  return true;
}

/// The journal beside the file, of whatever file it is; nothing when there is none that is whole.
std::optional<PageJournal> read_any_journal(const std::filesystem::path& file) {
  std::error_code none;
  const std::filesystem::path path = find_journal(file);
  if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(path, none))) return std::nullopt;
  // At most all of the file changed, and the new end of it.
  const std::uintmax_t most = 2 * std::filesystem::file_size(file, none) + (1U << 20U);
  if (none || std::filesystem::file_size(path, none) > most || none) return std::nullopt;
  std::ifstream in(path, std::ios::binary);
  if (!in) return std::nullopt;
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  return unpack_journal(bytes);
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
  PageJournal numbers{journal.end, {}, journal.first_before};
  return StateArchive::pack([&](StateArchive& archive) { transfer(archive, numbers, entries); });
}

std::optional<PageJournal> unpack_journal(std::string_view bytes) {
  PageJournal journal;
  std::vector<Entry> entries;
  try {
    StateArchive archive(bytes);
    transfer(archive, journal, entries);
    archive.expect_end();
  } catch (const FileError&) {
    return std::nullopt;
  }
  for (const Entry& entry : entries) journal.pages.emplace(entry.number, entry.page);
  return journal;
}

Hdf5Target::Page read_page(int descriptor, std::uint64_t number) {
  Hdf5Target::Page page{};
  [[maybe_unused]] const ssize_t count =
      ::pread(descriptor, page.data(), page.size(), static_cast<off_t>(number * Hdf5Target::kPageSize));
  return page;
}

std::optional<PageJournal> read_journal(const std::filesystem::path& file, int descriptor) {
  std::optional<PageJournal> journal = read_any_journal(file);
  if (journal && !is_of_file(*journal, descriptor)) return std::nullopt;
  return journal;
}

bool has_foreign_journal(const std::filesystem::path& file) {
  const std::optional<PageJournal> journal = read_any_journal(file);
  const int descriptor = journal ? ::open(file.c_str(), O_RDONLY | O_CLOEXEC) : -1;
  if (descriptor < 0) return false;
  const bool is_foreign = !is_of_file(*journal, descriptor);
  ::close(descriptor);
  return is_foreign;
}

}  // namespace gudgeon
