#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# Set-up, the whole suite on a Release build, then once more under ASan and UBSan.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")"

bash setup.sh
echo "Building into build/"
bash scripts/build.sh build all -DCMAKE_BUILD_TYPE=Release -DGUDGEON_BUILD_BENCH=ON
bash scripts/build.sh build all_verify_interface_header_sets
echo "Testing"
ctest --test-dir build --output-on-failure --progress -j2

echo "Building into build-asan/ with sanitizers"
bash scripts/build.sh build-asan all -DCMAKE_BUILD_TYPE=Debug '-DCMAKE_CXX_FLAGS_DEBUG=-O1 -g1' -DGUDGEON_SANITIZE=ON
echo "Testing with sanitizers"
ctest --test-dir build-asan --output-on-failure --progress -j2
