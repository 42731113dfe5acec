// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Depths of cells told no finer than a length.
#pragma once

#include <vector>

namespace gudgeon {

/// Replaces each value by the mean over a width about it, given in cells, three times: in effect by its mean under a
/// smooth bell of three times that width, whose variance is width²/4. Values are those of equal cells around a
/// circle, or along a line, whose ends mirror. The sum stays, values >= 0 stay so, and zeros farther away than 3/2 of
/// the width (and one cell a time) stay zeros. Widths up to one cell change nothing; more than a third of all
/// counts as that.
void smooth_by_moving_means(std::vector<double>& values, double width, bool is_round);

}  // namespace gudgeon
