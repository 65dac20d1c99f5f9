#!/usr/bin/env bash
# every_suite.sh PROGRAM NAME,NAME...: the suites and cases that the entries of CTest name are all that this
# program of tests has.
set -euo pipefail
has=$("$1" --list_content 2>&1 | sed -nE 's/^([A-Za-z0-9_]+)\*?.*$/\1/p' | sort -u)
named=$(tr ',' '\n' <<<"$2" | sort -u)
if ! diff <(printf '%s\n' "$has") <(printf '%s\n' "$named"); then
  echo "what begins with < is in the program and no entry of CTest runs it; what begins with > is not in the program"
  exit 1
fi
echo "$(wc -l <<<"$has") suites and cases outside of suites, each run by an entry"
