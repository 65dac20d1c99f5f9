// record.mjs --build BUILD --commit COMMIT [--what "bench stress checks proofs"] [--root ROOT]: records the
// figures of the release in docs/release.
//
// Of the benchmarks and long tests those are recorded whose last full run was made with the executable as it
// is now (cmake/tools/measure.sh --ask knows); of the checks all columns that `./run` does not fill; of the
// proofs the list that the kernel has checked, where it is of the sources as they are. What was
// recorded before and is not current now stays, and is named. Status 1 where a page shows figures of a
// program that is neither current nor recorded before.
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';

import {digest, readList} from './kernel.mjs';
import {optionalPrograms, options, walk} from './lib.mjs';
import {measuredAt, packChecks, quickColumns} from './release.mjs';

const opt = options({build: 'build', commit: '', what: 'bench stress checks proofs', root: '.'});
const target = path.join(opt.root, 'docs/release');
const what = opt.what.split(/\s+/).filter(Boolean);

const compiler = (() => {
  const file = walk(path.join(opt.build, 'CMakeFiles')).find(f => f.endsWith('CMakeCXXCompiler.cmake'));
  const value = name =>
      new RegExp(`set\\(${name} "([^"]*)"\\)`).exec(file ? fs.readFileSync(file, 'utf8') : '')?.[1];
  const id = value('CMAKE_CXX_COMPILER_ID');
  return id ? `${id === 'GNU' ? 'GCC' : id} ${value('CMAKE_CXX_COMPILER_VERSION')}` : 'an unknown compiler';
})();
const at = time => ({
  date: `${new Date(time).toISOString().slice(0, 16).replace('T', ' ')} UTC`,
  processor: `${os.cpus()[0]?.model.trim() ?? 'an unknown processor'}, ${os.cpus().length} cores`,
  compiler,
  commit: opt.commit,
});

const missing = [];
/// Programs whose figures a page shows.
const shown = new Set(
    [...walk(path.join(opt.root, 'docs/pages')), ...walk(path.join(opt.root, 'chapters'))]
        .filter(f => f.endsWith('.md'))
        .flatMap(
            f => [...fs.readFileSync(f, 'utf8').matchAll(/\\(?:figure|table|picture)\{\s*(\w+)/g)].map(
                m => m[1])));
/// One member a line, so that two releases can be compared.
const lines = object => `{\n${
    Object.entries(object).map(([k, v]) => ` ${JSON.stringify(k)}: ${JSON.stringify(v)}`).join(',\n')}\n}\n`;

for (const [kind, prefix, folder] of [['bench', 'bench', 'benchmarks'], ['stress', 'stress', 'stress']]) {
  if (!what.includes(kind)) continue;
  const to = path.join(target, folder), from = path.join(opt.build, 'report', optionalPrograms[prefix]);
  fs.mkdirSync(to, {recursive: true});
  const names = fs.readdirSync(path.join(opt.root, optionalPrograms[prefix]))
                    .filter(f => f.endsWith('.cpp'))
                    .map(f => `${prefix}_${path.basename(f, '.cpp')}`);
  for (const old of fs.readdirSync(to))
    if (!names.includes(old.split('.')[0])) fs.rmSync(path.join(to, old));
  for (const name of names) {
    const file = path.join(from, `${name}.json`), kept = path.join(to, `${name}.json`);
    const state =
        execFileSync('bash', [path.join(opt.root, 'cmake/tools/measure.sh'), opt.build, name, '--ask'], {
          encoding: 'utf8'
        }).trim();
    if (state !== 'full' || !fs.existsSync(file)) {
      if (fs.existsSync(kept))
        console.log(`${name}: no full run of the executable as it is; the record stays that of ${
            measuredAt(JSON.parse(fs.readFileSync(kept, 'utf8')).release)}`);
      else if (shown.has(name))
        missing.push(`${
            name}: never recorded, and there is no full run of the executable as it is; type ./run ${kind}`);
      continue;
    }
    const report = JSON.parse(fs.readFileSync(file, 'utf8'));
    for (const old of fs.readdirSync(to))
      if (old.startsWith(`${name}.`)) fs.rmSync(path.join(to, old));
    for (const picture of report.pictures ?? [])
      fs.copyFileSync(path.join(from, picture.file), path.join(to, picture.file));
    fs.writeFileSync(kept, lines({...report, release: at(fs.statSync(file).mtimeMs)}));
    console.log(`${name}: recorded`);
  }
}

if (what.includes('checks')) {
  const file = path.join(opt.build, 'report/statements.json'), kept = path.join(target, 'checks.json');
  const statements = fs.existsSync(file) ? JSON.parse(fs.readFileSync(file, 'utf8')) : [];
  const columns = [...new Set(statements.flatMap(s => (s.evidence ?? []).map(e => e.scalar)))]
                      .filter(c => !quickColumns.includes(c))
                      .sort();
  const before = fs.existsSync(kept) ? JSON.parse(fs.readFileSync(kept, 'utf8')) : null;
  if (columns.length && (before?.columns ?? []).every(c => columns.includes(c))) {
    fs.mkdirSync(target, {recursive: true});
    const {fields, words, statements: packed} = packChecks(statements, columns);
    const rows =
        Object.entries(packed).map(([id, s]) => `  ${JSON.stringify(id)}: ${JSON.stringify(s)}`).join(',\n');
    fs.writeFileSync(
        kept,
        `{\n "release": ${JSON.stringify(at(fs.statSync(file).mtimeMs))},\n "columns": ${
            JSON.stringify(columns)},\n "fields": ${JSON.stringify(fields)},\n "words": ${
            JSON.stringify(words)},\n "statements": {\n${rows}\n }\n}\n`);
    console.log(`checks: recorded in ${columns.join(', ')}`);
  } else if (before)
    console.log(`checks: this build has run fewer columns than are recorded; the record stays that of ${
        measuredAt(before.release)}`);
  else
    missing.push('checks: never recorded, and no column beyond those of ./run is there; type ./run test --all');
}

if (what.includes('proofs')) {
  const list = path.join(opt.build, 'report/kernel.tsv'), kept = path.join(target, 'kernel.tsv');
  const current = file => readList(file)?.facts.sources === digest(opt.root);
  if (current(list)) {
    fs.copyFileSync(list, kept);
    console.log('proofs: recorded');
  } else if (!current(kept))
    missing.push('proofs: the kernel has not checked them as they stand; type ./run proofs');
}

for (const m of missing) console.error(m);
process.exit(missing.length ? 1 : 0);
