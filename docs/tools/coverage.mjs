// What each chapter gives its reader, counted: named results with a proof on the page, numbered equations
// displayed, definitions, words, drawings, exercises. The counts go to report/book_coverage.tsv; a named
// result without a proof and a numbered equation that no page displays are errors of the strict book.
import fs from 'node:fs';
import path from 'node:path';
import { label } from './lib.mjs';

const named = ['theorem', 'proposition', 'lemma', 'corollary'];

/// Ids of the equations that a page displays: in a command of their own, or in the box of the statement.
export function displayed(lines) {
  const ids = new Set();
  let box = null;
  for (const line of lines) {
    const m = /^\s*\\(statement|endstatement|beside|equation|printed)(?:\{\s*([A-Za-z0-9_]+))?/.exec(line);
    if (m?.[1] === 'statement') box = m[2];
    else if (m?.[1] === 'endstatement') box = null;
    else if (m) ids.add(m[2]);
    if (box && line.includes('\\f[')) ids.add(box);
  }
  return ids;
}

/// Words of prose: no commands, no code; a formula in a line counts as one.
export function words(lines) {
  let code = false, display = false, count = 0;
  for (const line of lines) {
    if (/^\s*(```|~~~)/.test(line)) { code = !code; continue; }
    if (code || /^\s*\\(snippet|evidence|picture|table|step|prints|program|tryit|idea)\b/.test(line)) continue;
    let text = line;
    if (text.includes('\\f[')) { display = true; text = text.slice(0, text.indexOf('\\f[')); }
    if (display) { const end = line.indexOf('\\f]'); text = (text === line ? '' : text) + (end < 0 ? '' : line.slice(end + 3)); if (end >= 0) display = false; }
    text = text.replace(/\\f\$.*?\\f\$/g, ' x ').replace(/\\(ref|cite|figure|verdict)\b(\{[^}]*\}|\s+\w+)/g, ' x ');
    count += (text.match(/[\p{L}\d]+(?:['’.-][\p{L}\d]+)*/gu) ?? []).length;
  }
  return count;
}

const header = ['page', 'named results', 'with proof', 'numbered equations', 'displayed', 'definitions', 'own results', 'proofs', 'drawings', 'exercises', 'hints', 'solutions', 'changing code', 'to try', 'words'];

/// Counts, writes the table, and in the strict book holds the pages to it.
/// @param homes  where each statement lives
export function coverage(book, pages, homes, errors, strict) {
  const rows = [], proved = book.proved ?? new Set();
  for (const p of pages.filter(q => q.chapter !== null)) {
    const thesis = /^\d+$/.test(p.number), of = kinds => book.registry.filter(s => thesis && Number(s.chapter) === p.chapter && kinds.includes(s.kind));
    const results = of(named), equations = of(['equation']), c = p.counts ?? {};
    const shown = new Set(pages.filter(q => q.chapter === p.chapter).flatMap(q => [...displayed(q.lines)]));
    const place = id => homes.get(id) ?? { file: p.file, line: 1 };
    if (strict) {
      for (const s of results) if (!proved.has(s.id)) errors.add(place(s.id).file, place(s.id).line, `${label(s.id)} has no \\proof on its page`);
      for (const s of equations) if (!shown.has(s.id)) errors.add(place(s.id).file, place(s.id).line, `${label(s.id)} is not displayed on its page`);
      for (const own of p.toProve ?? []) if (!proved.has(own.id)) errors.add(p.file, own.line, `${own.id} has no \\proof`);
    }
    rows.push([p.number, results.length, results.filter(s => proved.has(s.id)).length, equations.length, equations.filter(s => shown.has(s.id)).length, c.definitions ?? 0, c.results ?? 0,
      c.proofs ?? 0, c.ideas ?? 0, c.exercises ?? 0, c.hints ?? 0, c.solutions ?? 0, c.code ?? 0, c.tries ?? 0, words(p.lines)]);
  }
  const file = path.join(book.build, 'report/book_coverage.tsv');
  fs.mkdirSync(path.dirname(file), { recursive: true });
  fs.writeFileSync(file, [header, ...rows].map(r => r.join('\t')).join('\n') + '\n');
}
