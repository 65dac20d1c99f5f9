// A plot: curves over a pair of axes, linear or logarithmic.
//
//   auto plot = book::Plot("step h", "error").log_x().log_y();
//   plot.curve(steps, errors, "natural chart").curve(steps, squares, "h squared", {.dashed = true});
//   program.picture("orders", plot.svg(), "...");
#pragma once

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
  /// @param label  in the legend, or beside the last point where the look says so; none where empty
  /// @throws std::invalid_argument  where x and y differ in length
  Plot& curve(std::span<double const> x, std::span<double const> y, std::string label = "", Look look = {});
  /// Adds points without a line through them.
  Plot& dots(std::span<double const> x, std::span<double const> y, std::string label = "", Look look = {}) {
    look.dots = true;
    return curve(x, y, std::move(label), look);
  }

  /// The picture.
  std::string svg() const;

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
  static void make_equal(Axis& x, Axis& y, Frame const& frame);

  static std::string axes(Axis const& x, Axis const& y, Frame const& frame);

  /// Entries of the legend, in rows above the frame, as many in a row as fit.
  template <class Place>
  int lay_out_legend(Place&& place) const;
  int legend_rows() const;
  std::string legend() const;
  /// Room to the right of the frame for the names of curves.
  double margin_right() const;
  /// The names of curves beside their last points, moved apart where they would overlap.
  /// @param place  pixels of a point
  template <class Place>
  std::string names(Frame const& frame, Place&& place) const;

  Axis x_, y_;
  std::vector<Curve> curves_;
  double width_ = 660, height_ = 400;
  bool equal_ = false;
};

}  // namespace book
