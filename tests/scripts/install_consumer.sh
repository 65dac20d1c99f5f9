#!/usr/bin/env bash
# install_consumer.sh SOURCE BUILD COMPILER: installs to a fresh folder, then builds and runs a project that
# uses nothing else.
set -euo pipefail
source=$1
build=$2
compiler=$3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

cmake --install "$build" --prefix "$scratch/prefix" >"$scratch/install.log"
cmake -S "$source/tests/install_consumer" -B "$scratch/consumer" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$scratch/prefix" >"$scratch/configure.log" || { cat "$scratch/configure.log"; exit 1; }
cmake --build "$scratch/consumer"
"$scratch/consumer/consumer"
"$scratch/consumer/consumer_of_core"
"$scratch/consumer/consumer_of_headers"

# Nothing installed may point back to where it was built.
if grep -rlF -e "$source" -e "$build" "$scratch/prefix"; then
  echo "these installed files name the source or build folder"
  exit 1
fi
