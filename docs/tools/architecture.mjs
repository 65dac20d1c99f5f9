// The page "Architecture": the modules of the library and the rooms of the program, the arrows between them and
// their sizes, read from where they are declared.
//
// Modules and arrows are the lines `actio_module(NAME USES ...)` of CMakeLists.txt, rooms the lines
// `actio_room(NAME USES ...)` of src/program/CMakeLists.txt; the test `layering` holds every #include to
// them. What each holds is the \brief of its folder in docs/rooms.dox; sizes are counted in the sources.
import fs from 'node:fs';
import path from 'node:path';
import { boxed, escapeHtml, labelled, walk } from './lib.mjs';

/** The modules of the library, or with `program` the rooms of the program, in the order of their declaration:
 *  { name, uses, about, files, lines, floor }. A floor is one above the highest that is used. */
export function readArchitecture(root, errors, which = 'library') {
  const read = file => fs.readFileSync(path.join(root, file), 'utf8');
  const { folder, declared, line } = which === 'program' ?
    { folder: 'src/program', declared: 'src/program/CMakeLists.txt', line: /^actio_room\(([\w/]+)(.*)\)$/gm } :
    { folder: 'src/actio', declared: 'CMakeLists.txt', line: /^actio_module\((\w+)(.*)\)$/gm };
  const rooms = read('docs/rooms.dox').matchAll(new RegExp(`\\\\dir ${folder}/([\\w/]+)\\s+\\\\brief ([^]*?)\\s*\\*/`, 'g'));
  const about = new Map([...rooms].map(m => [m[1], m[2]]));
  const dox = path.join(root, 'docs/rooms.dox');
  const architecture = new Map();
  for (const [, name, rest] of read(declared).matchAll(line)) {
    const uses = (/USES ([\w/ ]+?)(?: LINKS|$)/.exec(rest.trim())?.[1] ?? '').split(' ').filter(Boolean);
    const here = path.join(root, folder, name);
    const files = walk(here).filter(f => /\.[hc]pp$/.test(f) && (which === 'library' || path.dirname(f) === here));
    const lines = files.reduce((sum, f) => sum + fs.readFileSync(f, 'utf8').split('\n').length - 1, 0);
    const floor = uses.reduce((highest, u) => Math.max(highest, architecture.get(u).floor + 1), 0);
    if (!about.has(name)) errors.add(dox, 1, `nothing is said of ${folder}/${name}`);
    architecture.set(name, { name, uses, about: about.get(name) ?? '', files: files.length, lines, floor });
  }
  for (const name of about.keys())
    if (!architecture.has(name)) errors.add(dox, 1, `${declared} does not declare ${name}`);
  return architecture;
}

/** The rooms floor by floor, the ground floor at the bottom; an arrow from each room to those that it uses. */
export function architecturePlan(architecture) {
  const floors = [];
  for (const room of architecture.values()) (floors[room.floor] ??= []).push(room);
  const high = 34, step = 72, wide = 136, place = new Map();
  const width = (wide + 12) * Math.max(5, ...floors.map(rooms => rooms.length));
  floors.forEach((rooms, floor) => rooms.forEach((room, i) => {
    const x = width * (i + 0.5) / rooms.length, y = step * (floors.length - 1 - floor) + high;
    place.set(room.name, { x, y });
  }));
  const arrows = [...architecture.values()].flatMap(room => room.uses.map(used => {
    const from = place.get(room.name), to = place.get(used), a = from.y + high / 2, b = to.y - high / 2 - 5;
    const middle = (a + b) / 2, curve = `M${from.x} ${a} C${from.x} ${middle} ${to.x} ${middle} ${to.x} ${b}`;
    return `<path d="${curve}" marker-end="url(#architecture-tip)"/>`;
  }));
  const boxes = [...architecture.values()].map(({ name }) => {
    const { x, y } = place.get(name);
    const box = `<rect x="${x - wide / 2}" y="${y - high / 2}" width="${wide}" height="${high}" rx="5"/>`;
    return `${box}<text x="${x}" y="${y + 5}">${path.basename(name)}</text>`;
  });
  const view = `viewBox="0 0 ${width} ${step * floors.length}" role="img" aria-label="The folders and what they use"`;
  return `<figure class="architecture-plan"><svg ${view}>
<defs><marker id="architecture-tip" viewBox="0 0 8 8" refX="6" refY="4" markerWidth="7" markerHeight="7" orient="auto">
<path d="M0 0L8 4L0 8z" class="tip"/></marker></defs>
<g class="arrows">${arrows.join('')}</g><g class="rooms">${boxes.join('')}</g></svg>
<figcaption>An arrow leads from a folder to one that it uses.
What that one uses may be used as well. Arrows lead down.</figcaption></figure>`;
}

/** What each holds, what it uses, and how large it is. */
export function architectureTable(architecture) {
  const names = ['folder', 'what it holds', 'uses', 'files', 'lines'];
  const rows = [...architecture.values()].map(r => {
    const cells = [`<code>${r.name}</code>`, escapeHtml(r.about), r.uses.join(', ') || '–', r.files, r.lines];
    return `<tr>${labelled(cells.map(c => `<td>${c}</td>`), ['', '', ...names.slice(2)])}</tr>`;
  });
  const head = `<tr>${names.map(n => `<th>${n}</th>`).join('')}</tr>`;
  return boxed(`<table class="programs stacked architecture"><thead>${head}</thead><tbody>${rows.join('')}</tbody></table>`);
}
