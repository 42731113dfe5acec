// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Script and style of the page, bundled from web/ when the program is built.
#pragma once

#include <string_view>

namespace gudgeon {

std::string_view page_script();
std::string_view page_style();

}  // namespace gudgeon
