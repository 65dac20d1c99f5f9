#!/usr/bin/env bash
# statement_list.sh ROOT PROGRAM...: proofs_checks/statements.json is what the check programs list. It is read
# by ./run, by CMake and by the book, which may not wait until the checks are built. To write it anew:
# statement_list.sh --write ROOT PROGRAM...
set -euo pipefail
write=0
[[ $1 == --write ]] && { write=1; shift; }
file=$1/proofs_checks/statements.json
shift
list=$({ echo '['; for program in "$@"; do "$program" --list | sed -e '1d' -e '$d' -e 's/,$//'; done | sed '$!s/$/,/'; echo ']'; })
if ((write)); then
  printf '%s\n' "$list" >"$file"
elif [[ $list != "$(<"$file")" ]]; then
  diff <(printf '%s\n' "$list") "$file" | head -n 10 || true
  echo "proofs_checks/statements.json is not what the check programs list; ninja statement_list writes it anew"
  exit 1
fi
