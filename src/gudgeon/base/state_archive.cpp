// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Copies, and a seal around them.
#include "gudgeon/base/state_archive.h"

#include <boost/crc.hpp>

#include "gudgeon/base/diagnostics.h"

namespace gudgeon {

namespace {

// What sealed bytes begin with; the checksum follows. Another layout of the bytes gets another number.
constexpr std::string_view kSealMark = "gudgeon state 1\n";
constexpr std::size_t kSealSize = kSealMark.size() + sizeof(std::uint32_t);

}  // namespace

std::uint32_t find_checksum(std::string_view bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

StateArchive::StateArchive() : saved_(kSealMark) { saved_.resize(kSealSize); }

StateArchive::StateArchive(std::string_view sealed) : is_loading_(true) {
  if (sealed.size() < kSealSize || !sealed.starts_with(kSealMark)) refuse();
  std::uint32_t checksum = 0;
  std::memcpy(&checksum, sealed.data() + kSealMark.size(), sizeof checksum);
  source_ = sealed.substr(kSealSize);
  if (find_checksum(source_) != checksum) refuse();
}

std::string StateArchive::seal() && {
  const std::uint32_t checksum = find_checksum(std::string_view(saved_).substr(kSealSize));
  std::memcpy(saved_.data() + kSealMark.size(), &checksum, sizeof checksum);
  return std::move(saved_);
}

void StateArchive::require_text(std::string_view text) {
  require(text.size());
  std::string saved(text);
  copy(saved.data(), saved.size());
  if (saved != text) refuse();
}

void StateArchive::text(std::string& value) {
  std::size_t n = value.size();
  transfer(n);
  if (is_loading_) {
    if (n > left()) refuse();
    value.resize(n);
  }
  copy(value.data(), n);
}

void StateArchive::expect_end() const {
  if (!source_.empty()) refuse();
}

void StateArchive::copy(void* data, std::size_t size) {
  if (size == 0) return;
  if (is_counting_) {
    n_counted_ += size;
    return;
  }
  if (!is_loading_) {
    saved_.append(static_cast<const char*>(data), size);
    return;
  }
  if (size > source_.size()) refuse();
  std::memcpy(data, source_.data(), size);
  source_.remove_prefix(size);
}

void StateArchive::refuse() { throw FileError("the checkpoint is damaged, or of another model, study or program"); }

}  // namespace gudgeon
