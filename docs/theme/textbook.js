// Programs to copy and motions to watch. Plain script: it runs from file:// as from anywhere.
(function () {
  'use strict';

  // ---- A button that copies a snippet as a whole program.
  function copies() {
    document.querySelectorAll('button.copy').forEach(function (b) {
      var said = b.textContent;
      b.addEventListener('click', function () {
        var area = document.createElement('textarea');
        area.value = b.dataset.copy;
        document.body.appendChild(area);
        area.select();
        var done = document.execCommand('copy');
        area.remove();
        b.textContent = done ? 'copied' : 'not copied: select the lines';
        setTimeout(function () { b.textContent = said; }, 1600);
      });
    });
  }

  // ---- Motions: rows of numbers from the run that built the book, drawn frame by frame while they are in
  // sight.
  function colours() {
    var style = getComputedStyle(document.documentElement);
    return function (name) { return style.getPropertyValue('--' + name).trim(); };
  }
  /** A point of space on the canvas: seen from a little above, x towards the reader's left. */
  function view(p) {
    var c = Math.cos(0.6), s = Math.sin(0.6), C = Math.cos(0.45), S = Math.sin(0.45);
    var x = c * p[0] - s * p[1], y = s * p[0] + c * p[1];
    return { x: x, y: -(C * p[2] + S * y), depth: C * y - S * p[2] };
  }
  /** The row at a moment, between two rows that were reported. */
  function rowAt(data, time) {
    var rows = data.rows, k = 0;
    while (k + 2 < rows.length && rows[k + 1][0] <= time) ++k;
    var span = rows[k + 1][0] - rows[k][0], w = span > 0 ? Math.min(1, Math.max(0, (time - rows[k][0]) / span)) : 0;
    return { k: k, row: rows[k].map(function (x, i) { return x + w * (rows[k + 1][i] - x); }) };
  }

  var painters = {
    // A box by its attitude: three faces are in sight, each in a colour of its own.
    flip: function (g, w, h, data, time, colour) {
      var R = rowAt(data, time).row.slice(1), f = data.figures, half = [f.a, f.b, f.c].map(function (x) { return x || 1; });
      var size = Math.hypot(half[0], half[1], half[2]), unit = 0.44 * h / size;
      var turn = function (p) { return [0, 1, 2].map(function (i) { return R[3 * i] * p[0] + R[3 * i + 1] * p[1] + R[3 * i + 2] * p[2]; }); };
      var faces = [];
      for (var axis = 0; axis < 3; ++axis) for (var side = -1; side <= 1; side += 2) {
        var u = (axis + 1) % 3, v = (axis + 2) % 3, corners = [[1, 1], [1, -1], [-1, -1], [-1, 1]].map(function (c) {
          var p = [0, 0, 0];
          p[axis] = side * half[axis]; p[u] = c[0] * half[u]; p[v] = c[1] * half[v];
          return view(turn(p));
        });
        faces.push({ axis: axis, side: side, corners: corners, depth: corners.reduce(function (s, c) { return s + c.depth; }, 0) });
      }
      faces.sort(function (a, b) { return b.depth - a.depth; }).forEach(function (face) {
        g.beginPath();
        face.corners.forEach(function (c, i) { g[i ? 'lineTo' : 'moveTo'](w / 2 + unit * c.x, h / 2 + unit * c.y); });
        g.closePath();
        g.fillStyle = colour('page-background-color') || '#fff';
        g.fill();
        g.globalAlpha = face.side > 0 ? 0.75 : 0.35;
        g.fillStyle = colour('plot-' + (face.axis + 1));
        g.fill();
        g.globalAlpha = 1;
        g.strokeStyle = colour('plot-text');
        g.stroke();
      });
    },
    // A momentum on its sphere, with the way that it has come.
    orbit: function (g, w, h, data, time, colour) {
      var at = rowAt(data, time), r = Math.hypot(data.rows[0][1], data.rows[0][2], data.rows[0][3]), unit = 0.44 * h / r;
      g.strokeStyle = colour('plot-axis');
      g.beginPath();
      g.arc(w / 2, h / 2, 0.44 * h, 0, 2 * Math.PI);
      g.stroke();
      var line = function (rows, name, width) {
        for (var k = 1; k < rows.length; ++k) {
          var a = view(rows[k - 1].slice(1)), b = view(rows[k].slice(1));
          g.globalAlpha = a.depth + b.depth < 0 ? 1 : 0.3;
          g.strokeStyle = colour(name);
          g.lineWidth = width;
          g.beginPath();
          g.moveTo(w / 2 + unit * a.x, h / 2 + unit * a.y);
          g.lineTo(w / 2 + unit * b.x, h / 2 + unit * b.y);
          g.stroke();
        }
        g.globalAlpha = 1;
        g.lineWidth = 1;
      };
      // Two great circles, so that the sphere is one, and the whole way.
      [0, 1].forEach(function (upright) {
        var circle = [];
        for (var k = 0; k <= 72; ++k) { var c = r * Math.cos(k * Math.PI / 36), s = r * Math.sin(k * Math.PI / 36); circle.push(upright ? [0, c, 0, s] : [0, c, s, 0]); }
        line(circle, 'plot-grid', 1);
      });
      line(data.rows, 'plot-axis', 1);
      line(data.rows.slice(0, at.k + 1).concat([at.row]), 'plot-1', 2);
      var p = view(at.row.slice(1));
      g.strokeStyle = colour('plot-2');
      g.beginPath();
      g.moveTo(w / 2, h / 2);
      g.lineTo(w / 2 + unit * p.x, h / 2 + unit * p.y);
      g.stroke();
      g.fillStyle = colour('plot-2');
      g.beginPath();
      g.arc(w / 2 + unit * p.x, h / 2 + unit * p.y, 5, 0, 2 * Math.PI);
      g.fill();
    },
    // Marked particles of a fluid, each with a piece of its path.
    fluid: function (g, w, h, data, time, colour) {
      if (!data.box) {
        var xs = [], ys = [];
        data.rows.forEach(function (row) { for (var i = 1; i + 1 < row.length; i += 2) { xs.push(row[i]); ys.push(row[i + 1]); } });
        data.box = [Math.min.apply(0, xs), Math.max.apply(0, xs), Math.min.apply(0, ys), Math.max.apply(0, ys)];
      }
      var b = data.box, unit = Math.min((w - 30) / (b[1] - b[0]), (h - 30) / (b[3] - b[2]));
      var X = function (x) { return w / 2 + unit * (x - (b[0] + b[1]) / 2); }, Y = function (y) { return h / 2 - unit * (y - (b[2] + b[3]) / 2); };
      var at = rowAt(data, time), tail = Math.max(0, at.k - 24), n = (at.row.length - 1) / 2;
      for (var i = 0; i < n; ++i) {
        var name = 'plot-' + (1 + i % 3);
        g.strokeStyle = colour(name);
        g.globalAlpha = 0.45;
        g.beginPath();
        for (var k = tail; k <= at.k; ++k) g[k > tail ? 'lineTo' : 'moveTo'](X(data.rows[k][1 + 2 * i]), Y(data.rows[k][2 + 2 * i]));
        g.lineTo(X(at.row[1 + 2 * i]), Y(at.row[2 + 2 * i]));
        g.stroke();
        g.globalAlpha = 1;
        g.fillStyle = colour(name);
        g.beginPath();
        g.arc(X(at.row[1 + 2 * i]), Y(at.row[2 + 2 * i]), 3, 0, 2 * Math.PI);
        g.fill();
      }
    }
  };

  /** One motion in twelve seconds, over and over, while it is in sight and nobody has stopped it. */
  function animate(canvas) {
    var data = JSON.parse(canvas.nextElementSibling.textContent), paint = painters[canvas.dataset.animation];
    var button = canvas.parentNode.querySelector('button.play'), g = canvas.getContext('2d');
    var width = 640, height = 360, scale = Math.min(2, window.devicePixelRatio || 1), last = data.rows[data.rows.length - 1][0], first = data.rows[0][0];
    canvas.width = width * scale;
    canvas.height = height * scale;
    var playing = !matchMedia('(prefers-reduced-motion: reduce)').matches, inSight = false, elapsed = 0, before = null, asked = false;
    function frame(now) {
      asked = false;
      if (before !== null && playing) elapsed += Math.min(100, now - before) / 12000;
      before = now;
      g.setTransform(scale, 0, 0, scale, 0, 0);
      g.clearRect(0, 0, width, height);
      paint(g, width, height, data, first + (elapsed % 1) * (last - first), colours());
      go();
    }
    function go() {
      if (!asked && inSight && playing) { asked = true; requestAnimationFrame(frame); }
      if (!inSight || !playing) before = null;
    }
    function tell() { button.textContent = playing ? 'stop' : 'play'; }
    button.addEventListener('click', function () { playing = !playing; tell(); go(); });
    new IntersectionObserver(function (entries) { inSight = entries[entries.length - 1].isIntersecting; go(); }).observe(canvas);
    tell();
    requestAnimationFrame(frame);
  }

  document.addEventListener('DOMContentLoaded', function () {
    copies();
    document.querySelectorAll('canvas[data-animation]').forEach(animate);
  });
})();
