# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# help_entries.awk -v command=COMMAND: the help of a command as a table, a line an entry, its columns parted by tabs:
# command, kind (about, usage, subcommand, positional, option, footer), names, value, what it is not to be used with,
# description.

function trim(text) {
  sub(/^ +/, "", text)
  sub(/ +$/, "", text)
  return text
}

function write(kind, names, value, others, description) {
  printf "%s\t%s\t%s\t%s\t%s\t%s\n", command, kind, names, value, others, description
}

# An entry's left side, "--case NAME ... Excludes: --all-cases", and its right.
function write_entry(left, description,    names, others, value) {
  others = ""
  if (match(left, / Excludes: .*/)) {
    others = substr(left, RSTART + 11)
    left = substr(left, 1, RSTART - 1)
  }
  names = left
  sub(/ .*/, "", names)
  value = trim(substr(left, length(names) + 1))
  write(kind, names, value, others, trim(description))
}

function flush_entry() {
  if (entry != "") write_entry(trim(entry), "")
  entry = ""
}

BEGIN { column = 34 }  # where descriptions begin

/^Usage: / {
  sub(/^Usage: [^ ]+/, "gudgeon")
  write("usage", "", "", "", $0)
  next
}
/^(Positionals|Options|Subcommands):$/ {
  flush_entry()
  kind = tolower(substr($0, 1, length($0) - 2))
  blank = 0
  next
}
kind == "" && $0 != "" { write("about", "", "", "", $0); next }
kind == "" { next }
/^$/ && kind != "footer" { flush_entry(); blank = 1; next }
kind != "footer" && blank && !/^(Positionals|Options|Subcommands):$/ { kind = "footer" }
kind == "footer" { write("footer", "", "", "", $0); next }
/^   / { write_entry(trim(entry), $0); entry = ""; next }
{
  flush_entry()
  blank = 0
  if (length($0) > column && substr($0, column, 1) == " " && substr($0, column + 1, 1) != " ") {
    write_entry(trim(substr($0, 1, column)), substr($0, column + 1))
  } else {
    entry = $0
  }
}
END { flush_entry() }
