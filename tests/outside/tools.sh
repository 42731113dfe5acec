#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# tools.sh PROGRAM MODEL [TOOL]: runs the model and has every tool of docs/guide/reading_results.md, or the one named, read
# the run file: the largest normal force of joint B of the first clearance stage must be the number that gudgeon exports. A
# tool that is not there is told as not run, never as passed. Fails when a tool reads something else; ends with 77 when
# none was there.
set -euo pipefail
program=$1
model=$2
only=${3:-}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# The run file, and the right number; once a tool is there to read it.
right=
prepare() {
  if [ -n "$right" ]; then return; fi
  "$program" run "$model" -o runs --set study.cycles=1 --set study.warm_up_cycles=0 \
    --set study.outputs_per_cycle=2000 --quiet >/dev/null
  mv runs/base.h5 press.h5
  "$program" export press.h5 -o csv >/dev/null
  right=$(python3 - <<'EOF'
import csv
rows = csv.DictReader(open("csv/no_wear_channels.csv"))
print("%.9g" % max(float(row["B.normal_force [N]"]) for row in rows))
EOF
  )
}
group=stages/no_wear/channels/B
n_failed=0
n_passed=0

# try NAME CONDITION COMMAND: runs the command, whose last line must be the right number.
try() {
  local name=$1 condition=$2 seen
  shift 2
  if [ -n "$only" ] && [ "$only" != "$name" ]; then return; fi
  if ! bash -c "$condition" >/dev/null 2>&1; then
    echo "not run: $name is not there"
    return
  fi
  prepare
  if ! seen=$("$@" 2>errors.txt | tail -n 1) || [ "$seen" != "$right" ]; then
    echo "FAILED: $name read '${seen}' where $right is right: $(tail -n 2 errors.txt)"
    n_failed=$((n_failed + 1))
    return
  fi
  echo "passed: $name read $seen"
  n_passed=$((n_passed + 1))
}

python=/usr/bin/python3 # Debian's, which has Debian's packages
has_module() { echo "$python -c 'import $1'"; }

try h5py "$(has_module h5py)" $python -c "
import h5py
print('%.9g' % h5py.File('press.h5')['$group/normal_force'][:].max())"
try pandas "$(has_module pandas) && $(has_module h5py)" $python -c "
import h5py, pandas as pd
run = h5py.File('press.h5')
B = pd.DataFrame({name: column[:] for name, column in run['$group'].items()}).set_index('time')
table = run['stages/no_wear/statistics']
rows = pd.DataFrame({n: c[:] for n, c in table.items() if c.shape}, index=table['channel'].asstr()[()].splitlines())
assert rows.loc['B.normal_force', 'maximum'] >= B['normal_force'].max()
print('%.9g' % B['normal_force'].max())"
for engine in netcdf4 h5netcdf; do
  module=$([ $engine = netcdf4 ] && echo netCDF4 || echo h5netcdf)
  try "xarray_$engine" "$(has_module xarray) && $(has_module $module)" $python -c "
import xarray as xr
B = xr.open_dataset('press.h5', group='$group', engine='$engine')
xr.open_dataset('press.h5', group='stages/no_wear/statistics', engine='$engine',
                **({'phony_dims': 'access'} if '$engine' == 'h5netcdf' else {})).load()
assert B.normal_force.units == 'N' and 'time' in B.coords
print('%.9g' % B.normal_force.max())"
done
try Octave "command -v octave-cli" octave-cli --no-gui --quiet --eval "
run = load('press.h5'); B = run.stages.no_wear.channels.B;
names = strsplit(strtrim(run.stages.no_wear.statistics.channel), \"\\n\");
assert(numel(names) == numel(run.stages.no_wear.statistics.maximum));
printf('%.9g\n', max(B.normal_force));"
try rhdf5 "Rscript -e 'library(rhdf5)'" Rscript -e "
B <- as.data.frame(rhdf5::h5read('press.h5', '$group')); cat(sprintf('%.9g\n', max(B\$normal_force)))"
try hdf5r "Rscript -e 'library(hdf5r)'" Rscript -e "
force <- hdf5r::H5File\$new('press.h5', 'r')[['$group/normal_force']][]; cat(sprintf('%.9g\n', max(force)))"
cat >read.sce <<EOF
mprintf("%.9g\n", max(h5read("press.h5", "/$group/normal_force")));
exit
EOF
try Scilab "command -v scilab-cli" timeout 120 scilab-cli -nb -f read.sce
try Veusz "$(has_module veusz)" env QT_QPA_PLATFORM=offscreen timeout 120 $python -c "
import veusz.embed
window = veusz.embed.Embedded('press', hidden=True)
window.ImportFileHDF5('press.h5', ['/$group'])
print('%.9g' % window.GetData('normal_force')[0].max())
window.Close()"
cat >dump.py <<'EOF'
import re
import subprocess
text = subprocess.run(["ncdump", "-v", "/stages/no_wear/channels/B/normal_force", "press.h5"], capture_output=True,
                      text=True, check=True).stdout
values = re.search(r"^ *normal_force = ([^;]*);", text, re.MULTILINE).group(1)
print("%.9g" % max(float(value) for value in values.split(",")))
EOF
try ncdump "command -v ncdump" python3 dump.py
try h5repack "command -v h5repack && command -v h5dump" bash -c "
h5repack press.h5 packed.h5
$program info --verify packed.h5 >&2
$python -c 'import csv; print(\"%.9g\" % max(float(r[\"B.normal_force [N]\"]) for r in csv.DictReader(open(\"csv/no_wear_channels.csv\"))))'"
if ((n_failed > 0)); then exit 1; fi
if ((n_passed == 0)); then exit 77; fi
