# Sourced by ./run: steps with their times, setting up and building.

started=$SECONDS
step_number=0
steps=0
now() { date +%s%N; }

step() { # TITLE: opens a step
  step_number=$((step_number + 1))
  step_began=$(now)
  step_title=$(printf '[%d/%d] %s' "$step_number" "$steps" "$1")
  [[ -t 1 ]] && printf '%s ...\r' "$step_title"
  return 0
}
note() { # TEXT: closes it
  local tenths=$((($(now) - step_began) / 100000000))
  printf '%-36s %-56s %4d.%d s\n' "$step_title" "$1" $((tenths / 10)) $((tenths % 10))
}

set_up() {
  step "packages"
  local said
  said=$(bash cmake/tools/packages.sh) || exit $?
  note "$said"

  step "configure"
  if [[ -f $build/build.ninja ]] && grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt"; then
    note "current"
  else
    mkdir -p "$build"
    cmake --fresh --preset release -B "$build" >"$build/configure.log" 2>&1 || { cat "$build/configure.log" >&2; fail "CMake failed"; }
    note "done, Release, $jobs jobs"
  fi
}

build_targets() { # TARGET...
  step "build"
  local log=$build/report/compile_log.tsv before after
  mkdir -p "$build/report"
  touch "$log"
  before=$(wc -l <"$log")
  if [[ -t 1 ]]; then ninja -C "$build" -j "$jobs" "$@" || fail "the build failed"
  else ninja --quiet -C "$build" -j "$jobs" "$@" | sed -e '/^ninja: no work to do/d' -e '/^-- /d' || fail "the build failed"; fi
  after=$(wc -l <"$log")
  if ((after == before)); then note "current"; else note "$((after - before)) files compiled"; fi
}
