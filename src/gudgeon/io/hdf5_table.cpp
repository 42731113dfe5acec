// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rows to columns and back.
#include "gudgeon/io/hdf5_table.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <optional>
#include <variant>
#include <vector>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/hdf5_compound.h"
#include "gudgeon/io/hdf5_dataset.h"
#include "gudgeon/io/hdf5_node.h"

namespace gudgeon {

namespace {

template <class Value>
Value take_member(const std::byte* row, const TableField& field) {
  Value value{};
  std::memcpy(&value, row + field.offset, sizeof value);
  return value;
}

template <class Cell, class Member>
std::vector<Cell> gather(const TableField& field, std::size_t row_size, const std::byte* rows, std::size_t n_rows) {
  std::vector<Cell> cells;
  cells.reserve(n_rows);
  for (std::size_t i = 0; i < n_rows; ++i) cells.emplace_back(take_member<Member>(rows + i * row_size, field));
  return cells;
}

Hdf5Handle write_column(const Hdf5Handle& table, const TableField& field, std::size_t row_size, const std::byte* rows,
                        std::size_t n_rows) {
  switch (field.kind) {
    case FieldKind::real:
      return write_series(table, field.name, gather<double, double>(field, row_size, rows, n_rows));
    case FieldKind::index:
      return write_indices(table, field.name, gather<std::int32_t, std::int32_t>(field, row_size, rows, n_rows));
    default:
      return write_lines(table, field.name, gather<std::string, const char*>(field, row_size, rows, n_rows));
  }
}

/// A column as it was read.
struct Column {
  const TableField* field;
  std::variant<std::vector<double>, std::vector<std::int32_t>, std::vector<std::string>> cells;

  [[nodiscard]] std::size_t size() const {
    return std::visit([](const auto& values) { return values.size(); }, cells);
  }
  void put_into(std::byte* row, std::size_t i) const {
    if (const auto* texts = std::get_if<std::vector<std::string>>(&cells)) {
      const char* text = (*texts)[i].c_str();
      std::memcpy(row + field->offset, &text, sizeof text);
    } else if (const auto* reals = std::get_if<std::vector<double>>(&cells)) {
      std::memcpy(row + field->offset, &(*reals)[i], sizeof(double));
    } else {
      std::memcpy(row + field->offset, &std::get<std::vector<std::int32_t>>(cells)[i], sizeof(std::int32_t));
    }
  }
};

Column read_column(const Hdf5Handle& table, const TableField& field) {
  switch (field.kind) {
    case FieldKind::real:
      return {&field, read_series(table, field.name)};
    case FieldKind::index:
      return {&field, read_indices(table, field.name)};
    default:
      return {&field, read_lines(table, field.name)};
  }
}

std::vector<Column> read_columns(const Hdf5Handle& table, const std::string& name, TableShape shape) {
  std::vector<Column> columns;
  for (const TableField& field : shape.fields) {
    if (!has_link(table, field.name)) {
      if (field.may_lack) continue;
      throw FileError(fmt::format("table '{}' lacks the column '{}'", name, field.name));
    }
    columns.push_back(read_column(table, field));
    if (columns.back().size() != columns.front().size()) {
      throw FileError(fmt::format("column '{}' of table '{}' has {} rows where '{}' has {}", field.name, name,
                                  columns.back().size(), columns.front().field->name, columns.front().size()));
    }
  }
  return columns;
}

}  // namespace

void write_table(const Hdf5Handle& parent, const std::string& name, TableShape shape, const void* rows,
                 std::size_t n_rows) {
  const auto n_fields = static_cast<unsigned>(shape.fields.size());
  const Hdf5Handle table = make_group(parent, name, n_fields, 12);
  for (const TableField& field : shape.fields) {
    write_unit(write_column(table, field, shape.row_size, static_cast<const std::byte*>(rows), n_rows), field.unit);
  }
}

void read_table(const Hdf5Handle& parent, const std::string& name, TableShape shape,
                const std::function<void(const void* row)>& take) {
  require_link(parent, name, "table");
  if (!is_group(parent, name)) return read_compound_table(parent, name, shape, take);
  const std::vector<Column> columns = read_columns(open_group(parent, name), name, shape);
  const std::size_t n_rows = columns.empty() ? 0 : columns.front().size();
  std::vector<std::max_align_t> row(shape.row_size / sizeof(std::max_align_t) + 1);
  auto* bytes = reinterpret_cast<std::byte*>(row.data());
  for (std::size_t i = 0; i < n_rows; ++i) {
    for (const Column& column : columns) column.put_into(bytes, i);
    take(bytes);
  }
}

}  // namespace gudgeon
