// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A figure's curves in display units.
import { readScaled } from './data.js';

/** Curves of a figure with their numbers, read once. */
export function readCurves(figure) {
  figure.read ??= figure.curves.map((curve) => ({
    ...curve,
    xs: readScaled(curve.x, figure.x.factor),
    ys: readScaled(curve.y, figure.y.factor),
  }));
  return figure.read;
}

/** One entry a group, in the order of the curves; a reference line is an entry of its own. */
export function findGroups(figure) {
  const groups = [];
  for (const curve of figure.curves) {
    const key = curve.group || `reference: ${curve.name}`;
    if (!groups.some((group) => group.key === key)) groups.push({ key, name: curve.name, curve });
  }
  return groups;
}

export const groupOf = (curve) => curve.group || `reference: ${curve.name}`;

/** What of a figure is seen: which groups, and which ranges (null: all). */
export function makeView(figure) {
  const shown = new Set(findGroups(figure).filter((group) => group.curve.shown).map((group) => group.key));
  return { shown, x: findFirstRange(figure), y: null };
}

export function findFirstRange(figure) {
  if (!(figure.end > figure.begin)) return null;
  return [figure.begin * figure.x.factor, figure.end * figure.x.factor];
}

/** Least and greatest finite value of the shown curves along 'xs' or 'ys', over an x range when one is given. */
export function findExtent(curves, part, range = null) {
  let least = Infinity;
  let greatest = -Infinity;
  for (const curve of curves) {
    const values = curve[part];
    for (let k = 0; k < values.length; ++k) {
      if (range && !(curve.xs[k] >= range[0] && curve.xs[k] <= range[1])) continue;
      if (values[k] < least) least = values[k];
      if (values[k] > greatest) greatest = values[k];
    }
  }
  return least <= greatest ? [least, greatest] : [0, 1];
}

/** Room around a range. */
export function widen([begin, end], part) {
  const room = end > begin ? part * (end - begin) : Math.abs(begin) * 0.1 || 1;
  return [begin - room, end + room];
}
