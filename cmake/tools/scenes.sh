#!/usr/bin/env bash
# scenes.sh BUILD: runs every scene of data/scenes with the built command, for the book:
# BUILD/report/scenes/NAME holds what the run left, NAME.txt what it said, and systems.json and keys.json what
# the command knows of its systems and of their keys. Then every program of data/scenes in Python, where the
# module is built: BUILD/report/python/NAME.txt.
set -euo pipefail
build=$(cd "$1" && pwd)
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
reports=$build/report/scenes
mkdir -p "$reports"
"$build/bin/actio" list systems --json >"$reports/systems.json.part"
mv "$reports/systems.json.part" "$reports/systems.json"
"$build/bin/actio" list keys --json >"$reports/keys.json.part"
mv "$reports/keys.json.part" "$reports/keys.json"

cd "$root"
# From the folder of the reports, so that what a run says of its own folder is a name and no path of this
# machine.
run_scene() { # SCENE
  local name
  name=$(basename "$1" .toml)
  # shellcheck disable=SC2016
  bash cmake/tools/once.sh "$reports/$name.stamp" --keep "$reports/$name.txt" "$1" "$build/bin/actio" -- \
    bash -c 'cd "$1" && exec "$2" run "$3" --out "$4" --force --plots' scene "$reports" "$build/bin/actio" "$root/$1" "$name" \
    >"$reports/$name.log" 2>&1 || touch "$reports/$name.failed"
}
export -f run_scene
export build root reports
# shellcheck disable=SC2016
printf '%s\n' data/scenes/*.toml | xargs -P "$(nproc)" -n 1 bash -c 'run_scene "$1"' scene
ran=0 current=0 failed=()
for scene in data/scenes/*.toml; do
  name=$(basename "$scene" .toml)
  if [[ -f $reports/$name.failed ]]; then
    rm "$reports/$name.failed"
    failed+=("$name")
    tail -n 20 "$reports/$name.log" >&2
  elif grep -q '^current:' "$reports/$name.log"; then current=$((current + 1)); else ran=$((ran + 1)); fi
done

python=$(sed -n 's/^Python_EXECUTABLE:[A-Z]*=//p' "$build/CMakeCache.txt" 2>/dev/null || true)
for module in "$build"/python/actio/_actio.*.so; do
  [[ -f $module ]] || continue
  for program in data/scenes/*.py; do
    name=$(basename "$program" .py) folder=$build/report/python
    mkdir -p "$folder"
    PYTHONPATH=$build/python bash cmake/tools/once.sh "$folder/$name.stamp" --keep "$folder/$name.txt" "$program" data/scenes "$module" -- "$python" "$program" >"$folder/$name.log" 2>&1 ||
      { failed+=("$name.py"); tail -n 20 "$folder/$name.log" >&2; }
  done
done

# Output of scenes that no longer exist.
for stamp in "$reports"/*.stamp; do
  name=$(basename "$stamp" .stamp)
  [[ -f data/scenes/$name.toml ]] || rm -rf "${reports:?}/$name" "$reports/$name".{stamp,txt,log}
done
((${#failed[@]} == 0)) || { echo "scenes failed: ${failed[*]}" >&2; exit 1; }
echo "$ran run, $current current"
