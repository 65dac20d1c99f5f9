// One letter, one meaning: on a page, and in a table of the notation page.
//
//   node docs/tools/notation.mjs [--root DIR] [--list PAGE]
//
// 1. A table of docs/pages/12_notation.md has each symbol of its first column once. A table is in force on the
//    pages of its chapter, that of a single page on this page alone; so a page finds one meaning.
// 2. A letter that a page introduces by the noun before it, "the arrow a", "a step h", keeps that kind of noun on
//    the page. The nouns are sorted into kinds that exclude each other, below; indices, primes and accents do not
//    make another letter of it, except a tilde, a hat or a bar. Other ways to introduce a letter are not seen.
// 3. Where the table in force has the letter, the kind on the page is among the nouns of its row.
//
// What differs is listed with file and line, and the exit status is 1. --list prints the letters of a page. The
// chapters and the pages beside them are read.
import fs from 'node:fs';
import path from 'node:path';
import { options, walk } from './lib.mjs';

// Words that name the form of a thing and not what it is, matrix, element, map, curve, number, are not among them.
const kinds = {
  configuration: 'configuration configurations attitude attitudes rotation rotations relative-motion relative-motions',
  arrow: 'arrow arrows',
  point: 'point points',
  time: 'step time',
  momentum: 'momentum momenta covector covectors',
  velocity: 'velocity velocities',
  function: 'function functions lagrangian hamiltonian',
  'vector field': 'vector-field vector-fields',
  angle: 'angle angles azimuth',
  degree: 'degree',
  section: 'section sections',
  jet: 'jet jets',
  metric: 'metric metrics',
  density: 'density densities',
  pressure: 'pressure pressures',
  energy: 'energy energies enthalpy',
  stress: 'stress stresses',
  mass: 'mass masses',
  vorticity: 'vorticity',
  multiplier: 'multiplier multipliers',
  current: 'current currents',
  node: 'node nodes',
  cell: 'cell cells',
  set: 'manifold group algebra groupoid bundle',
};
/// What one thing can be at once: a configuration is a point of the group, or a section, a relative motion an arrow of
/// it; a vector field is a section; a density, a pressure and an energy are functions, and a mass has a density.
const both = [['configuration', 'point'], ['configuration', 'arrow'], ['configuration', 'section'], ['vector field', 'section'],
  ...['density', 'pressure', 'energy', 'vorticity', 'multiplier'].map(kind => [kind, 'function']), ['mass', 'density'], ['energy', 'density']];
const agree = (a, b) => a === b || both.some(pair => pair.includes(a) && pair.includes(b));
const kindOf = new Map(Object.entries(kinds).flatMap(([kind, words]) => words.split(' ').map(w => [w.replace(/-(?=[mf])/, ' '), kind])));
const noun = new RegExp(`(?<!-|unit )\\b(${[...kindOf.keys()].join('|')})\\s+\\\\f\\$(.*?)\\\\f\\$`, 'gi');

/// The letter that a formula is about: `a` of `a_1,\dots,a_N`, of `a\in G` and of `a = b`; '' for an expression.
export function letterOf(formula) {
  const m = /^\s*((?:\\(?:tilde|widetilde|hat|widehat|bar|mathcal|mathfrak|mathbf|mathbb|mathsf|mathrm)\s*)*(?:\\[A-Za-z]+|\{[^{}]*\}|[A-Za-z]))((?:[_^](?:\{[^{}]*\}|\\[A-Za-z]+|.)|')*)\s*(.*)$/s.exec(formula);
  if (!m || /^\\(frac|tfrac|partial|sum|int|log|exp|det|Tr|Ad|ad|pair|poisson|langle|bigl|begin|mathrm)/.test(m[1]) || /\^(?!\*)/.test(m[2])) return '';
  return /^($|[=,:]|\\(in|colon|ne|neq|subset|to|ge|le)(?![A-Za-z]))/.test(m[3]) ? m[1].replace(/\s/g, '') : '';
}

/// Where a page says what a letter is: line, letter, kind, the words.
export function introduced(source) {
  const out = [];
  let fence = false;
  source.split('\n').forEach((line, i) => {
    if (/^(```|~~~)/.test(line)) fence = !fence;
    if (fence || /^\\(snippet|step|prints)/.test(line)) return;
    for (const m of line.matchAll(noun)) {
      const letter = letterOf(m[2]);
      if (letter) out.push({ line: i + 1, letter, kind: kindOf.get(m[1].toLowerCase()), words: m[0].replace(/\\f\$/g, '').replace(/\s+/g, ' ') });
    }
  });
  return out;
}

/// The tables of the notation page: the pages on which each is in force, and its rows.
export function tables(source) {
  const out = [];
  let scope = '', head = '', rows = null;
  source.split('\n').forEach((line, i) => {
    const heading = /^## .*\{#notation_(\w+)\}/.exec(line);
    if (heading) scope = heading[1];
    if (!line.startsWith('|')) { rows = null; return; }
    // A bar in a formula is no border of a cell.
    const cells = line.replace(/\\f\$.*?\\f\$/g, f => f.replaceAll('|', '\u0001')).split('|').slice(1, -1).map(c => c.replaceAll('\u0001', '|').trim());
    if (!rows) { head = cells[0]; rows = []; out.push({ scope: /^chapter \d+[A-Z]$/.test(head) ? `ch${head.slice(8).toLowerCase().padStart(3, '0')}` : scope, rows }); return; }
    if (/^[-: ]+$/.test(cells[0])) return;
    const symbols = [...cells[0].matchAll(/\\f\$(.*?)\\f\$/g)].flatMap(m => split(m[1]));
    rows.push({ line: i + 1, symbols, text: cells[1] ?? '' });
  });
  return out;
}

/// `g, h, f` is three symbols; `(x, y)` is one.
function split(formula) {
  const parts = [''];
  let depth = 0;
  for (const c of formula.replaceAll('\\,', ' ')) {
    if ('([{'.includes(c)) ++depth;
    if (')]}'.includes(c)) --depth;
    if ((c === ',' || c === ';') && depth === 0) parts.push(''); else parts[parts.length - 1] += c;
  }
  return parts.map(p => p.split(/=|\\in(?![A-Za-z])|\\colon|\\circ(?![A-Za-z])/)[0].trim()).filter(Boolean);
}

/// What the project says twice: file, line, text.
export function faults(root) {
  const out = [], file = 'docs/pages/12_notation.md', notation = path.join(root, file);
  const all = fs.existsSync(notation) ? tables(fs.readFileSync(notation, 'utf8')) : [];
  for (const { scope, rows } of all) {
    const seen = new Map();
    for (const row of rows) for (const symbol of row.symbols) {
      if (seen.has(symbol)) out.push({ file, line: row.line, text: `${symbol} stands twice in the table of ${scope}, first in line ${seen.get(symbol)}` });
      else seen.set(symbol, row.line);
    }
  }
  for (const page of walk(path.join(root, 'chapters')).filter(f => f.endsWith('.md'))) {
    const source = fs.readFileSync(page, 'utf8'), label = /^# .*\{#(\w+)\}/.exec(source)?.[1] ?? '';
    const first = new Map();
    // The table of the page itself, then that of its chapter.
    const inForce = [label, label.slice(0, 4)].map(l => all.filter(t => t.scope === l).flatMap(t => t.rows));
    const rowOf = letter => inForce.map(rows => rows.find(r => r.symbols.some(s => letterOf(s) === letter))).find(Boolean);
    for (const use of introduced(source)) {
      const where = { file: path.relative(root, page), line: use.line };
      const before = first.get(use.letter);
      if (before && !agree(before.kind, use.kind)) { out.push({ ...where, text: `"${use.words}" (${use.kind}); in line ${before.line} "${before.words}" (${before.kind})` }); continue; }
      first.set(use.letter, before ?? use);
      const row = before ? null : rowOf(use.letter);
      const named = row ? [...kindOf].filter(([word]) => new RegExp(`\\b${word}\\b`, 'i').test(row.text)).map(([, kind]) => kind) : [];
      if (named.length && !named.some(kind => agree(kind, use.kind))) out.push({ ...where, text: `"${use.words}" (${use.kind}); line ${row.line} of ${file} says "${row.text.replace(/\\f\$/g, '')}"` });
    }
  }
  return out;
}

if (process.argv[1] && path.resolve(process.argv[1]) === path.resolve(new URL(import.meta.url).pathname)) {
  const opt = options({ root: '.', list: '' });
  if (opt.list) { for (const u of introduced(fs.readFileSync(opt.list, 'utf8'))) console.log(`${u.line}\t${u.letter}\t${u.kind}\t${u.words}`); process.exit(0); }
  const found = faults(opt.root);
  for (const f of found) console.error(`${f.file}:${f.line}: ${f.text}`);
  if (found.length) { console.error(`${found.length} letter${found.length > 1 ? 's have' : ' has'} two meanings: rename one, or correct the row of the notation page`); process.exit(1); }
}
