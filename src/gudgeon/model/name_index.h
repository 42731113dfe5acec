// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Bodies, points and joints by name, for whoever looks up more than a few.
#pragma once

#include <string_view>
#include <unordered_map>
#include <vector>

#include "gudgeon/model/mechanism.h"

namespace gudgeon {

/// Look-ups in constant time. Keeps references to the mechanism. Of several with the same name it knows the first.
class NameIndex {
 public:
  explicit NameIndex(const Mechanism& mechanism);

  /// -1 when there is none.
  [[nodiscard]] int find_body(std::string_view name) const { return find(bodies_, name); }
  /// -1 when there is none.
  [[nodiscard]] int find_joint(std::string_view name) const { return find(joints_, name); }
  /// nullptr when the body has none.
  [[nodiscard]] const Point* find_point(int body, std::string_view name) const;

 private:
  using Indices = std::unordered_map<std::string_view, int>;

  [[nodiscard]] static int find(const Indices& indices, std::string_view name) {
    const auto found = indices.find(name);
    return found == indices.end() ? -1 : found->second;
  }

  const Mechanism* mechanism_;
  Indices bodies_;
  Indices joints_;
  std::vector<Indices> points_;  // one a body; empty for few points
};

}  // namespace gudgeon
