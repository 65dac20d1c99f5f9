#!/usr/bin/env bash
# compile_log.sh LOG COMMAND...: run one compile and append a line to LOG:
#   object   user seconds   wall seconds   peak kilobytes   compiled|cached
# User seconds, because the wall clock also measures what else the machine is doing.
set -u
log=$1
shift

object=
previous=
for word in "$@"; do
  [ "$previous" = -o ] && object=$word
  previous=$word
done

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
export CCACHE_BASEDIR="$top" CCACHE_SLOPPINESS="pch_defines,time_macros" CCACHE_STATSLOG="$scratch/cache"

command time --quiet --format '%U\t%e\t%M' --output "$scratch/time" "$@"
status=$?

how=compiled
grep -qs 'cache_hit$' "$scratch/cache" && how=cached
[ "$status" = 0 ] && [ -n "$object" ] && printf '%s\t%b\t%s\n' "$object" "$(cat "$scratch/time")" "$how" >>"$log"
exit "$status"
