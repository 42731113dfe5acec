// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers as people read them.

/** Four significant digits, "−12.35", "1.5e-9". */
export function printNumber(value) {
  if (value === null || value === undefined || Number.isNaN(value)) return '–';
  const size = Math.abs(value);
  const text = size !== 0 && (size < 1e-4 || size >= 1e6) ? value.toExponential(3) : String(Number(value.toPrecision(4)));
  return text.replace('-', '−');
}

/** With its unit. */
export function printQuantity(value, unit) {
  return unit ? `${printNumber(value)} ${unit}` : printNumber(value);
}

/** Round numbers within [begin, end], about as many as wanted; degrees go by divisors of a turn. */
export function findTicks(begin, end, wanted, unit) {
  const raw = (end - begin) / Math.max(1, wanted);
  const decade = 10 ** Math.floor(Math.log10(raw));
  // A little closer than wanted rather than much too far apart.
  const isWide = (one) => one >= raw * 0.7;
  let step = [1, 2, 5, 10].map((part) => part * decade).find(isWide);
  if (unit === '°' && raw > 5) step = [10, 15, 30, 45, 60, 90, 180, 360].find(isWide) ?? step;
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const places = [];
  for (let k = Math.ceil(begin / step - 1e-9); k * step <= end + 1e-9 * step; ++k) places.push(k * step);
  return { places, decimals };
}

export const printTick = (value, decimals) => value.toFixed(decimals).replace(/^-(?=0\.?0*$)/, '').replace('-', '−');

/** [px] that the numbers beside an axis take, at 12 px: what most axes need, and more where numbers are long. */
export const findLabelRoom = (labels) => Math.max(58, 18 + 7.7 * Math.max(0, ...(labels ?? []).map((label) => label.length)));

/** "Wear depth (µm)" */
export const printAxis = (axis) => (axis.display ? `${axis.label} (${axis.display})` : axis.label);
