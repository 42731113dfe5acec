// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The numbers of the page: JSON for what is small, blocks in base64 for signals, decoded when first shown.

export const report = JSON.parse(document.getElementById('report-data').textContent);

const decoded = new Map();

/** Block k as Float32Array or Float64Array, in SI. */
export function readBlock(k) {
  if (!decoded.has(k)) {
    const element = document.getElementById(`block-${k}`);
    const text = atob(element.textContent);
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
    decoded.set(k, element.dataset.type === 'f8' ? new Float64Array(bytes.buffer) : new Float32Array(bytes.buffer));
  }
  return decoded.get(k);
}

/** Block k times a factor; the block itself when the factor is 1. */
export function readScaled(k, factor) {
  const values = readBlock(k);
  return factor === 1 ? values : Float64Array.from(values, (value) => value * factor);
}

export const findCase = (name) => report.cases.find((one) => one.name === name);
