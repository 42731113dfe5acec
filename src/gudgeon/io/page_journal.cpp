// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Journals as bytes: a mark, the end, the pages, a checksum; whole numbers as this machine has them.
#include "gudgeon/io/page_journal.h"

#include <boost/crc.hpp>
#include <cstring>
#include <fstream>
#include <iterator>

namespace gudgeon {

namespace {

constexpr std::string_view kMark = "gudgeon journal 1";

template <class Number>
void add_number(std::string& bytes, Number number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// Takes a number off the front; 0 when too few bytes are left.
template <class Number>
Number take_number(std::string_view& bytes) {
  Number number{};
  if (bytes.size() < sizeof number) return number;
  std::memcpy(&number, bytes.data(), sizeof number);
  bytes.remove_prefix(sizeof number);
  return number;
}

std::uint32_t find_checksum(std::string_view bytes) {
  boost::crc_32_type sum;
  sum.process_bytes(bytes.data(), bytes.size());
  return sum.checksum();
}

}  // namespace

std::filesystem::path find_journal(const std::filesystem::path& file) {
  std::filesystem::path journal = file;
  journal += ".journal";
  return journal;
}

std::string pack(const PageJournal& journal) {
  std::string bytes(kMark);
  add_number(bytes, journal.end);
  add_number(bytes, static_cast<std::uint64_t>(journal.pages.size()));
  for (const auto& [number, page] : journal.pages) {
    add_number(bytes, number);
    bytes.append(reinterpret_cast<const char*>(page.data()), page.size());
  }
  add_number(bytes, find_checksum(bytes));
  return bytes;
}

std::optional<PageJournal> unpack_journal(std::string_view bytes) {
  constexpr std::size_t kEntrySize = sizeof(std::uint64_t) + Hdf5Target::kPageSize;
  if (!bytes.starts_with(kMark) || bytes.size() < kMark.size() + sizeof(std::uint32_t)) return std::nullopt;
  std::string_view sum = bytes.substr(bytes.size() - sizeof(std::uint32_t));
  bytes.remove_suffix(sum.size());
  if (take_number<std::uint32_t>(sum) != find_checksum(bytes)) return std::nullopt;
  bytes.remove_prefix(kMark.size());
  PageJournal journal;
  journal.end = take_number<std::uint64_t>(bytes);
  const auto n_pages = take_number<std::uint64_t>(bytes);
  if (bytes.size() % kEntrySize != 0 || bytes.size() / kEntrySize != n_pages) return std::nullopt;
  while (!bytes.empty()) {
    Hdf5Target::Page& page = journal.pages[take_number<std::uint64_t>(bytes)];
    std::memcpy(page.data(), bytes.data(), page.size());
    bytes.remove_prefix(page.size());
  }
  return journal;
}

std::optional<PageJournal> read_journal(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return std::nullopt;
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  return unpack_journal(bytes);
}

}  // namespace gudgeon
