#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# R's ncdf4 1.21 (Debian 12, r-cran-ncdf4 1.21-1) cannot open a file in which any variable is stored compact, that is, in
# its object's header: nc_open stops with "neither NC_CONTIGUOUS nor NC_CHUNKED", whatever variable one wants. The
# library below it, netCDF-C 4.9.0, knows compact storage, and ncdump reads the same file.
# gudgeon keeps single values compact, because there they have a checksum; docs/guide/reading_results.md sends R users to
# rhdf5 and hdf5r.
# Needs: Debian 12, its package mirror, root or sudo. Fails where the behaviour is another one.
set -euo pipefail
as_root() { if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi; }
as_root apt-get install -y -qq --no-install-recommends r-base-core r-cran-ncdf4=1.21-1 netcdf-bin libnetcdf-dev gcc \
  libc6-dev >/dev/null
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat >compact.c <<'EOF'
#include <netcdf.h>
int main(void) {
  int file, dimension, variable;
  double values[3] = {1.0, 2.0, 4.0};
  int failed = nc_create("compact.nc", NC_NETCDF4, &file) || nc_def_dim(file, "n", 3, &dimension) ||
               nc_def_var(file, "force", NC_DOUBLE, 1, &dimension, &variable) ||
               nc_def_var_chunking(file, variable, NC_COMPACT, 0) || nc_put_var_double(file, variable, values) ||
               nc_close(file);
  return failed ? 1 : 0;
}
EOF
gcc compact.c -o compact -lnetcdf
./compact
ncdump -v force compact.nc | grep "force = 1, 2, 4"
Rscript -e 'library(ncdf4); nc_open("compact.nc")' >seen 2>&1 && { echo "opens it"; exit 1; }
grep -o "neither NC_CONTIGUOUS nor NC_CHUNKED!  Value=2" seen
