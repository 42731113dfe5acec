// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Datasets: texts and series of doubles.
#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/hdf5_node.h"

namespace gudgeon {

namespace {

constexpr std::size_t kChunkRows = 16384;    // 128 KiB of doubles: well inside HDF5's chunk cache of 1 MiB
constexpr std::size_t kRowsToCompress = 64;  // below this the chunk index is larger than what compression saves
constexpr unsigned kDeflateLevel = 1;        // after shuffle, higher levels cost much time and gain little

Hdf5Id make_dataset(const Hdf5Handle& parent, const std::string& name, Hdf5Id type, const Hdf5Handle& space,
                    const Hdf5Handle& storage) {
  return H5Dcreate2(parent.id(), name.c_str(), type, space.id(), H5P_DEFAULT, storage.id(), H5P_DEFAULT);
}

void compress(const Hdf5Handle& storage, hsize_t chunk_rows) {
  check_status(H5Pset_chunk(storage.id(), 1, &chunk_rows), "cannot set", "chunks");
  check_status(H5Pset_shuffle(storage.id()), "cannot set", "shuffle");
  check_status(H5Pset_deflate(storage.id(), kDeflateLevel), "cannot set", "deflate");
}

}  // namespace

Hdf5Handle make_text_type(std::size_t size) {
  Hdf5Handle type = check_id(H5Tcopy(H5T_C_S1), "cannot make", "text type");
  check_status(H5Tset_size(type.id(), std::max<std::size_t>(size, 1)), "cannot size", "text type");
  check_status(H5Tset_strpad(type.id(), H5T_STR_NULLPAD), "cannot pad", "text type");
  check_status(H5Tset_cset(type.id(), H5T_CSET_UTF8), "cannot encode", "text type");
  return type;
}

Hdf5Handle make_storage(std::size_t n_rows) {
  Hdf5Handle storage = check_id(H5Pcreate(H5P_DATASET_CREATE), "cannot make", "dataset storage");
  if (n_rows >= kRowsToCompress) compress(storage, std::min(n_rows, kChunkRows));
  return storage;
}

std::size_t find_row_count(const Hdf5Handle& dataset, const std::string& name) {
  const Hdf5Handle space = check_id(H5Dget_space(dataset.id()), "cannot measure dataset", name);
  hsize_t n_rows = 0;
  const bool one_dimensional = H5Sget_simple_extent_ndims(space.id()) == 1;
  if (!one_dimensional) throw FileError(fmt::format("dataset '{}' is not one-dimensional", name));
  check_status(H5Sget_simple_extent_dims(space.id(), &n_rows, nullptr), "cannot measure dataset", name);
  return n_rows;
}

void write_text(const Hdf5Handle& parent, const std::string& name, const std::string& text) {
  const Hdf5Handle type = make_text_type(text.size());
  const Hdf5Handle space = check_id(H5Screate(H5S_SCALAR), "cannot make a scalar for", name);
  const Hdf5Handle storage = make_storage(1);
  const Hdf5Handle dataset =
      check_id(make_dataset(parent, name, type.id(), space, storage), "cannot make dataset", name);
  check_status(H5Dwrite(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()), "cannot write dataset",
               name);
}

std::string read_text(const Hdf5Handle& parent, const std::string& name) {
  const Hdf5Handle dataset = open_dataset(parent, name);
  const Hdf5Handle type = check_id(H5Dget_type(dataset.id()), "cannot read the type of dataset", name);
  const Hdf5Handle space = check_id(H5Dget_space(dataset.id()), "cannot measure dataset", name);
  const bool fits = H5Tget_class(type.id()) == H5T_STRING && H5Tis_variable_str(type.id()) == 0 &&
                    H5Sget_simple_extent_npoints(space.id()) == 1;
  if (!fits) throw FileError(fmt::format("dataset '{}' is not a text", name));
  std::string text(H5Tget_size(type.id()), '\0');
  check_status(H5Dread(dataset.id(), make_text_type(text.size()).id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()),
               "cannot read dataset", name);
  text.erase(text.find_last_not_of('\0') + 1);
  return text;
}

Hdf5Handle write_series(const Hdf5Handle& parent, const std::string& name, std::span<const double> values) {
  const hsize_t n_rows = values.size();
  const Hdf5Handle space = check_id(H5Screate_simple(1, &n_rows, nullptr), "cannot make a series for", name);
  const Hdf5Handle storage = make_storage(values.size());
  check_name(name);
  Hdf5Handle dataset =
      check_id(make_dataset(parent, name, H5T_IEEE_F64LE, space, storage), "cannot make dataset", name);
  if (values.empty()) return dataset;
  check_status(H5Dwrite(dataset.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
               "cannot write dataset", name);
  return dataset;
}

Hdf5Handle make_growing_series(const Hdf5Handle& parent, const std::string& name, std::size_t chunk_rows) {
  const hsize_t n_rows = 0;
  const hsize_t no_limit = H5S_UNLIMITED;
  const Hdf5Handle space = check_id(H5Screate_simple(1, &n_rows, &no_limit), "cannot make a series for", name);
  const Hdf5Handle storage = check_id(H5Pcreate(H5P_DATASET_CREATE), "cannot make", "dataset storage");
  compress(storage, std::min(chunk_rows, kChunkRows));
  check_name(name);
  return check_id(make_dataset(parent, name, H5T_IEEE_F64LE, space, storage), "cannot make dataset", name);
}

void extend_series(const Hdf5Handle& parent, const std::string& name, std::span<const double> values) {
  if (values.empty()) return;
  const Hdf5Handle dataset = open_dataset(parent, name);
  const hsize_t n_before = find_row_count(dataset, name);
  const hsize_t n_added = values.size();
  const hsize_t n_after = n_before + n_added;
  check_status(H5Dset_extent(dataset.id(), &n_after), "cannot extend dataset", name);
  const Hdf5Handle rows = check_id(H5Screate_simple(1, &n_added, nullptr), "cannot make rows for", name);
  const Hdf5Handle space = check_id(H5Dget_space(dataset.id()), "cannot measure dataset", name);
  check_status(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, &n_before, nullptr, &n_added, nullptr),
               "cannot select rows of dataset", name);
  check_status(H5Dwrite(dataset.id(), H5T_NATIVE_DOUBLE, rows.id(), space.id(), H5P_DEFAULT, values.data()),
               "cannot write dataset", name);
}

std::vector<double> read_series(const Hdf5Handle& parent, const std::string& name) {
  const Hdf5Handle dataset = open_dataset(parent, name);
  const Hdf5Handle type = check_id(H5Dget_type(dataset.id()), "cannot read the type of dataset", name);
  if (H5Tget_class(type.id()) != H5T_FLOAT) throw FileError(fmt::format("dataset '{}' is not of numbers", name));
  std::vector<double> values(find_row_count(dataset, name));
  if (values.empty()) return values;
  check_status(H5Dread(dataset.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
               "cannot read dataset", name);
  return values;
}

}  // namespace gudgeon
