// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as a run file: they are read, or refused with a FileError.
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/run_reader.h"
#include "tests/fuzz/target.h"

/// HDF5 1.10 loses memory over damaged files; a build with the leak checker shall not stop at that.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5"; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gudgeon;
  const int descriptor = ::memfd_create("run", 0);
  fuzz::require(descriptor >= 0 && ::write(descriptor, data, size) == static_cast<ssize_t>(size), "a file of memory");
  const std::string path = fmt::format("/proc/self/fd/{}", descriptor);
  try {
    read_run_header(path);
    RunRecord outline = read_run_outline(path);
    read_channels(path, outline.stages, [](const StageRecord& stage) {
      std::vector<std::string> names;
      for (const Channel& channel : stage.channels) names.push_back(channel.name);
      return names;
    });
    read_run(path);
  } catch (const FileError& error) {
    fuzz::require(error.what()[0] != '\0', "an error says why");
  }
  ::close(descriptor);
  return 0;
}
