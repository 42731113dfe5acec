#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# Runs the verification tests of the Release build and writes docs/verification.md from what they checked.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

bash scripts/build.sh build verification_tests -DCMAKE_BUILD_TYPE=Release
bash scripts/build.sh build verification_book
rm -rf build/verification_entries
build/verification_tests --gtest_brief=1
build/verification_book render >docs/verification.md
