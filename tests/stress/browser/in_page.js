// What a reader would stumble over in the page that is open, as a list of [kind, text]. It is run in the page
// itself.
(function() {
'use strict';
const out = [], wide = innerWidth >= 768;
const say = (kind, text) => {
  if (out.filter((f) => f[0] === kind).length < 4)
    out.push([kind, String(text).replace(/\s+/g, ' ').trim().slice(0, 140)]);
};
const name = (e) => e.tagName.toLowerCase() + (e.id ? '#' + e.id : '') +
  (e.classList.length ? '.' + [...e.classList].join('.') : '');
const seen = (e) => e.getClientRects().length > 0 && getComputedStyle(e).visibility !== 'hidden';
const viewer = Boolean(document.getElementById('stages'));
const content = document.getElementById('doc-content') || document.body;

// ---- The page does not scroll sideways.
const sideways = Math.max(document.scrollingElement.scrollWidth, document.body.scrollWidth) - innerWidth;
const inner = getComputedStyle(content).overflowX === 'auto' ? content.scrollWidth - content.clientWidth : 0;
const scrolls = (e) => ['auto', 'scroll', 'hidden', 'clip'].includes(getComputedStyle(e).overflowX);
if (sideways > 1 || inner > 1) {
  const beyond = [];
  for (const e of content.querySelectorAll('*')) {
    if (e.getBoundingClientRect().right <= innerWidth + 1 || !seen(e)) continue;
    let boxed = false;
    for (let up = e.parentElement; up && up !== content; up = up.parentElement) boxed = boxed || scrolls(up);
    if (!boxed) beyond.push(e);
  }
  say('sideways', `by ${Math.max(sideways, inner)} px: ${beyond.slice(0, 3).map(name).join(', ')}`);
}

// ---- No text is cut: none reaches beyond a box that hides what does not fit.
const texts = [];
const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
for (let node; (node = walker.nextNode());) {
  const holder = node.parentElement;
  if (
    !node.data.trim() || /^(SCRIPT|STYLE|OPTION|NOSCRIPT|TITLE)$/.test(holder.tagName) ||
    holder.closest('.katex, svg, [hidden], .skip-link'))
    continue;
  texts.push(node);
}
const hides = new Map();
const hiding = (e) => {
  if (!hides.has(e)) {
    const style = getComputedStyle(e);
    hides.set(e, {
      x: /hidden|clip/.test(style.overflowX),
      y: /hidden|clip/.test(style.overflowY),
      scrolls: /auto|scroll/.test(style.overflowX) || /auto|scroll/.test(style.overflowY),
      box: e.getBoundingClientRect()
    });
  }
  return hides.get(e);
};
const range = document.createRange();
for (const node of texts) {
  let chain = [];
  for (let up = node.parentElement; up && up !== document.body; up = up.parentElement) {
    const h = hiding(up);
    if (h.scrolls) break;
    if (h.x || h.y) chain.push(h);
  }
  if (!chain.length || !seen(node.parentElement)) continue;
  range.selectNodeContents(node);
  for (const r of range.getClientRects())
    if (
      r.width > 1 &&
      chain.some(
        (h) => (h.x && (r.right > h.box.right + 2 || r.left < h.box.left - 2)) ||
          (h.y && (r.bottom > h.box.bottom + 4 || r.top < h.box.top - 4)))) {
      say('cut', `${name(node.parentElement)}: ${node.data}`);
      break;
    }
}

// ---- No raw TeX, no stray backslash, no path of the machine that made the book.
for (const node of texts) {
  const path = /(?:^|\s)\/\S*\/report\/\S*/.exec(node.data);
  if (path) say('path', path[0]);
  if (node.parentElement.closest(
        'pre, code, .fragment, textarea, .memproto, .memItemLeft, .memItemRight, .memtitle, #nav-tree'))
    continue;
  if (/\\[,;\\]|\\[a-zA-Z]+[{_^ ]|\\\(|\\f\$/.test(node.data))
    say('backslash', node.data);
  else if (
    content.contains(node) &&
    /[A-Za-z)]\*?[_^]\{|\b(?:Ad|ad)\*_|\b[gfM]_k\b|\^-1\b|\b(?:eq|thm|prop|lem|cor|def|rem|claim|bridge)_\d+_\w+/
      .test(node.data) &&
    !/_8[hc]pp/.test(location.pathname))
    say('raw TeX', node.data);
}

// ---- Text stands out from what is behind it.
const colour = (text) => {
  const m = /rgba?\(([\d.]+), ([\d.]+), ([\d.]+)(?:, ([\d.]+))?\)/.exec(text);
  return m && [+m[1], +m[2], +m[3], m[4] === undefined ? 1 : +m[4]];
};
const light = (c) => {
  const [r, g, b] = c.map((x) => {
    x /= 255;
    return x <= 0.03928 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
};
const grounds = new Map();
const ground = (e) => {
  if (!e) return matchMedia('(prefers-color-scheme: dark)').matches ? [18, 18, 18, 1] : [255, 255, 255, 1];
  if (!grounds.has(e)) {
    const own = colour(getComputedStyle(e).backgroundColor);
    grounds.set(e, own && own[3] > 0.5 ? own : ground(e.parentElement));
  }
  return grounds.get(e);
};
for (const node of texts.length > 4000 ? texts.filter((_, i) => i % Math.ceil(texts.length / 4000) === 0) :
                                         texts) {
  const e = node.parentElement;
  if (!seen(e)) continue;
  const ink = colour(getComputedStyle(e).color), behind = ground(e);
  if (!ink || ink[3] < 0.5) continue;
  const [a, b] = [light(ink), light(behind)].sort((x, y) => y - x), contrast = (a + 0.05) / (b + 0.05);
  if (contrast < 2.9) say('contrast', `${contrast.toFixed(1)}: ${name(e)}: ${node.data}`);
}

// ---- Ways to other pages.
if (!viewer) {
  if (wide) {
    const entries = [...document.querySelectorAll('#nav-tree .item')].filter(seen);
    if (entries.length < 2)
      say('sidebar', `${entries.length} entries: ${entries.map((e) => e.textContent).join(', ')}`);
    else if (document.querySelector('#nav-tree a[href$="part1.html"]') === null)
      say('sidebar', 'the parts of the book are not in it');
  } else {
    const chapters = [...document.querySelectorAll('#book-menu a, #main-menu a')].filter(
      (a) => /(^|\/)ch\d\d\.html$/.test(a.getAttribute('href')));
    if (chapters.length < 2) say('menu', `${chapters.length} chapters in the menu of a narrow screen`);
  }
}
// ---- The page of a run: two stages side by side begin at the same height, and nothing is below a canvas.
if (viewer) {
  const figures = [...document.querySelectorAll('#stages figure')].filter(seen);
  const tops = figures.map(
    (f) => [f.getBoundingClientRect().top, f.querySelector('canvas').getBoundingClientRect().top]);
  if (tops.length > 1 && Math.abs(tops[0][0] - tops[1][0]) < 2 && Math.abs(tops[0][1] - tops[1][1]) > 1)
    say('stages', `canvases begin ${tops.map((t) => Math.round(t[1])).join(' and ')} px from above`);
  for (const f of figures) {
    const below = f.getBoundingClientRect().bottom - f.querySelector('canvas').getBoundingClientRect().bottom;
    if (below > 3) say('stages', `a strip of ${Math.round(below)} px below the canvas of ${f.id}`);
  }
  for (const canvas of document.querySelectorAll('canvas')) {
    if (!seen(canvas)) continue;
    const copy = document.createElement('canvas'),
          pen = Object.assign(copy, { width: canvas.width, height: canvas.height }).getContext('2d', {
            willReadFrequently: true
          });
    pen.drawImage(canvas, 0, 0);
    const data = pen.getImageData(0, 0, copy.width, copy.height).data;
    let drawn = 0;
    for (let i = 3; i < data.length; i += 4)
      if (data[i]) ++drawn;
    if (drawn < 200) say('canvas', `nothing is drawn on a canvas of ${canvas.width} by ${canvas.height}`);
  }
}
return out;
})();
