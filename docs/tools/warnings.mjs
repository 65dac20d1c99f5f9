// Doxygen's warnings with the lines of the pages as they were written, not as they were expanded.
import fs from 'node:fs';
import path from 'node:path';
import { options } from './lib.mjs';

const opt = options({ pages: '', log: '', root: '.' });
const { maps } = JSON.parse(fs.readFileSync(path.join(opt.pages, 'items.json'), 'utf8'));
// A key of a scene says itself what it means, and the page on scenes shows that: no comment says it again.
const isKey = l => /Member \w+ \(variable\) of struct actio::scene::\w*Keys is not documented/.test(l);
const lines = fs.readFileSync(opt.log, 'utf8').split('\n').filter(l => l.trim() && !isKey(l));
for (const l of lines) {
  const m = /^(.*?\/book-src\/)([^/:]+):(\d+):(.*)$/.exec(l);
  const map = m && maps[m[2]];
  console.error(map ? `${map.file}:${map.lines[Number(m[3]) - 1] ?? 1}:${m[4]}` : l.replaceAll(path.resolve(opt.root) + '/', ''));
}
process.exit(lines.length ? 1 : 0);
