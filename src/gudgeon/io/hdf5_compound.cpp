// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Compound types made from field tables: only the wanted columns of a row are read, packed one behind the other.
#include "gudgeon/io/hdf5_compound.h"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/hdf5_dataset.h"
#include "gudgeon/io/hdf5_node.h"

namespace gudgeon {

namespace {

/// Where the fields of a packed row are.
struct Packing {
  std::vector<std::size_t> widths;   ///< [bytes] of each field
  std::vector<std::size_t> offsets;  ///< [bytes] of each field
  std::size_t row_size = 0;          ///< [bytes]

  void add(std::size_t width) {
    widths.push_back(width);
    offsets.push_back(row_size);
    row_size += width;
  }
};

H5T_class_t find_class(FieldKind kind) {
  if (kind == FieldKind::text) return H5T_STRING;
  return kind == FieldKind::real ? H5T_FLOAT : H5T_INTEGER;
}

/// The type of a field in memory; a text gets one byte more, so that it ends with NUL. HDF5 leaves memory of absent
/// fields as it is, so their presence and kind is checked here.
Hdf5Handle make_field_type(const Hdf5Handle& row, const std::string& name, const TableField& field) {
  const int index = H5Tget_member_index(row.id(), field.name);
  if (index < 0) throw FileError(fmt::format("table '{}' lacks the column '{}'", name, field.name));
  const Hdf5Handle found =
      check_id(H5Tget_member_type(row.id(), static_cast<unsigned>(index)), "cannot read column", field.name);
  const bool is_loose = field.kind == FieldKind::text && H5Tis_variable_str(found.id()) != 0;
  if (H5Tget_class(found.id()) != find_class(field.kind) || is_loose) {
    throw FileError(fmt::format("column '{}' of table '{}' has an unexpected type", field.name, name));
  }
  if (field.kind != FieldKind::text) {
    return check_id(H5Tcopy(field.kind == FieldKind::real ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT32), "cannot make",
                    "field type");
  }
  Hdf5Handle type = make_reading_type(found, fmt::format("column '{}'", field.name));
  check_status(H5Tset_size(type.id(), H5Tget_size(found.id()) + 1), "cannot size", "text type");
  return type;
}

Hdf5Handle make_row_type(const std::vector<Hdf5Handle>& types, TableShape shape, const Packing& packing) {
  Hdf5Handle type = check_id(H5Tcreate(H5T_COMPOUND, packing.row_size), "cannot make", "row type");
  for (std::size_t f = 0; f < shape.fields.size(); ++f) {
    check_status(H5Tinsert(type.id(), shape.fields[f].name, packing.offsets[f], types[f].id()), "cannot add field",
                 shape.fields[f].name);
  }
  return type;
}

/// The columns of the shape but for those that this file may lack and does.
std::vector<TableField> find_present(const Hdf5Handle& row, TableShape shape) {
  std::vector<TableField> present;
  for (const TableField& field : shape.fields) {
    if (field.may_lack && H5Tget_member_index(row.id(), field.name) < 0) continue;
    present.push_back(field);
  }
  return present;
}

void unpack_row(TableShape shape, const Packing& packing, const std::byte* packed, std::byte* row) {
  for (std::size_t f = 0; f < shape.fields.size(); ++f) {
    const TableField& field = shape.fields[f];
    const std::byte* place = packed + packing.offsets[f];
    if (field.kind == FieldKind::text) {
      std::memcpy(row + field.offset, &place, sizeof place);
    } else {
      std::memcpy(row + field.offset, place, packing.widths[f]);
    }
  }
}

}  // namespace

void read_compound_table(const Hdf5Handle& parent, const std::string& name, TableShape shape,
                         const std::function<void(const void* row)>& take) {
  const Hdf5Handle dataset = open_dataset(parent, name);
  const Hdf5Handle on_file = check_id(H5Dget_type(dataset.id()), "cannot read the type of table", name);
  if (H5Tget_class(on_file.id()) != H5T_COMPOUND) throw FileError(fmt::format("dataset '{}' is not a table", name));
  const std::vector<TableField> present = find_present(on_file, shape);
  shape.fields = present;
  Packing packing;
  std::vector<Hdf5Handle> types;
  for (const TableField& field : present) {
    types.push_back(make_field_type(on_file, name, field));
    packing.add(H5Tget_size(types.back().id()));
  }
  const std::size_t n_rows = find_row_count(dataset, name);
  if (n_rows == 0) return;
  const Hdf5Handle type = make_row_type(types, shape, packing);
  std::vector<std::byte> packed(n_rows * packing.row_size);
  check_status(H5Dread(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, packed.data()), "cannot read table",
               name);
  std::vector<std::max_align_t> row(shape.row_size / sizeof(std::max_align_t) + 1);
  auto* row_bytes = reinterpret_cast<std::byte*>(row.data());
  for (std::size_t i = 0; i < n_rows; ++i) {
    unpack_row(shape, packing, packed.data() + i * packing.row_size, row_bytes);
    take(row_bytes);
  }
}

}  // namespace gudgeon
