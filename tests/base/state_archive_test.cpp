// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What goes in comes out, and nothing else does.
#include "gudgeon/base/state_archive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "gudgeon/base/diagnostics.h"

namespace gudgeon {
namespace {

struct Plain {
  int number = 0;
  double value = 0.0;
};

class Nested {
 public:
  explicit Nested(std::size_t n) : values_(n), rows_(2, std::vector<double>(n)) {}
  void fill() {
    values_.assign(values_.size(), 0.1);
    rows_[1].assign(rows_[1].size(), -0.0);
    pairs_[1] = {7, std::numeric_limits<double>::infinity()};
    chosen_ = 3;
    events_ = {{1, 2.0}, {3, 4.0}};
  }
  void transfer(StateArchive& archive) {
    archive(values_, rows_, pairs_, chosen_);
    archive.list(events_);
  }
  [[nodiscard]] bool is_filled() const {
    return values_.back() == 0.1 && std::signbit(rows_[1][0]) && pairs_[1].number == 7 && std::isinf(pairs_[1].value) &&
           chosen_ == 3U && events_.size() == 2 && events_[1].value == 4.0;
  }

 private:
  std::vector<double> values_;
  std::vector<std::vector<double>> rows_;
  std::array<Plain, 2> pairs_;
  std::optional<std::size_t> chosen_;
  std::vector<Plain> events_;
};

std::string save(Nested& nested) {
  return StateArchive::pack([&](StateArchive& archive) { archive(nested); });
}

TEST(StateArchive, GivesBackWhatWasSaved) {
  Nested first(3);
  first.fill();
  const std::string bytes = save(first);
  Nested second(3);
  StateArchive archive(bytes);
  EXPECT_TRUE(archive.is_loading());
  archive(second);
  EXPECT_NO_THROW(archive.expect_end());
  EXPECT_TRUE(second.is_filled());
}

TEST(StateArchive, RefusesAnotherLengthAndWhatIsLeftOver) {
  Nested first(3);
  const std::string bytes = save(first);
  Nested shorter(2);
  StateArchive archive(bytes);
  EXPECT_THROW(archive(shorter), FileError);
  StateArchive unread(bytes);
  EXPECT_THROW(unread.expect_end(), FileError);
}

TEST(StateArchive, RefusesEveryFlippedBitAndEveryCut) {
  Nested nested(3);
  nested.fill();
  const std::string bytes = save(nested);
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::string flipped = bytes;
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << at % 8));
    EXPECT_THROW(StateArchive{flipped}, FileError) << at;
    EXPECT_THROW(StateArchive{std::string_view(bytes).substr(0, at)}, FileError) << at;
  }
}

TEST(StateArchive, RefusesALengthThatTheBytesCannotHold) {
  std::size_t n = std::numeric_limits<std::size_t>::max() / 4;
  const std::string bytes = StateArchive::pack([&](StateArchive& archive) { archive(n); });
  StateArchive archive(bytes);
  std::vector<double> values;
  EXPECT_THROW(archive.list(values), FileError);
}

TEST(StateArchive, RequiresWhatMustBeTheSame) {
  const std::string bytes = StateArchive::pack([](StateArchive& archive) {
    archive.require(2.5);
    archive.require_text("no_wear");
  });
  StateArchive same(bytes);
  EXPECT_NO_THROW(same.require(2.5));
  EXPECT_THROW(same.require_text("no_Wear"), FileError);
  StateArchive other(bytes);
  EXPECT_THROW(other.require(2.6), FileError);
}

}  // namespace
}  // namespace gudgeon
