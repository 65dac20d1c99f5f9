#!/usr/bin/env bash
# The book on trial: a small project is written, its book must come out whole; then one thing at a time is broken, and the
# book must refuse it with the place and the reason.
set -uo pipefail
docs=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

project() {
  rm -rf "$work/p"
  mkdir -p "$work"/p/{src/actio/reduction,src/book,chapters/ch03_sample,proofs_checks,data,build/report/programs}
  cp -r "$docs" "$work/p/docs"
  cd "$work/p" || exit 1
  # Pages that speak of the real library are not under test.
  rm -f docs/pages/1[12]_*.md docs/pages/2[2-9]_*.md docs/pages/40_*.md
  sed -i '/scenes\|conventions\|notation\|bibliography\|performance\|^.picture/d' docs/pages/00_mainpage.md
  printf '/** @namespace actio\n The library. */\n' >docs/namespaces.dox
  printf 'id\tkind\tchapter\tsection\tsubject\neq_3_9\tequation\t3\t3.2\tquotient map\nthm_3_2_3\ttheorem\t3\t3.2\treconstruction\nclaim_3_2_small\tclaim\t3\t3.2\tsmall claim\neq_6_1\tequation\t6\t6.1\tlater\n' >proofs_checks/registry.tsv
  printf '// Checks.\nSTATEMENT(eq_3_9, "quotient") {\n}\n' >proofs_checks/ch03_2.cpp
  printf '[{"id":"eq_3_9","source":"proofs_checks/ch03_2.cpp","chapter":"ch03","columns":["prime"],"title":"quotient"}]\n' >proofs_checks/statements.json
  cat >src/actio/reduction/relative_motion.hpp <<'X'
// Relative motions.
#pragma once
namespace actio {
/// The motion between two places, \f$f = g_0g_1^{-1}\f$.
/// \implements{eq_3_9}
template <class E>
E relative_motion(E const& g0, E const& g1) {
  // [eq_3_9]
  return g0 * inverse(g1);
  // [eq_3_9]
}
}  // namespace actio
X
  cat >chapters/ch03_sample/chapter.md <<'X'
# Sample {#ch03}

As \cite pekarsky2000 has it, \ref eq_3_9 holds: \verdict{eq_3_9}, \figure{ch03_wheel,drift}.

\beside{eq_3_9}
\f[ f_{01} = g_0\, g_1^{-1} \f]
\asCode
\snippet reduction/relative_motion.hpp eq_3_9
\endbeside

\statement{thm_3_2_3,Theorem 3.2.3, in words}
Nothing is lost, \f$\Ad^*_g\mu\f$.
\endstatement

\evidence{thm_3_2_3}

\program{ch03_wheel}

\picture{ch03_wheel,path}

\table{ch03_wheel,orders,A table, with a comma}

## Verified

\verified{3}
X
  printf '// A wheel.\nint main() {}\n' >chapters/ch03_sample/wheel.cpp
  cat >build/report/programs/ch03_wheel.json <<'X'
{"chapter":"ch03","program":"ch03_wheel","shows":"a wheel","headline":{"text":"drift 1e-15","value":1e-15},"figures":[{"name":"drift","value":1e-15,"text":"1e-15"}],
 "tables":[{"name":"orders","header":["scheme","order"],"rows":[["DEP","2.0"]]}],"pictures":[{"name":"path","file":"ch03_wheel.path.svg","caption":"A path"}],"seconds":0.1}
X
  echo 'all is well' >build/report/programs/ch03_wheel.txt
  echo '<svg xmlns="http://www.w3.org/2000/svg" width="10" height="10"><path id="a" d="M0 0L9 9"/></svg>' >build/report/programs/ch03_wheel.path.svg
  cat >build/report/statements.json <<'X'
[{"id":"eq_3_9","title":"q","verdict":"holds","evidence":[{"what":"both sides","kind":"exact","scalar":"rational","model":"SE(3)","measured":0,"bound":0,"points":20,"degree":4,"probability":1e-40}],"control":[{"what":"other side","measured":0.5,"floor":0.001}]},
 {"id":"thm_3_2_3","title":"t","verdict":"corrected","printed":"a=b","corrected":"a=-b","note":"a sign, $\\mu$, and mu -> Ad*_{f(mu)} mu as in eq_3_9","scan":true,"evidence":[{"what":"residual","kind":"precision","scalar":"double","model":"SE(3)","measured":1e-15,"bound":1e-13,"epsilon":2.2e-16}],"control":[{"what":"as printed","measured":0.5,"floor":0.001}]},
 {"id":"claim_3_2_small","title":"s","verdict":"scope","note":"nothing to compute","evidence":[],"control":[]},
 {"id":"eq_6_1","title":"l","verdict":"pending","evidence":[],"control":[]}]
X
}
book() { docs/tools/book.sh build "$@" >"$work/out" 2>&1; }
passes() {
  if book "${@:2}"; then echo "ok      $1"; else echo "FAILED  $1"; cat "$work/out"; failures=$((failures + 1)); fi
}
refuses() {  # name, what must be said
  if book --strict; then echo "FAILED  $1: the book was written"; failures=$((failures + 1))
  elif ! grep -qE "$2" "$work/out"; then echo "FAILED  $1: refused without saying /$2/"; cat "$work/out"; failures=$((failures + 1))
  else echo "ok      refuses $1"; fi
}
contains() {
  if grep -q "$2" "build/book/$1"; then echo "ok      $1 has $2"; else echo "FAILED  $1 lacks $2"; failures=$((failures + 1)); fi
}
chapter=chapters/ch03_sample/chapter.md

project
passes 'a whole book' --strict
contains ch03.html 'id="eq_3_9"'
contains ch03.html 'id="claim_3_2_small"'
contains ch03.html '3\.2: small\|Claim 3\.2'
contains ch03.html 'all is well'
contains ch03.html '4\.5&#8239;<i>ε</i>'
contains ch03.html 'class="katex"'
contains errata.html 'erratum_thm_3_2_3'
contains ledger.html 'id="eq_6_1"'
contains implements.html 'relative_motion'
contains ch03.html 'class="skip-link" href="#doc-content"'
contains ch03.html 'rel="next" href='
contains index.html '<li class="depth-1"><a href="ch03.html"'
contains ledger.html 'data-label="verdict"'
contains ledger.html 'class="mord mathnormal">μ'

# What every page must have is looked for in the book as it stands.
lacks() {  # name, what must be said: the book is changed, and refused
  if node docs/tools/check_pages.mjs build/book >"$work/out" 2>&1; then echo "FAILED  $1: passed"; failures=$((failures + 1))
  elif ! grep -qE "$2" "$work/out"; then echo "FAILED  $1: refused without saying /$2/"; cat "$work/out"; failures=$((failures + 1))
  else echo "ok      refuses $1"; fi
}
whole() { rm -rf build/book; cp -a "$work/whole" build/book; }
cp -a build/book "$work/whole"
node -e 'const f = "build/book/navtreedata.js", fs = require("fs"); fs.writeFileSync(f, fs.readFileSync(f, "utf8").replace(/(var NAVTREEINDEX =\s*\[)/, "$1\"zz.html\","))'; lacks 'an index of the tree out of order' 'part 1 of the index begins with'
whole; sed -i '/"ch03.html":/d' build/book/navtreeindex*.js; lacks 'a page that the tree does not find' 'the tree does not find ch03.html'
whole; sed -i 's/<a class="skip-link"[^>]*>[^<]*<.a>//' build/book/errata.html; lacks 'a page without the way past the tree' 'errata.html:1: no link past the tree'
whole; sed -i 's/<li class="depth-1"><a href="ch03.html"[^<]*<.a><.li>//' build/book/index.html; lacks 'contents without a chapter' 'index.html:1: the table of contents lacks ch03.html'
whole; sed -i 's|all is well|/home/somebody/build/report/scenes/iss: all is well|' build/book/ch03.html; lacks 'a path of the machine' '/home/somebody/build/report/scenes/iss'
whole; sed -i 's|A table, with a comma|A table\\, with a comma|' build/book/ch03.html; lacks 'a backslash in a caption' 'a caption with a backslash'
whole
book --strict
grep -q 'nothing changed' "$work/out" && echo 'ok      is not written again' || { echo 'FAILED  written again with nothing changed'; failures=$((failures + 1)); }

# What the command tells of its keys is a page, and the tables of the systems point into it.
project; mkdir -p build/report/scenes
cat >build/report/scenes/keys.json <<'X'
[{"key":"system.mass","expects":"a number > 0","fallback":"needed","unit":"mass x length^2","allowed":[],"meaning":"The <mass> of_it.","example":"1","systems":["top"]},
 {"key":"run.at","expects":"a list | of numbers","fallback":"\"none_at_all\"","unit":"","allowed":["one_two"],"meaning":"The times.","example":"[0, 1]","systems":["top"]}]
X
echo "[{\"name\":\"top\",\"title\":\"Top\",\"meaning\":\"It turns.\",\"statement\":\"\",\"parameters\":$(cat build/report/scenes/keys.json),\"methods\":[],\"quantities\":[]}]" >build/report/scenes/systems.json
passes 'a book with keys of scenes' --strict
contains scene_keys.html 'id="key_system_mass"'
contains scene_keys.html 'The &lt;mass&gt; of_it\.'
contains scene_keys.html '"none_at_all"'
contains scene_keys.html 'mass = 1'
contains system_top.html 'scene_keys.html#key_run_at'
contains search_index.js 'key_system_mass'
project; rm -rf build/report; passes 'a book without reports'; contains ch03.html 'not run'
project; rm -rf build/report; refuses 'absent reports' 'statements.json:1: missing'
project; sed -i 's/\\verdict{eq_3_9}/\\verdict{eq_3_99}/' $chapter; refuses 'an unknown statement' 'chapter.md:3: unknown statement eq_3_99'
project; sed -i 's/\\figure{ch03_wheel,drift}/\\figure{ch03_wheel,speed}/' $chapter; refuses 'a figure nobody reports' 'chapter.md:3: .*no figure "speed"'
project; sed -i 's/A table, with/A table\\\\, with/' $chapter; refuses 'a backslash before a comma of a caption' 'chapter.md:21: a caption holds a backslash'
project; sed -i 's/\\program{ch03_wheel}/\\program{ch03_cart}/' $chapter; refuses 'an unknown program' 'chapter.md:17: program ch03_cart'
project; rm build/report/programs/ch03_wheel.path.svg; refuses 'a lost picture' 'chapter.md:19: picture file'
project; sed -i 's/hpp eq_3_9/hpp eq_3_8/' $chapter; refuses 'a lost snippet' 'chapter.md:8: .*no tag \[eq_3_8\]'
project; sed -i 's/\\f\[ f_{01}/\\f[ \\frac{1 f_{01}/' $chapter; refuses 'a formula that does not parse' 'ch03.html:1: formula does not parse'
project; sed -i 's/a=-b/a=\\\\nosuchmacro b/' build/report/statements.json; refuses 'a formula of the ledger that does not parse' 'errata.html:1: formula does not parse'
project; sed -i '/endstatement/d' $chapter; refuses 'a box left open' 'chapter.md:11: .statement\{thm_3_2_3\} is not closed'
project; sed -i 's/\\ref eq_3_9/\\ref eq_3_98/' $chapter; refuses 'an unknown reference' 'chapter.md:3: .*eq_3_98'
project; sed -i 's/\\cite pekarsky2000/\\cite nobody1900/' $chapter; refuses 'an unknown work' 'chapter.md:3: .*nobody1900'
project; sed -i 's|/// The motion.*||' src/actio/reduction/relative_motion.hpp; sed -i 's|/// .implements.*||' src/actio/reduction/relative_motion.hpp; refuses 'an undocumented symbol' 'relative_motion.hpp:7: .*not documented'
project; sed -i 's/implements{eq_3_9}/implements{eq_3_97}/' src/actio/reduction/relative_motion.hpp; refuses 'an unknown statement in a header' 'relative_motion.hpp:5: .*eq_3_97'
project; sed -i 's/^## Verified/## Verified \\f$\\mu\\f$/' $chapter; refuses 'a formula in a title' 'chapter.md:23: a title holds a formula'
project; echo '<a href="nowhere.html">x</a>' >>$chapter; refuses 'a dead link' 'dead link: nowhere.html'
project; echo '<img src="http://example.org/x.png" alt="x"/>' >>$chapter; refuses 'the network' 'reaches for the network'

# Programs that not every build runs: their figures may be absent, their names may not be wrong.
benchmark() {
  project
  mkdir -p benchmarks build/report/benchmarks
  printf '// Tops.\nint main() {}\n' >benchmarks/tops.cpp
  printf '# Performance {#performance}\n\nA top takes \\figure{bench_tops,time}.\n\n\\table{bench_tops,times}\n\n\\picture{bench_tops,race}\n\n\\benchmarks\n' >docs/pages/22_performance.md
}
tops() {
  printf '{"program":"bench_tops","shows":"a top","headline":{"text":"7 ns","value":7},"figures":[{"name":"time","value":7,"text":"7 ns"},{"name":"date","value":1,"text":"2026-01-01 00:00 UTC"}],"tables":[{"name":"times","header":["a"],"rows":[["1"]]}],"pictures":[{"name":"race","file":"bench_tops.race.svg","caption":"A race"}],"claims":[{"holds":false,"text":"a top is fast"}]}\n' >build/report/benchmarks/bench_tops.json
  cp build/report/programs/ch03_wheel.path.svg build/report/benchmarks/bench_tops.race.svg
}
benchmark; passes 'a book before the benchmarks have run' --strict; contains performance.html 'not measured yet'; contains performance.html 'benchmarks have not been run'
benchmark; tops; passes 'a book with a benchmark' --strict; contains performance.html '>7 ns<'; contains performance.html 'a top is fast'; contains performance.html '2026-01-01'
benchmark; sed -i 's/bench_tops,time}/bench_flops,time}/' docs/pages/22_performance.md; refuses 'a benchmark without a source' '22_performance.md:3: program bench_flops has no source'
benchmark; tops; sed -i 's/,{"name":"date".*UTC"}//' build/report/benchmarks/bench_tops.json; passes 'a benchmark that does not tell its date' --strict; contains performance.html ' UTC'
benchmark; tops; sed -i 's/bench_tops,time}/bench_tops,speed}/' docs/pages/22_performance.md; refuses 'a figure that a benchmark does not report' '22_performance.md:3: .*no figure "speed"'
benchmark; tops; sed -i 's/bench_tops,time}/bench_tops,speed}/' docs/pages/22_performance.md; touch -d '+1 minute' benchmarks/tops.cpp; passes 'a book with a figure that the next run will bring' --strict; contains performance.html 'class="unmeasured"'

((failures == 0)) && echo "the book's tools: all as they should be" || echo "the book's tools: $failures failures"
exit $((failures > 0))
