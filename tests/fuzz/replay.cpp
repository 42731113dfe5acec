// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// replay [--mutations N] [--seed S] DIRECTORY...: gives a target every file of the directories, and N changed copies of
// each (100 by default), the same at every run. For compilers without libFuzzer, and as a test. An input that breaks
// the target is left beside the program as PROGRAM.broken.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/fuzz/mutation.h"
#include "tests/fuzz/target.h"
#ifdef GUDGEON_SANITIZE
#include <sanitizer/common_interface_defs.h>
#endif

namespace {

using gudgeon::fuzz::Bytes;
using gudgeon::fuzz::Numbers;

// What is being tried, for the moment when it breaks the target; plain data, as a signal handler may read them.
const std::uint8_t* tried_bytes = nullptr;
std::size_t tried_size = 0;
std::array<char, 4096> broken_path{};

void keep_broken_input() {
  const int file = ::open(broken_path.data(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file < 0) return;
  const bool kept = ::write(file, tried_bytes, tried_size) == static_cast<ssize_t>(tried_size);
  ::close(file);
  constexpr std::array texts{"replay: the input was not kept in ", "replay: the input is kept in "};
  for (const char* text : {texts[kept ? 1 : 0], static_cast<const char*>(broken_path.data()), "\n"}) {
    if (::write(STDERR_FILENO, text, std::strlen(text)) < 0) return;
  }
}

extern "C" void keep_and_end(int signal_number) {
  keep_broken_input();
  std::signal(signal_number, SIG_DFL);
  std::raise(signal_number);
}

void watch_for_breaks(const char* program) {
  std::snprintf(broken_path.data(), broken_path.size(), "%s.broken", program);
  std::remove(broken_path.data());
#ifdef GUDGEON_SANITIZE
  __sanitizer_set_death_callback(keep_broken_input);  // the sanitizers tell of the other signals themselves
  std::signal(SIGABRT, keep_and_end);
#else
  static std::array<char, 65536> stack;  // the target's own may be what overflowed
  stack_t alternative{};
  alternative.ss_sp = stack.data();
  alternative.ss_size = stack.size();
  ::sigaltstack(&alternative, nullptr);
  struct sigaction action {};
  action.sa_handler = keep_and_end;
  action.sa_flags = SA_ONSTACK;
  for (const int signal_number : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE}) ::sigaction(signal_number, &action, nullptr);
#endif
}

void run(const Bytes& bytes) {
  tried_bytes = bytes.data();
  tried_size = bytes.size();
  LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}

std::vector<Bytes> read_files(const char* directory) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory)) {
    if (entry.is_regular_file()) paths.push_back(entry.path());
  }
  std::ranges::sort(paths);
  std::vector<Bytes> files;
  for (const std::filesystem::path& path : paths) {
    std::ifstream stream(path, std::ios::binary);
    files.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
  return files;
}

bool read_number(const char* text, std::uint64_t& number) {
  const char* end = text + std::strlen(text);
  return std::from_chars(text, end, number).ptr == end && text != end;
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t n_mutations = 100;
  std::uint64_t seed = 1;
  std::vector<Bytes> files;
  for (int k = 1; k < argc; ++k) {
    const std::string argument = argv[k];
    if (argument == "--mutations" || argument == "--seed") {
      if (k + 1 == argc || !read_number(argv[++k], argument == "--seed" ? seed : n_mutations)) {
        std::fprintf(stderr, "replay: %s takes a whole number\n", argument.c_str());
        return 2;
      }
      continue;
    }
    for (Bytes& file : read_files(argv[k])) files.push_back(std::move(file));
  }
  watch_for_breaks(argv[0]);
  Numbers numbers(seed);
  std::size_t n_inputs = 0;
  for (const Bytes& file : files) {
    run(file);
    for (std::uint64_t k = 0; k < n_mutations; ++k) run(mutate(file, files[numbers.next(files.size())], numbers));
    n_inputs += 1 + n_mutations;
  }
  std::printf("%zu inputs from %zu files\n", n_inputs, files.size());
  return files.empty() ? 1 : 0;
}
