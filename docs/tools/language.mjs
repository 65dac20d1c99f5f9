// The length of paragraphs and of sentences on every page.
//
//   node docs/tools/language.mjs [--root DIR] [PAGE...]
//
// A paragraph has at most 110 words and a sentence at most 38. A formula, a piece of code or a reference counts as
// one word; a display ends a paragraph, and so does an item of a list. What is longer is listed with file, line and
// count, the longest first, and the exit status is 1. There is no list of exceptions.
import fs from 'node:fs';
import path from 'node:path';
import { walk } from './lib.mjs';

const longestParagraph = 110, longestSentence = 38;

/// Formulas, code, links and commands as one word each, marks of emphasis as nothing.
const asWords = text =>
  text
    .replace(/\\f\$.*?\\f\$|\$`?[^$]*\$|`[^`]*`/g, ' formula ')
    .replace(/!?\[([^\]]*)\]\([^)]*\)/g, ' $1 ')
    .replace(/\\(ref|cite)\s+\S+?(?=[.,;:)]*(\s|$))(\s+"([^"]*)")?/g, (_, _c, _e, _q, words) => ` ${words ?? 'reference'} `)
    .replace(/\\(figure|verdict|target)\{[^}]*\}/g, ' figure ')
    .replace(/<[^>]*>/g, ' ')
    .replace(/[*_]/g, '');

const count = text => text.split(/\s+/).filter(w => /[\p{L}\p{N}]/u.test(w)).length;

/// Ends of sentences: a full stop before a capital, but not after an initial or an abbreviation.
const sentencesOf = text =>
  text.split(/(?<=[.!?]["')]?)(?<!\b(?:e\.g|i\.e|cf|vol|no|pp?|[A-Z])\.)\s+(?=["'(]?(?:\p{Lu}|formula|figure|reference))/u).filter(s => s.trim());

/// What is too long on a page: line, what it is, its count, how it begins.
export function tooLong(source) {
  const out = [], lines = source.split('\n');
  let fence = false, display = false, paragraph = [], start = 0;
  const flush = () => {
    const text = asWords(paragraph.join(' '));
    paragraph = [];
    const words = count(text);
    const begins = t => t.trim().split(/\s+/).slice(0, 8).join(' ');
    if (words > longestParagraph) out.push({ line: start + 1, what: 'paragraph', words, bound: longestParagraph, begins: begins(text) });
    for (const s of sentencesOf(text)) if (count(s) > longestSentence) out.push({ line: start + 1, what: 'sentence', words: count(s), bound: longestSentence, begins: begins(s) });
  };
  lines.forEach((raw, i) => {
    const l = raw.trim();
    const add = text => { if (!paragraph.length) start = i; paragraph.push(text); };
    if (/^(```|~~~)|^[\\@](end)?(code|verbatim)\b|^<\/?pre/.test(l)) { flush(); fence = !fence; return; }
    if (fence) return;
    if (display) { display = !/\\f\]|^\$\$$/.test(l); return; }
    if (/^\\f\[/.test(l)) { flush(); display = !/\\f\]/.test(l); return; }
    if (l === '$$') { flush(); display = true; return; }
    if (/^\$\$.*\$\$/.test(l)) { flush(); return; }
    if (l === '' || /^#{1,6} /.test(l) || (/^    /.test(raw) && !paragraph.length)) { flush(); return; }
    const command = /^\\([A-Za-z]+)(?:\{(.*)\})?$/.exec(l);
    if (command && !/^(ref|cite|figure|verdict)$/.test(command[1])) {
      flush();
      if (/^(idea|animation|picture|table|scenepicture)$/.test(command[1]) && command[2]) { add(command[2].split(',').slice(command[1] === 'idea' ? 1 : 2).join(',')); flush(); }
      return;
    }
    if (/^\|/.test(l)) { flush(); if (!/^\|[-:| ]+\|$/.test(l)) for (const cell of l.split(/(?<!\\)\|/)) { add(cell); flush(); } return; }
    if (/^([-*]|\d+\.) /.test(l)) flush();
    add(l.replace(/^>\s?|^([-*]|\d+\.) /, ''));
  });
  flush();
  return out;
}

if (process.argv[1] && import.meta.url.endsWith(path.basename(process.argv[1]))) {
  const { flags, rest } = parse(process.argv.slice(2));
  const root = path.resolve(flags.root ?? '.');
  const pages = rest.length ? rest.map(f => path.resolve(f)) : [...walk(path.join(root, 'chapters')), ...walk(path.join(root, 'docs/pages')), path.join(root, 'README.md')].filter(f => f.endsWith('.md') && fs.existsSync(f));
  const found = pages.flatMap(f => tooLong(fs.readFileSync(f, 'utf8')).map(x => ({ file: path.relative(root, f), ...x }))).sort((a, b) => b.words / b.bound - a.words / a.bound);
  for (const x of found) console.error(`${x.file}:${x.line}: a ${x.what} of ${x.words} words, at most ${x.bound}: "${x.begins} ..."`);
  if (found.length) { console.error(`${found.length} paragraphs and sentences are too long`); process.exit(1); }
}

function parse(words) {
  const flags = {}, rest = [];
  for (let i = 0; i < words.length; ++i) if (words[i].startsWith('--')) flags[words[i].slice(2)] = words[++i]; else rest.push(words[i]);
  return { flags, rest };
}
