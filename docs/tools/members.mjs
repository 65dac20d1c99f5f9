// Where functions are documented. Doxygen writes every function of a namespace on the page of the namespace,
// which grows without bound; here each moves to the page of its header, where the list of the header leads
// anyway. The page of a namespace becomes a short index of its headers. The page of a group keeps what it
// documents as long as it stays within the limits of a page.
import {escapeHtml} from './lib.mjs';

/// What a page may weigh: bytes of its HTML, and elements.
export const limits = { bytes: 1500000, nodes: 25000 };
export const nodesOf = html => (html.replace(/<!--[\s\S]*?-->/g, '').replace(/(<script\b[^>]*>)[\s\S]*?<\/script>/g, '$1').match(/<[a-zA-Z]/g) ?? []).length;
export const withinLimits = html => Buffer.byteLength(html) <= limits.bytes && nodesOf(html) <= limits.nodes;

const memberId = '(?:gg|[ag])[0-9a-f]{32}[0-9a-z]*';
const start = `<a id="(?:${memberId})" name="(?:${memberId})"></a>\\s*<h2 class="memtitle">`;
const documented = new RegExp(`<a id="(${memberId})" name="\\1"></a>\\s*<h2 class="memtitle">[\\s\\S]*?(?=${start}|<h2 class="groupheader">|</div><!-- contents -->)`, 'g');
const section = / Documentation$/;

/// The members that a page documents: id, HTML, title of their section, page of their header.
function members(html) {
  const titles = [...html.matchAll(/<h2 class="groupheader">([^<]*)<\/h2>/g)].map(m => ({ at: m.index, title: m[1] }));
  return [...html.matchAll(documented)].map(m => ({
    id: m[1], html: m[0], title: titles.filter(t => t.at < m.index).at(-1)?.title ?? 'Documentation',
    home: /Definition at line <a [^>]*>\d+<\/a> of file <a [^>]*href="([^"#]+)_source\.html/.exec(m[0])?.[1]
  }));
}

/// The text without members and without sections that they leave empty.
const withoutMembers = (html, gone) => html.replace(documented, (all, id) => (gone.has(id) ? '' : all))
  .replace(/<h2 class="groupheader">([^<]*)<\/h2>\s*(?=<h2 class="groupheader">|<\/div><!-- contents -->)/g, (all, title) => (section.test(title) && title !== 'Detailed Description' ? '' : all));

const rowOnly = new RegExp(`<td [^>]*><a id="(${memberId})" name="\\1"></a>`);

/// What a page says of itself in its first paragraph.
const brief = html => (/<div class="contents">\s*<p>([\s\S]*?)<\/p>/.exec(html)?.[1] ?? '').replace(/<a href="[^"]*#details">[\s\S]*?<\/a>/, '').trim();

/// A namespace as an index: what it is, the namespaces within it, its headers. Lists of its members stand on their pages.
function asIndex(name, html, text) {
  const title = /<div class="title">([\s\S]*?) Namespace Reference/.exec(html)?.[1] ?? name;
  html = html.replace(/<table class="memberdecls">([\s\S]*?)<\/table>/g, (all, body) => {
    if (/<a id="namespaces"/.test(body)) return all;
    // What has no page but its row in this list stays.
    const [head, ...rows] = body.split(/(?=<tr class="memitem:)/), ids = new Set(rows.map(r => rowOnly.exec(r)?.[1]).filter(Boolean));
    const kept = rows.filter(r => ids.has(/^<tr class="memitem:(\w+)"/.exec(r)?.[1]));
    return kept.length ? `<table class="memberdecls">${head}${kept.join('')}</table>` : '';
  })
    .replace(/<div class="summary">[\s\S]*?<\/div>/, '');
  const headers = [...text].filter(([f, h]) => /_8[hc]pp\.html$/.test(f) && h.includes(`memitem:${name.replace(/\.html$/, '')}"`))
    .map(([f, h]) => ({ f, title: /<div class="title">(\S+) File Reference/.exec(h)?.[1] ?? f, brief: brief(h) })).sort((a, b) => (a.title < b.title ? -1 : 1));
  if (!headers.length) return html;
  const list = `<h2 class="groupheader"><a id="headers" name="headers"></a>Headers of ${title}</h2><p>Each documents its functions, types and constants.</p><ul class="headers">${headers.map(h => `<li><a class="el" href="${h.f}">${escapeHtml(h.title)}</a> ${h.brief}</li>`).join('')}</ul>`;
  return html.replace(/<a name="details" id="details"><\/a>|<\/div><!-- contents -->/, all => list + all);
}

/// Moves members, makes indices of namespaces, and leads every link to where its member is now.
/// @param text  pages by name, changed in place
export function settleMembers(text) {
  const kinds = ['Typedef Documentation', 'Enumeration Type Documentation', 'Function Documentation', 'Variable Documentation'], moved = new Map();
  // The page of a header lists what it declares.
  const lists = new Map();
  for (const [name, html] of text)
    if (/_8[hc]pp\.html$/.test(name)) for (const m of html.matchAll(/<tr class="memitem:([ag]\w{32,})"/g)) if (!lists.has(m[1])) lists.set(m[1], name);
  for (const [name, html] of [...text]) {
    const isNamespace = /^namespace(?!s|members)/.test(name);
    if (!isNamespace && !(/^group__/.test(name) && !withinLimits(html))) continue;
    const all = members(html), gone = new Map();
    for (const m of all) {
      m.home = lists.get(m.id) ?? (text.has(`${m.home}.html`) ? `${m.home}.html` : null);
      if (m.home) gone.set(m.id, m);
    }
    let rest = withoutMembers(html, gone);
    if (isNamespace)
      rest = rest.replace(new RegExp(`<a id="(${memberId})" name="\\1"></a>(?!\\s*<h2)`, 'g'), (all, id) => {
        const to = lists.get(id);
        if (!to || gone.has(id) || !text.get(to).includes(`<tr class="memitem:${id}"><td`)) return all;
        text.set(to, text.get(to).replace(new RegExp(`<tr class="memitem:${id}"><td[^>]*>`), row => row + all));
        return '';
      });
    if (isNamespace) rest = asIndex(name, rest, text);
    text.set(name, rest);
    for (const m of gone.values()) {
      // A link within the page was to a neighbour.
      const own = m.html.replace(/href="#([^"]+)"/g, (link, id) => (id === m.id || m.html.includes(`id="${id}"`) ? link : `href="${name}#${id}"`));
      const page = m.home;
      if (!moved.has(page)) moved.set(page, []);
      moved.get(page).push({ ...m, html: own });
    }
  }
  for (const [page, list] of moved) {
    let html = text.get(page);
    for (const title of [...kinds, ...new Set(list.map(m => m.title).filter(t => !kinds.includes(t)))]) {
      const body = list.filter(m => m.title === title).map(m => m.html).join('');
      if (!body) continue;
      const head = `<h2 class="groupheader">${title}</h2>`;
      html = html.includes(head) ? html.replace(head, () => head + body) : html.replace(/<\/div><!-- contents -->/, all => head + body + all);
    }
    text.set(page, html);
  }
  const places = placesOf(text), led = leader(places);
  for (const [name, html] of text) {
    const ids = new RegExp(`href="((?:[\\w.-]+\\.html)?)#(${memberId})"`, 'g');
    const now = html.replace(ids, (link, page, id) => {
      const to = places.get(id);
      return !to || to === (page || name) ? link : `href="${to === name ? '' : to}#${id}"`;
    }).replace(/href="(namespace[\w-]+\.html)#(?:nested-classes|concepts|typedef-members|enum-members|func-members|var-members)"/g, 'href="$1"');
    if (now !== html) text.set(name, now);
  }
  return led;
}

/// The page on which each member is documented.
function placesOf(text) {
  const places = new Map();
  for (const [name, html] of text)
    for (const m of html.matchAll(new RegExp(`<a id="(${memberId})" name=`, 'g'))) places.set(m[1], name);
  return places;
}
/// An address in scripts of the tree, led to where its member is.
const leader = places => address => address.replace(new RegExp(`^([\\w.-]+\\.html)#(${memberId})$`), (all, page, id) => (places.has(id) ? `${places.get(id)}#${id}` : all));
