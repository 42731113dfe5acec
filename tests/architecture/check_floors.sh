#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# check_floors.sh ROOT: every source file includes only what its floor may, third-party headers stay in their rooms,
# and each file has its licence lines and fewer than 500 lines. Prints all that is wrong; fails when anything is.
set -euo pipefail

root="${1:?usage: check_floors.sh ROOT}"
source_root="$root/src/gudgeon"
if [[ ! -d "$source_root" ]]; then
  echo "check_floors.sh: there is no $source_root" >&2
  exit 1
fi

mapfile -t files < <(find "$source_root" -type f \( -name '*.h' -o -name '*.cpp' \) | LC_ALL=C sort)
if ((${#files[@]} == 0)); then
  echo "check_floors.sh: there are no sources in $source_root" >&2
  exit 1
fi

awk -v prefix="$source_root/" '
  BEGIN {
    max_lines = 500
    # floor -> the floors it may include besides itself
    may["base"] = ""
    may["geometry"] = "base"
    may["laws"] = "base geometry"
    may["model"] = "base geometry laws"
    may["system"] = "base geometry laws model"
    may["results"] = "base"
    may["sim"] = "base geometry laws model system results"
    may["analysis"] = "base results"
    may["io"] = "base laws model results"
    may["report"] = "base results analysis"
    may["library"] = "base model results sim analysis io"
    may["gudgeon.h"] = "library"  # all that users of the library include
    may["app"] = "base geometry laws model system results sim analysis io report"
    # start of a third-party header -> the floors that may include it
    room["hdf5"] = "io"; room["H5"] = "io"; room["toml++/"] = "io"
    room["CLI/"] = "app"; room["nlohmann/"] = "app"
    room["boost/"] = "base geometry laws system sim"
    room["muParser"] = "base"; room["xsimd/"] = "base"
    room["sundials/"] = "sim"; room["cvode/"] = "sim"; room["nvector/"] = "sim"
    room["sunlinsol/"] = "sim"; room["sunmatrix/"] = "sim"
    room["Eigen/"] = "base geometry laws model system sim analysis"
    room["pybind11/"] = ""
    room["mpi.h"] = "app"
  }
  function complain(line, text) {
    printf "src/gudgeon/%s:%d: %s\n", name, line, text
    n_complaints++
  }
  function holds(list, word) { return index(" " list " ", " " word " ") > 0 }
  function close_file() {
    if (name != "" && n_lines > max_lines) complain(n_lines, "has " n_lines " lines, more than " max_lines)
  }
  FNR == 1 {
    close_file()
    name = substr(FILENAME, length(prefix) + 1)
    floor = index(name, "/") ? substr(name, 1, index(name, "/") - 1) : name
    if (!(floor in may)) complain(1, "lies on no known floor")
    if ($0 !~ /^\/\/ SPDX-FileCopyrightText: /) complain(1, "does not begin with its SPDX copyright line")
  }
  FNR == 2 && $0 !~ /^\/\/ SPDX-License-Identifier: Apache-2\.0$/ { complain(2, "lacks its SPDX licence line") }
  { n_lines = FNR }
  /^[ \t]*#[ \t]*include[ \t]*[<"]/ {
    header = $0
    sub(/^[^<"]*[<"]/, "", header)
    sub(/[>"].*$/, "", header)
    if (header ~ /^gudgeon\//) {
      split(header, part, "/")
      if (part[2] != floor && !holds(may[floor], part[2])) {
        complain(FNR, "floor " floor " may not include " header)
      }
    } else {
      if ($0 ~ /"/) complain(FNR, "includes " header " without its floor; write gudgeon/FLOOR/" header)
      for (start in room) {
        if (index(header, start) == 1 && !holds(room[start], floor)) {
          complain(FNR, header " may not be included on floor " floor)
        }
      }
    }
  }
  END {
    close_file()
    if (n_complaints > 0) exit 1
    printf "%d files keep their floors\n", ARGC - 1
  }
' "${files[@]}"
