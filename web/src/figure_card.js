// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A figure on the page: title, legend that switches, chart, hover values, buttons, caption.
import { findGroups, makeView } from './curves.js';
import { make, saveFile } from './elements.js';
import { makeCsv } from './figure_csv.js';
import { makePng, makeSvg } from './figure_picture.js';
import { printAxis, printQuantity } from './number_text.js';
import { curveColor, findDashes, onThemeChange } from './palette.js';
import { PlaneChart } from './plane_chart.js';
import { SignalChart } from './signal_chart.js';

const kKeys = {
  '+': (chart) => chart.zoomBy(0.5),
  '-': (chart) => chart.zoomBy(2),
  0: (chart) => chart.reset(),
  a: (chart) => chart.showAll(),
  ArrowLeft: (chart) => chart.panBy(-0.2),
  ArrowRight: (chart) => chart.panBy(0.2),
  ',': (chart) => chart.readBy(-1),
  '.': (chart) => chart.readBy(1),
  '<': (chart) => chart.readBy(-20),
  '>': (chart) => chart.readBy(20),
};

/** The line or dot of a curve, as the legend shows it. */
function makeSwatch(curve) {
  const swatch = make('span', { class: curve.points ? 'swatch dotted' : 'swatch' });
  swatch.dataset.color = curve.color;
  swatch.style.setProperty('--color', curveColor(curve.color));
  if (curve.line && !curve.points) {
    // The dashes of the line, as a gradient that repeats.
    let at = 0;
    const stops = findDashes(curve).map((length, k) => {
      const from = at;
      at += length;
      return `${k % 2 ? 'transparent' : 'var(--color)'} ${from}px ${at}px`;
    });
    swatch.style.background = `repeating-linear-gradient(90deg, ${stops.join(', ')})`;
  }
  return swatch;
}

export class FigureCard {
  constructor(figure, caseName) {
    this.figure = figure;
    this.name = [caseName, figure.id].filter(Boolean).join('.');
    this.view = makeView(figure);
    this.place = make('div', {
      class: `chart ${figure.kind}`, tabindex: 0, role: 'application', 'aria-roledescription': 'figure',
      'aria-label': `${figure.title}. ${printAxis(figure.y)} over ${printAxis(figure.x)}. Keys: plus and minus zoom, arrows pan, comma and full stop read values, 0 resets.`,
    });
    this.readout = make('output', { class: 'readout' }, '\u00a0');
    this.legend = make('div', { class: 'legend', role: 'group', 'aria-label': 'Curves' }, ...this.#makeLegend());
    this.element = make('figure', { class: `figure ${figure.kind}`, id: `figure-${this.name}`, 'data-figure': figure.id },
      make('h3', {}, figure.title), this.legend, make('div', { class: 'axis-label' }, printAxis(figure.y)), this.place,
      this.readout, this.#makeButtons(), make('figcaption', {}, figure.caption));
    this.element.card = this;
    this.place.addEventListener('keydown', (event) => this.#onKey(event));
    onThemeChange(() => this.#recolor());
  }

  #makeLegend() {
    return findGroups(this.figure).map(({ key, name, curve }) => {
      const swatch = makeSwatch(curve);
      const button = make('button', { type: 'button', 'data-group': key, 'aria-pressed': this.view.shown.has(key) }, swatch, name);
      button.setAttribute('aria-pressed', String(this.view.shown.has(key)));
      button.addEventListener('click', () => this.#toggle(key, button));
      return button;
    });
  }

  #toggle(key, button) {
    if (!this.view.shown.delete(key)) this.view.shown.add(key);
    button.setAttribute('aria-pressed', String(this.view.shown.has(key)));
    this.chart?.setShown();
  }

  #makeButtons() {
    const button = (text, label, onclick) => make('button', { type: 'button', title: label, 'aria-label': `${label}: ${this.figure.title}`, onclick }, text);
    return make('div', { class: 'buttons' },
      button('−', 'Show more', () => this.chart?.zoomBy(2)), button('+', 'Show less', () => this.chart?.zoomBy(0.5)),
      button('All', 'Show everything', () => this.chart?.showAll()), button('Reset', 'As at first', () => this.chart?.reset()),
      make('span', { class: 'gap' }),
      button('CSV', 'Data as CSV', () => this.saveCsv()), button('SVG', 'Picture as SVG', () => this.saveSvg()),
      button('PNG', 'Picture as PNG', () => this.savePng()));
  }

  #onKey(event) {
    const act = kKeys[event.key];
    if (!act || !this.chart || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    act(this.chart);
  }

  #recolor() {
    for (const swatch of this.legend.querySelectorAll('.swatch')) {
      swatch.style.setProperty('--color', curveColor(Number(swatch.dataset.color)));
    }
    this.chart?.redraw();
  }

  #showHover(hover) {
    if (!hover) {
      this.readout.textContent = '\u00a0';
      return;
    }
    const { x, y } = this.figure;
    const values = hover.values.map(({ curve, y: value }) => `${curve.name} ${printQuantity(value, y.display)}`);
    this.readout.textContent = `${printQuantity(hover.x, x.display)}: ${values.join(' · ')}`;
  }

  /** Makes the chart, when the figure comes near the screen. */
  draw() {
    if (this.chart) return;
    const Chart = this.figure.kind === 'time' || this.figure.kind === 'line' ? SignalChart : PlaneChart;
    this.chart = new Chart(this.figure, this.view, this.place, (hover) => this.#showHover(hover));
    this.width = this.place.clientWidth;
    if (this.moment) this.setTime(this.moment);
  }

  resize() {
    const width = this.place.clientWidth;
    if (!this.chart || width === 0 || width === this.width) return;
    this.width = width;
    this.chart.resize(width);
  }

  setTime(moment) {
    this.moment = moment;
    this.chart?.setTime(moment.time, moment.stage, moment.times);
  }

  saveCsv() { saveFile(`${this.name}.csv`, new Blob([makeCsv(this.figure)], { type: 'text/csv' })); }
  makeSvg() {
    this.draw();
    return makeSvg(this.figure, this.view, this.chart.findRanges());
  }
  saveSvg() { saveFile(`${this.name}.svg`, new Blob([this.makeSvg()], { type: 'image/svg+xml' })); }
  async savePng() { saveFile(`${this.name}.png`, await makePng(this.makeSvg())); }
}
