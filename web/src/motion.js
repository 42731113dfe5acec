// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The recorded motion of one stage: where every body is at any time of its full samples.
import { readBlock } from './data.js';
import { findSample } from './plane_chart.js';

export class Motion {
  /** raw: an entry of a case's motions. */
  constructor(raw, scene) {
    this.raw = raw;
    this.scene = scene;
    this.times = readBlock(raw.time);
    this.begin = this.times[0];
    this.end = this.times[this.times.length - 1];
    this.cycleTime = raw.cycle_time;
  }

  /** Values of an entry's channels at a time, between samples in proportion; undefined where nothing was recorded. */
  #find(blocks, name, time) {
    if (blocks[name] === undefined) return undefined;
    const values = readBlock(blocks[name]);
    const k = findSample(this.times, time);
    if (k + 1 >= values.length) return values[k];
    const part = Math.min(1, Math.max(0, (time - this.times[k]) / (this.times[k + 1] - this.times[k])));
    return values[k] + part * (values[k + 1] - values[k]);
  }

  /** { x, y, angle } of each body; the frame rests. */
  findPoses(time) {
    return this.scene.bodies.map((body, b) => {
      if (body.frame) return { x: 0, y: 0, angle: 0 };
      const blocks = this.raw.bodies[b];
      return { x: this.#find(blocks, 'x', time) ?? 0, y: this.#find(blocks, 'y', time) ?? 0, angle: this.#find(blocks, 'angle', time) ?? 0 };
    });
  }

  /** Journal offset of a bearing, place and tilt in a slot, and forces; offset and height are undefined without clearance. */
  findJoint(j, time) {
    const blocks = this.raw.joints[j];
    const find = (name) => this.#find(blocks, name, time);
    return {
      x: find('x_offset'), y: find('y_offset'), fx: find('x_force') ?? 0, fy: find('y_force') ?? 0, normal: find('normal_force') ?? 0,
      along: find('displacement'), height: find('height'), tilt: find('tilt') ?? 0, left: find('left_force') ?? 0,
      right: find('right_force') ?? 0, contacts: Math.ceil(find('n_contacts') ?? 0),
    };
  }

  /** The time of the same place in the cycle within these samples, for motions that are shown beside another. */
  matchTime(time) {
    if (time >= this.begin && time <= this.end) return time;
    const cycle = this.cycleTime;
    if (!(cycle > 0) || this.end - this.begin < cycle * 0.999) return Math.min(this.end, Math.max(this.begin, time));
    const turns = Math.ceil((time - this.end) / cycle);
    return Math.min(this.end, Math.max(this.begin, time - turns * cycle));
  }
}

/** A place of a body in the frame, [x, y] in m. */
export function findPlace(pose, [x, y]) {
  const c = Math.cos(pose.angle);
  const s = Math.sin(pose.angle);
  return [pose.x + c * x - s * y, pose.y + s * x + c * y];
}
