#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# make_shell_files.sh PROGRAM DIRECTORY: the program's manual page and completions, from its own help, into
# DIRECTORY: gudgeon.1, gudgeon.bash, _gudgeon.
set -euo pipefail

program="$1"
directory="$2"
here="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)"
table="$(mktemp)"
trap 'rm -f "$table"' EXIT
export LC_ALL=C

"$program" --help | awk -v command= -f "$here/help_entries.awk" >"$table"
mapfile -t commands < <(awk -F '\t' '$2 == "subcommand" { print $3 }' "$table")
for command in "${commands[@]}"; do
  "$program" "$command" --help | awk -v command="$command" -f "$here/help_entries.awk" >>"$table"
done
version="$("$program" --version)"
mkdir -p "$directory"
awk -v version="${version#gudgeon }" -f "$here/man_page.awk" "$table" >"$directory/gudgeon.1"
awk -f "$here/bash_completion.awk" "$table" >"$directory/gudgeon.bash"
awk -f "$here/zsh_completion.awk" "$table" >"$directory/_gudgeon"
