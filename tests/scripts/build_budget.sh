#!/usr/bin/env bash
# build_budget.sh LOG BUILD: every translation unit compiled within 60 s of user time and 1.5 GB.
#
# LOG is what cmake/compile_log.sh wrote; of several compiles of an object the last counts, those that came
# from the cache and those of objects that are no more are left out. At the end a line over each limit is
# planted, and must be found.
set -euo pipefail
log=$1
build=$2
[[ -s $log ]] || { echo "there is no log of compile times at $log: is the package 'time' installed?"; exit 1; }

over_budget() { # LOG: prints the report; status 1 where a unit is over
  awk -F '\t' '
    NF != 5 { print "a line that is not one of the log: " $0; bad = 1; next }
    $5 == "compiled" { seconds[$1] = $2; peak[$1] = $4 }
    $5 == "cached" { cached++ }
    END {
      for (unit in seconds) {
        units++
        total += seconds[unit]
        if (seconds[unit] > longest) { longest = seconds[unit]; slow = unit }
        if (peak[unit] > largest) { largest = peak[unit]; big = unit }
        if (seconds[unit] > 60 || peak[unit] > 1.5 * 1024 * 1024) {
          printf "over the budget: %s, %.1f s, %.2f GB\n", unit, seconds[unit], peak[unit] / 1024 / 1024
          bad = 1
        }
      }
      printf "%d units compiled in %.0f s of user time (%d more came from the cache)\n", units, total, cached
      printf "longest: %.1f s, %s\nlargest: %.2f GB, %s\n", longest, slow, largest / 1024 / 1024, big
      exit bad
    }' "$1"
}

present=$(mktemp)
trap 'rm -f "$present" "$present.planted"' EXIT
while IFS= read -r line; do
  [[ -e $build/${line%%$'\t'*} ]] && printf '%s\n' "$line"
done <"$log" >"$present" || true

over_budget "$present" || exit 1

for planted in $'slow.o\t60.1\t70\t1000\tcompiled' $'big.o\t1\t1\t1600000\tcompiled'; do
  { cat "$present"; printf '%s\n' "$planted"; } >"$present.planted"
  if over_budget "$present.planted" >/dev/null; then
    echo "a unit over the budget was planted and not found: $planted"
    exit 1
  fi
done
