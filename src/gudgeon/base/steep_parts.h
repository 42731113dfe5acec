// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The parts of a formula that can make it narrow or steep.
#pragma once

#include <string>
#include <vector>

namespace gudgeon {

/// The arguments of functions that are neither waves nor pieced together, the bases of powers other than small whole
/// ones, and denominators: of "1e6*exp(-((t - 0.5)/w)^2)" they are "-((t - 0.5)/w)^2" and "w". A formula has narrow
/// peaks and steep flanks where one of them turns or passes zero, and only there. The text must be one that can be
/// understood.
std::vector<std::string> list_steep_parts(const std::string& text);

}  // namespace gudgeon
