# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# The slider-crank of Flores and Ambrosio, two turns, without friction and with mu = 0.1.
1;
r = 0.05; l = 0.12; w = 5000 * pi / 30;
model.mass = [0.3; 0.3; 1e-5; 0.21; 0.21; 2.5e-4; 0.14; 0.14; 1e-4];
model.force = zeros (9, 1);
model.pins = [0, 0, 0, 1, 0, 0; 1, r, 0, 2, -l/2, 0];
model.fixed = [8, 0, 0; 9, 0, 0; 3, 0, w];
model.n_rows = 7;
model.alpha = 100;
model.beta = 100;
model.max_step = 0.02 * 60 / 5000;
contact.number = 1;
contact.bearing = 2;
contact.bearing_arm = [l/2; 0];
contact.journal = 3;
contact.journal_arm = [0; 0];
contact.radius = 10e-3;
contact.clearance = 0.5e-3;
contact.stiffness = 4/3 * 207e9 / (2 * (1 - 0.09)) * sqrt (10e-3 * 9.5e-3 / 0.5e-3);
contact.damping = 0.75 * (1 - 0.81);
y = [0; 0; 0; r + l/2; 0; 0; r + l; 0; 0; zeros(9, 1)];
y(9+3) = w;
y(9+5) = r * w / 2;
y(9+6) = -r * w / l;

contact.friction = @(slip) 0;
model.contacts = contact;
run_motion ("slider_crank", model, y, 2 * 60 / 5000, 1e-6);
contact.friction = @(slip) 0.1 * tanh (slip / 1e-3);
model.contacts = contact;
run_motion ("slider_crank_friction", model, y, 2 * 60 / 5000, 1e-6);
