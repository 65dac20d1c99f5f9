// A plot: curves over a pair of axes, linear or logarithmic.
//
//   auto plot = book::Plot("step h", "error").log_x().log_y();
//   plot.curve(steps, errors, "natural chart").curve(steps, squares, "h squared", {.dashed = true});
//   program.picture("orders", plot.svg(), "...");
#pragma once

#include <limits>
#include <stdexcept>

#include "book/program.hpp"
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
    auto const clip = std::to_string(std::hash<std::string>{}(x_.label + y_.label + std::to_string(curves_.size())) % 100000);
    out += "<clipPath id=\"frame" + clip + "\"><rect x=\"" + svg::pixel(frame.left - 1) + "\" y=\"" + svg::pixel(frame.top - 4) + "\" width=\"" +
           svg::pixel(frame.right - frame.left + 2) + "\" height=\"" + svg::pixel(frame.bottom - frame.top + 8) + "\"/></clipPath>\n";
    out += "<g clip-path=\"url(#frame" + clip + ")\">\n";
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

  /// One axis: its range, and where in it a value lies, from 0 to 1.
  struct Axis {
    std::string label;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    bool log = false, fixed = false;

    bool takes(double value) const { return std::isfinite(value) && (!log || value > 0); }
    void include(double value) {
      if (!fixed) low = std::min(low, value), high = std::max(high, value);
    }
    /// Leaves room at the ends, and gives a single value, or none, a range around it.
    void close() {
      if (!(low <= high)) low = high = log ? 1 : 0;
      if (fixed) return;
      double const from = scaled(low), to = scaled(high);
      double const smallest = log ? 0.02 : 1e-12 * std::max(std::abs(low), std::abs(high));
      double const room = to - from > smallest ? 0.03 * (to - from) : log ? 0.5 : std::max(std::abs(low), 1.0) / 2;
      low = unscaled(from - room), high = unscaled(to + room);
    }
    double scaled(double value) const { return log ? std::log10(value) : value; }
    double unscaled(double value) const { return log ? std::pow(10.0, value) : value; }
    double position(double value) const {
      return takes(value) ? (scaled(value) - scaled(low)) / (scaled(high) - scaled(low)) : std::numeric_limits<double>::quiet_NaN();
    }

    /// Distance between ticks: 1, 2 or 5 times a power of ten, whole decades on a logarithmic axis; about six in all.
    double spacing() const {
      double const raw = (scaled(high) - scaled(low)) / 6;
      double const power = std::pow(10.0, std::floor(std::log10(raw)));
      double const nice = raw / power < 1.5 ? 1 : raw / power < 3.5 ? 2 : raw / power < 7.5 ? 5 : 10;
      return log ? std::max(1.0, std::round(raw)) : nice * power;
    }
    std::vector<double> ticks() const {
      std::vector<double> out;
      double const step = spacing(), from = scaled(low), to = scaled(high);
      bool const narrow = log && to - from < 1.6;
      if (narrow) {
        for (int decade = static_cast<int>(std::floor(from)); decade <= to; ++decade)
          for (int digit = 1; digit < 10; ++digit) {
            double const value = digit * std::pow(10.0, decade);
            bool const shown = to - from < 0.8 || digit == 1 || digit == 2 || digit == 5;
            if (shown && value >= low && value <= high) out.push_back(value);
          }
        return out;
      }
      for (double k = std::ceil(from / step - 1e-9); k * step <= to + 1e-9 * step; ++k) out.push_back(unscaled(k * step));
      return out;
    }
    /// A tick for a reader: 0.25, −3, 10⁻¹², 2·10⁻⁸.
    std::string tick_label(double value) const {
      if (!log && std::abs(value) < 1e-9 * spacing()) return "0";
      int const exponent = static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-9));
      bool const decades = log && scaled(high) - scaled(low) > 4;
      double const largest = std::max(std::abs(low), std::abs(high));
      bool const plain = decades ? std::abs(exponent) < 2 : log ? std::abs(exponent) < 4 : largest >= 1e-3 && largest < 1e5;
      std::string const shown = number(plain ? value : value / std::pow(10.0, exponent), 6);
      std::string out = shown[0] == '-' ? "−" + shown.substr(1) : shown;
      return plain ? out : (out == "1" ? "" : out == "−1" ? "−" : out + "·") + power_of_ten(exponent);
    }
    static std::string power_of_ten(int exponent) {
      static constexpr char const* raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
      std::string out = exponent < 0 ? "10⁻" : "10";
      for (char const digit : std::to_string(std::abs(exponent))) out += raised[digit - '0'];
      return out;
    }
  };

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
    out += "<path class=\"axis\" d=\"M" + svg::pixel(f.left) + " " + svg::pixel(f.top) + "V" + svg::pixel(f.bottom) + "H" + svg::pixel(f.right) + "\"/>\n";
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
