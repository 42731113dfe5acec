// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The hash against the values that its authors publish.
#include "gudgeon/base/stable_hash.h"

#include <gtest/gtest.h>

namespace gudgeon {
namespace {

TEST(StableHash, HasThePublishedValues) {
  EXPECT_EQ(find_stable_hash(""), 0xcbf29ce484222325U);
  EXPECT_EQ(find_stable_hash("a"), 0xaf63dc4c8601ec8cU);
  EXPECT_EQ(find_stable_hash("foobar"), 0x85944171f73967e8U);
}

}  // namespace
}  // namespace gudgeon
