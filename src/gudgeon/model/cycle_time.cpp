// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Finds the driver that counts the cycles.
#include "gudgeon/model/cycle_time.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gudgeon {

const Driver* find_cycle_driver(const Mechanism& mechanism, const Study& study) {
  const bool named = !study.cycle_driver.empty();
  if (!named && study.cycle_time != 0.0) return nullptr;
  const auto found = std::ranges::find_if(mechanism.drivers, [&](const Driver& driver) {
    const bool turns = driver.speed != 0.0 && std::isfinite(driver.speed);
    return std::holds_alternative<DrivenAngle>(driver.target) && driver.is_uniform() &&
           (named ? driver.name == study.cycle_driver : turns);
  });
  return found == mechanism.drivers.end() ? nullptr : &*found;
}

double find_cycle_time(const Mechanism& mechanism, const Study& study) {
  if (const Driver* driver = find_cycle_driver(mechanism, study)) {
    return 2.0 * std::numbers::pi / std::abs(driver->speed);
  }
  return study.cycle_time != 0.0 ? study.cycle_time : kDefaultCycleTime;
}

}  // namespace gudgeon
