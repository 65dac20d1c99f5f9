// Expands the book's own commands in its pages (docs/pages, chapters/*/*.md) from the reports of the
// build.
//
// A command becomes a token that Doxygen carries through unchanged; finish.mjs puts the token's HTML in its
// place. So tables, boxes and pictures are never parsed as Markdown, and a box may hold anything a page may
// hold. The vocabulary is in docs/WRITING.md. Errors name file and line of the page as written.
import fs from 'node:fs';
import path from 'node:path';
import { Errors, badge, escapeHtml, label, optionalPrograms, options, readRegistry, readReports, shortLabel, verdictText, walk } from './lib.mjs';
import { chapterLedger, errata, evidence, ledger, ledgerCounts, ledgerStrength, slipCounts, verdictOf, verdictNote } from './ledger.mjs';
import { pythonCard, readScenes, sceneCard, scenePage, scenePicture, sceneTable, systemPage, viewerFrame, viewerOf } from './scenes.mjs';
import { knowStatements } from './small_print.mjs';
import { localHeaders, textbookBlocks } from './textbook.mjs';
import { coverage } from './coverage.mjs';
import { architecturePlan, architectureTable, readArchitecture } from './architecture.mjs';
import { keysPage, readKeys } from './keys.mjs';
import * as pythonReference from './python_reference.mjs';
import { beyondTable, codeAt, codeBlock, kernelCounts, kernelPage, kernelTable, proofFiles, readKernel, seal } from './kernel.mjs';
import { benchmarkTable, inlineSvg, programCard, programTable, reportTable, targetBadge, targetReached, targetsOf } from './programs.mjs';
import { legend, measured, originClass, originText, releasedChecks, releasedPrograms } from './release.mjs';

const opt = options({ root: '.', build: 'build', registry: '', strict: false });
const at = (...p) => path.join(opt.root, ...p);
const errors = new Errors();
const registryFile = opt.registry || at('proofs_checks/registry.tsv');
if (!fs.existsSync(registryFile)) { console.error(`${registryFile}:1: the registry of statements is missing`); process.exit(1); }
const registry = readRegistry(registryFile);
knowStatements(registry.map(s => s.id));
const reports = readReports(opt.build);
if (opt.strict && !reports.statements) errors.add(path.join(opt.build, 'report/statements.json'), 1, 'missing: run the checks and merge the ledger');
if (opt.strict && !reports.programs) errors.add(path.join(opt.build, 'report/programs'), 1, 'missing: run the chapter programs');
const book = {
  root: opt.root, build: opt.build, registry, byId: new Map(registry.map(s => [s.id, s])), ...reports,
  places: new Map(),      // statement id -> true once a page holds its box
  programPlaces: new Set(),
  ownIds: new Map(),      // id of a definition or result of our own -> where, title
  ...readScenes(opt.root, opt.build),
  release: { programs: releasedPrograms(opt.root), checks: releasedChecks(opt.root) },
  kernel: readKernel(opt.root, opt.build),
};
if (opt.strict && !book.scenes && fs.existsSync(at('data/scenes'))) errors.add(path.join(opt.build, 'report/scenes'), 1, 'missing: run the scenes');

// ---- Pages

const pages = walk(at('docs/pages')).filter(f => f.endsWith('.md')).map(file => ({ file, out: path.basename(file), chapter: null }));
for (const dir of fs.existsSync(at('chapters')) ? fs.readdirSync(at('chapters')).sort() : []) {
  const file = at('chapters', dir, 'chapter.md');
  const chapter = /^ch(\d+)_/.exec(dir);
  if (!chapter) continue;
  if (fs.existsSync(file)) pages.push({ file, out: `21_${dir}.md`, chapter: Number(chapter[1]), number: String(Number(chapter[1])), id: `ch${chapter[1]}` });
  // Chapters of our own stand after the one that they grow from.
  for (const own of fs.readdirSync(at('chapters', dir)).sort()) {
    const letter = /^ch\d+([a-z])_\w+\.md$/.exec(own)?.[1];
    if (letter) pages.push({ file: at('chapters', dir, own), out: `21_${dir}_${letter}.md`, chapter: Number(chapter[1]), number: `${Number(chapter[1])}${letter.toUpperCase()}`, id: `ch${chapter[1]}${letter}` });
  }
}
// One page with every key of a scene, where the command has told them.
const keys = readKeys(opt.build);
// Pages of systems and of scenes lead to it; what an earlier version left in the reports waits for it.
if (!keys) book.systems = book.scenes = null;
if (opt.strict && !keys && fs.existsSync(at('data/scenes'))) errors.add(path.join(opt.build, 'report/scenes/keys.json'), 1, 'missing: run the scenes');
if (keys) pages.push({ file: path.join(opt.build, 'report/scenes/keys.json'), out: '23_a_keys.md', chapter: null, text: keysPage(keys) });
// One page for each system that scenes are made of, after the page that tells how to run them.
for (const system of book.systems ?? []) pages.push({ file: path.join(opt.build, `report/scenes/systems.json:${system.name}`), out: `23_system_${system.name}.md`, chapter: null, text: systemPage(book, system) });
for (const scene of book.scenes?.values() ?? []) pages.push({ file: scene.file, out: `23_x_scene_${scene.name}.md`, chapter: null, text: scenePage(scene) });
// One page for each source of proofs, in the order in which they are read.
proofFiles(opt.root).forEach((file, i) => pages.push({ file: at('proofs_checks/kernel', file), out: `32_${String(i).padStart(2, '0')}_kernel_${file.replace(/\.v$/, '')}.md`, chapter: null, text: kernelPage(opt.root, file) }));
for (const p of pages) {
  p.lines = (p.text ?? fs.readFileSync(p.file, 'utf8')).split('\n');
  // Where no scene was run there are no pages of scenes to lead to.
  if (!book.scenes) p.lines = p.lines.map(line => line.replace(/\\ref scenefile_\w+ "([^"]*)"/g, '$1'));
  const title = p.lines.findIndex(l => /^# /.test(l));
  p.title = title < 0 ? '' : p.lines[title].replace(/^# /, '').replace(/\s*\{#.*$/, '');
  if (p.chapter === null || title < 0) continue;
  if (!p.lines[title].includes(`{#${p.id}}`)) errors.add(p.file, title + 1, `the page of this chapter is titled "# ... {#${p.id}}"`);
  p.lines[title] = p.lines[title].replace(/^# (\d+\S*\s+)?(· )?/, `# ${p.number} · `);
}
book.chapters = pages.filter(p => p.chapter !== null);

// What the package of Python says of itself, once a page asks, and the names that pages show.
let python = null;
const pythonShown = new Map();

// Text and line of each source that a page may show.
const sources = new Map();
function source(name) {
  if (!sources.has(name)) {
    const file = ['src/actio', 'src', 'chapters', 'proofs_checks'].map(d => at(d, name)).find(f => fs.existsSync(f));
    sources.set(name, file ? { path: path.relative(opt.root, file), lines: fs.readFileSync(file, 'utf8').split('\n') } : null);
  }
  return sources.get(name);
}
book.sourceLink = (file, line, text) => `<a class="source" href="@source:${escapeHtml(file)}:${line}">${text}</a>`;
book.checkSource = id => {
  const list = at('proofs_checks', 'statements.json');
  book.checkFiles ??= new Map((fs.existsSync(list) ? JSON.parse(fs.readFileSync(list, 'utf8')) : []).map(s => [s.id, s.source]));
  const file = book.checkFiles.get(id);
  if (!file || !fs.existsSync(at(file))) return null;
  const line = fs.readFileSync(at(file), 'utf8').split('\n').findIndex(l => l.includes(`(${id},`));
  return { path: file, line: line + 1 || 1 };
};
book.programSource = name => {
  const m = /^(ch\d+)_(.+)$/.exec(name);
  const dir = m && fs.existsSync(at('chapters')) && fs.readdirSync(at('chapters')).find(d => d.startsWith(m[1] + '_'));
  const file = dir && path.join('chapters', dir, `${m[2]}.cpp`);
  return file && fs.existsSync(at(file)) ? { path: file, include: path.join(dir, `${m[2]}.cpp`), lines: fs.readFileSync(at(file), 'utf8').split('\n').length - 1 } : null;
};

// ---- Tokens

const items = {};
let count = 0;
// Tables of benchmarks, after which the page says what the colours of its figures mean.
const legends = [];
const token = html => { const name = `BOOKITEM${String(++count).padStart(5, '0')}X`; items[name] = html; return name; };

// ---- First pass: where each statement lives. Its box, else its first formula, holds the permanent anchor.

const inCode = lines => {
  let fence = false;
  return lines.map(l => { const mark = /^\s*(```|~~~)/.test(l) || /[\\@](code|verbatim|endcode|endverbatim)\b/.test(l); if (mark) fence = !fence; return fence || mark; });
};
const homes = new Map();   // id -> "file:line:command"
for (const rank of ['statement', 'beside', 'equation', 'evidence'])
  for (const p of pages) {
    p.code ??= inCode(p.lines);
    p.lines.forEach((line, i) => {
      const m = !p.code[i] && new RegExp(`^\\s*\\\\${rank}\\{\\s*([A-Za-z0-9_]+)`).exec(line);
      if (!m) return;
      const home = homes.get(m[1]);
      if (rank === 'statement' && home?.rank === 'statement') errors.add(p.file, i + 1, `${m[1]} has its box already, at ${home.file}:${home.line}`);
      if (!home) homes.set(m[1], { rank, file: p.file, line: i + 1 });
    });
  }
// Statements without a box live in the list of their chapter, where there is one, else in the ledger.
const listed = new Map();
for (const p of pages) p.lines.forEach((l, i) => {
  const m = !p.code[i] && /^\s*\\verified\{\s*(\d+)\s*\}/.exec(l);
  if (!m) return;
  const ids = registry.filter(s => Number(s.chapter) === Number(m[1]) && !homes.has(s.id)).map(s => s.id);
  listed.set(`${p.file}:${i + 1}`, ids);
  for (const id of ids) homes.set(id, { rank: 'verified', file: p.file, line: i + 1 });
});
for (const id of homes.keys()) book.places.set(id, true);
book.boxes = new Set([...homes].filter(([, h]) => h.rank === 'statement').map(([id]) => id));
for (const p of pages) p.lines.forEach((l, i) => { const m = !p.code[i] && /^\s*\\program\{\s*([^},]+)/.exec(l); if (m) book.programPlaces.add(m[1].trim()); });

// ---- Second pass: expand.

const split = (text, parts) => {
  const cells = text.split(',');
  return [...cells.slice(0, parts - 1), cells.slice(parts - 1).join(',')].map(s => s.trim()).filter((s, i) => s !== '' || i === 0);
};
/// Commas of a caption need no backslash; one that stands there would be printed.
const caption = (p, line, text) => {
  if (text !== undefined && /\\[,.;:]/.test(text.replace(/\$[^$]*\$/g, ''))) errors.add(p.file, line, 'a caption holds a backslash before a comma: commas need none');
  return text;
};
const notRun = what => `<span class="notrun">${what} not run</span>`;
const optional = program => program.split('_')[0] in optionalPrograms;
// A figure that waits for a run of its program is a dash; the page says so once, and each table or picture
// where it would stand.
const notMeasured = program => `<span class="unmeasured" title="waits for a run of ${escapeHtml(program)}">–</span>`;
const notDrawn = (program, what) => `<p class="notrun">${what} waits for a run of <code>${escapeHtml(program)}</code></p>`;

// A program that not every build runs has its source, or its name is wrong; a report of this build, or one of
// the release, or it is not measured yet. A figure that an older or a short report lacks is that of the
// release.
book.optionalSource = program => {
  const [, kind, stem] = /^([a-z]+)_(.+)$/.exec(program) ?? [];
  const file = optionalPrograms[kind] && `${optionalPrograms[kind]}/${stem}.cpp`;
  return file && fs.existsSync(at(file)) ? file : null;
};
function lookupOptional(p, line, list, what, program, name) {
  const file = book.optionalSource(program);
  if (!file) { errors.add(p.file, line, `program ${program} has no source in ${Object.values(optionalPrograms).join(' or ')}`); return undefined; }
  const report = book.optional.get(program);
  for (const from of [report, book.release.programs.get(program)]) {
    const found = (from?.[list] ?? []).find(x => x.name === name);
    if (!found) continue;
    (p.shown ??= new Set()).add(from);
    return { ...found, report: from };
  }
  if (!report || report.short || report.written < fs.statSync(at(file)).mtimeMs) return null;
  errors.add(p.file, line, `program ${program} reports no ${what} "${name}" (it has: ${(report[list] ?? []).map(x => x.name).join(', ') || 'none'})`);
  return undefined;
}

function lookup(p, line, list, what, program, name) {
  if (optional(program)) return lookupOptional(p, line, list, what, program, name);
  if (!book.programs) return null;
  const report = book.programs.get(program);
  if (!report) { errors.add(p.file, line, `no report of program ${program} (known: ${[...book.programs.keys()].join(', ')})`); return undefined; }
  const found = (report[list] ?? []).find(x => x.name === name);
  if (!found) errors.add(p.file, line, `program ${program} reports no ${what} "${name}" (it has: ${(report[list] ?? []).map(x => x.name).join(', ') || 'none'})`);
  return found && { ...found, report };
}
const known = (p, line, id) => {
  if (book.byId.has(id)) return true;
  errors.add(p.file, line, `unknown statement ${id}`);
  return false;
};

const inline = {
  figure(p, line, arg) {
    const [program, name] = split(arg, 2);
    const f = lookup(p, line, 'figures', 'figure', program, name);
    if (f === null) return optional(program) ? notMeasured(program) : notRun('figure');
    return f ? `<span class="${`figure ${originClass(f.report)}`.trim()}" title="${escapeHtml([`${program}: ${name} = ${f.value}`, originText(f.report)].filter(Boolean).join('; '))}">${figureText(f)}</span>` : '';
  },
  verdict(p, line, id) {
    if (id in verdictText) return badge(id);
    if (!known(p, line, id)) return '';
    return badge(verdictOf(book, id));
  },
};
/// A row of targets: the bound, what was measured, and whether it was reached, in three cells.
function targetCells(p, line, { program, name, side, bound }) {
  if (!/^at (most|least)$/.test(side) || !Number.isFinite(bound)) errors.add(p.file, line, '\\target{program,figure,at most,0.6}, or at least');
  const f = lookup(p, line, 'figures', 'figure', program, name);
  return [token(`${figureText({ text: String(bound) })} ${escapeHtml(side)}`), token(inline.figure(p, line, `${program},${name}`)), token(f ? targetBadge(targetReached(f.value, side, bound), f.report) : '')].join(' | ');
}
const figureText = f => {
  const m = /^([-+]?\d+(?:\.\d+)?)[eE]([-+]?\d+)(.*)$/.exec(f.text ?? '');
  if (m) return `${m[1].replace('-', '−')}·10<sup>${String(Number(m[2])).replace('-', '−')}</sup>${escapeHtml(m[3])}`;
  return escapeHtml(f.text ?? String(f.value));
};

for (const p of pages) {
  const out = [], map = [];
  let line = 0;
  const emit = text => { for (const l of text.split('\n')) { out.push(l); map.push(line); } };
  const block = (html, anchors = []) => emit(`\n${anchors.map(a => `\\anchor ${a} `).join('')}${token(html)}\n`);
  const open = [];
  const anchorHome = (id, rank) => { const h = homes.get(id); return h.rank === rank && h.file === p.file; };
  const anchorHere = (id, rank) => { const h = homes.get(id); return h.rank === rank && h.file === p.file && h.line === line ? [id] : []; };
  const heading = (id, text) => `<a class="here" href="#${id}" title="permanent link">${text}</a>`;

  // The number the thesis gives it, unless the title says it already.
  const boxTitle = (id, title) => {
    const number = shortLabel(id);
    if (!title) return escapeHtml(label(id));
    return title.includes(number.replace(/^\(|\)$/g, '')) ? escapeHtml(title) : `<span class="statement-number">${number}</span> ${escapeHtml(title)}`;
  };

  const blocks = {
    statement(arg) {
      const [id, title] = split(arg, 2);
      if (!known(p, line, id)) return;
      open.push({ kind: 'statement', id, line });
      p.lastNamed = id;
      block(`<div class="statement statement-${book.byId.get(id).kind}" id="${id}"><div class="statement-head">${heading(id, boxTitle(id, title))}<span class="statement-tools">${seal(book, id)}${badge(verdictOf(book, id))}</span></div><div class="statement-body">`, anchorHere(id, 'statement'));
    },
    endstatement() {
      const top = open.pop();
      if (top?.kind !== 'statement') return errors.add(p.file, line, '\\endstatement without \\statement');
      block(`${verdictNote(book, top.id)}</div></div>`);
    },
    beside(id) {
      if (!known(p, line, id)) return;
      const within = open.some(o => o.kind === 'statement' && o.id === id);
      const anchors = anchorHere(id, 'beside');
      open.push({ kind: 'beside', id, line });
      const mark = within ? '' : `<div class="beside-head">${heading(id, label(id))}${badge(verdictOf(book, id))}</div>`;
      block(`<div class="beside"${anchors.length ? ` id="${id}"` : ''}><div class="beside-formula">${mark}`, anchors);
    },
    asCode() {
      const top = open.at(-1);
      if (top?.kind !== 'beside' || top.code) return errors.add(p.file, line, '\\asCode without \\beside');
      top.code = true;
      block('</div><div class="beside-code">');
    },
    endbeside() {
      const top = open.pop();
      if (top?.kind !== 'beside') return errors.add(p.file, line, '\\endbeside without \\beside');
      if (!top.code) errors.add(p.file, line, '\\beside has no \\asCode');
      // Outside a statement's box, what was wrong with it stands below.
      const alone = !open.some(o => o.kind === 'statement') && anchorHome(top.id, 'beside');
      block(`</div></div>${alone ? verdictNote(book, top.id) : ''}`);
    },
    evidence(id) {
      if (!known(p, line, id)) return;
      const record = book.statements?.get(id);
      if (book.statements && !record) errors.add(p.file, line, `the ledger has no record of ${id}`);
      const anchors = anchorHere(id, 'evidence');
      block(evidence(book, id, anchors.length > 0), anchors);
    },
    table(arg) {
      const [program, name, title] = split(arg, 3);
      const t = lookup(p, line, 'tables', 'table', program, name);
      if (t === null) block(optional(program) ? notDrawn(program, 'This table') : `<p>${notRun(`table ${escapeHtml(name)} of ${escapeHtml(program)}`)}</p>`);
      else if (t) block(reportTable(t, caption(p, line, title), t.report));
    },
    picture(arg) {
      const [program, name, title] = split(arg, 3);
      const pic = lookup(p, line, 'pictures', 'picture', program, name);
      if (pic === null) return block(optional(program) ? notDrawn(program, 'This picture') : `<p>${notRun(`picture ${escapeHtml(name)} of ${escapeHtml(program)}`)}</p>`);
      if (!pic) return;
      const file = path.join(pic.report.folder, pic.file);
      if (!fs.existsSync(file)) return errors.add(p.file, line, `picture file ${pic.file} is missing`);
      block(inlineSvg(fs.readFileSync(file, 'utf8'), caption(p, line, title) ?? pic.caption, `pic${count}`, pic.report));
    },
    scene(name) {
      if (!book.scenes) return block(`<p>${notRun(`scene ${escapeHtml(name)}`)}</p>`);
      const scene = book.scenes.get(name);
      if (!scene) return errors.add(p.file, line, `no scene ${name} has been run (there are: ${[...book.scenes.keys()].join(', ')})`);
      block(sceneCard(scene, `scene_${name}`), [`scene_${name}`]);
    },
    scenefile(name) { block(sceneCard(book.scenes.get(name))); },
    sceneviewer(arg) {
      const [name, ...rest] = split(arg, 3), stage = rest.includes('stage'), [moment] = rest.filter(x => x !== 'stage'), scene = book.scenes?.get(name), viewer = scene && viewerOf(scene);
      if (!book.scenes) return block(`<p>${notRun(`scene ${escapeHtml(name)}`)}</p>`);
      if (!viewer) return errors.add(p.file, line, `scene ${name} has left no page plots/index.html`);
      block(viewerFrame(scene, viewer.to, moment, stage));
    },
    scenepicture(arg) {
      const [name, picture, title] = split(arg, 3);
      if (!book.scenes) return block(`<p>${notRun(`scene ${escapeHtml(name)}`)}</p>`);
      const html = book.scenes.has(name) ? scenePicture(book.scenes.get(name), picture, caption(p, line, title), `pic${count}`) : null;
      if (!html) return errors.add(p.file, line, `scene ${name} has drawn no picture ${picture}`);
      block(html);
    },
    python(name) {
      const file = at('data/scenes', `${name}.py`), said = path.join(opt.build, 'report/python', `${name}.txt`);
      if (!fs.existsSync(file)) return errors.add(p.file, line, `there is no data/scenes/${name}.py`);
      block(pythonCard(`data/scenes/${name}.py`, fs.readFileSync(file, 'utf8'), fs.existsSync(said) ? fs.readFileSync(said, 'utf8') : null));
    },
    architectureplan(which) { block(architecturePlan(readArchitecture(opt.root, errors, which || 'library'))); },
    architecture(which) { block(architectureTable(readArchitecture(opt.root, errors, which || 'library'))); },
    scenes() {
      block(book.scenes ? sceneTable(book.scenes) : `<p>${notRun('the scenes')}</p>`);
      if (book.scenes) emit(`Each has a page with its motion and its text: ${[...book.scenes.keys()].map(name => `\\subpage scenefile_${name} "${name}"`).join(', ')}.\n`);
    },
    systems() {
      if (!book.systems) return block(`<p>${notRun('the command')}</p>`);
      for (const s of book.systems) emit(`- \\subpage system_${s.name} "${s.name}": ${s.title}. ${s.meaning}`);
      emit('');
    },
    program(arg) {
      const [name] = split(arg, 1);
      const src = book.programSource(name);
      if (!src) return errors.add(p.file, line, `program ${name} has no source under chapters/`);
      const report = book.programs?.get(name);
      if (book.programs && !report) return errors.add(p.file, line, `no report of program ${name}`);
      if (report && report.output === null && opt.strict) errors.add(p.file, line, `the output of ${name} was not kept`);
      const headers = localHeaders(opt.root, src), card = programCard(book, name, report, src, headers);
      block(card.before, [`program_${name}`]);
      emit(`\\include ${src.include}`);
      for (const header of headers) {
        block(`</details><details><summary>${escapeHtml(header.name)}, ${header.lines} lines</summary>`);
        emit(`\\include ${path.relative('chapters', header.path)}`);
      }
      block(card.after);
    },
    snippet(arg, raw) {
      const [file, tag] = arg.trim().split(/\s+/);
      const src = source(file);
      emit(raw);
      if (!src) return errors.add(p.file, line, `no file ${file} for this snippet`);
      const where = src.lines.findIndex(l => l.includes(`[${tag}]`));
      if (where < 0) return errors.add(p.file, line, `${src.path} has no tag [${tag}]`);
      block(`<div class="snippet-source">${book.sourceLink(src.path, where + 2, escapeHtml(src.path.replace(/^src\//, '')) + `:${where + 2}`)}</div>`);
    },
    ledger() {
      const unplaced = registry.filter(s => !book.places.has(s.id)).map(s => s.id);
      block(ledger(book), unplaced);
    },
    scenekeys() {
      if (!keys) return block(`<p>${notRun('the command')}</p>`);
      emit('\\subpage scene_keys "Every key of a scene" has them all, with type, default, unit and an example.');
      emit('');
    },
    kernelcode(place) { const [file, from] = place.split(':'); block(codeBlock(codeAt(opt.root, file, Number(from)), new Set(registry.map(s => s.id)))); },
    kerneltable() { block(book.kernel?.rows.length ? kernelTable(book) : ''); },
    kernelbeyond() { block(book.kernel?.rows.length ? beyondTable(book) : ''); },
    kernelcounts() { block(book.kernel ? kernelCounts(book) : ''); },
    kernelfiles() { for (const file of proofFiles(opt.root)) emit(`- \\subpage kernel_${file.replace(/\.v$/, '')}`); emit(''); },
    pythonreference(names) {
      python ??= pythonReference.readPython(opt.build);
      if (python.why) { if (opt.strict) errors.add(p.file, line, python.why); return block(`<p>${notRun('the package of Python')}</p>`); }
      const list = names.split(',').map(n => n.trim());
      if (!pythonShown.size) block(pythonReference.style);
      for (const name of list) {
        pythonShown.set(name, { p, line });
        const e = pythonReference.entry(python, name);
        if (!e) continue;
        emit(`### ${e.title} {#${e.id}}`);
        block(e.html);
      }
    },
    ledgercounts() { block(ledgerCounts(book)); },
    slipcounts() { block(slipCounts(book)); },
    ledgerstrength() { block(ledgerStrength(book)); },
    verified(chapter) {
      const list = registry.filter(s => Number(s.chapter) === Number(chapter));
      if (!list.length) return errors.add(p.file, line, `the registry has no statements of chapter ${chapter}`);
      const here = listed.get(`${p.file}:${line}`);
      block(chapterLedger(book, list, new Set(here)), here);
    },
    errata() { block(errata(book)); },
    programs(arg) { block(programTable(book, arg)); },
    benchmarks() {
      const names = walk(at('benchmarks')).filter(f => /^benchmarks\/[^/]*\.cpp$/.test(path.relative(opt.root, f))).map(f => `bench_${path.basename(f, '.cpp')}`);
      for (const name of names) { const report = measured(book, name); if (report) (p.shown ??= new Set()).add(report); }
      const missed = new Map();
      for (const t of targetsOf(p.lines)) {
        const f = lookup(p, line, 'figures', 'figure', t.program, t.name);
        if (f && !targetReached(f.value, t.side, t.bound)) missed.set(t.program, (missed.get(t.program) ?? 0) + 1);
      }
      block(benchmarkTable(book, names, missed));
      const key = token('');
      legends.push({ page: p, key });
      emit(`\n${key}\n`);
    },
    chapters(arg) {
      const list = arg.split(',').map(Number);
      for (const c of book.chapters.filter(c => list.includes(c.chapter))) emit(`- \\subpage ${c.id}`);
      emit('');
    },
  };

  Object.assign(blocks, textbookBlocks(book, { p, line: () => line, errors, block, emit, open, heading, anchorHere, known: id => known(p, line, id), caption: title => caption(p, line, title), unique: () => ++count }));

  p.lines.forEach((text, i) => {
    line = i + 1;
    if (p.code[i]) return emit(text);
    const m = /^\s*\\([A-Za-z]+)(?:\{(.*)\})?(\s.*)?$/.exec(text);
    if (m && m[1] in blocks && !(m[1] === 'snippet' && m[2])) {
      if (m[1] === 'snippet') return blocks.snippet(m[3] ?? '', text);
      if (m[3]?.trim()) errors.add(p.file, line, `\\${m[1]} stands alone on its line`);
      return blocks[m[1]]((m[2] ?? '').trim());
    }
    text = text.replace(/\\(figure|verdict)\{([^}]*)\}/g, (_, name, arg) => token(inline[name](p, line, arg.trim())));
    for (const t of targetsOf([text])) text = text.replace(/\\target\{[^}]*\}/, targetCells(p, line, t));
    // A chapter that is not there yet is named without a link.
    text = text.replace(/\\ref (ch(\d\d)([a-z]?))\b(?: "([^"]*)")?/g, (all, id, n, own, words) => book.chapters.some(c => c.id === id) ? all : words ?? `chapter ${Number(n)}${own.toUpperCase()}`);
    if (/^#{1,6} /.test(text) && /\\f[$[(]|BOOKITEM/.test(text)) errors.add(p.file, line, 'a title holds a formula or a command: the tree and the search show it as text');
    const stray = /\\(statement|endstatement|definition|enddefinition|result|endresult|proof|endproof|equation|endequation|printed|endprinted|exercise|endexercise|hint|solution|tryit|step|prints|claims|idea|animation|beside|asCode|endbeside|evidence|table|picture|program|verified|ledger|kernelcode|kerneltable|kernelbeyond|kernelcounts|kernelfiles|errata|benchmarks|architectureplan|architecture|scene|scenefile|sceneviewer|scenepicture|scenes|systems|python|pythonreference)\b(?!`)/.exec(text.replace(/`[^`]*`/g, ''));
    if (stray) errors.add(p.file, line, `\\${stray[1]} stands alone on its line`);
    // Beside its code an equation carries its number in the corner.
    if (open.at(-1)?.kind === 'beside' && !open.at(-1).code) text = text.replace(/\s*\\tag\{[^}]*\}/g, '');
    emit(text);
    if (p.chapter !== null && /^# /.test(text)) emit('\n[TOC]\n');
  });
  for (const o of open) errors.add(p.file, o.line, `\\${o.kind}{${o.id}} is not closed`);
  p.text = out.join('\n');
  p.map = map;
}
if (python && !python.why && opt.strict)
  for (const what of pythonReference.missing(python, new Set(pythonShown.keys()))) errors.add([...pythonShown.values()][0].p.file, 1, what);
coverage(book, pages, homes, errors, opt.strict);
for (const { page, key } of legends) items[key] = legend([...(page.shown ?? [])]);
errors.exitIfAny('pages');

const target = path.join(opt.build, 'book-src');
fs.rmSync(target, { recursive: true, force: true });
fs.mkdirSync(target, { recursive: true });
const maps = {};
for (const p of pages) {
  fs.writeFileSync(path.join(target, p.out), p.text);
  maps[p.out] = { file: path.relative(opt.root, p.file), lines: p.map };
}
fs.writeFileSync(path.join(target, 'items.json'), JSON.stringify({ items, maps, titles: Object.fromEntries([...book.ownIds].map(([id, o]) => [id, o.title])), copies: [...(book.scenes?.values() ?? [])].map(viewerOf).filter(Boolean) }));
