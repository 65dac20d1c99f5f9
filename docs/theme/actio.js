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
      var text = input.value, hits = index.ask(text, 12);
      hits.forEach(function (e, k) {
        var a = document.createElement('a');
        a.href = e.address;
        a.id = 'book-search-' + k;
        a.tabIndex = -1;
        a.setAttribute('role', 'option');
        [['b', e.title], ['span', e.page === e.title ? '' : e.page], ['small', e.text]].forEach(function (part) {
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
      load('search.js', function () {
        load('search_index.js', function () {
          index = window.bookSearcher.open(window.bookSearch);
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

  // ---- What is wider than the screen scrolls in a box of its own, which the keyboard reaches. It is measured when it comes near.
  var kinds = '.table-box, pre.output, div.fragment, pre.fragment, .formula, .report-table, .markdownTable tbody', near = null;
  function goesOn() { this.classList.toggle('goes-on', this.scrollLeft + this.clientWidth < this.scrollWidth - 2); }
  function fit(all) {
    // All sizes are read before anything is changed, or each change would cost a layout of the page.
    var edge = document.documentElement.clientWidth;
    all.map(function (box) {
      if (box.matches(kinds)) return box.scrollWidth > box.clientWidth + 1;
      // A formula in a line that is wider than a narrow screen scrolls by itself.
      return edge < 768 && !box.classList.contains('wide') && [].some.call(box.querySelectorAll('.base'), function (base) { return base.getBoundingClientRect().right > edge; });
    }).forEach(function (wide, i) {
      var box = all[i];
      if (!box.matches(kinds)) {
        if (wide) box.classList.add('wide');
        return;
      }
      if (!wide) box.removeAttribute('tabindex');
      else if (box.tabIndex !== 0) {
        box.tabIndex = 0;
        box.addEventListener('scroll', goesOn, { passive: true });
      }
      box.classList.toggle('goes-on', wide);
    });
  }
  function measured(within) {
    return [].filter.call((within || document.querySelector('.contents') || document.body).querySelectorAll(kinds + ', .katex'), function (e) { return e.matches(kinds) || !e.closest(kinds); });
  }
  /** All at once, for a reader who looks at the whole page. */
  window.bookFit = function () { fit(measured()); };
  function boxes(within) {
    var all = measured(within);
    if (!near) {
      near = new IntersectionObserver(function (list) { fit(list.filter(function (e) { return e.isIntersecting; }).map(function (e) { return e.target; })); }, { rootMargin: '800px' });
      var width = innerWidth;
      window.addEventListener('resize', function () {
        if (innerWidth === width) return;
        width = innerWidth;
        near.disconnect();
        boxes();
      });
    }
    all.forEach(function (e) { near.observe(e); });
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
    boxes(details);
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
  window.addEventListener('load', function () { boxes(); });
})();
