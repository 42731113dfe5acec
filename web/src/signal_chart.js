// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Signals over time and profiles over a coordinate, drawn by uPlot. Drag zooms, Shift and drag pans, a double click
// shows all.
import uPlot from 'uplot';
import { findExtent, findFirstRange, groupOf, readCurves, widen } from './curves.js';
import { findLabelRoom, findTicks, printAxis, printTick } from './number_text.js';
import { curveColor, findDashes, styleColor } from './palette.js';

const kHeight = 280;
const kFont = '12px system-ui, sans-serif';

const isSame = (a, b) => a.length === b.length && a.every((value, k) => value === b[k]);
const allNumbers = (values) => (values.some(Number.isNaN) ? Array.from(values, (v) => (Number.isNaN(v) ? null : v)) : values);

/** One x for all curves, as uPlot wants it. */
function alignCurves(curves) {
  const first = curves[0].xs;
  if (curves.every((curve) => isSame(curve.xs, first))) return [first, ...curves.map((curve) => allNumbers(curve.ys))];
  return uPlot.join(curves.map((curve) => [Array.from(curve.xs), Array.from(curve.ys)]));
}

function makeAxis(axis, side) {
  return {
    stroke: () => styleColor('--ink'),
    grid: { stroke: () => styleColor('--grid'), width: 1 },
    ticks: { stroke: () => styleColor('--grid'), width: 1, size: 4 },
    font: kFont,
    labelFont: kFont,
    label: side === 'x' ? printAxis(axis) : undefined,
    labelSize: 20,
    size: side === 'x' ? 34 : (u, values) => findLabelRoom(values),
    splits: (u, axisIndex, begin, end) => {
      const pixels = (side === 'x' ? u.bbox.width : u.bbox.height) / (window.devicePixelRatio || 1);
      return findTicks(begin, end, Math.max(2, Math.floor(pixels / (side === 'x' ? 80 : 45))), axis.display).places;
    },
    values: (u, splits) => {
      const step = splits.length > 1 ? Math.abs(splits[1] - splits[0]) : 1;
      const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
      return splits.map((value) => printTick(value, decimals));
    },
  };
}

/** A turn is whole although its cells' middles do not reach its ends. */
function findWholeRange(curves, axis) {
  const [begin, end] = findExtent(curves, 'xs');
  return axis.display === '°' && begin >= 0 && begin < 1 && end > 359 && end <= 360 ? [0, 360] : [begin, end];
}

export class SignalChart {
  constructor(figure, view, place, onHover) {
    this.figure = figure;
    this.view = view;
    this.curves = readCurves(figure);
    this.data = alignCurves(this.curves);
    this.all = findWholeRange(this.curves, figure.x);
    this.cursor = document.createElement('div');
    this.cursor.className = 'time-cursor';
    this.plot = new uPlot(this.#makeOptions(place.clientWidth, onHover), this.data, place);
    this.plot.over.append(this.cursor);
    this.#listenForPan();
    this.plot.over.addEventListener('dblclick', (event) => {
      event.stopPropagation();
      this.zoomTo(this.all);
    }, true);
    // At once: a picture may be asked for before uPlot would come to it.
    this.plot.batch(() => this.zoomTo(view.x ?? this.all));
  }

  #makeOptions(width, onHover) {
    const series = this.curves.map((curve) => ({
      label: curve.name,
      show: this.view.shown.has(groupOf(curve)),
      stroke: () => curveColor(curve.color),
      width: curve.group ? 1.4 : 1,
      dash: curve.line ? findDashes(curve) : undefined,
      spanGaps: true,
      points: { show: false },
    }));
    return {
      width,
      height: kHeight,
      padding: [12, 24, 0, 0],
      legend: { show: false },
      scales: { x: { time: false }, y: { range: (u, least, greatest) => widen(least === null ? [0, 1] : [least, greatest], 0.06) } },
      axes: [makeAxis(this.figure.x, 'x'), makeAxis(this.figure.y, 'y')],
      series: [{}, ...series],
      cursor: {
        drag: { x: true, y: false, dist: 5 },
        sync: this.figure.kind === 'time' ? { key: 'time', setSeries: false } : undefined,
        points: { size: 6 },
      },
      hooks: {
        setScale: [(u, key) => key === 'x' && this.#noteRange()],
        setCursor: [(u) => onHover(this.#findHover(u))],
      },
    };
  }

  #noteRange() {
    const { min, max } = this.plot?.scales.x ?? {};
    if (min === undefined || min === null) return;
    this.view.x = [min, max];
    this.setTime(this.time);
  }

  #findHover(u) {
    const k = u.cursor.idx;
    if (k === null || k === undefined) return null;
    const values = this.curves.map((curve, i) => ({ curve, y: this.data[i + 1][k] }));
    return { x: this.data[0][k], values: values.filter(({ curve }) => this.view.shown.has(groupOf(curve))) };
  }

  /** Shift and drag moves the range; uPlot's own drag zooms. */
  #listenForPan() {
    const over = this.plot.over;
    over.addEventListener('mousedown', (event) => {
      if (!event.shiftKey) return;
      event.stopImmediatePropagation();
      event.preventDefault();
      const [begin, end] = this.view.x;
      const scale = (end - begin) / over.clientWidth;
      const move = (now) => this.zoomTo([begin, end].map((x) => x - (now.clientX - event.clientX) * scale));
      const stop = () => {
        window.removeEventListener('mousemove', move);
        window.removeEventListener('mouseup', stop);
      };
      window.addEventListener('mousemove', move);
      window.addEventListener('mouseup', stop);
    }, true);
  }

  zoomTo([min, max]) {
    if (max > min) this.plot.setScale('x', { min, max });
  }

  /** factor < 1 shows less. */
  zoomBy(factor) {
    const [begin, end] = this.view.x;
    const center = (begin + end) / 2;
    const half = (factor * (end - begin)) / 2;
    this.zoomTo([Math.max(this.all[0], center - half), Math.min(this.all[1], center + half)]);
  }

  panBy(part) {
    const [begin, end] = this.view.x;
    const shift = Math.max(this.all[0] - begin, Math.min(this.all[1] - end, part * (end - begin)));
    this.zoomTo([begin + shift, end + shift]);
  }

  /** Moves the cursor by samples, from the first one that is seen. */
  readBy(n) {
    const [xs] = this.data;
    const [begin, end] = this.view.x;
    const at = xs[this.plot.cursor.idx ?? -1];
    const first = xs.findIndex((x) => x >= begin);
    const k = at >= begin && at <= end && this.plot.cursor.left >= 0 ? this.plot.cursor.idx + n : first;
    if (!(xs[k] >= begin && xs[k] <= end)) return;
    this.plot.setCursor({ left: this.plot.valToPos(xs[k], 'x'), top: this.plot.over.clientHeight / 2 });
  }

  showAll() { this.zoomTo(this.all); }
  reset() { this.zoomTo(findFirstRange(this.figure) ?? this.all); }

  setShown() {
    this.curves.forEach((curve, k) => this.plot.setSeries(k + 1, { show: this.view.shown.has(groupOf(curve)) }, false));
    this.redraw();
  }

  /** Puts the time cursor; undefined takes it away. */
  setTime(time) {
    this.time = time;
    const [begin, end] = this.view.x ?? this.all;
    const isSeen = this.figure.kind === 'time' && time !== undefined && time >= begin && time <= end;
    this.cursor.hidden = !isSeen;
    if (isSeen) this.cursor.style.transform = `translateX(${this.plot.valToPos(time, 'x')}px)`;
  }

  resize(width) {
    this.plot.setSize({ width, height: kHeight });
    this.setTime(this.time);
  }

  redraw() { this.plot.redraw(true, true); }

  /** What is drawn now, for the picture of it. */
  findRanges() {
    const { x, y } = this.plot.scales;
    return { x: [x.min, x.max], y: [y.min, y.max] };
  }
}
