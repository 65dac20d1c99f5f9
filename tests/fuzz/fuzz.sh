#!/usr/bin/env bash
# fuzz.sh FOLDER [SECONDS]: compiles the reader of scenes with clang's sanitisers into FOLDER, and feeds it
# with what libFuzzer makes of the corpus here.
#
# Status: 0 where nothing was found; 1 where something was, which is kept in FOLDER/found; 2 where clang is
# missing and cannot be installed. ACTIO_FUZZ_SECONDS is how long, 600 otherwise; ACTIO_FUZZ_SEED the seed.
set -euo pipefail
folder=$1
seconds=${2:-${ACTIO_FUZZ_SECONDS:-600}}
seed=${ACTIO_FUZZ_SEED:-1971}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(realpath "$here/../..")
mkdir -p "$folder/grown" "$folder/found"

packages=(clang-14 libclang-rt-14-dev)
if ! command -v clang++-14 >/dev/null || ! compgen -G '/usr/lib/llvm-14/lib/clang/*/lib/linux/libclang_rt.fuzzer-*.a' >/dev/null; then
  if [[ $(id -u) != 0 ]]; then
    printf '%s\n' "The fuzzer needs clang. Please type" "" "  sudo apt-get update && sudo apt-get install ${packages[*]}" "" "and start again." >&2
    exit 2
  fi
  export DEBIAN_FRONTEND=noninteractive
  apt-get update -qq >/dev/null
  apt-get install -y -qq --no-install-recommends "${packages[@]}" >/dev/null
fi

# The library that reads TOML is compiled in, so that its branches are seen, too.
watched="-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all"
cmake -S "$root" -B "$folder" -G Ninja -DCMAKE_CXX_COMPILER=clang++-14 -DCMAKE_BUILD_TYPE=Fuzzing -DACTIO_FUZZER=ON -DACTIO_BUILD_APP=ON -DACTIO_BUILD_CHAPTERS=OFF \
  -DACTIO_BUILD_CHECKS=OFF -DACTIO_BUILD_TESTS=OFF -DACTIO_BUILD_BENCHMARKS=OFF \
  -DCMAKE_CXX_FLAGS="-O1 -g1 $watched -Wno-macro-redefined -DTOML_HEADER_ONLY=1 -UTOML_SHARED_LIB" >"$folder/configure.log" 2>&1 ||
  { cat "$folder/configure.log" >&2; exit 1; }
ninja --quiet -C "$folder" -j "${ACTIO_JOBS:-$(nproc)}" fuzz_scenes

program=$(find "$folder/bin" "$folder/tests" -name fuzz_scenes -type f -print -quit 2>/dev/null)
export UBSAN_OPTIONS=print_stacktrace=1
status=0
"$program" -max_total_time="$seconds" -seed="$seed" -dict="$here/scene.dict" -timeout=20 -rss_limit_mb=2048 -max_len=4096 -print_final_stats=1 -artifact_prefix="$folder/found/" \
  "$folder/grown" "$here/corpus" >"$folder/fuzz.log" 2>&1 || status=1
grep -E '^stat::number_of_executed_units|^stat::average_exec_per_sec|^stat::peak_rss_mb' "$folder/fuzz.log" || true
printf 'coverage: %s\n' "$(grep -oE 'cov: [0-9]+ ft: [0-9]+ corp: [0-9]+' "$folder/fuzz.log" | tail -n 1)"
if ((status)); then
  tail -n 60 "$folder/fuzz.log"
  ls "$folder/found"
fi
exit "$status"
