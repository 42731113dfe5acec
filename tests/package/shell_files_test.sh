#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# shell_files_test.sh PROGRAM DIRECTORY: the manual page and the completions in the directory have every command and
# every option that the program's help has, under its command; the one for bash completes.
set -euo pipefail

program="$1"
directory="$2"
n_failures=0

fail() {
  echo "shell_files_test.sh: $1" >&2
  n_failures=$((n_failures + 1))
}

man_page="$(sed 's/\\-/-/g' "$directory/gudgeon.1")"
zsh_file="$(<"$directory/_gudgeon")"
# The lines about one command.
man_part() { awk -v from=".SS gudgeon $1 " '/^\.S[SH]/ { on = index($0, from) == 1 } on' <<<"$man_page"; }
zsh_part() { awk -v from="      $1) _arg" '/^      [a-z]+\) _arg/ { on = index($0, from) == 1 } on' <<<"$zsh_file"; }

# complete WORD...: what bash offers for the last of them.
complete_words() {
  bash -c 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _gudgeon; printf "%s\n" "${COMPREPLY[@]}"' \
    bash "$directory/gudgeon.bash" gudgeon "$@"
}

# has_word WORD LINES, each a word
has_word() { [[ $'\n'"$2"$'\n' == *$'\n'"$1"$'\n'* ]]; }

n_options=0
commands="$("$program" --help | awk '/^[A-Z]/ { on = /^Subcommands:/ } on && /^  [a-z]/ { print $1 }')"
offered="$(complete_words '')"
(($(wc -w <<<"$commands") >= 10)) || fail "the help has only the commands $commands"
for command in $commands; do
  page="$(man_part "$command" | sed -n 's/^\\fB\(.*\)\\fR.*/\1/p' | sed 's/\\fR.*//; s/, /\n/g')"
  zsh_names="$(zsh_part "$command" | sed -n "s/^ *'[^']*'{*\([-a-z,]*\)}*'\[.*/\1/p" | tr , '\n')"
  bash_names="$(complete_words "$command" -)"
  has_word "$command" "$offered" || fail "bash does not know $command"
  names="$("$program" "$command" --help | awk '/^[A-Z]/ { on = /^Options:/ } on && /^  -/ { print $1 }' | tr , '\n')"
  for name in $names; do
    n_options=$((n_options + 1))
    has_word "$name" "$page" || fail "the manual page lacks $command $name"
    has_word "$name" "$zsh_names" || fail "zsh does not know $command $name"
    has_word "$name" "$bash_names" || fail "bash does not know $command $name"
  done
done
((n_options > 40)) || fail "the help has only $n_options options"

scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT
mkdir "$scratch/a directory"
touch "$scratch/press.toml" "$scratch/base.h5" "$scratch/note.txt"
cd "$scratch"
[[ "$(complete_words run '')" == $'a directory\npress.toml' ]] || fail "bash offers other files than models to run"
[[ "$(complete_words info '')" == $'a directory\nbase.h5' ]] || fail "bash offers other files than runs to info"
[[ "$(complete_words plot --format p)" == $'png\npdf' ]] || fail "bash does not offer the formats of plot"
[[ -z "$(complete_words run --case '')" ]] || fail "bash offers files for a case"
if command -v zsh >/dev/null; then
  zsh -n "$directory/_gudgeon" || fail "zsh cannot read its completion"
fi
if command -v man >/dev/null; then
  complaints="$(man --warnings -E UTF-8 -l -Tutf8 -Z "$directory/gudgeon.1" 2>&1 >/dev/null)"
  [[ -z "$complaints" ]] || fail "man complains: $complaints"
fi
((n_failures == 0))
