// Ways through the book: the index by which the tree finds the entry of a page, the table of contents for
// narrow screens, and links to the next page and the one before.
import fs from 'node:fs';
import path from 'node:path';
import vm from 'node:vm';

import {escapeHtml} from './lib.mjs';

/// What a script of Doxygen assigns to a variable.
const assigned = (file, variable) => vm.runInNewContext(`${fs.readFileSync(file, 'utf8')};${variable}`);
const indexFiles = dir => fs.readdirSync(dir).filter(f => /^navtreeindex\d+\.js$/.test(f));

/// Writes the index of the tree anew, in the order in which navtree.js looks: it takes the last part whose
/// first address is not after the one it seeks, and compares addresses as texts. Addresses that were led to
/// another page are sorted in with the others, and a part that begins within a page has the page itself, too,
/// since an anchor without an entry is shown as its page.
/// @param lead  the address of an entry, as it is now
export function sortTreeIndex(dir, lead = address => address) {
  const entries = new Map(), moved = new Map();
  for (const file of indexFiles(dir)) {
    for (const [address, way] of Object.entries(
           assigned(path.join(dir, file), file.replace(/^navtreeindex(\d+)\.js$/, 'NAVTREEINDEX$1')))) {
      const now = lead(address);
      (now === address ? entries : moved).set(now, way);
    }
    fs.rmSync(path.join(dir, file));
  }
  // A page's own entry goes before one that was led there.
  for (const [address, way] of moved)
    if (!entries.has(address)) entries.set(address, way);
  const addresses = [...entries.keys()].sort((a, b) => (a < b ? -1 : 1)), size = 250, starts = [];
  for (let first = 0; first < addresses.length; first += size) {
    const part = addresses.slice(first, first + size), page = part[0].replace(/#.*$/, '');
    const listed = page !== part[0] && entries.has(page) ? [page, ...part] : part;
    fs.writeFileSync(
      path.join(dir, `navtreeindex${starts.length}.js`),
      `var NAVTREEINDEX${starts.length} =\n{\n${
        listed.map(a => `${JSON.stringify(a)}:${JSON.stringify(entries.get(a))}`).join(',\n')}\n};\n`);
    starts.push(part[0]);
  }
  const data = path.join(dir, 'navtreedata.js');
  fs.writeFileSync(
    data,
    fs.readFileSync(data, 'utf8')
      .replace(
        /var NAVTREEINDEX =\s*\[[\s\S]*?\];/,
        () => `var NAVTREEINDEX =\n${JSON.stringify(starts, null, 0).replaceAll('",', '",\n')};`));
}

/// The pages of prose in the order of the tree, each with title, address and depth; the reference of the
/// interface is not among them.
export function readingOrder(dir) {
  const pages = [], reference = [];
  const children = node =>
    (typeof node[2] === 'string' ? assigned(path.join(dir, `${node[2]}.js`), node[2]) : node[2]) ?? [];
  const visit = (node, depth) => {
    const [title, address] = node;
    if (!address || address.includes('#') || pages.some(p => p.address === address)) return;
    pages.push({ title, address, depth });
    for (const child of children(node)) visit(child, depth + 1);
  };
  const interfaces = ['modules.html', 'namespaces.html', 'concepts.html', 'annotated.html', 'files.html'];
  for (const node of children(assigned(path.join(dir, 'navtreedata.js'), 'NAVTREE')[0])) {
    if (interfaces.includes(node[1]))
      reference.push({ title: node[0], address: node[1], depth: 0 });
    else
      visit(node, 0);
  }
  return { pages, reference };
}

const link = (page, here) => `<li class="depth-${page.depth}"><a href="${page.address}"${
  page.address === here ? ' aria-current="page"' : ''}>${escapeHtml(page.title)}</a></li>`;

/// The table of contents that a narrow screen has in place of the tree; it needs no script.
export const contentsMenu = ({pages, reference}, here) =>
  `<nav id="book-menu" aria-label="Contents"><details><summary>Contents</summary><ul>${
    pages.map(p => link(p, here)).join('')}</ul><ul class="reference">${
    reference.map(p => link(p, here)).join('')}</ul></details></nav>`;

/// Links at the foot of a page of prose; empty for the others.
export function pageTurns({pages}, here) {
  const at = pages.findIndex(p => p.address === here);
  if (at < 0) return '';
  const turn = (page, rel, word) =>
    (page ? `<a rel="${rel}" href="${page.address}"><span>${word}</span>${escapeHtml(page.title)}</a>` : '');
  return `<nav class="page-turns" aria-label="Next page and the one before">${
    turn(pages[at - 1], 'prev', 'Before')}${turn(pages[at + 1], 'next', 'Next')}</nav>`;
}

/// A page with its ways through the book.
export function withNavigation(html, order, here) {
  return html.replace(/<\/div><!-- top -->/, all => contentsMenu(order, here) + all)
    .replace('<div id="doc-content">', '<div id="doc-content" role="main" tabindex="-1">')
    .replace('</div><!-- contents -->', all => all + pageTurns(order, here));
}
