# Sourced by ./run: benchmarks and long tests, and the record of their figures.

# Names of the benchmarks that this build has; of the long tests whose figures a page shows.
benchmarks() { ninja -C "$build" -t targets all | sed -n 's/^bin\/\(bench_[a-z0-9_]*\): .*/\1/p' | sort -u; }
shown_long_tests() { cat docs/pages/*.md chapters/*/*.md | grep -oE '\\(figure|table|picture)\{stress_[a-z0-9_]+' | sed 's/.*{//' | sort -u; }

# One after the other, so that none disturbs another. A time that misses its bound is shown in the book and
# fails nothing here.
run_short_benchmarks() {
  step "short benchmarks"
  local name ran=0 current=0 beyond=0 failed=() folder=$build/report/benchmarks
  mkdir -p "$folder"
  # Curves of work and precision have no short form.
  for name in $(benchmarks | grep -v '^bench_precision_'); do
    if ACTIO_ONCE=1 bash cmake/tools/measure.sh "$build" "$name" --short >"$folder/$name.log" 2>&1; then
      if grep -q '^current:' "$folder/$name.log"; then current=$((current + 1)); else ran=$((ran + 1)); fi
      beyond=$((beyond + $(grep -c 'a claim does not hold' "$folder/$name.log" || true)))
    else
      failed+=("$name")
      tail -n 30 "$folder/$name.log" | sed 's/^/    /' >&2
    fi
  done
  ((${#failed[@]} == 0)) || fail "these benchmarks failed: ${failed[*]}"
  note "$ran run, $current current$( ((beyond == 0)) || echo ", $beyond times beyond their bounds")"
}

run_each() { # KIND FOLDER PREFIX [STEPS]: builds and runs every FOLDER/*.cpp in full; STEPS more will follow
  local kind=$1 folder=$2 prefix=$3 source names=() failed=()
  for source in "$folder"/*.cpp; do [[ -f $source ]] && names+=("${prefix}_$(basename "$source" .cpp)"); done
  ((${#names[@]})) || { echo "There is no $kind yet: $folder/ holds no program."; return 0; }
  steps=$((3 + ${#names[@]} + ${4:-0}))
  [[ ! -f $build/book/index.html ]] || steps=$((steps + 1))
  set_up
  build_targets "${names[@]}"
  for source in "${names[@]}"; do
    step "$source"
    printf '\n%s\n' "$step_title"
    if bash cmake/tools/measure.sh "$build" "$source"; then
      echo
      note "done"
    else
      failed+=("$source")
      echo
      note "FAILED"
    fi
  done
  [[ ! -f $build/book/index.html ]] || write_book
  printf '\n%d of %d passed; their figures are in the book%s.\n' $((${#names[@]} - ${#failed[@]})) ${#names[@]} \
    "$([[ -f $build/book/index.html ]] || echo " that ./run will write")"
  ((${#failed[@]} == 0)) || fail "these failed, and said above why: ${failed[*]}"
}

# The checks over a second prime field and in 200 digits: what a prime, or a hundred digits, may hide.
run_long_checks() {
  step "checks, another prime"
  ninja --quiet -C "$build" -j "$jobs" checks || fail "the build failed"
  local section failed=() count=0 said
  mkdir -p "$build/report/checks_long"
  for section in $(checked_sections); do
    count=$((count + 1))
    said=$("$build/bin/checks_${section%%_*}" --source "$section" --columns prime --modulo 2305843009213693907 --seed 7 --brief --report "$build/report/checks_long" 2>&1) ||
      { failed+=("$section"); grep -E '^FAILED|^checks_' <<<"$said" >&2; }
  done
  ((${#failed[@]} == 0)) || fail "these failed: ${failed[*]}"
  note "$count sections passed"
}

# ./run record [WHAT...]: what is recorded was measured with the executables of the commit that the record
# names, so these are brought up to date first.
record_release() { # [bench | stress | checks | proofs]...
  local what targets=() names=()
  (($#)) || set -- bench stress checks proofs
  for what in "$@"; do
    case $what in
      bench | stress | checks | proofs) ;;
      *) fail "record: unknown word '$what'; there are bench, stress, checks and proofs" 2 ;;
    esac
  done
  local commit
  commit=$(git rev-parse --short=10 HEAD 2>/dev/null) || fail "record: this is no git repository, so there is no commit for the record to name"
  [[ -z $(git status --porcelain -- . ':!docs') ]] || fail "record: sources differ from the commit $commit, which the record would name; commit them first"
  steps=4
  set_up
  for what in "$@"; do
    case $what in
      bench) mapfile -t names < <(benchmarks) ;;
      stress) mapfile -t names < <(shown_long_tests) ;;
      checks) names=(checks) ;;
      proofs) names=() ;;
    esac
    targets+=("${names[@]}")
  done
  ((${#targets[@]} == 0)) || build_targets "${targets[@]}"
  step "record"
  node docs/tools/record.mjs --build "$build" --commit "$commit" --what "$*" || fail "the release is not recorded in full; what is missing is named above"
  note "docs/release"
}
