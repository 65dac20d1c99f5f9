// proofs.mjs ROOT BUILD JOBS: has the proofs of proofs_checks/kernel checked, in BUILD/kernel.
//
// Compiles the sources (coqc), has the compiled files checked once more by the separate checker (coqchk),
// which lists the axioms that they and all they rest on use, and asks of each theorem what it assumes. Writes
// BUILD/report/kernel.tsv. What the definitions give on samples, which values.v prints, goes to
// BUILD/report/kernel_values.tsv and is compared with proofs_checks/kernel/values.tsv, which the library is
// tested against. Status 1 where a source does not compile, an axiom is used, a proof is admitted, a value is
// not the recorded one, or the table of seals does not fit the theorems.
import { execFileSync, spawn } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';

import { digest, folder, proofFiles, readSeals, sealComplaints, theorems, withoutComments, writeList } from '../../docs/tools/kernel.mjs';
import { readRegistry } from '../../docs/tools/lib.mjs';

const [root, buildArgument, jobs] = process.argv.slice(2);
const build = path.resolve(buildArgument), work = path.join(build, 'kernel');
const flags = ['-Q', '.', 'actio', '-w', '-notation-overridden,-ambiguous-paths'];
const fail = text => { console.error(`proofs: ${text}`); process.exit(1); };

const files = proofFiles(root);
if (!files.length) fail(`${folder}/_CoqProject names no source`);
const there = fs.readdirSync(path.join(root, folder)).filter(f => f.endsWith('.v'));
for (const f of there) if (!files.includes(f)) fail(`${folder}/${f} is not in _CoqProject`);

// What each source prints into files of its own.
const printed = new Map(files.map(f => [f, [...fs.readFileSync(path.join(root, folder, f), 'utf8').matchAll(/^Redirect "(\w+)"/gm)].map(m => `${m[1]}.out`)]));

fs.mkdirSync(work, { recursive: true });
for (const old of fs.readdirSync(work)) if (!files.includes(`${old.split('.')[0]}.v`) && ![...printed.values()].flat().includes(old) && !/^(build\.ninja|\.ninja)/.test(old)) fs.rmSync(path.join(work, old), { recursive: true });
for (const f of files) {
  const text = fs.readFileSync(path.join(root, folder, f), 'utf8'), copy = path.join(work, f);
  if (/\b(Axioms?|Parameters?|Conjecture|Admitted|admit|Abort)\b/.test(withoutComments(text))) fail(`${f} assumes or admits something`);
  if (!fs.existsSync(copy) || fs.readFileSync(copy, 'utf8') !== text) fs.writeFileSync(copy, text);
}

// ---- Compile, those first that others need

const needs = new Map(files.map(f => [f, []]));
for (const m of execFileSync('coqdep', ['-Q', '.', 'actio', ...files], { cwd: work, encoding: 'utf8' }).matchAll(/^(\w+)\.vo\b[^:]*:(.*)$/gm))
  needs.set(`${m[1]}.v`, [...m[2].matchAll(/\b(\w+)\.vo\b/g)].map(d => `${d[1]}.v`).filter(d => files.includes(d)));
fs.writeFileSync(path.join(work, 'build.ninja'), `rule prove
  command = coqc ${flags.join(' ')} $in
  description = prove $in
${files.map(f => `build ${[`${f}o`, ...printed.get(f)].join(' ')}: prove ${f} | ${needs.get(f).map(d => `${d}o`).join(' ')}`).join('\n')}
`);
const run = (program, words) => new Promise(resolve => {
  const child = spawn(program, words, { cwd: work });
  let said = '';
  child.stdout.on('data', d => said += d), child.stderr.on('data', d => said += d);
  child.on('close', status => resolve({ status, said }));
});
let done = await run('ninja', ['-j', jobs, '--quiet']);
if (done.status !== 0) { process.stderr.write(done.said); fail('a proof does not compile'); }

// ---- The values of the definitions

const texts = (printed.get('values.v') ?? []).map(f => /^\s*= "([\s\S]*)"(?:%string)?\s*: string\s*$/.exec(fs.readFileSync(path.join(work, f), 'utf8'))?.[1] ?? fail(`${f} holds no text`));
if (texts.length) {
  const rows = texts.flatMap(t => t.split('\n')).filter(Boolean).map(l => l.split(' ')).map(w => [...w.slice(0, 5), w.slice(5).join(' ')].join('\t'));
  const written = `definition\tsample\trole\trows\tcolumns\tentries\n${rows.join('\n')}\n`;
  const fresh = path.join(build, 'report/kernel_values.tsv'), kept = path.join(root, folder, 'values.tsv');
  fs.mkdirSync(path.dirname(fresh), { recursive: true });
  fs.writeFileSync(fresh, written);
  const recorded = fs.existsSync(kept) ? fs.readFileSync(kept, 'utf8') : '';
  if (recorded !== written) {
    const now = written.split('\n'), then = recorded.split('\n'), k = now.findIndex((l, i) => l !== then[i]);
    const [name, sample] = ((k < 0 ? then[now.length] : now[k]) || then[k] || '').split('\t');
    fail(`the values of the definitions are not those of ${folder}/values.tsv, which the library is tested against; the first that differs is ${name}${sample ? ` on sample ${sample}` : ''}. Where the change is meant, \`cp ${fresh} ${kept}\` records the new values`);
  }
}

// ---- The checker, and beside it what each theorem assumes

const ids = new Set(readRegistry(path.join(root, 'proofs_checks/registry.tsv')).map(s => s.id)), list = theorems(root, ids);
const twice = list.find((t, i) => list.findIndex(o => o.name === t.name) !== i);
if (twice) fail(`${twice.name} is the name of two theorems`);
const complaints = sealComplaints(readSeals(root), list);
if (complaints.length) fail(`${folder}/seals.tsv does not fit the theorems:\n  ${complaints.join('\n  ')}`);
const modules = files.map(f => f.replace(/\.v$/, ''));
const asked = path.join(work, 'assumptions');
fs.mkdirSync(asked, { recursive: true });
fs.writeFileSync(path.join(asked, 'assumptions.v'), `From actio Require ${modules.join(' ')}.
${list.map(t => `Goal True. idtac "@@ ${t.name}". Abort.\nPrint Assumptions ${t.file.replace(/\.v$/, '')}.${t.name}.`).join('\n')}
`);
const [checked, answer] = await Promise.all([
  run('coqchk', ['-silent', '-o', '-Q', '.', 'actio', ...modules.map(m => `actio.${m}`)]),
  run('coqc', ['-Q', '.', 'actio', '-w', 'none', 'assumptions/assumptions.v'])]);
fs.writeFileSync(path.join(build, 'report/kernel_coqchk.txt'), checked.said);
if (checked.status !== 0) { process.stderr.write(checked.said); fail('the checker objects'); }
const axioms = /\* Axioms:\s*([\s\S]*?)\n\s*\n/.exec(checked.said)?.[1].trim() ?? 'not told';
if (axioms !== '<none>') { process.stderr.write(checked.said); fail(`axioms are used: ${axioms}`); }
if (answer.status !== 0) { process.stderr.write(answer.said); fail('the assumptions could not be asked for'); }
const assumed = new Map(answer.said.split(/^@@ /m).slice(1).map(part => [/^\w+/.exec(part)[0], part.replace(/^\w+\s*/, '').trim()]));
for (const t of list) {
  t.assumptions = assumed.get(t.name) === 'Closed under the global context' ? 'none' : assumed.get(t.name)?.replace(/\s+/g, ' ') ?? 'not told';
  if (t.assumptions !== 'none') fail(`${t.name} (${t.file}:${t.line}) rests on more than the kernel: ${t.assumptions}`);
}

const version = execFileSync('coqc', ['--print-version'], { encoding: 'utf8' }).split(' ')[0];
let mathcomp = '';
try { mathcomp = execFileSync('dpkg-query', ['-W', '-f', '${Version}', 'libcoq-mathcomp-algebra'], { encoding: 'utf8' }).replace(/-.*/, ''); } catch { /* not a Debian system */ }
writeList(path.join(build, 'report/kernel.tsv'), list, {
  sources: digest(root), checked: `the kernel of Coq ${version} and its checker coqchk${mathcomp ? `, with mathcomp ${mathcomp}` : ''}`, axioms: 'none' });
const of = what => new Set(list.filter(t => t.what === what).map(t => t.id)).size;
console.log(`${of('proved')} statements proved, ${of('refuted')} prints refuted, ${list.filter(t => t.what === 'beyond').length} beyond; no axiom`);
