// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Tables: groups of columns of the same length, from and to rows of a plain struct that a table of its fields
// describes. Under an Hdf5Session.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>

#include "gudgeon/io/hdf5_handle.h"

namespace gudgeon {

/// What a field of a row is in memory.
enum class FieldKind {
  real,   ///< double
  index,  ///< std::int32_t
  text,   ///< const char*, ended by NUL
};

/// One column.
struct TableField {
  const char* name;
  const char* unit;
  FieldKind kind;
  std::size_t offset;     ///< [bytes] of the member in the row
  bool may_lack = false;  ///< files of before it was there are read with zero
};

/// The shape of a row in memory, and its columns in the file.
struct TableShape {
  std::span<const TableField> fields;
  std::size_t row_size;  ///< [bytes]
};

void write_table(const Hdf5Handle& parent, const std::string& name, TableShape shape, const void* rows,
                 std::size_t n_rows);

/// Hands over every row in order; its texts live only during the call. Reads tables of format 1, too.
void read_table(const Hdf5Handle& parent, const std::string& name, TableShape shape,
                const std::function<void(const void* row)>& take);

}  // namespace gudgeon
