# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# man_page.awk -v version=VERSION: the manual page, from the table of help_entries.awk.

function escape(text) {
  gsub(/\\/, "\\e", text)
  gsub(/-/, "\\-", text)
  if (text ~ /^[.']/) text = "\\&" text
  return text
}

function end_footer() {
  if (in_footer) print ".fi\n.RE"
  in_footer = 0
}

function begin_footer() {
  if (!in_footer) print ".PP\n.RS 0\n.nf"
  in_footer = 1
}

BEGIN {
  FS = "\t"
  printf ".TH GUDGEON 1 \"\" \"gudgeon %s\" \"User Commands\"\n", version
}
$1 != last { end_footer() }
$1 == "" && $2 == "about" {
  about = $6
  sub(/^gudgeon: /, "", about)
  sub(/\.$/, "", about)
  printf ".SH NAME\ngudgeon \\- %s\n", escape(about)
}
$1 == "" && $2 == "usage" {
  print ".SH SYNOPSIS\n.B gudgeon\nCOMMAND [OPTIONS] [FILE]\n.br\n.B gudgeon\n\\-\\-help | \\-\\-version"
}
$1 == "" && $2 == "option" && !n_global++ { print ".SH OPTIONS" }
$1 == "" && $2 == "subcommand" { next }
$1 == "" && $2 == "footer" && !n_session++ { print ".SH SESSIONS AND EXIT STATUS" }
$1 != "" && $1 != last && !n_commands++ { print ".SH COMMANDS" }
$1 != "" && $2 == "about" { about = $6 }
$1 != "" && $2 == "usage" { printf ".SS %s\n%s.\n", escape($6), escape(about) }
$2 == "positional" || $2 == "option" {
  names = $3
  gsub(/,/, ", ", names)
  value = $4
  required = sub(/ ?REQUIRED/, "", value) ? " Required." : ""
  others = $5 == "" ? "" : " Not with " $5 "."
  text = $6
  if (text !~ /\.$/ && required others != "") text = text "."
  printf ".TP\n\\fB%s\\fR%s\n%s\n", escape(names), value == "" ? "" : " \\fI" escape(value) "\\fR",
    escape(text required others)
}
$2 == "footer" {
  begin_footer()
  print escape($6)
}
{ last = $1 }
END {
  end_footer()
  print ".SH SEE ALSO"
  print "Model files, laws, diagnostics, run files and the library have pages of their own in the sources, docs/guide/."
}
