// Formulas with few elements. KaTeX writes about forty elements for a formula of a line, twice: once as HTML,
// once as MathML for readers of the screen. Here the HTML becomes about a quarter of it and looks the same:
// an index is a <sub> that is moved, not a table; a strut and a space are styles of what stands beside them;
// what only names a class without a rule falls away. A formula is an image with its TeX as its name.
import {escapeHtml} from './lib.mjs';

/// Classes that no rule of KaTeX's sheet speaks of.
const neutral = new Set(['mord', 'mrel', 'mbin', 'mopen', 'mclose', 'mpunct', 'minner', 'mop', 'mtight', 'text']);

/// The rules that the lean form needs beside those of KaTeX.
export const leanRules = `
.katex i{font-family:KaTeX_Math;font-style:italic;font-size:inherit}
.katex sub,.katex sup{position:relative;vertical-align:baseline;font-size:.7em;line-height:inherit}
.katex :is(sub,sup) :is(sub,sup){font-size:.71428571em}
.katex .ss{display:inline-grid;text-align:left}
.katex .ss>*{grid-area:1/1;justify-self:start}
.katex .base::before{content:"";display:inline-block;height:var(--h);vertical-align:var(--v,baseline)}
.katex .vlist>span::before{content:"";display:inline-block;overflow:hidden;width:0;height:var(--p)}
.katex .vlist-t2::after{content:"";display:table-row;height:var(--d)}
.katex .vlist-t2>.vlist-r::after{content:"\\200b";display:table-cell;vertical-align:bottom;font-size:1px;width:0}
.katex .vlist-t2{margin-right:0}
`;

// ---- KaTeX's HTML as a tree: elements { tag, classes, style, rest, kids } and texts

const styles = text => new Map((text ?? '').split(';').filter(Boolean).map(s => { const at = s.indexOf(':'); return [s.slice(0, at), s.slice(at + 1)]; }));

function parse(html) {
  const root = { kids: [] }, open = [root], tag = /<(\/?)([a-zA-Z]+)([^>]*?)(\/?)>/g;
  let at = 0;
  for (let m; (m = tag.exec(html)); at = tag.lastIndex) {
    if (m.index > at) open.at(-1).kids.push(html.slice(at, m.index));
    if (m[1]) { open.pop(); continue; }
    const value = name => new RegExp(`\\s${name}=(?:"([^"]*)"|'([^']*)')`).exec(m[3]);
    const classes = value('class')?.[1] ?? '', style = value('style')?.[1];
    const e = { tag: m[2], classes: classes.split(/\s+/).filter(Boolean), style: styles(style),
      rest: m[3].replace(/\s(?:class|style)="[^"]*"/g, ''), kids: [] };
    open.at(-1).kids.push(e);
    if (!m[4]) open.push(e);
  }
  if (at < html.length) open.at(-1).kids.push(html.slice(at));
  return root.kids;
}

const shortNumber = text => text.replace(/(^|[^\d.])(-?)0+(?=\.\d)/g, '$1$2').replace(/(\.\d*?)0+(?=em|$)/g, '$1').replace(/\.(?=em|$)/g, '');
const em = x => `${Number(x.toFixed(4))}em`;
const has = (e, name) => typeof e !== 'string' && e.classes.includes(name);

function write(nodes) {
  return nodes.map(e => {
    if (typeof e === 'string') return e;
    const style = [...e.style].map(([k, v]) => `${k}:${shortNumber(v)}`).join(';');
    const inside = write(e.kids);
    const head = `<${e.tag}${e.classes.length ? ` class="${e.classes.join(' ')}"` : ''}${style ? ` style="${style}"` : ''}${e.rest}`;
    return e.tag === 'path' || e.tag === 'line' ? `${head}/>` : `${head}>${inside}</${e.tag}>`;
  }).join('');
}

// ---- The lean form

/// An element in the line, whose margins move what stands beside it.
const inLine = e => typeof e !== 'string' && (['i', 'sub', 'sup'].includes(e.tag) || (e.tag === 'span' && !e.classes.length && [...e.style.keys()].every(k => /^margin-/.test(k)) && e.style.size));
/// Nothing in it is taller than its line.
const isSimple = nodes => nodes.every(e => typeof e === 'string' || has(e, 'mspace') || ((inLine(e) || has(e, 'ss') || (e.tag === 'span' && !e.style.size && e.classes.every(c => /^(math|ams|main)/.test(c)))) && isSimple(e.kids)));
const scaleOf = e => e.scale ?? 1;
const addMargin = (e, side, x) => {
  const name = `margin-${side}`, sum = (parseFloat(e.style.get(name) ?? '0') || 0) + x / scaleOf(e);
  if (Math.abs(sum) < 5e-5) e.style.delete(name);
  else e.style.set(name, em(sum));
};

/// Whether a space beside it may be its margin.
const takesMargin = e => e !== undefined && typeof e !== 'string' && e.tag !== 'svg' && !e.classes.some(c => /^(vlist|base$|tag$|[rlc]lap$|newline$|mspace$|sizing$|col-align|arraycolsep|vertical)/.test(c));
const space = e => (has(e, 'mspace') && e.classes.length === 1 && [...e.style.keys()].join() === 'margin-right' ? parseFloat(e.style.get('margin-right')) : null);
const word = (text, side, x) => { const e = { tag: 'span', classes: [], style: new Map(), rest: '', kids: [text] }; addMargin(e, side, x); return e; };

/// Texts beside each other are one, and a space is a margin of its neighbour.
function joined(nodes) {
  const out = [];
  const plain = n => n !== undefined && typeof n !== 'string' && n.tag === 'i' && n.kids.length === 1 && typeof n.kids[0] === 'string';
  for (const e of nodes) {
    const last = out.at(-1), x = space(e), before = last === undefined ? null : space(last);
    if (x !== null) {
      if (before !== null) last.style.set('margin-right', em(before + x));
      else if (takesMargin(last)) addMargin(last, 'right', x);
      else if (typeof last === 'string') out[out.length - 1] = word(last, 'right', x);
      else out.push(e);
      continue;
    }
    if (before !== null && (typeof e === 'string' || takesMargin(e))) {
      if (typeof e === 'string') out[out.length - 1] = word(e, 'left', before);
      else { addMargin(e, 'left', before); out[out.length - 1] = e; }
      continue;
    }
    if (typeof e === 'string' && typeof last === 'string') { out[out.length - 1] = last + e; continue; }
    if (plain(e) && plain(last) && !last.style.size && !e.style.has('margin-left')) { last.kids[0] += e.kids[0]; last.style = e.style; continue; }
    // A slanted letter makes room that its index takes back.
    if (typeof e !== 'string' && e.tag === 'sub' && inLine(last ?? '') && last.style.has('margin-right')) {
      const back = parseFloat(e.style.get('margin-left') ?? '0') * scaleOf(e), room = parseFloat(last.style.get('margin-right')) * scaleOf(last);
      if (Math.abs(back + room) < 2e-4) { e.style.delete('margin-left'); last.style.delete('margin-right'); }
    }
    out.push(e);
  }
  return out;
}

const sizes = { 'reset-size6 size3': 0.7, 'reset-size3 size1': 0.71428571, 'reset-size1 size1': 1 };
/// Sub- and superscripts that are a line each; null where one of them is taller.
function scripts(e, depth) {
  const table = e.kids.length === 1 && has(e.kids[0], 'vlist-t') ? e.kids[0] : null, list = table?.kids[0]?.kids?.[0];
  if (!list || !has(list, 'vlist') || list.kids.length > 2) return null;
  const parts = [];
  for (const child of list.kids) {
    const [strut, box, more] = child.kids;
    if (more || !has(strut, 'pstrut') || !box || !has(box, 'sizing') || box.style.size || child.classes.length) return null;
    const size = sizes[box.classes.filter(c => /size\d/.test(c)).join(' ')];
    if (size === undefined) return null;
    const kids = lean(box.kids, depth + 1);
    if (!isSimple(kids)) return null;
    const shift = parseFloat(child.style.get('top')) + parseFloat(strut.style.get('height')), style = new Map();
    if ([...child.style.keys()].some(k => !/^(top|margin-(left|right))$/.test(k))) return null;
    style.set('top', em(shift / size));
    const script = { tag: shift > 0 ? 'sub' : 'sup', classes: [], style, rest: '', kids, scale: size };
    for (const side of ['left', 'right']) if (child.style.has(`margin-${side}`)) addMargin(script, side, parseFloat(child.style.get(`margin-${side}`)));
    if (size !== (depth ? 0.71428571 : 0.7)) style.set('font-size', `${size}em`);
    parts.push(script);
  }
  return parts.length === 1 ? parts : [{ tag: 'span', classes: ['ss'], style: new Map(), rest: '', kids: parts.reverse() }];
}

function stack(e, depth) {
  const [first, second] = e.kids, list = first.kids.find(k => has(k, 'vlist'));
  const kids = list.kids.map(child => {
    const strut = child.kids?.find(k => has(k, 'pstrut'));
    if (!strut) return { ...child, kids: lean(child.kids ?? [], depth, true) };
    const style = new Map(child.style);
    style.set('--p', strut.style.get('height'));
    return { ...child, style, kids: lean(child.kids.filter(k => k !== strut), depth, true) };
  });
  const style = new Map(e.style);
  if (second) style.set('--d', second.kids[0].style.get('height'));
  return { ...e, style, kids: [{ ...first, kids: [{ ...list, kids }] }] };
}

/// @param depth  how many scripts it stands in
/// @param boxes  the elements themselves are boxes of a stack, and stay
function lean(nodes, depth, boxes = false) {
  const out = [];
  for (const e of nodes) {
    if (typeof e === 'string') { out.push(e); continue; }
    if (e.tag !== 'span') { out.push(e); continue; }
    if (has(e, 'msupsub')) {
      const small = boxes ? null : scripts(e, depth);
      if (small) { out.push(...small); continue; }
    }
    if (has(e, 'vlist-t')) { out.push(stack(e, depth)); continue; }
    const classes = e.classes.filter(c => !neutral.has(c)), style = new Map(e.style);
    if (has(e, 'base')) {
      const strut = e.kids[0], kids = has(strut, 'strut') ? e.kids.slice(1) : e.kids;
      if (kids !== e.kids) {
        style.set('--h', strut.style.get('height'));
        if (strut.style.has('vertical-align')) style.set('--v', strut.style.get('vertical-align'));
      }
      out.push({ ...e, classes, style, kids: lean(kids, depth) });
      continue;
    }
    if (has(e, 'delimcenter') && parseFloat(style.get('top')) === 0) { style.delete('top'); classes.splice(classes.indexOf('delimcenter'), 1); }
    if (has(e, 'op-symbol')) style.delete('position');
    // An upright letter is upright where nothing around it is not.
    const upright = classes.length === 1 && classes[0] === 'mathrm';
    const inner = upright ? [] : classes, table = /^(overlay|stretchy|mtable|col-align|rlap|llap|clap|x-arrow|hbox|vbox|delim-size)/;
    const kids = lean(e.kids, depth, classes.some(c => table.test(c)) || has(e, 'mult'));
    // What bounds an expression without a sign is a space.
    if (classes.join() === 'nulldelimiter' && !style.size) { out.push({ ...e, classes: ['mspace'], style: new Map([['margin-right', '0.12em']]) }); continue; }
    if (classes.length === 1 && classes[0] === 'mathnormal') out.push({ ...e, tag: 'i', classes: [], style, kids });
    else if (!inner.length && !style.size && !boxes) out.push(...kids);
    else out.push({ ...e, classes: inner, style, kids });
  }
  return boxes ? out : joined(out);
}

/// KaTeX's output of HTML alone, made lean.
export function leanFormula(html, tex) {
  const slanted = /\b(?:textit|mathit|boldsymbol)\b/.test(html), nodes = parse(html);
  const find = list => { for (const e of list) { if (typeof e === 'string') continue; if (has(e, 'katex-html')) return e; const inner = find(e.kids); if (inner) return inner; } return null; };
  const visible = find(nodes), display = has(nodes[0], 'katex-display');
  const body = slanted ? visible.kids : lean(visible.kids, 0);
  const inside = slanted ? `<span class="plain">${write(visible.kids)}</span>` : write(body);
  const name = ` role="img" aria-label="${escapeHtml(tex.replace(/\s+/g, ' '))}"`;
  return display ? `<span class="katex-display"><span class="katex"${name}><span class="katex-html">${inside}</span></span></span>` : `<span class="katex"${name}>${inside}</span>`;
}
