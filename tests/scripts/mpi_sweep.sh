#!/usr/bin/env bash
# mpi_sweep.sh ACTIO ACTIO_MPI MPIRUN: a sweep on two ranks writes what the same sweep writes on one machine,
# and where a rank dies the others end.
# shellcheck source=tests/scripts/on_ranks.sh
. "$(dirname "$0")/on_ranks.sh" 60 "$@"

cat >apophis.toml <<'TOML'
[system]
kind = "rigid_body"
body = "apophis"
[initial]
angular_velocity = [0.0649, 0.001, 0.22321]
[method]
order = 2
step = 0.25
[run]
until = 25.0
every = 2.5
[output]
quantities = ["body_momentum", "energy"]
TOML

# The same members, one of them wrong.
over=(--over "method.step=0.125,0.25,fast" --over "run.until=10,15,20")
timeless() { awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "wall_seconds") clock = i } { $clock = ""; print }' "$1/sweep.csv"; }
one=0 two=0
"$actio" sweep apophis.toml "${over[@]}" --out one >one.out 2>one.err || one=$?
ranks 2 apophis.toml "${over[@]}" --out two >two.out 2>two.err || two=$?
[[ $one == 2 && $two == 2 ]] || { cat two.err; fail "a wrong member ends a sweep with status 2, not $one on one machine and $two on ranks"; }
diff <(timeless one) <(timeless two) || fail "the tables differ in more than the time"
for member in one/0*; do
  for file in series.csv scene.toml; do cmp "$member/$file" "two/${member#one/}/$file"; done
done
members=(one/0*)
[[ ${#members[@]} == 6 && $(wc -l <two/sweep.csv) == 10 ]] || fail "six members run and three are told of alone, not ${members[*]}"
diff <(sort one.err) <(grep '^00000' two.err | sort) || fail "the failed members are not named alike"
grep -q "two: 9 members, 6 done, 3 failed (status 2), in .* s; table two/sweep.csv" two.out || fail "no closing line: $(cat two.out)"

# Without one member in order nothing is left, and the ranks do not wait for each other.
two=0
ranks 2 apophis.toml --over method.stp=1,2,3 --out none >none.err 2>&1 || two=$?
if ! [[ $two == 2 && ! -e none ]] || ! grep -q "did you mean 'step'?" none.err; then
  cat none.err
  fail "an unknown key ended with status $two"
fi

# One member at a time and two at a time on each rank, more ranks than members.
ranks 2 apophis.toml --over method.step=0.125 --jobs 2 --out single --quiet
[[ $(wc -l <single/sweep.csv) == 2 ]] || fail "a sweep of one member on two ranks leaves another table"

# A rank, and then mpirun itself, is killed in the midst of members that would take days.
killed() { # FOLDER rank|mpirun
  local mpirun_process members status=0
  "$mpirun" --oversubscribe -n 2 "$actio_mpi" apophis.toml --over scene.seed=1,2,3,4 --set run.until=2.5e13 --set run.every=2.5e12 --out "$1" >"$1.err" 2>&1 &
  mpirun_process=$!
  for _ in $(seq 100); do
    [[ -e $1/000000/checkpoint && -e $1/000001/checkpoint ]] && break
    sleep 0.1
  done
  read -r -a members <"/proc/$mpirun_process/task/$mpirun_process/children" || true  # no end of line
  if [[ $2 == rank ]]; then kill -KILL "${members[1]}"; else kill -KILL "$mpirun_process"; fi
  for process in "$mpirun_process" "${members[@]}"; do
    timeout 30 tail --pid="$process" -f /dev/null || { kill -KILL "$process"; fail "30 s after the death of $2 a process of the sweep was still there"; }
  done
  wait "$mpirun_process" || status=$?
  ((status != 0)) || { cat "$1.err"; fail "a sweep whose $2 was killed ended with status 0"; }
  [[ $(head -c 1 "$1/000000/series.csv") == t ]] || fail "the members of a sweep whose $2 was killed are gone"
}
killed one_rank_less rank

# A sweep that was interrupted is resumed, on ranks and on one machine, to the same table.
long=(apophis.toml --over "run.until=10,1000000,15,1200000" --set run.every=5)
"$actio" sweep "${long[@]}" --out unbroken --quiet
for how in ranks alone; do
  timeout -s INT 1 "$actio" sweep "${long[@]}" --out "$how" --jobs 1 --quiet 2>/dev/null || true
  if [[ $how == ranks ]]; then ranks 2 --resume ranks --quiet; else "$actio" resume alone --quiet; fi
  diff <(timeless unbroken) <(timeless "$how") || fail "the table of a sweep that went on ($how) is another"
done
killed no_mpirun mpirun

echo "Six members are the same on one machine and on two ranks; a sweep whose rank or mpirun dies ends."
