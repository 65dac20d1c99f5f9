// check_pages.mjs BOOK [--whole]: what every page of the book has for every reader: an entry of the tree
// that the tree finds, the way past it, a table of contents for narrow screens; and what none has: a path of
// the machine that made it, a backslash in a caption; in a whole book, the place of a figure that was not
// measured.
import fs from 'node:fs';
import path from 'node:path';
import vm from 'node:vm';

import {Errors, walk} from './lib.mjs';

const root = process.argv[2], whole = process.argv.includes('--whole');
const errors = new Errors();
const names = walk(root)
                .filter(f => f.endsWith('.html') && !path.basename(f).startsWith('viewer_'))
                .map(f => path.relative(root, f));

// ---- The tree looks an address up in the last part whose first address is not after it, as navtree.js does.
const evaluate = (file, variable) =>
  vm.runInNewContext(`${fs.readFileSync(path.join(root, file), 'utf8')};${variable}`);
const starts = evaluate('navtreedata.js', 'NAVTREEINDEX');
starts.forEach((start, i) => {
  if (i && !(starts[i - 1] < start))
    errors.add(
      'navtreedata.js', 1,
      `part ${i} of the index begins with ${start}, which is not after ${starts[i - 1]}`);
});
const parts = starts.map(
  (_, i) =>
    (fs.existsSync(path.join(root, `navtreeindex${i}.js`)) ?
       evaluate(`navtreeindex${i}.js`, `NAVTREEINDEX${i}`) :
       {}));
function found(page, anchor) {
  let i = -1;
  while (starts[i + 1] <= page + anchor) ++i;
  return i >= 0 && Boolean(parts[i][page + anchor] ?? parts[i][page]);
}
const listed = new Set(parts.flatMap(part => Object.keys(part).map(address => address.replace(/#.*$/, ''))));
for (const page of names)
  for (const anchor of ['', '#a', '#eq_3_10', '#zz'])
    if (listed.has(page) && !found(page, anchor)) {
      errors.add(page, 1, `the tree does not find ${page}${anchor}`);
      break;
    }

// ---- Every page
const chapters = names.filter(name => /^ch\d\d\.html$/.test(name));
const text = html => html.replace(/<!--f-->[\s\S]*?<!--\/f-->/g, ' ')
                       .replace(/<(script|style)\b[\s\S]*?<\/\1>/g, ' ')
                       .replace(/<[^>]*>/g, ' ');
for (const page of names) {
  const html = fs.readFileSync(path.join(root, page), 'utf8');
  if (!html.includes('<div id="doc-content"')) continue;
  if (
    !html.includes('class="skip-link" href="#doc-content"') ||
    !html.includes('<div id="doc-content" role="main" tabindex="-1">'))
    errors.add(page, 1, 'no link past the tree to the text');
  const menu = /<nav id="book-menu"[\s\S]*?<\/nav>/.exec(html)?.[0] ?? '';
  const missing = chapters.filter(chapter => !menu.includes(`href="${chapter}"`));
  if (!menu || missing.length)
    errors.add(page, 1, `the table of contents lacks ${missing.join(', ') || 'everything'}`);
  if (chapters.includes(page) && !/<nav class="page-turns"[^>]*>.*<a rel="/.test(html))
    errors.add(page, 1, 'no link to the next page or the one before');
  const place = /(?:^|\s)\/\S*\/report\/\S*/.exec(text(html));
  if (place && !page.includes('_source'))
    errors.add(page, 1, `a path of the machine that made the book: ${place[0].trim()}`);
  for (const caption of html.matchAll(
         /<figcaption>([\s\S]*?)<\/figcaption>|<div class="caption">([\s\S]*?)<\/div>/g))
    if (/\\/.test(text(caption[1] ?? caption[2])))
      errors.add(page, 1, `a caption with a backslash: ${text(caption[1] ?? caption[2]).trim()}`);
  // A figure comes from this build or from the release; where neither has it, somebody must measure and
  // record it.
  const empty = whole ? [...html.matchAll(/<(\w+) class="(?:[^"]* )?(?:unmeasured|notrun)(?: [^"]*)?"[^>]*?(?: title="([^"]*)")?>([^<]*)/g)] : [];
  if (empty.length)
    errors.add(
      page, 1,
      `${empty.length} empty place${empty.length > 1 ? 's' : ''}, the first: ${empty[0][2] ?? empty[0][3]}; ` +
        './run bench, ./run stress, ./run test --all and ./run proofs measure what is missing, ./run record keeps it for all builds');
}
errors.exitIfAny('pages');
console.log(`book: ${names.length} pages, each in the tree where it is listed, with ways to the others`);
