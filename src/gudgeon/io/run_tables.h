// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The tables of a run file, and stage states in words.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "gudgeon/io/hdf5_table.h"
#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// ChannelStatistics with its texts as HDF5 wants them.
struct StatisticsRow {
  const char* channel;
  const char* unit;  ///< of minimum, maximum, mean, rms
  double minimum;
  double minimum_time;
  double maximum;
  double maximum_time;
  double mean;
  double rms;
};

inline constexpr std::array kStatisticsFields{
    TableField{"channel", "", FieldKind::text, offsetof(StatisticsRow, channel)},
    TableField{"unit", "", FieldKind::text, offsetof(StatisticsRow, unit)},
    TableField{"minimum", "", FieldKind::real, offsetof(StatisticsRow, minimum)},
    TableField{"minimum_time", "s", FieldKind::real, offsetof(StatisticsRow, minimum_time)},
    TableField{"maximum", "", FieldKind::real, offsetof(StatisticsRow, maximum)},
    TableField{"maximum_time", "s", FieldKind::real, offsetof(StatisticsRow, maximum_time)},
    TableField{"mean", "", FieldKind::real, offsetof(StatisticsRow, mean)},
    TableField{"rms", "", FieldKind::real, offsetof(StatisticsRow, rms)},
};
inline constexpr TableShape kStatisticsShape{kStatisticsFields, sizeof(StatisticsRow)};

inline constexpr std::array kEventFields{
    TableField{"joint", "1", FieldKind::index, offsetof(ContactEvent, joint)},
    TableField{"onset_time", "s", FieldKind::real, offsetof(ContactEvent, onset_time)},
    TableField{"duration", "s", FieldKind::real, offsetof(ContactEvent, duration)},
    TableField{"onset_speed", "m/s", FieldKind::real, offsetof(ContactEvent, onset_speed)},
    TableField{"angle", "rad", FieldKind::real, offsetof(ContactEvent, angle)},
    TableField{"peak_force", "N", FieldKind::real, offsetof(ContactEvent, peak_force)},
    TableField{"position", "m", FieldKind::real, offsetof(ContactEvent, position), true},
    TableField{"contact", "1", FieldKind::index, offsetof(ContactEvent, contact), true},
};
inline constexpr TableShape kEventShape{kEventFields, sizeof(ContactEvent)};

struct OverrideRow {
  const char* path;
  const char* text;
};

inline constexpr std::array kOverrideFields{
    TableField{"path", "", FieldKind::text, offsetof(OverrideRow, path)},
    TableField{"text", "", FieldKind::text, offsetof(OverrideRow, text)},
};
inline constexpr TableShape kOverrideShape{kOverrideFields, sizeof(OverrideRow)};

struct StatusName {
  StageStatus status;
  const char* name;
};

inline constexpr std::array kStatusNames{
    StatusName{StageStatus::finished, "finished"},
    StatusName{StageStatus::stopped, "stopped"},
    StatusName{StageStatus::failed, "failed"},
};

}  // namespace gudgeon
