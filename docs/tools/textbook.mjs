// What makes a page a textbook: definitions, proofs, exercises, drawings, programs told step by step, lines
// to try. The commands are told in docs/WRITING.md; expand.mjs calls them.
import fs from 'node:fs';
import path from 'node:path';
import { badge, escapeHtml, label, prose } from './lib.mjs';
import { verdictNote, verdictOf } from './ledger.mjs';
import { drawn } from './drawings.mjs';
import { claimList, inlineSvg } from './programs.mjs';

/// The chapter of a program and its folder: ch03_orbit_kept -> chapters/ch03_discrete_reduction.
export function chapterFolder(root, chapter) {
  const all = path.join(root, 'chapters');
  const name = fs.existsSync(all) && fs.readdirSync(all).find(d => d.startsWith(`${chapter}_`));
  return name ? path.join('chapters', name) : null;
}

/// Headers of the chapters that a program includes: beside it, or beside all chapters.
export function localHeaders(root, src) {
  const text = fs.readFileSync(path.join(root, src.path), 'utf8');
  return [...text.matchAll(/^#include "([\w.]+\.hpp)"/gm)].map(m => m[1]).map(name => {
    const beside = path.join(path.dirname(src.path), name), shared = path.join('chapters', name);
    const file = [beside, shared].find(f => fs.existsSync(path.join(root, f)));
    return file && { path: file, name, lines: fs.readFileSync(path.join(root, file), 'utf8').split('\n').length - 1 };
  }).filter(Boolean);
}

/// The lines of a program that belong to a numbered comment, up to the next one; `main` is the last.
export function stepLines(lines, step) {
  const start = lines.findIndex(l => step === 'main' ? /^int main\(/.test(l) : new RegExp(`^\\s*// ${step}\\. `).test(l));
  if (start < 0) return null;
  let end = start + 1;
  while (end < lines.length && !/^\s*\/\/ \d+\. |^int main\(/.test(lines[end])) ++end;
  // A comment directly above `main` belongs to it.
  while (end > start && /^\s*$|^\/\//.test(lines[end - 1])) --end;
  const part = lines.slice(start, end), margin = Math.min(...part.filter(l => l.trim()).map(l => /^ */.exec(l)[0].length));
  return { first: start + 1, lines: part.map(l => l.slice(margin)) };
}

/// The body of a snippet in try_it.cpp, without the marks of other snippets, and the headers above it.
export function snippetOf(text, name) {
  const lines = text.split('\n'), start = lines.findIndex(l => l.startsWith(`TRY_IT(${name})`));
  if (start < 0) return null;
  const end = lines.findIndex((l, i) => i > start && l.startsWith('}'));
  const body = lines.slice(start + 1, end).filter(l => !/^\s*\/\/ \[\w+\]$/.test(l)).map(l => l.replace(/^  /, ''));
  const above = lines.slice(0, start).filter(l => /^#include|^using /.test(l) && !l.includes('"book/try_it.hpp"'));
  return { first: start + 1, body, program: [...above, '', 'int main() {', ...body.map(l => (l ? `  ${l}` : l)), '}', ''].join('\n') };
}

/// The commands of one page. `page` has: p, line(), errors, block, emit, open, heading, known, caption, ids.
export function textbookBlocks(book, page) {
  const { p, errors, block, emit, open } = page;
  const error = text => { errors.add(p.file, page.line(), text); };
  const split = (arg, n) => { const c = arg.split(','); return [...c.slice(0, n - 1), c.slice(n - 1).join(',')].map(s => s.trim()); };
  const box = (kind, id, head, tools, classes) => {
    open.push({ kind, id, line: page.line() });
    block(`<div class="statement ${classes}" id="${id}"><div class="statement-head">${page.heading(id, head)}${tools}</div><div class="statement-body">`, [id]);
  };
  const close = (kind, html) => {
    const top = open.pop();
    if (top?.kind !== kind) { error(`\\end${kind} without \\${kind}`); return null; }
    block(html(top));
    return top;
  };
  const ownId = (id, prefix, title) => {
    if (!new RegExp(`^${prefix}_[a-z][a-z0-9_]*$`).test(id)) return error(`"${id}": an id of this kind is ${prefix}_ and words`), false;
    if (book.byId.has(id)) return error(`${id} is a statement of the thesis: use \\statement`), false;
    if (book.ownIds.has(id)) return error(`${id} stands at ${book.ownIds.get(id).where} already`), false;
    if (!title) return error(`${id} has no title`), false;
    return true;
  };
  const report = name => {
    if (!book.programs) return null;
    const found = book.programs.get(name);
    if (!found) error(`no report of program ${name}`);
    return found ?? undefined;
  };
  const number = `${p.number}.`;
  p.counts ??= { proofs: 0, definitions: 0, results: 0, ideas: 0, exercises: 0, hints: 0, solutions: 0, code: 0, tries: 0, equations: new Set() };
  const counts = p.counts;

  // A folded part of an exercise, which ends where the next one begins.
  const unfolding = (command, title) => {
    const top = open.at(-1);
    if (top?.kind !== 'exercise') return error(`\\${command} without \\exercise`);
    block(`${top.fold ? '</details>' : ''}<details class="hint"><summary>${title}</summary>`);
    top.fold = true;
  };

  return {
    definition(arg) {
      const [id, title] = split(arg, 2);
      if (!ownId(id, 'def', title)) return;
      ++counts.definitions;
      book.ownIds.set(id, { where: `${p.file}:${page.line()}`, title: title[0].toLowerCase() + title.slice(1) });
      box('definition', id, `<span class="statement-number">Definition</span> ${escapeHtml(title)}`, '', 'statement-definition');
    },
    enddefinition() { close('definition', () => '</div></div>'); },
    result(arg) {
      const [id, word, title] = split(arg, 3), known = word.startsWith('known '), kind = word.replace(/^known /, '');
      if (!/^(Theorem|Proposition|Lemma|Corollary|Observation)$/.test(kind)) return error(`\\result{id,Theorem,Title}: "${kind}" is no kind of result, nor is it "known Theorem"`);
      if (!ownId(id, 'res', title)) return;
      if (!known) ++counts.results;
      p.lastNamed = id;
      if (kind !== 'Observation') (p.toProve ??= []).push({ id, line: page.line() });
      book.ownIds.set(id, { where: `${p.file}:${page.line()}`, title: `${kind} (${title})` });
      box('result', id, `<span class="statement-number">${kind}</span> ${escapeHtml(title)}`, `<span class="statement-tools">${known ? '<span class="own-result known" title="not of the thesis; the text says whose it is">known</span>' : '<span class="own-result" title="a result of this project, not of the thesis">this project</span>'}</span>`, 'statement-result');
    },
    endresult() { close('result', () => '</div></div>'); },
    proof(arg) {
      ++counts.proofs;
      const id = book.byId.has(arg) ? arg : '';
      // Without a name it proves the last statement above it.
      (book.proved ??= new Set()).add(id || (book.ownIds.has(arg) ? arg : p.lastNamed) || '');
      open.push({ kind: 'proof', id: '', line: page.line() });
      block(`<div class="proof"><div class="proof-head">${id ? `Proof of ${label(id)}` : book.ownIds.has(arg) ? `Proof of the ${book.ownIds.get(arg).title}` : arg ? prose(arg) : 'Proof'}</div>`);
    },
    endproof() { close('proof', () => '<div class="qed" title="which was to be shown">∎</div></div>'); },
    equation(id) {
      if (!page.known(id)) return;
      open.push({ kind: 'equation', id, line: page.line() });
      const anchors = page.anchorHere(id, 'equation');
      const within = open.some(o => o.kind === 'statement' && o.id === id);
      block(`<div class="beside equation"${anchors.length ? ` id="${id}"` : ''}><div class="beside-formula">${within ? '' : `<div class="beside-head">${page.heading(id, label(id))}${badge(verdictOf(book, id))}</div>`}`, anchors);
    },
    endequation() { close('equation', top => `</div></div>${open.some(o => o.id === top.id) ? '' : verdictNote(book, top.id)}`); },
    printed(id) {
      if (!page.known(id)) return;
      open.push({ kind: 'printed', id, line: page.line() });
      block(`<div class="printed"><div class="printed-head">as printed, <a href="@ref:${['corrected', 'convention'].includes(verdictOf(book, id)) ? 'erratum_' : ''}${id}">${label(id)}</a></div>`);
    },
    endprinted() { close('printed', () => '</div>'); },

    exercise(arg) {
      if (arg && arg !== 'code') return error('\\exercise or \\exercise{code}');
      ++counts.exercises;
      if (arg) ++counts.code;
      const id = `exercise_${p.number.toLowerCase()}_${counts.exercises}`;
      open.push({ kind: 'exercise', id, line: page.line() });
      block(`<div class="exercise" id="${id}"><div class="exercise-head">${page.heading(id, `Exercise ${number}${counts.exercises}`)}${arg ? '<span class="exercise-kind">changes code</span>' : ''}</div>`, [id]);
    },
    hint() { ++counts.hints; unfolding('hint', 'Hint'); },
    solution() { ++counts.solutions; unfolding('solution', 'Solution'); },
    endexercise() {
      close('exercise', top => `${top.fold ? '</details>' : ''}</div>`);
    },

    tryit(arg) {
      const [chapter, name] = split(arg, 2), folder = chapterFolder(book.root, chapter);
      const file = folder && path.join(folder, 'try_it.cpp');
      if (!file || !fs.existsSync(path.join(book.root, file))) return error(`there is no try_it.cpp of ${chapter}`);
      const snippet = snippetOf(fs.readFileSync(path.join(book.root, file), 'utf8'), name);
      if (!snippet) return error(`${file} has no TRY_IT(${name})`);
      ++counts.tries;
      const ran = report(`${chapter}_try_it`), said = ran?.snippets?.find(s => s.name === name);
      if (ran && !said) return error(`${chapter}_try_it did not run ${name}: build and run it again`);
      block(`<div class="tryit"><div class="tryit-head"><span>Try it</span><button type="button" class="copy" data-copy="${escapeHtml(snippet.program)}" title="with its headers and a main; compile it with: g++ -std=c++20 -O2 -I src -I chapters -I /usr/include/eigen3">copy as a program</button>${book.sourceLink(file, snippet.first, `${escapeHtml(file)}:${snippet.first}`)}</div>`);
      emit(['```cpp', ...snippet.body, '```'].join('\n'));
      block(`${said ? `<pre class="output">${escapeHtml(said.said.trimEnd())}</pre>` : '<p class="notrun">not run in this build</p>'}</div>`);
    },
    step(arg) {
      const [name, step] = split(arg, 2), src = book.programSource(name);
      if (!src) return error(`program ${name} has no source under chapters/`);
      const part = stepLines(fs.readFileSync(path.join(book.root, src.path), 'utf8').split('\n'), step);
      if (!part) return error(`${src.path} has no comment "// ${step}. ..."`);
      // The comment at its head is set as text, the lines below it as code.
      const head = part.lines.findIndex(l => !/^\s*\/\//.test(l)), said = part.lines.slice(0, Math.max(0, head)).map(l => l.replace(/^\s*\/\/ ?/, '')).join(' ');
      const words = said ? `<p class="step-head">${prose(said).replace(/^(\d+)\. /, '<b>Step $1.</b> ')}</p>` : '';
      block(`<div class="step">${words}`);
      emit(['```cpp', ...part.lines.slice(Math.max(0, head)), '```'].join('\n'));
      block(`<div class="snippet-source">${book.sourceLink(src.path, part.first, `${escapeHtml(src.path)}:${part.first}`)}</div></div>`);
    },
    prints(arg) {
      const [name, from, to] = split(arg, 3), ran = report(name);
      if (ran === undefined) return;
      if (!ran || ran.output === null) return block('<p><span class="notrun">not run in this build</span></p>');
      const lines = ran.output.split('\n'), begins = words => l => l.trim().startsWith(words);
      const first = lines.findIndex(begins(from));
      if (first < 0) return error(`${name} prints no line that starts with "${from}"`);
      const more = to ? lines.slice(first).findIndex(begins(to)) : 0;
      if (more < 0) return error(`${name} prints no line that starts with "${to}" after that one`);
      block(`<pre class="output prints">${escapeHtml(lines.slice(first, first + more + 1).join('\n'))}</pre>`);
    },
    claims(name) {
      const ran = report(name);
      if (ran === undefined) return;
      block(ran ? claimList(ran) : '<p><span class="notrun">not run in this build</span></p>');
    },

    idea(arg) {
      const [name, title] = split(arg, 2), file = path.join(book.root, 'docs/drawings', `${name}.svg`);
      if (!fs.existsSync(file)) return error(`there is no drawing docs/drawings/${name}.svg`);
      ++counts.ideas;
      try {
        block(inlineSvg(drawn(fs.readFileSync(file, 'utf8')), page.caption(title), `idea${page.unique()}`).replace('class="picture', 'class="picture idea'));
      } catch (e) { error(`docs/drawings/${name}.svg: ${e.message}`); }
    },
    animation(arg) {
      const [kind, program, title] = split(arg, 3), ran = report(program);
      if (ran === undefined) return;
      const motion = ran?.motions?.find(m => m.name === kind);
      if (ran && !motion) return error(`${program} reports no motion "${kind}"`);
      if (!ran) return block('<p><span class="notrun">not run in this build</span></p>');
      const figures = Object.fromEntries((ran.figures ?? []).map(f => [f.name, f.value]));
      const data = JSON.stringify({ header: motion.header, rows: motion.rows, figures }).replaceAll('<', '\\u003c');
      ++counts.ideas;
      block(`<figure class="picture animation"><canvas data-animation="${escapeHtml(kind)}" width="640" height="360" role="img" aria-label="${escapeHtml(title)}"></canvas><script type="application/json">${data}</script><figcaption>${prose(title)} <button type="button" class="play">stop</button></figcaption></figure>`);
    },
  };
}
