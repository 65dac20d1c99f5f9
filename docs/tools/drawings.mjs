// Drawings of ideas: SVG written by hand, with labels in a small markup and colours by class alone.
//
//   <path class="arrow c1" d="..."/>            an arrow head at its end, in the colour of the line
//   <text class="m" x="10" y="20">g_{k+1}</text>  a mathematical label: letters italic, _ lowers, ^ raises
import { escapeHtml } from './lib.mjs';

/// A label as spans: letters slanted, digits upright, what follows _ lowered and ^ raised.
export function labelSpans(text) {
  const out = [];
  const letters = (s, size) => {
    for (const part of s.match(/[\p{L}]+|[^\p{L}]+/gu) ?? [])
      out.push(`<tspan${/\p{L}/u.test(part) ? ' font-style="italic"' : ''}${size}>${escapeHtml(part)}</tspan>`);
  };
  let shift = 0;
  for (const m of text.matchAll(/([_^])(?:\{([^}]*)\}|(\S))|([^_^]+)/gu)) {
    if (m[4] !== undefined) {
      // Back to the line.
      if (shift) out.push(`<tspan dy="${-shift}">&#8203;</tspan>`);
      shift = 0;
      letters(m[4], '');
      continue;
    }
    const to = m[1] === '_' ? 4 : -6;
    out.push(`<tspan dy="${to - shift}">&#8203;</tspan>`);
    shift = to;
    letters(m[2] ?? m[3], ' font-size="72%"');
  }
  return out.join('');
}

const unescape = s => s.replace(/&lt;/g, '<').replace(/&gt;/g, '>').replace(/&amp;/g, '&');

/// A drawing with its labels set and its arrow heads in place.
/// @throws where it names a colour of its own, which no theme could change
export function drawn(svg) {
  if (/\b(?:fill|stroke)="(?!none)[^"]*"|style="[^"]*(?:fill|stroke|color)\s*:/.test(svg)) throw new Error('a colour is named: use the classes of docs/WRITING.md');
  if (!/viewBox="0 0 [\d.]+ [\d.]+"/.test(svg)) throw new Error('no viewBox="0 0 W H"');
  svg = svg.replace(/(<text\b[^>]*class="[^"]*\bm\b[^"]*"[^>]*>)([^<]*)(<\/text>)/g, (_, a, text, b) => a + labelSpans(unescape(text)) + b);
  const heads = new Set();
  svg = svg.replace(/<(path|line|polyline)\b([^>]*class="([^"]*)"[^>]*?)(\/?)>/g, (all, element, attributes, classes, closing) => {
    const names = classes.split(/\s+/);
    if (!names.includes('arrow')) return all;
    const colour = names.find(c => /^c\d$/.test(c)) ?? (names.includes('grey') ? 'grey' : 'line');
    heads.add(colour);
    return `<${element}${attributes} marker-end="url(#head-${colour})"${closing}>`;
  });
  const marker = c => `<marker id="head-${c}" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" orient="auto-start-reverse"><path class="head ${c.replace(/^c/, 'f')}" d="M0 0.6 L8 4 L0 7.4 Z"/></marker>`;
  return svg.replace(/^(<svg\b[^>]*)>/m, (_, head) => `${head.replace(/class="[^"]*"/, '')} class="drawing">${heads.size ? `<defs>${[...heads].map(marker).join('')}</defs>` : ''}`);
}
