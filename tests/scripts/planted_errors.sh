#!/usr/bin/env bash
# planted_errors.sh ROOT: each error that `./run mutate` plants finds its place: the text to be replaced
# stands exactly once in its file, within one line, and what takes its place is something else. Whether the
# checks catch the errors is for `./run mutate` to say.
set -euo pipefail
cd "$1"

misplaced() { # LIST
  local file from to description count
  while IFS=$'\t' read -r file from to _ description; do
    [[ -n $file && $file != '#'* ]] || continue
    [[ -n $description ]] || { echo "a line of fewer than five columns: $file $from"; continue; }
    [[ -f $file ]] || { echo "$file: no such file"; continue; }
    count=$(grep -oF -- "$from" "$file" | wc -l)
    [[ $count == 1 ]] || echo "$file: found $count times: $from"
    [[ $from != "$to" ]] || echo "$file: nothing changes: $from"
  done <"$1"
}

found=$(misplaced proofs_checks/mutate/mutations.tsv)
[[ -z $found ]] || { printf 'Errors that cannot be planted:\n%s\n' "$found"; exit 1; }

# Each source of checks stands first among the executables of one line at least, so that it is tried.
for source in proofs_checks/ch[0-9]*_*.cpp proofs_checks/bridge_*.cpp; do
  name=checks_$(basename "$source" .cpp)
  cut -f4 proofs_checks/mutate/mutations.tsv | cut -d, -f1 | grep -qx "$name" || { echo "no error is planted for $name"; exit 1; }
done

# A list with a line of each kind that is refused.
list=$(mktemp)
trap 'rm -f "$list"' EXIT
printf '%s\tpragma once\tx\tt\td\n' src/actio/numbers/nowhere.hpp >"$list"
there=src/actio/numbers/dual.hpp
printf '%s\tno such text\tx\tt\td\n' "$there" >>"$list"
printf '%s\t#pragma once\t#pragma once\tt\td\n%s\tx\n' "$there" "$there" >>"$list"
if [[ $(misplaced "$list" | wc -l) != 4 ]]; then
  misplaced "$list"
  echo "of four lines that are not valid some pass"
  exit 1
fi
echo "$(grep -cvE '^(#|\s*$)' proofs_checks/mutate/mutations.tsv) errors can be planted, each at its place"
