// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The moving mechanism with its controls. Keys: Space plays, arrows step, Home and End, L loops, < and > change speed.
import { findCase } from './data.js';
import { make, saveFile } from './elements.js';
import { showMoment } from './figure_places.js';
import { JointInset } from './joint_inset.js';
import { LinkageView } from './linkage_view.js';
import { Motion } from './motion.js';
import { printNumber } from './number_text.js';
import { onThemeChange } from './palette.js';
import { Player } from './player.js';

const kSpeeds = [0.01, 0.02, 0.05, 0.1, 0.25, 0.5, 1, 2];
const kInsetsAtOnce = 2;

class MechanismPanel {
  constructor(place) {
    this.caseName = place.dataset.case;
    const { scene, motions } = findCase(this.caseName);
    this.scene = scene;
    this.motions = motions.map((raw) => new Motion(raw, scene));
    this.ideal = this.motions.find((motion) => motion.raw.stage === 'ideal') ?? null;
    this.motion = this.motions.find((motion) => motion !== this.ideal) ?? this.ideal;
    this.canvas = make('canvas', { role: 'img', 'aria-label': 'The linkage in motion' });
    this.view = new LinkageView(this.canvas, scene);
    this.insets = this.#makeInsets();
    this.player = new Player((time) => this.#show(time));
    this.stagePlace = make('div', { class: 'linkage' }, this.canvas);
    place.append(this.#makeControls(), make('div', { class: 'stage-view' }, this.stagePlace,
      make('div', { class: 'insets' }, ...this.insets.map((inset) => inset.element))), this.#makeNote());
    place.tabIndex = 0;
    place.setAttribute('role', 'group');
    place.setAttribute('aria-label', 'Moving mechanism. Space plays and pauses, arrows step, L loops a cycle.');
    place.panel = this;
    place.addEventListener('keydown', (event) => this.#onKey(event));
    onThemeChange(() => this.#draw());
    this.#select(this.motion);
    new ResizeObserver(() => this.#resize()).observe(this.stagePlace);
  }

  #makeInsets() {
    const clear = this.scene.joints.map((joint, j) => j).filter((j) => this.scene.joints[j].kind.endsWith('_clearance'));
    return clear.slice(0, kInsetsAtOnce).map((j) => {
      const inset = new JointInset(this.scene, clear, j);
      inset.choice.addEventListener('change', () => {
        inset.joint = Number(inset.choice.value);
        this.#draw();
      });
      return inset;
    });
  }

  #makeControls() {
    const button = (text, label, act) => make('button', { type: 'button', title: label, 'aria-label': label, onclick: act }, text);
    this.playButton = button('▶', 'Play', () => this.#toggle());
    this.slider = make('input', { type: 'range', min: 0, max: 1000, step: 'any', 'aria-label': 'Time' });
    this.slider.addEventListener('input', () => this.#scrub());
    this.clock = make('output', { class: 'clock' });
    this.loopBox = make('input', { type: 'checkbox' });
    this.loopBox.addEventListener('change', () => this.player.setLoop(this.loopBox.checked));
    this.ghostBox = make('input', { type: 'checkbox', checked: true });
    this.ghostBox.addEventListener('change', () => this.#draw());
    return make('div', { class: 'controls' },
      make('div', { class: 'row' }, button('|◀', 'To the start', () => this.player.show(this.motion.begin)),
        button('◀', 'One sample back', () => this.#step(-1)), this.playButton,
        button('▶|', 'One sample on', () => this.#step(1)), this.slider, this.clock),
      make('div', { class: 'row' }, this.#makeStageChoice(), this.#makeSpeedChoice(), this.#makeTraceChoice(),
        make('label', {}, this.loopBox, ' loop one cycle'),
        ...(this.ideal && this.motions.length > 1 ? [make('label', {}, this.ghostBox, ' ideal as ghost')] : []),
        button('PNG', 'Picture as PNG', () => this.#savePicture())));
  }

  #makeStageChoice() {
    this.stageChoice = make('select', {}, ...this.motions.map((motion, k) =>
      make('option', { value: k, selected: motion === this.motion }, motion.raw.label)));
    this.stageChoice.addEventListener('change', () => this.#select(this.motions[this.stageChoice.value]));
    return make('label', {}, 'Stage ', this.stageChoice);
  }

  #makeSpeedChoice() {
    this.speedChoice = make('select', {}, ...kSpeeds.map((speed) =>
      make('option', { value: speed, selected: speed === 0.25 }, `${speed} ×`)));
    this.speedChoice.addEventListener('change', () => { this.player.speed = Number(this.speedChoice.value); });
    return make('label', {}, 'Speed ', this.speedChoice);
  }

  #makeTraceChoice() {
    this.traceable = this.scene.bodies.flatMap((body, b) =>
      body.frame ? [] : body.points.map((point) => ({ body: b, point, name: `${body.name}.${point.name}` })));
    const first = this.traceable.findIndex(({ body }) => this.scene.bodies[body].points.length > 2);
    const plate = first < 0 ? this.traceable.length - 1 : first;
    this.traceChoice = make('select', {}, make('option', { value: -1 }, 'none'),
      ...this.traceable.map(({ name }, k) => make('option', { value: k, selected: k === plate }, name)));
    this.traceChoice.addEventListener('change', () => this.#draw());
    return make('label', {}, 'Trace ', this.traceChoice);
  }

  #makeNote() {
    this.note = make('p', { class: 'note' });
    return this.note;
  }

  #select(motion) {
    this.motion = motion;
    this.view.fit(motion);
    const cycles = (motion.end - motion.begin) / motion.cycleTime;
    const span = cycles >= 0.1 ? `${Number(cycles.toFixed(1))} cycles` : `${printNumber(motion.end - motion.begin)} s`;
    this.note.textContent = `The last ${span} of this stage, every recorded sample. Space plays, arrow keys step.`;
    if (this.view.width) this.view.resize(this.view.width);
    this.player.load(motion);
  }

  #savePicture() {
    this.canvas.toBlob((blob) => saveFile(`${this.caseName}.${this.motion.raw.stage}.${this.time.toFixed(4)}_s.png`, blob));
  }

  #resize() {
    const width = this.stagePlace.clientWidth;
    if (width === 0 || width === this.view.width) return;
    this.view.resize(width);
    this.#draw();
  }

  #toggle() {
    this.player.toggle();
    const playing = this.player.isPlaying;
    this.playButton.textContent = playing ? '❚❚' : '▶';
    this.playButton.setAttribute('aria-label', playing ? 'Pause' : 'Play');
  }

  #step(n) {
    if (this.player.isPlaying) this.#toggle();
    this.player.step(n);
  }

  #scrub() {
    const { begin, end } = this.motion;
    this.player.show(begin + (Number(this.slider.value) / 1000) * (end - begin));
  }

  #onKey(event) {
    if (event.target.matches('select, input[type=range]') && event.key !== ' ') return;
    const acts = {
      ' ': () => this.#toggle(),
      ArrowRight: () => this.#step(1),
      ArrowLeft: () => this.#step(-1),
      Home: () => this.player.show(this.motion.begin),
      End: () => this.player.show(this.motion.end),
      l: () => this.loopBox.click(),
      '<': () => this.#changeSpeed(-1),
      '>': () => this.#changeSpeed(1),
    };
    if (!acts[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    // A focused button answers to Space itself.
    if (event.key === ' ' && event.target.matches('button, input')) return;
    event.preventDefault();
    acts[event.key]();
  }

  #changeSpeed(n) {
    const k = Math.min(kSpeeds.length - 1, Math.max(0, kSpeeds.indexOf(this.player.speed) + n));
    this.player.speed = kSpeeds[k];
    this.speedChoice.value = String(kSpeeds[k]);
  }

  #show(time) {
    const { begin, end, times, cycleTime, raw } = this.motion;
    this.slider.value = String((1000 * (time - begin)) / Math.max(end - begin, 1e-12));
    this.clock.textContent = `t = ${time.toFixed(4)} s`;
    this.slider.setAttribute('aria-valuetext', `${time.toFixed(3)} seconds, cycle ${(time / cycleTime).toFixed(2)}`);
    this.time = time;
    this.#draw();
    showMoment(this.caseName, { time, stage: raw.stage, times });
  }

  #draw() {
    if (!this.view.width || this.time === undefined) return;
    const ghost = this.ideal && this.ghostBox.checked && this.motion !== this.ideal ? this.ideal : null;
    const traced = this.traceable[Number(this.traceChoice.value)] ?? null;
    const moment = { motion: this.motion, time: this.time, ghost, traced };
    this.view.draw(moment);
    for (const inset of this.insets) inset.draw(moment);
  }
}

/** Makes the panel of a place when it comes near the screen. */
export function fillMechanismPlaces() {
  const near = new IntersectionObserver((entries) => {
    for (const entry of entries) {
      if (!entry.isIntersecting || entry.target.panel) continue;
      if (findCase(entry.target.dataset.case).motions.length === 0) {
        entry.target.append(make('p', { class: 'note' }, 'Nothing was recorded to move.'));
        near.unobserve(entry.target);
      } else {
        new MechanismPanel(entry.target);
      }
    }
  }, { rootMargin: '300px' });
  document.querySelectorAll('.mechanism').forEach((place) => near.observe(place));
}
