// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What is recorded and what formulas may use: no recorded name is unknown to the check of a model.
#include "gudgeon/sim/channel_table.h"

#include <gtest/gtest.h>

#include "gudgeon/model/check.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

TEST(ChannelTable, EveryRecordedNameIsKnownToFormulas) {
  for (const Mechanism& mechanism : oracle::make_all_mechanisms()) {
    const System system = compile(mechanism, assemble(mechanism));
    Mechanism asking = mechanism;
    for (const RecordedChannel& recorded : make_channel_table(system)) {
      const Expression formula{recorded.channel.name, {}};
      asking.loads.push_back({"ask_" + std::to_string(asking.loads.size()),
                              VariableTorque{mechanism.bodies[1].name, kFrameName, formula}});
    }
    const Diagnostics found = check(asking, {});
    for (const Diagnostic& item : found.items()) {
      EXPECT_NE(item.code, "E-MODEL-082") << mechanism.name << ": " << item.message;
    }
  }
}

}  // namespace
}  // namespace gudgeon
