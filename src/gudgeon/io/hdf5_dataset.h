// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Datasets of a run file: single values, texts, series and columns. Under an Hdf5Session.
//
// Everything has a checksum: short ones lie in their object's header, which has one; others in chunks with one each.
// What is read is checked first for type, size and place: a foreign or damaged file gives a FileError that names the
// dataset.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "gudgeon/io/hdf5_handle.h"
#include "gudgeon/io/hdf5_node.h"

namespace gudgeon {

/// Single values; the unit becomes the attributes 'unit' and 'units', none when it is empty.
void write_real(const Hdf5Handle& parent, const std::string& name, double value, const std::string& unit);
void write_count(const Hdf5Handle& parent, const std::string& name, std::int64_t value);
/// A text: a single value, or one row when it is long.
Hdf5Handle write_text(const Hdf5Handle& parent, const std::string& name, const std::string& text);
/// The attributes 'unit' and 'units'; nothing when it is empty.
void write_unit(const Hdf5Handle& dataset, const std::string& unit);
void write_unit(const Hdf5Handle& dataset, const std::string& unit, TextAttributes& attributes);

/// Single values; of files of format 1 an attribute of the group.
[[nodiscard]] bool has_value(const Hdf5Handle& parent, const std::string& name);
double read_real(const Hdf5Handle& parent, const std::string& name);
std::int64_t read_count(const Hdf5Handle& parent, const std::string& name);
std::string read_text(const Hdf5Handle& parent, const std::string& name);

/// 1-D datasets; returned open for their attributes.
Hdf5Handle write_series(const Hdf5Handle& parent, const std::string& name, std::span<const double> values);
Hdf5Handle write_indices(const Hdf5Handle& parent, const std::string& name, std::span<const std::int32_t> values);
/// Texts as one, a line each: some tools stumble over arrays of texts of fixed length. Within a line "\\" and "\n"
/// stand for a backslash and the end of a line.
Hdf5Handle write_lines(const Hdf5Handle& parent, const std::string& name, std::span<const std::string> texts);
std::vector<double> read_series(const Hdf5Handle& parent, const std::string& name);
std::vector<std::int32_t> read_indices(const Hdf5Handle& parent, const std::string& name);
std::vector<std::string> read_lines(const Hdf5Handle& parent, const std::string& name);

/// Makes many series of one length, as they lie in the file thought out once.
class SeriesMaker {
 public:
  explicit SeriesMaker(std::size_t n_rows);
  /// Series that grow: empty, in chunks of so many rows. Writing each chunk in one piece is fastest.
  static SeriesMaker growing(std::size_t chunk_rows);

  /// Returned open for its attributes; of series that grow, the values are left to extend_series().
  [[nodiscard]] Hdf5Handle make(const Hdf5Handle& parent, const std::string& name,
                                std::span<const double> values) const;

 private:
  SeriesMaker(Hdf5Handle space, Hdf5Handle storage, bool is_growing);
  Hdf5Handle space_;
  Hdf5Handle storage_;
  bool is_growing_;
};

void extend_series(const Hdf5Handle& parent, const std::string& name, std::span<const double> values);
/// Forgets what comes after so many rows; FileError when there are fewer.
void cut_series(const Hdf5Handle& parent, const std::string& name, std::size_t n_rows);

/// Makes a series what others are over, as netCDF has it: a dimension scale.
void make_scale(const Hdf5Handle& series, const std::string& name);
/// Says of series that their rows are over that scale.
class ScaleReference {
 public:
  ScaleReference(const Hdf5Handle& parent, const std::string& scale);
  void attach_to(const Hdf5Handle& series) const;

 private:
  std::uint64_t address_ = 0;  // of the scale in its file
  Hdf5Handle type_;
  Hdf5Handle space_;
};

/// Of its own file, and neither virtual nor kept elsewhere.
Hdf5Handle open_dataset(const Hdf5Handle& parent, const std::string& name);
/// Rows of a 1-D dataset; FileError when it has another shape, or more than its file can hold.
std::size_t find_row_count(const Hdf5Handle& dataset, const std::string& name);
/// Reads every value, so that damage is found; FileError as ever.
void check_values(const Hdf5Handle& dataset, const std::string& name);

}  // namespace gudgeon
