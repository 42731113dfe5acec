// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// How datasets lie in the file, and what is asked of them before they are read.
#include "gudgeon/io/hdf5_dataset.h"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/hdf5_node.h"

namespace gudgeon {

namespace {

constexpr std::size_t kChunkRows = 16384;      // 128 KiB of doubles: well inside HDF5's chunk cache of 1 MiB
constexpr std::size_t kMostCompact = 1024;     // [bytes] that an object's header holds with no index to them
constexpr std::size_t kLongText = 32768;       // [bytes] HDF5 has no room for 64 KiB in a header
constexpr std::size_t kLeastDeflated = 4096;   // [bytes] a smaller chunk takes as long to begin as to deflate
constexpr unsigned kDeflateLevel = 1;          // after shuffle, higher levels cost much time and gain little
constexpr std::uint64_t kMostDeflated = 1032;  // how many times smaller deflate makes anything

/// Without rows, there may come any number.
Hdf5Handle make_row_space(hsize_t n_rows) {
  const hsize_t no_limit = H5S_UNLIMITED;
  return check_id(H5Screate_simple(1, &n_rows, n_rows == 0 ? &no_limit : nullptr), "cannot make", "rows");
}

Hdf5Handle make_creation() { return check_id(H5Pcreate(H5P_DATASET_CREATE), "cannot make", "dataset storage"); }

void set_chunks(const Hdf5Handle& storage, hsize_t chunk_rows, std::size_t row_size) {
  check_status(H5Pset_chunk(storage.id(), 1, &chunk_rows), "cannot set", "chunks");
  if (chunk_rows * row_size >= kLeastDeflated) {
    check_status(H5Pset_shuffle(storage.id()), "cannot set", "shuffle");
    check_status(H5Pset_deflate(storage.id(), kDeflateLevel), "cannot set", "deflate");
  }
  check_status(H5Pset_fletcher32(storage.id()), "cannot set", "checksums");
}

/// Short ones in the object's header, others in chunks; those without rows, too, because some tools stop at no storage.
Hdf5Handle make_storage(std::size_t n_rows, std::size_t row_size) {
  Hdf5Handle storage = make_creation();
  const std::size_t n_bytes = n_rows * row_size;
  if (n_rows > 0 && n_bytes <= kMostCompact) {
    check_status(H5Pset_layout(storage.id(), H5D_COMPACT), "cannot set", "layout");
  } else {
    const std::size_t most = std::max<std::size_t>(1, kChunkRows * sizeof(double) / row_size);
    set_chunks(storage, std::clamp<std::size_t>(n_rows, 1, most), row_size);
  }
  return storage;
}

Hdf5Handle make_dataset(const Hdf5Handle& parent, const std::string& name, Hdf5Id type, const Hdf5Handle& space,
                        const Hdf5Handle& storage) {
  check_name(name);
  return check_id(H5Dcreate2(parent.id(), name.c_str(), type, space.id(), H5P_DEFAULT, storage.id(), H5P_DEFAULT),
                  "cannot make dataset", name);
}

void write_values(const Hdf5Handle& dataset, const std::string& name, Hdf5Id type, const void* values) {
  check_status(H5Dwrite(dataset.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "cannot write dataset", name);
}

void read_values(const Hdf5Handle& dataset, const std::string& name, Hdf5Id type, void* values) {
  check_status(H5Dread(dataset.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "cannot read dataset", name);
}

Hdf5Handle write_single(const Hdf5Handle& parent, const std::string& name, Hdf5Id on_file, Hdf5Id in_memory,
                        const void* value) {
  const Hdf5Handle space = check_id(H5Screate(H5S_SCALAR), "cannot make a scalar for", name);
  Hdf5Handle dataset = make_dataset(parent, name, on_file, space, make_storage(1, 1));
  write_values(dataset, name, in_memory, value);
  return dataset;
}

Hdf5Handle write_rows(const Hdf5Handle& parent, const std::string& name, Hdf5Id on_file, Hdf5Id in_memory,
                      std::size_t n_rows, const void* values) {
  Hdf5Handle dataset =
      make_dataset(parent, name, on_file, make_row_space(n_rows), make_storage(n_rows, H5Tget_size(on_file)));
  if (n_rows > 0) write_values(dataset, name, in_memory, values);
  return dataset;
}

Hdf5Handle find_type(const Hdf5Handle& dataset, const std::string& name) {
  return check_id(H5Dget_type(dataset.id()), "cannot read the type of dataset", name);
}

/// FileError when it claims more than what lies in the file can be: nobody shall ask for that much memory.
void check_size(const Hdf5Handle& dataset, const std::string& name, std::uint64_t n_rows) {
  const std::uint64_t row_size = H5Tget_size(find_type(dataset, name).id());
  const std::uint64_t stored = H5Dget_storage_size(dataset.id());
  const Hdf5Handle file = check_id(H5Iget_file_id(dataset.id()), "cannot find the file of", name);
  hsize_t file_size = 0;
  check_status(H5Fget_filesize(file.id(), &file_size), "cannot measure the file of", name);
  const bool fits = stored <= file_size && row_size > 0 && n_rows <= stored * kMostDeflated / row_size;
  if (n_rows > 0 && !fits) throw FileError(fmt::format("dataset '{}' claims more values than the file holds", name));
}

/// A dataset of one value whose type is of one of the two classes.
Hdf5Handle open_single(const Hdf5Handle& parent, const std::string& name, H5T_class_t wanted, H5T_class_t also) {
  Hdf5Handle dataset = open_dataset(parent, name);
  const Hdf5Handle space = check_id(H5Dget_space(dataset.id()), "cannot measure dataset", name);
  const H5T_class_t found = H5Tget_class(find_type(dataset, name).id());
  const bool fits = H5Sget_simple_extent_npoints(space.id()) == 1 && (found == wanted || found == also);
  if (!fits) throw FileError(fmt::format("dataset '{}' has an unexpected type or size", name));
  check_size(dataset, name, 1);
  return dataset;
}

template <class Value>
std::vector<Value> read_rows(const Hdf5Handle& parent, const std::string& name, H5T_class_t wanted, Hdf5Id in_memory) {
  const Hdf5Handle dataset = open_dataset(parent, name);
  if (H5Tget_class(find_type(dataset, name).id()) != wanted) {
    throw FileError(fmt::format("dataset '{}' is not of numbers", name));
  }
  std::vector<Value> values(find_row_count(dataset, name));
  if (!values.empty()) read_values(dataset, name, in_memory, values.data());
  return values;
}

std::string take_text(const char* bytes, std::size_t size) { return {bytes, ::strnlen(bytes, size)}; }

}  // namespace

void write_unit(const Hdf5Handle& dataset, const std::string& unit, TextAttributes& attributes) {
  if (unit.empty()) return;
  attributes.write(dataset, "unit", unit);
  attributes.write(dataset, "units", unit);
}

void write_unit(const Hdf5Handle& dataset, const std::string& unit) {
  if (unit.empty()) return;
  TextAttributes attributes;
  write_unit(dataset, unit, attributes);
}

void write_real(const Hdf5Handle& parent, const std::string& name, double value, const std::string& unit) {
  write_unit(write_single(parent, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &value), unit);
}

void write_count(const Hdf5Handle& parent, const std::string& name, std::int64_t value) {
  write_single(parent, name, H5T_STD_I64LE, H5T_NATIVE_INT64, &value);
}

Hdf5Handle write_text(const Hdf5Handle& parent, const std::string& name, const std::string& text) {
  const Hdf5Handle type = make_text_type(text.size(), is_ascii(text));
  return text.size() > kLongText ? write_rows(parent, name, type.id(), type.id(), 1, text.c_str())
                                 : write_single(parent, name, type.id(), type.id(), text.c_str());
}

bool has_value(const Hdf5Handle& parent, const std::string& name) {
  return has_link(parent, name) || has_attribute(parent, name);
}

double read_real(const Hdf5Handle& parent, const std::string& name) {
  if (has_attribute(parent, name)) return read_real_attribute(parent, name);
  double value = 0.0;
  read_values(open_single(parent, name, H5T_FLOAT, H5T_INTEGER), name, H5T_NATIVE_DOUBLE, &value);
  return value;
}

std::int64_t read_count(const Hdf5Handle& parent, const std::string& name) {
  if (has_attribute(parent, name)) return read_count_attribute(parent, name);
  std::int64_t value = 0;
  read_values(open_single(parent, name, H5T_INTEGER, H5T_INTEGER), name, H5T_NATIVE_INT64, &value);
  return value;
}

std::string read_text(const Hdf5Handle& parent, const std::string& name) {
  if (has_attribute(parent, name)) return read_text_attribute(parent, name);
  const Hdf5Handle dataset = open_single(parent, name, H5T_STRING, H5T_STRING);
  const Hdf5Handle type = make_reading_type(find_type(dataset, name), fmt::format("dataset '{}'", name));
  std::string text(H5Tget_size(type.id()), '\0');
  read_values(dataset, name, type.id(), text.data());
  return take_text(text.data(), text.size());
}

Hdf5Handle write_series(const Hdf5Handle& parent, const std::string& name, std::span<const double> values) {
  return write_rows(parent, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, values.size(), values.data());
}

Hdf5Handle write_indices(const Hdf5Handle& parent, const std::string& name, std::span<const std::int32_t> values) {
  return write_rows(parent, name, H5T_STD_I32LE, H5T_NATIVE_INT32, values.size(), values.data());
}

Hdf5Handle write_lines(const Hdf5Handle& parent, const std::string& name, std::span<const std::string> texts) {
  std::string lines;
  for (const std::string& text : texts) {
    for (const char c : text) {
      if (c == '\\') lines += "\\\\";
      if (c == '\n') lines += "\\n";
      if (c != '\\' && c != '\n') lines += c;
    }
    lines += '\n';
  }
  return write_text(parent, name, lines);
}

std::vector<double> read_series(const Hdf5Handle& parent, const std::string& name) {
  return read_rows<double>(parent, name, H5T_FLOAT, H5T_NATIVE_DOUBLE);
}

std::vector<std::int32_t> read_indices(const Hdf5Handle& parent, const std::string& name) {
  return read_rows<std::int32_t>(parent, name, H5T_INTEGER, H5T_NATIVE_INT32);
}

std::vector<std::string> read_lines(const Hdf5Handle& parent, const std::string& name) {
  std::vector<std::string> texts;
  std::string text;
  bool is_escaped = false;
  for (const char c : read_text(parent, name)) {
    if (is_escaped) {
      text += c == 'n' ? '\n' : c;
    } else if (c == '\n') {
      texts.push_back(std::exchange(text, {}));
    } else if (c != '\\') {
      text += c;
    }
    is_escaped = c == '\\' && !is_escaped;
  }
  if (!text.empty()) throw FileError(fmt::format("the last line of dataset '{}' has no end", name));
  return texts;
}

SeriesMaker::SeriesMaker(Hdf5Handle space, Hdf5Handle storage, bool is_growing)
    : space_(std::move(space)), storage_(std::move(storage)), is_growing_(is_growing) {}

SeriesMaker::SeriesMaker(std::size_t n_rows)
    : SeriesMaker(make_row_space(n_rows), make_storage(n_rows, sizeof(double)), false) {}

SeriesMaker SeriesMaker::growing(std::size_t chunk_rows) {
  Hdf5Handle storage = make_creation();
  set_chunks(storage, std::clamp<std::size_t>(chunk_rows, 1, kChunkRows), sizeof(double));
  return {make_row_space(0), std::move(storage), true};
}

Hdf5Handle SeriesMaker::make(const Hdf5Handle& parent, const std::string& name, std::span<const double> values) const {
  Hdf5Handle dataset = make_dataset(parent, name, H5T_IEEE_F64LE, space_, storage_);
  if (!is_growing_ && !values.empty()) write_values(dataset, name, H5T_NATIVE_DOUBLE, values.data());
  return dataset;
}

void extend_series(const Hdf5Handle& parent, const std::string& name, std::span<const double> values) {
  if (values.empty()) return;
  const Hdf5Handle dataset = open_dataset(parent, name);
  const hsize_t n_before = find_row_count(dataset, name);
  const hsize_t n_added = values.size();
  const hsize_t n_after = n_before + n_added;
  check_status(H5Dset_extent(dataset.id(), &n_after), "cannot extend dataset", name);
  const Hdf5Handle rows = make_row_space(n_added);
  const Hdf5Handle space = check_id(H5Dget_space(dataset.id()), "cannot measure dataset", name);
  check_status(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, &n_before, nullptr, &n_added, nullptr),
               "cannot select rows of dataset", name);
  check_status(H5Dwrite(dataset.id(), H5T_NATIVE_DOUBLE, rows.id(), space.id(), H5P_DEFAULT, values.data()),
               "cannot write dataset", name);
}

void cut_series(const Hdf5Handle& parent, const std::string& name, std::size_t n_rows) {
  const Hdf5Handle dataset = open_dataset(parent, name);
  if (find_row_count(dataset, name) < n_rows) throw FileError(fmt::format("dataset '{}' has too few rows", name));
  const hsize_t size = n_rows;
  check_status(H5Dset_extent(dataset.id(), &size), "cannot cut dataset", name);
}

void make_scale(const Hdf5Handle& series, const std::string& name) {
  write_text_attribute(series, "CLASS", "DIMENSION_SCALE");
  write_text_attribute(series, "NAME", name);
}

// HDF5's own call also lists every series at the scale, which takes time by the square of their number and soon no room
// is left for the list. Nobody needs it.
ScaleReference::ScaleReference(const Hdf5Handle& parent, const std::string& scale)
    : type_(check_id(H5Tvlen_create(H5T_STD_REF_OBJ), "cannot make", "reference type")), space_(make_row_space(1)) {
  static_assert(sizeof(hobj_ref_t) == sizeof address_);
  check_status(H5Rcreate(&address_, parent.id(), scale.c_str(), H5R_OBJECT, -1), "cannot refer to", scale);
}

void ScaleReference::attach_to(const Hdf5Handle& series) const {
  std::uint64_t address = address_;
  const hvl_t list{1, &address};
  const Hdf5Handle attribute =
      check_id(H5Acreate2(series.id(), "DIMENSION_LIST", type_.id(), space_.id(), H5P_DEFAULT, H5P_DEFAULT),
               "cannot make attribute", "DIMENSION_LIST");
  check_status(H5Awrite(attribute.id(), type_.id(), &list), "cannot write attribute", "DIMENSION_LIST");
}

Hdf5Handle open_dataset(const Hdf5Handle& parent, const std::string& name) {
  require_link(parent, name, "dataset");
  Hdf5Handle dataset = check_id(H5Dopen2(parent.id(), name.c_str(), H5P_DEFAULT), "cannot open dataset", name);
  const Hdf5Handle creation = check_id(H5Dget_create_plist(dataset.id()), "cannot look at dataset", name);
  const bool is_own = H5Pget_layout(creation.id()) != H5D_VIRTUAL && H5Pget_external_count(creation.id()) == 0;
  if (!is_own) throw FileError(fmt::format("dataset '{}' keeps its values in another file", name));
  return dataset;
}

std::size_t find_row_count(const Hdf5Handle& dataset, const std::string& name) {
  const Hdf5Handle space = check_id(H5Dget_space(dataset.id()), "cannot measure dataset", name);
  hsize_t n_rows = 0;
  const bool one_dimensional = H5Sget_simple_extent_ndims(space.id()) == 1;
  if (!one_dimensional) throw FileError(fmt::format("dataset '{}' is not one-dimensional", name));
  check_status(H5Sget_simple_extent_dims(space.id(), &n_rows, nullptr), "cannot measure dataset", name);
  check_size(dataset, name, n_rows);
  return n_rows;
}

void check_values(const Hdf5Handle& dataset, const std::string& name) {
  const Hdf5Handle space = check_id(H5Dget_space(dataset.id()), "cannot measure dataset", name);
  const hssize_t n_values = H5Sget_simple_extent_npoints(space.id());
  if (n_values < 0) throw FileError(fmt::format("dataset '{}' has no size", name));
  check_size(dataset, name, static_cast<std::uint64_t>(n_values));
  const Hdf5Handle type = find_type(dataset, name);
  std::vector<std::byte> values(static_cast<std::size_t>(n_values) * H5Tget_size(type.id()));
  if (!values.empty()) read_values(dataset, name, type.id(), values.data());
}

}  // namespace gudgeon
