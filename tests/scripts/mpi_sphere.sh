#!/usr/bin/env bash
# mpi_sphere.sh ACTIO ACTIO_MPI MPIRUN: the fluid on the sphere on two ranks and on three, whose matrices
# ScaLAPACK multiplies, and that on the torus. State, energy, angular momentum and spectrum are those of one
# process to rounding.
#
# The bound: the products of a step are of N terms and A is below one, so that a step changes the flow by at
# most N roundings of it, and so many steps by as many times that; no step amplifies it.
# shellcheck source=tests/scripts/on_ranks.sh
. "$(dirname "$0")/on_ranks.sh" 120 "$@"
size=64 steps=2
bound=$(awk "BEGIN { print $size * $steps * 2.2e-16 }")

cat >flow.toml <<TOML
[system]
kind = "vorticity_sphere"
N = $size
rotation = 0.3
[initial]
random = { lmax = 63, slope = -3 }
[method]
name = "all_invariants"
precision = "double"
step = 0.02
[run]
until = $(awk "BEGIN { print $steps * 0.02 }")
every = $(awk "BEGIN { print $steps * 0.02 }")
[output]
quantities = ["energy", "angular_momentum", "eigenvalues"]
snapshots = []
TOML

# states_apart FOLDER FOLDER: by how much the coefficients of both differ at the end, in units of their
# norm.
states_apart() {
  paste -d, "$1/snapshots/000001.harmonics.csv" "$2/snapshots/000001.harmonics.csv" | awk -F, '
    NR > 1 { n = n + $3^2 + $4^2; d = d + ($3 - $7)^2 + ($4 - $8)^2 } END { printf "%.3g\n", sqrt(d / n) }'
}
# The same of the columns of the last row whose names begin so, in units of the largest.
columns_apart() {
  paste -d'\n' <(head -1 "$1/series.csv") <(tail -1 "$1/series.csv") <(tail -1 "$2/series.csv") | awk -F, -v name="$3" '
    NR == 1 { split($0, names) } NR == 2 { split($0, one) }
    NR == 3 { for (k = 1; k <= NF; ++k) if (index(names[k], name) == 1) {
      a = one[k] < 0 ? -one[k] : one[k]; b = $k - one[k]; if (b < 0) b = -b
      if (a > largest) largest = a; if (b > d) d = b; ++count } }
    END { if (!count) exit 1; printf "%.3g\n", d / largest }'
}
below() { awk "BEGIN { exit !($1 <= $2) }"; }

"$actio" run flow.toml --out one --quiet 2>/dev/null
ranks 2 run flow.toml --out on_2 --quiet 2>/dev/null
apart=$(states_apart one on_2)
below "$apart" "$bound" || fail "the state is $apart away, more than $bound"
for name in energy angular_momentum eigenvalues; do
  apart=$(columns_apart one on_2 $name)
  below "$apart" "$bound" || fail "$name differs by $apart, more than $bound"
done

# In mixed precision the state is one to 1e-8 of the change in a step, and what is conserved as above. This is
# the control as well: two states that differ by that are told apart.
mixed=(--set method.precision=mixed --quiet)
"$actio" run flow.toml --out mixed "${mixed[@]}" 2>/dev/null
ranks 3 run flow.toml --out on_3 "${mixed[@]}" 2>/dev/null
apart=$(states_apart mixed on_3)
below "$apart" "$(awk "BEGIN { print $steps * 1e-8 }")" || fail "in mixed precision the state is $apart away"
for name in energy angular_momentum eigenvalues; do
  apart=$(columns_apart mixed on_3 $name)
  below "$apart" "$bound" || fail "in mixed precision $name differs by $apart, more than $bound"
done
! below "$(states_apart one mixed)" "$bound" || fail "mixed precision is not told from double"

# A flow on the torus takes the same way.
cat >torus.toml <<TOML
[system]
kind = "vorticity_torus"
N = 63
[initial]
random = { first = 1, last = 31 }
[method]
precision = "double"
step = 0.01
[run]
until = 0.02
every = 0.02
[output]
quantities = ["energy", "enstrophy"]
snapshots = []
TOML
"$actio" run torus.toml --out torus --quiet 2>/dev/null
ranks 2 run torus.toml --out torus_on_2 --quiet 2>/dev/null
apart=$(states_apart torus torus_on_2)
below "$apart" "$bound" || fail "on the torus the state is $apart away, more than $bound"
for name in energy enstrophy; do
  apart=$(columns_apart torus torus_on_2 $name)
  # Both are quadratic.
  below "$apart" "$(awk "BEGIN { print 2 * $bound }")" || fail "on the torus $name differs by $apart"
done
