// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The closure Jacobian entry by entry.
#pragma once

#include "gudgeon/system/coordinates.h"
#include "gudgeon/system/tables.h"

namespace gudgeon {

/// Calls visit(row, index, value) for the entries of one closure's rows, 0 and 1, with the index that the coordinate
/// has in the tables: free ones come first, driven ones stand behind the rows, the frame is the bin. An index may come
/// several times; its values add up.
template <class Visit>
void visit_closure_entries(const Tables& tables, const Coordinates& at, const ClosureRows& rows, Visit&& visit) {
  if (rows.kind == ClosureKind::angle) {
    visit(0, tables.find_turn_index(rows.angle_turn[0]), 1.0);
    visit(0, tables.find_turn_index(rows.angle_turn[1]), -1.0);
    return;
  }
  const Vec2 normal = at.rotation[rows.line_turn] * rows.normal;
  const auto add = [&](int index, Vec2 direction) {
    if (rows.kind == ClosureKind::line) {
      visit(0, index, dot(normal, direction));
    } else {
      visit(0, index, direction.x);
      visit(1, index, direction.y);
    }
  };
  Vec2 gap;
  for (int t = rows.first_term; t < rows.end_term; ++t) {
    const ClosureTerm& term = tables.closure_terms[t];
    const Vec2 arm = at.rotation[term.turn] * term.vector;
    gap += at.slide[term.slide] * arm;
    add(tables.find_turn_index(term.turn), at.slide[term.slide] * perp(arm));
    add(tables.find_slide_index(term.slide), arm);
  }
  if (rows.kind == ClosureKind::line) visit(0, tables.find_turn_index(rows.line_turn), cross(normal, gap));
}

}  // namespace gudgeon
