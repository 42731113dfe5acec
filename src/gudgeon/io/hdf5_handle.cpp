// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Closing by kind, the library's lock, and HDF5's error stack as one phrase.
#include "gudgeon/io/hdf5_handle.h"

#include <fmt/format.h>
#include <hdf5.h>
#include <sys/mman.h>

#include <array>
#include <cstddef>
#include <cstring>
#include <new>
#include <type_traits>

#include "gudgeon/base/diagnostics.h"

namespace gudgeon {

static_assert(std::is_same_v<hid_t, Hdf5Id>, "HDF5 1.10 or later has 64-bit identifiers");

namespace {

std::mutex& hdf5_mutex() {
  static std::mutex mutex;
  return mutex;
}

// [bytes] of a reason that are told
using Reason = std::array<char, 200>;

/// Keeps the description that lies deepest in the stack: the cause, not who passed it on. Allocates nothing: where no
/// memory is left, an exception would go through the library, which then holds its own lock for ever.
herr_t keep_deepest(unsigned, const H5E_error2_t* error, void* data) {
  auto& reason = *static_cast<Reason*>(data);
  if (error->desc != nullptr) std::strncpy(reason.data(), error->desc, reason.size() - 1);
  return 0;
}

std::string find_reason() {
  Reason reason{};
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keep_deepest, &reason);
  return reason.front() == '\0' ? "no reason given" : reason.data();
}

/// std::bad_alloc where memory is as good as used up: the library up to 1.10 would use what it was not given.
void require_memory() {
  constexpr std::size_t kRoom = 16U << 20U;  // [bytes] more than it takes for any block of ours
  void* room = ::mmap(nullptr, kRoom, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (room == MAP_FAILED) throw std::bad_alloc();
  ::munmap(room, kRoom);
}

}  // namespace

Hdf5Handle::~Hdf5Handle() {
  if (id_ < 0) return;
  switch (H5Iget_type(id_)) {
    case H5I_FILE:
      H5Fclose(id_);
      break;
    case H5I_GROUP:
      H5Gclose(id_);
      break;
    case H5I_DATASET:
      H5Dclose(id_);
      break;
    case H5I_DATASPACE:
      H5Sclose(id_);
      break;
    case H5I_DATATYPE:
      H5Tclose(id_);
      break;
    case H5I_ATTR:
      H5Aclose(id_);
      break;
    case H5I_GENPROP_LST:
      H5Pclose(id_);
      break;
    default:
      H5Oclose(id_);
      break;
  }
}

// Every handle closes itself, so that nothing is left for the library to close at exit. What it keeps inside of a
// damaged file that it failed to open it cannot close either: up to HDF5 1.10 it tries a hundred times and complains.
Hdf5Session::Hdf5Session() : lock_(hdf5_mutex()) {
  require_memory();
  [[maybe_unused]] static const int once = H5dont_atexit();
  H5Eget_auto2(H5E_DEFAULT, &print_errors_, &print_data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Session::~Hdf5Session() { H5Eset_auto2(H5E_DEFAULT, print_errors_, print_data_); }

Hdf5Handle check_id(Hdf5Id id, std::string_view what, std::string_view name) {
  if (id < 0) throw FileError(fmt::format("{} '{}' (HDF5: {})", what, name, find_reason()));
  return Hdf5Handle(id);
}

void check_status(int status, std::string_view what, std::string_view name) {
  if (status < 0) throw FileError(fmt::format("{} '{}' (HDF5: {})", what, name, find_reason()));
}

}  // namespace gudgeon
