// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A virtual file driver of HDF5 over plain POSIX calls.
#include "gudgeon/io/hdf5_driver.h"

#include <hdf5.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <new>
#include <span>
#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif

namespace gudgeon {

namespace {

constexpr haddr_t kLastAddress = (haddr_t{1} << 62) - 1;  // what off_t can hold, and no more than HDF5's own driver has

/// What the access list carries; the library copies it byte by byte.
struct TargetInfo {
  Hdf5Target* target;
};

/// The library's part comes first: it knows the file by that address.
struct TargetFile {
  H5FD_t library{};
  Hdf5Target* target = nullptr;
  haddr_t end = 0;           // of the addresses given out
  haddr_t file_end = 0;      // of the bytes there are
  TargetInfo info{nullptr};  // as asked for again
};

TargetFile& find_file(H5FD_t* file) { return *reinterpret_cast<TargetFile*>(file); }
const TargetFile& find_file(const H5FD_t* file) { return *reinterpret_cast<const TargetFile*>(file); }

H5FD_t* open_target(const char*, unsigned, hid_t access, haddr_t) {
  const auto* info = static_cast<const TargetInfo*>(H5Pget_driver_info(access));
  struct stat status {};
  if (info == nullptr || ::fstat(info->target->descriptor, &status) != 0) return nullptr;
  auto* file = new (std::nothrow) TargetFile;
  if (file == nullptr) return nullptr;
  file->target = info->target;
  file->file_end = static_cast<haddr_t>(status.st_size);
  file->info = *info;
  return &file->library;
}

herr_t close_target(H5FD_t* at) {
  TargetFile& file = find_file(at);
  file.target->end = file.end;
  delete &file;
  return 0;
}

void* find_info(H5FD_t* file) {
  void* copy = std::malloc(sizeof(TargetInfo));  // the library frees it
  if (copy != nullptr) std::memcpy(copy, &find_file(file).info, sizeof(TargetInfo));
  return copy;
}

/// Small pieces are gathered before they are written, as in HDF5's own driver.
herr_t find_features(const H5FD_t*, unsigned long* flags) {
  *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
           H5FD_FEAT_AGGREGATE_SMALLDATA;
  return 0;
}

haddr_t find_end(const H5FD_t* file, H5FD_mem_t) { return find_file(file).end; }
haddr_t find_file_end(const H5FD_t* file, H5FD_mem_t) { return find_file(file).file_end; }
herr_t set_end(H5FD_t* file, H5FD_mem_t, haddr_t end) {
  find_file(file).end = end;
  return 0;
}

/// Reads what the file has; beyond its end there are zeros: addresses given out but not written yet.
bool read_from_disk(int descriptor, std::uint64_t address, std::span<std::byte> rest) {
  while (!rest.empty()) {
    const ssize_t count = ::pread(descriptor, rest.data(), rest.size(), static_cast<off_t>(address));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    if (count == 0) break;
    rest = rest.subspan(static_cast<std::size_t>(count));
    address += static_cast<std::uint64_t>(count);
  }
  std::ranges::fill(rest, std::byte{0});
  return true;
}

/// Calls use(page number, first byte in the page, bytes of the span that lie in it).
template <class Byte, class Use>
void for_each_page(std::uint64_t address, std::span<Byte> bytes, Use use) {
  while (!bytes.empty()) {
    const std::uint64_t within = address % Hdf5Target::kPageSize;
    const std::size_t size = std::min<std::size_t>(bytes.size(), Hdf5Target::kPageSize - within);
    use(address / Hdf5Target::kPageSize, within, bytes.first(size));
    bytes = bytes.subspan(size);
    address += size;
  }
}

herr_t read_bytes(H5FD_t* from, H5FD_mem_t, hid_t, haddr_t address, std::size_t size, void* buffer) {
  const Hdf5Target& target = *find_file(from).target;
  const std::span<std::byte> bytes(static_cast<std::byte*>(buffer), size);
  if (!read_from_disk(target.descriptor, address, bytes)) return -1;
  if (target.pages.empty()) return 0;
  for_each_page(address, bytes, [&](std::uint64_t number, std::uint64_t within, std::span<std::byte> part) {
    const auto page = target.pages.find(number);
    if (page != target.pages.end()) std::memcpy(part.data(), page->second.data() + within, part.size());
  });
  return 0;
}

/// Changes copies of the pages.
void write_to_pages(Hdf5Target& target, std::uint64_t address, std::span<const std::byte> bytes) {
  for_each_page(address, bytes, [&](std::uint64_t number, std::uint64_t within, std::span<const std::byte> part) {
    auto page = target.pages.find(number);
    if (page == target.pages.end()) {
      page = target.pages.emplace(number, Hdf5Target::Page{}).first;
      if (!read_from_disk(target.descriptor, number * Hdf5Target::kPageSize, page->second)) target.failure = errno;
    }
    std::memcpy(page->second.data() + within, part.data(), part.size());
  });
}

void write_to_disk(Hdf5Target& target, std::uint64_t address, std::span<const std::byte> rest) {
  while (!rest.empty() && target.failure == 0) {
    const ssize_t count = ::pwrite(target.descriptor, rest.data(), rest.size(), static_cast<off_t>(address));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      target.failure = errno;
      break;
    }
    rest = rest.subspan(static_cast<std::size_t>(count));
    address += static_cast<std::uint64_t>(count);
  }
}

herr_t write_bytes_at(H5FD_t* to, H5FD_mem_t, hid_t, haddr_t address, std::size_t size, const void* buffer) {
  TargetFile& file = find_file(to);
  Hdf5Target& target = *file.target;
  file.file_end = std::max(file.file_end, address + size);
  const std::span<const std::byte> bytes(static_cast<const std::byte*>(buffer), size);
  const std::size_t n_protected =
      address < target.protected_end ? std::min<std::size_t>(size, target.protected_end - address) : 0;
  try {
    write_to_pages(target, address, bytes.first(n_protected));
  } catch (const std::bad_alloc&) {
    target.failure = ENOMEM;
  }
  write_to_disk(target, address + n_protected, bytes.subspan(n_protected));
  // The rest of a page that is half protected is read from its copy.
  for_each_page(address + n_protected, bytes.subspan(n_protected),
                [&](std::uint64_t number, std::uint64_t within, std::span<const std::byte> part) {
                  const auto page = target.pages.find(number);
                  if (page != target.pages.end()) std::memcpy(page->second.data() + within, part.data(), part.size());
                });
  return 0;
}

/// Cuts off, or fills up, what stands behind the last address given out; what is protected is cut off by who commits.
herr_t cut_off(H5FD_t* at, hid_t, hbool_t) {
  TargetFile& file = find_file(at);
  Hdf5Target& target = *file.target;
  target.end = file.end;
  const std::uint64_t end = std::max<std::uint64_t>(file.end, target.protected_end);
  if (file.file_end == end || target.failure != 0) return 0;
  const bool done = ::ftruncate(target.descriptor, static_cast<off_t>(end)) == 0;
  if (!done && errno != EINVAL) target.failure = errno;  // EINVAL: a device that has no length
  file.file_end = end;
  return 0;
}

H5FD_class_t make_driver() {
  H5FD_class_t driver{};
#if H5_VERSION_GE(1, 13, 0)
  driver.version = H5FD_CLASS_VERSION;
  driver.value = static_cast<H5FD_class_value_t>(H5_VFD_RESERVED);
#endif
  driver.name = "gudgeon";
  driver.maxaddr = kLastAddress;
  driver.fc_degree = H5F_CLOSE_WEAK;
  driver.fapl_size = sizeof(TargetInfo);
  driver.fapl_get = find_info;
  driver.open = open_target;
  driver.close = close_target;
  driver.query = find_features;
  driver.get_eoa = find_end;
  driver.set_eoa = set_end;
  driver.get_eof = find_file_end;
  driver.read = read_bytes;
  driver.write = write_bytes_at;
  driver.truncate = cut_off;
  return driver;  // fl_map stays zero: all kinds of data share one space
}

}  // namespace

void use_target(const Hdf5Handle& access, Hdf5Target& target) {
  static const H5FD_class_t driver = make_driver();
  // Stays registered as long as the library lives: files may outlive the access list.
  static const hid_t id = H5FDregister(&driver);
  const TargetInfo info{&target};
  check_status(H5Pset_driver(access.id(), id, &info), "cannot use", "file driver");
}

}  // namespace gudgeon
