// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What insets of bearings and of slots have in common: shapes, marks that turn, contact points with their force.
import { styleColor } from './palette.js';

const kLongest = 56; // [px] of the greatest force

/** Fills and outlines the context's path: a body. */
export function drawShape(context, color) {
  context.fillStyle = context.strokeStyle = color;
  context.globalAlpha = 0.22;
  context.fill();
  context.globalAlpha = 1;
  context.lineWidth = 1.5;
  context.stroke();
}

export function drawDisc(context, x, y, radius, color) {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  drawShape(context, color);
  context.fillRect(x - 1.5, y - 1.5, 3, 3);
}

/** A line that turns with its body. */
export function drawMark(context, x, y, from, to, angle, color) {
  context.strokeStyle = color;
  context.lineWidth = 2;
  context.beginPath();
  context.moveTo(x + from * Math.cos(angle), y - from * Math.sin(angle));
  context.lineTo(x + to * Math.cos(angle), y - to * Math.sin(angle));
  context.stroke();
}

export function drawContact(context, x, y) {
  context.fillStyle = styleColor('--clearance');
  context.beginPath();
  context.arc(x, y, 4, 0, 2 * Math.PI);
  context.fill();
}

/** An arrow from a place, as long as the square root of the force's share of the greatest. */
export function drawForce(context, x, y, { fx, fy }, greatest) {
  const force = Math.hypot(fx, fy);
  if (!(force > 0) || !(greatest > 0)) return;
  context.fillStyle = context.strokeStyle = styleColor('--clearance');
  const length = kLongest * Math.min(1, Math.sqrt(force / greatest));
  const [ux, uy] = [fx / force, -fy / force];
  const [tx, ty] = [x + length * ux, y + length * uy];
  const head = Math.min(9, length);
  context.lineWidth = 2.5;
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(tx - 0.8 * head * ux, ty - 0.8 * head * uy);
  context.stroke();
  context.beginPath();
  context.moveTo(tx, ty);
  context.lineTo(tx - head * ux - 0.5 * head * uy, ty - head * uy + 0.5 * head * ux);
  context.lineTo(tx - head * ux + 0.5 * head * uy, ty - head * uy - 0.5 * head * ux);
  context.fill();
}
