#!/usr/bin/env bash
# book_links.sh ROOT BUILD: the book can be written, without a warning; every link in it leads somewhere,
# every page is found by the tree and has its ways to the others, and none tells where it was made.
set -euo pipefail
bash "$1/docs/tools/book.sh" "$2"
node "$1/docs/tools/check_pages.mjs" "$2/book"
