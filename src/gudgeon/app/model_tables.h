// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What `gudgeon check` says about a model's joints, loads and drivers, as text.
#pragma once

#include <string>

#include "gudgeon/model/mechanism.h"

namespace gudgeon {

/// Every joint with its type, its two points and its play.
std::string render_joints(const Mechanism& mechanism, bool color);
/// Gravity, or that there is none, and every load with its type and what it acts on.
std::string render_loads(const Mechanism& mechanism, bool color);
/// What moves it; nothing without drivers.
std::string render_drivers(const Mechanism& mechanism, bool color);

}  // namespace gudgeon
