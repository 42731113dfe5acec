// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A figure's numbers as comma-separated text, in SI.
import { readBlock } from './data.js';

const quote = (cell) => (/[",\n]/.test(cell) ? `"${cell.replaceAll('"', '""')}"` : cell);
const nameColumn = (name, unit) => quote(unit ? `${name} [${unit}]` : name);

/** A number that reads back as the one stored: single precision needs up to nine digits. */
function print(value, single) {
  if (!single) return String(value);
  const short = Number(value.toPrecision(7));
  return String(Math.fround(short) === value ? short : Number(value.toPrecision(9)));
}

/** Columns x and y of every curve; curves with the same x share its column. */
export function makeCsv(figure) {
  const columns = [];
  for (const curve of figure.curves) {
    const name = curve.line && figure.kind === 'plane' && curve.group ? `${curve.name}, second surface` : curve.name;
    if (!columns.some((column) => column.block === curve.x)) {
      columns.push({ block: curve.x, name: nameColumn(figure.x.label, figure.x.unit) });
    }
    columns.push({ block: curve.y, name: nameColumn(name, figure.y.unit) });
  }
  const values = columns.map((column) => readBlock(column.block));
  const n = Math.max(...values.map((column) => column.length));
  const rows = [columns.map((column) => column.name).join(',')];
  for (let k = 0; k < n; ++k) {
    rows.push(values.map((column) => (k < column.length ? print(column[k], column instanceof Float32Array) : '')).join(','));
  }
  return `${rows.join('\n')}\n`;
}
