// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Short runs made by the program itself, their reports, and their numbers by way of `gudgeon export`.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

export const folder = mkdtempSync(join(tmpdir(), 'gudgeon_page_'));
export const removeFolder = () => rmSync(folder, { recursive: true, force: true });

const source = process.env.GUDGEON_SOURCE_DIR;

export function gudgeon(...words) {
  return execFileSync(process.env.GUDGEON_PROGRAM, words, { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
}

/** Runs a model and writes its report; returns the report's path. A run that fails on purpose may do so. */
export function makeReport(model, name, settings = [], { cases = [], mayFail = false } = {}) {
  const words = [...settings.flatMap((one) => ['--set', one]), ...cases.flatMap((one) => ['--case', one])];
  try {
    gudgeon('run', model, '-o', name, '--quiet', ...words);
  } catch (error) {
    if (!mayFail) throw error;
  }
  gudgeon('report', name);
  return join(folder, name, 'report.html');
}

export const findExample = (name) => join(source, 'examples', name);

/** A column of numbers by the start of its name, from a file that `gudgeon export` wrote. */
export function readColumn(directory, file, start) {
  const [header, ...rows] = readFileSync(join(folder, directory, file), 'utf8').trim().split('\n').map((row) => row.split(','));
  const k = header.findIndex((column) => column.startsWith(start));
  return rows.map((row) => row[k]);
}

/** Twelve rods, each hung in a joint with clearance of its own size. */
export function writeTwelveJoints() {
  const all = Array.from({ length: 12 }, (unused, k) => k);
  const file = join(folder, 'twelve.toml');
  writeFileSync(file, `name = "twelve"
gravity = [0, "-9.81 m/s^2"]
[bodies.frame]
${all.map((k) => `points.P${k} = ["${200 * k} mm", 0]`).join('\n')}
${all.map((k) => `[bodies.rod_${k}]
mass = "0.5 kg"
inertia = "1e-3 kg m^2"
center_of_mass = ["100 mm", 0]
points = { P = [0, 0], Q = ["200 mm", 0] }
start = { angle = "${-30 - 5 * k} deg" }
[joints.J${k}]
type = "revolute_clearance"
bearing = "frame.P${k}"
journal = "rod_${k}.P"
bearing_radius = "10 mm"
radial_clearance = "${(0.2 + 0.01 * k).toFixed(2)} mm"
width = "15 mm"
contact = "steel"`).join('\n')}
[materials.steel]
young_modulus = "200 GPa"
poisson_ratio = 0.3
[contacts.steel]
bearing_material = "steel"
journal_material = "steel"
normal_force = { law = "lankarani_nikravesh", restitution = 0.8, exponent = 1.5 }
friction = { law = "frictionless" }
wear = { law = "archard", coefficient = "1e-13 1/Pa" }
[study]
cycle_time = "100 ms"
cycles = 1
outputs_per_cycle = 200
wear_stages = 1
wear_acceleration = 1000
cells = 90
compare_ideal = false
`);
  return file;
}

/** A slider-crank whose load has no value after 0.7 s. */
export function writeFailing() {
  const file = join(folder, 'failing.toml');
  writeFileSync(file, `${readFileSync(join(source, 'tests/app/slider_crank.toml'), 'utf8')}
[loads.pull]
point = "slider.S"
force = ["f * ln(1 - t / last)", 0]
constants = { f = "1 mN", last = "0.7 s" }
`);
  return file;
}

/** The slider-crank with names and texts of five hundred letters wherever a model has them. */
export function writeLongWords() {
  const word = (letter) => letter.repeat(500);
  const file = join(folder, 'long_words.toml');
  const text = readFileSync(join(source, 'tests', 'app', 'slider_crank.toml'), 'utf8')
    .replace('name = "slider_crank"', `name = "${word('n')}"\ndescription = "${word('d')}"`)
    .replaceAll('[joints.pin]', `[joints.${word('p')}]`).replaceAll('joints.pin.', `joints.${word('p')}.`)
    .replaceAll('motor', word('m')).replace('[bodies.rod]', `[bodies.${word('r')}]`).replaceAll('"rod.', `"${word('r')}.`)
    .replace('twice the clearance', word('c'));
  writeFileSync(file, text);
  return file;
}
