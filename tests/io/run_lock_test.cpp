// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Locks that cannot be had, and why: the directory's permissions, or those of a lock file that another user left.
#include "gudgeon/io/run_lock.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <vector>

#include "gudgeon/base/diagnostics.h"
#include "tests/io/scratch_directory.h"

namespace gudgeon {
namespace {

using test::find_message;
using test::ScratchDirectory;
using testing::HasSubstr;

/// Root may write everywhere: while this lives it is another user.
class PlainUser {
 public:
  PlainUser() : before_(::geteuid()) { is_plain_ = before_ != 0 || ::seteuid(65534) == 0; }
  PlainUser(const PlainUser&) = delete;
  PlainUser& operator=(const PlainUser&) = delete;
  ~PlainUser() {
    if (before_ == 0 && ::seteuid(before_) != 0) ADD_FAILURE() << "root is not root again";
  }
  [[nodiscard]] bool is_plain() const { return is_plain_; }

 private:
  uid_t before_;
  bool is_plain_ = false;
};

std::string try_to_lock(const std::filesystem::path& directory) {
  const PlainUser user;
  EXPECT_TRUE(user.is_plain());
  const std::vector<std::filesystem::path> files{directory / "base.h5"};
  return find_message<FileError>([&] { const RunLock lock(directory, files); });
}

TEST(RunLock, NamesTheDirectoryThatTakesNoFile) {
  const ScratchDirectory scratch;
  ::chmod(scratch.path().c_str(), 0555);
  EXPECT_EQ(try_to_lock(scratch.path()), scratch.path().string() +
                                             ": no file can be made in this directory: Permission denied; give another "
                                             "one with -o, or change its permissions");
  ::chmod(scratch.path().c_str(), 0700);
}

TEST(RunLock, NamesTheLockFileOfAnotherUser) {
  const ScratchDirectory scratch;
  ::chmod(scratch.path().c_str(), 0777);
  test::write_text_file(scratch / ".gudgeon.lock", "");
  ::chmod((scratch / ".gudgeon.lock").c_str(), 0444);
  EXPECT_EQ(try_to_lock(scratch.path()),
            (scratch / ".gudgeon.lock").string() +
                ": the lock file is there and may not be written: Permission denied; remove it when no other user's "
                "run is under way in this directory, or give another directory with -o");
}

}  // namespace
}  // namespace gudgeon
