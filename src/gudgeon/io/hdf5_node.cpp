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

Hdf5Handle make_scalar_space() { return check_id(H5Screate(H5S_SCALAR), "cannot make", "scalar"); }

void write_attribute(const Hdf5Handle& node, const std::string& name, Hdf5Id type, const Hdf5Handle& space,
                     const void* value) {
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

H5L_type_t find_link_type(const Hdf5Handle& parent, const std::string& name) {
  H5L_info_t link{};
  check_status(H5Lget_info(parent.id(), name.c_str(), &link, H5P_DEFAULT), "cannot look at", name);
  return link.type;
}

bool keeps_order(const Hdf5Handle& group) {
  const Hdf5Handle creation = check_id(H5Gget_create_plist(group.id()), "cannot look at group", "");
  unsigned order = 0;
  check_status(H5Pget_link_creation_order(creation.id(), &order), "cannot look at the order of group", "");
  return (order & H5P_CRT_ORDER_TRACKED) != 0;
}

struct FoundLink {
  std::string name;
  H5L_type_t type;
};

herr_t keep_link(hid_t, const char* name, const H5L_info_t* link, void* links) {
  try {
    static_cast<std::vector<FoundLink>*>(links)->push_back({name, link->type});
    return 0;
  } catch (const std::bad_alloc&) {
    return -1;  // an exception may not go through the library
  }
}

[[noreturn]] void refuse_link(std::string_view what, const std::string& name) {
  throw FileError(fmt::format("{} '{}' is a link to elsewhere where a run file has its own", what, name));
}

}  // namespace

void check_name(const std::string& name) {
  const bool usable = !name.empty() && name != "." && name.find('/') == std::string::npos;
  if (!usable) throw FileError(fmt::format("'{}' cannot be a name in an HDF5 file", name));
}

Hdf5Handle open_root(const Hdf5Handle& file) {
  return check_id(H5Gopen2(file.id(), "/", H5P_DEFAULT), "cannot open group", "/");
}

void keep_order(const Hdf5Handle& creation) {
  constexpr unsigned kMostCompactLinks = 65535;  // all that HDF5 allows
  check_status(H5Pset_link_creation_order(creation.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED),
               "cannot keep order of", "links");
  check_status(H5Pset_link_phase_change(creation.id(), kMostCompactLinks, 0), "cannot keep compact", "links");
}

Hdf5Handle make_group(const Hdf5Handle& parent, const std::string& name, unsigned n_members, unsigned name_size) {
  check_name(name);
  const Hdf5Handle creation = check_id(H5Pcreate(H5P_GROUP_CREATE), "cannot make", "group creation");
  keep_order(creation);
  if (n_members > 0) {
    check_status(H5Pset_est_link_info(creation.id(), n_members, name_size), "cannot make room in group", name);
  }
  return check_id(H5Gcreate2(parent.id(), name.c_str(), H5P_DEFAULT, creation.id(), H5P_DEFAULT), "cannot make group",
                  name);
}

Hdf5Handle open_group(const Hdf5Handle& parent, const std::string& name) {
  require_link(parent, name, "group");
  return check_id(H5Gopen2(parent.id(), name.c_str(), H5P_DEFAULT), "cannot open group", name);
}

void require_link(const Hdf5Handle& parent, const std::string& name, std::string_view what) {
  if (!has_link(parent, name)) throw FileError(fmt::format("{} '{}' is missing", what, name));
  if (find_link_type(parent, name) != H5L_TYPE_HARD) refuse_link(what, name);
}

bool is_group(const Hdf5Handle& parent, const std::string& name) {
  const Hdf5Handle node = check_id(H5Oopen(parent.id(), name.c_str(), H5P_DEFAULT), "cannot open", name);
  return H5Iget_type(node.id()) == H5I_GROUP;
}

void make_soft_link(const Hdf5Handle& parent, const std::string& name, const std::string& target) {
  check_status(H5Lcreate_soft(target.c_str(), parent.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), "cannot make link",
               name);
}

void make_hard_link(const Hdf5Handle& parent, const std::string& name, const Hdf5Handle& other) {
  check_status(H5Lcreate_hard(parent.id(), name.c_str(), other.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
               "cannot make link", name);
}

void remove_link(const Hdf5Handle& parent, const std::string& name) {
  check_status(H5Ldelete(parent.id(), name.c_str(), H5P_DEFAULT), "cannot remove", name);
}

bool has_link(const Hdf5Handle& parent, const std::string& name) {
  return H5Lexists(parent.id(), name.c_str(), H5P_DEFAULT) > 0;
}

std::uint64_t find_address(const Hdf5Handle& parent, const std::string& name) {
  H5O_info_t info{};
  check_status(H5Oget_info_by_name(parent.id(), name.c_str(), &info, H5P_DEFAULT), "cannot look at", name);
  return info.addr;
}

bool has_attribute(const Hdf5Handle& node, const std::string& name) { return H5Aexists(node.id(), name.c_str()) > 0; }

std::vector<std::string> find_members(const Hdf5Handle& group) {
  // HDF5 finds a link by going through all before it: what the listing tells of each is not asked again.
  std::vector<FoundLink> links;
  const H5_index_t index = keeps_order(group) ? H5_INDEX_CRT_ORDER : H5_INDEX_NAME;
  check_status(H5Literate(group.id(), index, H5_ITER_INC, nullptr, keep_link, &links), "cannot list group", "");
  std::vector<std::string> names;
  for (FoundLink& link : links) {
    if (link.type == H5L_TYPE_SOFT) continue;
    if (link.type != H5L_TYPE_HARD) refuse_link("member", link.name);
    names.push_back(std::move(link.name));
  }
  return names;
}

std::vector<std::string> find_children(const Hdf5Handle& group) {
  std::vector<std::string> names = find_members(group);
  if (keeps_order(group)) return names;
  std::vector<std::pair<std::int64_t, std::string>> ordered;
  for (std::string& name : names) {
    const Hdf5Handle child = check_id(H5Oopen(group.id(), name.c_str(), H5P_DEFAULT), "cannot open", name);
    ordered.emplace_back(read_count_attribute(child, "order"), std::move(name));
  }
  std::ranges::sort(ordered);
  names.clear();
  for (auto& [place, name] : ordered) names.push_back(std::move(name));
  return names;
}

TextAttributes::TextAttributes() : space_(make_scalar_space()) {}

void TextAttributes::write(const Hdf5Handle& node, const std::string& name, const std::string& text) {
  const std::pair<std::size_t, bool> key(text.size(), is_ascii(text));
  auto type = types_.find(key);
  if (type == types_.end()) type = types_.emplace(key, make_text_type(key.first, key.second)).first;
  write_attribute(node, name, type->second.id(), space_, text.c_str());
}

void write_text_attribute(const Hdf5Handle& node, const std::string& name, const std::string& text) {
  TextAttributes().write(node, name, text);
}

void write_count_attribute(const Hdf5Handle& node, const std::string& name, std::int64_t count) {
  write_attribute(node, name, H5T_NATIVE_INT64, make_scalar_space(), &count);
}

std::string read_text_attribute(const Hdf5Handle& node, const std::string& name) {
  const Hdf5Handle attribute = open_attribute(node, name, H5T_STRING, H5T_STRING);
  const Hdf5Handle type = check_id(H5Aget_type(attribute.id()), "cannot read the type of attribute", name);
  const Hdf5Handle wanted = make_reading_type(type, fmt::format("attribute '{}'", name));
  std::string text(H5Tget_size(type.id()), '\0');
  check_status(H5Aread(attribute.id(), wanted.id(), text.data()), "cannot read attribute", name);
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

bool is_ascii(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 128; });
}

Hdf5Handle make_text_type(std::size_t size, bool is_ascii) {
  Hdf5Handle type = check_id(H5Tcopy(H5T_C_S1), "cannot make", "text type");
  check_status(H5Tset_size(type.id(), size + 1), "cannot size", "text type");
  check_status(H5Tset_strpad(type.id(), H5T_STR_NULLTERM), "cannot pad", "text type");
  check_status(H5Tset_cset(type.id(), is_ascii ? H5T_CSET_ASCII : H5T_CSET_UTF8), "cannot encode", "text type");
  return type;
}

Hdf5Handle make_reading_type(const Hdf5Handle& on_file, const std::string& what) {
  if (H5Tget_class(on_file.id()) != H5T_STRING || H5Tis_variable_str(on_file.id()) != 0) {
    throw FileError(fmt::format("{} has an unexpected type or size", what));
  }
  Hdf5Handle type = check_id(H5Tcopy(on_file.id()), "cannot make", "text type");
  check_status(H5Tset_strpad(type.id(), H5T_STR_NULLPAD), "cannot pad", "text type");
  return type;
}

}  // namespace gudgeon
