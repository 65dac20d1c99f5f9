// Finishes the pages that Doxygen wrote: puts the generated parts in place of their tokens, resolves links to
// sources and statements, and sets every formula with KaTeX. A formula that does not parse, or a link that
// leads nowhere, fails the book.
import fs from 'node:fs';
import path from 'node:path';
import { createRequire } from 'node:module';
import { Errors, escapeHtml, label, labelled, options, readRegistry, shortLabel, walk } from './lib.mjs';
import { knowStatements, smallPrint } from './small_print.mjs';
import { leanFormula, leanRules } from './lean_formula.mjs';
import { nodesOf, settleMembers } from './members.mjs';
import { readingOrder, sortTreeIndex, withNavigation } from './navigation.mjs';

const opt = options({ root: '.', html: '', pages: '', registry: '' });
const katexHome = '/usr/share/javascript/katex';
const katex = createRequire(import.meta.url)(path.join(katexHome, 'katex.js'));
const macros = JSON.parse(fs.readFileSync(new URL('../macros.json', import.meta.url), 'utf8'));
const { items, copies = [], titles = {} } = JSON.parse(fs.readFileSync(path.join(opt.pages, 'items.json'), 'utf8'));
const registry = readRegistry(opt.registry || path.join(opt.root, 'proofs_checks/registry.tsv'));
const ids = new Set(registry.map(s => s.id));
knowStatements(ids);
const errors = new Errors();

const unescape = s => s.replace(/&lt;/g, '<').replace(/&gt;/g, '>').replace(/&quot;/g, '"').replace(/&#39;/g, "'").replace(/&#160;|&nbsp;/g, ' ').replace(/&amp;/g, '&');

// ---- Where things are

const files = walk(opt.html).filter(f => f.endsWith('.html'));
const text = new Map(files.map(f => [path.basename(f), fs.readFileSync(f, 'utf8')]));

// Functions stand on the pages of their headers.
const led = settleMembers(text);

// Source page of a file, by the path in its title.
const sourcePage = new Map();
for (const [name, html] of text) { const m = /<title>(\S+) Source File/.exec(html); if (m) sourcePage.set(m[1], name); }

const tokens = /<p\b[^>]*>(?:\s*<a class="anchor" id="[^"]*"><\/a>)*\s*(BOOKITEM\d{5}X)\s*<\/p>|(?:<a class="anchor" id="[^"]*"><\/a>\s*)*(BOOKITEM\d{5}X)/g;
for (const [name, html] of text)
  if (html.includes('BOOKITEM')) text.set(name, html.replace(tokens, (_, block, bare) => items[block ?? bare]));

const anchorPage = new Map();
for (const [name, html] of text)
  if (!name.endsWith('_source.html')) for (const m of html.matchAll(/\bid="((?:eq|thm|prop|lem|cor|def|res|rem|claim|bridge|exercise|program|erratum|ledger|proof)_[A-Za-z0-9_]+)"/g)) anchorPage.set(m[1], name);

function resolve(page, kind, target) {
  if (kind === 'source') {
    const [, file, line] = /^(.*):(\d+)$/.exec(target);
    const to = sourcePage.get(file) ?? sourcePage.get(file.replace(/^src\//, ''));
    if (!to) { errors.add(page, 1, `no source page for ${file}`); return '#'; }
    return `${to}#l${line.padStart(5, '0')}`;
  }
  if (target.startsWith('page:')) return `${target.slice(5)}.html`;
  const to = anchorPage.get(target);
  if (!to) { errors.add(page, 1, `no place for ${target}`); return '#'; }
  return to === page ? `#${target}` : `${to}#${target}`;
}

// ---- Formulas

const cache = new Map();
let formulas = 0;
function formula(page, tex, displayMode) {
  tex = unescape(tex).trim();
  const key = (displayMode ? 'D' : 'I') + tex;
  ++formulas;
  if (!cache.has(key)) {
    try {
      cache.set(key, '<!--f-->' + leanFormula(katex.renderToString(tex, { displayMode, output: 'html', macros: { ...macros }, throwOnError: true, strict: c => c === 'newLineInDisplayMode' || c === 'commentAtEnd' ? 'ignore' : 'error' }), tex) + '<!--/f-->');
    } catch (e) {
      errors.add(page, 1, `formula does not parse: ${tex.replace(/\s+/g, ' ')}\n    ${e.message.replace(/\s+/g, ' ')}`);
      cache.set(key, '');
    }
  }
  return cache.get(key);
}
/// A line may break beside a formula: a bracket before it and what closes it go into its parts, or a comma begins the next line.
function held(open, html, close) {
  const mark = text => text && `<span class="after">${text}</span>`;
  return html.replace(/<span class="base"[^>]*>/, all => all + mark(open)).replace(/(?=<\/span><\/span><!--\/f-->$)/, mark(close));
}
/// Code keeps its text; elsewhere \[..\], \(..\) and environments become mathematics.
function setFormulas(page, html) {
  return html.split(/(<div class="fragment">[\s\S]*?<\/div><!-- fragment -->|<(?:pre|code|script|style|textarea)\b[\s\S]*?<\/(?:pre|code|script|style|textarea)>|<svg\b[\s\S]*?<\/svg>)/)
    .map((part, i) => i % 2 ? part : part
      .replace(/<p class="formulaDsp">\s*([\s\S]*?)\s*<\/p>/g, (_, tex) => `<div class="formula">${formula(page, tex.replace(/^\\\[|\\\]$/g, ''), true)}</div>`)
      .replace(/\\\[([\s\S]*?)\\\]/g, (_, tex) => formula(page, tex, true))
      // Doxygen puts a space between a bracket and a formula.
      .replace(/(?:(?<=[\s>])([([])\s*)?\\\(([\s\S]*?)\\\)([.,;:)\]?!]*)/g, (_, open = '', tex, close) => held(open, formula(page, tex, false), close)))
    .join('');
}

// The index of implementations in the order of the thesis: statement, subject, declarations.
if (text.has('implements.html')) {
  const html = text.get('implements.html');
  const places = new Map();
  for (const m of html.matchAll(/<dt>([\s\S]*?)<\/dt>\s*<dd>([\s\S]*?)<\/dd>/g)) {
    const declaration = /<a class="el" href="[^"]*">[^<]*<\/a>/.exec(m[1])?.[0].replace('>actio::', '>');
    let anchor = [...m[2].matchAll(/<a class="anchor" id="[^"]*"><\/a>/g)].map(a => a[0]).join('');
    for (const s of m[2].matchAll(/<a class="el" href="[^"]*">((?:eq|thm|prop|lem|cor|def|rem|claim|bridge)_\w+)<\/a>/g)) {
      places.set(s[1], [...(places.get(s[1]) ?? []), anchor + declaration]);
      anchor = '';
    }
  }
  const known = [...registry, ...[...places.keys()].filter(id => !ids.has(id)).map(id => ({ id, subject: '' }))];
  const rows = known.filter(s => places.has(s.id)).map(s => `<tr>${labelled([`<td class="id"><a href="@ref:${s.id}">${shortLabel(s.id)}</a></td>`, `<td>${smallPrint(s.title || s.subject)}</td>`, `<td>${places.get(s.id).join('<br/>')}</td>`], ['', '', 'declaration'])}</tr>`);
  const table = `<table class="programs stacked"><thead><tr><th>statement</th><th>subject</th><th>declaration</th></tr></thead><tbody>${rows.join('')}</tbody></table>`;
  text.set('implements.html', html.replace(/<dl class="reflist">[\s\S]*<\/dl>/, table));
}

for (const [name, original] of text) {
  let html = original;
  html = html.replace(/href="@(source|ref):([^"]*)"/g, (_, kind, target) => `href="${resolve(name, kind, target)}"`);
  // A reference to a statement reads as the thesis numbers it.
  html = html.replace(/(<a class="el" href="[^"]*">)((?:eq|thm|prop|lem|cor|def|rem|claim|bridge)_\w+)(<\/a>)/g, (all, a, id, b) => ids.has(id) ? a + escapeHtml(label(id)) + b : all);
  html = html.replace(/(<a class="el" href="[^"]*">)((?:def|res)_\w+)(<\/a>)/g, (all, a, id, b) => id in titles ? a + escapeHtml(titles[id]) + b : all);
  // In sources and listings the mark of a snippet leads to its statement.
  html = html.replace(/(<span class="comment">\/\/ \[)(\w+)(\]<\/span>)/g, (all, a, id, b) => anchorPage.has(id) ? `${a}<a class="statement-tag" href="${anchorPage.get(id)}#${id}">${id}</a>${b}` : all);
  // Doxygen announces a list of nested classes even where all of them are private.
  html = html.replace(/<a href="#nested-classes">[^<]*<\/a>(?: &#124;)?/g, a => /id="nested-classes"/.test(html) ? a : '');
  html = setFormulas(name, html);
  // The space that kept a year from beginning a line has done its work (book.sh).
  if (name === 'citelist.html') html = html.replace(/\s*&#160;(?=\d{4}\.)/g, ' ');
  // A snippet starts at its own margin.
  html = html.replace(/<div class="fragment">([\s\S]*?)<\/div><!-- fragment -->/g, (all, body) => name.endsWith('_source.html') ? all : `<div class="fragment">${dedent(body)}</div><!-- fragment -->`);
  if (html.includes('BOOKITEM')) errors.add(name, 1, 'a generated part was not put in place (a command inside a title or a code block?)');
  if (html !== original) text.set(name, html);
}
function dedent(body) {
  const lines = body.match(/<div class="line">/g) ? body.split(/(?=<div class="line">)/) : [body];
  const margin = Math.min(...lines.filter(l => l.replace(/<[^>]*>/g, '').trim()).map(l => /^<div class="line">(?:<a[^>]*><\/a>)?( *)/.exec(l)?.[1].length ?? 0));
  return margin > 0 && Number.isFinite(margin) ? lines.map(l => l.replace(new RegExp(`^(<div class="line">(?:<a[^>]*></a>)?) {${margin}}`), '$1')).join('') : body;
}

// The tree leads to the members where they are documented now.
for (const f of walk(opt.html).filter(f => f.endsWith('.js') && !/navtreeindex\d+\.js$/.test(f))) {
  const script = fs.readFileSync(f, 'utf8'), now = script.replace(/"([\w.-]+\.html#(?:[ag]|gg)[0-9a-f]{32}[0-9a-z]*)"/g, (_, address) => `"${led(address)}"`);
  if (now !== script) fs.writeFileSync(f, now);
}
sortTreeIndex(opt.html, led);
const order = readingOrder(opt.html);
for (const [name, html] of text) text.set(name, withNavigation(html, order, name));

errors.exitIfAny('finish');

// Tables that unfold are in a script beside the page, which loads it when the first of them is opened: each formula once, each table
// with marks for its formulas.
const more = [];
for (const [name, original] of text) {
  const formulasOf = new Map(), parts = {};
  const html = original.replace(/<!--more (\w+)-->([\s\S]*?)<!--\/more-->/g, (_, id, body) => {
    parts[id] = body.replace(/<!--f-->([\s\S]*?)<!--\/f-->/g, (all, f) => {
      if (!formulasOf.has(f)) formulasOf.set(f, formulasOf.size);
      return `\u0001${formulasOf.get(f)}\u0002`;
    });
    return '';
  });
  if (!Object.keys(parts).length) continue;
  text.set(name, html);
  more.push([`more_${name.replace(/\.html$/, '.js')}`, `window.bookMore(${JSON.stringify({ formulas: [...formulasOf.keys()], parts })});\n`]);
}

// A page has one heading of the first rank, its title; the sections of Doxygen are a rank below.
for (const [name, html] of text)
  text.set(name, html.replace(/<div class="title">([\s\S]*?)((?:<div class="ingroups">[\s\S]*?<\/div>)?)\s*<\/div>/, '<h1 class="title">$1</h1>$2')
    .replace(/<div class="toc"><h3>Table of Contents<\/h3>/, '<div class="toc" role="navigation" aria-label="On this page"><div class="toc-head" aria-hidden="true">On this page</div>')
    .replace(/<h([1-5])>(<a class="anchor" id="[^"]*"><\/a>[\s\S]*?)<\/h\1>/g, (_, rank, body) => `<h${Number(rank) + 1}>${body}</h${Number(rank) + 1}>`));

// The sections of a long page are elements of their own, which a browser lays out when they come near.
for (const [name, html] of text)
  if (nodesOf(html) > 4000 && !/_source\.html$|^(?:namespace|struct|class|group__)|_8[hc]pp/.test(name))
    text.set(name, html.replace(/(<div class="textblock">)([\s\S]*)(<\/div><\/div><!-- (?:PageDoc|contents) -->)/, (_, before, body, after) => before + inSections(body) + after));
function inSections(body) {
  const whole = part => ['div', 'details', 'table', 'ul', 'ol', 'dl', 'section', 'p', 'figure'].every(t => (part.match(new RegExp(`<${t}\\b`, 'g')) ?? []).length === (part.match(new RegExp(`</${t}>`, 'g')) ?? []).length);
  const parts = [];
  for (const piece of body.split(/(?=<h[23]><a class="anchor")/))
    if (parts.length && !whole(parts.at(-1))) parts[parts.length - 1] += piece;
    else parts.push(piece);
  const height = part => Math.round(part.replace(/<!--f-->[\s\S]*?<!--\/f-->/g, 'x').replace(/<(svg|pre)\b[\s\S]*?<\/\1>/g, ' ').replace(/<[^>]*>/g, '').length / 3.2 + 90 * (part.match(/<div class="(?:formula|beside|statement )/g) ?? []).length + 380 * (part.match(/<figure/g) ?? []).length);
  return parts.map((part, i) => (i && whole(part) ? `<section class="part" style="contain-intrinsic-size:auto ${Math.max(200, height(part))}px">${part}</section>` : part)).join('');
}

for (const [name, script] of more) fs.writeFileSync(path.join(opt.html, name), script);
for (const [name, html] of text) fs.writeFileSync(path.join(opt.html, name), html);
if (fs.existsSync(path.join(opt.root, 'LICENSE'))) fs.copyFileSync(path.join(opt.root, 'LICENSE'), path.join(opt.html, 'LICENSE.txt'));
for (const { from, to } of copies) fs.copyFileSync(from, path.join(opt.html, to));
fs.mkdirSync(path.join(opt.html, 'katex/fonts'), { recursive: true });
// woff2 alone: every browser that opens the book reads it.
fs.writeFileSync(path.join(opt.html, 'katex/katex.min.css'),
  fs.readFileSync(path.join(katexHome, 'katex.min.css'), 'utf8').replace(/,\s*url\([^)]*\.(?:woff|ttf)\)\s*format\([^)]*\)/g, '') + leanRules);
for (const f of fs.readdirSync(path.join(katexHome, 'fonts')).filter(f => f.endsWith('.woff2')))
  fs.copyFileSync(path.join(katexHome, 'fonts', f), path.join(opt.html, 'katex/fonts', f));
console.log(`book: ${files.length} pages, ${formulas} formulas (${cache.size} different)`);
