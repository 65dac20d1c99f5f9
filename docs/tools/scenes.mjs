// Scenes and the systems they are made of, in HTML: cards of scenes that were run, and a reference page for each system.
import fs from 'node:fs';
import path from 'node:path';
import { escapeHtml, number, prose, walk } from './lib.mjs';
import { columns, keyTable, unit } from './keys.mjs';
import { inlineSvg } from './programs.mjs';

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
    scenes.set(name, { name, folder, file: path.relative(root, file), text: fs.readFileSync(file, 'utf8').trimEnd(), summary: JSON.parse(fs.readFileSync(summary, 'utf8')), said: fs.existsSync(said) ? fs.readFileSync(said, 'utf8').trimEnd() : '' });
  }
  return { scenes, systems: JSON.parse(fs.readFileSync(registry, 'utf8')) };
}

const power = x => {
  const m = /^([-+]?[\d.]+)e([-+]?\d+)$/.exec(Number(x).toExponential(1));
  return Number(x) === 0 ? '0' : `${m[1].replace('-', '−')}·10<sup>${String(Number(m[2])).replace('-', '−')}</sup>`;
};

/// The scene as it is written, the command, and what it said.
export function sceneCard(book, scene) {
  const output = scene.said ? `<pre class="output">${escapeHtml(scene.said)}</pre>` : '';
  return `<div class="program scene" id="scene_${scene.name}"><div class="program-head"><span class="program-name">actio run ${escapeHtml(scene.file)}</span></div>` +
    `<pre class="fragment scene-text">${escapeHtml(scene.text)}</pre>${output}</div>`;
}

/// A program in Python and what it said; null where the module was not built.
export function pythonCard(file, text, said) {
  const output = said === null ? '<span class="notrun">not run: the module is not built</span>' : `<pre class="output">${escapeHtml(said.trimEnd())}</pre>`;
  return `<div class="program scene"><div class="program-head"><span class="program-name">python3 ${escapeHtml(file)}</span></div><pre class="fragment scene-text">${escapeHtml(text.trimEnd())}</pre>${output}</div>`;
}

/// A picture that a run drew.
export function scenePicture(scene, name, caption, prefix) {
  const file = path.join(scene.folder, 'plots', `${name}.svg`);
  if (!fs.existsSync(file)) return null;
  return inlineSvg(fs.readFileSync(file, 'utf8'), caption, prefix);
}

/// Every scene: what it is, rows, steps, time, the worst drift.
export function sceneTable(scenes) {
  const rows = [...scenes.values()].map(s => {
    const drifts = Object.entries(s.summary.drift ?? {});
    const worst = drifts.length ? drifts.reduce((a, b) => (b[1] > a[1] ? b : a)) : null;
    return `<tr><td class="id">${escapeHtml(path.basename(s.file))}</td><td>${prose(s.summary.title)}</td><td class="id">${escapeHtml(s.summary.system)}</td>` +
      `<td class="num">${s.summary.rows}</td><td class="num">${s.summary.steps || '—'}</td><td class="num">${number(1000 * s.summary.wall_seconds)} ms</td><td>${worst ? `${escapeHtml(worst[0])} ${power(worst[1])}` : ''}</td></tr>`;
  });
  return `<table class="programs"><thead><tr><th>scene</th><th>what it is</th><th>system</th><th class="num">rows</th><th class="num">steps</th><th class="num">time</th><th>worst drift</th></tr></thead><tbody>${rows.join('')}</tbody></table>`;
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
  for (const m of system.methods) lines.push(`| \`${m.name}\` | ${m.orders.join(', ')} | ${cell(m.meaning)} | ${statements(book, m.statement)} |`);
  lines.push('', '## Quantities', '', '| quantity | what it is | formula | kind, unit | columns | needs | kept | thesis |', '|---|---|---|---|---|---|---|---|');
  for (const q of system.quantities) lines.push(`| \`${q.name}\` | ${cell(q.meaning)} | ${formula(q.formula)} | ${q.kind}, ${unit(q.unit)} | ${columns(q)} | ${q.needs.length ? q.needs.map(n => `\`${n}\``).join(', ') : 'the state'} | ${q.conserved ? 'yes' : ''} | ${statements(book, q.statement)} |`);
  const examples = [...(book.scenes ?? new Map()).values()].filter(s => s.summary.system === system.name);
  if (examples.length) lines.push('', '## Scenes', '', ...examples.map(s => `- \`${s.file}\`: ${s.summary.title}`));
  return lines.join('\n') + '\n';
}
