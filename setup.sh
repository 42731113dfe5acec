#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# Installs the Debian packages that gudgeon is built and tested with, those that are missing. Needs root or sudo only for that.
# setup.sh --all also installs the tools that tests read run files with (tests/outside/tools.sh).
set -euo pipefail

packages=(
  g++ cmake ninja-build pkg-config dpkg-dev file
  libeigen3-dev libboost-dev libmuparser-dev libtomlplusplus-dev libfmt-dev libcli11-dev nlohmann-json3-dev libhdf5-dev libsundials-dev
  libxsimd-dev
  libgtest-dev libgmock-dev libbenchmark-dev
  clang libclang-rt-dev
  chromium fonts-dejavu-core librsvg2-bin
  hdf5-tools netcdf-bin python3-h5py python3-jsonschema
)

if [[ "${1:-}" == --all ]]; then
  packages+=(
    python3-pandas python3-xarray python3-netcdf4 python3-h5netcdf
    octave r-base-core r-bioc-rhdf5 r-cran-hdf5r scilab-cli veusz
  )
fi

# Node.js bundles the report's page. One that is there already, wherever it came from, is as good as Debian's.
has_node() {
  local version
  command -v npm >/dev/null && version="$(node --version 2>/dev/null)" && [[ "$version" =~ ^v([0-9]+)\. ]] &&
    ((BASH_REMATCH[1] >= 18))
}
has_node || packages+=(nodejs npm)

is_installed() {
  [[ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" == installed ]]
}

missing=()
for package in "${packages[@]}"; do
  is_installed "$package" || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
  exit 0
fi

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    echo "setup.sh: these packages are missing, and installing them needs root or sudo: ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

echo "Installing ${missing[*]}"
log="$(mktemp)"
trap 'rm -f "$log"' EXIT
install_missing() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get "$@" >>"$log" 2>&1
}
if ! { install_missing update && install_missing install --yes --no-install-recommends "${missing[@]}"; }; then
  cat "$log" >&2
  echo "setup.sh: the packages could not be installed; the reason is above" >&2
  exit 1
fi
