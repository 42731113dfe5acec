// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The program as a child process.
#include "tests/app/program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace gudgeon::test {
namespace {

/// Only what may be called between fork and exec.
[[noreturn]] void become_program(const char* folder, const char* out, const char* err, char* const* arguments) {
  const int out_file = ::open(out, O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0666);
  const int err_file = ::open(err, O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0666);
  if (out_file < 0 || err_file < 0 || ::chdir(folder) != 0) ::_exit(126);
  ::dup2(out_file, STDOUT_FILENO);
  ::dup2(err_file, STDERR_FILENO);
  ::execv(GUDGEON_PROGRAM, arguments);
  ::_exit(127);
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "gudgeon_test_XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path TemporaryFolder::write(std::string_view name, std::string_view text) const {
  const std::filesystem::path file = path_ / name;
  std::ofstream(file) << text;
  return file;
}

RunningProgram::RunningProgram(const TemporaryFolder& folder, const std::vector<std::string>& arguments,
                               const std::filesystem::path& out, const std::filesystem::path& err)
    : out_(out.empty() ? folder.path() / "stdout.txt" : out), err_(err.empty() ? folder.path() / "stderr.txt" : err) {
  std::vector<std::string> words = {GUDGEON_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  process_ = ::fork();
  if (process_ == 0) become_program(folder.path().c_str(), out_.c_str(), err_.c_str(), pointers.data());
  if (process_ < 0) throw std::runtime_error("the program cannot be started");
}

void RunningProgram::send(int signal) const { ::kill(process_, signal); }

double RunningProgram::find_peak_memory() const {
  const std::string status = read_text("/proc/" + std::to_string(process_) + "/status");
  const std::size_t at = status.find("VmHWM:");
  return at == std::string::npos ? 0.0 : 1024.0 * std::stod(status.substr(at + 6));
}

bool RunningProgram::has_ended() const {
  siginfo_t state{};
  return ::waitid(P_PID, static_cast<id_t>(process_), &state, WEXITED | WNOHANG | WNOWAIT) == 0 && state.si_pid != 0;
}

Outcome RunningProgram::wait() {
  int status = 0;
  ::waitpid(process_, &status, 0);
  Outcome outcome;
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.out = std::filesystem::is_regular_file(out_) ? read_text(out_) : std::string{};
  outcome.err = read_text(err_);
  return outcome;
}

Outcome run_program(const TemporaryFolder& folder, const std::vector<std::string>& arguments) {
  return RunningProgram(folder, arguments).wait();
}

Outcome run_in_shell(const TemporaryFolder& folder, const std::string& script) {
  const std::string command = "cd '" + folder.path().string() + "' && GUDGEON='" GUDGEON_PROGRAM "' && { " + script +
                              "\n} >stdout.txt 2>stderr.txt";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_text(folder.path() / "stdout.txt"),
          read_text(folder.path() / "stderr.txt")};
}

std::string find_slider_crank() { return GUDGEON_SOURCE_DIR "/tests/app/slider_crank.toml"; }

std::string find_case(std::string_view name) {
  return std::string(GUDGEON_SOURCE_DIR "/tests/cases/").append(name) + ".toml";
}

std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace gudgeon::test
