// node table.mjs BUILD [WIDTH]: the table of the chapter programs and the counts of the ledger, from the
// reports in BUILD/report.
import fs from 'node:fs';
import path from 'node:path';

const [build, columns = '120'] = process.argv.slice(2);
const read = file => JSON.parse(fs.readFileSync(file, 'utf8'));

const folder = path.join(build, 'report/programs');
const reports = (fs.existsSync(folder) ? fs.readdirSync(folder) : []).filter(f => /^ch\d+_.*\.json$/.test(f)).sort().map(f => read(path.join(folder, f)));

/// Cuts a text at the last word that fits.
const fit = (text, width) => text.length <= width ? text : text.slice(0, width).replace(/\s+\S*$/, '') + '…';

if (reports.length) {
  const rows = reports.map(r => [r.chapter.replace(/^ch0?/, ''), r.program, r.shows, r.headline?.text ?? '']);
  const longest = i => Math.max(...rows.map(r => r[i].length));
  const [name, figure] = [Math.max(longest(1), 7), Math.min(Math.max(longest(3), 8), 48)];
  const shows = Math.max(20, Number(columns) - name - figure - 13);
  const line = (a, b, c, d) => `  ${a.padEnd(4)}${b.padEnd(name + 2)}${fit(c, shows).padEnd(shows + 3)}${d}`;
  console.log(line('ch.', 'program', 'what it shows', 'measured'));
  for (const r of rows) console.log(line(...r));
} else {
  console.log('  no chapter program has reported');
}

const ledger = path.join(build, 'report/statements.json');
if (fs.existsSync(ledger)) {
  const json = read(ledger);
  const statements = Array.isArray(json) ? json : json.statements;
  const counts = {};
  for (const s of statements) counts[s.verdict] = (counts[s.verdict] ?? 0) + 1;
  const scalars = new Set(statements.flatMap(s => (s.evidence ?? []).map(e => e.scalar)));
  const owed = statements.length - (counts.pending ?? 0);
  const verdicts = ['holds', 'convention', 'corrected', 'scope', 'pending'].filter(v => counts[v]).map(v => `${counts[v]} ${v}`);
  console.log(`\n  Ledger: ${statements.length} statements, ${owed} adjudicated: ${verdicts.join(', ')}.`);
  console.log(`  Columns with figures: ${['prime', 'rational', 'double', 'dec50', 'dec100', 'ball'].filter(s => scalars.has(s)).join(', ') || 'none'}.`);
} else {
  console.log('\n  Ledger: the checks have not been run.');
}
