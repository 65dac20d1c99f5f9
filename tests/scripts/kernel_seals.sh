#!/usr/bin/env bash
# kernel_seals.sh SOURCE: every statement with a proof stands in the table of seals, whole or in part by
# decision, with just its theorems; and the test itself notices a row without a theorem and a theorem without
# a row.
set -euo pipefail
cd "$1"
node --input-type=module -e "
import { readSeals, sealComplaints, theorems } from './docs/tools/kernel.mjs';
import { readRegistry } from './docs/tools/lib.mjs';
const fail = text => { console.error(text); process.exit(1); };
const list = theorems('.', new Set(readRegistry('proofs_checks/registry.tsv').map(s => s.id))), seals = readSeals('.');
const found = sealComplaints(seals, list);
if (found.length) fail(found.join('\\n'));
const [id, row] = seals.entries().next().value, noticed = (table, theorems) => sealComplaints(table, theorems).length > 0;
const changed = (how, value) => new Map(seals).set(how, value), without = new Map(seals);
without.delete(id);
if (!noticed(without, list)) fail('a theorem without a row is not noticed');
if (!noticed(changed('eq_0_0', row), list)) fail('a row without a theorem is not noticed');
if (!noticed(seals, list.filter(t => t.name !== row.theorems[0]))) fail('a theorem that is gone is not noticed');
if (!noticed(changed(id, { ...row, how: 'whole', missing: 'something' }), list)) fail('a whole seal with something missing is not noticed');
const whole = [...seals.values()].filter(r => r.how === 'whole').length;
console.log(seals.size + ' seals, ' + whole + ' of them whole');
"
