// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Values that replace those of the model file: from a named case or from the command line.
#pragma once

#include <string>
#include <vector>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/document.h"
#include "gudgeon/model/study.h"

namespace gudgeon {

/// One value to replace, "joints.A.radial_clearance" by "0.3 mm".
struct Override {
  std::string path;
  std::string value;
};

/// The [cases.NAME] tables of a document, their overrides under present paths; one that stands there under an old path
/// has both in the source map.
std::vector<Case> read_cases(const DocumentNode& root, SourceMap& source, Diagnostics& diagnostics);

/// Puts the value at its path. The table around it must be there; the reader then judges key and value.
/// The origin says who overrides, "--set study.cycles=3"; the span is the override's own place, if it has one.
void update_document(DocumentNode& root, const Override& change, const std::string& origin, const SourceSpan& span,
                     SourceMap& source, Diagnostics& diagnostics);

}  // namespace gudgeon
