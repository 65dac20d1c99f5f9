#!/usr/bin/env bash
# Writes the book: BUILD_DIR/book/index.html, from the pages, the headers and the reports of BUILD_DIR.
#
#   docs/tools/book.sh BUILD_DIR [--strict] [--force] [--draft]
#
# --strict reports must be there: a figure that neither this build nor the release has measured fails the book
# instead of being shown as not run --force write it even if nothing changed since the last time --draft show
# Doxygen's warnings, but write the book all the same
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
strict='' force='' draft='' build=''
for argument in "$@"; do
  case $argument in
    --strict) strict=--strict ;;
    --force) force=yes ;;
    --draft) draft=yes ;;
    -*) echo "book.sh: unknown option $argument" >&2; exit 2 ;;
    *) build=$argument ;;
  esac
done
[[ -n $build ]] || { echo "usage: docs/tools/book.sh BUILD_DIR [--strict] [--force] [--draft]" >&2; exit 2; }
mkdir -p "$build"
build=$(cd "$build" && pwd)
cd "$root"
registry=${BOOK_REGISTRY:-proofs_checks/registry.tsv}

missing=()
command -v doxygen >/dev/null || missing+=(doxygen)
command -v node >/dev/null || missing+=(nodejs)
command -v bibtex >/dev/null || missing+=(texlive-binaries)
[[ -e /usr/share/doxygen-awesome-css/doxygen-awesome.css ]] || missing+=(doxygen-awesome-css)
[[ -e /usr/share/javascript/katex/katex.js ]] || missing+=(libjs-katex fonts-katex)
if (( ${#missing[@]} )); then
  echo "book: missing Debian packages; type: apt-get install ${missing[*]}" >&2
  exit 1
fi

# A sentence that claims something of all cases names what it rests on, or somebody has read it.
node docs/tools/claims.mjs --root . || [[ -z $strict ]] || exit 1
# Short sentences; and a letter has one meaning on a page.
node docs/tools/language.mjs --root . || [[ -z $strict ]] || exit 1
node docs/tools/notation.mjs --root . || [[ -z $strict ]] || exit 1

# Nothing to do if every input is what it was.
stamp=$(
  { echo "strict=$strict"
    mkdir -p "$build/report"
    # Of the benchmarks the pages show figures alone, but their names must be right.
    for folder in benchmarks tests/stress; do [[ -d $folder ]] && find "$folder" -name '*.cpp' | LC_ALL=C sort; done
    find docs src chapters proofs_checks data "$registry" "$build/report" -type f \
      \( -name '*.md' -o -name '*.hpp' -o -name '*.cpp' -o -name '*.tsv' -o -name '*.mjs' -o -name '*.sh' -o -name '*.css' -o -name '*.js' -o -name '*.html' \
         -o -name '*.xml' -o -name '*.bib' -o -name '*.json' -o -name '*.svg' -o -name '*.txt' -o -name '*.dox' -o -name '*.v' -o -name _CoqProject -o -name '*.toml' -o -name '*.py' -o -name Doxyfile \) \
      ! -name book_coverage.tsv ! -path '*/report/checks/*' ! -path '*/report/scenes/*/checkpoint*' -print0 | LC_ALL=C sort -z | xargs -0 -r sha256sum
  } | sha256sum | cut -d' ' -f1)
if [[ -z $force && -f $build/book/index.html && -f $build/book/.inputs && $(<"$build/book/.inputs") == "$stamp" ]]; then
  echo "book: nothing changed: $build/book/index.html"
  exit 0
fi

pages=$build/book-src work=$build/book-work
rm -rf "$work"
mkdir -p "$work"
node docs/tools/expand.mjs --root . --build "$build" --registry "$registry" $strict

# BibTeX breaks lines, and one that began with "2007. " would be an item of a list: the year is tied to a space, which
# finish.mjs takes away.
sed 's/^\( *year *= {\)/\1~/' docs/references.bib >"$work/references.bib"

status=0
BOOK_PAGES=$pages BOOK_OUTPUT=$work BOOK_LOG=$work/warnings.txt \
  BIBINPUTS=.: BSTINPUTS=.: doxygen docs/Doxyfile >"$work/doxygen.txt" 2>&1 || status=$?
# Doxygen fails on a warning; which of them count is judged here.
[[ ! -s $work/warnings.txt ]] || status=0
node docs/tools/warnings.mjs --pages "$pages" --log "$work/warnings.txt" --root . || status=1
if (( status )) && [[ -z $draft || ! -f $work/html/index.html ]]; then
  cat "$work/doxygen.txt" >&2
  echo "book: not written; the warnings above are errors" >&2
  exit 1
fi

node docs/tools/finish.mjs --root . --html "$work/html" --pages "$pages" --registry "$registry"
node docs/tools/search_index.mjs --html "$work/html"
node docs/tools/check_links.mjs "$work/html" || [[ -n $draft ]]
node docs/tools/check_pages.mjs "$work/html" ${strict:+--whole} || [[ -n $draft ]]

[[ -n $draft ]] || echo "$stamp" >"$work/html/.inputs"
rm -rf "$build/book"
mv "$work/html" "$build/book"
echo "book: $build/book/index.html"
