#!/usr/bin/env bash
# mpi_run.sh ACTIO ACTIO_MPI MPIRUN: a run on several ranks writes what it writes on one, file by file; a run
# that was ended goes on with another number of ranks; what ranks cannot share is refused.
set -euo pipefail
actio=$1 actio_mpi=$2 mpirun=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 ASAN_OPTIONS=detect_leaks=0
ranks() { timeout 120 "$mpirun" --oversubscribe -n "$1" "$actio_mpi" "${@:2}"; }
fail() { printf '%s\n' "$1"; exit 1; }
hash_of() { sed -n 's/^  "hash": "\(.*\)",$/\1/p' "$1/summary.json"; }
# Everything that a run leaves is the same, but for how long it took and on how many ranks.
same() {
  for file in $(cd "$1" && find . -type f ! -name checkpoint ! -name '*.lock'); do
    cmp <(sed '/"wall_seconds"/d; /"ranks"/d' "$1/$file") <(sed '/"wall_seconds"/d; /"ranks"/d' "$2/$file") ||
      fail "$2/$file differs from $1/$file"
  done
}

cat >solid.toml <<'TOML'
[system]
kind = "elastic_body"
mesh = { shape = "box", lower = [-1, -0.5], upper = [1, 0.5], cells = [20, 23] }
material = { name = "neo_hookean", mu = 1, kappa = 3 }
boundary = { bottom = "fixed", left = "sliding" }
[initial]
velocity = ["0", "0.2*(Y + 0.5)*X"]
[run]
until = 2.0
every = 0.5
[output]
quantities = ["momentum", "energy", "min_jacobian"]
snapshots = ["jacobian"]
TOML
cat >gas.toml <<'TOML'
[system]
kind = "barotropic_fluid"
mesh = { shape = "box", lower = [0, 0, 0], upper = [1, 1, 1], cells = [6, 5, 9], periodic = [false, false, true] }
material = { name = "polytropic_gas", K = 1, gamma = 1.4 }
[initial]
velocity = ["0.1*sin(2*pi*Z)", "0", "0.1*cos(2*pi*Z)"]
[run]
until = 0.4
every = 0.1
[output]
quantities = ["momentum", "energy"]
snapshots = []
TOML

for scene in solid gas; do
  "$actio" run $scene.toml --out "$scene.one" --quiet
  [ -n "$(hash_of "$scene.one")" ] || fail "no hash in $scene.one/summary.json"
  for n in 1 2 3; do
    ranks $n run $scene.toml --out "$scene.$n" --quiet
    same "$scene.one" "$scene.$n"
  done
done

# The control: another start has another state.
"$actio" run solid.toml --out other --quiet --set 'initial.velocity=["0", "0.2001*(Y + 0.5)*X"]'
[ "$(hash_of solid.one)" != "$(hash_of other)" ] || fail "another start has the same hash"

# A run that is interrupted goes on with another number of ranks, and so does one of which a rank has died.
long=(--set run.until=1200 --set run.every=40 --quiet)
"$actio" run solid.toml --out whole "${long[@]}"
for signal in TERM KILL; do
  part=part_$signal
  ranks 3 run solid.toml --out $part "${long[@]}" >/dev/null 2>&1 &
  running=$!
  for _ in $(seq 400); do [ -s $part/series.csv ] && [ "$(wc -l <$part/series.csv)" -gt 3 ] && break; sleep 0.02; done
  # Rank 0 is asked to end; the last one is killed.
  pids=$(pgrep -f "^[^ ]*actio-mpi run solid.toml --out $part" | sort -n || true)
  if [ -n "$pids" ]; then
    [ $signal = TERM ] && pid=$(head -1 <<<"$pids") || pid=$(tail -1 <<<"$pids")
    kill -$signal "$pid" || true
  fi
  wait $running || true
  while pgrep -f "^[^ ]*actio-mpi run solid.toml --out $part" >/dev/null; do sleep 0.1; done
  ranks 2 resume $part --quiet >resumed.txt 2>&1 || fail "after $signal: $(cat resumed.txt)"
  [ "$(hash_of whole)" = "$(hash_of $part)" ] || fail "after $signal the state is another one"
  cmp whole/series.csv $part/series.csv
done

# What ranks cannot share, and more ranks than rows, is refused.
ranks 2 run apophis --out a --quiet >told.txt 2>&1 && fail "a body was shared among ranks"
grep -q 'not shared among 2 ranks' told.txt || fail "$(cat told.txt)"
ranks 2 run gas.toml --set system.mesh.cells='[4,4,3]' --out b --quiet >told.txt 2>&1 && fail "three planes on two ranks"
grep -q 'at most 1 ranks' told.txt || fail "$(cat told.txt)"
