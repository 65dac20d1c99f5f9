#!/usr/bin/env bash
# mutate.sh BUILD JOBS [N...]: do the checks notice an error in the library?
#
# Each line of proofs_checks/mutate/mutations.tsv (or those with the numbers N) is planted alone in a copy of
# the sources; the executables that are expected to catch it are rebuilt there and run, checks over the prime
# field and in double. A line has five columns, separated by tabs; lines that begin with # are remarks:
#
#   file          path from the top of the tree
#   from          text that occurs there exactly once, within one line
#   to            what takes its place: another sign, side or index; it must compile
#   executables   one or several, separated by commas: checks_ch03_2 (the checks of proofs_checks/ch03_2.cpp),
#                 test_reduction (unit
#                 tests). They are tried in this order until one fails.
#   description   what is wrong now, in words
#
# The result goes to BUILD/report/mutations.tsv. Status 1 where an error survives or a line is not valid.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
mkdir -p "$1/mutate" "$1/report"
build=$(cd "$1" && pwd)
jobs=$2
shift 2
for number; do
  [[ $number =~ ^[0-9]+$ ]] || { echo "mutate: lines of mutations.tsv are named by their numbers, not '$number'" >&2; exit 2; }
done
wanted=" $* "
list=$root/proofs_checks/mutate/mutations.tsv
copy=$build/mutate
work=$copy/build # where it lies in a tree of its own, so that the compiler's cache knows what it sees
log=$copy/log

[[ -f $list ]] || { echo "there is no list of mutations at ${list#"$root"/}" >&2; exit 1; }
mapfile -t lines < <(grep -v -e '^#' -e '^[[:space:]]*$' "$list")

sync_copy() {
  local part
  for part in CMakeLists.txt CMakePresets.json LICENSE cmake src proofs_checks tests data; do
    rm -rf "${copy:?}/$part"
    [[ ! -e $root/$part ]] || cp -a "$root/$part" "$copy/"
  done
  # What was planted in an earlier run may still be compiled in: read these files again.
  local line
  for line in "${lines[@]}"; do [[ ! -f $copy/${line%%$'\t'*} ]] || touch "$copy/${line%%$'\t'*}"; done
  cmake -S "$copy" -B "$work" -G Ninja -DCMAKE_BUILD_TYPE=Release -DACTIO_BUILD_CHAPTERS=OFF -DACTIO_BUILD_BENCHMARKS=OFF \
    >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
}

compile() { ninja -C "$work" -j "$jobs" "$@" >"$log" 2>&1; }

# Two minutes are enough for any of them: an error that makes a check run for ever is caught as well.
passes() { # EXECUTABLE
  if [[ $1 == checks_* ]]; then
    timeout 120 "$work/bin/$1" --quick --brief --columns prime,double >"$log" 2>&1
  else
    timeout 120 "$work/bin/$1" --color_output=no >"$log" 2>&1
  fi
}

occurrences() { # TEXT FILE
  text=$1 awk 'BEGIN { text = ENVIRON["text"] } { for (rest = $0; i = index(rest, text); rest = substr(rest, i + length(text))) n++ } END { print n + 0 }' "$2"
}

plant() { # FILE FROM TO
  local content
  content=$(<"$copy/$1")
  printf '%s\n' "${content/"$2"/"$3"}" >"$copy/$1"
}

chosen() { # the lines that were asked for
  local number=0 line
  for line in "${lines[@]}"; do
    number=$((number + 1))
    [[ $wanted != "  " && $wanted != *" $number "* ]] || printf '%s\n' "$line"
  done
}

sync_copy
echo "Before anything is planted"
mapfile -t targets < <(chosen | cut -f 4 | tr ',' '\n' | sed 's/ //g' | sort -u)
compile "${targets[@]}" || { tail -n 40 "$log" >&2; echo "the copy does not build" >&2; exit 1; }
for target in "${targets[@]}"; do
  passes "$target" || { tail -n 40 "$log" >&2; echo "$target fails with nothing planted" >&2; exit 1; }
done
echo "  ${#targets[@]} executables pass"
echo

caught=0 tried=0 invalid=0 number=0
report=$build/report/mutations.tsv
printf 'number\tresult\tby\tseconds\tfile\tfrom\tto\tdescription\n' >"$report"
for line in "${lines[@]}"; do
  number=$((number + 1))
  [[ $wanted == "  " || $wanted == *" $number "* ]] || continue
  IFS=$'\t' read -r file from to executables description <<<"$line"
  tried=$((tried + 1))
  began=$SECONDS
  result=survived by=
  if [[ -z $description || ! -f $copy/$file ]]; then
    result="not valid: five columns, the first a file"
  elif [[ $(occurrences "$from" "$copy/$file") != 1 ]]; then
    result="not valid: the text to replace does not occur exactly once"
  else
    plant "$file" "$from" "$to"
    for executable in ${executables//,/ }; do
      if ! compile "$executable"; then
        result="not valid: does not compile"
        break
      elif ! passes "$executable"; then
        result=caught
        by="$executable: $({ grep -oE 'in "[^"]+"' "$log" | cut -d '"' -f 2; sed -nE 's/^FAILED ([a-z0-9]+ [a-z0-9_]+):.*/\1/p' "$log"; } | sort -u | head -n 3 | paste -sd ';' || true)"
        break
      fi
    done
    cp "$root/$file" "$copy/$file"
  fi
  case $result in
    caught) caught=$((caught + 1)) ;;
    not*) invalid=$((invalid + 1)); [[ $result != *compile ]] || grep -m 3 'error:' "$log" >&2 || true ;;
  esac
  printf '%3d  %-9s %4d s  %s\n' "$number" "$result" $((SECONDS - began)) "$description"
  [[ -z $by ]] || printf '%21sby %s\n' "" "$by"
  printf '%s\t' "$number" "$result" "$by" $((SECONDS - began)) "$file" "$from" "$to" >>"$report"
  printf '%s\n' "$description" >>"$report"
done

echo
echo "$caught of $tried planted errors were caught."
((invalid == 0)) || echo "$invalid lines of ${list#"$root"/} are not valid."
((tried > 0 && caught == tried))
