// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A clearance joint magnified: bearing or slot, journal with its clearance exaggerated, contact points, force on the
// journal.
import { make, prepareCanvas } from './elements.js';
import { drawContact, drawDisc, drawForce, drawMark } from './inset_marks.js';
import { printQuantity } from './number_text.js';
import { curveColor, styleColor } from './palette.js';
import { drawSlot } from './slot_inset.js';

const kSize = 210; // [px] it is laid out on; drawn smaller where there is less room
const kSlotHeight = 140; // [px]
const kRadius = 74; // [px] of the bearing
const kGap = 17; // [px] that the clearance is drawn as

/** 2 digits: "6.9", "69", "690". */
const printFactor = (factor) => Number(factor.toPrecision(2)).toString();

export class JointInset {
  /** indices: the clearance joints a reader can choose among; at: the one shown first. */
  constructor(scene, indices, at) {
    this.scene = scene;
    this.joint = at;
    this.canvas = make('canvas', { role: 'img' });
    this.text = make('div', { class: 'inset-text' });
    this.choice = make('select', { 'aria-label': 'Joint to magnify' },
      ...indices.map((j) => make('option', { value: j, selected: j === at }, scene.joints[j].name)));
    this.choice.hidden = indices.length < 3;
    this.title = make('strong');
    this.element = make('div', { class: 'inset' }, make('div', { class: 'inset-title' }, this.title, this.choice), this.canvas, this.text);
  }

  /** The greatest force while it moves, which the longest arrow stands for. */
  measure(motion) {
    this.measured = motion;
    this.greatest = 0;
    for (const time of motion.times) {
      const { fx, fy } = motion.findJoint(this.joint, time);
      this.greatest = Math.max(this.greatest, Math.hypot(fx, fy));
    }
  }

  draw({ motion, time }) {
    if (this.measured !== motion || this.measuredJoint !== this.joint) {
      this.measure(motion);
      this.measuredJoint = this.joint;
    }
    const joint = this.scene.joints[this.joint];
    const state = motion.findJoint(this.joint, time);
    const poses = motion.findPoses(time);
    const size = Math.min(kSize, this.element.clientWidth || kSize);
    const isRound = joint.kind === 'revolute_clearance';
    const height = isRound ? kSize : kSlotHeight;
    const context = prepareCanvas(this.canvas, size, (size * height) / kSize);
    context.scale(size / kSize, size / kSize);
    context.translate(kSize / 2, height / 2);
    this.title.textContent = this.choice.hidden ? `Joint ${joint.name}` : 'Joint ';
    if (isRound) this.#drawRound(context, joint, state, poses);
    this.layout = isRound ? null : drawSlot(context, joint, state, poses, this.greatest);
    if (!isRound) this.factor = this.layout.factor;
    this.#tell(joint, state, (isRound ? state.x : state.height) === undefined);
  }

  /** What is drawn, in words. */
  #tell(joint, state, isIdeal) {
    const force = printQuantity(Math.hypot(state.fx, state.fy), 'N');
    const places = this.layout?.touching.length > 1 ? ` in ${this.layout.touching.length} places` : '';
    const where = isIdeal ? `joint force ${force}` : state.normal > 0 ? `contact${places}, ${force}` : 'free flight';
    const what = this.layout?.isBlock ? 'clearance and tilt' : 'clearance';
    const scale = isIdeal ? '\u00a0' : `${what} × ${printFactor(this.factor)}, arrow ∝ √F, longest ${printQuantity(this.greatest, 'N')}`;
    this.text.replaceChildren(where, make('br'), scale);
    this.canvas.title = 'Ticks show how the two bodies are turned';
    this.canvas.setAttribute('aria-label', `Joint ${joint.name}, magnified: ${where}`);
  }

  #drawRound(context, joint, state, poses) {
    const clearance = joint.clearance || 1;
    const isIdeal = state.x === undefined;
    this.factor = kGap / ((kRadius / joint.bearing_radius) * clearance);
    const unit = isIdeal ? 0 : kGap / clearance; // [px/m]
    const [ex, ey] = [(state.x ?? 0) * unit, -(state.y ?? 0) * unit];
    const bearing = curveColor(1 + (joint.first % 7));
    const journal = curveColor(1 + (joint.second % 7));
    this.#drawRing(context, bearing);
    drawDisc(context, ex, ey, kRadius - (isIdeal ? 0 : kGap), journal);
    drawMark(context, 0, 0, kRadius + 4, kRadius + 14, poses[joint.first].angle, bearing);
    drawMark(context, ex, ey, kRadius - kGap - 12, kRadius - kGap - 2, poses[joint.second].angle, journal);
    context.fillStyle = styleColor('--ink');
    context.fillRect(-1.5, -1.5, 3, 3);
    if (isIdeal || !(state.normal > 0)) return;
    const angle = Math.atan2(ey, ex);
    const [x, y] = [kRadius * Math.cos(angle), kRadius * Math.sin(angle)];
    drawContact(context, x, y);
    drawForce(context, x, y, state, this.greatest);
  }

  #drawRing(context, color) {
    context.lineWidth = 9;
    context.strokeStyle = color;
    context.globalAlpha = 0.3;
    context.beginPath();
    context.arc(0, 0, kRadius + 4.5, 0, 2 * Math.PI);
    context.stroke();
    context.globalAlpha = 1;
    context.lineWidth = 1.5;
    context.beginPath();
    context.arc(0, 0, kRadius, 0, 2 * Math.PI);
    context.stroke();
  }
}
