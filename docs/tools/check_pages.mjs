// check_pages.mjs BOOK [--whole]: what every page of the book has for every reader: an entry of the tree
// that the tree finds, the way past it, a table of contents for narrow screens, one heading of the first rank,
// a name for each picture; and what none has: more bytes or elements than a browser opens at once, a path of
// the machine that made it, a backslash in a caption; in a whole book, the place of a figure that was not
// measured, and, where there is a browser, text that makes a page of prose scroll sideways.
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import vm from 'node:vm';
import {fileURLToPath, pathToFileURL} from 'node:url';
import {Errors, walk} from './lib.mjs';
import {limits, nodesOf} from './members.mjs';

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
// What a page has, with what it unfolds: that stands in a script beside it.
const unfolded = page => {
  const file = path.join(root, `more_${page.replace(/\.html$/, '.js')}`);
  if (!fs.existsSync(file)) return '';
  let data;
  vm.runInNewContext(fs.readFileSync(file, 'utf8'), { window: { bookMore: found => { data = found; } } });
  return Object.values(data.parts).join('\n').replace(/\u0001\d+\u0002/g, ' ');
};
for (const page of walk(root).filter(f => f.endsWith('.html')).map(f => path.relative(root, f))) {
  const html = fs.readFileSync(path.join(root, page), 'utf8'), bytes = Buffer.byteLength(html), nodes = nodesOf(html);
  if (bytes > limits.bytes) errors.add(page, 1, `${bytes} bytes, where a page has ${limits.bytes} at most`);
  if (nodes > limits.nodes) errors.add(page, 1, `${nodes} elements, where a page has ${limits.nodes} at most`);
}
for (const page of names) {
  const html = fs.readFileSync(path.join(root, page), 'utf8');
  if (!html.includes('<div id="doc-content"')) continue;
  const titles = (html.match(/<h1\b/g) ?? []).length;
  if (titles > 1) errors.add(page, 1, `${titles} headings of the first rank; the title is the only one`);
  // A browser shows nothing of the page behind a block that ends outside of its title.
  const [title] = /<h1 class="title">[\s\S]*?<\/h1>/.exec(html) ?? [''];
  if ((title.match(/<div\b/g) ?? []).length !== (title.match(/<\/div>/g) ?? []).length) errors.add(page, 1, 'a block begins in the title and does not end there');
  for (const picture of html.matchAll(/<(svg|canvas)\b[^>]*role="img"[^>]*>[\s\S]*?<\/\1>/g))
    if (!/<title>[^<]|^<\w+\b[^>]*aria-label="[^"]/.test(picture[0])) errors.add(page, 1, `a picture without a name: ${picture[0].slice(0, 80)}`);
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
  const empty = whole ? [...(html + unfolded(page)).matchAll(/<(\w+) class="(?:[^"]* )?(?:unmeasured|notrun)(?: [^"]*)?"[^>]*?(?: title="([^"]*)")?>([^<]*)/g)] : [];
  if (empty.length)
    errors.add(
      page, 1,
      `${empty.length} empty place${empty.length > 1 ? 's' : ''}, the first: ${empty[0][2] ?? empty[0][3]}; ` +
        './run bench, ./run stress, ./run test --all and ./run proofs measure what is missing, ./run record keeps it for all builds');
}
errors.exitIfAny('pages');

// ---- In a browser: no page of prose scrolls sideways, on a telephone or on a desk.
const widths = [390, 1400];
const isProse = f => !/^(viewer_|namespace|struct|class|concept|union|group__|files|annotated|functions|globals|hierarchy|modules|dir_)|_8[ch]pp|_8dox|_source/.test(f);
async function sideways() {
  const driver = new URL('../../tests/stress/browser/chromium.mjs', import.meta.url);
  if (!fs.existsSync(driver)) return null;
  const { Browser, findChromium } = await import(driver);
  const program = findChromium();
  if (!program) return null;
  const browser = await Browser.start(program);
  try {
    const pages = names.filter(isProse), count = pages.length;
    await Promise.all([1, 2].map(async () => {
      const tab = await browser.tab();
      for (let page; (page = pages.shift());) {
        await tab.look(widths[1], 900, 'light');
        await tab.open(pathToFileURL(path.resolve(root, page)).href);
        // Nothing may hide what is too wide.
        await tab.run(`document.head.insertAdjacentHTML('beforeend', '<style>section.part { content-visibility: visible !important; } div.contents { overflow: visible !important; }</style>')`);
        for (const width of widths) {
          await tab.look(width, 900, 'light');
          await tab.run('window.bookFit && window.bookFit()');
          const beyond = await tab.run(`(() => { const over = Math.max(document.scrollingElement.scrollWidth, document.body.scrollWidth) - document.scrollingElement.clientWidth;
            if (over < 2) return null;
            const limit = document.scrollingElement.clientWidth + 1, boxed = e => { for (let up = e.parentElement; up && up.id !== 'doc-content'; up = up.parentElement) if (getComputedStyle(up).overflowX !== 'visible') return true; return false; },
              seen = [...document.querySelectorAll('#doc-content *')].filter(e => e.getBoundingClientRect().right > limit && !boxed(e));
            return over + ' px: ' + seen.filter(e => !seen.some(x => x !== e && e.contains(x))).slice(0, 3).map(e => (e.closest('[id]') || e).id + ' ' + e.tagName.toLowerCase() + '.' + e.getAttribute('class') + ' ' + e.textContent.trim().slice(0, 30)).join('; '); })()`);
          if (beyond) errors.add(page, 1, `scrolls sideways at ${width} columns, by ${beyond}`);
        }
      }
    }));
    return count;
  } finally { await browser.close(); }
}
// ---- What readers ask for is found: the search of the book, with the questions of questions.tsv.
if (whole && fs.existsSync(path.join(root, 'search_index.js'))) {
  const tool = file => fileURLToPath(new URL(file, import.meta.url));
  const asked = spawnSync(process.execPath, [tool('./search_index.mjs'), '--html', root, '--questions', tool('./questions.tsv')], { stdio: 'inherit' });
  if (asked.status !== 0) process.exit(1);
}
const opened = whole ? await sideways() : null;
errors.exitIfAny('pages');
if (opened) console.log(`book: ${opened} pages of prose, none of which scrolls sideways at ${widths.join(' or ')} columns`);
else if (whole) console.log('book: no browser here: whether a page scrolls sideways was not looked at');
console.log(`book: ${names.length} pages, each in the tree where it is listed, with ways to the others, of ${limits.bytes / 1e6} MB and ${limits.nodes} elements at most`);
