// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Any text as a model file: what is wrong is told; what is right reads back from its own explanation.
#include <string>

#include "gudgeon/io/model_reader.h"
#include "gudgeon/io/resolved_model.h"
#include "tests/fuzz/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gudgeon;
  const ModelDocument document("m.toml", std::string(fuzz::make_text(data, size)));
  const ModelFile model = document.read({}, {});
  const std::string told = render(model.diagnostics, model.source);
  for (const unsigned char c : told) fuzz::require(c >= 0x20 || c == '\n' || c == '\t', "messages hold no controls");
  for (const Case& one : document.cases()) {
    const ModelFile in_case = document.read(one.name, {});
    render(in_case.diagnostics, in_case.source);
  }
  if (model.diagnostics.has_errors()) return 0;
  const ModelFile again = read_model_text("resolved.toml", write_resolved_model(model.mechanism, model.study));
  if (again.diagnostics.has_errors()) std::fputs(render(again.diagnostics, again.source).c_str(), stderr);
  fuzz::require(!again.diagnostics.has_errors(), "an explanation reads back");
  return 0;
}
