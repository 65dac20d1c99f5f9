#!/usr/bin/env bash
# measure.sh BUILD NAME [--short | --ask]: runs a benchmark (bench_NAME) or a long test (stress_NAME); its
# report goes where the book finds it.
#
# --short  the short form of a benchmark. With ACTIO_ONCE=1 it is not run where a report is current, and
# never in the place of a full one that is.
# --ask    runs nothing and says what is current: full, short or none
#
# A stamp beside the report holds what was measured: the executable, the data and the processor. A report
# with a claim that does not hold is one, too.
set -euo pipefail
build=$(cd "$1" && pwd)
name=$2
mode=${3:-}
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

case $name in
  bench_*) reports=$build/report/benchmarks ;;
  stress_*) reports=$build/report/tests/stress ;;
  *) echo "measure.sh: $name is neither a benchmark nor a long test" >&2; exit 2 ;;
esac
program=$build/bin/$name
if [[ ! -x $program ]]; then
  [[ $mode == --ask ]] && { echo none; exit 0; }
  echo "measure.sh: $program is not built" >&2
  exit 1
fi
inputs=("$program" data/bodies.toml)
# Some run the command, and hold its path.
grep -qaF "$build/bin/actio" "$program" && inputs+=("$build/bin/actio")
stamp=$reports/$name.stamp
key=$( (sed -n '/^model name/{p;q}' /proc/cpuinfo && sha256sum "${inputs[@]}") 2>/dev/null | sha256sum | cut -d ' ' -f 1)
current=none
[[ -f $stamp && $(<"$stamp") == *" $key" ]] && current=$(cut -d ' ' -f 1 "$stamp")

if [[ $mode == --ask ]]; then
  echo "$current"
  exit 0
fi
if [[ $mode == --short && ${ACTIO_ONCE:-} == 1 && $current != none ]]; then
  echo "current: a $current run of the same executable"
  exit 0
fi

mkdir -p "$reports"
rm -f "$stamp"
status=0
if [[ $mode == --short ]]; then
  "$program" --short --report "$reports" || status=$?
else
  "$program" --report "$reports" || status=$?
fi
# A program that stopped halfway has left no report.
if [[ $status == 0 || (-f $reports/$name.json && $status == 1) ]]; then
  [[ $mode == --short ]] && echo "short $key" >"$stamp" || echo "full $key" >"$stamp"
fi
exit "$status"
