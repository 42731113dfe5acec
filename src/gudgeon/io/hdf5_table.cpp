// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Compound types made from field tables. On file a row is packed and its texts lie in it, as wide as the longest.
#include "gudgeon/io/hdf5_table.h"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "gudgeon/base/diagnostics.h"

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

const char* find_text(const std::byte* row, const TableField& field) {
  const char* text = nullptr;
  std::memcpy(&text, row + field.offset, sizeof text);
  return text;
}

std::size_t find_width(const TableField& field, TableShape shape, const std::byte* rows, std::size_t n_rows) {
  if (field.kind == FieldKind::real) return sizeof(double);
  if (field.kind == FieldKind::index) return sizeof(std::int32_t);
  std::size_t width = 1;
  for (std::size_t i = 0; i < n_rows; ++i) {
    width = std::max(width, std::strlen(find_text(rows + i * shape.row_size, field)));
  }
  return width;
}

Hdf5Handle make_field_type(FieldKind kind, std::size_t width) {
  if (kind == FieldKind::text) return make_text_type(width);
  return check_id(H5Tcopy(kind == FieldKind::real ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT32), "cannot make", "field type");
}

Hdf5Handle make_row_type(TableShape shape, const Packing& packing) {
  Hdf5Handle type = check_id(H5Tcreate(H5T_COMPOUND, packing.row_size), "cannot make", "row type");
  for (std::size_t f = 0; f < shape.fields.size(); ++f) {
    const Hdf5Handle field = make_field_type(shape.fields[f].kind, packing.widths[f]);
    check_status(H5Tinsert(type.id(), shape.fields[f].name, packing.offsets[f], field.id()), "cannot add field",
                 shape.fields[f].name);
  }
  return type;
}

std::vector<std::byte> pack_rows(TableShape shape, const Packing& packing, const std::byte* rows, std::size_t n_rows) {
  std::vector<std::byte> packed(n_rows * packing.row_size);
  for (std::size_t i = 0; i < n_rows; ++i) {
    const std::byte* row = rows + i * shape.row_size;
    for (std::size_t f = 0; f < shape.fields.size(); ++f) {
      const TableField& field = shape.fields[f];
      std::byte* place = packed.data() + i * packing.row_size + packing.offsets[f];
      if (field.kind == FieldKind::text) {
        std::memcpy(place, find_text(row, field), std::strlen(find_text(row, field)));
      } else {
        std::memcpy(place, row + field.offset, packing.widths[f]);
      }
    }
  }
  return packed;
}

H5T_class_t find_class(FieldKind kind) {
  if (kind == FieldKind::text) return H5T_STRING;
  return kind == FieldKind::real ? H5T_FLOAT : H5T_INTEGER;
}

/// The packing to read a table with; a text gets one byte more for its NUL. HDF5 leaves memory of absent fields as it
/// is, so their presence and kind is checked here.
Packing find_packing(const Hdf5Handle& dataset, const std::string& name, TableShape shape) {
  const Hdf5Handle type = check_id(H5Dget_type(dataset.id()), "cannot read the type of table", name);
  if (H5Tget_class(type.id()) != H5T_COMPOUND) throw FileError(fmt::format("dataset '{}' is not a table", name));
  Packing packing;
  for (const TableField& field : shape.fields) {
    const int index = H5Tget_member_index(type.id(), field.name);
    if (index < 0) throw FileError(fmt::format("table '{}' lacks the column '{}'", name, field.name));
    const Hdf5Handle found =
        check_id(H5Tget_member_type(type.id(), static_cast<unsigned>(index)), "cannot read column", field.name);
    const bool loose_text = field.kind == FieldKind::text && H5Tis_variable_str(found.id()) != 0;
    if (H5Tget_class(found.id()) != find_class(field.kind) || loose_text) {
      throw FileError(fmt::format("column '{}' of table '{}' has an unexpected type", field.name, name));
    }
    packing.add(field.kind == FieldKind::text ? H5Tget_size(found.id()) + 1 : find_width(field, shape, nullptr, 0));
  }
  return packing;
}

// The columns of the shape but for those that this file may lack and does.
std::vector<TableField> find_present(const Hdf5Handle& dataset, const std::string& name, TableShape shape) {
  const Hdf5Handle type = check_id(H5Dget_type(dataset.id()), "cannot read the type of table", name);
  std::vector<TableField> present;
  for (const TableField& field : shape.fields) {
    if (field.may_lack && H5Tget_member_index(type.id(), field.name) < 0) continue;
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

void write_table(const Hdf5Handle& parent, const std::string& name, TableShape shape, const void* rows,
                 std::size_t n_rows) {
  const auto* bytes = static_cast<const std::byte*>(rows);
  Packing packing;
  for (const TableField& field : shape.fields) packing.add(find_width(field, shape, bytes, n_rows));
  const Hdf5Handle type = make_row_type(shape, packing);
  const hsize_t size = n_rows;
  const Hdf5Handle space = check_id(H5Screate_simple(1, &size, nullptr), "cannot make rows for", name);
  const Hdf5Handle storage = make_storage(n_rows);
  const Hdf5Handle dataset =
      check_id(H5Dcreate2(parent.id(), name.c_str(), type.id(), space.id(), H5P_DEFAULT, storage.id(), H5P_DEFAULT),
               "cannot make table", name);
  if (n_rows > 0) {
    const std::vector<std::byte> packed = pack_rows(shape, packing, bytes, n_rows);
    check_status(H5Dwrite(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, packed.data()), "cannot write table",
                 name);
  }
  for (const TableField& field : shape.fields) {
    if (*field.unit != '\0') write_text_attribute(dataset, std::string(field.name) + ".unit", field.unit);
  }
}

void read_table(const Hdf5Handle& parent, const std::string& name, TableShape shape,
                const std::function<void(const void* row)>& take) {
  const Hdf5Handle dataset = open_dataset(parent, name);
  const std::vector<TableField> present = find_present(dataset, name, shape);
  shape.fields = present;
  const Packing packing = find_packing(dataset, name, shape);
  const std::size_t n_rows = find_row_count(dataset, name);
  if (n_rows == 0) return;
  const Hdf5Handle type = make_row_type(shape, packing);
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
