# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# The paper's eq. (24): [M Phi_q'; Phi_q 0] [q''; lambda] = [Q; gamma - 2 alpha Phi' - beta^2 Phi] in maximal
# coordinates, solved with the backslash. model holds masses, joints, contacts and drivers by number.
function slope = maximal_slope (t, y, model)
  global n_evaluations
  n_evaluations++;
  n = numel (model.mass);
  q = y(1:n);
  v = y(n+1:2*n);
  Q = model.force;
  for k = 1:numel (model.contacts)
    Q = add_contact (Q, q, v, model.contacts(k));
  endfor

  m = model.n_rows;
  J = zeros (m, n);
  gamma = zeros (m, 1);
  gap = zeros (m, 1);
  row = 1;
  for k = 1:rows (model.pins)  # body, arm, body, arm; body 0 is the frame
    [p1, v1, a1, J1] = point_of (q, v, model.pins(k,1), model.pins(k,2:3)', n);
    [p2, v2, a2, J2] = point_of (q, v, model.pins(k,4), model.pins(k,5:6)', n);
    J(row:row+1,:) = J2 - J1;
    gap(row:row+1) = p2 - p1;
    gamma(row:row+1) = a1 - a2;  # centripetal parts
    row += 2;
  endfor
  for k = 1:rows (model.fixed)  # coordinate, value, speed
    c = model.fixed(k,1);
    J(row,c) = 1;
    gap(row) = q(c) - model.fixed(k,2) - model.fixed(k,3) * t;
    row++;
  endfor
  gap_rate = J * v;
  gap_rate(end-rows (model.fixed)+1:end) -= model.fixed(:,3);
  gamma -= 2 * model.alpha * gap_rate + model.beta ^ 2 * gap;

  x = [diag(model.mass), J'; J, zeros(m)] \ [Q; gamma];
  slope = [v; x(1:n)];
endfunction

function [p, velocity, centripetal, J] = point_of (q, v, body, arm, n)
  J = zeros (2, n);
  if (body == 0)
    p = arm;
    velocity = [0; 0];
    centripetal = [0; 0];
    return;
  endif
  i = 3 * body - 2;
  c = cos (q(i+2));
  s = sin (q(i+2));
  r = [c, -s; s, c] * arm;
  p = q(i:i+1) + r;
  J(:,i:i+2) = [1, 0, -r(2); 0, 1, r(1)];
  velocity = v(i:i+1) + v(i+2) * [-r(2); r(1)];
  centripetal = -v(i+2) ^ 2 * r;
endfunction

# Lankarani-Nikravesh and the contact's friction, surfaces unworn. Until a step has been accepted in contact, the
# speed now stands for the speed at onset.
function Q = add_contact (Q, q, v, contact)
  global latched onset_speed
  n = numel (Q);
  [pb, vb, ~, Jb] = point_of (q, v, contact.bearing, contact.bearing_arm, n);
  [pj, vj, ~, Jj] = point_of (q, v, contact.journal, contact.journal_arm, n);
  e = pj - pb;
  depth = norm (e) - contact.clearance;
  if (depth <= 0)
    return;
  endif
  normal = e / norm (e);
  tangent = [-normal(2); normal(1)];
  rate = normal' * (vj - vb);
  onset = max (rate, 1e-3);
  if (latched(contact.number))
    onset = max (onset_speed(contact.number), 1e-3);
  endif
  force = max (contact.stiffness * depth ^ 1.5 * (1 + contact.damping * rate / onset), 0);
  lever_j = contact.radius - contact.clearance - depth / 2;
  lever_b = norm (e) + lever_j;
  slip = tangent' * (vj - vb) + v(3*contact.journal) * lever_j - v(3*contact.bearing) * lever_b;
  drag = contact.friction (slip) * force;
  pressure = -force * normal - drag * tangent;
  Q += (Jj - Jb)' * pressure;
  Q(3*contact.journal) -= drag * lever_j;
  Q(3*contact.bearing) += drag * lever_b;
endfunction
