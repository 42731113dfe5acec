// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Names of cases and figures as those of files.
#pragma once

#include <string>

namespace gudgeon {

/// Whatever could mean something to a shell or a file system becomes '_'; of a name that is too long for a file's, its
/// beginning and a number that tells it from others with the same beginning.
std::string make_file_name(std::string name);

}  // namespace gudgeon
