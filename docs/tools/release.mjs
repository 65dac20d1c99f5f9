// The figures of the release: what `./run record` has recorded in docs/release of the runs that a first build
// does not do, and how they stand beside figures of the build.
//
// docs/release/benchmarks and docs/release/stress hold reports of programs as they were written, with their
// pictures; checks.json the evidence of statements in the columns that `./run` leaves out. Each says in its
// member "release" when, on which processor and at which commit it was measured.
import fs from 'node:fs';
import path from 'node:path';

import {escapeHtml} from './lib.mjs';

/// Scalars whose columns every `./run` fills, so that they need no record.
export const quickColumns = ['prime', 'rational', 'double'];

// ---- Where a figure comes from

/// 2026-11-22 18:45 UTC on AMD EPYC with GCC 12.2.0, commit e30f6aa0b1
export const measuredAt = r => `${r.date} on ${r.processor} with ${r.compiler}, commit ${r.commit}`;
/// Class of what a report says: of a short run, of the release, or none where it is a full run of this build.
export const originClass = report => (report.release ? 'from-release' : report.short ? 'from-short' : '');
export const originText = report =>
    (report.release ? `figure of the release, measured ${measuredAt(report.release)}` :
         report.short ? 'figure of a short run' :
                        '');

/// The same at the end of a caption.
export const originNote = report =>
    (originText(report) ? `<span class="origin" title="${escapeHtml(originText(report))}">${
                              report.release ? 'Of the release.' : 'Of a short run.'}</span>` :
                          '');

/// What the colours mean, for those that were used: `reports` are all whose figures a page shows.
export function legend(reports) {
  const lines = [];
  if (reports.some(r => r.short && !r.release))
    lines.push(
        'Figures <span class="figure from-short">in this colour</span> are those of a short run of this ' +
        'build, with fewer rounds and shorter intervals, in which other work of the machine shows more; ' +
        '<code>./run bench</code> replaces them.');
  const released = reports.filter(r => r.release);
  if (released.length) {
    const commands = [
      ...new Set(released.map(
          r => (r.program.startsWith('stress_') ? '<code>./run stress</code>' : '<code>./run bench</code>')))
    ].sort();
    const places =
        [...new Set(released.map(r => measuredAt({...r.release, date: r.release.date.slice(0, 10)})))].sort();
    lines.push(
        `Figures <span class="figure from-release">in this colour</span> are those of the release, measured ${
            places.map(escapeHtml).join('; ')}; ${commands.join(' and ')} ${
            commands.length > 1 ? 'replace' : 'replaces'} them by those of this machine.`);
  }
  return lines.map(l => `<p class="origin-legend">${l}</p>`).join('');
}

// ---- Reports of programs

/// The report of a program that not every build runs: of this build, else of the release.
export const measured = (book, program) => book.optional.get(program) ?? book.release.programs.get(program);

/// Reports of benchmarks and long tests that the release recorded, by program.
export function releasedPrograms(root) {
  const programs = new Map();
  for (const kind of ['benchmarks', 'stress']) {
    const folder = path.join(root, 'docs/release', kind);
    for (const f of fs.existsSync(folder) ? fs.readdirSync(folder).filter(f => f.endsWith('.json')).sort() :
                                            []) {
      const report = JSON.parse(fs.readFileSync(path.join(folder, f), 'utf8'));
      programs.set(report.program, {...report, folder});
    }
  }
  return programs;
}

// ---- Evidence of statements, packed: each text once, an entry as a list, numbers to three digits.

const shortened = x => (typeof x === 'number' ? Number(x.toPrecision(3)) : x);

/// @param statements  of the ledger
/// @param columns     which scalars are recorded
export function packChecks(statements, columns) {
  const words = new Map(), fields = [];
  const word = text => {
    if (!words.has(text)) words.set(text, words.size);
    return words.get(text);
  };
  const pack = entry => {
    const row = [];
    for (const [name, value] of Object.entries(entry)) {
      if (!['string', 'number', 'boolean'].includes(typeof value)) continue;
      if (!fields.includes(name)) fields.push(name);
      row[fields.indexOf(name)] = typeof value === 'string' ? [word(value)] : shortened(value);
    }
    return Array.from(row, x => x ?? null);
  };
  const packed = {};
  for (const s of statements) {
    const of = list => (list ?? []).filter(e => columns.includes(e.scalar)).map(pack);
    const evidence = of(s.evidence), control = of(s.control);
    if (evidence.length) packed[s.id] = {evidence, control};
  }
  return {fields, words: [...words.keys()], statements: packed};
}

export function unpackChecks({fields, words, statements}) {
  const entry = row => Object.fromEntries(
      row.map((x, i) => [fields[i], Array.isArray(x) ? words[x[0]] : x]).filter(([, x]) => x !== null));
  return new Map(
      Object.entries(statements)
          .map(([id, s]) => [id, {evidence: s.evidence.map(entry), control: s.control.map(entry)}]));
}

/// What the release recorded of the checks: when and where, the columns, and the entries by statement;
/// null where there is no record.
export function releasedChecks(root) {
  const file = path.join(root, 'docs/release/checks.json');
  if (!fs.existsSync(file)) return null;
  const json = JSON.parse(fs.readFileSync(file, 'utf8'));
  return {release: json.release, columns: new Set(json.columns), statements: unpackChecks(json)};
}

/// Evidence and control of a statement with the columns that this build has not run, of the release;
/// `released` names these. Only where the statement has evidence of this build: the verdict is of this build.
export function withRelease(book, record) {
  const recorded = book.release?.checks?.statements.get(record.id);
  const own = {evidence: record.evidence ?? [], control: record.control ?? [], released: []};
  if (!recorded || !own.evidence.length) return own;
  const wanted = list => list.filter(e => !book.columns.has(e.scalar)).map(e => ({...e, released: true}));
  const evidence = wanted(recorded.evidence), control = wanted(recorded.control);
  return {
    evidence: [...own.evidence, ...evidence],
    control: [...own.control, ...control],
    released: [...new Set(evidence.map(e => e.scalar))]
  };
}
