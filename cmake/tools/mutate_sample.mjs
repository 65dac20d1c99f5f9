// mutate_sample.mjs ROOT BUILD JOBS --sample N --seed S: what share of small errors do the checks notice?
//
// Draws N places in the library's sources (src/actio without bodies and instruments) by a rule and a
// seed, not by hand, and a plausible error for each: a sign, the order of factors or of arguments, a factor,
// an inverse, a star or a transpose that is dropped, another side, an index that is one off, a comparison,
// `and` for `or`. All of them are planted into one copy of the sources, each asleep behind a switch that is
// read when a program runs, so the copy is compiled once:
//
//   a - b      becomes      (actio::mutants::on(17) ? (a + b) : (a - b))
//
// --list prints the draw alone. With --each-source the first error of the draw that each source of checks
// catches is printed as a line of proofs_checks/mutate/mutations.tsv, which `./run mutate` plants one at a
// time.
//
// What does not compile is withdrawn and another place is drawn: also a sign between matrices, where the two
// versions are expressions of types that have nothing in common; of these the sample has fewer than its
// share. Then each error is awakened alone, and the theorem checks (prime field and double, a tenth of the
// points) and the cases of the library's tests that come by its place run, the shortest first, until one of
// them fails. Result:
// BUILD/report/mutation_sample.tsv; a run that was stopped goes on after its last trial unless a file has
// changed since. A survivor either changes nothing, which a line of
// proofs_checks/mutate/equivalent.tsv may explain, or is a gap. Status 1 where fewer than 95 of 100 of the
// others are caught.
import { execFile, execFileSync, spawnSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';

const [root, buildArgument, jobs, ...words] = process.argv.slice(2);
const option = (name, otherwise) => {
  const at = words.indexOf(`--${name}`);
  const value = at < 0 ? otherwise : Number(words[at + 1] ?? NaN);
  if (!Number.isInteger(value) || value < 1) {
    console.error(`mutate: --${name} wants a whole number above 0, not '${words[at + 1]}'`);
    process.exit(2);
  }
  return value;
};
words.forEach((word, i) => {
  if (!word.startsWith('--') && !['--sample', '--seed'].includes(words[i - 1])) {
    console.error(`mutate: '${word}' is no option; lines of mutations.tsv and --sample do not go together`);
    process.exit(2);
  }
  if (word.startsWith('--') && !['--sample', '--seed', '--list', '--each-source'].includes(word)) {
    console.error(`mutate: unknown option '${word}'; there are --sample N, --seed S, --list and --each-source`);
    process.exit(2);
  }
});
const wanted = option('sample', 200), seed = option('seed', 1);
// Errors that are planted, and those that were withdrawn.
const slots = 4 * wanted + 1000;
const build = path.resolve(buildArgument), copy = path.join(build, 'mutate_sample'), work = path.join(copy, 'build');

// ---- The sources, as tokens

/// Words, numbers and signs of a source with their places; comments, strings and lines for the preprocessor are passed over.
function tokens(text) {
  const rule = /\/\/[^\n]*|\/\*[\s\S]*?\*\/|^[ \t]*#[^\n]*(?:\\\n[^\n]*)*|"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*'|[A-Za-z_]\w*|\d[\w.']*|->\*?|\+\+|--|<=>|[-+*/%&|^<>=!]=|&&|\|\||::|\.\.\.|\s+|[^\s\w]/gm;
  const all = [];
  for (const m of text.matchAll(rule)) {
    if (/^(\s|\/\/|\/\*|[ \t]*#)/.test(m[0])) continue;
    all.push({ text: m[0], at: m.index, end: m.index + m[0].length });
  }
  return all;
}

const closing = { '(': ')', '[': ']', '{': '}' }, opening = { ')': '(', ']': '[', '}': '{' };

/// The token after the arguments of a template that begin here; 0 where this compares two numbers. They follow their name
/// without a space, and are for the compiler.
function endOfArguments(list, i) {
  if (i === 0 || list[i - 1].end !== list[i].at || list[i + 1]?.at !== list[i].end) return 0;
  for (let k = i + 1, open = 1; k < list.length && !/^[;{}]$/.test(list[k].text); ++k) {
    if (list[k].text === '<' && list[k - 1].end === list[k].at) ++open;
    if (list[k].text === '>' && --open === 0) return k;
  }
  return 0;
}

/// Gives each bracket its partner, and each token whether it stands in the body of a function.
function nest(list) {
  const stack = [];
  let constant = false, ofTemplate = 0;
  list.forEach((t, i) => {
    // Conditions and constants of the compiler are no code that runs.
    if (t.text === 'constexpr') constant = stack.some(s => s.kind === 'code');
    if (t.text === ';' || (t.text === ')' && stack.at(-1)?.constant)) constant = false;
    t.code = !constant && !(i < ofTemplate) && stack.some(s => s.kind === 'code') && !stack.some(s => s.kind === 'type');
    if (t.text === '<') ofTemplate = Math.max(ofTemplate, endOfArguments(list, i));
    if (closing[t.text]) stack.push({ i, kind: t.text === '{' ? kindOf(list, i, stack) : 'group', constant: t.text === '(' && list[i - 1]?.text === 'constexpr' });
    else if (opening[t.text]) {
      const from = stack.pop();
      if (!from || closing[list[from.i].text] !== t.text) throw new Error(`brackets do not match near ${t.at}`);
      t.partner = from.i, list[from.i].partner = i;
    }
  });
}

/// What a brace opens: the body of a function, a type or namespace, or a list of values.
function kindOf(list, i, stack) {
  let k = i - 1;
  while (k >= 0 && /^(const|noexcept|override|mutable|final)$/.test(list[k].text)) --k;
  // A trailing return type, or a requirement, stands between the parameters and the body.
  for (let back = k; back >= Math.max(0, k - 40); --back) {
    if (/^[;{}]$/.test(list[back].text)) break;
    if (list[back].text === '->') { k = back - 1; break; }
  }
  const before = list[k]?.text;
  for (let back = i - 1; back >= 0 && !/^[;{}]$/.test(list[back].text); --back)
    if (/^(struct|class|namespace|enum|union|concept)$/.test(list[back].text) && list[back - 1]?.text !== '<' && list[back - 1]?.text !== ',') return stack.some(s => s.kind === 'code') ? 'type' : 'scope';
  if (before === ')' || before === 'else' || before === 'do' || before === 'try') return 'code';
  if (/^[;{}]$/.test(before ?? ';')) return stack.some(s => s.kind === 'code') ? 'code' : 'scope';
  if (before === ']') return 'code';  // a lambda without parameters
  return 'group';
}

// ---- What may go wrong

const sides = [['left', 'right'], ['source', 'target'], ['D1', 'D2'], ['departure', 'arrival'], ['first', 'second'], ['lower', 'upper']];

/// The tokens of the expression around [from, to] between commas, brackets, assignments and the like.
function around(list, from, to) {
  const stop = /^([,;?:{}=]|return|else|do|case|&&|\|\||[-+*\/]=)$/;
  const header = t => t.text === ')' && /^(if|for|while|switch|constexpr)$/.test(list[t.partner - 1]?.text);
  let a = from, b = to;
  while (a > 0) {
    const t = list[a - 1];
    if (header(t)) break;
    if (opening[t.text] && t.text !== '}') { a = t.partner; continue; }
    if (closing[t.text] || stop.test(t.text)) break;
    --a;
  }
  while (b < list.length - 1) {
    const t = list[b + 1];
    if (closing[t.text] && t.text !== '{') { b = t.partner; continue; }
    if (opening[t.text] || stop.test(t.text)) break;
    ++b;
  }
  return [a, b];
}

/// The operand that ends at token i, to the left of a sign: names, calls, indices, members.
function operandBefore(list, i) {
  let k = i;
  for (;;) {
    if (opening[list[k].text]) k = list[k].partner;
    const before = list[k - 1]?.text ?? ';';
    if (/^[([]$/.test(list[k].text) && (/^[\w)\]]/.test(before) && before !== 'return')) { --k; continue; }
    if (/^(\.|->|::)$/.test(before)) { k -= 2; continue; }
    return k;
  }
}
/// The operand that begins at token i.
function operandAfter(list, i) {
  let k = i;
  if (/^[-+!*]$/.test(list[k].text)) ++k;
  for (;;) {
    if (closing[list[k].text]) k = list[k].partner;
    const after = list[k + 1]?.text ?? ';';
    if (/^[([]$/.test(after)) { ++k; continue; }
    if (/^(\.|->|::)$/.test(after)) { k += 2; continue; }
    return k;
  }
}

/// All errors that could be planted in a source: [from, to) of the text that is switched, and what stands there then.
function errorsOf(text) {
  const list = tokens(text);
  nest(list);
  const found = [];
  const cut = (a, b) => text.slice(list[a].at, list[b].end);
  /// Replaces the tokens from..to, within the expression around them.
  const plant = (rule, from, to, replacement, whole, operands) => {
    const [a, b] = whole ?? around(list, from, to);
    if (a > from || b < to) return;
    const original = cut(a, b);
    const start = list[from].at - list[a].at, end = list[to].end - list[a].at;
    found.push({ rule, at: list[a].at, end: list[b].end, original, mutated: original.slice(0, start) + replacement + original.slice(end),
      shown: [cut(from, to), replacement], operands });
  };
  const binary = i => i > 0 && /^[\w)\]]/.test(list[i - 1].text) && !/^(return|case|else)$/.test(list[i - 1].text);
  list.forEach((t, i) => {
    if (!t.code || t.text === 'operator' || list[i - 1]?.text === 'operator') return;
    const next = list[i + 1]?.text;
    if (/^[-+]$/.test(t.text)) {
      if (binary(i)) plant('sign', i, i, t.text === '+' ? '-' : '+');
      else if (t.text === '-' && !/^\d/.test(next)) plant('sign', i, i, '');
    }
    if (/^[-+]=$/.test(t.text)) {
      const a = operandBefore(list, i - 1), [, b] = around(list, i + 1, i + 1);
      plant('sign', i, i, t.text === '+=' ? '-=' : '+=', [a, b]);
    }
    if (t.text === '*' && binary(i) && /^[\w(]/.test(next ?? '')) {
      const a = operandBefore(list, i - 1), b = operandAfter(list, i + 1);
      if (found.length % 5 === 0) plant('order', a, b, `${cut(i + 1, b)} * ${cut(a, i - 1)}`, undefined, `${cut(a, i - 1)}, ${cut(i + 1, b)}`);
      plant('factor', a, b, cut(a, i - 1));
    }
    if (/^(&&|\|\|)$/.test(t.text) && binary(i)) {
      let a = i, b = i;
      while (a > 0 && !closing[list[a - 1].text] && !/^([,;?:{}=]|return)$/.test(list[a - 1].text)) a = opening[list[a - 1].text] ? list[a - 1].partner : a - 1;
      while (!opening[list[b + 1].text] && !/^[,;?:{}=]$/.test(list[b + 1].text)) b = closing[list[b + 1].text] ? list[b + 1].partner : b + 1;
      plant('logic', i, i, t.text === '&&' ? '||' : '&&', [a, b]);
    }
    if (/^(<=|>=)$/.test(t.text)) plant('comparison', i, i, t.text[0]);
    if (/^[<>]$/.test(t.text) && text[t.at - 1] === ' ' && text[t.end] === ' ') plant('comparison', i, i, `${t.text}=`);
    if (t.text === '.' && next === 'transpose' && list[i + 2]?.text === '(') plant('transpose', i, list[i + 2].partner, '');
    if (/^[A-Za-z_]/.test(t.text) && next === '(' && !/^(if|for|while|switch|return|sizeof|decltype|catch|static_assert|noexcept|requires|constexpr)$/.test(t.text)) {
      const end = list[i + 1].partner, commas = [];
      for (let k = i + 2; k < end; ++k) {
        if (closing[list[k].text]) k = list[k].partner;
        else if (list[k].text === '<' && text[list[k].at - 1] !== ' ') while (k < end && list[k].text !== '>') ++k;
        else if (list[k].text === ',') commas.push(k);
      }
      const head = t.text;
      if (/^inverse(_matrix)?$/.test(head)) plant('inverse', operandBefore(list, i + 1), end, `(${cut(i + 2, commas[0] ? commas[0] - 1 : end - 1)})`);
      if (/_star$/.test(head)) plant('star', i, i, head.replace(/_star$/, ''));
      // For the order of these two nothing changes.
      if (commas.length === 1 && end > i + 3 && !/^(min|max|hypot)$/.test(head)) plant('arguments', i + 2, end - 1, `${cut(commas[0] + 1, end - 1)}, ${cut(i + 2, commas[0] - 1)}`, around(list, i, end));
    }
    if (/^[A-Za-z_]/.test(t.text))
      for (const [one, other] of sides)
        for (const [from, to] of [[one, other], [other, one]])
          if (new RegExp(`(^|_)${from}(_|$)`).test(t.text)) plant('side', i, i, t.text.replace(from, to));
    if (t.text === '[' && binary(i) && t.partner === i + 2 && /^[A-Za-z]\w*$/.test(list[i + 1].text)) plant('index', i + 1, i + 1, `${list[i + 1].text} + 1`, operandRange(list, i));
  });
  return found;
}
/// The indexed thing and its index.
function operandRange(list, bracket) { return [operandBefore(list, list[bracket].partner), list[bracket].partner]; }

// ---- The draw

/// Numbers in [0, count), the same for the same seed on every machine.
function generator(start) {
  let state = BigInt(start) * 0x9E3779B97F4A7C15n & 0xFFFFFFFFFFFFFFFFn;
  return count => {
    state = state + 0x9E3779B97F4A7C15n & 0xFFFFFFFFFFFFFFFFn;
    let z = state;
    z = (z ^ z >> 30n) * 0xBF58476D1CE4E5B9n & 0xFFFFFFFFFFFFFFFFn;
    z = (z ^ z >> 27n) * 0x94D049BB133111EBn & 0xFFFFFFFFFFFFFFFFn;
    return Number((z ^ z >> 31n) % BigInt(count));
  };
}

function sources() {
  const all = [];
  const walk = folder => {
    for (const entry of fs.readdirSync(path.join(root, folder), { withFileTypes: true }).sort((a, b) => (a.name < b.name ? -1 : 1)))
      if (entry.isDirectory()) { if (!['bodies', 'instruments'].includes(entry.name)) walk(`${folder}/${entry.name}`); }
      else if (/\.(hpp|cpp)$/.test(entry.name)) all.push(`${folder}/${entry.name}`);
  };
  walk('src/actio');
  return all;
}

/// All possible errors in an order that the seed fixes.
function shuffled() {
  const all = [];
  for (const file of sources()) {
    const text = textOf(file);
    for (const e of errorsOf(text)) all.push({ file, line: text.slice(0, e.at).split('\n').length, ...e });
  }
  const below = generator(seed);
  for (let i = all.length - 1; i > 0; --i) {
    const k = below(i + 1);
    [all[i], all[k]] = [all[k], all[i]];
  }
  return all;
}

// ---- The copy

const switchHeader = `// Which of the planted errors is awake.
#pragma once
#include <cstdio>
#include <cstdlib>
#include <type_traits>
namespace actio::mutants {
struct Switch {
  int awake = -1;
  unsigned char passed[${slots}] = {};
  Switch() { if (char const* k = std::getenv("ACTIO_MUTANT")) awake = std::atoi(k); }
  ~Switch() {
    char const* file = std::getenv("ACTIO_MUTANTS_PASSED");
    if (!file) return;
    if (std::FILE* out = std::fopen(file, "a")) {
      for (int k = 0; k < ${slots}; ++k) if (passed[k]) std::fprintf(out, "%d %d\\n", k, passed[k]);
      std::fclose(out);
    }
  }
};
inline Switch one;
/// What need not commute with others of its kind: matrices, and what is made of them.
template <class T>
constexpr bool has_sides = requires(T const& x) { x.rows(); } || requires(T const& x) { x.group; };
constexpr bool on(int k);
/// The order of a product: of numbers it does not matter.
template <class A, class B>
constexpr bool on_product(int k, A const&, B const&) {
  if constexpr (has_sides<A> && has_sides<B>) return on(k);
  if (!std::is_constant_evaluated()) one.passed[k] |= 2;
  return false;
}
constexpr bool on(int k) {
  if (std::is_constant_evaluated()) return false;
  one.passed[k] |= 1;
  return one.awake == k;
}
}  // namespace actio::mutants
`;

// Whether a file of the copy was written: then trials of an earlier run say nothing.
let changed = false;

/// Writes a file of the copy with all errors that are planted in it.
/// What a source was when this began: whoever edits it meanwhile changes no error that is planted.
const original = new Map();
function textOf(file) {
  if (!original.has(file)) original.set(file, fs.readFileSync(path.join(root, file), 'utf8'));
  return original.get(file);
}
function writeFile(file, planted) {
  let text = textOf(file);
  const here = planted.filter(m => m.file === file).sort((a, b) => b.at - a.at);
  for (const m of here) text = `${text.slice(0, m.at)}(actio::mutants::${m.operands ? `on_product(${m.k}, ${m.operands})` : `on(${m.k})`} ? (${m.mutated}) : (${m.original}))${text.slice(m.end)}`;
  if (here.length) {
    const first = /^#(pragma once|include)[^\n]*/m.exec(text);
    text = `${text.slice(0, first.index)}#include "actio/mutants.hpp"\n${text.slice(first.index)}`;
  }
  const target = path.join(copy, file);
  if (!fs.existsSync(target) || fs.readFileSync(target, 'utf8') !== text) fs.writeFileSync(target, text), changed = true;
}

function makeCopy() {
  fs.mkdirSync(work, { recursive: true });
  // What is the same stays as it is, so that a second run compiles less.
  const own = new Set(sources());
  const sync = name => {
    const from = path.join(root, name), to = path.join(copy, name);
    if (fs.statSync(from).isDirectory()) {
      fs.mkdirSync(to, { recursive: true });
      const here = new Set(fs.readdirSync(from));
      for (const old of fs.readdirSync(to)) if (!here.has(old) && old !== 'mutants.hpp') fs.rmSync(path.join(to, old), { recursive: true });
      for (const entry of here) sync(`${name}/${entry}`);
    } else if (!own.has(name) && !(fs.existsSync(to) && fs.readFileSync(to).equals(fs.readFileSync(from)))) fs.copyFileSync(from, to), changed = true;
  };
  for (const part of ['CMakeLists.txt', 'CMakePresets.json', 'LICENSE', 'cmake', 'src', 'proofs_checks', 'tests', 'benchmarks/peers', 'data']) if (fs.existsSync(path.join(root, part))) sync(part);
  const header = path.join(copy, 'src/actio/mutants.hpp');
  if (!fs.existsSync(header) || fs.readFileSync(header, 'utf8') !== switchHeader) fs.writeFileSync(header, switchHeader);
}

const testPrograms = ['any_group', 'book', 'constraints', 'continuum', 'covariant_reduction', 'fast_body', 'formula', 'groupoid', 'groups', 'incompressible', 'jets', 'multisymplectic', 'noether', 'nonholonomic', 'numbers', 'reduction', 'rigid_body', 'scene', 'two_bodies', 'variational', 'vorticity', 'witness'].map(n => `test_${n}`);
const chapters = () => [...new Set(fs.readdirSync(path.join(root, 'proofs_checks')).map(n => /^(ch\d\d|bridge)_.*\.cpp$/.exec(n)?.[1]).filter(Boolean))].map(c => `checks_${c}`);

/// Builds, and returns the errors' numbers that the compiler objects to; null where all is well.
function compile(planted, targets) {
  const done = spawnSync('ninja', ['-C', work, '-j', jobs, '-k', '0', ...targets], { encoding: 'utf8', maxBuffer: 1 << 28 });
  if (done.status === 0) return null;
  const bad = new Set(), lines = new Map();
  for (const m of planted) {
    const text = fs.readFileSync(path.join(copy, m.file), 'utf8'), at = text.indexOf(m.operands ? `mutants::on_product(${m.k},` : `mutants::on(${m.k})`);
    const from = text.slice(0, at).split('\n').length;
    for (let l = from; l <= from + (m.mutated + m.original).split('\n').length; ++l) lines.set(`${m.file}:${l}`, [...(lines.get(`${m.file}:${l}`) ?? []), m.k]);
  }
  for (const found of done.stdout.matchAll(/(src\/actio\/[\w/]+\.[ch]pp):(\d+):\d+: (error|note|  )?[^\n]*/g))
    if (found[3] === 'error') for (const k of lines.get(`${found[1]}:${found[2]}`) ?? []) bad.add(k);
  if (!bad.size)  // The message names the place of a use: then whatever it passed through.
    for (const found of done.stdout.matchAll(/(src\/actio\/[\w/]+\.[ch]pp):(\d+):\d+:/g)) for (const k of lines.get(`${found[1]}:${found[2]}`) ?? []) bad.add(k);
  if (!bad.size) {
    fs.writeFileSync(path.join(copy, 'log'), done.stdout + done.stderr);
    console.error(`mutate: the copy does not build, and no planted error is to blame: see ${path.join(copy, 'log')}`);
    process.exit(1);
  }
  return bad;
}

// ---- The trial

/// What is run against the errors: each section of the theorem checks, and each case of the library's tests.
const sections = () => fs.readdirSync(path.join(root, 'proofs_checks')).map(n => /^((?:ch\d\d|bridge)_.*)\.cpp$/.exec(n)?.[1]).filter(Boolean);
let allUnits = null;
const units = () => (allUnits ??= [
  ...sections().map(name => ({ name, passed: name, program: `checks_${/^[a-z]+\d*/.exec(name)[0]}`, words: ['--quick', '--brief', '--columns', 'prime,double', '--source', name] })),
  ...testPrograms.flatMap(name => casesOf(name).map((one, i) => ({ name, passed: `${name}_${i}`, program: name, words: ['--color_output=no', `--run_test=${one}`] })))]);

/// The cases of a test program, which lists them as a tree by indentation.
function casesOf(program) {
  const said = spawnSync(path.join(work, 'bin', program), ['--list_content'], { encoding: 'utf8' });
  const lines = said.stderr.split('\n').map(l => /^( *)(\S.*?)\*?$/.exec(l)).filter(Boolean).map(m => ({ depth: m[1].length / 4, name: m[2] }));
  const above = [];
  return lines.flatMap((l, i) => {
    above.length = l.depth, above.push(l.name);
    return (lines[i + 1]?.depth ?? 0) > l.depth ? [] : [above.join('/')];
  });
}

/// Runs a unit with an error awake, or with none. @return { failed, seconds, said }
function trial(unit, k, limit) {
  return new Promise(resolve => {
    const began = Date.now();
    const env = { ...process.env, ...(k === null ? { ACTIO_MUTANTS_PASSED: path.join(copy, `passed_${unit.passed}`) } : { ACTIO_MUTANT: String(k) }) };
    execFile(path.join(work, 'bin', unit.program), unit.words, { env, timeout: Math.round(limit * 1000), killSignal: 'SIGKILL', maxBuffer: 1 << 26, cwd: copy }, (error, out, err) => {
      const text = `${out}\n${err}`;
      const names = [...text.matchAll(/^FAILED \w+ (\w+):|in "([^"]+)"/gm)].map(m => m[1] ?? m[2]);
      const how = error?.killed ? 'does not end' : error?.signal ? `ends with ${error.signal}` : [...new Set(names)].slice(0, 3).join('; ');
      resolve({ failed: !!error, seconds: (Date.now() - began) / 1000, said: how });
    });
  });
}

/// For each section of the checks the first error of the draw that it catches, as a line of mutations.tsv.
async function eachSource(planted, passedBy, times) {
  for (const unit of units().filter(u => u.program.startsWith('checks_'))) {
    let line = null, tried = 0;
    for (const m of planted.filter(p => passedBy.get(p.k)?.includes(unit))) {
      const text = textOf(m.file);
      if (/\n/.test(m.original)) continue;
      // The shortest text around it that occurs once, up to its line.
      const begin = text.lastIndexOf('\n', m.at) + 1, end = text.indexOf('\n', m.at);
      const whole = text.slice(begin, end).trim();
      const from = text.split(m.original).length === 2 ? m.original : whole;
      if (text.split(from).length !== 2) continue;
      ++tried;
      const r = await trial(unit, m.k, 20 + 10 * times.get(unit));
      if (!r.failed || !r.said) continue;
      const at = m.at - text.indexOf(from), to = from.slice(0, at) + m.mutated + from.slice(at + m.original.length);
      line = [m.file, from, to, `checks_${unit.name}`, `${m.rule}, drawn: ${m.shown[0].replace(/\s+/g, ' ')} becomes ${m.shown[1].trim() || 'nothing'}`].join('\t');
      break;
    }
    console.log(line ?? `# ${unit.name}: none of ${tried} errors that it comes by`);
  }
}

async function main() {
  const candidates = shuffled();
  console.log(`${candidates.length} places in ${new Set(candidates.map(c => c.file)).size} files; a sample of ${wanted} with the seed ${seed}`);
  makeCopy();
  let next = 0, number = 0, withdrawn = 0;
  let planted = [];
  // What was found to compile before need not be found again.
  const kept = path.join(copy, 'planted.json'), state = JSON.stringify(candidates.map(c => [c.file, c.at, c.original, c.mutated, c.operands]));
  const before = fs.existsSync(kept) ? JSON.parse(fs.readFileSync(kept, 'utf8')) : null;
  const again = before?.wanted === wanted && before.state === state;
  const overlaps = m => planted.some(p => p.file === m.file && m.at < p.end && p.at < m.end);
  const fill = () => {
    while (planted.length < wanted && next < candidates.length && number < slots) {
      const m = candidates[next++];
      if (!overlaps(m) && m.original !== m.mutated) planted.push({ ...m, k: number++ });
    }
    for (const file of sources()) writeFile(file, planted);
  };
  if (again) {
    ({ planted, next, number } = before);
    for (const file of sources()) writeFile(file, planted);
  } else fill();
  if (!fs.existsSync(path.join(work, 'build.ninja')))
    execFileSync('cmake', ['-S', copy, '-B', work, '-G', 'Ninja', '-DCMAKE_BUILD_TYPE=Release', '-DACTIO_BUILD_CHAPTERS=OFF', '-DACTIO_BUILD_BENCHMARKS=OFF'], { stdio: 'ignore' });
  const programs = [...chapters(), ...testPrograms];
  for (const targets of [chapters(), programs])
    for (;;) {
      const bad = compile(planted, targets);
      if (!bad) break;
      withdrawn += bad.size;
      console.log(`${bad.size} do not compile: withdrawn`);
      planted = planted.filter(m => !bad.has(m.k));
      // The last ones are not replaced: a new build for a handful is not worth its time.
      if (bad.size > wanted / 20 && targets !== programs) fill();
      else for (const file of sources()) writeFile(file, planted);
    }
  fs.writeFileSync(kept, JSON.stringify({ wanted, state, planted, next, number }));
  console.log(`${planted.length} planted, ${withdrawn} did not compile`);

  const times = new Map(), passedBy = new Map(), ofNumbers = new Set();
  const toPass = [...units()];
  const pass = async () => {
    for (let unit; (unit = toPass.shift());) {
      const passed = path.join(copy, `passed_${unit.passed}`);
      // A program that comes by no place of the sample writes none.
      fs.writeFileSync(passed, '');
      const plain = await trial(unit, null, 600);
      if (plain.failed) {
        // A program that is compiled otherwise rounds otherwise.
        console.log(`left out, since it fails with no error awake: ${unit.name} ${unit.words.at(-1)}`);
        continue;
      }
      times.set(unit, plain.seconds);
      for (const k of fs.readFileSync(passed, 'utf8').split('\n').filter(Boolean).map(l => l.split(' ').map(Number))) {
        if (k[1] & 1) passedBy.set(k[0], [...(passedBy.get(k[0]) ?? []), unit]);
        else ofNumbers.add(k[0]);
      }
    }
  };
  const workers = Math.max(1, Math.min(Number(jobs), os.cpus().length));
  await Promise.all(Array.from({ length: workers }, pass));

  if (words.includes('--each-source')) return eachSource(planted, passedBy, times);
  const explained = new Map();
  const list = path.join(root, 'proofs_checks/mutate/equivalent.tsv');
  if (fs.existsSync(list))
    for (const line of fs.readFileSync(list, 'utf8').split('\n').filter(l => l && !l.startsWith('#'))) {
      const [file, original, mutated, why] = line.split('\t');
      explained.set([file, original, mutated].join('\t'), why);
    }
  const flat = s => s.replace(/\s+/g, ' ').trim();
  const trials = path.join(copy, 'trials.jsonl'), done = new Map();
  if (changed || !fs.existsSync(trials)) fs.writeFileSync(trials, '');
  for (const line of fs.readFileSync(trials, 'utf8').split('\n').filter(Boolean)) {
    const { k, result, who } = JSON.parse(line);
    done.set(k, { result, who });
  }
  // What is explained changes nothing.
  const why = m => explained.get([m.file, flat(m.original), flat(m.mutated)].join('\t'));
  const settled = (m, { result, who }) => ({ ...m, ...(result !== 'caught' && why(m) ? { result: 'equivalent', who: why(m) } : { result, who }) });
  const results = planted.filter(m => done.has(m.k)).map(m => settled(m, done.get(m.k)));
  if (results.length) console.log(`${results.length} of them were tried before`);
  const queue = planted.filter(m => !done.has(m.k));
  const worker = async () => {
    for (let m; (m = queue.shift());) {
      const by = (passedBy.get(m.k) ?? []).sort((a, b) => times.get(a) - times.get(b));
      let result = by.length ? 'survived' : 'never reached', who = '';
      for (const unit of by) {
        const r = await trial(unit, m.k, 20 + 10 * times.get(unit));
        if (r.failed) { result = 'caught', who = `${unit.name}: ${r.said}`; break; }
      }
      if (result === 'never reached' && ofNumbers.has(m.k)) result = 'equivalent', who = 'a product of numbers';
      fs.appendFileSync(trials, `${JSON.stringify({ k: m.k, result, who })}\n`);
      results.push(settled(m, { result, who }));
      ({ result, who } = results.at(-1));
      console.log(`${String(results.length).padStart(4)} ${result.padEnd(13)} ${m.file}:${m.line} [${m.rule}] ${flat(m.shown[0])} -> ${flat(m.shown[1])}${who ? `  by ${who}` : ''}`);
    }
  };
  await Promise.all(Array.from({ length: workers }, worker));
  const report = path.join(build, 'report/mutation_sample.tsv');
  fs.mkdirSync(path.dirname(report), { recursive: true });
  fs.writeFileSync(report, `result\tby\trule\tfile\tline\toriginal\tmutated\n${results.map(r => [r.result, r.who, r.rule, r.file, r.line, flat(r.original), flat(r.mutated)].join('\t')).join('\n')}\n`);
  const count = what => results.filter(r => r.result === what).length;
  const counted = results.length - count('equivalent');
  console.log(`\n${count('caught')} of ${counted} caught (${(100 * count('caught') / counted).toFixed(1)} %), ${count('survived')} survived, ${count('never reached')} never reached, ${count('equivalent')} change nothing; ${report}`);
  process.exit(count('caught') >= 0.95 * counted ? 0 : 1);
}

if (words.includes('--list')) for (const m of shuffled().filter(c => c.original !== c.mutated).slice(0, wanted)) console.log(`${m.file}:${m.line} [${m.rule}] ${m.original.replace(/\s+/g, ' ')} -> ${m.mutated.replace(/\s+/g, ' ')}`);
else await main();
