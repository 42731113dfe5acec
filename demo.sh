#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# From a fresh machine to the nine-bar press, worn twice: set-up, Release build, study, tables, report.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")"

bash setup.sh
echo "Building into build/"
bash scripts/build.sh build gudgeon -DCMAKE_BUILD_TYPE=Release
echo "Running the nine-bar press: build/gudgeon run examples/nine_bar/nine_bar.toml --overwrite --report"
exec build/gudgeon run examples/nine_bar/nine_bar.toml --overwrite --report
