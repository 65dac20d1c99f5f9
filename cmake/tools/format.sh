#!/usr/bin/env bash
# format.sh: lays out the C++ sources of this checkout as .clang-format says, and ends the lines of all
# comments by column 110.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

# A function is read whole before it runs: this file may change meanwhile.
format() {
  # Versions differ in what they write; this one knows requires clauses.
  if ! command -v clang-format-16 >/dev/null; then
    echo "clang-format-16 is needed: apt install clang-format-16" >&2
    exit 2
  fi
  mapfile -t sources < <(git ls-files '*.hpp' '*.cpp')
  mapfile -t others < <(git ls-files run '*.sh' '*.cmake' '*CMakeLists.txt' '*.mjs' '*.js' 'data/*.toml')
  python3 cmake/tools/break_lines.py "${others[@]}" >/dev/null || true
  # Comments beside long lines move above them before the formatter tears these, and once more after it has
  # moved things.
  python3 cmake/tools/break_lines.py "${sources[@]}" >/dev/null || true
  clang-format-16 -i "${sources[@]}"
  python3 cmake/tools/break_lines.py "${sources[@]}" >/dev/null || true
  clang-format-16 -i "${sources[@]}"
  python3 cmake/tools/break_lines.py "${sources[@]}"
  exit
}
format
