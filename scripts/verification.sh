#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# Runs the verification tests and the tests of faults of the Release build and writes docs/verification.md from what they
# checked.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

bash scripts/build.sh build "verification_tests io_tests app_tests verification_book" -DCMAKE_BUILD_TYPE=Release
rm -rf build/verification_entries
build/verification_tests --gtest_brief=1
faults="$(paste -sd : tests/verification/fault_tests.txt)"
for tests in io app; do build/${tests}_tests --gtest_brief=1 --gtest_filter="$faults"; done
build/verification_book render >docs/verification.md
