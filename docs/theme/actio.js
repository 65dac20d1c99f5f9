// Plain script, no modules and no requests: it runs from file:// as from anywhere.
(function () {
  'use strict';

  function load(file, done) {
    var s = document.createElement('script');
    s.src = file;
    s.onload = done;
    document.head.appendChild(s);
  }

  // ---- Search: the index is loaded when somebody first types.
  function search() {
    var input = document.getElementById('book-search');
    if (!input) return;
    var list = document.createElement('div'), index = null, state = 0, chosen = -1;
    list.id = 'book-search-results';
    list.hidden = true;
    document.body.appendChild(list);

    function find(text) {
      text = text.trim();
      if (!text) return [];
      var terms = text.toLowerCase().replace(/[()\[\]{}:^~*+\-"'`,;]/g, ' ').split(/\s+/).filter(Boolean);
      // Each word by itself, then the places that have them all before those that have some; prose before declarations.
      var found = {};
      terms.forEach(function (t) {
        index.query(function (q) {
          q.term(lunr.stemmer(new lunr.Token(t)).toString(), { boost: 20 });
          q.term(t, { boost: 20 });
          q.term(t, { boost: 4, wildcard: lunr.Query.wildcard.TRAILING });
          if (t.length > 4) q.term(t, { editDistance: 1 });
        }).forEach(function (h) {
          var f = found[h.ref] = found[h.ref] || { ref: h.ref, words: 0, score: 0 };
          f.words += 1;
          f.score += h.score;
        });
      });
      var seen = {};
      return Object.keys(found).map(function (k) {
        var f = found[k];
        if (!/^(namespace|struct|class|concept|union)|_8[hc]pp/.test(window.bookSearch.entries[+k].u)) f.score *= 2;
        return f;
      }).sort(function (x, y) { return y.words - x.words || y.score - x.score; }).filter(function (f) {
        var u = window.bookSearch.entries[+f.ref].u, fresh = !seen[u];
        seen[u] = true;
        return fresh;
      });
    }
    function show() {
      if (state !== 2) return;
      chosen = -1;
      list.textContent = '';
      var text = input.value;
      var hits = find(text).slice(0, 12);
      hits.forEach(function (h) {
        var e = window.bookSearch.entries[+h.ref], a = document.createElement('a');
        a.href = e.u;
        [['b', e.t], ['span', e.p === e.t ? '' : e.p], ['small', e.x]].forEach(function (part) {
          var x = document.createElement(part[0]);
          x.textContent = part[1];
          a.appendChild(x);
        });
        list.appendChild(a);
      });
      if (text.trim() && !hits.length) list.textContent = 'Nothing found.';
      list.hidden = !text.trim();
    }
    function ready() {
      if (state) return show();
      state = 1;
      load('lunr.min.js', function () {
        load('search_index.js', function () {
          index = lunr.Index.load(window.bookSearch.index);
          state = 2;
          show();
        });
      });
    }
    var asked = /[?&]q=([^&]*)/.exec(location.search);
    if (asked) { input.value = decodeURIComponent(asked[1].replace(/\+/g, ' ')); ready(); }
    input.addEventListener('focus', ready);
    input.addEventListener('input', ready);
    input.addEventListener('keydown', function (e) {
      var links = list.querySelectorAll('a');
      if (e.key === 'Escape') { list.hidden = true; input.blur(); }
      if (e.key === 'Enter' && links.length) { e.preventDefault(); location.href = links[Math.max(chosen, 0)].href; list.hidden = true; }
      if (e.key === 'ArrowDown' || e.key === 'ArrowUp') {
        e.preventDefault();
        chosen = Math.max(0, Math.min(links.length - 1, chosen + (e.key === 'ArrowDown' ? 1 : -1)));
        links.forEach(function (l, i) { l.className = i === chosen ? 'on' : ''; });
      }
    });
    document.addEventListener('click', function (e) { if (e.isTrusted && !list.contains(e.target) && e.target !== input) list.hidden = true; });
    document.addEventListener('keydown', function (e) {
      if (e.key === '/' && !/INPUT|TEXTAREA/.test(document.activeElement.tagName)) { e.preventDefault(); input.focus(); }
    });
  }

  // ---- Ledger: by verdict, by words.
  function ledger() {
    var filter = document.querySelector('.ledger-filter');
    if (!filter) return;
    var words = filter.querySelector('input'), verdict = 'all';
    function apply() {
      var text = words.value.toLowerCase();
      document.querySelectorAll('.ledger-chapter').forEach(function (section) {
        var any = false;
        section.querySelectorAll('tbody tr').forEach(function (row) {
          var on = (verdict === 'all' || row.dataset.verdict === verdict) && (!text || row.textContent.toLowerCase().indexOf(text) >= 0);
          row.hidden = !on;
          any = any || on;
        });
        section.hidden = !any;
      });
    }
    filter.querySelectorAll('button').forEach(function (b) {
      b.addEventListener('click', function () {
        verdict = b.dataset.show;
        filter.querySelectorAll('button').forEach(function (x) { x.className = x === b ? 'on' : ''; });
        apply();
      });
    });
    words.addEventListener('input', apply);
    var m = /[?&]verdict=(\w+)/.exec(location.search), b = m && filter.querySelector('[data-show="' + m[1] + '"]');
    if (b) b.click();
  }

  // ---- Tree: the chapters are always in sight.
  function chapters() {
    var tries = 0, timer = setInterval(function () {
      document.querySelectorAll('#nav-tree a[href^="part"]').forEach(function (a) {
        var li = a.closest('li'), arrow = li && li.querySelector('.item > a');
        if (arrow && arrow !== a && !li.querySelector('ul.children_ul')) arrow.click();
        if (li && li.querySelector('ul.children_ul')) clearInterval(timer);
      });
      if (++tries > 20) clearInterval(timer);
    }, 100);
  }

  document.addEventListener('DOMContentLoaded', function () { search(); ledger(); chapters(); });
})();
