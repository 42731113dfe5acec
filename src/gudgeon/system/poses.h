// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Where all bodies are, from the coordinates of a tree.
#pragma once

#include <vector>

#include "gudgeon/system/assembly.h"
#include "gudgeon/system/coordinates.h"

namespace gudgeon {

/// Pose and motion of one body's origin.
BodyPose find_pose(const BodyNode& node, const Coordinates& coordinates);

/// Pose and motion of every body's origin, the frame's first.
std::vector<BodyPose> find_poses(const Mechanism& mechanism, const Topology& topology, const Coordinates& coordinates);

}  // namespace gudgeon
