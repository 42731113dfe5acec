#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# Draws docs/gallery/ again: the nine-bar press, one small figure of each kind from a short run of it and of a slider in
# a loose guide, and a picture of the press's report.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

bash setup.sh
bash scripts/build.sh build gudgeon -DCMAKE_BUILD_TYPE=Release
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
model=examples/nine_bar/nine_bar.toml
gallery=docs/gallery

build/gudgeon draw "$model" -o "$gallery/nine_bar.svg" --trace panel_7.D --overwrite >"$work/log"
build/gudgeon run "$model" -o "$work/runs" --case base --case clearance_0_3 --case clearance_0_8 --quiet --report \
  --set study.cycles=6 --set study.wear_acceleration=3000 >>"$work/log"
wanted=(
  base.A.wear_depth base.A.surfaces base.A.journal_surface
  base.slider_9.x_acceleration base.slider_9.x_velocity.error base.crank_4.effort
  base.B.normal_force base.B.orbit base.B.phase_x base.B.poincare_x A.wear_depth_over_clearance
)
build/gudgeon plot "$work/runs" -o "$gallery" "${wanted[@]/#/--figure=}" --cycles 1 --overwrite >>"$work/log"
build/gudgeon run examples/slider_crank_guide.toml -o "$work/guide" --quiet >>"$work/log"
build/gudgeon plot "$work/guide" -o "$gallery/slot" --figure=guide.wear_depth --figure=guide.journal_surface \
  --figure=guide.orbit --figure=guide.phase_tilt --overwrite >>"$work/log"
GUDGEON_WEB_PACKAGES="$PWD/build/web" GUDGEON_CHROMIUM="$(command -v chromium)" \
  node web/picture.mjs "$work/runs/report.html" "$gallery/report.png"
ls "$gallery"
