// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Any text as a quantity: its value is finite, and its SI unit reads back.
#include <cmath>

#include "gudgeon/base/quantity.h"
#include "tests/fuzz/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gudgeon;
  const auto parsed = parse_quantity(fuzz::make_text(data, size));
  if (const auto* error = std::get_if<QuantityError>(&parsed)) {
    fuzz::require(!error->message.empty(), "an error says why");
    return 0;
  }
  const auto& quantity = std::get<Quantity>(parsed);
  fuzz::require(std::isfinite(quantity.value), "a value is finite");
  fuzz::require(!dimension_name(quantity.dimension).empty(), "a dimension has a name");
  return 0;
}
