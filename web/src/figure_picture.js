// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A figure as it is seen now, as SVG for print and as PNG.
import { findGroups, groupOf, readCurves } from './curves.js';
import { findTicks, printAxis, printTick } from './number_text.js';
import { curveColor, findDashes } from './palette.js';

const kWidth = 720;
const kInk = '#1f2933';
const kLegendRow = 20;
const kCaptionRow = 16;
const kCaptionLength = 115; // letters of 11 px that fit

const escape = (text) => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
const round = (value) => String(Math.round(value * 100) / 100);

function makeText(x, y, text, extra = '') {
  return `<text x="${round(x)}" y="${round(y)}" fill="${kInk}" ${extra}>${escape(text)}</text>`;
}

/** The caption in lines that fit: what one has to know to read the picture goes with it. */
function breakCaption(text) {
  const lines = [];
  for (const word of (text ?? '').split(' ').filter(Boolean)) {
    const longer = `${lines.at(-1)} ${word}`;
    if (lines.length > 0 && longer.length <= kCaptionLength) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}

const makeDashes = (curve) => (curve.line ? ` stroke-dasharray="${findDashes(curve).join(' ')}"` : '');

/** Legend entries in rows; returns their SVG and height. */
function makeLegend(groups, top) {
  let x = 12;
  let y = top;
  let svg = '';
  for (const { name, curve } of groups) {
    const length = 30 + 7.2 * name.length + 16;
    if (x > 12 && x + length > kWidth - 24) [x, y] = [12, y + kLegendRow];
    const color = curveColor(curve.color, false);
    svg += curve.points
      ? `<circle cx="${x + 11}" cy="${y + 10}" r="3" fill="${color}"/>`
      : `<line x1="${x}" x2="${x + 22}" y1="${y + 10}" y2="${y + 10}" stroke="${color}" stroke-width="2"${makeDashes(curve)}/>`;
    svg += makeText(x + 30, y + 14.5, name, 'font-size="12"');
    x += length;
  }
  return { svg, height: groups.length ? y + kLegendRow - top : 0 };
}

function makeAxes(figure, ranges, area, toX, toY) {
  const end = { x: area.x + area.w, y: area.y + area.h };
  const xTicks = findTicks(...ranges.x, 7, figure.x.display);
  const yTicks = findTicks(...ranges.y, Math.max(3, Math.round(area.h / 54)), figure.y.display);
  let svg = '';
  for (const place of xTicks.places) {
    svg += `<line x1="${round(toX(place))}" x2="${round(toX(place))}" y1="${area.y}" y2="${end.y}" stroke="#e4e7eb"/>`;
    svg += makeText(toX(place), end.y + 17, printTick(place, xTicks.decimals), 'font-size="12" text-anchor="middle"');
  }
  for (const place of yTicks.places) {
    svg += `<line x1="${area.x}" x2="${end.x}" y1="${round(toY(place))}" y2="${round(toY(place))}" stroke="#e4e7eb"/>`;
    svg += makeText(area.x - 7, toY(place) + 4.2, printTick(place, yTicks.decimals), 'font-size="12" text-anchor="end"');
  }
  svg += makeText((area.x + end.x) / 2, end.y + 38, printAxis(figure.x), 'font-size="13" text-anchor="middle"');
  svg += makeText(12, area.y - 9, printAxis(figure.y), 'font-size="13"');
  return svg;
}

function makeCurve(figure, curve, ranges, toX, toY) {
  const color = curveColor(curve.color, false);
  if (curve.points) {
    return Array.from(curve.xs, (x, k) => `<circle cx="${round(toX(x))}" cy="${round(toY(curve.ys[k]))}" r="2.6" fill="${color}"/>`).join('');
  }
  const isFunction = figure.kind === 'time' || figure.kind === 'line';
  const room = ranges.x[1] - ranges.x[0];
  const points = [];
  for (let k = 0; k < curve.xs.length; ++k) {
    // One sample beyond either end keeps the line whole; the rest of a function is not seen.
    if (isFunction && (curve.xs[k] < ranges.x[0] - 0.02 * room || curve.xs[k] > ranges.x[1] + 0.02 * room)) continue;
    points.push(`${round(toX(curve.xs[k]))},${round(toY(curve.ys[k]))}`);
  }
  return `<polyline points="${points.join(' ')}" fill="none" stroke="${color}" stroke-width="${figure.kind === 'phase' ? 1 : 1.4}"${makeDashes(curve)}/>`;
}

/** The figure over the given ranges, in display units, with the groups shown. */
export function makeSvg(figure, view, ranges) {
  const legend = makeLegend(findGroups(figure).filter((group) => view.shown.has(group.key)), 40);
  const top = 64 + legend.height;
  const area = { x: 74, y: top, w: kWidth - 98, h: figure.kind === 'plane' ? 622 : 324 };
  const limits = figure.kind === 'plane' ? makeSquare(ranges) : ranges;
  const toX = (value) => area.x + ((value - limits.x[0]) / (limits.x[1] - limits.x[0])) * area.w;
  const toY = (value) => area.y + area.h - ((value - limits.y[0]) / (limits.y[1] - limits.y[0])) * area.h;
  const curves = readCurves(figure).filter((curve) => view.shown.has(groupOf(curve)));
  const caption = breakCaption(figure.caption);
  const captionTop = top + area.h + 62;
  const height = top + area.h + 52 + (caption.length > 0 ? 8 + kCaptionRow * caption.length : 0);
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${kWidth}" height="${height}" viewBox="0 0 ${kWidth} ${height}" font-family="'DejaVu Sans', Verdana, 'Segoe UI', Helvetica, Arial, sans-serif" stroke-linejoin="round">
<title>${escape(figure.title)}</title><rect width="${kWidth}" height="${height}" fill="#ffffff"/>
<clipPath id="area"><rect x="${area.x}" y="${area.y}" width="${area.w}" height="${area.h}"/></clipPath>
${makeText(12, 26, figure.title, 'font-size="16" font-weight="bold"')}${legend.svg}
${makeAxes(figure, limits, area, toX, toY)}
<g clip-path="url(#area)">${curves.map((curve) => makeCurve(figure, curve, limits, toX, toY)).join('\n')}</g>
<rect x="${area.x}" y="${area.y}" width="${area.w}" height="${area.h}" fill="none" stroke="${kInk}"/>
${caption.map((line, k) => makeText(12, captionTop + kCaptionRow * k, line, 'font-size="11"')).join('')}
</svg>\n`;
}

/** The same centre, one scale, as high as wide. */
function makeSquare({ x, y }) {
  const half = Math.max(x[1] - x[0], y[1] - y[0]) / 2;
  const around = ([begin, end]) => [(begin + end) / 2 - half, (begin + end) / 2 + half];
  return { x: around(x), y: around(y) };
}

/** The SVG at twice its size, as a PNG blob. */
export async function makePng(svg) {
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svg)}`;
  await image.decode();
  const canvas = document.createElement('canvas');
  canvas.width = 2 * image.width;
  canvas.height = 2 * image.height;
  canvas.getContext('2d').drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((resolve) => canvas.toBlob(resolve, 'image/png'));
}
