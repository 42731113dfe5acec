// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What is recorded of a load.
#pragma once

#include <span>

#include "gudgeon/model/load.h"
#include "gudgeon/system/load_tables.h"

namespace gudgeon {

/// A channel "LOAD.ending" and the number it shows.
struct LoadChannel {
  const char* ending;
  const char* symbol;
  const char* unit;
  const char* description;
  double (*find)(const LoadEffect& effect);
};

/// The channels of a load of that kind.
std::span<const LoadChannel> list_load_channels(const AnyLoad& kind);

}  // namespace gudgeon
