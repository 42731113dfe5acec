# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# ode15s from one contact change to the next, the onset speed latched there.
function run_with_events (name, model, y, horizon, tolerance)
  global n_evaluations latched onset_speed
  n_evaluations = 0;
  n_events = 0;
  n_contacts = numel (model.contacts);
  latched = false (1, n_contacts);
  onset_speed = zeros (1, n_contacts);
  t = 0;
  start = cputime ();
  while (t < horizon)
    options = odeset ("RelTol", tolerance, "AbsTol", 0.01 * tolerance, "Events", @(t, y) watch (t, y, model), ...
                      "MaxStep", model.max_step);
    [times, states, te, ye, ie] = ode15s (@(t, y) maximal_slope (t, y, model), [t, horizon], y, options);
    y = states(end,:)';
    t = times(end);
    if (t >= horizon)
      break;
    endif
    k = ie(end);
    n_events++;
    if (latched(k))
      latched(k) = false;
    else
      [~, rate] = gap_of (y, model, k);
      latched(k) = true;
      onset_speed(k) = rate;
    endif
  endwhile
  printf ("%s,%g,%g,%.6g,%d,%d\n", name, tolerance, t, cputime () - start, n_evaluations, n_events);
endfunction

function [value, terminal, direction] = watch (t, y, model)
  global latched
  n = numel (model.contacts);
  value = zeros (n, 1);
  direction = zeros (n, 1);
  for k = 1:n
    value(k) = gap_of (y, model, k);
    direction(k) = ifelse_sign (latched(k));
  endfor
  terminal = ones (n, 1);
endfunction

function d = ifelse_sign (in_contact)
  d = 1;
  if (in_contact)
    d = -1;
  endif
endfunction

function [depth, rate] = gap_of (y, model, k)
  contact = model.contacts(k);
  n = numel (model.mass);
  [pb, vb] = place (y, n, contact.bearing, contact.bearing_arm);
  [pj, vj] = place (y, n, contact.journal, contact.journal_arm);
  e = pj - pb;
  depth = norm (e) - contact.clearance;
  rate = 0;
  if (norm (e) > 0)
    rate = e' * (vj - vb) / norm (e);
  endif
endfunction

function [p, v] = place (y, n, body, arm)
  i = 3 * body - 2;
  c = cos (y(i+2));
  s = sin (y(i+2));
  r = [c, -s; s, c] * arm;
  p = y(i:i+1) + r;
  v = y(n+i:n+i+1) + y(n+i+2) * [-r(2); r(1)];
endfunction
