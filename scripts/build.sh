#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# build.sh DIRECTORY "TARGET ..." [cmake options]: configures and builds, silent unless something goes wrong.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

directory="$1"
read -ra targets <<<"$2"
shift 2
log="$(mktemp)"
trap 'rm -f "$log"' EXIT
if ! cmake -S . -B "$directory" -G Ninja "$@" >"$log" 2>&1; then
  cat "$log" >&2
  exit 1
fi
if [[ -t 1 ]]; then
  cmake --build "$directory" --target "${targets[@]}"
elif ! cmake --build "$directory" --target "${targets[@]}" >"$log" 2>&1; then
  cat "$log" >&2
  exit 1
fi
