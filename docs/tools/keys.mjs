// The keys of a scene, in the book: a reference page made from what `actio list keys --json` says, and the
// tables of the pages of the systems.
import fs from 'node:fs';
import path from 'node:path';
import { mathematics } from './small_print.mjs';

/// What the command said of its keys; null where it was not asked.
export function readKeys(build) {
  const file = path.join(build, 'report/scenes/keys.json');
  return fs.existsSync(file) ? JSON.parse(fs.readFileSync(file, 'utf8')) : null;
}

const inTex = part => part.replace(/ x /g, '\\cdot ')
  .replace(/[a-z]{2,}/g, word => (word === 'cdot' ? word : `\\text{${word}}`)).replace(/\^(\w+)/g, '^{$1}');
/// A unit in words as a formula: energy x time, (energy x time)^2, 1/time; what stands between commas is taken by
/// itself.
export const unit = text => String(text ?? '').split(', and ').map(part => (part === '' ? '' : `\\f$${inTex(part)}\\f$`)).join(', and ');

const entities = { '<': '&lt;', '>': '&gt;', '&': '&amp;', '"': '&quot;' };
/// Plain text in a cell of a table or in a paragraph: signs of Markdown stand for themselves.
const plain = text => String(text ?? '').replace(/[\\`*<>#|@$&~"]/g, sign => entities[sign] ?? `\\${sign}`);
/// The same, with its mathematics as formulas; code between back quotes and texts between double ones stay as they are.
const withFormulas = text => String(text ?? '').split(/(`[^`]+`|"[^"]*")/).map((part, i) => {
  if (i % 2) return part.startsWith('`') ? part : plain(part);
  return mathematics(part).map((piece, k) => (k % 2 ? `\\f$${piece.replaceAll('|', '\\vert ')}\\f$` : plain(piece))).join('');
}).join('');
const code = text => `\`${text}\``;
const anchor = key => `key_${key.replaceAll('.', '_')}`;

/// The rows of a table of keys, those of [scene] last: each with what it expects, what stands where it is left out,
/// its unit and its meaning.
export function keyTable(keys) {
  const ofScene = k => k.key.startsWith('scene.');
  const rows = [...keys.filter(k => !ofScene(k)), ...keys.filter(ofScene)].map(k =>
    `| \\ref ${anchor(k.key)} "${k.key}" | ${plain(k.expects)} | ${plain(k.fallback)} | ${unit(k.unit)} | ${withFormulas(k.meaning)} |`);
  return ['| key | expects | where left out | unit | what it is |', '|---|---|---|---|---|', ...rows];
}

/// The names of the columns of a quantity.
export const columns = quantity => (quantity.columns ?? []).map(name => (name === '...' ? '…' : code(name))).join(' ');

const sections = {
  scene: 'what the run is called', system: 'what is simulated', initial: 'how it begins',
  method: 'how it is stepped', run: 'when there are rows', output: 'what is wanted from it',
};

function entry(key) {
  const dot = key.key.lastIndexOf('.'), name = key.key.slice(dot + 1), table = key.key.slice(0, dot);
  const allowed = key.allowed.length ? `: ${key.allowed.map(code).join(', ')}` : '';
  const lines = [withFormulas(key.meaning), ''];
  lines.push(`- **expects** ${plain(key.expects)}${allowed}`);
  lines.push(`- **where left out** ${plain(key.fallback)}`);
  if (key.unit) lines.push(`- **unit** ${unit(key.unit)}`);
  lines.push(`- **example** ${code(`${name} = ${key.example}`)} in ${code(`[${table}]`)}`);
  return lines;
}

/// The page, as Markdown.
export function keysPage(keys) {
  const lines = ['# Every key of a scene {#scene_keys}', '',
    'A scene has six sections with these keys. Any other key is refused, and the message names the nearest one.',
    'The command prints the same: `actio list keys`, `actio show run.every`, `actio new rigid_body`.', ''];
  const systems = new Set(keys.flatMap(k => k.systems));
  for (const [section, what] of Object.entries(sections)) {
    lines.push(`## [${section}]: ${what} {#keys_of_${section}}`, '');
    const names = [...new Set(keys.map(k => k.key))].filter(name => name.startsWith(`${section}.`));
    for (const name of names) {
      lines.push(`### ${name} {#${anchor(name)}}`, '');
      for (const key of keys.filter(k => k.key === name)) {
        const of = key.systems.map(s => `\\ref system_${s} "${s}"`).join(', ');
        if (key.systems.length < systems.size) lines.push(`In scenes of ${of}:`, '');
        lines.push(...entry(key), '');
      }
    }
  }
  return lines.join('\n') + '\n';
}
