// Sentences that claim something of all cases, and what they rest on.
//
//   node docs/tools/claims.mjs [--root DIR] [--propose | --prune]
//
// A sentence of a page with one of the words below is true of every case or it is false. It rests on something
// that it names, \ref, \figure, \cite or \verdict, or it stands in a box that is proved or checked, or it
// introduces a display; otherwise somebody has read it and said in docs/claims.tsv why it needs no more. What
// is left is listed with file and line, and the exit status is 1. --propose prints what is left as lines for
// that list, each to be given its reason; --prune drops the lines of it whose sentences are gone.
import crypto from 'node:crypto';
import fs from 'node:fs';
import path from 'node:path';
import { options, walk } from './lib.mjs';

const words = /\b(exactly|every|only|none|never|always|all|cannot)\b/i;
/// Turns of phrase in which these words claim nothing.
const phrases = /\b(all the same|after all|first of all|above all|not only|only if|once and for all|all in all|read-only)\b/gi;
const boxes = /^(statement|definition|result|proof|equation|printed|beside|exercise)$/;
const names = /\\(ref|figure|cite|verdict|target)\b/;

/// A text without its formulas and its code, in which words are words.
const plain = text => text.replace(/\\f\$.*?\\f\$|`[^`]*`|\$[^$]*\$/g, ' ').replace(/\\(ref|cite)\s+\S+/g, ' ').replace(phrases, ' ');

/// Ends of sentences, where none is inside a formula, code or a link.
function sentences(text) {
  const hidden = [];
  const masked = text.replace(/\\f\$.*?\\f\$|`[^`]*`|\[[^\]]*\]\([^)]*\)|"[^"]*"/g, m => { hidden.push(m); return `\u0001${hidden.length - 1}\u0002`; });
  return masked.split(/(?<=[.!?](?:\)|\*)?)\s+(?=[A-Z*\\(\u0001`])/).map(s => s.replace(/\u0001(\d+)\u0002/g, (_, i) => hidden[i]).trim()).filter(Boolean);
}

/// Every sentence of a page outside of its boxes: its line, its text, and whether a display follows it.
export function sentencesOf(source) {
  const out = [], lines = source.split('\n');
  let fence = false, display = false, depth = 0, paragraph = [], start = 0;
  const flush = next => {
    const text = paragraph.join(' ').replace(/\s+/g, ' ').trim();
    paragraph = [];
    const parts = sentences(text);
    parts.forEach((sentence, i) => {
      let line = start, at = text.indexOf(sentence), passed = 0;
      for (const l of lines.slice(start)) { passed += l.replace(/\s+/g, ' ').trim().length + 1; if (passed > at) break; ++line; }
      out.push({ line: line + 1, sentence, introduces: next && i === parts.length - 1 && !/[.!?)]$/.test(sentence) });
    });
  };
  lines.forEach((raw, i) => {
    const l = raw.trim();
    if (/^(```|~~~)|^[\\@](end)?(code|verbatim)\b|^<\/?pre/.test(l)) { flush(true); fence = !fence; return; }
    if (fence) return;
    if (/^\\f\[/.test(l)) { if (!depth) flush(true); display = !/\\f\]/.test(l); return; }
    if (display) { display = !/\\f\]/.test(l); return; }
    const command = /^\\([A-Za-z]+)(?:\{(.*)\})?(?:\s.*)?$/.exec(l);
    const name = command && !names.test(`\\${command[1]}`) ? command[1] : '';
    if (name) {
      if (!depth) flush(true);
      if (boxes.test(name)) ++depth;
      else if (/^end/.test(name) && boxes.test(name.slice(3))) --depth;
      // The caption of a drawing is a sentence of the page; a table or a picture is its own evidence.
      else if (!depth && /^(idea|animation)$/.test(name) && command[2]) {
        const caption = command[2].split(',').slice(name === 'idea' ? 1 : 2).join(',').trim();
        for (const sentence of sentences(caption)) out.push({ line: i + 1, sentence, introduces: false });
      }
      return;
    }
    if (depth) return;
    if (/^#{1,6} /.test(l) || l === '') { flush(lines.slice(i).find(x => x.trim())?.trim().match(/^(\\f\[|\\(table|picture|claims|prints|tryit|step|snippet|scene|benchmarks)|```|\|)/)); return; }
    if (/^    /.test(raw) && !paragraph.length) return;  // code
    // A row of a table and an item of a list are read for themselves.
    if (/^\|/.test(l)) { flush(true); if (!/^\|[-:| ]+\|$/.test(l)) out.push({ line: i + 1, sentence: l, introduces: false }); return; }
    if (/^([-*]|\d+\.) /.test(l)) flush(false);
    if (!paragraph.length) start = i;
    paragraph.push(l);
  });
  flush(false);
  return out;
}

export const hashOf = sentence => crypto.createHash('sha1').update(sentence.replace(/\s+/g, ' ')).digest('hex').slice(0, 10);

/// The sentences of the pages of a project that claim of all cases and name nothing they rest on.
export function unsupported(root) {
  const pages = [...walk(path.join(root, 'chapters')), ...walk(path.join(root, 'docs/pages')), path.join(root, 'README.md')].filter(f => f.endsWith('.md') && fs.existsSync(f));
  return pages.flatMap(file => sentencesOf(fs.readFileSync(file, 'utf8')).filter(s => words.test(plain(s.sentence)) && !names.test(s.sentence) && !s.introduces).map(s => ({ file: path.relative(root, file), ...s, hash: hashOf(s.sentence) })));
}

/// What was read, by hash: the reason.
export function reviewed(root) {
  const file = path.join(root, 'docs/claims.tsv');
  if (!fs.existsSync(file)) return new Map();
  return new Map(fs.readFileSync(file, 'utf8').split('\n').filter(l => l.trim() && !l.startsWith('#')).map(l => l.split('\t')).map(([hash, , , reason]) => [hash, reason?.trim() ?? '']));
}

if (process.argv[1] && path.resolve(process.argv[1]) === path.resolve(new URL(import.meta.url).pathname)) {
  const opt = options({ root: '.', propose: false, prune: false });
  const known = reviewed(opt.root), found = unsupported(opt.root), left = found.filter(s => !known.get(s.hash));
  if (opt.prune) {
    const file = path.join(opt.root, 'docs/claims.tsv'), live = new Set(found.map(s => s.hash));
    fs.writeFileSync(file, fs.readFileSync(file, 'utf8').split('\n').filter(l => !l || l.startsWith('#') || live.has(l.split('\t')[0])).join('\n'));
  }
  for (const s of left) console.log(opt.propose ? `${s.hash}\t${s.file}\t${s.sentence.slice(0, 60).replaceAll('\t', ' ')}\t` : `${s.file}:${s.line}: ${s.sentence}`);
  if (left.length && !opt.propose) console.error(`${left.length} sentence${left.length > 1 ? 's' : ''} with "exactly, every, only, none, never, always, all, cannot" and nothing named to rest on: name the theorem or the figure, say less, or give the reason in docs/claims.tsv`);
  process.exit(left.length && !opt.propose ? 1 : 0);
}
