#!/usr/bin/env bash
# readme_program.sh SOURCE: the program in C++ in the README is, to the letter, the one that the install test
# builds and runs, and the one in Python is the one that the book runs.
set -euo pipefail
source=$1
shown() { # LANGUAGE: its blocks
  awk -v "opening=\`\`\`$1" '$0 == opening { inside = 1; next } /^```$/ { inside = 0; next } inside' "$source/README.md"
}
for pair in cpp:tests/install_consumer/main.cpp python:data/scenes/own_first.py; do
  if ! diff <(shown "${pair%%:*}") "$source/${pair#*:}"; then
    echo "README.md shows another program than ${pair#*:}"
    exit 1
  fi
done
