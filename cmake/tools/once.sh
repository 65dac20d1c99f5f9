#!/usr/bin/env bash
# once.sh STAMP [--keep FILE] INPUT... -- COMMAND...
#
# Runs COMMAND and notes in STAMP what it was run on. With ACTIO_ONCE=1 a command whose line and inputs are
# the same as when it last succeeded is not run again. --keep leaves the standard output in FILE as well.
set -euo pipefail

stamp=$1
shift
keep=
if [[ $1 == --keep ]]; then
  keep=$2
  shift 2
fi
inputs=()
while [[ $1 != -- ]]; do
  inputs+=("$1")
  shift
done
shift

# What the command sees: its own words, and the files it was said to read. A folder that is not there holds
# none.
hash_inputs() { { find "${inputs[@]}" -type f -print0 2>/dev/null || true; } | LC_ALL=C sort -z | xargs -0 -r sha256sum; }
key=$( (printf '%s\n' "$@" && hash_inputs) | sha256sum)
if [[ ${ACTIO_ONCE:-} == 1 && -f $stamp && $(<"$stamp") == "$key" ]]; then
  echo "current: the same inputs as when it last succeeded"
  exit 0
fi

rm -f "$stamp"
mkdir -p "$(dirname "$stamp")"
if [[ -n $keep ]]; then
  "$@" | tee "$keep.part"
  mv "$keep.part" "$keep"
else
  "$@"
fi
echo "$key" >"$stamp"
