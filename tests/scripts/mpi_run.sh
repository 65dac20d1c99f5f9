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

# Triangles of a file, with a pressure, a moved side and one that slides.
awk 'BEGIN {
  n = 8
  print "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n1 1 \"left\"\n1 2 \"right\"\n1 3 \"bottom\""
  print "$EndPhysicalNames\n$Nodes\n" (n + 1) ^ 2
  for (k = 0; k < (n + 1) ^ 2; ++k) print k + 1, k % (n + 1) / n, int(k / (n + 1)) / n, 0
  print "$EndNodes\n$Elements\n" 2 * n * n + 3 * n
  for (k = 1; k <= n; ++k) {
    a = 1 + (k - 1) * (n + 1)
    print ++e, 1, 2, 1, 1, a + n + 1, a "\n" ++e, 1, 2, 2, 2, a + n, a + 2 * n + 1 "\n" ++e, 1, 2, 3, 3, k, k + 1
    for (b = a; b < a + n; ++b) print ++e, 2, 2, 9, 1, b, b + 1, b + n + 2 "\n" ++e, 2, 2, 9, 1, b, b + n + 2, b + n + 1
  }
  print "$EndElements"
}' >square.msh
cat >mesh.toml <<'TOML'
[system]
kind = "elastic_body"
mesh = { shape = "file", file = "square.msh" }
material = { name = "neo_hookean", mu = 1, kappa = 3 }
boundary = { bottom = "sliding" }
[system.load]
motion.left = ["X - 0.1*t^2", "Y + 0.1*t^2"]
pressure.right = "0.2*sin(3*t)"
gravity = "0.1*y"
[run]
until = 1
every = 0.25
[output]
quantities = ["momentum", "energy", "min_jacobian"]
snapshots = ["jacobian"]
TOML

for scene in solid gas mesh; do
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

# A run that turns a cell inside out ends on ranks with the words of one, and leaves what that leaves.
crush=(--set 'system.load.pressure.right="20"' --quiet)
"$actio" run mesh.toml --out crushed.one "${crush[@]}" 2>one.txt && fail "nothing was turned inside out"
ranks 2 run mesh.toml --out crushed.two "${crush[@]}" 2>two.txt && fail "nothing was turned inside out on ranks"
grep -q 'inside out' one.txt || fail "$(cat one.txt)"
diff <(sed 's/crushed.one/OUT/' one.txt) <(sed 's/crushed.two/OUT/; /^---/,$d' two.txt)
same crushed.one crushed.two

# What ranks cannot share, and more ranks than rows, is refused.
ranks 2 run apophis --out a --quiet >told.txt 2>&1 && fail "a body was shared among ranks"
grep -q 'not shared among 2 ranks' told.txt || fail "$(cat told.txt)"
ranks 2 run gas.toml --set system.mesh.cells='[4,4,3]' --out b --quiet >told.txt 2>&1 && fail "three planes on two ranks"
grep -q 'at most 1 ranks' told.txt || fail "$(cat told.txt)"
