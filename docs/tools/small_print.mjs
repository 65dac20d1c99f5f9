// Notes and titles of checks are plain text, for a terminal; on a page their mathematics is set as such: mu
// -> Ad*_{f(mu)} mu becomes a formula, and the id of a statement its name, with a link. What does not parse
// stays as it was written.
import fs from 'node:fs';
import {createRequire} from 'node:module';
import path from 'node:path';

import {escapeHtml, label} from './lib.mjs';

const katexFile = '/usr/share/javascript/katex/katex.js';
const katex = fs.existsSync(katexFile) ? createRequire(import.meta.url)(katexFile) : null;
const macros = JSON.parse(fs.readFileSync(new URL('../macros.json', import.meta.url), 'utf8'));

const greek =
  'alpha|beta|gamma|delta|epsilon|zeta|eta|theta|iota|kappa|lambda|mu|nu|xi|pi|rho|sigma|tau|phi|chi|psi|omega|Gamma|Delta|Theta|Lambda|Xi|Pi|Sigma|Phi|Psi|Omega|eps';
const functions = 'Tr|tr|det|log|exp|ker|dim|dist|diam|floor|Ad|ad|div|diag|cay|iex';
const english = new Set('a an as at be by do he if in is it no of on or so to up us we I pt'.split(' '));
const isSymbol = letters => letters.length === 1 || (letters.length === 2 && !english.has(letters)) ||
  new RegExp(`^d?(?:${greek})$|^(?:${functions})$|^d[a-z]?[A-Z]?$`).test(letters);

/// A word with an index or a power, a Greek letter by its name, or Ad with its star.
const telling = new RegExp(
  `(?:^|[^A-Za-z])(?:d?(?:${greek})\\d?)(?![A-Za-z])|(?:^|[^A-Za-z0-9])(?:[A-Za-z]{1,2}|d?(?:${greek})|${
    functions})[\\d']*\\*?[_^](?:[A-Za-z0-9{(*#+-])|\\)\\^|\\}_|\\bd[a-z] \\^ d[a-z]|\\b(?:Ad|ad)\\*`);
/// Or a relation or a sum, N = 2 and K + P; a letter or function with its argument, p(0) and dist(g1, g2); a
/// letter with a star, R*; a capital that stands alone; a derivative along something, dS.V.
const tellingToo = new RegExp(
  `(?:^|[\\s(|])[-+]?[A-Za-z][A-Za-z0-9'()*/]*\\s(?:=|\\+|-|<|>|<=|>=)\\s[-(|{<]?[A-Za-z0-9|({]|(?:^|[^A-Za-z])(?:[A-Za-z]'?|${
    functions})\\([^()\\s]|(?:^|[\\s(+/-])[A-Za-z]\\*(?![A-Za-z]{2})|(?:^|[\\s(|])[B-HJ-Z](?=$|[\\s,;:)|])|\\bd[A-Z]\\.[A-Z]|<[^\\s<>=][^<>]*>`);
/// What may stand within a formula beside such a word: operators, numbers, letters, names of functions.
const operator = /^(?:=|\+|-|->|<|>|<=|>=|\/|\^|:=|\||\.)$/;
function fits(word) {
  if (operator.test(word) || /^\.\.\.,?$/.test(word)) return true;
  const bare = word.replace(/[.,;:]+$/, '');
  if (!/^[-+A-Za-z0-9'()[\]{}<>|^_*/=,.~#]+$/.test(bare) || english.has(bare) || isCode(bare)) return false;
  return (bare.match(/[A-Za-z]+/g) ?? []).every(isSymbol);
}
/// The name of something in the code or of a statement.
export const isCode = word => /^[a-z]{2,}(?:_[a-z0-9]+)+$/.test(word) && !isSymbol(word.split('_')[0]);

/// Plain text as TeX.
export function asTex(text) {
  let out =
    text.replace(/\.\.\./g, '\\dots ')
      .replace(/<-/g, '\\leftarrow ')
      .replace(/->/g, '\\to ')
      .replace(/<=/g, '\\le ')
      .replace(/>=/g, '\\ge ')
      .replace(/<(?=[^\s=][^<>]*>)/g, '\\langle ')
      .replace(/(\\langle [^<>]*)>/g, '$1\\rangle ')
      .replace(/\s\^\s/g, ' \\wedge ')
      .replace(/\so\s/g, ' \\circ ')
      .replace(/\s\.\s/g, ' \\cdot ')
      // Braces that are no arguments are braces.
      .replace(/(^|[^_^])\{((?:[^{}]|\{[^{}]*\})*)\}/g, (all, before, inner) => `${before}\\{${inner}\\}`)
      .replace(/([A-Za-z)}])\*(?=[_\s)(\]},;]|$)/g, '$1^*')
      .replace(/([A-Z])\*(?=[A-Za-z])/g, '$1^*')
      .replace(/\^\*_/g, '^*_')
      .replace(/\^#/g, '^\\sharp ')
      .replace(/\^\(([^()]*)\)/g, '^{($1)}')
      .replace(/\^(-?\d+|-[a-z])/g, '^{$1}')
      .replace(/_([A-Za-z])([A-Z])(?=[_^])/g, '_$1 $2')
      .replace(new RegExp(`_(${greek})(?![A-Za-z])`, 'g'), '_{$1}')
      .replace(/_([A-Za-z0-9]+[+-]1)(?![0-9A-Za-z])/g, '_{$1}')
      .replace(/_([A-Za-z0-9]{2,})/g, '_{$1}')
      .replace(/\b([A-Za-z]+)-bar\b/g, '\\bar{$1}')
      .replace(/\b([A-Za-z])~/g, '\\tilde{$1}');
  out =
    out
      .replace(
        new RegExp(`(^|[^A-Za-z\\\\])(d?)(${greek})(\\d?)(?![A-Za-z])`, 'g'),
        (all, before, d, name, digit) => `${before}${d}\\${name}${digit ? `_${digit}` : ' '}`)
      .replace(new RegExp(`(^|[^A-Za-z\\\\])(${functions})(?![A-Za-z])`, 'g'), '$1\\operatorname{$2}')
      .replace(/(^|[^A-Za-z\\])(SO|SE|SU|SL|GL|UT|Sp|Aff)(?=\()/g, '$1\\mathrm{$2}')
      .replace(/(\\(?:theta|Theta) )([-+])(?=\s*(?:$|[,;)]))/g, '$1^$2')
      .replace(/([A-Za-z}])(\d)(?=[\s),^]|$)/g, (all, a, n) => (/\\[A-Za-z]*$/.test(a) ? all : `${a}_${n}`))
      .replace(/([A-Za-z])\.(?=[A-Za-z\\])/g, '$1\\cdot ')
      .replace(/#/g, '\\#')
      .replace(/&/g, '\\&')
      .replace(/%/g, '\\%');
  return out.replace(/\s+/g, ' ').trim();
}
const parses = new Map();
function sets(tex) {
  if (!katex) return true;
  if (!parses.has(tex)) {
    let fine = true;
    try {
      katex.renderToString(tex, { macros: {...macros }, throwOnError: true, strict: 'error' });
    } catch { fine = false; }
    parses.set(tex, fine);
  }
  return parses.get(tex);
}

const balanced = text => ['()', '[]', '{}'].every(([open, close]) => {
  let depth = 0;
  for (const c of text) {
    if (c === open) ++depth;
    if (c === close && --depth < 0) return false;
  }
  return depth === 0;
});

/// Pieces of a text in turn: prose, formula, prose, ...
export function mathematics(text) {
  const words = text.replace(/\b(theta|Theta)([-+])(?=[\s,.;:)]|$)/g, '$1^{$2}').split(/(\s+)/), pieces = [];
  let prose = '';
  for (let i = 0; i < words.length;) {
    const end = formulaFrom(words, i);
    if (!end) {
      prose += words[i++];
      continue;
    }
    pieces.push(prose, end.tex);
    prose = end.after;
    i = end.next;
  }
  pieces.push(prose);
  return pieces;
}

/// The longest run of words from here that is a formula.
function formulaFrom(words, start) {
  if (words[start].trim() === '' || !fits(words[start])) return null;
  let last = start;
  while (last + 2 < words.length && (words[last] === '.' || !/[.;:]$/.test(words[last].replace(/\.\.\.,?$/, ''))) &&
         fits(words[last + 2]))
    last += 2;
  for (; last >= start; last -= 2) {
    const run = words.slice(start, last + 1).join(''), after = /(?<!\.\.)[.,;:]+$/.exec(run)?.[0] ?? '',
          formula = run.slice(0, run.length - after.length);
    // It begins and ends with something that is no operator between two things.
    if (
      !(telling.test(formula) || tellingToo.test(formula)) || /(?<!_)[=+/<^]$|->$|\s-$|\s\|$/.test(formula) ||
      /^(?:[=/>^]|<(?![^\s=<>][^<>]*>)|->|[+-]\s)/.test(formula) || !balanced(formula))
      continue;
    const tex = asTex(formula);
    if (sets(tex)) return { tex, after, next: last + 1 };
  }
  return null;
}


const statements = new Set();
/// Ids that are links where they stand in small print.
export function knowStatements(ids) {
  for (const id of ids) statements.add(id);
}

function words(text) {
  return escapeHtml(text)
    .replace(
      /\b(?:eq|thm|prop|lem|cor|def|rem|claim|bridge)_\w+/g,
      id => (statements.has(id) ? `<a href="@ref:${id}">${escapeHtml(label(id))}</a>` : id))
    .replace(
      /(?<![\w:"#])[a-z]{2,}(?:_[a-z0-9]+)+(?![\w"])/g,
      word => (isCode(word) ? `<code>${word}</code>` : word));
}
/// Plain text in HTML: its mathematics as formulas, whether between dollars or not, code between back quotes,
/// ids of statements as links.
export function smallPrint(text) {
  return String(text ?? '')
    .split(/(`[^`]+`|\\f\$.+?\\f\$|(?<!\\)\$.+?(?<!\\)\$)/)
    .map((part, i) => {
      if (i % 2 === 0)
        return mathematics(part)
          .map((piece, k) => (k % 2 ? `\\(${escapeHtml(piece)}\\)` : words(piece)))
          .join('');
      if (part.startsWith('`')) return `<code>${escapeHtml(part.slice(1, -1))}</code>`;
      return `\\(${escapeHtml(part.replace(/^(?:\\f)?\$|(?:\\f)?\$$/g, ''))}\\)`;
    })
    .join('');
}
