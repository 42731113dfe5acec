// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// HDF5 identifiers that close themselves, checked calls, and the lock every use of the library stands under.
// Failures leave as FileError naming the object in the file; who opened the file adds its path.
#pragma once

#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

namespace gudgeon {

/// HDF5's hid_t, named here so that no header needs the library's own.
using Hdf5Id = std::int64_t;

/// Owns one HDF5 identifier of any kind.
class Hdf5Handle {
 public:
  explicit Hdf5Handle(Hdf5Id id) : id_(id) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, kNone)) {}
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;
  ~Hdf5Handle();

  [[nodiscard]] Hdf5Id id() const { return id_; }

 private:
  static constexpr Hdf5Id kNone = -1;
  Hdf5Id id_ = kNone;
};

/// Alone with HDF5 while it lives, and the library's own printing of errors silenced. Debian's serial HDF5 is not
/// safe for threads, so whoever touches it makes one of these first; not recursive.
class Hdf5Session {
 public:
  Hdf5Session();
  ~Hdf5Session();
  Hdf5Session(const Hdf5Session&) = delete;
  Hdf5Session& operator=(const Hdf5Session&) = delete;

 private:
  using PrintErrors = int (*)(Hdf5Id, void*);
  std::lock_guard<std::mutex> lock_;
  PrintErrors print_errors_ = nullptr;  // as found, put back at the end
  void* print_data_ = nullptr;
};

/// The identifier as a handle; FileError "<what> '<name>' (HDF5: why)" when it is negative.
Hdf5Handle check_id(Hdf5Id id, std::string_view what, std::string_view name);
/// FileError when an HDF5 call returned a negative status.
void check_status(int status, std::string_view what, std::string_view name);

}  // namespace gudgeon
