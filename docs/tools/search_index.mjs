// Full-text index of the book, as a plain script: works from file:// where fetch() does not. The words, the
// index and the questions are those of docs/theme/search.js.
//
//   search_index.mjs --html BOOK                     writes the index
//   search_index.mjs --html BOOK --questions FILE    asks what FILE says, and fails where another place comes first
import fs from 'node:fs';
import path from 'node:path';
import vm from 'node:vm';
import { Errors, label, options, readRegistry, walk } from './lib.mjs';

const opt = options({ html: '', questions: '' });
const engine = new URL('../theme/search.js', import.meta.url);
const sandbox = { module: { exports: {} } };
vm.runInNewContext(fs.readFileSync(engine, 'utf8'), sandbox);
const search = sandbox.module.exports;
const target = path.join(opt.html, 'search_index.js');

if (opt.questions) {
  const window = {}, errors = new Errors();
  vm.runInNewContext(fs.readFileSync(target, 'utf8'), { window });
  const book = search.open(window.bookSearch);
  const rows = fs.readFileSync(opt.questions, 'utf8').split('\n').map((l, i) => [l, i + 1]).filter(([l]) => l.trim() && !l.startsWith('#'));
  let asked = 0;
  for (const [row, line] of rows) {
    const [question, first, where] = row.split('\t'), hits = book.ask(question, 5);
    // A book of a few pages lacks what the question is after.
    const [page, anchor] = (where ?? '').split('#'), file = path.join(opt.html, page);
    if (page && (!fs.existsSync(file) || (anchor && !fs.readFileSync(file, 'utf8').includes(`id="${anchor}"`)))) continue;
    ++asked;
    if (!hits.length || !new RegExp(first).test(hits[0].address))
      errors.add(opt.questions, line, `"${question}" brings ${hits[0]?.address ?? 'nothing'} first, not ${first}; then ${hits.slice(1).map(h => h.address).join(', ') || 'nothing'}`);
  }
  errors.exitIfAny('search');
  console.log(`book: ${asked} of ${rows.length} questions asked, each with the place that it is after first`);
  process.exit(0);
}

// Formulas are left out: nobody types them, and their text is not what one sees. Their Greek letters can be
// found.
const plain = html => html.replace(/<!--f-->[\s\S]*?<!--\/f-->/g, ' ')
  .replace(/<(script|style|svg|noscript)\b[\s\S]*?<\/\1>/g, ' ').replace(/<[^>]+>/g, ' ')
  .replace(/&lt;/g, '<').replace(/&gt;/g, '>').replace(/&quot;/g, '"').replace(/&nbsp;/g, ' ')
  .replace(/&#(\d+);/g, (_, code) => String.fromCodePoint(Number(code))).replace(/&amp;/g, '&').replace(/\s+/g, ' ').trim();
const letters = /\\(?:var)?(alpha|beta|gamma|delta|epsilon|zeta|eta|theta|iota|kappa|lambda|mu|nu|xi|pi|rho|sigma|tau|phi|chi|psi|omega)(?![a-z])/gi;
const greek = html => [...new Set([...html.matchAll(/<span class="katex" role="img" aria-label="([^"]*)"/g)].flatMap(f => [...f[1].matchAll(letters)].map(m => m[1].toLowerCase())))].join(' ');

/// The end of the element that begins at a place, by counting its kind.
function elementEnd(html, from, tag) {
  const each = new RegExp(`<(/?)${tag}\\b`, 'g');
  each.lastIndex = from;
  for (let depth = 0, m; (m = each.exec(html));) if ((depth += m[1] ? -1 : 1) === 0) return html.indexOf('>', m.index) + 1;
  return html.length;
}

const kinds = ['page', 'section', 'definition', 'statement', 'result', 'exercise', 'erratum', 'ledger', 'member', 'type', 'file', 'kernel', 'key'];
const skip = /_source\.html$|-members\.html$|^(files|annotated|classes|functions|globals|namespacemembers|hierarchy|pages|dir_|concepts|namespaces|modules|graph_legend|doxygen_crawl|viewer_)/;
const pageKind = name => (/^kernel_/.test(name) ? 'kernel' : /^(struct|class|concept|union|group__)/.test(name) ? 'type' : /^namespace|_8[hc]pp|_8dox/.test(name) ? 'file' : 'page');
const boxKind = id => ({ def: 'definition', res: 'result' })[id.split('_')[0]] ?? 'statement';
/// 3.10 of eq_3_10, 3.2.3 of thm_3_2_3.
const numberOf = id => /^(?:eq|thm|prop|lem|cor|def|rem|claim)_(\d+(?:_\d+)*(?:[a-z](?=_|$))?)(?:_|$)/.exec(id)?.[1].replace(/_/g, '.') ?? '';
/// A class by its name, without its namespaces and Doxygen's words.
const nameOf = title => title.replace(/<[^<>]*>/g, '').replace(/ (?:Class|Struct|Concept|Union|File|Namespace)?(?: Template)? ?(?:Reference|Module)$/, '').replace(/^(?:\w+::)+(?=\w)/, '').trim() || title;

const registry = process.env.BOOK_REGISTRY || 'proofs_checks/registry.tsv';
const subjects = new Map(fs.existsSync(registry) ? readRegistry(registry).map(s => [s.id, s.title || s.subject]) : []);
/// What a display shows, in words.
const display = id => [label(id), subjects.get(id)].filter(Boolean).join(' ');

const pages = [], entries = [];
for (const file of walk(opt.html).filter(f => f.endsWith('.html'))) {
  const name = path.basename(file);
  if (skip.test(name)) continue;
  const html = fs.readFileSync(file, 'utf8');
  const title = plain(/<title>([\s\S]*?)<\/title>/.exec(html)?.[1] ?? name).replace(/ · actio$/, '');
  let body = /<div class="contents">([\s\S]*?)<!-- contents -->/.exec(html)?.[1] ?? '';
  const whole = pageKind(name), page = pages.push([name, title]) - 1;
  // What the lists of an interface page say is said where it is documented.
  if (whole === 'type' || whole === 'file') body = body.replace(/<table class="memberdecls">[\s\S]*?<\/table>/g, ' ').replace(/<div class="toc"[\s\S]*?<\/div>/, ' ');
  body = body.replace(/<div class="toc"[\s\S]*?<\/ul>\s*<\/div>/, ' ');
  const add = (kind, anchor, heading, part, number = '') => {
    const text = plain(part);
    if (text.length > 1) entries.push({ page, anchor, kind, title: heading, text, more: `${greek(part)} ${/^[ag][0-9a-f]{32}|^autotoc|^>/.test(anchor) ? '' : anchor}`, number });
  };
  // A box with its own text; a section, a documented member, a row, an exercise up to the next one.
  const boxes = [...body.matchAll(/<div class="(statement [^"]*|beside(?: equation)?)" id="([^"]+)">/g)].map(m => ({ at: m.index, end: elementEnd(body, m.index, 'div'), id: m[2], beside: m[1].startsWith('beside') }));
  const marks = [...body.matchAll(/<h[1-5][^>]*>\s*<a class="anchor" id="([^"]+)"><\/a>([\s\S]*?)<\/h[1-5]>|<a id="([^"]+)" name="[^"]*"><\/a>\s*<h2 class="memtitle">([\s\S]*?)<\/h2>|<tr data-verdict="[^"]*" data-strength="[^"]*"><td class="id">(?:<a href="([^"]*)">|<a class="target" id="([^"]+)"><\/a>)([\s\S]*?)<\/td>|<article class="erratum" id="([^"]+)">|<div class="exercise" id="([^"]+)"><div class="exercise-head">([\s\S]*?)<\/a>|<a class="target" id="(proof_[^"]+)"><\/a>|<a class="anchor" id="(key_[^"]+)"><\/a>/g)]
    .map(m => m[1] !== undefined ? { at: m.index, kind: whole === 'kernel' ? 'kernel' : /^key_/.test(m[1]) ? 'key' : 'section', anchor: m[1], title: plain(m[2]) }
      : m[3] !== undefined ? { at: m.index, kind: 'member', anchor: m[3], title: plain(m[4]).replace('◆', '').trim() }
      : m[5] !== undefined ? { at: m.index, kind: 'ledger', anchor: m[5].startsWith('#') ? m[5].slice(1) : `>${m[5]}`, title: plain(m[7]) }
      : m[6] !== undefined ? { at: m.index, kind: 'ledger', anchor: m[6], title: plain(m[7]), number: numberOf(m[6]) }
      : m[8] !== undefined ? { at: m.index, kind: 'erratum', anchor: m[8], title: `Erratum ${label(m[8].replace(/^erratum_/, ''))}`, number: numberOf(m[8].replace(/^erratum_/, '')) }
      : m[9] !== undefined ? { at: m.index, kind: 'exercise', anchor: m[9], title: plain(m[10]) }
      : m[11] !== undefined ? { at: m.index, kind: 'kernel', anchor: m[11], title: m[11].replace(/^proof_/, '') }
      : { at: m.index, kind: 'key', anchor: m[12], title: m[12].replace(/^key_/, '').replace('_', '.') });
  for (const b of boxes) {
    const part = body.slice(b.at, b.end), head = /<a class="here"[^>]*>([\s\S]*?)<\/a>/.exec(part)?.[1];
    const title_ = head && !b.beside ? plain(head).replace(/^Definition /, boxKind(b.id) === 'definition' ? '' : 'Definition ') : display(b.id);
    add(boxKind(b.id), b.id, title_, part, numberOf(b.id));
  }
  // The text between, without the boxes.
  const without = (from, to) => {
    let out = '', at = from;
    for (const b of boxes) if (b.at >= at && b.at < to) { out += body.slice(at, b.at); at = Math.min(to, b.end); }
    return out + body.slice(Math.min(at, to), to);
  };
  let from = 0, here = { kind: whole, anchor: '', title: whole === 'type' || whole === 'file' ? nameOf(title) : title };
  for (const m of [...marks, null]) {
    add(here.kind, here.anchor, here.title, without(from, m ? m.at : body.length), here.number);
    if (m) { from = m.at; here = m; }
  }
}
const licence = path.join(opt.html, 'LICENSE.txt');
if (fs.existsSync(licence)) entries.push({ page: pages.push(['LICENSE.txt', 'Licence']) - 1, anchor: '', kind: 'page', title: 'Licence', text: fs.readFileSync(licence, 'utf8').replace(/\s+/g, ' '), more: '', number: '' });

const index = search.build(entries);
const shown = entries.map(e => {
  const row = [e.page, e.anchor, kinds.indexOf(e.kind), e.title, e.text.slice(0, 110)];
  if (e.number) row.push(e.number);
  return row;
});
fs.writeFileSync(target, `window.bookSearch=${JSON.stringify({ kinds, pages, entries: shown, terms: index.terms, lists: index.lists })};\n`);
console.log(`book: ${entries.length} places to find, index of ${Math.round(fs.statSync(target).size / 1024)} kB`);
