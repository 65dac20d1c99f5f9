// The proofs that a kernel has checked, in the book: the sources of proofs_checks/kernel as pages, the seal
// of a statement that has a proof there, and the table of all of them.
//
// A proof counts where `./run proofs` has found it closed: its list, kernel.tsv, names the sources by their
// digest, and a seal is shown only while the sources are those that were checked. Whether the proofs of a
// statement prove all of it was decided by hand: seals.tsv beside the sources says so, and what is missing.
import { createHash } from 'node:crypto';
import fs from 'node:fs';
import path from 'node:path';

import { escapeHtml, label, labelled, shortLabel } from './lib.mjs';

export const folder = 'proofs_checks/kernel';

/// The files in the order in which they are read: that of _CoqProject.
export function proofFiles(root) {
  const list = path.join(root, folder, '_CoqProject');
  if (!fs.existsSync(list)) return [];
  return fs.readFileSync(list, 'utf8').split('\n').map(l => l.trim()).filter(l => /^\w+\.v$/.test(l));
}

/// What the list of checked proofs names the sources by: all that the kernel reads, which comments are not.
export const digest = root => {
  const hash = createHash('sha256');
  for (const file of proofFiles(root)) hash.update(`${file}\n`).update(withoutComments(fs.readFileSync(path.join(root, folder, file), 'utf8')).replace(/\s+/g, ' '));
  return hash.digest('hex').slice(0, 16);
};

/// A source in pieces, in turn prose (a comment that is meant to be read) and code.
export function pieces(text) {
  const list = [];
  let at = 0;
  const line = place => text.slice(0, place).split('\n').length;
  const code = (from, to) => {
    const cut = text.slice(from, to), first = cut.search(/\S/);
    if (first >= 0) list.push({ code: cut.replace(/^\s*\n/, '').trimEnd(), line: line(from + first) });
  };
  for (const m of text.matchAll(/\(\*\*\s([\s\S]*?)\*\)/g)) {
    code(at, m.index);
    list.push({ prose: m[1].trim(), line: line(m.index) });
    at = m.index + m[0].length;
  }
  code(at, text.length);
  return list;
}

/// The registry's id that a theorem's name is or begins with; the longest.
export const idOf = (name, ids) => [...ids].filter(id => name === id || name.startsWith(`${id}_`)).sort((a, b) => b.length - a.length)[0] ?? null;

/// The same text, with blanks for what stands in comments, which may be nested.
export function withoutComments(text) {
  let out = '', depth = 0;
  for (let i = 0; i < text.length; ++i) {
    const two = text.slice(i, i + 2);
    if (two === '(*') ++depth;
    out += depth && text[i] !== '\n' ? ' ' : text[i];
    if (two === '*)' && depth) { out += ' ', ++i, --depth; }
  }
  return out;
}

/// The theorems of the sources: name, id or null, file, line, the statement as it is written, and which of the three it is.
export function theorems(root, ids) {
  const all = [];
  for (const file of proofFiles(root)) {
    const text = withoutComments(fs.readFileSync(path.join(root, folder, file), 'utf8'));
    for (const m of text.matchAll(/^Theorem\s+(\w+)([\s\S]*?)\.\s*\n\s*Proof/gm)) {
      const id = idOf(m[1], ids), refutes = /_printed_fails(_\w+)?$/.test(m[1]);
      all.push({ name: m[1], id, file, line: text.slice(0, m.index).split('\n').length,
        what: id === null ? 'beyond' : refutes ? 'refuted' : 'proved', statement: m[2].replace(/\s+/g, ' ').replace(/^ ?:? ?/, '').trim() });
    }
  }
  return all;
}

// ---- What was decided

/// The table of seals: by id whether its theorems prove the statement as a whole or in part, which they are, and what is missing.
export function readSeals(root) {
  const file = path.join(root, folder, 'seals.tsv');
  if (!fs.existsSync(file)) return new Map();
  const rows = fs.readFileSync(file, 'utf8').split('\n').slice(1).filter(Boolean).map(l => l.split('\t'));
  return new Map(rows.map(([id, how, names, missing]) => [id, { how, theorems: (names ?? '').split(' '), missing: missing === '-' ? '' : missing ?? '' }]));
}

/// What does not fit between the table and the theorems: each statement with a proof has its row, each row names just the theorems
/// that there are, and says what is missing where it does not hold the whole.
export function sealComplaints(seals, list) {
  const complaints = [], proofs = new Map();
  for (const t of list) if (t.what === 'proved') proofs.set(t.id, [...(proofs.get(t.id) ?? []), t.name]);
  for (const [id, names] of proofs) {
    const row = seals.get(id);
    if (!row) complaints.push(`${id} has a proof, ${names.join(' ')}, and no row`);
    else if (names.filter(n => !row.theorems.includes(n)).length) complaints.push(`${id}: ${names.filter(n => !row.theorems.includes(n)).join(' ')} is not among the theorems of its row; does the seal still hold?`);
  }
  for (const [id, row] of seals) {
    const gone = row.theorems.filter(n => !proofs.get(id)?.includes(n));
    if (gone.length) complaints.push(`${id}: no theorem ${gone.join(' ')}`);
    if (!['whole', 'part'].includes(row.how)) complaints.push(`${id}: a seal is 'whole' or 'part', not '${row.how}'`);
    if ((row.how === 'part') !== Boolean(row.missing)) complaints.push(`${id}: a seal in part, and no other, says what is missing`);
  }
  return complaints;
}

// ---- What was checked

const columns = ['name', 'id', 'file', 'line', 'what', 'assumptions', 'statement'];

export function writeList(file, rows, facts) {
  const head = Object.entries(facts).map(([k, v]) => `# ${k}: ${v}`).join('\n');
  fs.mkdirSync(path.dirname(file), { recursive: true });
  fs.writeFileSync(file, `${head}\n${columns.join('\t')}\n${rows.map(r => columns.map(c => r[c] ?? '-').join('\t')).join('\n')}\n`);
}

export function readList(file) {
  if (!fs.existsSync(file)) return null;
  const lines = fs.readFileSync(file, 'utf8').split('\n').filter(Boolean), facts = {};
  for (const l of lines.filter(l => l.startsWith('#'))) { const m = /^# ([\w ]+): (.*)$/.exec(l); if (m) facts[m[1]] = m[2]; }
  const rows = lines.filter(l => !l.startsWith('#')).slice(1).map(l => Object.fromEntries(l.split('\t').map((cell, i) => [columns[i], cell])));
  return { facts, rows: rows.map(r => ({ ...r, line: Number(r.line), id: r.id === '-' ? null : r.id })) };
}

/// The proofs that were checked as the sources stand: of this build, else of the release; rows by id, the rows that belong to
/// no statement of the thesis, and the facts of the run. Null where there are no proofs; without rows where none is current.
export function readKernel(root, build) {
  if (!proofFiles(root).length) return null;
  const now = digest(root);
  for (const [file, released] of [[path.join(build, 'report/kernel.tsv'), false], [path.join(root, 'docs/release/kernel.tsv'), true]]) {
    const list = readList(file);
    if (list?.facts.sources !== now) continue;
    const byId = new Map();
    for (const r of list.rows) if (r.id) byId.set(r.id, [...(byId.get(r.id) ?? []), r]);
    return { facts: list.facts, rows: list.rows, byId, released, seals: readSeals(root) };
  }
  return { facts: {}, rows: [], byId: new Map(), released: false, seals: new Map() };
}

// ---- Seals

const anchor = row => `proof_${row.name}`;

/// What a kernel has shown of a statement: '', 'part' or 'whole'; and whether the printed form is refuted.
export function proved(book, id) {
  return (book.kernel?.byId.get(id) ?? []).some(r => r.what === 'proved') ? book.kernel.seals.get(id)?.how ?? 'part' : '';
}
const missing = (book, id) => book.kernel.seals.get(id)?.missing ?? '';
export const refuted = (book, id) => (book.kernel?.byId.get(id) ?? []).some(r => r.what === 'refuted');

/// The seal of a statement, which leads to its proof.
export function seal(book, id) {
  const rows = book.kernel?.byId.get(id) ?? [];
  if (!rows.length) return '';
  const how = proved(book, id), wrong = rows.find(r => r.what === 'refuted'), proof = rows.find(r => r.name === id) ?? rows.find(r => r.what === 'proved');
  const links = [], needs = book.statements?.get(id)?.verdict === 'convention';
  if (proof) links.push(`<a class="seal" href="@ref:${anchor(proof)}" title="${how === 'whole' ? 'a kernel has checked a proof; no axiom is used' : `a kernel has checked a proof of a part; no axiom is used. Not proved: ${escapeHtml(missing(book, id))}`}">${how === 'whole' ? 'proved' : 'proved in part'}</a>`);
  if (wrong) links.push(`<a class="seal seal-refuted" href="@ref:${anchor(wrong)}" title="a kernel has checked a counterexample to the form that the thesis prints${needs ? ', without the convention that the note names' : ''}">${needs ? 'refuted without the convention' : 'print refuted'}</a>`);
  return links.join('');
}

// ---- Pages

const keyword = /\b(Theorem|Lemma|Corollary|Example|Definition|Fixpoint|Proof|Qed|Section|End|Variables?|Hypothes[ei]s|Context|Implicit Types?|Record|Notation|Local|Canonical|Let|Import|From|Require|Set|Unset|Open Scope|forall|exists|fun|let|in|if|then|else|match|with|end)\b/g;
/// Code with its keywords and comments set off.
function colour(code) {
  return code.split(/(\(\*[\s\S]*?\*\))/).map((part, i) => (i % 2 ? `<span class="comment">${escapeHtml(part)}</span>` : escapeHtml(part).replace(keyword, '<span class="keyword">$&</span>'))).join('');
}
/// A piece of a source: what is claimed stands open, how it is proved unfolds. The name of a theorem leads to its statement.
export function codeBlock(code, ids = new Set()) {
  const named = name => { const id = idOf(name, ids); return id ? `<a href="@ref:${id}">${name}</a>` : name; };
  const html = code.split(/(^Proof\.[^\n]*(?:Qed|Defined)\.$|^Proof\.[\s\S]*?(?:^|\s)(?:Qed|Defined)\.$)/m).map((part, i) => {
    if (!part.trim()) return '';
    if (i % 2 === 0) return `<pre class="coq">${colour(part.replace(/^\n+|\s+$/g, '')).replace(/(<span class="keyword">Theorem<\/span>\s+)(\w+)/g, (_, theorem, name) => `${theorem}<a class="target" id="proof_${name}"></a><b>${named(name)}</b>`)}</pre>`;
    const lines = part.trim().split('\n').length;
    return `<details class="coq-proof"><summary>proof, ${lines} line${lines === 1 ? '' : 's'}</summary><pre class="coq">${colour(part.trim())}</pre></details>`;
  });
  return `<div class="coq-code">${html.join('')}</div>`;
}

const stem = file => file.replace(/\.v$/, '');
/// The title of a source: its first line of prose.
export const titleOf = text => /^\*\s+(.*)$/m.exec(pieces(text).find(p => p.prose)?.prose ?? '')?.[1] ?? '';

/// The page of a source: its prose as text, its code as it is.
export function kernelPage(root, file) {
  const text = fs.readFileSync(path.join(root, folder, file), 'utf8'), lines = [];
  let titled = false;
  for (const p of pieces(text)) {
    if (p.code !== undefined) {
      if (/^(From|Set|Unset|Import|Local|Require|\s)+/.test(p.code) && !/Theorem|Lemma|Definition|Section/.test(p.code)) continue;
      lines.push('', `\\kernelcode{${file}:${p.line}}`, '');
      continue;
    }
    for (const l of p.prose.split('\n')) {
      const head = /^(\*+)\s+(.*)$/.exec(l.trim());
      if (!head) lines.push(l);
      else if (head[1].length === 1 && !titled) { lines.push(`# ${head[2]} {#kernel_${stem(file)}}`, ''); titled = true; }
      else lines.push('', `${'#'.repeat(Math.max(2, head[1].length))} ${head[2]}`, '');
    }
  }
  return lines.join('\n') + '\n';
}

/// The piece of code that begins at a line.
export const codeAt = (root, file, line) => pieces(fs.readFileSync(path.join(root, folder, file), 'utf8')).find(p => p.code !== undefined && p.line === line)?.code ?? '';

const rowLink = r => `<a href="@ref:${anchor(r)}"><code>${escapeHtml(r.name)}</code></a>`;

/// All statements with a proof, in the order of the thesis, and what is beyond it.
export function kernelTable(book) {
  const list = book.registry.filter(s => book.kernel.byId.has(s.id));
  const rows = list.map(s => {
    const of = book.kernel.byId.get(s.id), cell = what => of.filter(r => r.what === what).map(rowLink).join('<br/>');
    return `<tr>${labelled([`<td class="id"><a href="@ref:${s.id}">${shortLabel(s.id)}</a></td>`, `<td>${escapeHtml(s.subject)}${missing(book, s.id) ? `<div class="ledger-note">Not proved: ${escapeHtml(missing(book, s.id))}.</div>` : ''}</td>`, `<td>${proved(book, s.id) === 'whole' ? '<b>whole</b><br/>' : ''}${cell('proved')}</td>`, `<td>${cell('refuted')}</td>`], ['', '', 'proved', 'print refuted'])}</tr>`;
  });
  return `<table class="programs stacked kernel-table"><thead><tr><th>statement</th><th>subject</th><th>proved</th><th>print refuted</th></tr></thead><tbody>${rows.join('')}</tbody></table>`;
}
export const beyondTable = book => `<ul class="kernel-beyond">${book.kernel.rows.filter(r => r.what === 'beyond').map(r => `<li>${rowLink(r)} in <code>${escapeHtml(r.file)}</code></li>`).join('')}</ul>`;

/// How many, in words for the page.
export function kernelCounts(book) {
  const { rows, byId, facts, released } = book.kernel;
  const count = what => [...byId.values()].filter(of => of.some(r => r.what === what)).length;
  if (!rows.length) return '<p><span class="notrun">the proofs have not been checked as they stand; <code>./run proofs</code> does</span></p>';
  const wholly = [...byId.keys()].filter(id => proved(book, id) === 'whole').length;
  return `<p class="kernel-counts"><b>${count('proved')}</b> statements of the thesis are proved, ${wholly} of them as a whole and the others in part; of <b>${count('refuted')}</b> statements the printed form is refuted; <b>${rows.filter(r => r.what === 'beyond').length}</b> theorems go beyond them. Checked by ${escapeHtml(facts.checked)}${released ? ', for the release' : ''}. Axioms: <b>${escapeHtml(facts.axioms)}</b>.</p>`;
}
