// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// replay DIRECTORY...: gives a target every file of the directories, and of each some that are cut off or changed, the
// same at every run. For compilers without libFuzzer, and as a test.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "tests/fuzz/target.h"

namespace {

using Bytes = std::vector<std::uint8_t>;

/// A generator of numbers after Knuth: the same on every machine.
class Numbers {
 public:
  std::size_t next(std::size_t below) {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::size_t>(state_ >> 33U) % below;
  }

 private:
  std::uint64_t state_ = 1;
};

void run(const Bytes& bytes) { LLVMFuzzerTestOneInput(bytes.data(), bytes.size()); }

int run_variants(const Bytes& bytes) {
  constexpr int kVariants = 100;
  run(bytes);
  if (bytes.empty()) return 1;
  Numbers numbers;
  for (int k = 0; k < kVariants; ++k) {
    Bytes changed = bytes;
    const std::size_t at = numbers.next(bytes.size());
    if (k % 4 == 0) {
      changed.resize(at);
    } else if (k % 4 == 1) {  // a piece twice
      const std::size_t length = std::min<std::size_t>(numbers.next(64), bytes.size() - at);
      changed.insert(changed.begin() + static_cast<std::ptrdiff_t>(at), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                     bytes.begin() + static_cast<std::ptrdiff_t>(at + length));
    } else {
      changed[at] = static_cast<std::uint8_t>(k % 4 == 2 ? changed[at] ^ (1U << numbers.next(8)) : numbers.next(256));
    }
    run(changed);
  }
  return kVariants + 1;
}

}  // namespace

int main(int argc, char** argv) {
  int n_files = 0;
  int n_inputs = 0;
  for (int k = 1; k < argc; ++k) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(argv[k])) {
      if (entry.is_regular_file()) files.push_back(entry.path());
    }
    std::ranges::sort(files);
    for (const std::filesystem::path& file : files) {
      std::ifstream stream(file, std::ios::binary);
      n_inputs += run_variants(Bytes(std::istreambuf_iterator<char>(stream), {}));
      ++n_files;
    }
  }
  std::printf("%d inputs from %d files\n", n_inputs, n_files);
  return n_files > 0 ? 0 : 1;
}
