// Full-text index of the book for lunr, as a plain script: works from file:// where fetch() does not.
import fs from 'node:fs';
import path from 'node:path';
import { createRequire } from 'node:module';
import { options, walk } from './lib.mjs';

const opt = options({ html: '' });
const lunrFile = '/usr/share/javascript/lunr/lunr.min.js';
const lunr = createRequire(import.meta.url)(lunrFile);

// Formulas are left out: nobody types them, and their text is not what one sees. Their Greek letters can be
// found.
const plain = html => html.replace(/<!--f-->[\s\S]*?<!--\/f-->/g, ' ')
  .replace(/<(script|style|svg)\b[\s\S]*?<\/\1>/g, ' ').replace(/<[^>]+>/g, ' ')
  .replace(/&lt;/g, '<').replace(/&gt;/g, '>').replace(/&quot;/g, '"').replace(/&nbsp;/g, ' ')
  .replace(/&#(\d+);/g, (_, code) => String.fromCodePoint(Number(code))).replace(/&amp;/g, '&').replace(/\s+/g, ' ').trim();
const letters = /\\(?:var)?(alpha|beta|gamma|delta|epsilon|zeta|eta|theta|iota|kappa|lambda|mu|nu|xi|pi|rho|sigma|tau|phi|chi|psi|omega)(?![a-z])/gi;
const greek = html => [...new Set([...html.matchAll(/<annotation encoding="application\/x-tex">([\s\S]*?)<\/annotation>/g)].flatMap(f => [...f[1].matchAll(letters)].map(m => m[1].toLowerCase())))].join(' ');
/// As the question is put, so is the text: Noether's is Noether.
const indexed = text => text.replace(/['’]s\b/g, '').replace(/[’']/g, ' ');

const skip = /_source\.html$|^(files|annotated|classes|functions|globals|namespacemembers|hierarchy|pages|dir_|concepts|namespaces|graph_legend|doxygen_crawl)/;
const entries = [];
for (const file of walk(opt.html).filter(f => f.endsWith('.html'))) {
  const name = path.basename(file);
  if (skip.test(name)) continue;
  const html = fs.readFileSync(file, 'utf8');
  const title = plain(/<title>([\s\S]*?)<\/title>/.exec(html)?.[1] ?? name).replace(/ · actio$/, '');
  const body = /<div class="contents">([\s\S]*?)<!-- contents -->/.exec(html)?.[1] ?? '';
  // A section, a statement's box, a documented member: each is a place of its own to land on.
  const marks = [...body.matchAll(/<h[1-4][^>]*>\s*<a class="anchor" id="([^"]+)"><\/a>([\s\S]*?)<\/h[1-4]>|<div class="statement [^"]*" id="([^"]+)"><div class="statement-head">([\s\S]*?)<\/a>|<a id="([^"]+)" name="[^"]*"><\/a>\s*<h2 class="memtitle">([\s\S]*?)<\/h2>|<tr data-verdict="[^"]*"><td class="id">(?:<a href="([^"]*)">|<a class="target" id="([^"]+)"><\/a>)([\s\S]*?)<\/td>/g)];
  let from = 0, here = { anchor: '', title };
  const push = to => { const t = plain(body.slice(from, to)); if (t.length > 1) entries.push({ url: here.url ?? (here.anchor ? `${name}#${here.anchor}` : name), title: here.title, page: title, text: t, letters: greek(body.slice(from, to)) }); };
  for (const m of marks) {
    push(m.index);
    from = m.index;
    here = { anchor: m[1] ?? m[3] ?? m[5] ?? m[8], url: m[7] === undefined ? undefined : (m[7].startsWith('#') ? name + m[7] : m[7]), title: plain(m[2] ?? m[4] ?? m[6] ?? m[9]).replace('◆', '').trim() };
  }
  push(body.length);
}
const index = lunr(function () {
  this.ref('n');
  this.field('title', { boost: 10 });
  this.field('page', { boost: 2 });
  this.field('text');
  this.field('letters', { boost: 3 });
  this.field('id', { boost: 10 });
  entries.forEach((e, n) => this.add({ n, title: indexed(e.title), page: indexed(e.page), text: indexed(e.text), letters: e.letters, id: (e.url.split('#')[1] ?? '').replace(/^autotoc.*|^[ag][0-9a-f]{32}.*/, '') }));
});
const shown = entries.map(e => ({ u: e.url, t: e.title, p: e.page, x: e.text.slice(0, 160) }));
fs.copyFileSync(lunrFile, path.join(opt.html, 'lunr.min.js'));
fs.writeFileSync(path.join(opt.html, 'search_index.js'), `window.bookSearch=${JSON.stringify({ index, entries: shown })};\n`);
console.log(`book: ${entries.length} places to find, index of ${Math.round(fs.statSync(path.join(opt.html, 'search_index.js')).size / 1024)} kB`);
