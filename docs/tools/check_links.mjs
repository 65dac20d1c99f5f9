// Every href, src and anchor inside the book leads somewhere, and nothing in it reaches for the network.
import fs from 'node:fs';
import path from 'node:path';
import { Errors, walk } from './lib.mjs';

const root = process.argv[2];
const errors = new Errors();
const all = new Set(walk(root).map(f => path.relative(root, f)));
const pages = [...all].filter(f => f.endsWith('.html'));
const html = new Map(pages.map(f => [f, fs.readFileSync(path.join(root, f), 'utf8').replace(/<!--[\s\S]*?-->/g, '')]));
const anchors = new Map();
for (const [f, text] of html) {
  const seen = new Map();
  for (const m of text.matchAll(/<[a-zA-Z][^>]*?\s(?:id|name)="([^"]+)"/g)) seen.set(m[1], true);
  anchors.set(f, seen);
}
let links = 0;
for (const [f, text] of html) {
  const line = at => text.slice(0, at).split('\n').length;
  for (const m of text.matchAll(/<([a-zA-Z]+)[^>]*?\s(?:href|src|data)="([^"]*)"/g)) {
    const target = m[2].replace(/&amp;/g, '&');
    ++links;
    if (/^(https?:)?\/\//.test(target)) { errors.add(f, line(m.index), `reaches for the network: ${target}`); continue; }
    if (/^(javascript:|data:|mailto:)/.test(target)) continue;
    const [file, anchor] = target.split('#');
    const to = file === '' ? f : path.normalize(path.join(path.dirname(f), decodeURI(file)));
    if (!all.has(to)) { errors.add(f, line(m.index), `dead link: ${target}`); continue; }
    // The page of a run takes a moment for an anchor.
    if (/^t=[\d.]+(&play&stage)?$/.test(anchor ?? '') && anchors.get(to)?.has('scrubber')) continue;
    if (anchor && anchors.has(to) && !anchors.get(to).has(decodeURIComponent(anchor))) errors.add(f, line(m.index), `dead anchor: ${target}`);
  }
}
for (const f of [...all].filter(f => f.endsWith('.css'))) {
  const text = fs.readFileSync(path.join(root, f), 'utf8').replace(/\/\*[\s\S]*?\*\//g, '');
  for (const m of text.matchAll(/url\(\s*['"]?([^'")]+)/g)) {
    ++links;
    if (/^(https?:)?\/\//.test(m[1])) errors.add(f, 1, `reaches for the network: ${m[1]}`);
    else if (!m[1].startsWith('data:') && !all.has(path.normalize(path.join(path.dirname(f), m[1].split(/[?#]/)[0])))) errors.add(f, 1, `missing: ${m[1]}`);
  }
}
// The tree's own script data.
for (const f of [...all].filter(f => /^(navtreedata|.*_8hpp|.*)\.js$/.test(f) && /^var [A-Za-z0-9_]+ =\s*\[/m.test(fs.readFileSync(path.join(root, f), 'utf8').slice(0, 4000))))
  for (const m of fs.readFileSync(path.join(root, f), 'utf8').matchAll(/",\s*"([A-Za-z0-9_.-]+\.html)(?:#([^"]+))?"/g)) {
    ++links;
    if (!all.has(m[1])) errors.add(f, 1, `dead link in the tree: ${m[1]}`);
    else if (m[2] && !anchors.get(m[1]).has(m[2])) errors.add(f, 1, `dead anchor in the tree: ${m[1]}#${m[2]}`);
  }
errors.exitIfAny('links');
console.log(`book: ${links} links, all alive, none to the network`);
