#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# GNU Octave's ode15s on the slider-crank and the nine-bar, as CSV: case,tolerance,horizon_s,seconds,evaluations,onsets.
# Installs Octave when it is missing. Horizons are shortened: ode15s takes minutes for what gudgeon does in
# milliseconds; time over horizon is what is compared.
#   bash bench/peers/octave/run.sh > bench/baselines/octave.csv
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")"

if ! command -v octave-cli >/dev/null; then
  as_root=()
  if ((EUID != 0)); then as_root=(sudo); fi
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends octave >&2
fi
echo "# $(octave-cli --version | head -n 1)"
echo "case,tolerance,horizon_s,seconds,evaluations,onsets"
octave-cli --quiet --no-gui --no-init-file run_slider_crank.m
octave-cli --quiet --no-gui --no-init-file run_nine_bar.m
