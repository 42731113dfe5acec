// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Groups, attributes and datasets of an HDF5 file in the few shapes a run file has. Under an Hdf5Session.
// Everything read is checked for type and size first: a foreign file gives a FileError.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gudgeon/io/hdf5_handle.h"

namespace gudgeon {

/// FileError for a name HDF5 would read as a path ('/') or as the group itself ('.').
void check_name(const std::string& name);

/// The root group of an open file.
Hdf5Handle open_root(const Hdf5Handle& file);
Hdf5Handle make_group(const Hdf5Handle& parent, const std::string& name);
Hdf5Handle open_group(const Hdf5Handle& parent, const std::string& name);
Hdf5Handle open_dataset(const Hdf5Handle& parent, const std::string& name);
void make_soft_link(const Hdf5Handle& parent, const std::string& name, const std::string& target);
[[nodiscard]] bool has_link(const Hdf5Handle& parent, const std::string& name);
[[nodiscard]] bool has_attribute(const Hdf5Handle& node, const std::string& name);
/// Names of everything in a group, sorted by each child's attribute 'order'.
std::vector<std::string> find_children(const Hdf5Handle& group);

void write_text_attribute(const Hdf5Handle& node, const std::string& name, const std::string& text);
void write_count_attribute(const Hdf5Handle& node, const std::string& name, std::int64_t count);
void write_real_attribute(const Hdf5Handle& node, const std::string& name, double value);
std::string read_text_attribute(const Hdf5Handle& node, const std::string& name);
std::int64_t read_count_attribute(const Hdf5Handle& node, const std::string& name);
double read_real_attribute(const Hdf5Handle& node, const std::string& name);

/// A text as scalar dataset, UTF-8.
void write_text(const Hdf5Handle& parent, const std::string& name, const std::string& text);
std::string read_text(const Hdf5Handle& parent, const std::string& name);

/// A 1-D dataset of doubles, chunked and compressed without loss; returned open for its attributes.
Hdf5Handle write_series(const Hdf5Handle& parent, const std::string& name, std::span<const double> values);
/// The same, but growing: empty, in chunks of so many rows. Writing each chunk in one piece is fastest.
Hdf5Handle make_growing_series(const Hdf5Handle& parent, const std::string& name, std::size_t chunk_rows);
/// Adds to a growing series.
void extend_series(const Hdf5Handle& parent, const std::string& name, std::span<const double> values);
std::vector<double> read_series(const Hdf5Handle& parent, const std::string& name);

/// Copies a group with all that is in it from another file.
void copy_group(const Hdf5Handle& from, const std::string& name, const Hdf5Handle& to);

/// Creation properties of a 1-D dataset of so many rows: chunks, shuffle and deflate where they pay.
Hdf5Handle make_storage(std::size_t n_rows);
/// Rows of a 1-D dataset; FileError when it has another shape.
std::size_t find_row_count(const Hdf5Handle& dataset, const std::string& name);
/// The type of a UTF-8 text of that many bytes, filled up with NUL. Texts of variable length would lie in HDF5's
/// global heap, which has no checksum: a damaged one crashes the library.
Hdf5Handle make_text_type(std::size_t size);

}  // namespace gudgeon
