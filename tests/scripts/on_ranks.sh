#!/usr/bin/env bash
# What tests of runs on ranks begin with: . on_ranks.sh SECONDS ACTIO ACTIO_MPI MPIRUN. In an empty folder, which
# is removed at the end, `ranks N ...` is actio-mpi on N ranks, for so many seconds at most.
set -euo pipefail
# shellcheck disable=SC2034  # the scripts that source this use them
limit=$1 actio=$2 actio_mpi=$3 mpirun=$4
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 ASAN_OPTIONS=detect_leaks=0
on() { timeout "$limit" "$mpirun" --oversubscribe "$@"; }
ranks() { on -n "$1" "$actio_mpi" "${@:2}"; }
fail() { printf '%s\n' "$1"; exit 1; }
