// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Files in memory by HDF5's core driver, files on disk by its default one.
//
// The image is taken where the library frees it, after its closing writes. H5Fget_file_image is of no use here: up to
// HDF5 1.10 it changes a flag in the superblock without its checksum, and the file cannot be opened again.
#include "gudgeon/io/hdf5_file.h"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "gudgeon/base/diagnostics.h"

namespace gudgeon {

/// The library's buffer of the open file, ours once the file is closed.
struct Hdf5Image::Memory {
  std::size_t size = 0;
  std::unique_ptr<void, decltype(&std::free)> taken{nullptr, &std::free};

  static void* allocate(std::size_t size, H5FD_file_image_op_t operation, void* memory) {
    if (operation == H5FD_FILE_IMAGE_OP_FILE_OPEN) static_cast<Memory*>(memory)->size = size;
    return std::malloc(size);
  }
  static void* copy(void* to, const void* from, std::size_t size, H5FD_file_image_op_t, void*) {
    return std::memcpy(to, from, size);
  }
  static void* resize(void* buffer, std::size_t size, H5FD_file_image_op_t, void* memory) {
    void* moved = std::realloc(buffer, size);
    if (moved != nullptr) static_cast<Memory*>(memory)->size = size;
    return moved;
  }
  static herr_t release(void* buffer, H5FD_file_image_op_t operation, void* memory) {
    if (operation == H5FD_FILE_IMAGE_OP_FILE_CLOSE) {
      static_cast<Memory*>(memory)->taken.reset(buffer);
    } else {
      std::free(buffer);
    }
    return 0;
  }
  static void* share(void* memory) { return memory; }
  static herr_t let_go(void*) { return 0; }
};

namespace {

constexpr std::size_t kImageGrowth = 4u << 20;  // [bytes] a stage is some 10 MB: few reallocations
constexpr const char* kImageName = "run file in memory";

/// The file format of HDF5 1.10 has checksums on all metadata: damage is noticed instead of followed.
Hdf5Handle make_access() {
  Hdf5Handle access = check_id(H5Pcreate(H5P_FILE_ACCESS), "cannot make file access", "fapl");
  check_status(H5Pset_libver_bounds(access.id(), H5F_LIBVER_V110, H5F_LIBVER_V110), "cannot set", "file format");
  return access;
}

Hdf5Handle make_image_access(H5FD_file_image_callbacks_t callbacks) {
  Hdf5Handle access = make_access();
  check_status(H5Pset_fapl_core(access.id(), kImageGrowth, false), "cannot use", "core driver");
  check_status(H5Pset_file_image_callbacks(access.id(), &callbacks), "cannot use", "image callbacks");
  return access;
}

/// The length of the file as its superblock has it (version 3: 8 bytes at 28, low byte first); the buffer is longer.
std::size_t find_file_size(std::span<const std::byte> buffer) {
  constexpr std::size_t kPlace = 28;
  std::size_t size = 0;
  if (buffer.size() < kPlace + 8) return buffer.size();
  for (std::size_t i = 8; i-- > 0;) size = (size << 8) | std::to_integer<std::size_t>(buffer[kPlace + i]);
  return std::min(size, buffer.size());
}

}  // namespace

Hdf5Image::Hdf5Image() : Hdf5Image(std::span<const std::byte>()) {}

Hdf5Image::Hdf5Image(std::span<const std::byte> bytes) : memory_(std::make_unique<Memory>()), file_(-1) {
  const Hdf5Handle access = make_image_access(
      {Memory::allocate, Memory::copy, Memory::resize, Memory::release, Memory::share, Memory::let_go, memory_.get()});
  if (bytes.empty()) {
    file_ = check_id(H5Fcreate(kImageName, H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), "cannot make", kImageName);
    return;
  }
  // the library copies the bytes; its interface only lacks the const
  void* start = const_cast<std::byte*>(bytes.data());
  check_status(H5Pset_file_image(access.id(), start, bytes.size()), "cannot load", kImageName);
  file_ = check_id(H5Fopen(kImageName, H5F_ACC_RDWR, access.id()), "cannot open", kImageName);
}

Hdf5Image::Hdf5Image(Hdf5Image&&) noexcept = default;
Hdf5Image::~Hdf5Image() = default;

void Hdf5Image::finish() {
  check_status(H5Fflush(file_.id(), H5F_SCOPE_GLOBAL), "cannot flush", kImageName);
  file_ = Hdf5Handle(-1);
  if (memory_->taken == nullptr) throw FileError(fmt::format("cannot close '{}'", kImageName));
  memory_->size = find_file_size(bytes());
}

std::span<const std::byte> Hdf5Image::bytes() const {
  return {static_cast<const std::byte*>(memory_->taken.get()), memory_->size};
}

Hdf5Handle open_file(const std::filesystem::path& file) {
  if (H5Fis_hdf5(file.c_str()) <= 0) throw FileError("it is not an HDF5 file");
  const Hdf5Handle access = make_access();
  // a finished file is only ever replaced, never changed, so no lock is needed (some network disks have none)
  check_status(H5Pset_file_locking(access.id(), false, true), "cannot set", "file locking");
  return check_id(H5Fopen(file.c_str(), H5F_ACC_RDONLY, access.id()), "cannot open", "/");
}

}  // namespace gudgeon
