#!/usr/bin/env bash
# line_length.sh ROOT: no line of C++ or of a proof passes column 110, code or comment. `./run format` breaks
# those that do.
set -uo pipefail
cd "$1" || exit
export LC_ALL=C.UTF-8
long() { # FOLDER...
  find "$@" '(' -name '*.[hc]pp' -o -name '*.v' ')' -print0 | xargs -0 grep -nP '^.{111,}' /dev/null | sed -E 's/^([^:]+:[0-9]+):.*/\1/'
}
found=$(long src chapters proofs_checks tests benchmarks docs/examples)
[[ -z $found ]] || { printf 'past column 110:\n%s\n' "$found"; exit 1; }

# The measure itself: a line of 110 characters passes, one of 111 does not, and a letter of two bytes is one
# column.
planted=$(mktemp -d)
trap 'rm -rf "$planted"' EXIT
printf '//%0107dé\n' 0 >"$planted/short.hpp"
printf '//%0109d\n' 0 >"$planted/long.hpp"
if [[ $(long "$planted") != "$planted/long.hpp:1" ]]; then
  echo "planted lines: found '$(long "$planted")'"
  exit 1
fi
files=$(find src chapters proofs_checks tests benchmarks '(' -name '*.[hc]pp' -o -name '*.v' ')' | wc -l)
echo "no line of $files files passes column 110"
