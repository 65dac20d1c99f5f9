// The reference of the package actio of Python: what the built module says of itself, for the page
// docs/pages/07_python_reference.md. A command `\pythonreference{run,load}` on its own line is replaced by the
// entries of these names: signature, docstring, and for a class its members.
import fs from 'node:fs';
import path from 'node:path';
import { spawnSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { escapeHtml } from './lib.mjs';

/// What the module of a build says; `why` where it cannot be asked.
export function readPython(build) {
  const folder = path.join(build, 'python'), cache = path.join(build, 'CMakeCache.txt');
  if (!fs.existsSync(path.join(folder, 'actio/__init__.py'))) return { names: [], why: `${folder}/actio is not built: ninja python_module` };
  const told = fs.existsSync(cache) ? /^_?Python_EXECUTABLE:\w+=(.+)$/m.exec(fs.readFileSync(cache, 'utf8'))?.[1] : null;
  const run = spawnSync(told ?? '/usr/bin/python3', ['-B', fileURLToPath(new URL('./python_describe.py', import.meta.url))],
    { encoding: 'utf8', env: { ...process.env, PYTHONPATH: folder } });
  if (run.status !== 0) return { names: [], why: (run.stderr || String(run.error)).trim().split('\n').at(-1) };
  return JSON.parse(run.stdout);
}

const anchor = (name, member = '') => `python_${/^[A-Z]/.test(name) ? 'class_' : ''}${name}${member && `_${member}`}`;
const fieldLine = /^([a-z_]\w*(?:, [a-z_]\w*)*): (?=\S)/;

/// Paragraphs of a docstring: text, code (indented after an empty line), or arguments (`name: what it is`).
export function paragraphs(doc) {
  return doc.split(/\n\s*\n/).map(part => {
    const lines = part.split('\n');
    if (lines.every(l => /^ {4}/.test(l))) return { code: lines.map(l => l.slice(4)).join('\n') };
    if (!fieldLine.test(lines[0])) return { text: lines.join(' ') };
    const list = [];
    for (const l of lines) {
      const m = fieldLine.exec(l);
      if (m) list.push({ names: m[1].split(', '), text: l.slice(m[0].length) });
      else if (/^\s/.test(l)) list.at(-1).text += ` ${l.trim()}`;
      else list.push({ names: [], text: l });
    }
    return { list };
  });
}
/// The fields and arguments that a docstring explains.
const explained = doc => new Set(paragraphs(doc ?? '').flatMap(p => p.list ?? []).flatMap(e => e.names));

/// What the strict book refuses: a public name or member without a docstring, or that the page does not show.
export function missing(python, shown) {
  const found = [];
  for (const e of python.names) {
    if (!e.doc?.trim()) found.push(`actio.${e.name} has no docstring`);
    if (!shown.has(e.name)) found.push(`actio.${e.name} stands in no \\pythonreference`);
    const fields = explained(e.doc);
    for (const m of e.members) {
      if (m.kind === 'field' ? !fields.has(m.name) : !m.doc?.trim()) found.push(`actio.${e.name}.${m.name} has no docstring`);
    }
  }
  for (const name of shown) if (!python.names.some(e => e.name === name)) found.push(`there is no actio.${name}`);
  return found;
}

/// HTML of a docstring, with links to the names of the package between back quotes.
function prose(text, python) {
  return escapeHtml(text).replace(/`([^`]+)`/g, (_, code) => {
    const [, name, member] = /^(?:actio\.)?(\w+)(?:\.(\w+))?$/.exec(code.replace(/&#?\w+;/g, '')) ?? [];
    const entry = python.names.find(e => e.name === name);
    const to = entry && (member ? entry.members.some(m => m.name === member && m.kind !== 'field') && anchor(name, member) : anchor(name));
    return to ? `<a href="#${to}"><code>${code}</code></a>` : `<code>${code}</code>`;
  });
}
function docHtml(doc, call, python) {
  const types = new Map((call?.arguments ?? []).map(a => [a.name, a.type]));
  return paragraphs(doc).map(p => {
    if (p.code !== undefined) return `<pre class="fragment">${escapeHtml(p.code)}</pre>`;
    if (p.text !== undefined) return `<p>${prose(p.text, python)}</p>`;
    return `<dl class="python-arguments">${p.list.map(e => {
      const type = e.names.length === 1 && types.get(e.names[0]);
      return `<dt>${e.names.map(n => `<code>${n}</code>`).join(', ')}${type ? ` <span class="python-type">${escapeHtml(type)}</span>` : ''}</dt><dd>${prose(e.text, python)}</dd>`;
    }).join('')}</dl>`;
  }).join('');
}
const signature = (name, call) => {
  if (!call) return `<code>${name}</code>`;
  if (!call.arguments) return `<code>${name}</code>${call.returns ? ` <span class="python-type">${escapeHtml(call.returns)}</span>` : ''}`;
  const list = call.arguments.map(a => escapeHtml(a.name + (a.default === undefined ? '' : `=${a.default}`))).join(', ');
  return `<code>${name}(${list})</code>${call.returns && call.returns !== 'None' ? ` <span class="python-type">→ ${escapeHtml(call.returns)}</span>` : ''}`;
};

/// How entries look.
export const style = `<style>
.python-signature { padding: 6px 10px; background: var(--fragment-background); border: 1px solid var(--separator-color); border-radius: 5px; overflow-wrap: anywhere; }
.python-type { font-weight: normal; color: var(--page-secondary-foreground-color); font-size: 0.92em; overflow-wrap: anywhere; }
.python-entry pre { overflow-x: auto; }
dl.python-members > dt { margin-top: 0.7em; }
dl.python-members > dd, dl.python-arguments > dd { margin-left: 1.5em; }
dl.python-members > dd > p { margin: 0.2em 0; }
</style>`;

/// The entry of a name: { id, title, html }.
export function entry(python, name) {
  const e = python.names.find(found => found.name === name);
  if (!e) return null;
  const made = e.kind === 'class' && e.call && e.members.length && !['Run', 'Snapshots', 'Member', 'Sweep'].includes(name);
  const head = e.kind === 'error' ? `<code>actio.${name}</code> <span class="python-type">${escapeHtml(e.bases.join(', '))}</span>` :
    e.kind === 'class' ? (made ? signature(`actio.${name}`, { ...e.call, returns: '' }) : `<code>actio.${name}</code>`) : signature(`actio.${name}`, e.call);
  const member = m => `<dt id="${anchor(name, m.name)}">${signature(m.name, m.call)}</dt><dd>${docHtml(m.doc ?? '', m.call, python)}</dd>`;
  const listed = e.members.filter(m => m.kind !== 'field');
  return { id: anchor(name), title: name, html: `<div class="python-entry"><p class="python-signature">${head}</p>${docHtml(e.doc ?? '', e.call, python)}${
    listed.length ? `<dl class="python-members">${listed.map(member).join('')}</dl>` : ''}</div>` };
}
