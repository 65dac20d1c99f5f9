#!/usr/bin/env bash
# mpi_run.sh ACTIO ACTIO_MPI MPIRUN: a run on several ranks writes what it writes on one, file by file; a run
# that was ended goes on with another number of ranks; what ranks cannot share is refused.
# shellcheck source=tests/scripts/on_ranks.sh
. "$(dirname "$0")/on_ranks.sh" 300 "$@"
hash_of() { sed -n 's/^  "hash": "\(.*\)",$/\1/p' "$1/summary.json"; }
# Everything that a run leaves is the same, but for how long it took and on how many ranks.
same() {
  local apart='/"wall_seconds"/d; /"ranks"/d; /"rows_per_rank"/d; /"seconds_in_copies"/d'
  for file in $(cd "$1" && find . -type f ! -name checkpoint ! -name '*.lock'); do
    cmp <(sed "$apart" "$1/$file") <(sed "$apart" "$2/$file") || fail "$2/$file differs from $1/$file"
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
mesh = { shape = "box", lower = [0, 0, 0], upper = [1, 1, 1], cells = [6, 5, 14], periodic = [false, false, true] }
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
# So large that threads share the rows of a rank.
sed 's/\[20, 23\]/[400, 253]/; s/until = 2.0/until = 0.02/; s/every = 0.5/every = 0.01/; /snapshots/d' solid.toml >large.toml

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

# Water in a tank, which is heavy.
cat >water.toml <<'TOML'
[system]
kind = "incompressible_fluid"
mesh = { shape = "box", lower = [0, 0], upper = [1, 0.7], cells = [24, 56] }
boundary = { left = "sliding", right = "sliding", bottom = "sliding" }
load = { gravity = "9.81*y" }
[initial]
velocity = ["-0.1*sin(pi*X)", "0.1*pi*Y*cos(pi*X)"]
project = true
[run]
until = 0.1
every = 0.02
[output]
quantities = ["momentum", "energy", "volume_defect", "min_jacobian"]
snapshots = ["pressure"]
TOML

check() {
  [ -d "$1.one" ] || ACTIO_THREADS=1 "$actio" run "$1.toml" --out "$1.one" --quiet
  [ -n "$(hash_of "$1.one")" ] || fail "no hash in $1.one/summary.json"
  ACTIO_THREADS=$3 ranks "$2" run "$1.toml" --out "$1.$2.$3" --quiet 2>told.txt || fail "$(cat told.txt)"
  same "$1.one" "$1.$2.$3"
}
for n in 1 2 4 7; do check solid $n 1; done
for n in 3 7; do check gas $n 1; done
check large 1 2
check large 2 2
grep -q '"rows_per_rank": 127,' large.2.2/summary.json || fail "$(cat large.2.2/summary.json)"
for n in 2 3; do check mesh $n 1; done
for n in 2 7; do check water $n 1; done

# The control: another start has another state.
"$actio" run solid.toml --out other --quiet --set 'initial.velocity=["0", "0.2001*(Y + 0.5)*X"]'
[ "$(hash_of solid.one)" != "$(hash_of other)" ] || fail "another start has the same hash"

# More ranks than cores are told.
taskset -c 0 "$mpirun" --oversubscribe --bind-to none -n 2 "$actio_mpi" run solid.toml --out crowded --quiet 2>told.txt
grep -q '^actio-mpi: 2 ranks share 1 cores' told.txt || fail "$(cat told.txt)"
# Ranks with other registers use those of the least, and another program is refused.
if grep -qw avx2 /proc/cpuinfo && grep -qw fma /proc/cpuinfo; then
  ACTIO_REGISTERS=baseline ranks 1 run solid.toml --out baseline --quiet
  on -n 1 "$actio_mpi" run solid.toml --out mixed --quiet : -n 1 -x ACTIO_REGISTERS=baseline "$actio_mpi" run \
    solid.toml --out mixed --quiet 2>told.txt
  grep -q '^actio-mpi: all ranks use registers of the kind baseline, since rank 1' told.txt || fail "$(cat told.txt)"
  [ "$(hash_of mixed)" = "$(hash_of baseline)" ] || fail "registers of two kinds were mixed"
  [ "$(hash_of mixed)" != "$(hash_of solid.one)" ] || fail "other registers round alike"
fi
ACTIO_REGISTERS=avx3 ranks 2 run solid.toml --out unlike --quiet 2>told.txt && fail "unknown registers were taken"
grep -q '^actio-mpi: rank 0: ACTIO_REGISTERS must be' told.txt || fail "$(cat told.txt)"
cp "$actio_mpi" another && printf x >>another
on -n 1 "$actio_mpi" run solid.toml --out unlike --quiet : -n 1 ./another run solid.toml --out unlike --quiet \
  2>told.txt && fail "two programs shared a run"
grep -q '^actio-mpi: the program of rank 1 is not that of rank 0' told.txt || fail "$(cat told.txt)"
[ ! -e unlike ] || fail "two programs have made a folder"

# A run that is interrupted goes on with another number of ranks, and on one does one of which a rank, or
# mpirun, was killed; the others end then.
long=(--set run.until=800 --set run.every=40 --quiet)
"$actio" run solid.toml --out whole "${long[@]}"
for ended in first last mpirun; do
  part=part_$ended
  running() { pgrep -f "^[^ ]*actio-mpi run solid.toml --out $part" | sort -n; }
  "$mpirun" --oversubscribe -n 3 "$actio_mpi" run solid.toml --out $part "${long[@]}" >/dev/null 2>told.txt &
  mpirun_is=$!
  for _ in $(seq 400); do [ -s $part/series.csv ] && [ "$(wc -l <$part/series.csv)" -gt 3 ] && break; sleep 0.02; done
  case $ended in
    first) kill -TERM "$(running | head -1)" ;;
    last) kill -KILL "$(running | tail -1)" ;;
    mpirun) kill -KILL $mpirun_is ;;
  esac || fail "the run had ended before its $ended"
  since=$SECONDS
  wait $mpirun_is 2>/dev/null || true
  while running >/dev/null; do
    [ $((SECONDS - since)) -le 10 ] || fail "$ended has ended, and ten seconds later other ranks have not"
    sleep 0.05
  done
  [ $ended != last ] || grep -q 'exited on signal 9' told.txt || fail "who was killed is not told: $(cat told.txt)"
  go_on=("$actio")
  [ $ended != first ] || go_on=(ranks 2)
  # Ranks without mpirun go on for about a second, in which a fast machine may end the run.
  [ ! -e $part/summary.json ] || [ $ended = first ] || go_on=(true)
  "${go_on[@]}" resume $part --quiet >resumed.txt 2>&1 || fail "after the $ended: $(cat resumed.txt)"
  [ "$(hash_of whole)" = "$(hash_of $part)" ] || fail "after the $ended the state is another one"
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

# A full disk ends a run on ranks as it ends another one. Where none can be mounted, that is left out.
if unshare -rm true 2>/dev/null && mkdir full && unshare -rm mount -t tmpfs -o size=64k none full 2>/dev/null; then
  full() { unshare -rm bash -c 'mount -t tmpfs -o size=64k none full && "$@" --out full/run --set run.every=0.001' bash "$@"; }
  full "$actio" run solid.toml --quiet 2>told.txt && fail "a full disk went unnoticed" || one=$?
  full timeout 120 "$mpirun" --oversubscribe -n 2 "$actio_mpi" run solid.toml --quiet 2>told_2.txt &&
    fail "a full disk went unnoticed by two ranks" || two=$?
  if [ "$one" != 4 ] || [ "$two" != 4 ] || ! grep -qxF "$(cat told.txt)" told_2.txt; then
    fail "$one, $two: $(cat told.txt told_2.txt)"
  fi
fi
