// Scenes and the systems they are made of, in HTML: cards of scenes that were run, and a reference page for
// each system.
import fs from 'node:fs';
import path from 'node:path';
import { escapeHtml, labelled, number, prose, walk } from './lib.mjs';
import { columns, keyTable, unit } from './keys.mjs';
import { inlineSvg } from './programs.mjs';
import { mathematics } from './small_print.mjs';

/// What a run said, with the folder as a reader would name it.
const withoutFolder = (said, name) => said.replace(new RegExp(`\\S*/report/scenes/${name}\\b`, 'g'), name);

/// What the runs of a build have left: scenes by name, and the registry of systems; both null where none has run.
export function readScenes(root, build) {
  const dir = path.join(build, 'report/scenes');
  const registry = path.join(dir, 'systems.json');
  if (!fs.existsSync(registry)) return { scenes: null, systems: null };
  const scenes = new Map();
  for (const file of walk(path.join(root, 'data/scenes')).filter(f => f.endsWith('.toml')).sort()) {
    const name = path.basename(file, '.toml'), folder = path.join(dir, name), summary = path.join(folder, 'summary.json');
    if (!fs.existsSync(summary)) continue;
    const said = path.join(dir, `${name}.txt`);
    scenes.set(name, { name, folder, file: path.relative(root, file), text: fs.readFileSync(file, 'utf8').trimEnd(), summary: JSON.parse(fs.readFileSync(summary, 'utf8')), said: fs.existsSync(said) ? withoutFolder(fs.readFileSync(said, 'utf8').trimEnd(), name) : '' });
  }
  return { scenes, systems: JSON.parse(fs.readFileSync(registry, 'utf8')) };
}

const power = x => {
  const m = /^([-+]?[\d.]+)e([-+]?\d+)$/.exec(Number(x).toExponential(1));
  return Number(x) === 0 ? '0' : `${m[1].replace('-', '−')}·10<sup>${String(Number(m[2])).replace('-', '−')}</sup>`;
};

/// The comment at the head of a scene in lines that the box holds; the rest as it is.
function withShortHead(text, width = 88) {
  const lines = text.split('\n'), end = lines.findIndex(l => !l.startsWith('#'));
  if (end < 1) return text;
  const out = ['#'];
  for (const word of lines.slice(0, end).map(l => l.replace(/^#\s*/, '')).join(' ').split(/\s+/)) {
    if (out.at(-1).length + 1 + word.length > width) out.push('#');
    out[out.length - 1] += ` ${word}`;
  }
  return [...out, ...lines.slice(end)].join('\n');
}

/// The scene as it is written, the command, and what it said; with the permanent anchor of the scene where this is its place.
export function sceneCard(scene, id) {
  const output = scene.said ? `<pre class="output">${escapeHtml(scene.said)}</pre>` : '';
  return `<div class="program scene"${id ? ` id="${id}"` : ''}><div class="program-head"><span class="program-name">actio run ${escapeHtml(scene.file)} --out ${scene.name} --plots</span></div>` +
    `<pre class="fragment scene-text">${escapeHtml(withShortHead(scene.text))}</pre>${output}</div>`;
}

/// The page of a run that its `--plots` wrote, as a file of the book; null where there is none.
export function viewerOf(scene) {
  const from = path.join(scene.folder, 'plots/index.html');
  return fs.existsSync(from) ? { from, to: `viewer_${scene.name}.html` } : null;
}

/// That page in a frame, at a moment of the run, and a link to it; or its moving picture alone, which plays by itself.
export function viewerFrame(scene, to, moment, stage) {
  if (stage)
    return `<figure class="viewer stage"><iframe src="${to}#t=${escapeHtml(moment || '0')}&amp;play&amp;stage" title="${escapeHtml(scene.summary.title)}: the motion" loading="lazy"></iframe>` +
      `<figcaption><code>actio run ${scene.name} --plots</code> · <a href="${to}">its page with curves and figures</a> · <a href="@ref:page:scenefile_${scene.name}">the scene</a></figcaption></figure>`;
  return `<figure class="viewer"><iframe src="${to}#t=${escapeHtml(moment || '0')}" title="${escapeHtml(scene.summary.title)}: the page of the run" loading="lazy"></iframe>` +
    `<figcaption><a href="${to}">Open the viewer</a>: <code>plots/index.html</code> of this run. Play, drag to turn the view, drag over a curve to look closer.</figcaption></figure>`;
}

/// The page of a scene: what it is about, its motion, its text.
export function scenePage(scene) {
  const about = [];
  for (const line of scene.text.split('\n')) { if (!line.startsWith('#')) break; about.push(line.replace(/^#\s*/, '')); }
  return [`# Scene ${scene.name} {#scenefile_${scene.name}}`, '', `**${scene.summary.title}.** ${about.map(inMarkdown).join(' ')}`, '', `\\sceneviewer{${scene.name}}`, '', `\\scenefile{${scene.name}}`, '',
    `It is a scene of the system \\ref system_${scene.summary.system} "${scene.summary.system}". \\ref scenes says how to run it.`, ''].join('\n');
}

/// A program in Python and what it said; null where the module was not built.
export function pythonCard(file, text, said) {
  const output = said === null ? '<span class="notbuilt">not run: the module is not built</span>' : `<pre class="output">${escapeHtml(said.trimEnd())}</pre>`;
  return `<div class="program scene"><div class="program-head"><span class="program-name">python3 ${escapeHtml(file)}</span></div><pre class="fragment scene-text">${escapeHtml(text.trimEnd())}</pre>${output}</div>`;
}

/// A picture that a run drew.
export function scenePicture(scene, name, caption, prefix) {
  const file = path.join(scene.folder, 'plots', `${name}.svg`);
  if (!fs.existsSync(file)) return null;
  return inlineSvg(fs.readFileSync(file, 'utf8'), caption, prefix);
}

/// The estimated error of a run, in short: of the attitude or configuration where it is known, otherwise of the momentum.
function errorOf(summary) {
  const error = summary.error ?? {}, until = summary.error_until ?? {};
  for (const [name, unit] of [['attitude', ' rad'], ['configuration', ''], ['momentum', ''], ['vorticity', '']]) {
    if (typeof error[name] === 'number') return `${name} ${power(error[name])}${unit}`;
    if (name in until) return `${name} ${power(until[name].error)}${unit} until t = ${number(until[name].time)}`;
  }
  return String(error.how ?? '').startsWith('exact') ? 'rounding' : '';
}

/// Every scene: what it is, rows, steps, time, the worst drift, the error.
export function sceneTable(scenes) {
  const rows = [...scenes.values()].map(s => {
    const drifts = Object.entries(s.summary.drift ?? {});
    const worst = drifts.length ? drifts.reduce((a, b) => (b[1] > a[1] ? b : a)) : null;
    const viewer = viewerOf(s);
    const cells = [`<td class="id"><a href="@ref:page:scenefile_${s.name}">${escapeHtml(path.basename(s.file))}</a></td>`,
      `<td>${prose(s.summary.title)}${viewer ? ` <a class="source" href="${viewer.to}">open the viewer</a>` : ''}</td>`, `<td class="id"><a href="@ref:page:system_${s.summary.system}">${escapeHtml(s.summary.system)}</a></td>`,
      `<td class="num">${s.summary.rows}</td>`, `<td class="num">${s.summary.steps || '—'}</td>`, `<td class="num">${number(1000 * s.summary.wall_seconds)} ms</td>`, `<td>${worst ? `${escapeHtml(worst[0])} ${power(worst[1])}` : ''}</td>`,
      `<td>${errorOf(s.summary)}</td>`];
    return `<tr>${labelled(cells, ['', '', 'system', 'rows', 'steps', 'time', 'worst drift', 'error'])}</tr>`;
  });
  return `<table class="programs stacked"><thead><tr><th>scene</th><th>what it is</th><th>system</th><th class="num">rows</th><th class="num">steps</th><th class="num">time</th><th>worst drift</th><th>error</th></tr></thead><tbody>${rows.join('')}</tbody></table>`;
}

/// Products and powers of dimensions, as they are written for a terminal: mass x length^2.
const dimensions = /\(?\b(?:mass|energy|length|time|1)(?:\^\d)?(?:(?: x |\/)(?:mass|energy|length|time)\b(?:\^\d)?)+(?:\)(?:\^\d?k?)?)?|\b(?:length|time)\^\d/g;
const dimension = text => `\\f$${text.replace(/ x /g, ' \\times ').replace(/\b(mass|energy|length|time)\b/g, '\\text{$1}').replace(/\^(\w+)/g, '^{$1}')}\\f$`;
/// Plain text as Markdown, with its mathematics as formulas.
function inMarkdown(text) {
  const parts = [];
  let from = 0;
  for (const m of String(text ?? '').matchAll(dimensions)) parts.push(text.slice(from, m.index), dimension(m[0])), from = m.index + m[0].length;
  parts.push(String(text ?? '').slice(from));
  return parts.map((part, i) => (i % 2 ? part : mathematics(part).map((piece, k) => (k % 2 ? `\\f$${piece.replaceAll('|', '\\vert ')}\\f$` : piece.replaceAll('|', '\\|'))).join(''))).join('');
}

const formula = tex => tex ? `\\f$${tex.replaceAll("|", "\\vert ")}\\f$` : "";
const cell = text => String(text ?? '').replaceAll('|', '\\|');
const statements = (book, text) => String(text ?? '').split(/[ ,]+/).filter(Boolean).every(id => book.byId.has(id))
  ? String(text ?? '').split(/[ ,]+/).filter(Boolean).map(id => `\\ref ${id}`).join(', ') : cell(text);

/// The reference page of a system, as a page of the book.
export function systemPage(book, system) {
  const lines = [`# System ${system.name} {#system_${system.name}}`, '', `**${system.title}.** ${system.meaning}`, '', system.statement ? `In the thesis: ${statements(book, system.statement)}.` : '', ''];
  lines.push('## Keys', '', ...keyTable(system.parameters));
  lines.push('', '## Methods', '', '| method | orders | what it is | source |', '|---|---|---|---|');
  for (const m of system.methods) lines.push(`| \`${m.name}\` | ${m.orders.join(', ')} | ${inMarkdown(m.meaning)} | ${statements(book, m.statement)} |`);
  lines.push('', '## Quantities', '', '| quantity | what it is | formula | kind, unit | columns | needs | conserved | thesis |', '|---|---|---|---|---|---|---|---|');
  for (const q of system.quantities) lines.push(`| \`${q.name}\` | ${inMarkdown(q.meaning)} | ${formula(q.formula)} | ${q.kind}, ${unit(q.unit)} | ${columns(q)} | ${q.needs.length ? q.needs.map(n => `\`${n}\``).join(', ') : 'the state'} | ${q.conserved ? 'yes' : ''} | ${statements(book, q.statement)} |`);
  const examples = [...(book.scenes ?? new Map()).values()].filter(s => s.summary.system === system.name);
  if (examples.length) lines.push('', '## Scenes', '', ...examples.map(s => `- \\ref scenefile_${s.name} "${path.basename(s.file)}": ${s.summary.title}`));
  return lines.join('\n') + '\n';
}
