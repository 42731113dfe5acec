// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Groups, links, attributes.
#include "gudgeon/io/hdf5_node.h"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <new>
#include <utility>

#include "gudgeon/base/diagnostics.h"

namespace gudgeon {

namespace {

void write_attribute(const Hdf5Handle& node, const std::string& name, Hdf5Id type, const void* value) {
  const Hdf5Handle space = check_id(H5Screate(H5S_SCALAR), "cannot make a scalar for", name);
  const Hdf5Handle attribute = check_id(H5Acreate2(node.id(), name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT),
                                        "cannot make attribute", name);
  check_status(H5Awrite(attribute.id(), type, value), "cannot write attribute", name);
}

/// Opens an attribute of one element whose type is of one of the two classes.
Hdf5Handle open_attribute(const Hdf5Handle& node, const std::string& name, H5T_class_t wanted, H5T_class_t also) {
  if (!has_attribute(node, name)) throw FileError(fmt::format("attribute '{}' is missing", name));
  Hdf5Handle attribute = check_id(H5Aopen(node.id(), name.c_str(), H5P_DEFAULT), "cannot open attribute", name);
  const Hdf5Handle space = check_id(H5Aget_space(attribute.id()), "cannot measure attribute", name);
  const Hdf5Handle type = check_id(H5Aget_type(attribute.id()), "cannot read the type of attribute", name);
  const H5T_class_t found = H5Tget_class(type.id());
  const bool fits = H5Sget_simple_extent_npoints(space.id()) == 1 && (found == wanted || found == also);
  const bool loose_text = found == H5T_STRING && H5Tis_variable_str(type.id()) != 0;
  if (!fits || loose_text) throw FileError(fmt::format("attribute '{}' has an unexpected type or size", name));
  return attribute;
}

herr_t keep_name(hid_t, const char* name, const H5L_info_t*, void* names) {
  try {
    static_cast<std::vector<std::string>*>(names)->emplace_back(name);
    return 0;
  } catch (const std::bad_alloc&) {
    return -1;  // an exception may not go through the library
  }
}

}  // namespace

void check_name(const std::string& name) {
  const bool usable = !name.empty() && name != "." && name.find('/') == std::string::npos;
  if (!usable) throw FileError(fmt::format("'{}' cannot be a name in an HDF5 file", name));
}

Hdf5Handle open_root(const Hdf5Handle& file) {
  return check_id(H5Gopen2(file.id(), "/", H5P_DEFAULT), "cannot open group", "/");
}

Hdf5Handle make_group(const Hdf5Handle& parent, const std::string& name) {
  check_name(name);
  return check_id(H5Gcreate2(parent.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), "cannot make group",
                  name);
}

Hdf5Handle open_group(const Hdf5Handle& parent, const std::string& name) {
  if (!has_link(parent, name)) throw FileError(fmt::format("group '{}' is missing", name));
  return check_id(H5Gopen2(parent.id(), name.c_str(), H5P_DEFAULT), "cannot open group", name);
}

Hdf5Handle open_dataset(const Hdf5Handle& parent, const std::string& name) {
  if (!has_link(parent, name)) throw FileError(fmt::format("dataset '{}' is missing", name));
  return check_id(H5Dopen2(parent.id(), name.c_str(), H5P_DEFAULT), "cannot open dataset", name);
}

void make_soft_link(const Hdf5Handle& parent, const std::string& name, const std::string& target) {
  check_status(H5Lcreate_soft(target.c_str(), parent.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), "cannot make link",
               name);
}

void copy_group(const Hdf5Handle& from, const std::string& name, const Hdf5Handle& to) {
  check_status(H5Ocopy(from.id(), name.c_str(), to.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), "cannot copy group",
               name);
}

bool has_link(const Hdf5Handle& parent, const std::string& name) {
  return H5Lexists(parent.id(), name.c_str(), H5P_DEFAULT) > 0;
}

bool has_attribute(const Hdf5Handle& node, const std::string& name) { return H5Aexists(node.id(), name.c_str()) > 0; }

std::vector<std::string> find_children(const Hdf5Handle& group) {
  std::vector<std::string> names;
  check_status(H5Literate(group.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, keep_name, &names), "cannot list group", "");
  std::vector<std::pair<std::int64_t, std::string>> ordered;
  for (std::string& name : names) {
    const Hdf5Handle child = check_id(H5Oopen(group.id(), name.c_str(), H5P_DEFAULT), "cannot open", name);
    ordered.emplace_back(read_count_attribute(child, "order"), std::move(name));
  }
  std::ranges::sort(ordered);
  names.clear();
  for (auto& [order, name] : ordered) names.push_back(std::move(name));
  return names;
}

void write_text_attribute(const Hdf5Handle& node, const std::string& name, const std::string& text) {
  write_attribute(node, name, make_text_type(text.size()).id(), text.c_str());
}

void write_count_attribute(const Hdf5Handle& node, const std::string& name, std::int64_t count) {
  write_attribute(node, name, H5T_NATIVE_INT64, &count);
}

void write_real_attribute(const Hdf5Handle& node, const std::string& name, double value) {
  write_attribute(node, name, H5T_NATIVE_DOUBLE, &value);
}

std::string read_text_attribute(const Hdf5Handle& node, const std::string& name) {
  const Hdf5Handle attribute = open_attribute(node, name, H5T_STRING, H5T_STRING);
  const Hdf5Handle type = check_id(H5Aget_type(attribute.id()), "cannot read the type of attribute", name);
  std::string text(H5Tget_size(type.id()), '\0');
  check_status(H5Aread(attribute.id(), make_text_type(text.size()).id(), text.data()), "cannot read attribute", name);
  text.erase(text.find_last_not_of('\0') + 1);
  return text;
}

std::int64_t read_count_attribute(const Hdf5Handle& node, const std::string& name) {
  const Hdf5Handle attribute = open_attribute(node, name, H5T_INTEGER, H5T_INTEGER);
  std::int64_t count = 0;
  check_status(H5Aread(attribute.id(), H5T_NATIVE_INT64, &count), "cannot read attribute", name);
  return count;
}

double read_real_attribute(const Hdf5Handle& node, const std::string& name) {
  const Hdf5Handle attribute = open_attribute(node, name, H5T_FLOAT, H5T_INTEGER);
  double value = 0.0;
  check_status(H5Aread(attribute.id(), H5T_NATIVE_DOUBLE, &value), "cannot read attribute", name);
  return value;
}

}  // namespace gudgeon
