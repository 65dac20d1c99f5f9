// The elements of a picture: text of SVG, the look of its lines, and long curves made short.
//
// Colours are variables of the page (--plot-1 to --plot-6, --plot-axis, --plot-grid, --plot-text), so that a
// picture placed in a page follows its light or dark theme; alone, a picture follows the preference of the
// one who looks at it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace book {

/// How a curve is drawn.
struct Look {
  int colour = 0;       ///< 1 to 6; 0 takes the next one that is free
  double width = 1.6;   ///< in pixels
  bool dashed = false;  ///< a broken line
  bool dots = false;    ///< a marker at each point instead of a line
  double radius = 2.6;  ///< of a marker
  bool named = false;   ///< the label stands beside the last point, in the colour of the curve
};

namespace svg {

/// A place in the picture, in pixels from its upper left corner.
struct Point {
  double x;  ///< to the right
  double y;  ///< downwards
};

/// A coordinate with a tenth of a pixel, which is what one sees.
inline std::string pixel(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", x);
  std::string_view shown = text;
  if (shown.ends_with(".0")) shown.remove_suffix(2);
  return shown == "-0" ? "0" : std::string(shown);
}

/// A text with the signs that mean something in XML written out.
inline std::string escape(std::string_view text) {
  std::string out;
  for (char const c : text)
    out += c == '&'   ? "&amp;"
           : c == '<' ? "&lt;"
           : c == '>' ? "&gt;"
           : c == '"' ? "&quot;"
                      : std::string(1, c);
  return out;
}

/// A picture of `width` by `height` pixels around its elements, with the colours of both themes.
inline std::string picture(double width, double height, std::string const& elements) {
  static constexpr char const* light[] = {"#1c5d99", "#c2571a", "#2c7a4b", "#8a3d86", "#9a7b00", "#5c6670"};
  static constexpr char const* dark[] = {"#7fb4e6", "#f0a06a", "#7fd0a0", "#d79ad3", "#e2c65a", "#98a1aa"};
  auto const colours = [](auto const& list, std::string const& axis, std::string const& grid,
                          std::string const& text) {
    std::string out = ".plot{";
    for (int i = 0; i < 6; ++i)
      out += "--c" + std::to_string(i + 1) + ":var(--plot-" + std::to_string(i + 1) + "," + list[i] + ");";
    return out + "--axis:var(--plot-axis," + axis + ");--grid:var(--plot-grid," + grid +
           ");--text:var(--plot-text," + text + ")}";
  };
  std::string style = colours(light, "#5c6670", "#e6e2d9", "#22272d");
  style += "@media(prefers-color-scheme:dark){" + colours(dark, "#98a1aa", "#2c3137", "#d8dbde") + "}";
  style +=
      ".plot text{fill:var(--text);font-size:12px}.plot .axis{stroke:var(--axis);fill:none}.plot "
      ".grid{stroke:var(--grid);fill:none}";
  for (int i = 1; i <= 6; ++i) {
    auto const n = std::to_string(i);
    // Piece by piece: GCC 12 warns of the sum of these without reason.
    for (char const* const text :
         {".plot .line", "{stroke:var(--c", ");fill:none}.plot .dot", "{fill:var(--c"})
      style += text, style += n;
    style += ");stroke:none}";
  }
  auto const size = pixel(width) + " " + pixel(height);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" width=\"" + pixel(width) + "\" height=\"" +
         pixel(height) + "\" viewBox=\"0 0 " + size + "\" font-family=\"sans-serif\">\n<style>" + style +
         "</style>\n" + elements + "</svg>\n";
}

/// A text at a place. @param anchor  start, middle or end  @param more  further attributes
inline std::string label(Point at, std::string_view text, std::string_view anchor = "start",
                         std::string_view more = "") {
  return "<text x=\"" + pixel(at.x) + "\" y=\"" + pixel(at.y) + "\" text-anchor=\"" + std::string(anchor) +
         "\"" + std::string(more) + ">" + escape(text) + "</text>\n";
}

/// A straight line; `look` is its class: axis or grid.
inline std::string segment(Point a, Point b, std::string_view look) {
  return "<line class=\"" + std::string(look) + "\" x1=\"" + pixel(a.x) + "\" y1=\"" + pixel(a.y) +
         "\" x2=\"" + pixel(b.x) + "\" y2=\"" + pixel(b.y) + "\"/>\n";
}

/// Leaves out the points that lie within `tolerance` pixels of the line through those that stay (Ramer,
/// Douglas and Peucker).
inline std::vector<Point> straighten(std::span<Point const> points, double tolerance) {
  if (points.size() < 3) return {points.begin(), points.end()};
  std::vector<bool> kept(points.size());
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
  while (!open.empty()) {
    auto const [first, last] = open.back();
    open.pop_back();
    Point const a = points[first], b = points[last];
    double const dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
    double farthest = tolerance;
    std::size_t at = 0;
    for (std::size_t i = first + 1; i < last; ++i) {
      double const ex = points[i].x - a.x, ey = points[i].y - a.y;
      double const distance = length > tolerance ? std::abs(dx * ey - dy * ex) / length : std::hypot(ex, ey);
      if (distance > farthest) farthest = distance, at = i;
    }
    if (at == 0) continue;
    kept[at] = true;
    open.push_back({first, at});
    open.push_back({at, last});
  }
  std::vector<Point> out;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (kept[i]) out.push_back(points[i]);
  return out;
}

/// Of a curve that runs to the right, no more than four points in each half pixel: first, lowest, highest,
/// last.
inline std::vector<Point> thin(std::span<Point const> points) {
  if (!std::ranges::is_sorted(points, {}, &Point::x)) return {points.begin(), points.end()};
  std::vector<Point> out;
  for (std::size_t i = 0; i < points.size();) {
    std::size_t end = i, low = i, high = i;
    for (; end < points.size() && std::floor(2 * points[end].x) == std::floor(2 * points[i].x); ++end) {
      if (points[end].y < points[low].y) low = end;
      if (points[end].y > points[high].y) high = end;
    }
    std::size_t stay[] = {i, std::min(low, high), std::max(low, high), end - 1};
    for (int k = 0; k < 4; ++k)
      if (k == 0 || stay[k] != stay[k - 1]) out.push_back(points[stay[k]]);
    i = end;
  }
  return out;
}

/// A curve through points in pixels; breaks where a point is not finite.
inline std::string curve(std::span<Point const> points, Look const& look) {
  auto const colour = std::to_string(look.colour);
  std::string out;
  if (look.dots) {
    for (auto const& p : points)
      if (std::isfinite(p.x) && std::isfinite(p.y))
        out += "<circle class=\"dot" + colour + "\" cx=\"" + pixel(p.x) + "\" cy=\"" + pixel(p.y) +
               "\" r=\"" + pixel(look.radius) + "\"/>\n";
    return out;
  }
  std::string path;
  for (std::size_t i = 0; i < points.size();) {
    std::size_t end = i;
    while (end < points.size() && std::isfinite(points[end].x) && std::isfinite(points[end].y)) ++end;
    if (end > i) {
      char command = 'M';
      for (auto const& p : straighten(thin(points.subspan(i, end - i)), 0.15)) {
        path += command + pixel(p.x) + " " + pixel(p.y);
        command = 'L';
      }
    }
    i = end + 1;
  }
  return "<path class=\"line" + colour + "\" stroke-width=\"" + pixel(look.width) +
         "\" stroke-linejoin=\"round\"" + (look.dashed ? " stroke-dasharray=\"6 4\"" : "") + " d=\"" + path +
         "\"/>\n";
}

}  // namespace svg
}  // namespace book
