// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The tables of keys are sound.
#include "gudgeon/model/model_keys.h"

#include <gtest/gtest.h>

#include <set>

namespace gudgeon {
namespace {

void check_keys(const std::vector<KeyEntry>& keys, const std::string& where) {
  std::set<std::string> seen;
  for (const KeyEntry& entry : keys) {
    SCOPED_TRACE(where + entry.key);
    EXPECT_TRUE(seen.insert(entry.key).second) << "stands there twice";
    EXPECT_FALSE(entry.meaning.empty());
    EXPECT_EQ(entry.required, entry.default_text.empty()) << "what is not required has a default";
    EXPECT_TRUE(!entry.default_number || entry.range.contains(*entry.default_number));
    EXPECT_EQ(entry.kind == ValueKind::choice, !entry.choices.empty());
    EXPECT_EQ(entry.kind == ValueKind::name,
              !entry.of.empty() && entry.kind != ValueKind::law && entry.kind != ValueKind::body_pair);
    check_keys(entry.keys, where + entry.key + ".");
  }
}

TEST(ModelKeys, AreSound) {
  std::set<std::string> tables;
  for (const KeyTable& table : list_model_keys()) {
    const std::string name = table.section + "." + (table.type.empty() ? table.meaning : table.type);
    EXPECT_TRUE(tables.insert(name).second) << name << " stands there twice";
    EXPECT_FALSE(table.keys.empty()) << name;
    check_keys(table.keys, name + ".");
  }
  for (const char* one : {"joints.revolute", "joints.prismatic_clearance", "loads.bushing"}) {
    EXPECT_TRUE(tables.contains(one)) << one;
  }
}

TEST(ModelKeys, SayWhatTheDeclarationsSay) {
  for (const KeyTable& table : list_model_keys()) {
    if (table.type != "prismatic_clearance") continue;
    ASSERT_EQ(table.keys.front().key, "bearing");
    EXPECT_EQ(table.keys.front().kind, ValueKind::point);
    const KeyEntry& clearance = table.keys[8];
    EXPECT_EQ(clearance.key, "clearance");
    EXPECT_EQ(clearance.kind, ValueKind::quantity);
    EXPECT_EQ(clearance.dimension, dimension::kLength);
    EXPECT_FALSE(clearance.range.contains(0.0));
    EXPECT_TRUE(clearance.required);
    const KeyEntry& angle = table.keys[3];
    EXPECT_EQ(angle.key, "relative_angle");
    EXPECT_FALSE(angle.required);
    EXPECT_EQ(angle.default_text, "0 rad");
    return;
  }
  FAIL() << "there is no prismatic_clearance";
}

}  // namespace
}  // namespace gudgeon
