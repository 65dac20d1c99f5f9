// book_pages.mjs BOOK [--prose | --only NAME]: opens every page (of prose alone, or those whose names begin
// so) of the book in a browser, wide and narrow, light and dark, and holds it to what a reader expects.
// Status 1 where a page falls short, 0 otherwise, also where there is no browser: then it says so.
import fs from 'node:fs';
import path from 'node:path';
import {pathToFileURL} from 'node:url';

import {Browser, findChromium, wait} from './chromium.mjs';

const book = path.resolve(process.argv[2] ?? 'build/book'),
      only = process.argv[3] === '--only' ? process.argv[4] : null, prose = process.argv[3] === '--prose';
if (!fs.existsSync(path.join(book, 'index.html'))) {
  console.error(`${book}: there is no book; ./run book writes it`);
  process.exit(1);
}
const program = findChromium();
if (!program) {
  console.log('no Chromium here: the pages of the book are not opened (Debian: apt-get install chromium)');
  process.exit(0);
}

const inPage = fs.readFileSync(new URL('./in_page.js', import.meta.url), 'utf8');
const url = (name) =>
  pathToFileURL(path.join(book, name.replace(/#.*$/, ''))).href + (/#.*$/.exec(name)?.[0] ?? '');
const
  isViewer = (f) => /^viewer_/.test(f),
  isInterface = (f) =>
    /^(namespace|struct|class|concept|union|files|annotated|functions|globals|hierarchy|dir_)|_8[ch]pp|_8dox|_source/
      .test(f);
const all =
  fs.readdirSync(book)
    .filter((f) => f.endsWith('.html') && (!only || f.startsWith(only)) && !(prose && isInterface(f)))
    .sort();
const widths = {
  wide: [1400, 900],
  narrow: [420, 900]
};

const faults = new Map();
let checks = 0;
function fault(kind, page, text) {
  if (!faults.has(kind)) faults.set(kind, []);
  faults.get(kind).push(`${page}: ${text}`);
}
const complaints = (tab, page) => {
  for (const text of tab.said.splice(0)) fault('console', page, text);
};

async function look(tab, page, width) {
  for (const colours of ['light', 'dark']) {
    await tab.colours(colours);
    ++checks;
    for (const [kind, text] of await tab.run(inPage)) fault(kind, `${page} (${width}, ${colours})`, text);
  }
  complaints(tab, `${page} (${width})`);
}
/// The tree is filled by scripts that are loaded one after the other, and its branches slide open: it is
/// ready when nothing has changed for a while.
const ready =
  `new Promise((done) => { let same = 0, last = -1, turns = 0; const timer = setInterval(() => { const now = document.querySelectorAll('#nav-tree .item').length;
  same = now === last && !(window.jQuery && jQuery(':animated').length) ? same + 1 : 0; last = now;
  if (same > (innerWidth < 768 ? 1 : now > 1 ? 4 : 16) || ++turns > 200) { clearInterval(timer); done(true); } }, 25); })`;

async function everyPage(tab, pages) {
  for (let page; (page = pages.shift());)
    for (const [width, size] of Object.entries(widths)) {
      try {
        await tab.look(...size, 'light');
        await tab.open(url(page));
        if (!isViewer(page))
          await tab.run(ready);
        else
          await wait(150);
        await look(tab, page, width);
      } catch (error) { fault('not opened', page, error.message); }
    }
}

const place = 'Math.round(scrollY + (document.getElementById("doc-content") || document.body).scrollTop)';
/// The keys work from the start: the first stop skips to the text, and pages scroll.
async function keys(tab, page, width) {
  const where = `${page} (${width})`;
  await tab.look(...widths[width], 'light');
  await tab.open(url(page));
  await tab.press('Tab', 9);
  ++checks;
  const stop = await tab.run(
    '(() => { const e = document.activeElement, r = e.getBoundingClientRect(); return [e.className, e.tagName, e.textContent.slice(0, 40), r.top >= -1 && r.left >= -1].join("|"); })()');
  if (!/skip-link\|A\|.*\|true$/.test(stop)) fault('skip link', where, `the first stop is ${stop}`);
  await tab.open(url(page));
  if (
    (await tab.run(
      'Math.max(document.scrollingElement.scrollHeight - innerHeight, (document.getElementById("doc-content") || document.body).scrollHeight - innerHeight)')) >
    100)
    for (const [key, code] of [['PageDown', 34], [' ', 32]]) {
      ++checks;
      // The glide of the key before has to end.
      for (let last = -1, now; (now = await tab.run(place)) !== last; last = now) await wait(150);
      await tab.run('scrollTo({ top: 0, behavior: "instant" })');
      await wait(50);
      let moved = false;
      // A busy machine may lose a key; twice it does not.
      for (let k = 0; k < 2 && !moved; ++k) {
        await tab.press(key, code);
        moved = await tab.until(`${place} > 20`, 2500);
      }
      if (!moved) fault('keys', where, `${key === ' ' ? 'Space' : key} does not scroll`);
    }
  complaints(tab, where);
}

/// An anchor is at its place, and the screen is filled to its foot.
async function anchors(tab) {
  for (const page of all.filter((f) => /^(ch\d\d|ledger|errata|conventions)\.html$/.test(f))) {
    const ids = [
      ...fs.readFileSync(path.join(book, page), 'utf8')
        .matchAll(/id="((?:eq|thm|prop|def|erratum|ledger|conv)_\w+)"/g)
    ].map((m) => m[1]);
    for (const id of [ids[Math.floor(ids.length / 3)], ids[Math.floor((2 * ids.length) / 3)]].filter(Boolean))
      for (const [width, size] of Object.entries(widths)) {
        await tab.look(...size, 'light');
        await tab.open(url(`${page}#${id}`));
        if (width === 'wide') await tab.run(ready);
        await wait(150);
        ++checks;
        const [top, foot, height] = await tab.run(`[document.getElementById('${
          id}').getBoundingClientRect().top, Boolean(document.elementFromPoint(innerWidth - 60, innerHeight - 80)?.closest('#doc-content, #nav-path')), innerHeight]`);
        if (!(top > -90 && top < height / 2))
          fault('anchor', `${page}#${id} (${width})`, `it is ${Math.round(top)} px from above`);
        if (!foot) fault('anchor', `${page}#${id} (${width})`, 'the foot of the screen is empty');
      }
  }
}

/// The search says what it is, finds letters and apostrophes, and prose before declarations; the colours are
/// a stop of the keyboard.
async function search(tab) {
  await tab.look(...widths.wide, 'light');
  await tab.open(url('index.html'));
  const ask = async (question) => {
    await tab.run(`(() => { const i = document.getElementById('book-search'); i.focus(); i.value = ''; })()`);
    await tab.type(question);
    await tab.until(
      `document.querySelectorAll('#book-search-results a').length > 0 || /Nothing/.test(document.getElementById('book-search-results').textContent)`,
      8000);
    ++checks;
    return tab.run(
      `[...document.querySelectorAll('#book-search-results a')].map((a) => [a.getAttribute('href'), a.textContent])`);
  };
  const noether = await ask("Noether's theorem");
  if (!noether.some(([, text]) => /Noether['’]s theorem/.test(text)))
    fault(
      'search', 'index.html',
      `"Noether's theorem" finds ${
        noether.slice(0, 3).map((h) => h[1].slice(0, 40)).join(' / ') || 'nothing'}`);
  const said = () => tab.run(
    `(() => { const i = document.getElementById('book-search'), l = document.getElementById('book-search-results'); return [i.getAttribute('role'), i.getAttribute('aria-expanded'), l.getAttribute('role'), l.querySelectorAll('[role="option"]').length, document.getElementById(i.getAttribute('aria-activedescendant'))?.getAttribute('aria-selected')].join(); })()`);
  await tab.press('ArrowDown', 40);
  if (!/^combobox,true,listbox,\d+,true$/.test(await said()))
    fault('search', 'index.html', `roles of input, list, options, the chosen one: ${await said()}`);
  if (!(await ask('λ')).length) fault('search', 'index.html', '"λ" finds nothing');
  for (const word of ['quaternion', 'plots', 'checkpoint', 'body_momentum']) {
    const [first] = await ask(word);
    if (!first || isInterface(first[0]))
      fault('search', 'index.html', `"${word}" leads to ${first?.[0] ?? 'nothing'}`);
  }
  ++checks;
  if (
    (await tab.run(
      `(document.querySelector('#book-colours, doxygen-awesome-dark-mode-toggle') || {}).tabIndex`)) !== 0)
    fault('keys', 'index.html', 'the button of the colours is no stop of the keyboard');
  complaints(tab, 'index.html');
}

const began = Date.now();
/// What was found so far, by kinds, the first few of each.
function report() {
  for (const [kind, list] of [...faults].sort()) {
    const pages = new Set(list.map((text) => text.replace(/[ (#:].*$/, '')));
    console.log(`${kind}: ${list.length} times, on ${pages.size} ${pages.size === 1 ? 'page' : 'pages'}`);
    for (const text of list.slice(0, process.env.BOOK_PAGES_ALL ? Infinity : 6)) console.log(`    ${text}`);
  }
  console.log(`${all.length} pages of the book in ${Math.round((Date.now() - began) / 1000)} s, ${
    checks} checks: ${faults.size ? `${[...faults.values()].flat().length} faults` : 'as they should be'}`);
}
const browser = await Browser.start(program);
for (const signal of ['SIGINT', 'SIGTERM'])
  process.on(signal, () => {
    report();
    console.log('interrupted: what is above is not all');
    browser.close().finally(() => process.exit(1));
  });
try {
  const first = all.filter((f) => !isInterface(f)), rest = all.filter(isInterface),
        tabs = await Promise.all([browser.tab(), browser.tab()]);
  for (const tab of tabs) await tab.ask('Emulation.setFocusEmulationEnabled', { enabled: true });
  await Promise.all(tabs.map((tab) => everyPage(tab, first)));
  await Promise.all(tabs.map((tab) => everyPage(tab, rest)));
  // Keys go to one tab alone, the one in front.
  await tabs[0].ask('Page.bringToFront');
  for (const page of all.filter((f) => !isViewer(f) && (!isInterface(f) || f === 'namespaceactio.html')))
    for (const width of Object.keys(widths)) await keys(tabs[0], page, width);
  await anchors(tabs[0]);
  if (all.includes('index.html')) await search(tabs[0]);
  for (const page of only ? [] : ['scenes.html']) {
    await tabs[0].look(...widths.wide, 'light');
    await tabs[0].open(url(page));
    ++checks;
    if (!(await tabs[0].run(`document.querySelector('iframe[src^="viewer_"]') !== null`)))
      fault('viewer', page, 'no page of a run is shown');
  }
} finally { await browser.close(); }

report();
process.exit(faults.size ? 1 : 0);
