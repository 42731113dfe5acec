// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Tables as run files of format 1 have them: compound datasets. Under an Hdf5Session.
#pragma once

#include <functional>
#include <string>

#include "gudgeon/io/hdf5_table.h"

namespace gudgeon {

/// Hands over every row in order; its texts live only during the call.
void read_compound_table(const Hdf5Handle& parent, const std::string& name, TableShape shape,
                         const std::function<void(const void* row)>& take);

}  // namespace gudgeon
