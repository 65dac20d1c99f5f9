// What the book's tools share: the registry of statements, the reports, and how a number, a statement or a
// verdict is written.
import fs from 'node:fs';
import path from 'node:path';

export const escapeHtml = text => String(text).replace(/[&<>"]/g, c => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[c]);

/// Collects errors as `file:line: text` and ends the run with all of them at once.
export class Errors {
  list = [];
  add(file, line, text) { this.list.push(`${file}:${line}: ${text}`); }
  exitIfAny(what) {
    if (!this.list.length) return;
    for (const e of this.list) console.error(e);
    console.error(`${what}: ${this.list.length} error${this.list.length > 1 ? 's' : ''}`);
    process.exit(1);
  }
}

export function options(defaults) {
  const result = { ...defaults };
  for (let i = 2; i < process.argv.length; ++i) {
    const name = process.argv[i].replace(/^--/, '');
    if (!(name in defaults)) { console.error(`unknown option ${process.argv[i]}`); process.exit(2); }
    result[name] = typeof defaults[name] === 'boolean' ? true : process.argv[++i];
  }
  return result;
}

export function walk(dir) {
  if (!fs.existsSync(dir)) return [];
  return fs.readdirSync(dir, { withFileTypes: true }).sort((a, b) => a.name < b.name ? -1 : 1)
    .flatMap(e => e.isDirectory() ? walk(path.join(dir, e.name)) : [path.join(dir, e.name)]);
}

// ---- Registry and reports

/// Rows of registry.tsv as objects, in their order; columns are named by the first line.
export function readRegistry(file) {
  const [head, ...rows] = fs.readFileSync(file, 'utf8').split('\n').filter(l => l.trim() && !l.startsWith('#'));
  const names = head.split('\t').map(s => s.trim());
  return rows.map(row => Object.fromEntries(row.split('\t').map((cell, i) => [names[i], cell.trim()])));
}

/// Programs that not every build runs: their names' first word, where their sources are, and where below report/ their reports are.
export const optionalPrograms = { bench: 'benchmarks', stress: 'tests/stress' };

/// Reports of a build: `statements` is null where the ledger has not been merged, `programs` null where none has run; `optional` holds the benchmarks and
/// long tests that have run.
export function readReports(build) {
  const ledger = path.join(build, 'report/statements.json');
  let statements = null;
  if (fs.existsSync(ledger)) {
    const json = JSON.parse(fs.readFileSync(ledger, 'utf8'));
    statements = new Map((Array.isArray(json) ? json : json.statements).map(r => [r.id, r]));
  }
  const dir = path.join(build, 'report/programs');
  const files = walk(dir).filter(f => f.endsWith('.json'));
  const programs = files.length ? new Map() : null;
  for (const f of files) {
    const p = JSON.parse(fs.readFileSync(f, 'utf8'));
    const text = f.replace(/\.json$/, '.txt');
    p.program ??= path.basename(f, '.json');
    p.output = fs.existsSync(text) ? fs.readFileSync(text, 'utf8') : null;
    p.folder = dir;
    programs.set(p.program, p);
  }
  const optional = new Map();
  for (const folder of Object.values(optionalPrograms))
    for (const f of walk(path.join(build, 'report', folder)).filter(f => f.endsWith('.json'))) {
      const p = JSON.parse(fs.readFileSync(f, 'utf8'));
      p.program ??= path.basename(f, '.json');
      p.folder = path.dirname(f);
      p.written = fs.statSync(f).mtimeMs;
      optional.set(p.program, p);
    }
  const columns = new Set();
  for (const r of statements?.values() ?? []) for (const e of r.evidence ?? []) columns.add(e.scalar);
  return { statements, programs, optional, columns };
}

// ---- Numbers

const superscript = n => `<sup>${String(n).replace('-', '−')}</sup>`;

/// A number for a reader: 0, 0.0123, 4711, or 1.2·10⁻¹⁵.
export function number(x, digits = 2) {
  const v = Number(x);
  if (x === null || x === undefined || x === '') return '–';
  if (!Number.isFinite(v)) return escapeHtml(x);
  if (v === 0) return '0';
  const a = Math.abs(v);
  if (a >= 1e-3 && a < 1e5) return String(Number.isInteger(v) ? v : Number(v.toPrecision(Math.max(digits, 2)))).replace('-', '−');
  const [mantissa, exponent] = v.toExponential(digits - 1).split('e');
  const power = `10${superscript(Number(exponent))}`;
  return mantissa.replace(/\.?0+$/, '') === '1' ? power : `${mantissa.replace('-', '−')}·${power}`;
}

/// A residual in units of the rounding of its arithmetic, with the plain figure where the pointer rests.
export function inEpsilons(measured, epsilon) {
  if (!(Number(epsilon) > 0)) return number(measured);
  const units = Number(measured) / Number(epsilon);
  const shown = units === 0 ? '0' : units < 0.05 ? '&lt; 0.1' : units < 9.95 ? units.toFixed(1) : units < 1e5 ? String(Math.round(units)) : number(units);
  return `${shown}&#8239;<i>ε</i>`;
}

// ---- Statements

const kindWord = { eq: '', thm: 'Theorem', prop: 'Proposition', lem: 'Lemma', cor: 'Corollary', def: 'Definition', rem: 'Remark', claim: 'Claim', bridge: 'Bridge' };

/// eq_3_10 -> (3.10), thm_3_2_3 -> Theorem 3.2.3, claim_3_1_action_split -> Claim 3.1: action split.
export function label(id) {
  const [head, ...rest] = id.split('_');
  if (!(head in kindWord)) return id;
  const isNumber = s => /^\d+[a-z]?$/.test(s);
  let n = 0;
  while (n < rest.length && isNumber(rest[n])) ++n;
  const numbers = rest.slice(0, n).join('.'), words = rest.slice(n).join(' ');
  if (head === 'eq') return `(${numbers})${words ? ' ' + words : ''}`;
  return `${kindWord[head]} ${numbers}${words ? ': ' + words : ''}`;
}

/// The number alone: Claim 3.1.
export const shortLabel = id => label(id).replace(/:.*$/, '');

export const verdictText = {
  failed: ['failed', 'its check failed in this build'],
  holds: ['holds', 'holds as printed'],
  convention: ['convention', 'holds under a convention or a hypothesis that the note names'],
  corrected: ['corrected', 'fails as printed; the corrected form holds'],
  scope: ['scope', 'fixes scope only, nothing to compute'],
  pending: ['pending', 'not adjudicated yet'],
  notrun: ['not run', 'the checks have not been run in this build'],
};

export function badge(verdict) {
  const [word, title] = verdictText[verdict] ?? [verdict, ''];
  return `<span class="verdict verdict-${verdict}" title="${escapeHtml(title)}">${word}</span>`;
}

/// Text of a note: escaped, with `code`, $formulas$ and \(formulas\) kept as formulas.
export function prose(text) {
  return escapeHtml(text ?? '').replace(/\\f\$(.+?)\\f\$/g, '\\($1\\)').replace(/(?<!\\)\$(.+?)(?<!\\)\$/g, '\\($1\\)')
    .replace(/`([^`]+)`/g, '<code>$1</code>');
}

/// The cells of a row, each with the name of its column, which a narrow screen shows before it.
export const labelled = (cells, names) => cells.map((cell, i) => (names[i] ? cell.replace(/^<td/, `<td data-label="${escapeHtml(names[i])}"`) : cell)).join('');

/// A table that may be wider than the screen, in a box that scrolls.
export const boxed = table => `<div class="table-box">${table}</div>`;

export const columnNames = { prime: 'prime field', rational: 'rationals', double: 'double', dec50: '50 digits', dec100: '100 digits', ball: 'balls' };
export const columnOrder = ['prime', 'rational', 'double', 'dec50', 'dec100', 'ball'];

/// Largest measured/bound of a record (orders apart), and the entry it belongs to.
export function worst(record) {
  let result = null;
  for (const e of record.evidence ?? []) {
    if (e.kind === 'order') continue;
    const ratio = Number(e.bound) > 0 ? Number(e.measured) / Number(e.bound) : Number(e.measured) === 0 ? 0 : Infinity;
    const key = [ratio, e.scalar === 'double' ? 1 : 0];
    if (!result || key[0] > result.ratio || (key[0] === result.ratio && e.scalar === 'double')) result = { ratio, entry: e };
  }
  return result;
}

/// How many times the control misses what the statement meets: the smallest control over the largest residual, per scalar.
export function controlRatio(record) {
  const residuals = new Map();
  for (const e of record.evidence ?? []) if (e.kind !== 'order') residuals.set(e.scalar, Math.max(residuals.get(e.scalar) ?? 0, Number(e.measured)));
  let smallest = null;
  for (const c of record.control ?? []) {
    const scalar = c.scalar ?? (residuals.has('double') ? 'double' : [...residuals.keys()][0]);
    const residual = residuals.get(scalar);
    if (residual === undefined) continue;
    const ratio = residual === 0 ? Infinity : Number(c.measured) / residual;
    if (smallest === null || ratio < smallest) smallest = ratio;
  }
  return smallest;
}

export const ratioText = r => r === null || r === undefined ? '–' : r === Infinity ? '∞' : number(r);
