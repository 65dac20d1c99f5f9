#!/usr/bin/env bash
# build_budget.sh LOG BUILD: no unit takes more than 1.5 GB to compile, and none makes more than 2 MB of code
# and constants, those that the linker will drop included.
#
# Both are the same on every machine, however busy it is; the seconds that are told decide nothing. LOG is
# what cmake/compile_log.sh wrote: of several compiles of an object the last counts, those from the cache have
# no memory, and objects that are no more are left out. At the end a unit over each limit is planted, and must
# be found.
set -euo pipefail
log=$1
build=$2
[[ -s $log ]] || { echo "there is no log of compiles at $log: is the package 'time' installed?"; exit 1; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

over_budget() { # LOG CODE: prints the report; status 1 where a unit is over
  awk -F '\t' '
    FNR == NR && NF != 5 { print "a line that is not one of the log: " $0; bad = 1; next }
    FNR == NR { if ($5 == "cached") { cached++; next }; seconds[$1] = $2; peak[$1] = $4; next }
    { code[$2] = $1; bytes += $1; objects++; if ($1 > most) { most = $1; wide = $2 } }
    END {
      for (unit in seconds) {
        units++
        total += seconds[unit]
        if (seconds[unit] > longest) { longest = seconds[unit]; slow = unit }
        if (peak[unit] > largest) { largest = peak[unit]; big = unit }
        if (peak[unit] > 1.5 * 1024 * 1024) {
          printf "over the budget: %s took %.2f GB to compile\n", unit, peak[unit] / 1024 / 1024
          bad = 1
        }
      }
      for (unit in code) if (code[unit] > 2e6) {
        printf "over the budget: %s holds %.2f MB of code\n", unit, code[unit] / 1e6
        bad = 1
      }
      printf "%d units compiled in %.0f s of user time (%d more came from the cache)\n", units, total, cached
      printf "longest: %.1f s, %s\nlargest: %.2f GB, %s\n", longest, slow, largest / 1024 / 1024, big
      printf "%d objects hold %.1f MB of code; most: %.2f MB, %s\n", objects, bytes / 1e6, most / 1e6, wide
      exit bad
    }' "$1" "$2"
}

while IFS= read -r line; do
  [[ -e $build/${line%%$'\t'*} ]] && printf '%s\n' "$line"
done <"$log" >"$scratch/log" || true
(cd "$build" && cut -f 1 "$scratch/log" | grep '\.o$' | sort -u | tr '\n' '\0' | xargs -0 -r size) |
  awk '$1 != "text" { print $1 "\t" $6 }' >"$scratch/code"

over_budget "$scratch/log" "$scratch/code" || exit 1

planted() { # FILE LINE
  cp "$scratch/log" "$scratch/planted_log"
  cp "$scratch/code" "$scratch/planted_code"
  printf '%s\n' "$2" >>"$scratch/planted_$1"
  if over_budget "$scratch/planted_log" "$scratch/planted_code" >/dev/null; then
    echo "a unit over the budget was planted and not found: $2"
    exit 1
  fi
}
planted log $'big.o\t1\t1\t1600000\tcompiled'
planted code $'2000001\twide.o'
