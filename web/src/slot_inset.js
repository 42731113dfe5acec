// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A block or a pin in its slot, the slot lying level: heights and tilt larger than they are by one factor, so that a
// corner meets its side where it does.
import { drawContact, drawDisc, drawForce, drawShape } from './inset_marks.js';
import { findPlace } from './motion.js';
import { curveColor, styleColor } from './palette.js';

const kHalfWidth = 98; // [px] of the picture
const kGap = 9; // [px] that the clearance is drawn as: more would turn a block too far for its shape
const kLeastHeight = 30; // [px] of a block: a smaller one shows no corners
const kMostHeight = 88; // [px]

/** Where the journal is in its slot: recorded, or from the poses where the joint is ideal. */
function findPosition(joint, state, poses) {
  if (state.height !== undefined) return { along: state.along, height: state.height, tilt: state.tilt };
  const [ax, ay] = findPlace(poses[joint.first], joint.first_place);
  const [bx, by] = findPlace(poses[joint.second], joint.second_place);
  const angle = poses[joint.first].angle + joint.direction;
  return { along: (bx - ax) * Math.cos(angle) + (by - ay) * Math.sin(angle), height: 0, tilt: 0 };
}

/**
 * The places of the picture, in px, y down. scale [px/m] is that of lengths, magnified [px/m] that of heights across the
 * slot; corners are the middles of the block's rounded corners: left rear, left front, right rear, right front.
 */
function layOutSlot(joint, state, poses) {
  const isBlock = joint.block_length > 0;
  const radius = joint.journal_radius || 10 * joint.clearance; // a run may hold none
  const journalHeight = isBlock ? joint.block_height : 2 * radius;
  const whole = (2 * (kHalfWidth - 4)) / joint.slot_length;
  const scale = Math.min(kMostHeight / journalHeight, Math.max(whole, kLeastHeight / journalHeight));
  const isIdeal = state.height === undefined;
  const magnified = isIdeal ? 0 : kGap / joint.clearance;
  const { along, height, tilt } = findPosition(joint, state, poses);
  // A slot longer than the picture moves under its journal.
  const fits = scale * joint.slot_length <= 2 * kHalfWidth;
  const x = fits ? scale * along : 0;
  const y = -magnified * height;
  const half = { along: joint.block_length / 2 - radius, across: joint.block_height / 2 - radius };
  const corners = isBlock ? [[-1, 1], [1, 1], [-1, -1], [1, -1]].map(([rear, left]) => {
    const [a, b] = [rear * half.along, left * half.across];
    const turn = Math.sin(tilt);
    return [x + scale * a - magnified * b * turn, y - scale * b - magnified * a * turn];
  }) : [[x, y], [x, y]];
  return {
    isBlock, isIdeal, fits, scale, x, y, corners, radius: scale * radius,
    wall: (scale * journalHeight) / 2 + (isIdeal ? 0 : kGap),
    ends: [-0.5, 0.5].map((part) => (fits ? 0 : -scale * along) + part * scale * joint.slot_length),
    factor: magnified / scale,
  };
}

/**
 * The corners that touch, with the side of each: of a side that bears force the outermost one, and further ones as many
 * as were recorded to touch.
 */
function findTouching(layout, state) {
  const { corners } = layout;
  const sides = [
    { side: 'left', force: state.left, order: layout.isBlock ? [0, 1].sort((a, b) => corners[a][1] - corners[b][1]) : [0] },
    { side: 'right', force: state.right, order: layout.isBlock ? [2, 3].sort((a, b) => corners[b][1] - corners[a][1]) : [1] },
  ].filter(({ force }) => force > 0);
  const touching = sides.map(({ side, order }) => ({ side, corner: order[0] }));
  for (const { side, order } of sides) {
    if (order.length > 1 && touching.length < state.contacts) touching.push({ side, corner: order[1] });
  }
  return touching;
}

/** The outline of a block: its corners' circles and what joins them. */
function traceBlock(context, { corners, radius }) {
  const round = [corners[0], corners[1], corners[3], corners[2]];
  context.beginPath();
  round.forEach(([x, y], k) => {
    const before = round[(k + 3) % 4];
    const after = round[(k + 1) % 4];
    // The outward normal of an edge is a quarter turn to its left, seen on the screen.
    const from = Math.atan2(y - before[1], x - before[0]) - Math.PI / 2;
    const to = Math.atan2(after[1] - y, after[0] - x) - Math.PI / 2;
    context.arc(x, y, radius, from, to);
  });
  context.closePath();
}

function drawWalls(context, layout, color) {
  context.strokeStyle = context.fillStyle = color;
  const [begin, end] = layout.ends.map((x) => Math.max(-kHalfWidth - 20, Math.min(kHalfWidth + 20, x)));
  for (const side of [-1, 1]) {
    context.globalAlpha = 0.3;
    context.fillRect(begin, side * layout.wall + (side < 0 ? -9 : 0), end - begin, 9);
    context.globalAlpha = 1;
    context.lineWidth = 1.5;
    context.beginPath();
    context.moveTo(begin, side * layout.wall);
    context.lineTo(end, side * layout.wall);
    context.stroke();
  }
  // The middle of the slot.
  context.strokeStyle = styleColor('--line');
  context.setLineDash([8, 3, 2, 3]);
  context.lineWidth = 1;
  context.beginPath();
  context.moveTo(begin, 0);
  context.lineTo(end, 0);
  context.stroke();
  context.setLineDash([]);
}

/** The force of each side at what touches it; between two corners of one side, whose shares are not recorded. */
function drawForces(context, joint, state, layout, greatest, bearingAngle) {
  const { touching } = layout;
  const sides = [...new Set(touching.map(({ side }) => side))];
  const placeOf = ({ side, corner }) => [layout.corners[corner][0], layout.corners[corner][1] + (side === 'left' ? -1 : 1) * layout.radius];
  for (const one of touching) drawContact(context, ...placeOf(one));
  for (const side of sides) {
    const places = touching.filter((one) => one.side === side).map(placeOf);
    const middle = [0, 1].map((k) => places.reduce((sum, place) => sum + place[k], 0) / places.length);
    const angle = bearingAngle + joint.direction;
    // One side: the joint's force, friction and all, turned as the slot is. Both: the normal force of each.
    const force = sides.length > 1 ? { fx: 0, fy: side === 'left' ? -state.left : state.right }
      : { fx: state.fx * Math.cos(angle) + state.fy * Math.sin(angle), fy: -state.fx * Math.sin(angle) + state.fy * Math.cos(angle) };
    drawForce(context, ...middle, force, greatest);
  }
}

/** Draws about the context's origin; returns the layout. */
export function drawSlot(context, joint, state, poses, greatest) {
  const layout = layOutSlot(joint, state, poses);
  layout.touching = layout.isIdeal ? [] : findTouching(layout, state);
  const journal = curveColor(1 + (joint.second % 7));
  drawWalls(context, layout, curveColor(1 + (joint.first % 7)));
  if (layout.isBlock) {
    traceBlock(context, layout);
    drawShape(context, journal);
    context.fillRect(layout.x - 1.5, layout.y - 1.5, 3, 3);
  } else {
    drawDisc(context, layout.x, layout.y, layout.radius, journal);
  }
  if (!layout.isIdeal) drawForces(context, joint, state, layout, greatest, poses[joint.first].angle);
  return layout;
}
