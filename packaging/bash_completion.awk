# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# bash_completion.awk: the completion for bash, from the table of help_entries.awk.

# Words to choose from, of "FORMAT:{svg,png,pdf}" and of "A family (normal_force, damping) or a law"; or nothing.
function find_choices(value, description,    text) {
  if (match(value, /\{[^}]*\}/)) text = substr(value, RSTART + 1, RLENGTH - 2)
  else if (match(description, /\([a-z_]+(, [a-z_]+)+\)/)) text = substr(description, RSTART + 1, RLENGTH - 2)
  gsub(/, ?/, " ", text)
  return text
}

function needs_value(value) {
  sub(/ ?REQUIRED/, "", value)
  return value != ""
}

BEGIN { FS = "\t" }
$2 == "subcommand" { commands = commands " " $3 }
$2 == "option" {
  names = $3
  gsub(/,/, " ", names)
  options[$1] = options[$1] " " names
  if (!needs_value($4)) next
  gsub(/ /, "|", names)
  choices = find_choices($4, "")
  if (choices != "") values[$1] = values[$1] sprintf("        %s) _gudgeon_words '%s'; return ;;\n", names, choices)
  else if ($3 ~ /--output|--plots/) values[$1] = values[$1] sprintf("        %s) _gudgeon_files ''; return ;;\n", names)
  else values[$1] = values[$1] sprintf("        %s) return ;;\n", names)
}
$2 == "positional" {
  choices = find_choices("", $6)
  if (index($6, "TOML")) arguments[$1] = "_gudgeon_files toml"
  else if (index($6, "HDF5")) arguments[$1] = "_gudgeon_files h5"
  else if (choices != "") arguments[$1] = "_gudgeon_words '" choices "'"
}
END {
  n = split(substr(commands, 2), order, " ")
  print "# bash completion for gudgeon"
  print ""
  print "_gudgeon_words() { COMPREPLY=($(compgen -W \"$1\" -- \"$current\")); }"
  print ""
  print "# Files with that ending, or all, and directories, which lead to others."
  print "_gudgeon_files() {"
  print "  local IFS=$'\\n'"
  print "  compopt -o filenames 2>/dev/null"
  print "  COMPREPLY=($(compgen -d -- \"$current\") $(compgen -f -X \"${1:+!*.$1}\" -- \"$current\"))"
  print "  COMPREPLY=($(printf '%s\\n' \"${COMPREPLY[@]}\" | sort -u | sed '/^$/d'))"
  print "}"
  print ""
  print "_gudgeon() {"
  print "  local current=\"${COMP_WORDS[COMP_CWORD]}\" previous=\"${COMP_WORDS[COMP_CWORD - 1]}\""
  print "  COMPREPLY=()"
  print "  if ((COMP_CWORD == 1)); then"
  printf "    _gudgeon_words '%s'\n    return\n  fi\n", substr(commands options[""], 2)
  print "  case \"${COMP_WORDS[1]}\" in"
  for (k = 1; k <= n; k++) {
    command = order[k]
    printf "    %s)\n", command
    if (values[command] != "") printf "      case \"$previous\" in\n%s      esac\n", values[command]
    print "      if [[ \"$current\" == -* ]]; then"
    printf "        _gudgeon_words '%s'\n", substr(options[command], 2)
    if (arguments[command] != "") printf "      else\n        %s\n", arguments[command]
    print "      fi\n      ;;"
  }
  print "  esac\n}\ncomplete -F _gudgeon gudgeon"
}
