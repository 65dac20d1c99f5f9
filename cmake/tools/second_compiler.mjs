// second_compiler.mjs BUILD JOBS: reads every unit that BUILD compiles with clang as well, and makes nothing.
//
// A second compiler sees what the first lets pass: a pointer to what is gone, one `auto` for two types, an
// extension that our users' compilers lack. Status 1 where clang refuses a unit or warns, 2 where
// ACTIO_CLANG names what is no clang of version 16 at least; where none is installed, it says so and passes.
import { execFileSync, spawn } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';

const [build, jobs] = [path.resolve(process.argv[2]), Number(process.argv[3])];
const least = 16;

// Not what is a matter of taste, or what clang says of headers that are not ours.
const warnings = ['all', 'extra', 'no-unused-lambda-capture', 'no-overloaded-virtual', 'no-unused-value',
  'no-deprecated-declarations', 'no-unknown-warning-option'].map(name => `-W${name}`);

function version(clang) {
  try {
    return Number(/clang version (\d+)/.exec(execFileSync(clang, ['--version'], { encoding: 'utf8' }))?.[1] ?? 0);
  } catch {
    return 0;
  }
}
const named = process.env.ACTIO_CLANG;
const candidates = named ? [named] : [...Array(10).keys()].map(k => `clang++-${25 - k}`).concat('clang++');
const clang = candidates.find(name => version(name) >= least);
if (!clang && named) {
  console.error(`ACTIO_CLANG names ${named}, which is no clang of version ${least} or later`);
  process.exit(2);
}
if (!clang) {
  console.log(`no clang of version ${least} or later is installed`);
  process.exit(0);
}

const work = fs.mkdtempSync(path.join(os.tmpdir(), 'actio-clang-'));
process.on('exit', () => fs.rmSync(work, { recursive: true, force: true }));
const run = command => new Promise(done => {
  const child = spawn('bash', ['-c', command], { cwd: build });
  let said = '';
  child.stdout.on('data', text => said += text);
  child.stderr.on('data', text => said += text);
  child.on('close', status => done({ status, said }));
});

// What GCC was told that clang is to know: definitions, folders, the language.
const told = command => command.match(/(?<=\s)(-D\w+(=("(\\.|[^"])*"|\S+))?|-I\S+|-isystem \S+|-std=\S+|-UNDEBUG)/g).join(' ');
// GCC's precompiled headers are nothing to clang: each is compiled anew, once.
const precompiled = new Map();
function headers(command) {
  const header = /-include (\S+\/cmake_pch\.hxx)/.exec(command)?.[1];
  if (!header) return Promise.resolve('');
  if (!precompiled.has(header)) {
    const made = path.join(work, `${precompiled.size}.pch`);
    precompiled.set(header, run(`${clang} ${told(command)} -w -x c++-header ${header} -o ${made}`).then(({ status, said }) => {
      if (status) throw new Error(`${header}:\n${said}`);
      return `-include-pch ${made}`;
    }));
  }
  return precompiled.get(header);
}

const units = JSON.parse(fs.readFileSync(path.join(build, 'compile_commands.json'), 'utf8'))
  .filter(unit => /\.(cpp|cxx)$/.test(unit.file) && !/\/(precompiled\.cpp|cmake_pch\.hxx\.cxx)$/.test(unit.file))
  // A unit of a chapter's checks holds those of the sections, which have programs of their own, too.
  .filter(unit => !/-o \S*checks_(ch\d+_|bridge_)\S*\.dir\//.test(unit.command));
// Sources that the build writes are brought up to date first.
const written = units.map(unit => path.relative(build, unit.file)).filter(file => !file.startsWith('..') && !/\/Unity\//.test(file));
if (written.length) execFileSync('ninja', ['--quiet', '-C', build, ...written]);

let next = 0, refused = 0;
async function worker() {
  while (next < units.length) {
    const unit = units[next++];
    const { status, said } = await run(`${clang} ${told(unit.command)} ${warnings.join(' ')} ${await headers(unit.command)} -fsyntax-only ${unit.file}`);
    if (status || /\bwarning:/.test(said)) {
      refused++;
      console.error(`${path.relative(build, unit.file)}\n${said.trimEnd()}\n`);
    }
  }
}
await Promise.all(Array.from({ length: jobs }, worker));
if (refused) {
  console.error(`${clang} refuses or warns of ${refused} of ${units.length} units, as said above`);
  process.exit(1);
}
console.log(`${units.length} units read by ${clang}`);
