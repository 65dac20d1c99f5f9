#!/usr/bin/env bash
# program.sh BUILD NAME: runs a chapter program; its words go to NAME.txt beside its report, where the book
# finds them.
set -euo pipefail
build=$(cd "$1" && pwd)
name=$2
reports=$build/report/programs
tools=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
exec bash "$tools/once.sh" "$reports/$name.stamp" --keep "$reports/$name.txt" \
  "$build/bin/$name" "$tools/../../data/bodies.toml" -- "$build/bin/$name" --report "$reports"
