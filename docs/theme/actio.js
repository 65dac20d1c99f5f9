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
  // The input is a combobox: the arrow keys move through its list of options, and the focus stays where one
  // types.
  function search() {
    var input = document.getElementById('book-search');
    if (!input) return;
    var list = document.createElement('div'), index = null, state = 0, chosen = -1;
    list.id = 'book-search-results';
    list.setAttribute('role', 'listbox');
    list.setAttribute('aria-label', 'Places found');
    list.hidden = true;
    document.body.appendChild(list);

    var greek = { '\u03b1': 'alpha', '\u03b2': 'beta', '\u03b3': 'gamma', '\u03b4': 'delta', '\u03b5': 'epsilon', '\u03f5': 'epsilon', '\u03b6': 'zeta', '\u03b7': 'eta', '\u03b8': 'theta', '\u03b9': 'iota',
      '\u03ba': 'kappa', '\u03bb': 'lambda', '\u03bc': 'mu', '\u03bd': 'nu', '\u03be': 'xi', '\u03c0': 'pi', '\u03c1': 'rho', '\u03c3': 'sigma', '\u03c4': 'tau', '\u03c6': 'phi', '\u03d5': 'phi',
      '\u03c7': 'chi', '\u03c8': 'psi', '\u03c9': 'omega' };
    /** The words of a question, as the index has them: Noether's is noether, a Greek letter is its name. */
    function words(text) {
      return text.toLowerCase().replace(/[\u03b1-\u03f5]/g, function (c) { return greek[c] ? ' ' + greek[c] + ' ' : c; }).replace(/['\u2019]s\b/g, '').replace(/[()\[\]{}:^~*+\-"'\u2019`,;]/g, ' ').split(/\s+/).filter(Boolean);
    }
    var isInterface = function (address) { return /^(namespace|struct|class|concept|union)|_8[hc]pp/.test(address); };
    function find(text) {
      text = text.trim();
      var terms = words(text);
      if (!terms.length) return [];
      // Each word by itself, then the places that have them all before those that have some.
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
      var all = Object.keys(found).map(function (k) { return found[k]; }).sort(function (x, y) { return y.words - x.words || y.score - x.score; }).filter(function (f) {
        f.address = window.bookSearch.entries[+f.ref].u;
        var fresh = !seen[f.address];
        seen[f.address] = true;
        return fresh;
      });
      // Plain words are sought in the prose first; what looks like a name of the code is taken as it scores.
      if (/[A-Z].*[A-Z]|[a-z][A-Z]|::|\(\)/.test(text)) return all.slice(0, 12);
      var most = all.length ? all[0].words : 0;
      var prose = all.filter(function (f) { return !isInterface(f.address) && f.words === most; }), rest = all.filter(function (f) { return isInterface(f.address) || f.words < most; });
      return prose.slice(0, rest.length > 4 ? 8 : 12).concat(rest).slice(0, 12);
    }
    function options() { return list.querySelectorAll('[role="option"]'); }
    function choose(k) {
      chosen = k;
      options().forEach(function (o, i) {
        o.className = i === k ? 'on' : '';
        o.setAttribute('aria-selected', String(i === k));
        if (i === k) o.scrollIntoView({ block: 'nearest' });
      });
      if (k >= 0) input.setAttribute('aria-activedescendant', 'book-search-' + k);
      else input.removeAttribute('aria-activedescendant');
    }
    function open(on) {
      list.hidden = !on;
      input.setAttribute('aria-expanded', String(on));
      if (!on) choose(-1);
      if (on) {
        var box = input.getBoundingClientRect();
        list.style.top = Math.round(box.bottom + 6) + 'px';
      }
    }
    function show() {
      if (state !== 2) return;
      list.textContent = '';
      var text = input.value, hits = find(text);
      hits.forEach(function (h, k) {
        var e = window.bookSearch.entries[+h.ref], a = document.createElement('a');
        a.href = e.u;
        a.id = 'book-search-' + k;
        a.tabIndex = -1;
        a.setAttribute('role', 'option');
        [['b', e.t], ['span', e.p === e.t ? '' : e.p], ['small', e.x]].forEach(function (part) {
          var x = document.createElement(part[0]);
          x.textContent = part[1];
          a.appendChild(x);
        });
        list.appendChild(a);
      });
      if (text.trim() && !hits.length) list.textContent = 'Nothing found.';
      open(Boolean(text.trim()));
      choose(-1);
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
      var links = options();
      if (e.key === 'Escape') { open(false); input.blur(); }
      if (e.key === 'Tab') open(false);
      if (e.key === 'Enter' && links.length) { e.preventDefault(); location.href = links[Math.max(chosen, 0)].href; open(false); }
      if (e.key === 'ArrowDown' || e.key === 'ArrowUp') {
        e.preventDefault();
        if (links.length) choose(Math.max(0, Math.min(links.length - 1, chosen + (e.key === 'ArrowDown' ? 1 : -1))));
      }
    });
    document.addEventListener('click', function (e) { if (e.isTrusted && !list.contains(e.target) && e.target !== input) open(false); });
    document.addEventListener('keydown', function (e) {
      if (e.key === '/' && !/INPUT|TEXTAREA/.test(document.activeElement.tagName)) { e.preventDefault(); input.focus(); }
      if (e.key === 'k' && e.ctrlKey) { e.preventDefault(); input.focus(); }
    });
  }

  // ---- Light or dark: a button that the keyboard reaches; the choice is remembered.
  function colours() {
    var button = document.getElementById('book-colours');
    if (!button || typeof DoxygenAwesomeDarkModeToggle === 'undefined') return;
    var dark = function () { return document.documentElement.classList.contains('dark-mode'); };
    var tell = function () { button.setAttribute('aria-pressed', String(dark())); };
    button.addEventListener('click', function () { DoxygenAwesomeDarkModeToggle.userPreference = !dark(); });
    new MutationObserver(tell).observe(document.documentElement, { attributes: true, attributeFilter: ['class'] });
    tell();
  }

  // ---- Tables that are wider than the screen scroll in a box of their own, which the keyboard reaches.
  function boxes() {
    var all = document.querySelectorAll('.contents .table-box, .contents pre.output, .contents div.fragment, .contents pre.fragment, .contents .formula, .contents .report-table');
    function goesOn() { this.classList.toggle('goes-on', this.scrollLeft + this.clientWidth < this.scrollWidth - 2); }
    // All sizes are read before anything is changed, or each change would cost a layout of the page.
    function mark() {
      [].map.call(all, function (box) { return box.scrollWidth > box.clientWidth + 1; }).forEach(function (wide, i) {
        var box = all[i];
        if (!wide) box.removeAttribute('tabindex');
        else if (box.tabIndex !== 0) {
          box.tabIndex = 0;
          box.addEventListener('scroll', goesOn, { passive: true });
        }
        box.classList.toggle('goes-on', wide);
      });
    }
    mark();
    window.addEventListener('resize', mark);
  }

  // ---- Tables of evidence are made when they are opened, from a script that is loaded when the first one is.
  var more = null, waiting = [];
  window.bookMore = function (data) {
    more = data;
    waiting.splice(0).forEach(fill);
  };
  function fill(details) {
    var key = details.dataset.more;
    if (!key || details.dataset.filled) return;
    if (!more) {
      waiting.push(details);
      if (waiting.length === 1) load('more_' + (location.pathname.split('/').pop() || 'index.html').replace(/\.html$/, '.js'), function () {});
      return;
    }
    details.dataset.filled = 'yes';
    var made = document.createElement('div');
    made.innerHTML = more.parts[key].replace(/\u0001(\d+)\u0002/g, function (all, k) { return more.formulas[+k]; });
    while (made.firstChild) details.appendChild(made.firstChild);
    boxes();
  }
  function folded() {
    document.addEventListener('toggle', function (e) { if (e.target.open && e.target.dataset && e.target.dataset.more) fill(e.target); }, true);
    // An address within what is folded opens it.
    function land() {
      var target = location.hash.length > 1 && document.getElementById(decodeURIComponent(location.hash.slice(1)));
      if (!target) return;
      var moved = false;
      for (var up = target; up; up = up.parentElement) if (up.tagName === 'DETAILS' && !up.open) { up.open = true; moved = true; }
      if (moved) target.scrollIntoView();
    }
    window.addEventListener('hashchange', land);
    land();
  }

  // ---- Ledger: by verdict, by words.
  function ledger() {
    var filter = document.querySelector('.ledger-filter');
    if (!filter) return;
    var words = filter.querySelector('input'), verdict = 'all';
    function apply() {
      var text = words.value.toLowerCase();
      document.querySelectorAll('.ledger-chapter, .ledger-sorted').forEach(function (section) {
        var any = false;
        section.querySelectorAll('tbody tr').forEach(function (row) {
          var on = (verdict === 'all' || row.dataset.verdict === verdict) && (!text || row.textContent.toLowerCase().indexOf(text) >= 0);
          row.hidden = !on;
          any = any || on;
        });
        if (section.className === 'ledger-chapter') section.hidden = !any;
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
    // In one table by strength, or each row at its place.
    var order = filter.querySelector('select'), sorted = document.querySelector('.ledger-sorted');
    var rows = [].map.call(document.querySelectorAll('.ledger-chapter tbody tr'), function (row) { return { row: row, home: row.parentNode, strength: Number(row.dataset.strength) }; });
    if (order) order.addEventListener('change', function () {
      var by = order.value, sign = by === 'strong' ? -1 : 1;
      sorted.hidden = by === 'place';
      var list = rows.slice();
      if (by !== 'place') list.sort(function (a, b) { return sign * (a.strength - b.strength) || rows.indexOf(a) - rows.indexOf(b); });
      list.forEach(function (r) { (by === 'place' ? r.home : sorted.querySelector('tbody')).appendChild(r.row); });
      apply();
    });
    var m = /[?&]verdict=(\w+)/.exec(location.search), b = m && filter.querySelector('[data-show="' + m[1] + '"]');
    if (b) b.click();
  }

  // ---- Tree: it stands as it is, without sliding open, and the chapters are always in sight.
  if (window.jQuery) window.jQuery.fx.off = true;
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

  document.addEventListener('DOMContentLoaded', function () { search(); colours(); folded(); ledger(); chapters(); });
  window.addEventListener('load', boxes);
})();
