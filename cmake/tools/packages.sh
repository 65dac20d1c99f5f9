#!/usr/bin/env bash
# packages.sh [proofs]: sees to it that the Debian packages are there which the build, the checks and the book
# need; or those that the kernel's proofs need, which nothing else does. As root it installs what is missing;
# otherwise it prints the one line to type and ends with status 2.
set -euo pipefail

packages=(
  g++ cmake ninja-build ccache time                                      # to build, and to time the build
  libeigen3-dev libboost-dev libboost-test-dev libgsl-dev libgmp-dev libfftw3-dev # mathematics and tests
  libmpfr-dev libflint-dev libflint-arb-dev                              # digits and balls for the checks
  libtomlplusplus-dev nlohmann-json3-dev                                 # data and reports
  libcli11-dev libfmt-dev libhdf5-dev hdf5-tools libnetcdf-dev # the command and its scenes
  libopenmpi-dev openmpi-bin libscalapack-openmpi-dev                    # scenes across machines
  pybind11-dev python3-dev python3-numpy                                 # and from Python
  libopenblas-dev valgrind                                               # what the benchmarks are measured beside, and count with
  nodejs doxygen doxygen-awesome-css libjs-katex fonts-katex texlive-binaries # the book
)

[[ ${1:-} != proofs ]] || packages=(coq libcoq-mathcomp-algebra ninja-build nodejs)

if ! command -v dpkg-query >/dev/null; then
  echo "not a Debian system: please provide what these packages hold: ${packages[*]}"
  exit 0
fi

present=$(dpkg-query -W -f '${binary:Package} ${db:Status-Status}\n' "${packages[@]}" 2>/dev/null | sed -n 's/\(:[a-z0-9]*\)\{0,1\} installed$//p' || true)
missing=()
for package in "${packages[@]}"; do
  grep -qxF -- "$package" <<<"$present" || missing+=("$package")
done

if ((${#missing[@]} == 0)); then
  echo "all ${#packages[@]} there"
elif [[ $(id -u) == 0 ]]; then
  export DEBIAN_FRONTEND=noninteractive
  apt-get update -qq >/dev/null
  apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
  echo "installed ${missing[*]}"
else
  printf '%s\n' "These packages are missing. Please type" "" "  sudo apt-get update && sudo apt-get install ${missing[*]}" "" "and start again." >&2
  exit 2
fi
