// What a program reported, in HTML: its card, its tables, its pictures, and the table of all programs.
import { escapeHtml, labelled, number, prose } from './lib.mjs';
import { measured, originClass, originNote, originText } from './release.mjs';

// A column of figures, of which some may be missing.
const figures = (rows, i) => rows.every(r => numeric(r[i]) || r[i] === '') && rows.some(r => numeric(r[i]));
const numeric = s => /^[-+−]?(\d|\.\d)/.test(String(s).trim());
const power = (mantissa, exponent) => `${mantissa.replace('-', '−')}·10<sup>${String(Number(exponent)).replace('-', '−')}</sup>`;
/// The text of a cell. Where one of its numbers is a power of ten, so are the others that are as small or as large.
function cellText(s) {
  const text = String(s).trim(), withPower = /(?<![\w.$])([-+]?\d+(?:\.\d+)?)[eE]([-+]?\d+)(?![\w.])/g;
  if (!withPower.test(text) || /\$|`/.test(text)) return prose(s);
  return escapeHtml(text).replace(/ (?=kg\b|m²)/g, '\u00a0').replace(withPower, (_, mantissa, exponent) => power(mantissa, exponent)).replace(/(?<![\w.·&#;<>])0\.0\d+(?![\w.<])/g, plain => {
    const digits = plain.replace(/^0\.0+/, '').length;
    return power(...Number(plain).toExponential(digits - 1).split('e'));
  });
}

/// The words under a table or a picture, and whether it is of a short run or of the release.
const captionText = (caption, report) => [prose(caption ?? ''), originNote(report)].filter(Boolean).join(' ');

/// @param report  where it comes from
export function reportTable(t, caption, report = {}) {
  const head = (t.header ?? []).map((h, i) => `<th${figures(t.rows ?? [], i) ? ' class="num"' : ''}>${prose(h)}</th>`).join('');
  const rows = (t.rows ?? []).map(r => `<tr>${r.map(c => `<td${numeric(c) ? ` class="num${String(c).trim().includes(' ') ? ' words' : ''}"` : ''}>${cellText(c)}</td>`).join('')}</tr>`).join('');
  const text = captionText(caption ?? t.caption, report);
  return `<div class="${`report-table ${originClass(report)}`.trim()}"><table><thead><tr>${head}</tr></thead><tbody>${rows}</tbody></table>${text ? `<div class="caption">${text}</div>` : ''}</div>`;
}

/// An SVG file as part of the page, so that it takes the colours of the theme; its ids are made unique to the page.
export function inlineSvg(svg, caption, prefix, report = {}) {
  svg = svg.replace(/<\?xml[^>]*\?>/g, '').replace(/<!DOCTYPE[^>]*>/gi, '').replace(/<!--[\s\S]*?-->/g, '').trim();
  for (const id of new Set([...svg.matchAll(/\bid="([^"]+)"/g)].map(m => m[1]))) {
    svg = svg.replaceAll(`id="${id}"`, `id="${prefix}-${id}"`).replaceAll(`url(#${id})`, `url(#${prefix}-${id})`).replaceAll(`href="#${id}"`, `href="#${prefix}-${id}"`);
  }
  svg = svg.replace(/^<svg\b([^>]*)>/, (_, attributes) => {
    const size = /viewBox=/.test(attributes) ? '' : (() => { const w = /\bwidth="([\d.]+)/.exec(attributes), h = /\bheight="([\d.]+)/.exec(attributes); return w && h ? ` viewBox="0 0 ${w[1]} ${h[1]}"` : ''; })();
    const width = /\bwidth="([\d.]+)/.exec(attributes) ?? /viewBox="[-\d.]+[ ,]+[-\d.]+[ ,]+([\d.]+)/.exec(attributes);
    // Its name is its own title, else the words below it.
    const said = /<title\b/.test(svg) || /aria-label=/.test(attributes) ? '' : String(caption ?? '').replace(/\\[()]|\$|`/g, '').trim();
    return `<svg${attributes.replace(/\s(width|height)="[^"]*"/g, '')}${size} role="img"${said ? ` aria-label="${escapeHtml(said)}"` : ''} style="max-width:${width ? width[1] : 640}px">`;
  });
  const text = captionText(caption, report);
  return `<figure class="${`picture ${originClass(report)}`.trim()}">${svg}${text ? `<figcaption>${text}</figcaption>` : ''}</figure>`;
}

/// What a program claims: each with the measured figure and its bound.
export function claimList(report) {
  const items = (report.claims ?? []).map(c => `<li class="${c.holds ? 'holds' : 'fails'}">${prose(c.text)}${c.measured ? ` <span class="claimed">${cellText(c.measured.replace(/(?<![<>]) ([<>]) /g, ' $1 '))}</span>` : ''}</li>`);
  return items.length ? `<ul class="claims">${items.join('')}</ul>` : '';
}

/// @param headers  those of the chapters that it includes
export function programCard(book, name, report, src, headers = []) {
  const shows = report ? prose(report.shows) : '';
  const headline = report?.headline ? `<span class="headline">${prose(report.headline.text)}</span>` : '';
  const output = report ? (report.output === null ? '<p class="notrun">the output was not kept</p>' : `<pre class="output">${escapeHtml(report.output.trimEnd())}</pre>`) : '<p><span class="notrun">not run in this build</span></p>';
  return {
    before: `<div class="program" id="program_${name}"><div class="program-head"><span class="program-name">${escapeHtml(name)}</span>${book.sourceLink(src.path, 1, escapeHtml(src.path))}</div>${shows ? `<p class="program-shows">${shows}${headline ? ` ${headline}` : ''}</p>` : ''}${report ? claimList(report) : ''}<details class="said"><summary>What it prints</summary>${output}</details>${headers.length ? `<p class="program-headers">Its physics is in ${headers.map(h => book.sourceLink(h.path, 1, escapeHtml(h.name))).join(', ')} as well, shown below it.</p>` : ''}<details><summary>The program, ${src.lines} lines</summary>`,
    after: '</details></div>',
  };
}

/// Table of the programs, all or of the chapters listed.
export function programTable(book, chapters) {
  if (!book.programs) return '<p><span class="notrun">the chapter programs have not been run in this build</span></p>';
  const wanted = chapters ? chapters.split(',').map(c => Number(c)) : null;
  const list = [...book.programs.values()].filter(p => !wanted || wanted.includes(Number(/\d+/.exec(p.chapter ?? p.program)[0])));
  const rows = list.map(p => {
    const src = book.programSource(p.program);
    const name = book.programPlaces.has(p.program) ? `<a href="@ref:program_${p.program}">${escapeHtml(p.program)}</a>` : src ? book.sourceLink(src.path, 1, escapeHtml(p.program)) : escapeHtml(p.program);
    return `<tr>${labelled([`<td class="id">${name}</td>`, `<td>${prose(p.shows)}</td>`, `<td>${prose(p.headline?.text ?? '')}</td>`, `<td class="num">${p.seconds === undefined ? '' : `${number(p.seconds)} s`}</td>`], ['', '', 'measured', 'time'])}</tr>`;
  });
  return `<table class="programs stacked"><thead><tr><th>program</th><th>what it shows</th><th>measured</th><th class="num">time</th></tr></thead><tbody>${rows.join('')}</tbody></table>`;
}

/// The targets in lines of a page, `\target{program,figure,at most,0.6}`: one a line.
export const targetsOf = lines => lines.flatMap(l => {
  const m = /\\target\{([^}]*)\}/.exec(l.replace(/`[^`]*`/g, ''));
  if (!m) return [];
  const [program, name, side = '', bound] = m[1].split(',').map(s => s.trim());
  return [{ program, name, side, bound: bound ? Number(bound) : NaN }];
});
export const targetReached = (value, side, bound) => (side === 'at most' ? value <= bound : value >= bound);
/// Said of a target; a short run has fewer rounds, in which other work of the machine shows more.
export const targetBadge = (reached, report) =>
  reached ? '<span class="verdict verdict-holds">reached</span>' : `<span class="verdict verdict-corrected" title="${report.short && !report.release ? 'a short run measured' : 'measured'} beyond the target">missed</span>`;

/// The benchmarks: what each shows, what it measured and when, and the claims that did not hold.
/// @param missed  how many targets of the page each program missed
export function benchmarkTable(book, names, missed = new Map()) {
  const rows = names.map(n => {
    const p = measured(book, n);
    if (!p) return `<tr><td class="id">${escapeHtml(n)}</td><td colspan="4"><span class="notrun">not run</span></td></tr>`;
    const date = p.release?.date ?? (p.figures ?? []).find(f => f.name === 'date')?.text ?? `${new Date(p.written).toISOString().slice(0, 16).replace('T', ' ')} UTC`;
    const how = p.release ? ', of the release' : p.short ? ', short' : '';
    const broken = (p.claims ?? []).filter(c => !c.holds);
    const beyond = missed.get(n) ? `${missed.get(n)} target${missed.get(n) > 1 ? 's' : ''} of the table below missed` : '';
    const claimed = broken.length ? broken.map(c => `${p.short ? '<span class="verdict verdict-corrected" title="a time of a short run beyond its bound">missed</span>' : '<span class="verdict verdict-failed">failed</span>'} ${prose(c.text)}`).join('<br/>') : (p.claims ?? []).length ? 'all claims hold' : '';
    const claims = [claimed, beyond].filter(Boolean).join('<br/>');
    const said = originText(p);
    return `<tr${said ? ` class="${originClass(p)}" title="${escapeHtml(said)}"` : ''}>${labelled([`<td class="id">${escapeHtml(n)}</td>`, `<td>${prose(p.shows)}</td>`, `<td class="measured">${prose(p.headline?.text ?? '')}</td>`, `<td>${claims}</td>`, `<td class="num">${escapeHtml(date + how)}</td>`], ['', '', 'measured', 'claims', 'run'])}</tr>`;
  });
  return `<table class="programs stacked"><thead><tr><th>program</th><th>what it measures</th><th>measured</th><th>claims</th><th class="num">run</th></tr></thead><tbody>${rows.join('')}</tbody></table>`;
}
