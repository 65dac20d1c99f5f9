// Full-text search: the same lines make the index when the book is built (docs/tools/search_index.mjs, in
// Node) and ask it in the browser. A plain script, which runs from file:// as from anywhere.
(function (root) {
  'use strict';

  // ---- Words

  var greek = { '\u03b1': 'alpha', '\u03b2': 'beta', '\u03b3': 'gamma', '\u03b4': 'delta', '\u03b5': 'epsilon', '\u03f5': 'epsilon',
    '\u03b6': 'zeta', '\u03b7': 'eta', '\u03b8': 'theta', '\u03d1': 'theta', '\u03b9': 'iota', '\u03ba': 'kappa', '\u03bb': 'lambda',
    '\u03bc': 'mu', '\u03bd': 'nu', '\u03be': 'xi', '\u03c0': 'pi', '\u03c1': 'rho', '\u03c3': 'sigma', '\u03c4': 'tau',
    '\u03c6': 'phi', '\u03d5': 'phi', '\u03c7': 'chi', '\u03c8': 'psi', '\u03c9': 'omega' };
  var same = { license: 'licence', analyse: 'analyze', center: 'centre', install: 'install', installation: 'install', momenta: 'momentum',
    vertices: 'vertex', axes: 'axis', matrices: 'matrix', bodies: 'body' };
  /** The stem of a word: plural and singular, steps and stepping are one. */
  function stem(word) {
    if (Object.prototype.hasOwnProperty.call(same, word)) word = same[word];
    if (word.length < 5 || /[\d_]/.test(word)) return word;
    return word.replace(/ies$/, 'y').replace(/sses$/, 'ss').replace(/([^siu])s$/, '$1').replace(/([aeiouy].*[^aeiou])(?:ing|ed)$/, '$1').replace(/(.{3})e$/, '$1').replace(/([bdgmnprt])\1$/, '$1');
  }
  /** Words as they are written, small: Noether's is noether, a Greek letter is its name, 3.10 is one word. */
  function words(text) {
    return text.replace(/[\u03b1-\u03f5]/g, function (c) { return greek[c] ? ' ' + greek[c] + ' ' : c; }).toLowerCase()
      .replace(/['\u2019]s\b/g, '').match(/\d+(?:\.\d+)+[a-z]?|[a-z0-9\u00df-\u024f]+(?:_[a-z0-9]+)*/g) || [];
  }
  /** What a text is found by: its words, and the parts of names such as body_momentum. */
  function terms(text) {
    var all = [];
    words(text).forEach(function (w) {
      all.push(stem(w));
      if (w.indexOf('_') > 0) w.split('_').forEach(function (part) { if (part.length > 1) all.push(stem(part)); });
    });
    return all;
  }

  // ---- Lists of numbers as text: five bits a character, the sixth says that more follow

  var digits = '0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz-_', value = {};
  digits.split('').forEach(function (c, k) { value[c] = k; });
  function pack(list) {
    var text = '', before = -1;
    list.forEach(function (p) {
      var delta = p[0] - before - 1;
      before = p[0];
      for (; delta > 31; delta = Math.floor(delta / 32)) text += digits[32 + delta % 32];
      text += digits[delta] + digits[p[1]];
    });
    return text;
  }
  function unpack(text) {
    var list = [], before = -1;
    for (var i = 0; i < text.length; ++i) {
      var delta = 0, unit = 1;
      for (; value[text[i]] > 31; ++i, unit *= 32) delta += (value[text[i]] - 32) * unit;
      before += delta + value[text[i]] * unit + 1;
      list.push([before, value[text[++i]]]);
    }
    return list;
  }

  /**
   * The index of entries { title, text, more }: of each term where it stands and how much it counts there. Five bits say how often it
   * stands there, for the length of the text; the sixth, that it stands in the title.
   */
  function build(entries) {
    var found = new Map(), lengths = [], total = 0;
    entries.forEach(function (e, n) {
      var counts = new Map(), inTitle = new Set(terms(e.title));
      var body = terms(e.text).concat(terms(e.more || ''));
      body.forEach(function (t) { counts.set(t, (counts.get(t) || 0) + 1); });
      inTitle.forEach(function (t) { counts.set(t, (counts.get(t) || 0) + 1); });
      lengths.push(body.length);
      total += body.length;
      counts.forEach(function (count, t) {
        if (t.length > 40) return;
        if (!found.has(t)) found.set(t, []);
        found.get(t).push([n, count, inTitle.has(t)]);
      });
    });
    var mean = total / Math.max(1, entries.length), all = Array.from(found.keys()).sort();
    return { terms: all.join(' '), lists: all.map(function (t) {
      return pack(found.get(t).map(function (p) {
        var much = p[1] / (p[1] + 1.2 * (0.5 + 0.5 * lengths[p[0]] / mean));
        return [p[0], Math.min(31, Math.floor(32 * much)) + (p[2] ? 32 : 0)];
      }));
    }).join(' ') };
  }

  // ---- Questions

  /** How much a place counts by what it is: a definition before a box, a box before a text, all before proofs of the kernel. */
  var weight = { definition: 2.6, statement: 2, result: 1.9, page: 1.8, section: 1.5, type: 1.3, exercise: 1.1, key: 1, member: 0.8, ledger: 0.6, erratum: 0.7, file: 0.5, kernel: 0.35 };
  var isCode = function (kind) { return kind === 'type' || kind === 'member' || kind === 'file'; };
  var bare = function (text) { return words(text).map(stem).join(' '); };

  /** The data as they were written, ready to be asked: { kinds, pages: [address, title], entries: [page, anchor, kind, title, text, number], terms, lists }. */
  function open(data) {
    var all = data.terms.split(' '), lists = data.lists.split(' '), count = data.entries.length;
    var first = function (t) { var a = 0, b = all.length; while (a < b) { var m = (a + b) >> 1; if (all[m] < t) a = m + 1; else b = m; } return a; };
    var titles = data.entries.map(function (e) { return bare(e[3]); });
    var entry = function (n) {
      var e = data.entries[n], page = data.pages[e[0]];
      return { address: (e[1][0] === '>' ? e[1].slice(1) : page[0] + (e[1] ? '#' + e[1] : '')), title: e[3], page: page[1], text: e[4], kind: data.kinds[e[2]] };
    };
    /** Terms that a word of a question stands for, and how well. */
    function meant(word) {
      var t = stem(word), list = [], at = first(t), exact = all[at] === t;
      if (exact) list.push([at, 1]);
      if (word.length > 1) for (var k = first(word), n = 0; k < all.length && all[k].indexOf(word) === 0 && n < 60; ++k, ++n) if (all[k] !== t) list.push([k, exact ? 0.15 : 0.5]);
      if (!list.length && t.length > 4) all.forEach(function (x, k) { if (near(x, t)) list.push([k, 0.4]); });
      return list;
    }
    /** One letter more, less or another. */
    function near(a, b) {
      if (Math.abs(a.length - b.length) > 1 || a[0] !== b[0]) return false;
      var i = 0;
      while (i < a.length && a[i] === b[i]) ++i;
      return a.slice(i + 1) === b.slice(i + 1) || a.slice(i) === b.slice(i + 1) || a.slice(i + 1) === b.slice(i);
    }
    function ask(question, most) {
      var text = question.trim(), asked = words(text), score = {}, had = {}, seen = {}, hits = [];
      if (!asked.length) return [];
      // A number of the thesis: its box, then what speaks of it.
      var number = /^(?:eq|equation|thm|theorem|prop|proposition|lemma|lem|cor|corollary|def|definition|rem|remark|claim)?[\s._]*\(?(\d+(?:[._]\d+)+[a-z]?)\)?$/i.exec(text);
      if (number) data.entries.forEach(function (e, n) { if (e[5] && e[5] === number[1].replace(/_/g, '.')) score[n] = 1000 + (/^[a-z]/i.test(text) && bare(e[3]).indexOf(asked[0].slice(0, 3)) === 0 ? 10 : 0) - (data.kinds[e[2]] === 'statement' ? 0 : 5), had[n] = asked.length; });
      asked.forEach(function (word) {
        var best = {};
        meant(word).forEach(function (m) {
          var list = unpack(lists[m[0]]), rare = Math.log(1 + count / (list.length + 0.5));
          list.forEach(function (p) {
            var s = m[1] * rare * ((p[1] & 31) / 32 + (p[1] & 32 ? 1.4 : 0));
            if (!(best[p[0]] > s)) best[p[0]] = s;
          });
        });
        Object.keys(best).forEach(function (n) { score[n] = (score[n] || 0) + best[n]; had[n] = (had[n] || 0) + 1; });
      });
      var whole = bare(text), code = /^[\w:]*[a-z][A-Z]\w*$|::|\(\)/.test(text), needed = 0;
      Object.keys(had).forEach(function (n) { needed = Math.max(needed, had[n]); });
      Object.keys(score).forEach(function (n) {
        var kind = data.kinds[data.entries[n][2]], s = score[n] * (code && isCode(kind) ? (kind === 'type' ? 3 : 2) : weight[kind] || 1), title = titles[n];
        // The whole question is the title, or begins it.
        if (code || !isCode(kind)) {
          if (title === whole) s *= 3;
          else if (title.indexOf(whole + ' ') === 0) s *= 1.7;
        }
        hits.push([had[n] < needed ? s / 20 : !code && isCode(kind) ? s / 4 : s, n]);
      });
      return hits.sort(function (a, b) { return b[0] - a[0] || a[1] - b[1]; }).map(function (h) { return entry(h[1]); })
        .filter(function (e) { var fresh = !seen[e.address]; seen[e.address] = true; return fresh; }).slice(0, most || 12);
    }
    return { ask: ask, size: count };
  }

  var search = { build: build, open: open, words: words };
  if (typeof module !== 'undefined' && module.exports) module.exports = search;
  else root.bookSearcher = search;
})(this);
