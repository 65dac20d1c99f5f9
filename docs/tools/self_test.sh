#!/usr/bin/env bash
# The book on trial: a small project is written, its book must come out whole; then one thing at a time is
# broken, and the book must refuse it with the place and the reason.
set -uo pipefail
docs=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

project() {
  rm -rf "$work/p"
  mkdir -p "$work"/p/{src/actio/reduction,src/program,src/book,chapters/ch03_sample,proofs_checks,data,build/report/programs}
  cp -r "$docs" "$work/p/docs"
  cd "$work/p" || exit 1
  # Pages that speak of the real library are not under test.
  rm -rf docs/pages/0[15-7]_*.md docs/pages/1[1-3]_*.md docs/pages/22_*.md docs/pages/35_*.md docs/pages/40_*.md docs/release docs/modules/* docs/examples/*
  sed -i '/architecture\|own_systems\|scenes\|conventions\|notation\|bibliography\|performance\|gallery\|claim_10\|res_modified\|^.picture\|^.sceneviewer\|^.python\|.figure/d' docs/pages/00_mainpage.md
  printf '/** @namespace actio\n The library. */\n' >docs/namespaces.dox
  : >docs/rooms.dox
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

\proof{thm_3_2_3}
By \ref def_turn "the turn".
\endproof

\definition{def_turn,Turn}
A *turn* is \f$f\f$.
\enddefinition

\result{res_own,Lemma,Ours}
It turns, \ref def_turn.
\endresult

\proof
So it is.
\endproof

\printed{eq_3_9}
\f[ f = g_1 \f]
\endprinted

\exercise{code}
Turn it.
\hint
By hand.
\solution
Done.
\endexercise

\tryit{ch03,turn}

\step{ch03_wheel,2}

\prints{ch03_wheel,all is}

\claims{ch03_wheel}

\idea{ch03_turn,A turn, drawn}

\animation{flip,ch03_wheel,It turns}
X
  printf '// A wheel.\n#include "spokes.hpp"\n\n// 1. One.\nint one;\n\n// 2. Two.\nint two;\n\nint main() {}\n' >chapters/ch03_sample/wheel.cpp
  printf '// Spokes.\nint spokes;\n' >chapters/ch03_sample/spokes.hpp
  printf '// Try.\n#include "book/try_it.hpp"\nTRY_IT(turn) {\n  print("turned", 1);\n}\n' >chapters/ch03_sample/try_it.cpp
  printf '{"chapter":"ch03","program":"ch03_try_it","shows":"lines","headline":{"text":"1","value":1},"snippets":[{"name":"turn","said":"turned: 1\\n"}]}' >build/report/programs/ch03_try_it.json
  echo 'turned: 1' >build/report/programs/ch03_try_it.txt
  mkdir -p docs/drawings
  echo '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 60 40"><path class="arrow c1" d="M0 0L9 9"/><text class="m" x="1" y="9">g_{k+1}</text></svg>' >docs/drawings/ch03_turn.svg
  cat >build/report/programs/ch03_wheel.json <<'X'
{"chapter":"ch03","program":"ch03_wheel","shows":"a wheel","headline":{"text":"drift 1e-15","value":1e-15},"figures":[{"name":"drift","value":1e-15,"text":"1e-15"}],
 "tables":[{"name":"orders","header":["scheme","order"],"rows":[["DEP","2.0"]]}],"pictures":[{"name":"path","file":"ch03_wheel.path.svg","caption":"A path"}],
 "claims":[{"holds":true,"text":"it rolls","measured":"1e-15 < 2e-12"}],"motions":[{"name":"flip","header":["t","x"],"rows":[[0,1],[1,2]]}],"seconds":0.1}
X
  echo 'all is well' >build/report/programs/ch03_wheel.txt
  echo '<svg xmlns="http://www.w3.org/2000/svg" width="10" height="10"><path id="a" d="M0 0L9 9"/></svg>' >build/report/programs/ch03_wheel.path.svg
  cat >build/report/statements.json <<'X'
[{"id":"eq_3_9","title":"q","verdict":"holds","evidence":[{"what":"both sides","kind":"exact","scalar":"rational","model":"SE(3)","measured":0,"bound":0,"points":20,"degree":4,"probability":1e-40}],"control":[{"what":"other side","measured":0.5,"floor":0.001}]},
 {"id":"thm_3_2_3","title":"t","verdict":"corrected","printed":"a=b","corrected":"a=-b","note":"a sign, $\\mu$, and mu -> Ad*_{f(mu)} mu as in eq_3_9","scan":true,"evidence":[{"what":"residual","kind":"precision","scalar":"double","model":"SE(3)","measured":1e-15,"bound":1e-13,"epsilon":2.2e-16}],"control":[{"what":"as printed","measured":0.5,"floor":0.001}]},
 {"id":"claim_3_2_small","title":"s","verdict":"scope","note":"nothing to compute","evidence":[],"control":[]},
 {"id":"eq_6_1","title":"l","verdict":"pending","evidence":[],"control":[]}]
X
  # Proofs, and the list of what a kernel has checked of them.
  mkdir -p proofs_checks/kernel
  printf -- '-Q . actio\ncomputed.v\n' >proofs_checks/kernel/_CoqProject
  printf 'id\tseal\ttheorems\tmissing\neq_3_9\twhole\teq_3_9\t-\n' >proofs_checks/kernel/seals.tsv
  cat >proofs_checks/kernel/computed.v <<'X'
(** * Tables

Words on \f$a = b\f$. *)

From actio Require Import matrices.

(** ** The quotient

It is what it is. *)
Theorem eq_3_9 (a : nat) : a = a.
Proof.
by [].
Qed.

Theorem thm_3_2_3_printed_fails : ~ (forall a b : nat, a = b).
Proof. by move=> /(_ 0 1). Qed.
X
  cat >list.mjs <<'X'
import { digest, theorems, writeList } from './docs/tools/kernel.mjs';
const list = theorems('.', new Set(['eq_3_9', 'thm_3_2_3'])).map(t => ({ ...t, assumptions: 'none' }));
writeList('build/report/kernel.tsv', list, { sources: digest('.'), checked: 'a kernel', axioms: 'none' });
X
  node list.mjs
  # What the release recorded of the columns that this build has not run.
  mkdir -p docs/release
  cat >record.mjs <<'X'
import fs from 'node:fs';
import { packChecks } from './docs/tools/release.mjs';
const entry = (scalar, measured) => ({ what: 'residual', kind: 'precision', scalar, model: 'SE(3)', measured, bound: measured * 100, epsilon: measured / 3.14, steps: [] });
const evidence = [entry('dec50', 3.14159e-50), entry('dec100', 3.14159e-100)];
const control = [{ what: 'as printed', scalar: 'dec50', measured: 0.25, floor: 0.001 }];
const release = { date: '2026-01-01 00:00 UTC', processor: 'a fast processor', compiler: 'GCC 12', commit: 'abc1234567' };
const columns = ['dec100', 'dec50'];
fs.writeFileSync('docs/release/checks.json', JSON.stringify({ release, columns, ...packChecks([{ id: 'thm_3_2_3', evidence, control }, { id: 'eq_6_1', evidence, control }], columns) }));
X
  node record.mjs
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
contains ledger.html 'role="img" aria-label="[^"]*\\mu[^"]*"><span class="base"[^>]*><i>μ'
# What unfolds is in a script beside the page.
contains more_ch03.js 'class=\\"num from-release\\"><span title=\\"3.14e-50, allowed 3.1e-48\\">3\.1&#8239;<i>ε'
contains more_ch03.js '50 digits and 100 digits: .*measured 2026-01-01 00:00 UTC on a fast processor with GCC 12, commit abc1234567.*of the release'
contains more_ch03.js 'class=\\"num from-release\\">0\.25'
contains ch03.html '<details class="evidence"[^>]* data-more="thm_3_2_3">.*<a href="ledger.html#ledger_3">the ledger</a>'
grep -q 'evidence-table' build/book/ch03.html && { echo 'FAILED  a table of evidence stands in the page'; failures=$((failures + 1)); }
# The page of a namespace is an index of headers, and a header documents its functions.
contains namespaceactio.html '<ul class="headers"><li><a class="el" href="relative__motion_8hpp.html">relative_motion.hpp</a>'
contains group__module__reduction.html '<h2 class="groupheader">Function Documentation</h2>'
contains implements.html 'href="group__module__reduction.html#ga[0-9a-f]*">relative_motion<'
grep -q 'class="memtitle"' build/book/namespaceactio.html && { echo 'FAILED  a function documented on the page of the namespace'; failures=$((failures + 1)); }
contains ch03.html '<h1 class="title">[^<]*Sample'
contains ch03.html '<h2><a class="anchor" id="autotoc_md[0-9]*"></a>'

contains ch03.html 'id="def_turn"'
contains ch03.html 'href="ch03.html#def_turn">turn</a>'
contains ch03.html '>Proof of Theorem 3.2.3<'
contains ch03.html 'as printed, <a href="#eq_3_9">'
contains ch03.html '>Exercise 3.1<'
contains ch03.html '<summary>Solution</summary>'
contains ch03.html 'print.*turned'
contains ch03.html '<pre class="output">turned: 1</pre>'
contains ch03.html 'spokes.hpp, 2 lines'
contains ch03.html '>it rolls <span class="claimed">10<sup>−15</sup>\|it rolls <span class="claimed">1·10'
contains ch03.html 'marker-end="url(#idea[0-9]*-head-c1)"'
contains ch03.html 'data-animation="flip"'
contains ch03.html '<a class="seal" href="kernel_computed.html#proof_eq_3_9"[^>]*>proved</a>'
contains ch03.html '<a class="seal seal-refuted" href="kernel_computed.html#proof_thm_3_2_3_printed_fails"[^>]*>print refuted</a>'
contains kernel_computed.html '<a class="target" id="proof_eq_3_9"></a><b><a href="ch03.html#eq_3_9">eq_3_9</a></b>'
contains errata.html 'hold <b>1</b> distinct slips: in 0 of them .* Of the distinct slips <b>1</b> may be the scan'
contains index.html 'hold <b>1</b> distinct slips'
contains kernel.html '<b>1</b> statements of the thesis are proved, 1 of them as a whole.*of <b>1</b> statements the printed form is refuted'

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
whole; node -e 'require("fs").appendFileSync("build/book/errata.html", " ".repeat(1500001))'; lacks 'a page of too many bytes' 'errata.html:1: 15[0-9]* bytes, where a page has 1500000 at most'
whole; node -e 'require("fs").appendFileSync("build/book/errata.html", "<i></i>".repeat(25001))'; lacks 'a page of too many elements' 'errata.html:1: [0-9]* elements, where a page has 25000 at most'
whole; sed -i 's|<h2><a class="anchor"|<h1><a class="anchor"|' build/book/ch03.html; lacks 'a second title' 'ch03.html:1: . headings of the first rank'
whole; sed -i 's|role="img" aria-label="A path"|role="img"|' build/book/ch03.html; lacks 'a picture without a name' 'ch03.html:1: a picture without a name'
whole; sed -i 's|A table, with a comma|A table\\, with a comma|' build/book/ch03.html; lacks 'a backslash in a caption' 'a caption with a backslash'
whole
# The search brings what is asked for first, or says what it brings.
printf '(3.9)\t^ch03.html#eq_3_9$\tch03.html\nturn\t^ch03.html#def_turn$\tch03.html\nrelative_motion()\t^group__module__reduction.html#ga\nnowhere\t^x\tno_such_page.html\n' >"$work/questions.tsv"
asks() { node docs/tools/search_index.mjs --html build/book --questions "$work/questions.tsv" >"$work/out" 2>&1; }
asks && grep -q '3 of 4 questions asked' "$work/out" && echo 'ok      finds what is asked for' || { echo 'FAILED  questions'; cat "$work/out"; failures=$((failures + 1)); }
printf '(3.9)\t^errata\n' >"$work/questions.tsv"
asks || grep -q '"(3.9)" brings ch03.html#eq_3_9 first' "$work/out" && echo 'ok      says what comes first' || { echo 'FAILED  a wrong answer'; cat "$work/out"; failures=$((failures + 1)); }
# A column that neither this build nor the release has is an empty place; one that this build has is its own.
project; rm docs/release/checks.json; refuses 'a column that nobody has run' 'ch03.html:1: . empty places, the first: not run; .*/run record'
project; sed -i 's/\("scalar":"double","model":"SE(3)","measured":1e-15.*\)}\],"control"/\1},{"what":"residual","kind":"precision","scalar":"dec50","model":"SE(3)","measured":2e-50,"bound":1e-48,"epsilon":1e-50}],"control"/' build/report/statements.json
passes 'a book with a column of its own' --strict; contains more_ch03.js 'class=\\"num\\"><span title=\\"2.00e-50'; contains more_ch03.js '<span>100 digits: .*of the release'
project; passes 'a whole book again' --strict
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
contains scene_keys.html '&quot;none_at_all&quot;'
contains scene_keys.html 'mass = 1'
contains system_top.html 'scene_keys.html#key_run_at'
contains search_index.js 'key_system_mass'
# A seal is that of the sources as they are.
project; sed -i 's/: a = a\./: a + 0 = a./' proofs_checks/kernel/computed.v; refuses 'proofs that changed' 'kernel.html:1: 1 empty place.*have not been checked as they stand'; passes 'a draft with proofs that changed'
contains kernel.html 'have not been checked as they stand'
grep -q 'class="seal' build/book/ch03.html && { echo 'FAILED  a seal on a proof that changed'; failures=$((failures + 1)); }
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
project; sed -i '/^.proof{thm/,/^.endproof/d' $chapter; refuses 'a theorem without a proof' 'chapter.md:11: Theorem 3.2.3 has no .proof'
project; sed -i '0,/^.proof$/{/^.proof$/,/^.endproof/d}' $chapter; refuses 'a result of our own without a proof' 'chapter.md:[0-9]*: res_own has no .proof'
project; sed -i '/^.beside/,/^.endbeside/d; /^.printed/,/^.endprinted/d; s/.ref eq_3_9/it/' $chapter; refuses 'an equation that is not displayed' '.3.9. is not displayed'
project; sed -i 's/result{res_own/result{def_turn/' $chapter; refuses 'an id of another kind' '"def_turn": an id of this kind is res_'
project; sed -i 's/ch03,turn}/ch03,twist}/' $chapter; refuses 'a snippet that is not there' 'try_it.cpp has no TRY_IT.twist'
project; sed -i 's/ch03_wheel,2}/ch03_wheel,3}/' $chapter; refuses 'a step that is not there' 'has no comment "// 3. ..."'
project; sed -i 's/ch03_wheel,all is}/ch03_wheel,none is}/' $chapter; refuses 'words that are not printed' 'prints no line that starts with "none is"'
project; sed -i 's/{flip,/{flop,/' $chapter; refuses 'a motion that nobody reports' 'reports no motion "flop"'
project; sed -i 's/class="arrow c1"/stroke="red"/' docs/drawings/ch03_turn.svg; refuses 'a drawing in a colour of its own' 'a colour is named'
project; echo '<a href="nowhere.html">x</a>' >>$chapter; refuses 'a dead link' 'dead link: nowhere.html'
project; echo '<img src="http://example.org/x.png" alt="x"/>' >>$chapter; refuses 'the network' 'reaches for the network'

# A sentence on all cases names what it rests on, stands in a box or introduces a display; else it is on the list.
claims() { project; sed -i "s/^## Verified/$1\n\n&/" $chapter; }
claims 'It never slips.'; refuses 'a sentence on all cases that rests on nothing' 'chapter.md:23: It never slips\.'; passes 'a draft with such a sentence'
claims 'It never slips, by \\ref res_own.'; passes 'a sentence that names its theorem' --strict
claims 'It cannot slip by more than \\figure{ch03_wheel,drift}.'; passes 'a sentence that names its figure' --strict
claims 'It is read-only. `never` is a word, and all the same it turns.'; passes 'words that claim nothing' --strict
claims 'Of all wheels, its energy is'; sed -i 's/^Of all wheels.*/&\n\\f[ E \\f]/' $chapter; passes 'a sentence that introduces a display' --strict
claims 'It rolls. Every wheel does. It has a hub.'; refuses 'one sentence of a paragraph' 'chapter.md:23: Every wheel does\.$'
node docs/tools/claims.mjs --propose | sed 's/$/wheels roll/' >>docs/claims.tsv; passes 'a sentence that was read' --strict
sed -i 's/Every wheel does/Every wheel rolls/' $chapter; refuses 'a sentence that changed after it was read' 'Every wheel rolls\.$'
project; sed -i 's/^So it is\./Every turn is./' $chapter; passes 'a sentence of a proof' --strict

# A letter keeps its kind on a page, and stands once in a table.
claims 'Take the arrow \\f$a\\f$ and the step \\f$a_1\\f$.'; refuses 'a letter with two meanings' 'chapter.md:23: "step a_1" .time.; in line 23 "arrow a" .arrow.'
claims 'The metric \\f$a\\f$ of space-time \\f$b\\f$ has the density \\f$b\\f$ and the node \\f$a\\f$.'; refuses 'a letter of fields with two meanings' 'chapter.md:23: "node a" .node.; in line 23 "metric a" .metric.'
claims 'Take the arrow \\f$a\\f$ and the arrow \\f$a_1\\f$, the relative motion \\f$a_2\\f$.'; passes 'a letter with one meaning' --strict
project; printf '# Notation {#notation}\n\n## Chapter 3 {#notation_ch03}\n\n| symbol | what it is |\n|---|---|\n| \\f$a\\f$ | an arrow |\n| \\f$b, a\\f$ | two steps |\n' >docs/pages/12_notation.md
refuses 'a symbol that stands twice in a table' '12_notation.md:8: a stands twice in the table of ch03'
claims 'For a point \\f$a\\f$.'; printf '# Notation {#notation}\n\n## Chapter 3 {#notation_ch03}\n\n| symbol | what it is |\n|---|---|\n| \\f$a\\f$ | an arrow |\n' >docs/pages/12_notation.md
refuses 'a letter that is another thing in its table' '"point a" .point.; line 7 of docs/pages/12_notation.md says "an arrow"'

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
short() { sed -i 's/"claims"/"short":true,"claims"/' build/report/benchmarks/bench_tops.json; }
release() { # as ./run record leaves it
  mkdir -p docs/release/benchmarks
  sed 's/^{/{"release":{"date":"2026-01-02 00:00 UTC","processor":"a fast processor","compiler":"GCC 12","commit":"abc1234567"},/' build/report/benchmarks/bench_tops.json >docs/release/benchmarks/bench_tops.json
  mv build/report/benchmarks/bench_tops.race.svg docs/release/benchmarks
  rm build/report/benchmarks/*
}
benchmark; refuses 'a benchmark that nobody has run' 'performance.html:1: 4 empty places, the first: waits for a run of bench_tops; .*/run record'
benchmark; passes 'a draft before the benchmarks have run'; contains performance.html 'class="unmeasured"'
benchmark; tops; release; passes 'a book with the figures of the release' --strict; contains performance.html 'class="figure from-release" title="bench_tops: time = 7; figure of the release, measured 2026-01-02'
contains performance.html 'class="report-table from-release"'; contains performance.html 'class="picture from-release"'; contains performance.html 'those of the release, measured 2026-01-02 on a fast processor with GCC 12, commit abc1234567; <code>./run bench</code> replaces them'
benchmark; tops; short; passes 'a book with a short benchmark' --strict; contains performance.html 'class="figure from-short"'; contains performance.html 'Of a short run\.'; contains performance.html '2026-01-01 00:00 UTC, short'; contains performance.html '>missed<'
benchmark; tops; release; tops; passes 'a benchmark of this build before that of the release' --strict; contains performance.html '<span class="figure" title="bench_tops: time = 7">'
benchmark; tops; release; tops; short; sed -i 's/"name":"time"/"name":"speed"/' build/report/benchmarks/bench_tops.json; passes 'a figure that a short run leaves out' --strict; contains performance.html 'class="figure from-release"'; contains performance.html 'class="report-table from-short"'
benchmark; tops; passes 'a book with a benchmark' --strict; contains performance.html '>7 ns<'; contains performance.html 'a top is fast'; contains performance.html '2026-01-01'
# Whether a target is reached is decided by the tool, from the report whose figure stands beside it.
target() { benchmark; printf '\n| what | target | measured | |\n|---|---|---|---|\n| a top, ns | \\target{bench_tops,time,%s} |\n' "$1" >>docs/pages/22_performance.md; }
target 'at most,8'; tops; passes 'a target that is reached' --strict; contains performance.html '>reached<'
target 'at most,6'; tops; passes 'a target that is missed' --strict; contains performance.html '>missed<'; contains performance.html '1 target of the table below missed'
target 'at least,8'; tops; passes 'a lower target that is missed' --strict; contains performance.html '>missed<'
target 'at about,8'; tops; refuses 'a target without a side' '22_performance.md:13: .target.program,figure,at most,0.6'
benchmark; sed -i 's/bench_tops,time}/bench_flops,time}/' docs/pages/22_performance.md; refuses 'a benchmark without a source' '22_performance.md:3: program bench_flops has no source'
benchmark; tops; sed -i 's/,{"name":"date".*UTC"}//' build/report/benchmarks/bench_tops.json; passes 'a benchmark that does not tell its date' --strict; contains performance.html ' UTC'
benchmark; tops; sed -i 's/bench_tops,time}/bench_tops,speed}/' docs/pages/22_performance.md; refuses 'a figure that a benchmark does not report' '22_performance.md:3: .*no figure "speed"'
benchmark; tops; sed -i 's/bench_tops,time}/bench_tops,speed}/' docs/pages/22_performance.md; touch -d '+1 minute' benchmarks/tops.cpp; passes 'a book with a figure that the next run will bring'; contains performance.html 'class="unmeasured"'

# What is recorded was measured in full with the executable as it is.
recording() {
  benchmark
  mkdir -p cmake build/bin docs/release/benchmarks
  cp -r "$docs/../cmake/tools" cmake
  cat >build/bin/bench_tops <<'X'
#!/usr/bin/env bash
[[ $1 == --short ]] && short=true && shift || short=false
echo "{\"program\":\"bench_tops\",\"shows\":\"a top\",\"short\":$short,\"headline\":{\"text\":\"7 ns\"},\"figures\":[{\"name\":\"time\",\"value\":7,\"text\":\"7 ns\"}],\"tables\":[{\"name\":\"times\",\"header\":[\"a\"],\"rows\":[[\"1\"]]}],\"pictures\":[{\"name\":\"race\",\"file\":\"bench_tops.race.svg\",\"caption\":\"A race\"}]}" >"$2/bench_tops.json"
cp build/report/programs/ch03_wheel.path.svg "$2/bench_tops.race.svg"
X
  chmod +x build/bin/bench_tops
  touch data/bodies.toml
}
measure() { ACTIO_ONCE=1 bash cmake/tools/measure.sh build bench_tops "$@" >"$work/out" 2>&1; }
record() { node docs/tools/record.mjs --build build --commit abc1234567 --what "${1:-bench}" >"$work/out" 2>&1; }
says() { if grep -q "$2" "$work/out"; then echo "ok      $1"; else echo "FAILED  $1: not said: $2"; cat "$work/out"; failures=$((failures + 1)); fi; }
recording; record && failures=$((failures + 1)); says 'a record of nothing' 'bench_tops: never recorded, .*type ./run bench'
measure --short; record && failures=$((failures + 1)); says 'a record of a short run' 'bench_tops: never recorded'
measure; record || failures=$((failures + 1)); says 'a record of a full run' 'bench_tops: recorded'
measure --short; says 'a short run leaves a full one that is current' 'current: a full run'
rm -rf build/report/benchmarks; passes 'a book from what was recorded' --strict; contains performance.html 'commit abc1234567'; contains performance.html 'class="picture from-release"'
measure; echo '# changed' >>build/bin/bench_tops; record || failures=$((failures + 1)); says 'an executable that changed' 'no full run of the executable as it is; the record stays that of .*commit abc1234567'
measure --short; grep -q '"short":true' build/report/benchmarks/bench_tops.json || { echo 'FAILED  a short run does not replace a full one of another executable'; failures=$((failures + 1)); }
record checks || failures=$((failures + 1)); says 'checks of fewer columns than are recorded' 'checks: this build has run fewer columns than are recorded'
rm docs/release/checks.json; record checks && failures=$((failures + 1)); says 'checks of no column beyond the quick ones' 'checks: never recorded, .*type ./run test --all'
sed -i 's/"scalar":"double"/"scalar":"dec50"/' build/report/statements.json; record checks || failures=$((failures + 1)); says 'a record of the checks' 'checks: recorded in dec50'

((failures == 0)) && echo "the book's tools: all as they should be" || echo "the book's tools: $failures failures"
exit $((failures > 0))
