// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Tells which bodies joints make one.
#pragma once

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/model/mechanism.h"

namespace gudgeon {

/// A remark for each pair of revolute joints that makes two bodies one rigid body. Clearance joints count as they are.
Diagnostics remark_pinned_bodies(const Mechanism& mechanism);

}  // namespace gudgeon
