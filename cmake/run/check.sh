# Sourced by ./run: `./run check`, and what was meant by a mistyped word.

# The id nearest to a mistyped one: the fewest letters to change, add or drop.
nearest() { # WORD, candidates on standard input
  awk -v word="$1" '
    function smaller(a, b) { return a < b ? a : b }
    function distance(s, t,   i, j, d) {
      for (i = 0; i <= length(s); i++) d[i, 0] = i
      for (j = 0; j <= length(t); j++) d[0, j] = j
      for (i = 1; i <= length(s); i++)
        for (j = 1; j <= length(t); j++)
          d[i, j] = smaller(smaller(d[i-1, j], d[i, j-1]) + 1, d[i-1, j-1] + (substr(s, i, 1) != substr(t, j, 1)))
      return d[length(s), length(t)]
    }
    # Of two that are as near, the one of the same length.
    { k = 2 * distance(word, $1) + (length(word) != length($1)); if (NR == 1 || k < best) { best = k; name = $1 } }
    END { print name }'
}

check_statements() { # ID... [OPTION VALUE]...
  local id ids=() options=() known line chapters=() chapter
  while (($#)); do
    case $1 in
      --balls) options+=("$1") ;;
      --digits | --modulo | --points | --seed | --columns)
        (($# > 1)) || fail "check: $1 needs a value" 2
        [[ $1 == --columns || $2 =~ ^[0-9]+$ ]] || fail "check: $1 wants a whole number, not '$2'" 2
        [[ $1 != --digits ]] || ((${#2} < 7 && 10#$2 >= 16 && 10#$2 <= 100000)) || fail "check: --digits wants 16 to 100000, not $2" 2
        options+=("$1" "$2")
        shift ;;
      --*) fail "check: unknown option '$1'; there are --digits, --modulo, --balls, --points, --columns, --seed" 2 ;;
      *) ids+=("$1") ;;
    esac
    shift
  done
  ((${#ids[@]})) || fail "check: which statement? For example: ./run check eq_3_10" 2
  known=$(grep -v '^#' proofs_checks/registry.tsv | tail -n +2 | cut -f 1)
  for id in "${ids[@]}"; do
    grep -qxF -- "$id" <<<"$known" || fail "unknown statement '$id'; did you mean '$(nearest "$id" <<<"$known")'?" 2
    line=$(grep -F "\"id\":\"$id\"" proofs_checks/statements.json || true)
    [[ -n $line ]] || fail "$id is in the registry, but has no check yet"
    chapters+=("$(sed -E 's/.*"chapter":"([a-z0-9]+)".*/\1/' <<<"$line")")
  done
  mapfile -t chapters < <(printf '%s\n' "${chapters[@]}" | sort -u)
  steps=3
  set_up
  build_targets "${chapters[@]/#/checks_}"
  local status=0 one here
  for chapter in "${chapters[@]}"; do
    here=()
    for id in "${ids[@]}"; do grep -F "\"id\":\"$id\"" proofs_checks/statements.json | grep -qF "\"chapter\":\"$chapter\"" && here+=("$id"); done
    one=0
    "$build/bin/checks_$chapter" "${here[@]}" "${options[@]}" --report "$build/report/selected" || one=$?
    ((one > status)) && status=$one
  done
  return "$status"
}
