// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Colours that colour-blind readers can tell apart, after Okabe and Ito, for a light and a dark ground.

const kLight = ['#6b7280', '#0072b2', '#d55e00', '#009e73', '#cc79a7', '#b8860b', '#56b4e9', '#7f3fbf'];
const kDark = ['#9aa4b2', '#5cb3ec', '#f08a3c', '#2fc79b', '#e39cc4', '#e0b93f', '#8fd0f5', '#b48be8'];
const listeners = [];

export const isDark = () => document.documentElement.dataset.theme === 'dark';

/** Colour k of the palette; 0 is the neutral one. */
export function curveColor(k, dark = isDark()) {
  const colors = dark ? kDark : kLight;
  return k <= 0 ? colors[0] : colors[1 + ((k - 1) % (colors.length - 1))];
}

const kDashes = [[], [5, 5], [1.5, 3], [9, 3, 2, 3]];

/** Lengths of the dashes of a curve; none for a solid line. */
export const findDashes = (curve) => kDashes[curve.line];

/** A colour of the style sheet, "--ink". */
export const styleColor = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

export const onThemeChange = (listener) => listeners.push(listener);

function setTheme(dark) {
  document.documentElement.dataset.theme = dark ? 'dark' : 'light';
  for (const listener of listeners) listener();
}

/** Follows the system until the reader chooses. */
export function startTheme(button) {
  const system = window.matchMedia('(prefers-color-scheme: dark)');
  let chosen = false;
  setTheme(system.matches);
  system.addEventListener('change', () => chosen || setTheme(system.matches));
  button.addEventListener('click', () => {
    chosen = true;
    setTheme(!isDark());
  });
  // Paper is white.
  let wasDark = false;
  window.addEventListener('beforeprint', () => {
    wasDark = isDark();
    if (wasDark) setTheme(false);
  });
  window.addEventListener('afterprint', () => wasDark && setTheme(true));
}
