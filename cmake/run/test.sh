# Sourced by ./run: `./run test`, `./run proofs`.

test_all() { # [--all] [--again]
  local once=1 targets=(all checks) chosen=(-LE '^all$')
  while (($#)); do
    case $1 in
      --all) chosen=() targets+=(long_tests) ;;
      --again) once=0 ;;
      *) fail "test: unknown argument '$1'; there are --all and --again" 2 ;;
    esac
    shift
  done
  steps=$((${#chosen[@]} ? 4 : 6))
  set_up
  build_targets "${targets[@]}"
  step "tests"
  echo
  local status=0
  ACTIO_ONCE=$once ctest --test-dir "$build" -j "$jobs" "${chosen[@]}" --output-on-failure || status=$?
  local figures shown
  for figures in "$build"/report/figures/*.txt; do
    [[ -s $figures ]] || continue
    shown=$(sed -e '/^Running [0-9]* test case/d' -e '/^\*\*\* /d' -e '/^ *$/d' -e 's/^/    /' "$figures")
    [[ -z $shown ]] || printf '\n  measured by %s\n%s\n' "$(basename "$figures" .txt)" "$shown"
  done
  local current
  current=$(grep -c '^current:' "$build/Testing/Temporary/LastTest.log" || true)
  ((current == 0)) || echo "$current of them were current and not run again; ./run test --again runs them all."
  note "$([[ $status == 0 ]] && echo "all passed" || echo "FAILED")"
  if ((${#chosen[@]} == 0)); then
    read_by_second_compiler
    open_book_pages
  fi
  return "$status"
}

# The library, the programs, the checks and the tests, read by clang where it is installed.
read_by_second_compiler() {
  step "a second compiler"
  local said
  said=$(node cmake/tools/second_compiler.mjs "$build" "$jobs" 2>&1) || { printf '%s\n' "$said" >&2; fail "a second compiler refuses what is said above"; }
  note "$(tail -n 1 <<<"$said")"
}

# Every page of the book in a browser, where there is one.
open_book_pages() {
  step "pages of the book"
  [[ -f $build/book/index.html ]] || { note "no book yet; ./run book writes it"; return 0; }
  local said
  said=$(node tests/stress/browser/book_pages.mjs "$build/book" 2>&1) || { printf '%s\n' "$said" >&2; fail "pages of the book fall short of what is said above"; }
  note "$(tail -n 1 <<<"$said")"
}

# The kernel's proofs need no C++.
check_proofs() {
  steps=2
  step "packages"
  local said
  said=$(bash cmake/tools/packages.sh proofs) || exit $?
  note "$said"
  step "proofs"
  mkdir -p "$build/report"
  said=$(node cmake/tools/proofs.mjs . "$build" "$jobs") || fail "the proofs do not stand; what the kernel said is above"
  note "$said"
}
