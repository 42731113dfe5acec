// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The state of a computation as bytes, and back.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace gudgeon {

/// Each class with state lists its members once, in `void transfer(StateArchive&)`, which both saves and loads them:
/// an object made from the same model goes on from the bytes of another with the same bits. What follows from the model
/// alone is not listed. Bytes are those of this machine and of this program.
class StateArchive {
 public:
  /// Loads from sealed bytes, which have to outlive it. Throws FileError when they are damaged or foreign.
  explicit StateArchive(std::string_view sealed);

  /// The sealed bytes of what save(archive) saves; it is called twice, first to find how many they are.
  template <class Save>
  [[nodiscard]] static std::string pack(Save save) {
    StateArchive counting;
    counting.is_counting_ = true;
    save(counting);
    StateArchive archive;
    archive.saved_.reserve(archive.saved_.size() + counting.n_counted_);
    save(archive);
    return std::move(archive).seal();
  }

  [[nodiscard]] bool is_loading() const { return is_loading_; }

  /// Saves or loads each of them. A vector that is loaded keeps its length: it throws FileError when another was saved.
  template <class... Member>
  void operator()(Member&... members) {
    (transfer(members), ...);
  }
  /// A vector whose length is part of the state.
  template <class T>
  void list(std::vector<T>& values) {
    std::size_t n = values.size();
    transfer(n);
    if (is_loading_) {
      static_assert(is_plain<T>);
      if (n > left() / sizeof(T)) refuse();
      values.resize(n);
    }
    copy(values.data(), n * sizeof(T));
  }
  /// A text of any length.
  void text(std::string& value);
  /// A number that must be the same in both: FileError when it is not.
  template <class T>
  void require(const T& value) {
    T saved = value;
    transfer(saved);
    if (std::memcmp(&saved, &value, sizeof(T)) != 0) refuse();
  }
  /// A text that must be the same in both.
  void require_text(std::string_view text);
  /// An array that somebody else owns.
  void raw(double* values, std::size_t n) { copy(values, n * sizeof(double)); }

  /// Throws FileError: what is loaded cannot be what was saved.
  [[noreturn]] static void refuse();

  /// Throws FileError when there is more than was loaded.
  void expect_end() const;

 private:
  // Saves.
  StateArchive();
  // What was saved, with its checksum.
  [[nodiscard]] std::string seal() &&;

  // Numbers, and structs of nothing but numbers.
  template <class T>
  static constexpr bool is_plain = std::is_arithmetic_v<T> || std::is_enum_v<T> ||
                                   (std::is_trivially_copyable_v<T> && std::is_aggregate_v<T>);

  template <class T>
  void transfer(T& value) {
    if constexpr (requires { value.transfer(*this); }) {
      value.transfer(*this);
    } else {
      static_assert(is_plain<T>, "pointers and classes without transfer() cannot be saved");
      copy(&value, sizeof(T));
    }
  }
  template <class T>
  void transfer(std::vector<T>& values) {
    require(values.size());
    if constexpr (is_plain<T>) {
      copy(values.data(), values.size() * sizeof(T));
    } else {
      for (T& value : values) transfer(value);
    }
  }
  template <class T, std::size_t kSize>
  void transfer(std::array<T, kSize>& values) {
    for (T& value : values) transfer(value);
  }
  template <class T>
  void transfer(std::optional<T>& value) {
    bool has_value = value.has_value();
    transfer(has_value);
    if (is_loading_) value = has_value ? std::optional<T>(T{}) : std::nullopt;
    if (has_value) transfer(*value);
  }
  void copy(void* data, std::size_t size);
  [[nodiscard]] std::size_t left() const { return source_.size(); }

  bool is_loading_ = false;
  bool is_counting_ = false;
  std::size_t n_counted_ = 0;
  std::string saved_;        // behind room for the seal
  std::string_view source_;  // what is still to be loaded
};

/// A checksum of bytes.
[[nodiscard]] std::uint32_t find_checksum(std::string_view bytes);

}  // namespace gudgeon
