#!/usr/bin/env bash
# book_links.sh ROOT BUILD: the book can be written, without a warning, and every link in it leads somewhere.
set -euo pipefail
bash "$1/docs/tools/book.sh" "$2"
