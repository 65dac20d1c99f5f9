#!/usr/bin/env bash
# check_cli.sh PROGRAM STATEMENT: what a program of checks answers to options that do not fit: one line that
# says what would do, and status 2.
set -uo pipefail
program=$1
statement=$2
failures=0

refuses() { # TEXT ARGUMENT...
  local text=$1 said status=0
  shift
  said=$("$program" "$@" 2>&1) || status=$?
  if [[ $status != 2 || $said != *"$text"* || $(wc -l <<<"$said") != 1 ]]; then
    printf '%s\n  wanted status 2 and one line with: %s\n  got status %s and: %s\n' "$*" "$text" "$status" "$said"
    failures=$((failures + 1))
  fi
}

refuses "no check of 'eq_3_1O'" eq_3_1O
refuses "unknown column 'quad'; there are prime, rational, double, 50, 100, ball" "$statement" --columns quad
refuses "from 16 to 100000, not '15'" "$statement" --digits 15
refuses "from 16 to 100000, not '1e3'" "$statement" --digits 1e3
refuses "from 16 to 100000, not '100001'" "$statement" --digits 100001
refuses "no prime" "$statement" --modulo 2305843009213693953
refuses "between 2^40 and 2^62" "$statement" --modulo 1000003
refuses "--modulo wants a whole number" "$statement" --modulo -7
refuses "no claim for balls" "$statement" --balls
refuses "not meant for these columns" "$statement" --columns ball
refuses "--points wants a whole number" "$statement" --points 0
refuses "needs a value" "$statement" --seed
refuses "unknown option '--collumns'" "$statement" --collumns all
refuses "there is no source 'ch03_9'" --source ch03_9

"$program" "$statement" --digits 30 --brief >/dev/null || { echo "$statement fails in 30 digits"; failures=$((failures + 1)); }
"$program" "$statement" --modulo 2305843009213693907 --points 20 --brief >/dev/null || { echo "$statement fails over another prime field"; failures=$((failures + 1)); }
exit $((failures > 0))
