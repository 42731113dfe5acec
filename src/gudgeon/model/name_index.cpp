// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Hash tables of names.
#include "gudgeon/model/name_index.h"

namespace gudgeon {

namespace {

// So many names are compared one by one.
constexpr std::size_t kFewPoints = 8;

template <class Named>
std::unordered_map<std::string_view, int> index_names(const std::vector<Named>& items) {
  std::unordered_map<std::string_view, int> indices;
  for (std::size_t i = 0; i < items.size(); ++i) indices.emplace(items[i].name, static_cast<int>(i));
  return indices;
}

}  // namespace

NameIndex::NameIndex(const Mechanism& mechanism)
    : mechanism_(&mechanism), bodies_(index_names(mechanism.bodies)), joints_(index_names(mechanism.joints)) {
  for (const Body& body : mechanism.bodies) {
    points_.push_back(body.points.size() > kFewPoints ? index_names(body.points) : Indices{});
  }
}

const Point* NameIndex::find_point(int body, std::string_view name) const {
  const Body& at = mechanism_->bodies[body];
  if (at.points.size() <= kFewPoints) return gudgeon::find_point(at, name);
  const int point = find(points_[static_cast<std::size_t>(body)], name);
  return point < 0 ? nullptr : &at.points[point];
}

}  // namespace gudgeon
