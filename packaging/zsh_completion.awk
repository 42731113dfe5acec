# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# zsh_completion.awk: the completion for zsh, from the table of help_entries.awk.

# Inside single quotes, with what _arguments takes for its own escaped.
function quote(text) {
  gsub(/'/, "'\\''", text)
  gsub(/\[/, "\\[", text)
  gsub(/\]/, "\\]", text)
  gsub(/:/, "\\:", text)
  return text
}

# Words to choose from, "(svg png pdf)"; or nothing.
function find_choices(value, description,    text) {
  if (match(value, /\{[^}]*\}/)) text = substr(value, RSTART + 1, RLENGTH - 2)
  else if (match(description, /\([a-z_]+(, [a-z_]+)+\)/)) text = substr(description, RSTART + 1, RLENGTH - 2)
  gsub(/, ?/, " ", text)
  return text == "" ? "" : "(" text ")"
}

function find_action(names, value, description,    choices) {
  choices = find_choices(value, description)
  if (choices != "") return choices
  if (index(description, "TOML")) return "_files -g \"*.toml(-.)\""
  if (index(description, "HDF5")) return "_files -g \"*.h5(-.)\""
  if (names ~ /--output|--plots/) return "_files"
  return " "
}

BEGIN { FS = "\t" }
$2 == "subcommand" {
  commands = commands sprintf("    '%s:%s'\n", $3, quote($6))
  order[++n] = $3
}
$2 == "option" {
  value = $4
  sub(/ ?REQUIRED/, "", value)
  repeated = sub(/ ?\.\.\.$/, "", value)
  label = value
  sub(/[:].*/, "", label)
  argument = value == "" ? "" : sprintf(":%s:%s", quote(label), find_action($3, value, ""))
  shared = $3
  gsub(/,/, " ", shared)
  excluded = $5 == "" ? "" : " " $5
  # _arguments takes several names of one option by brace expansion.
  if (repeated) prefix = "'*'"
  else prefix = "'(" shared excluded ")'"
  names = index($3, ",") ? "{" $3 "}" : $3
  specs[$1] = specs[$1] sprintf(" \\\n        %s%s'[%s]%s'", prefix, names, quote($6), argument)
}
$2 == "positional" {
  value = $3
  optional = index($4, "REQUIRED") ? "" : ":"
  specs[$1] = specs[$1] sprintf(" \\\n        '1:%s%s:%s'", optional, quote(value), find_action("", "", $6))
}
END {
  print "#compdef gudgeon\n"
  print "_gudgeon() {"
  print "  local context state state_descr line"
  print "  typeset -A opt_args"
  printf "  local -a commands=(\n%s  )\n", commands
  printf "  _arguments -C%s \\\n        '1:command:->command' '*::argument:->argument'\n", specs[""]
  print "  case $state in\n    command) _describe command commands ;;\n    argument) case $line[1] in"
  for (k = 1; k <= n; k++) printf "      %s) _arguments%s ;;\n", order[k], specs[order[k]]
  print "    esac ;;\n  esac\n}\n\n_gudgeon \"$@\""
}
