// A plot: curves over a pair of axes, linear or logarithmic.
//
//   auto plot = book::Plot("step h", "error").log_x().log_y();
//   plot.curve(steps, errors, "natural chart").curve(steps, squares, "h squared", {.dashed = true});
//   program.picture("orders", plot.svg(), "...");
#pragma once

#include <stdexcept>

#include "book/axis.hpp"
#include "book/svg.hpp"

namespace book {

/// Curves over a pair of axes; every function returns the plot, so that calls can be joined.
class Plot {
 public:
  /// @param x_label  what runs to the right, with its unit: "time, s"
  /// @param y_label  what runs upwards
  Plot(std::string x_label, std::string y_label) : x_{std::move(x_label)}, y_{std::move(y_label)} {}

  /// A logarithmic axis to the right.
  Plot& log_x() { return x_.log = true, *this; }
  /// A logarithmic axis upwards.
  Plot& log_y() { return y_.log = true, *this; }
  /// One unit is as long on both axes.
  Plot& equal() { return equal_ = true, *this; }
  /// The size of the whole picture, in pixels.
  Plot& size(double width, double height) { return width_ = width, height_ = height, *this; }
  /// Fixes the range of an axis, which otherwise holds all curves.
  Plot& x_range(double low, double high) { return x_.low = low, x_.high = high, x_.fixed = true, *this; }
  /// The same for the axis upwards.
  Plot& y_range(double low, double high) { return y_.low = low, y_.high = high, y_.fixed = true, *this; }

  /// Adds a curve. Points that are not finite, or not positive on a logarithmic axis, leave a gap.
  /// @param label  in the legend; none where empty
  /// @throws std::invalid_argument  where x and y differ in length
  Plot& curve(std::span<double const> x, std::span<double const> y, std::string label = "", Look look = {}) {
    if (x.size() != y.size())
      throw std::invalid_argument("Plot::curve: " + std::to_string(x.size()) + " x for " + std::to_string(y.size()) + " y");
    if (look.colour == 0) look.colour = static_cast<int>(curves_.size()) % 6 + 1;
    curves_.push_back({{x.begin(), x.end()}, {y.begin(), y.end()}, std::move(label), look});
    return *this;
  }
  /// Adds points without a line through them.
  Plot& dots(std::span<double const> x, std::span<double const> y, std::string label = "", Look look = {}) {
    look.dots = true;
    return curve(x, y, std::move(label), look);
  }

  /// The picture.
  std::string svg() const {
    Axis x = x_, y = y_;
    for (auto const& c : curves_)
      for (std::size_t i = 0; i < c.x.size(); ++i)
        if (x.takes(c.x[i]) && y.takes(c.y[i])) x.include(c.x[i]), y.include(c.y[i]);
    x.close(), y.close();
    Frame frame{margin_left, width_ - 16, 14.0 + 18 * legend_rows(), height_ - 48};
    if (equal_) make_equal(x, y, frame);
    auto const place = [&](double u, double v) -> svg::Point {
      return {frame.left + x.position(u) * (frame.right - frame.left), frame.bottom - y.position(v) * (frame.bottom - frame.top)};
    };

    std::string out = axes(x, y, frame);
    out += "<clipPath id=\"frame\"><rect x=\"" + svg::pixel(frame.left - 1) + "\" y=\"" + svg::pixel(frame.top - 4) + "\" width=\"" +
           svg::pixel(frame.right - frame.left + 2) + "\" height=\"" + svg::pixel(frame.bottom - frame.top + 8) + "\"/></clipPath>\n";
    out += "<g clip-path=\"url(#frame)\">\n";
    for (auto const& c : curves_) {
      std::vector<svg::Point> points;
      for (std::size_t i = 0; i < c.x.size(); ++i) points.push_back(place(c.x[i], c.y[i]));
      out += svg::curve(points, c.look);
    }
    return svg::picture(width_, height_, out + "</g>\n" + legend());
  }

 private:
  struct Curve {
    std::vector<double> x, y;
    std::string label;
    Look look;
  };
  struct Frame {
    double left, right, top, bottom;
  };
  static constexpr double margin_left = 78;

  /// Widens the axis that has too little, so that a unit is as long on both.
  static void make_equal(Axis& x, Axis& y, Frame const& frame) {
    double const per_x = (x.high - x.low) / (frame.right - frame.left), per_y = (y.high - y.low) / (frame.bottom - frame.top);
    Axis& wide = per_x < per_y ? x : y;
    double const more = std::max(per_x, per_y) / std::min(per_x, per_y), middle = (wide.low + wide.high) / 2;
    double const half = (wide.high - wide.low) / 2 * more;
    wide.low = middle - half, wide.high = middle + half;
  }

  static std::string axes(Axis const& x, Axis const& y, Frame const& f) {
    std::string out;
    for (double const tick : x.ticks()) {
      double const at = f.left + x.position(tick) * (f.right - f.left);
      out += svg::segment({at, f.top}, {at, f.bottom}, "grid") + svg::label({at, f.bottom + 16}, x.tick_label(tick), "middle");
    }
    for (double const tick : y.ticks()) {
      double const at = f.bottom - y.position(tick) * (f.bottom - f.top);
      out += svg::segment({f.left, at}, {f.right, at}, "grid") + svg::label({f.left - 7, at + 4}, y.tick_label(tick), "end");
    }
    out += "<path class=\"axis\" d=\"M" + svg::pixel(f.left) + " " + svg::pixel(f.top) + "V" + svg::pixel(f.bottom) + "H" +
           svg::pixel(f.right) + "\"/>\n";
    double const middle = (f.top + f.bottom) / 2;
    out += svg::label({(f.left + f.right) / 2, f.bottom + 38}, x.label, "middle");
    return out + svg::label({16, middle}, y.label, "middle", " transform=\"rotate(-90 16 " + svg::pixel(middle) + ")\"");
  }

  /// Entries of the legend, in rows above the frame, as many in a row as fit.
  template <class Place>
  int lay_out_legend(Place&& place) const {
    double at = margin_left;
    int row = 0;
    for (auto const& c : curves_) {
      if (c.label.empty()) continue;
      double const length = 34 + 6.9 * static_cast<double>(width(c.label)) + 18;
      if (at > margin_left && at + length > width_ - 10) at = margin_left, ++row;
      place(c, at, row);
      at += length;
    }
    return at > margin_left ? row + 1 : 0;
  }
  int legend_rows() const {
    return lay_out_legend([](auto const&...) {});
  }
  std::string legend() const {
    std::string out;
    lay_out_legend([&](Curve const& c, double x, int row) {
      double const y = 14 + 18 * row;
      svg::Point const sample[] = {{x, y}, {x + 26, y}}, dot[] = {{x + 13, y}};
      out += svg::curve(c.look.dots ? std::span<svg::Point const>(dot) : sample, c.look) + svg::label({x + 34, y + 4}, c.label);
    });
    return out;
  }

  Axis x_, y_;
  std::vector<Curve> curves_;
  double width_ = 660, height_ = 400;
  bool equal_ = false;
};

}  // namespace book
