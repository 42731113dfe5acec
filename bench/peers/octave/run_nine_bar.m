# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# The nine-bar press of the paper over a quarter of a cycle from its start with journals in the middle of their
# bearings: 24 coordinates, 20 rows.
1;
side = 0.2546;
tip = [side/2, side*sqrt(3)/2];
middle = ([side, 0] + tip) / 3;
A = [22.3093, 39.0806] / 1e3; B = [487.3576, -75.7304] / 1e3; D = [187.1338, 320.3436] / 1e3;
E = [6.5307, 499.7974] / 1e3; F = [252.2438, 566.4774] / 1e3; S = [569.8719, 460.0] / 1e3;
O1 = [0, 0]; O4 = [0.430, 0]; P6 = [-0.220, 0.460];
# first point, second point, distance of the centre of mass, mass, inertia
bars = {O1, A, 0.023, 0.148, 0.2382e-3; A, D, 0.163, 0.805, 8.001e-3; B, D, 0.249, 0.603, 13.37e-3; ...
        O4, B, 0.048, 0.265, 1.210e-3; P6, E, 0.115, 0.581, 3.802e-3; E, D, 0, 4.334, 12.12e-3; ...
        F, S, 0.168, 0.827, 8.663e-3; S, S, 0, 0.801, 1e-3};
q = zeros (24, 1);
for k = 1:8
  from = bars{k,1}; to = bars{k,2};
  angle = atan2 (to(2) - from(2), to(1) - from(1));
  arm = [bars{k,3}, 0];
  if (k == 6)
    arm = middle;
  endif
  turn = [cos(angle), -sin(angle); sin(angle), cos(angle)];
  q(3*k-2:3*k) = [from' + turn * arm'; angle];
  model.mass(3*k-2:3*k,1) = [bars{k,4}; bars{k,4}; bars{k,5}];
  model.force(3*k-2:3*k,1) = [9.81 * bars{k,4}; 0; 0];
endfor
q(3) = 60.28 * pi / 180;
q(12) = -52.86 * pi / 180;
arm = @(k, x) [x - bars{k,3}, 0];
model.pins = [0, O1, 1, arm(1, 0); 0, O4, 4, arm(4, 0); ...
              2, arm(2, 0.326), 6, [side, 0] - middle; 3, arm(3, 0.497), 6, [side, 0] - middle; ...
              0, P6, 5, arm(5, 0); 5, arm(5, 0.230), 6, -middle; 6, tip - middle, 7, arm(7, 0); ...
              7, arm(7, 0.335), 8, 0, 0];
model.fixed = [23, 0.460, 0; 24, 0, 0; 3, q(3), -2*pi; 12, q(12), 2*pi];
model.n_rows = 20;
model.alpha = 5;
model.beta = 5;
model.max_step = 0.02;
contact.radius = 15e-3;
contact.clearance = 0.5e-3;
contact.stiffness = 4/3 * 200e9 / (2 * (1 - 0.09)) * sqrt (15e-3 * 14.5e-3 / 0.5e-3);
contact.damping = 0.75 * (1 - 0.81);
contact.friction = @(slip) (0.10 + 0.05 * exp (-(slip / 1e-3) ^ 2)) * tanh (slip / 1e-4);
contact.number = 1; contact.bearing = 1; contact.bearing_arm = arm(1, 0.045)';
contact.journal = 2; contact.journal_arm = arm(2, 0)';
model.contacts = contact;
contact.number = 2; contact.bearing = 4; contact.bearing_arm = arm(4, 0.095)';
contact.journal = 3; contact.journal_arm = arm(3, 0)';
model.contacts(2) = contact;

# Velocities: those of all joints closed, clearances too.
v = zeros (24, 1);
J = zeros (24, 24);
row = 1;
pins = [model.pins; 1, arm(1, 0.045), 2, arm(2, 0); 4, arm(4, 0.095), 3, arm(3, 0)];
for k = 1:rows (pins)
  for side_of = [1, 4]
    body = pins(k,side_of);
    if (body == 0)
      continue;
    endif
    a = q(3*body);
    x = [cos(a), -sin(a); sin(a), cos(a)] * pins(k,side_of+1:side_of+2)';
    J(row:row+1,3*body-2:3*body) += (side_of - 2.5) / 1.5 * [1, 0, -x(2); 0, 1, x(1)];
  endfor
  row += 2;
endfor
right = zeros (24, 1);
for k = 1:4
  J(row,model.fixed(k,1)) = 1;
  right(row) = model.fixed(k,3);
  row++;
endfor
v = J \ right;
run_motion ("nine_bar", model, [q; v], 0.25, 1e-6);
