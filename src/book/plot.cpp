// A plot as a picture: axes, legend, curves.
#include "book/plot.hpp"

#include <stdexcept>

namespace book {

Plot& Plot::curve(std::span<double const> x, std::span<double const> y, std::string label, Look look) {
  if (x.size() != y.size())
    throw std::invalid_argument("Plot::curve: " + std::to_string(x.size()) + " x for " +
                                std::to_string(y.size()) + " y");
  if (look.colour == 0) look.colour = static_cast<int>(curves_.size()) % 6 + 1;
  curves_.push_back({{x.begin(), x.end()}, {y.begin(), y.end()}, std::move(label), look});
  return *this;
}

template <class Place>
int Plot::lay_out_legend(Place&& place) const {
  double at = margin_left;
  int row = 0;
  for (auto const& c : curves_) {
    if (c.label.empty() || c.look.named) continue;
    double const length = 34 + 6.9 * static_cast<double>(width(c.label)) + 18;
    if (at > margin_left && at + length > width_ - 10) at = margin_left, ++row;
    place(c, at, row);
    at += length;
  }
  return at > margin_left ? row + 1 : 0;
}

int Plot::legend_rows() const {
  return lay_out_legend([](auto const&...) {});
}

std::string Plot::legend() const {
  std::string out;
  lay_out_legend([&](Curve const& c, double x, int row) {
    double const y = 14 + 18 * row;
    svg::Point const sample[] = {{x, y}, {x + 26, y}}, dot[] = {{x + 13, y}};
    out += svg::curve(c.look.dots ? std::span<svg::Point const>(dot) : sample, c.look) +
           svg::label({x + 34, y + 4}, c.label);
  });
  return out;
}

double Plot::margin_right() const {
  double longest = 0;
  for (auto const& c : curves_)
    if (c.look.named) longest = std::max(longest, 22 + 6.3 * static_cast<double>(width(c.label)));
  return std::max(16.0, longest);
}

template <class Place>
std::string Plot::names(Frame const& frame, Place&& place) const {
  constexpr double line = 15;
  struct Name {
    Curve const* curve;
    svg::Point end;
    double y;
  };
  std::vector<Name> all;
  for (auto const& c : curves_) {
    if (!c.look.named) continue;
    for (std::size_t i = c.x.size(); i-- > 0;) {
      svg::Point const end = place(c.x[i], c.y[i]);
      if (!std::isfinite(end.x) || !std::isfinite(end.y)) continue;
      all.push_back({&c, end, end.y});
      break;
    }
  }
  std::ranges::sort(all, {}, &Name::y);
  // Downwards until no two overlap, then upwards from the lower edge.
  for (std::size_t i = 1; i < all.size(); ++i) all[i].y = std::max(all[i].y, all[i - 1].y + line);
  double limit = frame.bottom;
  for (std::size_t i = all.size(); i-- > 0; limit = all[i].y - line) all[i].y = std::min(all[i].y, limit);
  std::string out;
  for (auto const& [curve, end, y] : all) {
    auto const colour = std::to_string(curve->look.colour);
    out +=
        "<path class=\"line" + colour + "\" stroke-width=\"0.6\" d=\"M" + svg::pixel(end.x + 4) + " " +
        svg::pixel(end.y) + "L" + svg::pixel(frame.right + 8) + " " + svg::pixel(y) + "\"/>\n" +
        svg::label({frame.right + 12, y + 4}, curve->label, "start",
                   " class=\"dot" + colour + "\"" + (curve->look.width > 2 ? " font-weight=\"bold\"" : ""));
  }
  return out;
}

void Plot::make_equal(Axis& x, Axis& y, Frame const& frame) {
  double const per_x = (x.high - x.low) / (frame.right - frame.left),
               per_y = (y.high - y.low) / (frame.bottom - frame.top);
  Axis& wide = per_x < per_y ? x : y;
  double const more = std::max(per_x, per_y) / std::min(per_x, per_y), middle = (wide.low + wide.high) / 2;
  double const half = (wide.high - wide.low) / 2 * more;
  wide.low = middle - half, wide.high = middle + half;
}

std::string Plot::axes(Axis const& x, Axis const& y, Frame const& f) {
  std::string out;
  for (double const tick : x.ticks()) {
    double const at = f.left + x.position(tick) * (f.right - f.left);
    out += svg::segment({at, f.top}, {at, f.bottom}, "grid") +
           svg::label({at, f.bottom + 16}, x.tick_label(tick), "middle");
  }
  for (double const tick : y.ticks()) {
    double const at = f.bottom - y.position(tick) * (f.bottom - f.top);
    out += svg::segment({f.left, at}, {f.right, at}, "grid") +
           svg::label({f.left - 7, at + 4}, y.tick_label(tick), "end");
  }
  out += "<path class=\"axis\" d=\"M" + svg::pixel(f.left) + " " + svg::pixel(f.top) + "V" +
         svg::pixel(f.bottom) + "H" + svg::pixel(f.right) + "\"/>\n";
  double const middle = (f.top + f.bottom) / 2;
  out += svg::label({(f.left + f.right) / 2, f.bottom + 38}, x.label, "middle");
  return out + svg::label({16, middle}, y.label, "middle",
                          " transform=\"rotate(-90 16 " + svg::pixel(middle) + ")\"");
}

std::string Plot::svg() const {
  Axis x = x_, y = y_;
  for (auto const& c : curves_)
    for (std::size_t i = 0; i < c.x.size(); ++i)
      if (x.takes(c.x[i]) && y.takes(c.y[i])) x.include(c.x[i]), y.include(c.y[i]);
  x.close(), y.close();
  Frame frame{margin_left, width_ - margin_right(), 14.0 + 18 * legend_rows(), height_ - 48};
  if (equal_) make_equal(x, y, frame);
  auto const place = [&](double u, double v) -> svg::Point {
    return {frame.left + x.position(u) * (frame.right - frame.left),
            frame.bottom - y.position(v) * (frame.bottom - frame.top)};
  };

  std::string out = axes(x, y, frame);
  out += "<clipPath id=\"frame\"><rect x=\"" + svg::pixel(frame.left - 1) + "\" y=\"" +
         svg::pixel(frame.top - 4) + "\" width=\"" + svg::pixel(frame.right - frame.left + 2) +
         "\" height=\"" + svg::pixel(frame.bottom - frame.top + 8) + "\"/></clipPath>\n";
  out += "<g clip-path=\"url(#frame)\">\n";
  for (auto const& c : curves_) {
    std::vector<svg::Point> points;
    for (std::size_t i = 0; i < c.x.size(); ++i) points.push_back(place(c.x[i], c.y[i]));
    out += svg::curve(points, c.look);
  }
  return svg::picture(width_, height_, out + "</g>\n" + names(frame, place) + legend());
}

}  // namespace book
