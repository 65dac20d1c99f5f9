#!/usr/bin/env bash
# readme_program.sh SOURCE: the program in the README is, to the letter, the one that the install test builds
# and runs.
set -euo pipefail
source=$1
shown=$(awk '/^```cpp$/ { inside = 1; text = ""; next } /^```$/ { if (inside && text ~ /int main/) print text; inside = 0; next } inside { text = text $0 "\n" }' "$source/README.md")
if ! diff <(printf '%s' "$shown" | awk 1) "$source/tests/install_consumer/main.cpp"; then
  echo "README.md shows another program than tests/install_consumer/main.cpp"
  exit 1
fi
