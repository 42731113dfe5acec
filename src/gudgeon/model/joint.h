// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A joint between two bodies, of any type.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "gudgeon/model/joint/any.h"

namespace gudgeon {

/// One of the two ways to assemble the loop that a joint closes: to which side it folds, see docs/theory/kinematics.md.
enum class Branch { left, right };

inline constexpr std::array<std::pair<std::string_view, Branch>, 2> kBranches{{
    {"left", Branch::left},
    {"right", Branch::right},
}};
constexpr std::span<const std::pair<std::string_view, Branch>> choices(Branch /*kind*/) { return kBranches; }

struct Joint {
  std::string name;
  AnyJoint kind;
  std::optional<Branch> branch = std::nullopt;  ///< demanded of the start; else the start angles choose

  /// Besides those of its type.
  static constexpr auto kFields = std::tuple{
      field("branch", &Joint::branch,
            {.absent = "the start angles choose", .meaning = "the side to which the loop that it closes is assembled"}),
  };
};

}  // namespace gudgeon
