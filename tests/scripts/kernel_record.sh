#!/usr/bin/env bash
# kernel_record.sh SOURCE: the list of proofs that the release carries is that of the proofs as they are, each
# with no assumption. `./run proofs` makes it, `./run record proofs` keeps it.
set -euo pipefail
cd "$1"
node --input-type=module -e "
import { digest, readList, theorems } from './docs/tools/kernel.mjs';
import { readRegistry } from './docs/tools/lib.mjs';
const list = readList('docs/release/kernel.tsv');
const fail = text => { console.error(text); process.exit(1); };
if (list?.facts.sources !== digest('.')) fail('the proofs have changed since they were checked; type ./run proofs and ./run record proofs');
const all = theorems('.', new Set(readRegistry('proofs_checks/registry.tsv').map(s => s.id)));
for (const t of all) {
  const r = list.rows.find(r => r.name === t.name);
  if (!r || r.statement !== t.statement || r.what !== t.what) fail('the record does not hold ' + t.name + ' as it stands');
  if (r.assumptions !== 'none') fail(t.name + ' assumes ' + r.assumptions);
}
if (list.rows.length !== all.length || all.length === 0) fail('the record holds ' + list.rows.length + ' theorems of ' + all.length);
console.log(all.length + ' theorems, as they were checked');
"
