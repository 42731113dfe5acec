// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Groups, links and attributes of an HDF5 file in the few shapes a run file has. Under an Hdf5Session.
// Everything read is checked for type and size first: a foreign file gives a FileError.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gudgeon/io/hdf5_handle.h"

namespace gudgeon {

/// FileError for a name HDF5 would read as a path ('/') or as the group itself ('.').
void check_name(const std::string& name);

/// Has a group keep the order its members come in, and its links in its own header, which has a checksum: HDF5 1.10
/// crashes over damaged files whose links lie elsewhere. Creation properties of a group or file.
void keep_order(const Hdf5Handle& creation);

/// The root group of an open file.
Hdf5Handle open_root(const Hdf5Handle& file);
/// With room for so many members whose names have up to that many bytes, where more are to come later.
Hdf5Handle make_group(const Hdf5Handle& parent, const std::string& name, unsigned n_members = 0,
                      unsigned name_size = 0);
/// FileError when it is missing, or lies in another file.
Hdf5Handle open_group(const Hdf5Handle& parent, const std::string& name);
void make_soft_link(const Hdf5Handle& parent, const std::string& name, const std::string& target);
/// A second name of a member, in another group.
void make_hard_link(const Hdf5Handle& parent, const std::string& name, const Hdf5Handle& other);
void remove_link(const Hdf5Handle& parent, const std::string& name);
[[nodiscard]] bool has_link(const Hdf5Handle& parent, const std::string& name);
/// FileError "<what> 'name' is missing", or what leads out of the file.
void require_link(const Hdf5Handle& parent, const std::string& name, std::string_view what);
[[nodiscard]] bool is_group(const Hdf5Handle& parent, const std::string& name);
/// Where the member lies in its file: the same for two names of one thing.
[[nodiscard]] std::uint64_t find_address(const Hdf5Handle& parent, const std::string& name);
[[nodiscard]] bool has_attribute(const Hdf5Handle& node, const std::string& name);
/// Names of everything in a group, in the order it was made where the group keeps that. Links to members of other
/// groups are left out; FileError when anything in it leads out of the file.
std::vector<std::string> find_members(const Hdf5Handle& group);
/// The same, in files of format 1 sorted by each child's attribute 'order'.
std::vector<std::string> find_children(const Hdf5Handle& group);

/// Writes many short texts: the types of their lengths are made once.
class TextAttributes {
 public:
  TextAttributes();
  void write(const Hdf5Handle& node, const std::string& name, const std::string& text);

 private:
  Hdf5Handle space_;
  std::map<std::pair<std::size_t, bool>, Hdf5Handle> types_;  // by size and whether it is ASCII
};

void write_text_attribute(const Hdf5Handle& node, const std::string& name, const std::string& text);
void write_count_attribute(const Hdf5Handle& node, const std::string& name, std::int64_t count);
std::string read_text_attribute(const Hdf5Handle& node, const std::string& name);
std::int64_t read_count_attribute(const Hdf5Handle& node, const std::string& name);
double read_real_attribute(const Hdf5Handle& node, const std::string& name);

/// The type of a text of that many bytes and a NUL behind it, which some readers go on to. Texts of variable length
/// would lie in HDF5's global heap, which has no checksum.
Hdf5Handle make_text_type(std::size_t size, bool is_ascii);
[[nodiscard]] bool is_ascii(std::string_view text);
/// The type that a text of that type, on file, is read into, whatever its character set; FileError "what has an
/// unexpected type or size" when it is no text of fixed length.
Hdf5Handle make_reading_type(const Hdf5Handle& on_file, const std::string& what);

}  // namespace gudgeon
