#!/usr/bin/env bash
# run_cli.sh ROOT: what ./run answers to a person who mistypes. None of this may build anything.
set -uo pipefail
root=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export ACTIO_BUILD=$scratch/build
failures=0

expect() { # STATUS TEXT ARGUMENT...
  local wanted=$1 text=$2 said status=0
  shift 2
  said=$("$root/run" "$@" 2>&1) || status=$?
  if [[ $status != "$wanted" || $said != *"$text"* ]]; then
    printf './run %s\n  wanted status %s and: %s\n  got status %s and: %s\n' "$*" "$wanted" "$text" "$status" "$said"
    failures=$((failures + 1))
  fi
}

expect 0 "usage: ./run" help
expect 0 "usage: ./run" --help
expect 2 "did you mean 'test'" tset
expect 2 "did you mean 'mutate'" mutat
expect 2 "--jobs wants a positive number, not 'many'" --jobs many
expect 2 "--jobs wants a positive number, not '0'" --jobs=0
expect 2 "--jobs wants a positive number" --jobs
expect 2 "there are --all and --again" test --agian
expect 2 "which statement" check
expect 2 "proofs takes no argument" proofs eq_5_8
expect 2 "there are bench, stress, checks and proofs" record everything
if [[ -f $root/proofs_checks/registry.tsv ]]; then
  expect 2 "did you mean 'eq_3_10'" check eq_3_1O
  expect 2 "did you mean 'thm_3_2_1'" check thm_321
  expect 2 "unknown statement 'id'" check id
  expect 2 "--digits wants 16 to 100000, not 15" check eq_3_10 --digits 15
  expect 2 "--digits wants a whole number, not 'many'" check eq_3_10 --digits many
  expect 2 "--modulo needs a value" check eq_3_10 --modulo
  expect 2 "unknown option '--digit'" check eq_3_10 --digit 50
fi
[[ -e $ACTIO_BUILD ]] && { echo "something was made in $ACTIO_BUILD"; failures=$((failures + 1)); }

# From any folder.
(cd / && "$root/run" help >/dev/null) || { echo "./run help fails from another folder"; failures=$((failures + 1)); }

# The scripts are sound where there is a tool to say so.
if command -v shellcheck >/dev/null; then
  (cd "$root" && shellcheck -x run .ci/run cmake/*.sh cmake/tools/*.sh tests/scripts/*.sh) || failures=$((failures + 1))
fi
((failures == 0)) && echo "./run answers as it should"
exit $((failures > 0))
