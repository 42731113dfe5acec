# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# One call of ode15s; contacts are looked at after every accepted step, where an onset speed is kept.
function run_motion (name, model, y, horizon, tolerance)
  global n_evaluations n_onsets latched onset_speed
  n_evaluations = 0;
  n_onsets = 0;
  latched = false (1, numel (model.contacts));
  onset_speed = zeros (1, numel (model.contacts));
  start = cputime ();
  options = odeset ("RelTol", tolerance, "AbsTol", 0.01 * tolerance, "MaxStep", model.max_step, ...
                    "InitialSlope", maximal_slope (0, y, model), "InitialStep", 1e-6, ...
                    "OutputFcn", @(t, y, flag) note_contacts (t, y, flag, model));
  [times, states] = ode15s (@(t, y) maximal_slope (t, y, model), [0, horizon], y, options);
  printf ("%s,%g,%g,%.6g,%d,%d\n", name, tolerance, times(end), cputime () - start, n_evaluations, n_onsets);
endfunction

function stop = note_contacts (t, y, flag, model)
  global n_onsets latched onset_speed
  stop = false;
  if (! isempty (flag))
    return;
  endif
  y = y(:,end);
  for k = 1:numel (model.contacts)
    [depth, rate] = gap_of (y, model, k);
    if (depth > 0 && ! latched(k))
      onset_speed(k) = rate;
      n_onsets++;
    endif
    latched(k) = depth > 0;
  endfor
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
