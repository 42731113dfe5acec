// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Bytes as text.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace gudgeon {

/// RFC 4648, with padding.
std::string encode_base64(std::span<const std::uint8_t> bytes);

}  // namespace gudgeon
