// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A clearance joint magnified: bearing, journal with its clearance exaggerated, contact point, force on the journal.
import { make, prepareCanvas } from './elements.js';
import { printQuantity } from './number_text.js';
import { curveColor, styleColor } from './palette.js';

const kSize = 210; // [px] it is laid out on; drawn smaller where there is less room
const kRadius = 74; // [px] of the bearing
const kGap = 17; // [px] that the clearance is drawn as
const kLongest = 56; // [px] of the greatest force
const kSlotHalf = 88; // [px]

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
    const context = prepareCanvas(this.canvas, size, size);
    context.scale(size / kSize, size / kSize);
    context.translate(kSize / 2, kSize / 2);
    this.title.textContent = this.choice.hidden ? `Joint ${joint.name}` : 'Joint ';
    this.canvas.setAttribute('aria-label', `Joint ${joint.name}, magnified`);
    if (joint.kind === 'revolute_clearance') this.#drawRound(context, joint, state, poses);
    else this.#drawSlot(context, joint, state, poses);
    const force = Math.hypot(state.fx, state.fy);
    // An ideal joint and a slot have no journal centre to tell contact from flight by.
    const where = state.x === undefined ? `joint force ${printQuantity(force, 'N')}`
      : state.normal > 0 ? `contact, ${printQuantity(force, 'N')}` : 'free flight';
    this.text.replaceChildren(where, make('br'),
      state.x === undefined ? '\u00a0' : `clearance × ${printFactor(this.factor)}, arrow ∝ √F, longest ${printQuantity(this.greatest, 'N')}`);
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
    this.#drawDisc(context, ex, ey, kRadius - (isIdeal ? 0 : kGap), journal);
    this.#drawMark(context, 0, 0, kRadius + 4, kRadius + 14, poses[joint.first].angle, bearing);
    this.#drawMark(context, ex, ey, 12, kRadius - kGap - 8, poses[joint.second].angle, journal);
    context.fillStyle = styleColor('--ink');
    context.fillRect(-1.5, -1.5, 3, 3);
    if (isIdeal || !(state.normal > 0)) return;
    const angle = Math.atan2(ey, ex);
    this.#drawForce(context, kRadius * Math.cos(angle), kRadius * Math.sin(angle), state);
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

  #drawDisc(context, x, y, radius, color) {
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.fillStyle = context.strokeStyle = color;
    context.globalAlpha = 0.22;
    context.fill();
    context.globalAlpha = 1;
    context.lineWidth = 1.5;
    context.stroke();
    context.fillRect(x - 1.5, y - 1.5, 3, 3);
  }

  /** A line that turns with its body. */
  #drawMark(context, x, y, from, to, angle, color) {
    context.strokeStyle = color;
    context.lineWidth = 2;
    context.beginPath();
    context.moveTo(x + from * Math.cos(angle), y - from * Math.sin(angle));
    context.lineTo(x + to * Math.cos(angle), y - to * Math.sin(angle));
    context.stroke();
  }

  #drawForce(context, x, y, { fx, fy }) {
    const force = Math.hypot(fx, fy);
    const color = styleColor('--clearance');
    context.fillStyle = context.strokeStyle = color;
    context.beginPath();
    context.arc(x, y, 4, 0, 2 * Math.PI);
    context.fill();
    if (!(force > 0) || !(this.greatest > 0)) return;
    const length = kLongest * Math.sqrt(force / this.greatest);
    const [ux, uy] = [fx / force, -fy / force];
    const [tx, ty] = [x + length * ux, y + length * uy];
    context.lineWidth = 2.5;
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(tx, ty);
    context.stroke();
    const head = Math.min(9, length);
    context.beginPath();
    context.moveTo(tx, ty);
    context.lineTo(tx - head * ux - 0.5 * head * uy, ty - head * uy + 0.5 * head * ux);
    context.lineTo(tx - head * ux + 0.5 * head * uy, ty - head * uy - 0.5 * head * ux);
    context.fill();
  }

  /** A block or pin between the two sides of its slot, the slot lying level. */
  #drawSlot(context, joint, state, poses) {
    const clearance = joint.clearance || 1;
    const half = 34; // [px] of the block's height
    const angle = poses[joint.first].angle + joint.direction;
    const along = (state.x ?? 0) * Math.cos(angle) + (state.y ?? 0) * Math.sin(angle);
    const across = -(state.x ?? 0) * Math.sin(angle) + (state.y ?? 0) * Math.cos(angle);
    const height = joint.block_height || 2 * (joint.journal_radius || clearance);
    this.factor = kGap / ((2 * half / height) * clearance);
    const x = Math.max(-1, Math.min(1, along / Math.max(joint.slot_length / 2, 1e-9))) * (kSlotHalf - half);
    const y = state.x === undefined ? 0 : -(across * kGap) / clearance;
    context.strokeStyle = curveColor(1 + (joint.first % 7));
    context.lineWidth = 2.5;
    for (const side of [-1, 1]) {
      context.beginPath();
      context.moveTo(-kSlotHalf, side * (half + kGap));
      context.lineTo(kSlotHalf, side * (half + kGap));
      context.stroke();
    }
    if (joint.block_length > 0) {
      context.strokeStyle = context.fillStyle = curveColor(1 + (joint.second % 7));
      context.globalAlpha = 0.22;
      context.fillRect(x - half, y - half, 2 * half, 2 * half);
      context.globalAlpha = 1;
      context.strokeRect(x - half, y - half, 2 * half, 2 * half);
    } else {
      this.#drawDisc(context, x, y, half, curveColor(1 + (joint.second % 7)));
    }
    if (!(state.normal > 0)) return;
    // The slot lies level here: the force turns with it.
    const turned = { fx: state.fx * Math.cos(angle) + state.fy * Math.sin(angle), fy: -state.fx * Math.sin(angle) + state.fy * Math.cos(angle) };
    this.#drawForce(context, x, y + (turned.fy > 0 ? half : -half), turned);
  }
}
