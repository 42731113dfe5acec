// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Trajectories, points and outlines in a plane, on a canvas of their own: uPlot draws functions of x only. Drag zooms,
// Shift and drag pans, a double click shows all.
import { findExtent, groupOf, readCurves, widen } from './curves.js';
import { make, prepareCanvas } from './elements.js';
import { findLabelRoom, findTicks, printAxis, printTick } from './number_text.js';
import { curveColor, findDashes, styleColor } from './palette.js';

const kMargin = { left: 58, right: 14, top: 12, bottom: 46 }; // [px]; left at least
const kPhaseHeight = 320;

export class PlaneChart {
  constructor(figure, view, place, onHover) {
    this.figure = figure;
    this.view = view;
    this.curves = readCurves(figure);
    this.canvas = make('canvas');
    this.selection = make('div', { class: 'selection', hidden: true });
    this.dots = make('div', { class: 'dots', 'aria-hidden': 'true' });
    place.append(this.canvas, this.selection, this.dots);
    this.onHover = onHover;
    this.all = this.#findAll();
    view.x ??= this.all.x;
    view.y ??= this.all.y;
    this.resize(place.clientWidth);
    this.#listen();
  }

  #findAll() {
    return { x: widen(findExtent(this.curves, 'xs'), 0.05), y: widen(findExtent(this.curves, 'ys'), 0.06) };
  }

  resize(width) {
    this.width = width;
    const inner = width - kMargin.left - kMargin.right;
    const isPlane = this.figure.kind === 'plane';
    this.height = isPlane ? Math.min(inner, 430) + kMargin.top + kMargin.bottom : kPhaseHeight;
    this.redraw();
  }

  /** The area of the plot and the ranges on it; a plane has one scale. */
  #layOut() {
    let { x, y } = this.view;
    const h = this.height - kMargin.top - kMargin.bottom;
    const ticks = findTicks(y[0], y[1], Math.max(2, Math.floor(h / 45)), this.figure.y.display);
    const left = findLabelRoom(ticks.places.map((place) => printTick(place, ticks.decimals)));
    const area = { x: left, y: kMargin.top, w: this.width - left - kMargin.right, h };
    if (this.figure.kind === 'plane') {
      const scale = Math.max((x[1] - x[0]) / area.w, (y[1] - y[0]) / area.h);
      const fit = ([begin, end], pixels) => [(begin + end - scale * pixels) / 2, (begin + end + scale * pixels) / 2];
      x = fit(x, area.w);
      y = fit(y, area.h);
    }
    const toX = (value) => area.x + ((value - x[0]) / (x[1] - x[0])) * area.w;
    const toY = (value) => area.y + area.h - ((value - y[0]) / (y[1] - y[0])) * area.h;
    const fromX = (pixel) => x[0] + ((pixel - area.x) / area.w) * (x[1] - x[0]);
    const fromY = (pixel) => y[0] + ((area.y + area.h - pixel) / area.h) * (y[1] - y[0]);
    this.layout = { area, x, y, toX, toY, fromX, fromY };
    return this.layout;
  }

  redraw() {
    this.mark?.remove();
    const context = prepareCanvas(this.canvas, this.width, this.height);
    const layout = this.#layOut();
    this.#drawAxes(context, layout);
    const { area } = layout;
    context.save();
    context.beginPath();
    context.rect(area.x, area.y, area.w, area.h);
    context.clip();
    for (const curve of this.curves) {
      if (this.view.shown.has(groupOf(curve))) this.#drawCurve(context, layout, curve);
    }
    context.restore();
    context.strokeStyle = styleColor('--line');
    context.strokeRect(area.x + 0.5, area.y + 0.5, area.w - 1, area.h - 1);
    this.setTime(this.time, this.stage, this.sampleTimes);
  }

  #drawAxes(context, { area, x, y, toX, toY }) {
    context.font = '12px system-ui, sans-serif';
    context.fillStyle = styleColor('--ink');
    context.strokeStyle = styleColor('--grid');
    context.lineWidth = 1;
    const xTicks = findTicks(x[0], x[1], Math.max(2, Math.floor(area.w / 80)), this.figure.x.display);
    const yTicks = findTicks(y[0], y[1], Math.max(2, Math.floor(area.h / 45)), this.figure.y.display);
    context.beginPath();
    context.textAlign = 'center';
    for (const place of xTicks.places) {
      context.moveTo(toX(place), area.y);
      context.lineTo(toX(place), area.y + area.h);
      context.fillText(printTick(place, xTicks.decimals), toX(place), area.y + area.h + 17);
    }
    context.textAlign = 'right';
    for (const place of yTicks.places) {
      context.moveTo(area.x, toY(place));
      context.lineTo(area.x + area.w, toY(place));
      context.fillText(printTick(place, yTicks.decimals), area.x - 6, toY(place) + 4);
    }
    context.stroke();
    context.textAlign = 'center';
    context.fillText(printAxis(this.figure.x), area.x + area.w / 2, this.height - 8);
  }

  #drawCurve(context, { toX, toY }, curve) {
    context.strokeStyle = context.fillStyle = curveColor(curve.color);
    context.lineWidth = this.figure.kind === 'phase' ? 1 : 1.4;
    context.globalAlpha = this.figure.kind === 'phase' && !curve.points ? 0.7 : 1;
    context.setLineDash(findDashes(curve));
    context.beginPath();
    for (let k = 0; k < curve.xs.length; ++k) {
      const px = toX(curve.xs[k]);
      const py = toY(curve.ys[k]);
      if (curve.points) {
        context.moveTo(px + 2.6, py);
        context.arc(px, py, 2.6, 0, 2 * Math.PI);
      } else {
        context.lineTo(px, py);
      }
    }
    if (curve.points) context.fill();
    else context.stroke();
    context.globalAlpha = 1;
    context.setLineDash([]);
  }

  #listen() {
    const { canvas, onHover } = this;
    canvas.addEventListener('mousemove', (event) => onHover(this.#findNearest(event.offsetX, event.offsetY)));
    canvas.addEventListener('mouseleave', () => onHover(null));
    canvas.addEventListener('dblclick', () => this.showAll());
    canvas.addEventListener('mousedown', (event) => this.#drag(event));
  }

  #drag(event) {
    event.preventDefault();
    const start = { x: event.offsetX, y: event.offsetY, view: { x: this.layout.x, y: this.layout.y } };
    const box = this.canvas.getBoundingClientRect();
    const find = (now) => ({ x: now.clientX - box.left, y: now.clientY - box.top });
    const move = (now) => (event.shiftKey ? this.#pan(start, find(now)) : this.#select(start, find(now)));
    const stop = (now) => {
      window.removeEventListener('mousemove', move);
      window.removeEventListener('mouseup', stop);
      this.selection.hidden = true;
      const end = find(now);
      const isBox = Math.abs(end.x - start.x) > 5 && Math.abs(end.y - start.y) > 5;
      if (!event.shiftKey && isBox) this.#zoomToBox(start, end);
    };
    window.addEventListener('mousemove', move);
    window.addEventListener('mouseup', stop);
  }

  #pan(start, now) {
    const { area } = this.layout;
    const shift = (range, pixels, length) => range.map((value) => value + (pixels / length) * (range[1] - range[0]));
    this.view.x = shift(start.view.x, start.x - now.x, area.w);
    this.view.y = shift(start.view.y, now.y - start.y, area.h);
    this.redraw();
  }

  #select(start, now) {
    const style = this.selection.style;
    this.selection.hidden = false;
    style.left = `${Math.min(start.x, now.x)}px`;
    style.top = `${Math.min(start.y, now.y)}px`;
    style.width = `${Math.abs(now.x - start.x)}px`;
    style.height = `${Math.abs(now.y - start.y)}px`;
  }

  #zoomToBox(start, end) {
    const { fromX, fromY } = this.layout;
    this.view.x = [fromX(Math.min(start.x, end.x)), fromX(Math.max(start.x, end.x))];
    this.view.y = [fromY(Math.max(start.y, end.y)), fromY(Math.min(start.y, end.y))];
    this.redraw();
  }

  #findNearest(px, py) {
    const { toX, toY } = this.layout;
    let best = null;
    let least = 20 * 20; // [px^2] further away nothing is meant
    for (const curve of this.curves) {
      if (!this.view.shown.has(groupOf(curve))) continue;
      for (let k = 0; k < curve.xs.length; ++k) {
        const distance = (toX(curve.xs[k]) - px) ** 2 + (toY(curve.ys[k]) - py) ** 2;
        if (distance < least) {
          least = distance;
          best = { curve, x: curve.xs[k], y: curve.ys[k] };
        }
      }
    }
    return best && { x: best.x, values: [{ curve: best.curve, y: best.y }] };
  }

  /** Reads the next points of the first curve that is shown, round and round. */
  readBy(n) {
    const curve = this.curves.find((one) => this.view.shown.has(groupOf(one)) && one.group) ?? this.curves[0];
    const count = curve.xs.length;
    this.readAt = ((((this.readAt ?? -n) + n) % count) + count) % count;
    const at = { x: curve.xs[this.readAt], y: curve.ys[this.readAt] };
    this.onHover({ x: at.x, values: [{ curve, y: at.y }] });
    const { toX, toY } = this.layout;
    this.mark?.remove();
    this.mark = make('div', { class: 'dot reading' });
    this.mark.style.transform = `translate(${toX(at.x)}px, ${toY(at.y)}px)`;
    this.selection.after(this.mark);
  }

  zoomBy(factor) {
    const { x, y } = this.layout;
    const scale = ([begin, end]) => [(begin + end - factor * (end - begin)) / 2, (begin + end + factor * (end - begin)) / 2];
    this.view.x = scale(x);
    this.view.y = scale(y);
    this.redraw();
  }

  panBy(part) {
    this.view.x = this.layout.x.map((value, k, range) => value + part * (range[1] - range[0]));
    this.redraw();
  }

  showAll() {
    this.view.x = this.all.x;
    this.view.y = this.all.y;
    this.redraw();
  }

  reset() { this.showAll(); }
  setShown() { this.redraw(); }

  /** A dot where the moving stage's trajectory is at that time; times are those of its samples. */
  setTime(time, stage, times) {
    this.time = time;
    this.stage = stage;
    this.sampleTimes = times;
    this.dots.replaceChildren();
    const curve = this.curves.find((one) => one.group === stage && one.follows && !one.points);
    if (time === undefined || !times || !curve || !this.view.shown.has(curve.group)) return;
    const { area, toX, toY } = this.layout;
    const k = findSample(times, time);
    const at = { x: toX(curve.xs[k]), y: toY(curve.ys[k]) };
    if (at.x < area.x || at.x > area.x + area.w || at.y < area.y || at.y > area.y + area.h) return;
    const dot = make('div', { class: 'dot' });
    dot.style.transform = `translate(${at.x}px, ${at.y}px)`;
    this.dots.append(dot);
  }

  findRanges() { return { x: this.layout.x, y: this.layout.y }; }
}

/** The last sample not after a time. */
export function findSample(times, time) {
  let first = 0;
  let last = times.length - 1;
  while (first < last) {
    const middle = (first + last + 1) >> 1;
    if (times[middle] <= time) first = middle;
    else last = middle - 1;
  }
  return first;
}
