// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The linkage on a canvas: bodies by their points, joints, guides, the ideal mechanism as a ghost, a traced point.
import { prepareCanvas } from './elements.js';
import { findPlace } from './motion.js';
import { printNumber } from './number_text.js';
import { curveColor, styleColor } from './palette.js';

const kBar = 11; // [px]
const kMostSamples = 400; // for bounds and traces: more cannot be told apart on the screen

/** Corners of the convex hull, counter-clockwise. */
function findHull(points) {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const cross = (o, a, b) => (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
  const half = (list) => {
    const hull = [];
    for (const p of list) {
      while (hull.length > 1 && cross(hull.at(-2), hull.at(-1), p) <= 0) hull.pop();
      hull.push(p);
    }
    return hull.slice(0, -1);
  };
  return sorted.length < 3 ? sorted : [...half(sorted), ...half(sorted.reverse())];
}

export class LinkageView {
  constructor(canvas, scene) {
    this.canvas = canvas;
    this.scene = scene;
    this.blocks = new Set(scene.joints.filter((joint) => joint.kind.startsWith('prismatic')).map((joint) => joint.second));
  }

  /** The view that holds the whole motion. */
  fit(motion) {
    const box = { x0: Infinity, x1: -Infinity, y0: Infinity, y1: -Infinity };
    const step = Math.max(1, Math.floor(motion.times.length / kMostSamples));
    for (let k = 0; k < motion.times.length; k += step) {
      const poses = motion.findPoses(motion.times[k]);
      this.scene.bodies.forEach((body, b) => {
        if (!body.frame) for (const point of body.points) this.#hold(box, findPlace(poses[b], point.place));
      });
      for (const joint of this.scene.joints) if (joint.slot_length > 0) this.#holdSlot(box, joint, poses);
    }
    for (const joint of this.scene.joints) {
      if (this.scene.bodies[joint.first].frame && !joint.kind.startsWith('prismatic')) this.#hold(box, joint.first_place);
      if (this.scene.bodies[joint.second].frame) this.#hold(box, joint.second_place);
    }
    this.box = box;
    this.trace = null;
  }

  #hold(box, [x, y]) {
    box.x0 = Math.min(box.x0, x);
    box.x1 = Math.max(box.x1, x);
    box.y0 = Math.min(box.y0, y);
    box.y1 = Math.max(box.y1, y);
  }

  #holdSlot(box, joint, poses) {
    const [x, y] = findPlace(poses[joint.first], joint.first_place);
    const angle = poses[joint.first].angle + joint.direction;
    for (const half of [-joint.slot_length / 2, joint.slot_length / 2]) this.#hold(box, [x + half * Math.cos(angle), y + half * Math.sin(angle)]);
  }

  resize(width) {
    this.width = width;
    const { x0, x1, y0, y1 } = this.box;
    const ratio = (y1 - y0) / Math.max(x1 - x0, 1e-12);
    this.height = Math.round(Math.min(520, Math.max(220, width * Math.min(1, ratio + 0.15))));
  }

  #place([x, y]) {
    const { x0, x1, y0, y1 } = this.box;
    const margin = 44;
    const scale = Math.min((this.width - 2 * margin) / Math.max(x1 - x0, 1e-9), (this.height - 2 * margin) / Math.max(y1 - y0, 1e-9));
    this.scale = scale;
    return [this.width / 2 + scale * (x - (x0 + x1) / 2), this.height / 2 - scale * (y - (y0 + y1) / 2)];
  }

  /** moment: { motion, time, ghost: a motion or null, traced: { body, point } or null }. */
  draw({ motion, time, ghost, traced }) {
    const context = prepareCanvas(this.canvas, this.width, this.height);
    context.lineJoin = context.lineCap = 'round';
    const poses = motion.findPoses(time);
    this.#place([0, 0]);
    this.#drawGuides(context, poses);
    if (traced) this.#drawTrace(context, motion, traced, poses);
    if (ghost) this.#drawGhost(context, ghost.findPoses(ghost.matchTime(time)));
    this.scene.bodies.forEach((body, b) => body.frame || this.#drawBody(context, body, b, poses[b]));
    this.scene.joints.forEach((joint) => this.#drawJoint(context, joint, poses));
    if (traced) this.#drawTracedPoint(context, traced, poses);
    this.#drawScale(context);
  }

  #path(context, corners) {
    context.beginPath();
    corners.forEach(([x, y], k) => (k ? context.lineTo(x, y) : context.moveTo(x, y)));
    if (corners.length > 2) context.closePath();
  }

  #findCorners(body, pose) {
    return findHull(body.points.map((point) => this.#place(findPlace(pose, point.place))));
  }

  #drawBody(context, body, b, pose) {
    const corners = this.#findCorners(body, pose);
    if (this.blocks.has(b) && corners.length < 2) {
      const joint = this.scene.joints.find((one) => one.kind.startsWith('prismatic') && one.second === b);
      this.#drawBlock(context, corners[0], this.guideAngles.get(joint), curveColor(1 + (b % 7)));
      return;
    }
    context.strokeStyle = context.fillStyle = curveColor(1 + (b % 7));
    this.#path(context, corners);
    context.globalAlpha = 0.28;
    context.lineWidth = kBar;
    context.stroke();
    if (corners.length > 2) context.fill();
    context.globalAlpha = 1;
    context.lineWidth = 1.6;
    context.stroke();
  }

  #drawBlock(context, [x, y], angle, color) {
    context.save();
    context.translate(x, y);
    context.rotate(-angle);
    context.fillStyle = styleColor('--paper');
    context.strokeStyle = color;
    context.lineWidth = 1.6;
    context.beginPath();
    context.rect(-18, -10, 36, 20);
    context.fill();
    context.globalAlpha = 0.28;
    context.fillStyle = color;
    context.fill();
    context.globalAlpha = 1;
    context.stroke();
    context.restore();
  }

  #drawGuides(context, poses) {
    this.guideAngles = new Map();
    context.strokeStyle = styleColor('--line');
    context.lineWidth = 1.5;
    for (const joint of this.scene.joints) {
      if (!joint.kind.startsWith('prismatic') && !joint.kind.startsWith('pin_in_slot')) continue;
      const angle = poses[joint.first].angle + joint.direction;
      this.guideAngles.set(joint, angle);
      const [x, y] = this.#place(findPlace(poses[joint.second], joint.second_place));
      const reach = this.scene.bodies[joint.first].frame ? Math.max(this.width, this.height) : 60;
      const origin = reach > 60 ? [x, y] : this.#place(findPlace(poses[joint.first], joint.first_place));
      if (joint.slot_length > 0) {
        this.#drawSlot(context, joint, poses, angle);
        continue;
      }
      context.setLineDash([6, 4]);
      this.#path(context, [[origin[0] - reach * Math.cos(angle), origin[1] + reach * Math.sin(angle)], [origin[0] + reach * Math.cos(angle), origin[1] - reach * Math.sin(angle)]]);
      context.stroke();
      context.setLineDash([]);
    }
  }

  /** The sides of a slot with clearance, as long and as far apart as they are. */
  #drawSlot(context, joint, poses, angle) {
    const [x, y] = this.#place(findPlace(poses[joint.first], joint.first_place));
    const half = this.scale * (joint.slot_length / 2);
    const wall = this.scale * ((joint.block_height || 2 * joint.journal_radius) / 2 + joint.clearance);
    context.save();
    context.translate(x, y);
    context.rotate(-angle);
    for (const side of [-wall, wall]) {
      this.#path(context, [[-half, side], [half, side]]);
      context.stroke();
    }
    context.restore();
  }

  /** A block or pin with clearance, in its size. */
  #drawLooseBlock(context, joint, [x, y]) {
    const angle = this.guideAngles.get(joint);
    const [length, height] = [joint.block_length, joint.block_height].map((size) => this.scale * size);
    context.save();
    context.translate(x, y);
    context.rotate(-angle);
    context.beginPath();
    if (length > 0) context.roundRect(-length / 2, -height / 2, length, height, this.scale * (joint.journal_radius || 0));
    else context.arc(0, 0, this.scale * joint.journal_radius, 0, 2 * Math.PI);
    context.fillStyle = curveColor(1 + (joint.second % 7));
    context.globalAlpha = 0.18;
    context.fill();
    context.globalAlpha = 1;
    context.strokeStyle = styleColor('--clearance');
    context.lineWidth = 1.8;
    context.stroke();
    context.restore();
  }

  #drawGhost(context, poses) {
    context.strokeStyle = curveColor(0);
    context.lineWidth = 1;
    context.setLineDash([3, 3]);
    this.scene.bodies.forEach((body, b) => {
      if (body.frame) return;
      this.#path(context, this.#findCorners(body, poses[b]));
      context.stroke();
    });
    context.setLineDash([]);
  }

  #drawJoint(context, joint, poses) {
    if (joint.kind === 'prismatic') return;
    const [x, y] = this.#place(findPlace(poses[joint.second], joint.second_place));
    const onFrame = this.scene.bodies[joint.first].frame || this.scene.bodies[joint.second].frame;
    if (onFrame && joint.kind === 'revolute') this.#drawSupport(context, x, y);
    const isClear = joint.kind.endsWith('_clearance');
    if (joint.slot_length > 0) {
      this.#drawLooseBlock(context, joint, [x, y]);
    } else {
      context.fillStyle = styleColor('--paper');
      context.strokeStyle = isClear ? styleColor('--clearance') : styleColor('--ink');
      context.lineWidth = isClear ? 2.4 : 1.5;
      context.beginPath();
      context.arc(x, y, isClear ? 7 : 4, 0, 2 * Math.PI);
      context.fill();
      context.stroke();
    }
    if (isClear) this.#drawName(context, joint.name, x, y);
  }

  #drawName(context, name, x, y) {
    context.font = 'bold 13px system-ui, sans-serif';
    context.fillStyle = styleColor('--clearance');
    context.strokeStyle = styleColor('--paper');
    context.lineWidth = 3;
    context.textAlign = 'left';
    context.strokeText(name, x + 11, y - 9);
    context.fillText(name, x + 11, y - 9);
  }

  #drawSupport(context, x, y) {
    context.strokeStyle = styleColor('--ink');
    context.fillStyle = styleColor('--grid');
    context.lineWidth = 1.5;
    this.#path(context, [[x, y], [x - 10, y + 17], [x + 10, y + 17]]);
    context.fill();
    context.stroke();
  }

  #drawTrace(context, motion, traced) {
    if (this.trace?.motion !== motion || this.trace.point !== traced.point || this.trace.width !== this.width) {
      const step = Math.max(1, Math.floor(motion.times.length / (4 * kMostSamples)));
      const places = [];
      for (let k = 0; k < motion.times.length; k += step) {
        places.push(this.#place(findPlace(motion.findPoses(motion.times[k])[traced.body], traced.point.place)));
      }
      this.trace = { motion, point: traced.point, width: this.width, places };
    }
    context.strokeStyle = styleColor('--accent');
    context.lineWidth = 1.2;
    context.beginPath();
    this.trace.places.forEach(([x, y], k) => (k ? context.lineTo(x, y) : context.moveTo(x, y)));
    context.stroke();
  }

  #drawTracedPoint(context, traced, poses) {
    const [x, y] = this.#place(findPlace(poses[traced.body], traced.point.place));
    context.fillStyle = styleColor('--accent');
    context.beginPath();
    context.arc(x, y, 4.5, 0, 2 * Math.PI);
    context.fill();
  }

  /** A round length at the lower left. */
  #drawScale(context) {
    const wanted = 90 / this.scale;
    const decade = 10 ** Math.floor(Math.log10(wanted));
    const length = [5, 2, 1].map((part) => part * decade).find((one) => one <= wanted);
    const y = this.height - 14;
    context.strokeStyle = context.fillStyle = styleColor('--ink');
    context.lineWidth = 1.5;
    context.beginPath();
    context.moveTo(14, y - 4);
    context.lineTo(14, y);
    context.lineTo(14 + length * this.scale, y);
    context.lineTo(14 + length * this.scale, y - 4);
    context.stroke();
    context.font = '12px system-ui, sans-serif';
    context.textAlign = 'left';
    context.fillText(length < 1 ? `${printNumber(length * 1000)} mm` : `${printNumber(length)} m`, 20 + length * this.scale, y);
  }
}
