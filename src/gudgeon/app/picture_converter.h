// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// SVG to PNG and PDF by rsvg-convert, which does it well.
#pragma once

#include <filesystem>
#include <string>

namespace gudgeon {

/// Turns an SVG file into "png" or "pdf" beside it. FileError when the tool is missing or fails.
void convert_picture(const std::filesystem::path& svg, const std::filesystem::path& output, const std::string& format);

}  // namespace gudgeon
