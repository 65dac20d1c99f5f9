#!/usr/bin/env bash
# one_system_one_file.sh ROOT: a system of scenes is one file and one line, as src/program/registry/system.hpp
# says.
#
# Outside systems/ nothing in the program, in the command, in the module for Python and in the page of a
# run asks which system it is: none of them compares with the name of a system, or looks one up by a name that
# is written down. At the end such a comparison is planted in a copy, and must be found.
set -euo pipefail
root=$1

names() { # the names of the systems, from their one line each, joined by |
  sed -nE 's/^  with\(([a-z_]+)\).*$/\1/p' "$1/src/program/systems/systems.cpp" | paste -sd'|'
}
violations() {
  local all
  all=$(names "$1")
  [[ -n $all ]] || { echo "no system was found in src/program/systems/systems.cpp"; return; }
  for name in ${all//|/ }; do
    compgen -G "$1/src/program/systems/*/$name.cpp" >/dev/null || echo "there is no src/program/systems/FAMILY/$name.cpp"
  done
  grep -rnE "(==|!=|find_system\(|case) *\"($all)\"|\"($all)\" *(==|!=)" \
    "$1/src/program" "$1/src/app" "$1/src/python" "$1/data/viewer" | grep -v "/src/program/systems/" || true
  grep -rnwE "(${all//|/_system|}_system)" "$1/src" | grep -v "/src/program/systems/" || true
}

found=$(violations "$root")
if [[ -n $found ]]; then
  printf '%s\n' "Asks by name which system it is, outside src/program/systems:" "$found"
  exit 1
fi

copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
mkdir -p "$copy/data"
cp -r "$root/src" "$copy/"
cp -r "$root/data/viewer" "$copy/data/"
plant() { # FILE LINE
  printf '%s\n' "$2" >"$copy/$1"
  violations "$copy" | grep -qF -- "$1" || { echo "planted, and not found: $2"; exit 1; }
  rm "$copy/$1"
}
plant src/program/run/planted.cpp 'if (scene.system->name == "heavy_top") return 1;'
plant src/app/planted.cpp 'auto const* const system = find_system("rigid_body");'
plant data/viewer/planted.js 'if (run.scene.kind === "rigid_body_n") return 1;'
plant src/program/run/planted.hpp 'System heavy_top_system();'

echo "$(names "$root" | tr '|' '\n' | wc -l) systems: one file and one line each; four planted violations were found."
