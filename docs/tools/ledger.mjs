// The ledger in HTML: evidence under a statement, the page of all statements, the counts, the errata.
import { badge, boxed, columnNames, columnOrder, controlRatio, escapeHtml, inEpsilons, label, labelled, number, ratioText, shortLabel, verdictText, worst } from './lib.mjs';
import { smallPrint as prose } from './small_print.mjs';
import { proved, seal } from './kernel.mjs';
import { measuredAt, withRelease } from './release.mjs';

export function verdictOf(book, id) {
  if (!book.statements) return 'notrun';
  const r = book.statements.get(id);
  return !r ? 'pending' : r.failures?.length || !r.verdict ? 'failed' : r.verdict;
}

/// What a statement says: the check's own words where there is a check, else its subject.
const subject = (book, s) => prose((verdictOf(book, s.id) !== 'pending' && book.statements?.get(s.id)?.title) || s.title || s.subject);

/// The number alone, and the words where claims of one section share it.
const nameOf = id => (id.startsWith('claim_') ? label(id) : shortLabel(id));
const statementLink = (id, text) => `<a href="@ref:${id}">${text ?? label(id)}</a>`;
const display = tex => `<div class="formula">\\[ ${escapeHtml(tex)} \\]</div>`;

/// What stands at the foot of a statement's box: the convention it needs, or what was wrong with it.
export function verdictNote(book, id) {
  const r = book.statements?.get(id);
  if (r?.failures?.length) return `<div class="statement-note note-failed"><b>Failed.</b> ${r.failures.map(f => prose(f)).join('<br/>')}</div>`;
  if (!r || r.verdict === 'holds' || r.verdict === 'pending' || !(r.note || r.corrected)) return '';
  const lead = { convention: 'Convention', corrected: 'Corrected', scope: 'Scope' }[r.verdict] ?? r.verdict;
  const more = r.verdict === 'corrected' || r.verdict === 'convention' ? ` <a href="@ref:erratum_${id}">errata</a>` : '';
  return `<div class="statement-note note-${r.verdict}"><b>${lead}.</b> ${prose(r.note)}${more}</div>`;
}

// ---- Evidence

function cell(e) {
  if (e.kind === 'order') {
    const slope = Number(e.slope).toFixed(3), spread = Number(e.spread);
    const steps = (e.steps ?? []).length;
    const errors = (e.errors ?? []).map(x => Number(x).toExponential(1)).join(', ');
    return `<span title="${escapeHtml(`fitted over ${steps} step sizes${errors ? `; errors ${errors}` : ''}`)}">${slope}${spread ? ` ± ${number(spread)}` : ''}</span>`;
  }
  if (e.kind === 'enclosure') return `<span title="${escapeHtml(`on the whole set, in ${e.points} box${e.points === 1 ? '' : 'es'}; margin ${number(e.margin)}`)}">decided, ${e.points}&#8239;box${e.points === 1 ? '' : 'es'}</span>`;
  if (e.kind === 'exact' || e.scalar === 'rational' || e.scalar === 'prime') {
    const bound = Number(e.probability) > 0 && Number(e.probability) < 1 ? `a false identity passes with probability below ${Number(e.probability).toExponential(0)}` : '';
    const what = Number(e.measured) === 0 ? '0' : number(e.measured);
    const points = e.points ? `, ${e.points}&#8239;pt` : '';
    return `<span title="${escapeHtml([e.degree ? `degree at most ${e.degree}` : '', bound].filter(Boolean).join('; '))}">${what}${points}</span>`;
  }
  return `<span title="${escapeHtml(`${Number(e.measured).toExponential(2)}, allowed ${Number(e.bound).toExponential(1)}`)}">${inEpsilons(e.measured, e.epsilon)}</span>`;
}

function allowed(entries) {
  const e = entries.find(x => x.kind === 'precision') ?? entries[0];
  if (e.kind === 'order') return Number(e.bound) ? `± ${number(e.bound)}` : '–';
  if (e.kind === 'exact') return '0';
  if (e.kind === 'enclosure') return 'all of it';
  return inEpsilons(e.bound, e.epsilon);
}

function merge(a, b) {
  if (!a) return b;
  if (a.kind === 'order') return Math.abs(b.slope - Math.round(b.slope)) > Math.abs(a.slope - Math.round(a.slope)) ? b : a;
  return { ...(Number(b.measured) > Number(a.measured) ? b : a), points: (a.points ?? 0) + (b.points ?? 0), probability: Math.max(a.probability ?? 0, b.probability ?? 0) };
}

/// Rows by what was compared (and by model, where wanted), in the order of the report, each with one entry per scalar: the worst.
function rows(entries, byModel) {
  const table = new Map();
  for (const e of entries ?? []) {
    const key = [e.what, e.kind === 'order' || e.kind === 'enclosure' ? e.kind : '', byModel ? e.model : ''].join('\u0001');
    if (!table.has(key)) table.set(key, { what: e.what, kinds: new Set(), models: new Set(), cells: new Map(), floor: Number(e.floor) });
    const row = table.get(key);
    if (e.kind) row.kinds.add(e.kind);
    if (e.model) row.models.add(e.model);
    const scalar = e.scalar ?? '';
    // Of a control the smallest figure is the worst.
    row.cells.set(scalar, e.kind ? merge(row.cells.get(scalar), e) : !row.cells.has(scalar) || Number(e.measured) < Number(row.cells.get(scalar).measured) ? e : row.cells.get(scalar));
    if (e.floor !== undefined) row.floor = Math.max(row.floor, Number(e.floor));
  }
  return [...table.values()];
}

/// The table of measured figures under a statement.
export function evidence(book, id, anchor) {
  const idAttribute = anchor ? ` id="${id}"` : '';
  if (!book.statements) return `<div class="evidence evidence-notrun"${idAttribute}><span class="notrun">the check of ${label(id)} has not been run in this build</span></div>`;
  const r = book.statements.get(id);
  if (!r) return '';
  const source = book.checkSource(id);
  const where = source ? book.sourceLink(source.path, source.line, 'check') : '';
  if (r.verdict === 'pending' || !(r.evidence ?? []).length)
    return `<div class="evidence evidence-empty"${idAttribute}>${badge(r.verdict)} <span>${book.boxes.has(id) ? escapeHtml(verdictText[r.verdict]?.[1] ?? '') : prose(r.note) || escapeHtml(verdictText[r.verdict]?.[1] ?? '')}</span> ${where}</div>`;

  const { evidence: entries, control: broke, released } = withRelease(book, r);
  const here = new Set(entries.map(e => e.scalar));
  const columns = columnOrder.filter(c => here.has(c));
  const missing = ['dec50', 'dec100'].filter(c => !book.columns.has(c) && !here.has(c) && r.evidence.some(e => e.kind === 'precision'));
  const shown = columnOrder.filter(c => columns.includes(c) || missing.includes(c));
  const modelCell = row => row.models.size > 1 ? `<span title="${escapeHtml([...row.models].join(', '))}">${row.models.size} models</span>` : prose([...row.models][0]);
  const figure = (row, c) => {
    const e = row.cells.get(c);
    if (e) return `<td class="num${e.released ? ' from-release' : ''}">${cell(e)}</td>`;
    return missing.includes(c) && row.kinds.has('precision') ? '<td class="num notrun">not run</td>' : '<td class="num none">·</td>';
  };
  const controlColumn = shown.includes('double') ? 'double' : shown[0];
  const controlFigure = (row, c) => {
    const e = row.cells.get(c) ?? (c === controlColumn ? row.cells.get('') : undefined);
    return `<td class="num${e?.released ? ' from-release' : ''}">${e ? controlText(e) : '<span class="none">·</span>'}</td>`;
  };
  const head = first => `<thead><tr><th>${first}</th>${shown.map(c => `<th class="num">${columnNames[c]}</th>`).join('')}<th class="num">allowed</th></tr></thead>`;
  const measured = (list, first) => `<tbody class="measured">${list.map(row => `<tr><td>${first(row)}</td>${shown.map(c => figure(row, c)).join('')}<td class="num">${allowed([...row.cells.values()])}</td></tr>`).join('')}</tbody>`;
  const broken = (list, first) => list.length ? `<tbody class="control">${list.map(row => `<tr><td>${first(row)}</td>${shown.map(c => controlFigure(row, c)).join('')}<td class="num">&gt;&#8239;${number(row.floor)}</td></tr>`).join('')}</tbody>` : '';
  const said = row => `${prose(row.what)} <span class="kind">${modelCell(row)}${row.kinds.has('order') ? ', order' : ''}</span>`;
  const controls = rows(broke, false), all = rows(entries, false);
  const worstOnly = boxed(`<table class="evidence-table">${head('what is compared')}${measured(all, said)}${broken(controls, row => `${said(row)} <span class="kind">control</span>`)}</table>`);

  // Where models were merged, all figures unfold.
  let unfolded = '';
  if ([...all, ...controls].some(row => row.models.size > 1)) {
    const span = shown.length + 2;
    const part = (title, body) => `<tbody><tr class="what"><th colspan="${span}">${title}</th></tr></tbody>${body}`;
    const of = (list, what) => list.filter(row => row.what === what);
    const full = rows(entries, true), fullControls = rows(broke, true);
    const model = row => prose([...row.models][0] ?? '');
    unfolded = `<details><summary>by model</summary>${boxed(`<table class="evidence-table by-model">${head('model')}${[...new Set(full.map(row => row.what))].map(w => part(prose(w), measured(of(full, w), model))).join('')}${[...new Set(fullControls.map(row => row.what))].map(w => part(`${prose(w)} <span class="kind">control</span>`, broken(of(fullControls, w), model))).join('')}</table>`)}</details>`;
  }
  const foot = [
    r.left ? `<b>Not shown:</b> ${prose(r.left)}` : '',
    released.length ? `${released.map(c => columnNames[c] ?? c).join(' and ')}: <span class="figure from-release" title="${escapeHtml(`measured ${measuredAt(book.release.checks.release)}`)}">of the release</span>, until <code>./run test --all</code>` : '',
    missing.length ? `${missing.map(c => columnNames[c]).join(' and ')}: <span class="notrun">not run</span>` : '',
  ].filter(Boolean).map(s => `<span>${s}</span>`).join('');
  // What unfolds leaves the page: finish.mjs puts what stands between the marks into a script, which the page loads when the first table is opened.
  const without = `<noscript><p>A script makes the table; the worst figures stand in <a href="@ref:ledger_${book.byId.get(id).chapter}">the ledger</a> as well.</p></noscript>`;
  return `<details class="evidence"${idAttribute} data-more="${id}"><summary>${evidenceLine(book, r)}<span class="evidence-where">${where}</span></summary>${without}<!--more ${id}-->${foot ? `<div class="evidence-foot">${foot}</div>` : ''}${worstOnly}${unfolded}<!--/more--></details>`;
}

/// The largest of the draws, and the median where it is another one.
function controlText(e) {
  const median = Number(e.median);
  return `${number(e.measured)}${e.points > 1 && median > 0 && median < 0.9 * Number(e.measured) ? ` <span class="median" title="median of ${e.points} draws">(${number(median)})</span>` : ''}`;
}

/// Kinds of evidence, the strongest first.
const strength = ['proof', 'exact', 'enclosure', 'precision', 'order'];
const kindsOf = r => [...new Set((r?.evidence ?? []).map(e => e.kind))].sort((a, b) => strength.indexOf(a) - strength.indexOf(b));
/// The strongest kind: a proof where a kernel has checked one of the whole statement.
const strongest = (book, id) => (proved(book, id) === 'whole' ? 'proof' : kindsOf(book.statements?.get(id))[0]);
/// By which the ledger sorts: the strongest kind; half a step more where a part of it is proved, half a step less where the
/// check says what it leaves; 0 without evidence.
function rankOf(book, id) {
  const kind = strongest(book, id), left = book.statements?.get(id)?.left;
  return kind ? strength.length - strength.indexOf(kind) + (kind !== 'proof' && proved(book, id) ? 0.5 : 0) - (kind !== 'proof' && left ? 0.5 : 0) : 0;
}
const leftOf = r => (r?.left ? `<div class="ledger-note ledger-left"><b>Not shown:</b> ${prose(r.left)}</div>` : '');

/// Evidence in a line: verdict, strongest kind, worst residual, least control.
function evidenceLine(book, r) {
  const kind = strength.find(k => r.evidence.some(e => e.kind === k)) ?? r.evidence[0].kind;
  const of = r.evidence.filter(e => e.kind === kind), models = new Set(r.evidence.map(e => e.model).filter(Boolean)).size;
  const points = of.reduce((sum, e) => sum + (e.points ?? 0), 0);
  const over = kind === 'exact' ? ` title="over ${[...new Set(of.map(e => columnNames[e.scalar]))].filter(Boolean).join(' and ')}${points ? `, ${points} points` : ''}"` : '';
  const w = worst(r), orders = r.evidence.filter(e => e.kind === 'order').map(e => Number(e.slope));
  const rounded = r.evidence.filter(e => e.kind === 'precision' && Number(e.epsilon) > 0);
  const largest = rounded.length ? rounded.reduce((a, b) => (Number(b.measured) / Number(b.epsilon) > Number(a.measured) / Number(a.epsilon) ? b : a)) : null;
  const residual = largest ? `residual ≤ ${inEpsilons(largest.measured, largest.epsilon)}` : w ? `residual ${number(w.entry.measured)}` : '';
  const controls = (r.control ?? []).map(c => Number(c.measured));
  return `<span class="evidence-title">Evidence <span>for ${nameOf(r.id)}</span></span>${badge(r.verdict)}${book.boxes.has(r.id) ? '' : seal(book, r.id)}${[
    `<span class="evidence-kind"${over}>${kind}${models > 1 ? `, ${models} models` : ''}${kind === 'exact' && points ? `, ${points} points` : ''}</span>`,
    residual ? `<span>${residual}</span>` : '',
    orders.length ? `<span>order ${[...new Set([Math.min(...orders), Math.max(...orders)].map(x => x.toFixed(2)))].join(' to ')}</span>` : '',
    controls.length ? `<span>least control ${number(Math.min(...controls))}</span>` : '',
  ].join('')}`;
}

// ---- The ledger page

const verdicts = ['failed', 'holds', 'convention', 'corrected', 'scope', 'pending', 'notrun'];

const byChapter = registry => {
  const chapters = new Map();
  for (const s of registry) chapters.set(s.chapter, [...(chapters.get(s.chapter) ?? []), s]);
  return chapters;
};

/// The slips of the thesis: the corrected statements, those of them in which a slip occurs first, and those of these where the
/// scan may be at fault; and the statements that are judged with a slip of another one put right.
function slips(book) {
  const corrected = book.registry.filter(s => verdictOf(book, s.id) === 'corrected').map(s => book.statements.get(s.id));
  const distinct = corrected.filter(r => !r.first);
  const rest = book.registry.filter(s => verdictOf(book, s.id) === 'convention' && verdictOf(book, book.statements.get(s.id).first) === 'corrected');
  return { corrected: corrected.length, distinct: distinct.length, scan: distinct.filter(fromTheScan).length, rest: rest.length };
}
const fromTheScan = r => r.scan === true || r.scan === 'true';

/// The same in a sentence, so that the number of corrected statements never stands alone.
export function slipCounts(book) {
  if (!book.statements) return '';
  const n = slips(book), returns = n.corrected - n.distinct;
  if (!n.corrected) return '';
  return `<p class="slip-counts">The <b>${n.corrected}</b> corrected statements hold <b>${n.distinct}</b> distinct slips: in ${returns} of them a slip returns that occurs first in another. Of the distinct slips <b>${n.scan}</b> may be the scan's. ${n.rest} more statements rest on one of the slips without printing it, and are judged with it put right, as conventions.</p>`;
}

export function ledgerCounts(book) {
  const chapters = byChapter(book.registry);
  const used = verdicts.filter(v => book.registry.some(s => verdictOf(book, s.id) === v));
  const row = (name, list, tag) => `<tr><${tag}>${name}</${tag}>${used.map(v => `<${tag} class="num">${list.filter(s => verdictOf(book, s.id) === v).length || '·'}</${tag}>`).join('')}<${tag} class="num">${list.length}</${tag}></tr>`;
  return boxed(`<table class="counts"><thead><tr><th>chapter</th>${used.map(v => `<th class="num">${badge(v)}</th>`).join('')}<th class="num">statements</th></tr></thead><tbody>${[...chapters].map(([c, list]) => row(`<a href="@ref:ledger_${c}">${c}</a>`, list, 'td')).join('')}</tbody><tfoot>${row('all', book.registry, 'th')}</tfoot></table>`) + slipCounts(book);
}

/// How many statements have which strongest kind of evidence, by chapter, and how many leave something.
export function ledgerStrength(book) {
  if (!book.statements) return '';
  const kindOf = s => strongest(book, s.id);
  const used = strength.filter(k => book.registry.some(s => kindOf(s) === k));
  const count = n => n || '·';
  const row = (name, list, tag) => `<tr><${tag}>${name}</${tag}>${used.map(k => `<${tag} class="num">${count(list.filter(s => kindOf(s) === k).length)}</${tag}>`).join('')}<${tag} class="num">${count(list.filter(s => kindsOf(book.statements.get(s.id)).includes('enclosure')).length)}</${tag}><${tag} class="num">${count(list.filter(s => book.statements.get(s.id)?.left).length)}</${tag}></tr>`;
  return boxed(`<table class="counts"><thead><tr><th>chapter</th>${used.map(k => `<th class="num">${k}</th>`).join('')}<th class="num">with an enclosure</th><th class="num">say what they leave</th></tr></thead><tbody>${[...byChapter(book.registry)].map(([c, list]) => row(`<a href="@ref:ledger_${c}">${c}</a>`, list, 'td')).join('')}</tbody><tfoot>${row('all', book.registry, 'th')}</tfoot></table>`);
}

/// @param here  in the short form, inside a chapter: ids whose permanent anchor is in this very table
function ledgerRow(book, s, here) {
  const r = book.statements?.get(s.id);
  const verdict = verdictOf(book, s.id);
  const name = book.places.has(s.id) && !here?.has(s.id) ? statementLink(s.id, shortLabel(s.id)) : `<a class="target" id="${s.id}"></a><span class="ledger-anchor">${shortLabel(s.id)}</span>`;
  const kinds = kindsOf(r);
  const models = new Set((r?.evidence ?? []).map(e => e.model).filter(Boolean)).size;
  let figure = '';
  if (kinds.length) {
    const w = worst(r), orders = r.evidence.filter(e => e.kind === 'order');
    const parts = [];
    if (w) parts.push(w.entry.kind === 'exact' && Number(w.entry.measured) === 0 ? '0' : `${inEpsilons(w.entry.measured, w.entry.epsilon)} of ${inEpsilons(w.entry.bound, w.entry.epsilon)}`);
    if (orders.length) { const slopes = orders.map(o => Number(o.slope)); const lo = Math.min(...slopes).toFixed(2), hi = Math.max(...slopes).toFixed(2); parts.push(`order ${lo === hi ? lo : `${lo}–${hi}`}`); }
    figure = parts.join(', ');
  }
  const control = (r?.control ?? []).length ? Math.min(...r.control.map(c => Number(c.measured))) : null;
  const source = book.checkSource(s.id);
  const seconds = r?.seconds === undefined ? '' : ` title="${number(r.seconds)} s"`;
  const cells = [`<td class="id">${name}</td>`,
    `<td>${subject(book, s)}${r?.note && verdict !== 'pending' ? `<div class="ledger-note">${prose(r.note)}</div>` : ''}${leftOf(r)}</td>`,
    `<td>${badge(verdict)}${seal(book, s.id)}</td>`,
    here ? '' : `<td class="kind"><span title="${models} model${models === 1 ? '' : 's'}">${kinds.join(', ')}</span></td>`,
    `<td class="num">${figure}</td>`,
    here ? '' : `<td class="num">${control === null ? '' : `<span title="control / residual: ${ratioText(controlRatio(r)).replace(/<[^>]+>/g, '')}">${number(control)}</span>`}</td>`,
    `<td${seconds}>${source ? book.sourceLink(source.path, source.line, 'check') : ''}</td>`];
  const names = columns.filter(c => !here || !['kind', 'control'].includes(c[1])).map(c => (['id', 'subject', 'source'].includes(c[1]) ? '' : c[0]));
  return `<tr data-verdict="${verdict}" data-strength="${rankOf(book, s.id)}">${labelled(cells.filter(c => c !== ''), names)}</tr>`;
}

export function ledger(book) {
  const used = verdicts.filter(v => book.registry.some(s => verdictOf(book, s.id) === v));
  const buttons = `<div class="ledger-filter" role="group" aria-label="Filter by verdict"><button type="button" data-show="all" class="on">all</button>${used.map(v => `<button type="button" data-show="${v}">${verdictText[v][0]} <span>${book.registry.filter(s => verdictOf(book, s.id) === v).length}</span></button>`).join('')}<input type="search" placeholder="filter by words" aria-label="Filter by words"/><select aria-label="Order"><option value="place">in the order of the thesis</option><option value="strong">strongest evidence first</option><option value="weak">weakest evidence first</option></select></div>`;
  const tables = [...byChapter(book.registry)].map(([c, list]) => {
    const page = book.chapters.find(p => String(p.chapter) === String(c));
    const title = page ? `<a href="@ref:page:${page.id}">Chapter ${c}. ${escapeHtml(page.title)}</a>` : `Chapter ${c}`;
    return `<section class="ledger-chapter"><a class="target" id="ledger_${c}"></a><h2>${title}</h2><table class="ledger-table stacked">${tableHead(false)}<tbody>${list.map(s => ledgerRow(book, s)).join('')}</tbody></table></section>`;
  });
  const sorted = `<section class="ledger-sorted" hidden><table class="ledger-table stacked">${tableHead(false)}<tbody></tbody></table></section>`;
  return `<div class="ledger">${buttons}${sorted}${tables.join('')}</div>`;
}

const columns = [['statement', 'id'], ['subject', 'subject'], ['verdict', 'verdict'], ['kind', 'kind'], ['worst figure', 'figure'], ['control', 'control'], ['', 'source']];
function tableHead(brief) {
  const shown = columns.filter(c => !brief || !['kind', 'control'].includes(c[1]));
  return `<colgroup>${shown.map(c => `<col class="c-${c[1]}"/>`).join('')}</colgroup><thead><tr>${shown.map(c => `<th${/figure|control/.test(c[1]) ? ' class="num"' : ''}>${c[0]}</th>`).join('')}</tr></thead>`;
}

/// All statements of a chapter; those that have no place of their own unfold into their figures.
export function chapterLedger(book, list, here) {
  const rows = list.map(s => {
    const figures = here.has(s.id) && (book.statements?.get(s.id)?.evidence ?? []).length ? `<tr class="figures"><td></td><td colspan="4">${evidence(book, s.id, false)}</td></tr>` : '';
    return ledgerRow(book, s, here) + figures;
  });
  return `<div class="ledger"><table class="ledger-table stacked">${tableHead(true)}<tbody>${rows.join('')}</tbody></table></div>`;
}

// ---- The errata page

export function errata(book) {
  if (!book.statements) return '<p><span class="notrun">the checks have not been run in this build</span></p>';
  const part = verdict => book.registry.filter(s => verdictOf(book, s.id) === verdict).map(s => {
    const r = book.statements.get(s.id);
    const ratio = controlRatio(r), w = worst(r);
    const forms = [r.printed ? `<div class="erratum-form"><span>printed</span>${display(r.printed)}</div>` : '',
      r.corrected ? `<div class="erratum-form erratum-right"><span>${verdict === 'corrected' ? 'right' : 'read as'}</span>${display(r.corrected)}</div>` : ''].join('');
    const control = (r.control ?? [])[0];
    const scan = fromTheScan(r) ? '<span class="scan" title="the text came through recognition; a sign, star or inverse may have been lost there">perhaps the scan</span>' : '';
    const elsewhere = book.registry.filter(x => book.statements.get(x.id)?.first === s.id);
    const links = list => list.map(x => statementLink(x.id, nameOf(x.id))).join(', ');
    const returns = elsewhere.filter(x => verdictOf(book, x.id) === verdict), rest = elsewhere.filter(x => verdictOf(book, x.id) !== verdict);
    const slip = [r.first ? `${verdictOf(book, r.first) === verdict ? 'The slip occurs first in' : 'Judged with the slip put right that occurs in'} ${statementLink(r.first, nameOf(r.first))}.` : '',
      returns.length ? `The slip returns in ${links(returns)}.` : '',
      rest.length ? `Judged with it put right: ${links(rest)}.` : ''].filter(Boolean).map(text => `<p class="erratum-slip">${text}</p>`).join('');
    const figures = [control ? `${verdict === 'corrected' ? 'broken form' : 'control'}: ${prose(control.what)}, off by ${number(control.measured)}` : '',
      w ? `${verdict === 'corrected' ? 'corrected form' : 'statement'}: ${Number(w.entry.measured) === 0 ? 'exactly 0' : inEpsilons(w.entry.measured, w.entry.epsilon)}` : '',
      ratio !== null ? `ratio ${ratioText(ratio)}` : ''].filter(Boolean).map(f => `<span>${f}</span>`).join('');
    return `<article class="erratum" id="erratum_${s.id}"><div class="statement-head">${statementLink(s.id, shortLabel(s.id))}<span class="erratum-subject">${subject(book, s)}</span><span class="statement-tools">${scan}${seal(book, s.id)}${badge(verdict)}</span></div>${forms ? `<div class="erratum-forms">${forms}</div>` : ''}<p>${prose(r.note)}</p>${slip}<div class="evidence-foot">${figures}</div></article>`;
  });
  const corrected = part('corrected'), convention = part('convention');
  return `${slipCounts(book)}<h2 id="errata_corrected">Corrected: ${corrected.length} statements, ${slips(book).distinct} slips</h2>${corrected.join('') || '<p>None so far.</p>'}<h2 id="errata_convention">Conventions and hypotheses: ${convention.length}</h2>${convention.join('') || '<p>None so far.</p>'}`;
}
