// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The tables that a run ends with.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gudgeon/model/study.h"
#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// The summary of a run whose samples lie in the file, as far as it needs them. FileError when they cannot be read.
std::string summarize_case(const std::filesystem::path& file, RunRecord run,
                           const std::vector<ReferenceValue>& reference);

}  // namespace gudgeon
