// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Any lines "path=value" set in a sound model.
#include <string>
#include <vector>

#include "gudgeon/io/model_reader.h"
#include "tests/fuzz/target.h"
#include "tests/io/pendulum_model.h"

namespace {

constexpr const char* kMore = R"([loads.push]
point = "bar.tip"
force = ["k*t", "1 N"]
constants = { k = 2 }
[study]
cycle_time = 1
[cases.heavy]
set = { "bodies.bar.mass" = "2 kg" }
)";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gudgeon;
  static const ModelDocument document("m.toml", test::make_pendulum_model(kMore));
  std::vector<Override> overrides;
  std::string_view rest = fuzz::make_text(data, size);
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    const std::size_t equals = line.find('=');
    if (equals != std::string_view::npos) {
      overrides.push_back({std::string(line.substr(0, equals)), std::string(line.substr(equals + 1))});
    }
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  for (const char* name : {"", "heavy"}) {
    const ModelFile model = document.read(name, overrides);
    const std::string told = render(model.diagnostics, model.source);
    for (const unsigned char c : told) fuzz::require(c >= 0x20 || c == '\n' || c == '\t', "messages hold no controls");
  }
  return 0;
}
