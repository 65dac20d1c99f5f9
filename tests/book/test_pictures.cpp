// Pictures: what is left out of a long curve cannot be seen, and what cannot be drawn leaves a gap.
#include <boost/test/unit_test.hpp>
#include <limits>
#include <random>

#include "book/plot.hpp"
#include "book/sphere.hpp"
#include "book/sphere_map.hpp"

namespace {

using book::svg::Point;

double distance_to_segment(Point p, Point a, Point b) {
  double const dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  double const t = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

std::size_t count(std::string const& text, std::string const& what) {
  std::size_t n = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

}  // namespace

BOOST_AUTO_TEST_CASE(straighten_leaves_out_only_what_lies_on_the_line) {
  std::vector<Point> spiral;
  for (int i = 0; i < 3000; ++i)
    spiral.push_back({(50 + 0.03 * i) * std::cos(0.01 * i), (50 + 0.03 * i) * std::sin(0.01 * i)});
  double const tolerance = 0.15;
  auto const kept = book::svg::straighten(spiral, tolerance);
  BOOST_TEST(kept.size() < spiral.size() / 5);
  for (auto const& p : spiral) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < kept.size(); ++k)
      nearest = std::min(nearest, distance_to_segment(p, kept[k - 1], kept[k]));
    BOOST_TEST(nearest <= tolerance * 1.001);
  }
}

BOOST_AUTO_TEST_CASE(thin_keeps_the_extremes_of_every_half_pixel) {
  std::mt19937 random(1);
  std::vector<Point> noise;
  for (int i = 0; i < 100000; ++i) noise.push_back({0.001 * i, static_cast<double>(random() % 1000)});
  auto const kept = book::svg::thin(noise);
  BOOST_TEST(kept.size() <= 4 * 201u);
  std::map<int, std::pair<double, double>> before, after;
  auto const collect = [](auto const& points, auto& range) {
    for (auto const& p : points) {
      auto& [low, high] = range.try_emplace(static_cast<int>(std::floor(2 * p.x)), p.y, p.y).first->second;
      low = std::min(low, p.y), high = std::max(high, p.y);
    }
  };
  collect(noise, before);
  collect(kept, after);
  BOOST_TEST((before == after));
}

BOOST_AUTO_TEST_CASE(a_value_that_cannot_be_drawn_breaks_the_curve) {
  double const nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> const x{1, 2, 3, 4, 5, 6}, y{1, 2, nan, 2, 0, 3};
  auto const linear = book::Plot("x", "y").curve(x, y).svg();
  BOOST_TEST(linear.find("nan") == std::string::npos);
  auto const path = [](std::string const& svg) { return svg.substr(svg.find("<path class=\"line1\"")); };
  BOOST_TEST(count(path(linear), "M") == 2u);
  // Zero has no place on a logarithmic axis.
  BOOST_TEST(count(path(book::Plot("x", "y").log_y().curve(x, y).svg()), "M") == 3u);
}

BOOST_AUTO_TEST_CASE(ticks_lie_in_the_range_and_are_few) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 500; ++trial) {
    double const scale = std::pow(10.0, static_cast<int>(random() % 40) - 20);
    for (bool const log : {false, true}) {
      book::Axis axis;
      axis.log = log;
      axis.include(scale * (1 + random() % 100));
      axis.include(scale * (200 + random() % 100000));
      axis.close();
      auto const ticks = axis.ticks();
      BOOST_TEST(ticks.size() >= 2u);
      BOOST_TEST(ticks.size() <= 12u);
      for (double const tick : ticks) {
        BOOST_TEST(axis.position(tick) > -1e-6);
        BOOST_TEST(axis.position(tick) < 1 + 1e-6);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(tick_labels_read_as_numbers) {
  book::Axis decades{.label = "", .low = 1e-12, .high = 1, .log = true};
  BOOST_TEST(decades.tick_label(1e-8) == "10⁻⁸");
  BOOST_TEST(decades.tick_label(1) == "1");
  book::Axis small{.label = "", .low = -3e-13, .high = 3e-13};
  BOOST_TEST(small.tick_label(-2e-13) == "−2·10⁻¹³");
  BOOST_TEST(small.tick_label(0) == "0");
  book::Axis plain{.label = "", .low = -1.5, .high = 1.5};
  BOOST_TEST(plain.tick_label(-0.5) == "−0.5");
}

BOOST_AUTO_TEST_CASE(a_curve_of_one_value_or_none_has_a_range) {
  std::vector<double> const x{0, 1}, same{7, 7}, none;
  for (auto const& svg :
       {book::Plot("x", "y").curve(x, same).svg(), book::Plot("x", "y").log_y().curve(x, same).svg(),
        book::Plot("x", "y").curve(none, none).svg(),
        book::Plot("x", "y").log_x().log_y().curve(none, none).svg()}) {
    BOOST_TEST(svg.find("nan") == std::string::npos);
    BOOST_TEST(svg.find("inf") == std::string::npos);
  }
}

BOOST_AUTO_TEST_CASE(curves_of_unequal_length_are_refused) {
  std::vector<double> const x{0, 1}, y{1};
  BOOST_CHECK_THROW(book::Plot("x", "y").curve(x, y), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(what_is_behind_the_sphere_is_dashed) {
  std::vector<std::array<double, 3>> equator;
  for (int i = 0; i <= 360; ++i)
    equator.push_back({std::cos(i * 0.0174532925), std::sin(i * 0.0174532925), 0});
  auto const svg = book::Sphere(0, 20).curve(equator, "", {.colour = 2}).svg();
  auto const back = svg.substr(0, svg.find("</g>")), front = svg.substr(svg.find("</g>"));
  BOOST_TEST(count(back, "class=\"line2\"") == 1u);
  BOOST_TEST(back.find("class=\"line2\" stroke-width=\"1.6\" stroke-linejoin=\"round\" stroke-dasharray") !=
             std::string::npos);
  BOOST_TEST(count(front, "class=\"line2\"") == 1u);
}

BOOST_AUTO_TEST_CASE(names_beside_their_curves_do_not_overlap_and_are_not_in_the_legend) {
  std::vector<double> const x{1, 2};
  book::Plot plot("x", "y");
  std::vector<std::string> const names{"first", "second", "third", "fourth"};
  for (std::size_t k = 0; k < names.size(); ++k) {
    // They end next to each other.
    std::vector<double> const y{static_cast<double>(k), 5 + 1e-3 * static_cast<double>(k)};
    plot.curve(x, y, names[k], {.named = true});
  }
  std::string const svg = plot.svg();
  std::vector<double> heights;
  for (auto const& name : names) {
    BOOST_TEST(count(svg, ">" + name + "<") == 1u);
    auto const at = svg.rfind(" y=\"", svg.find(">" + name + "<"));
    heights.push_back(std::stod(svg.substr(at + 4)));
  }
  std::ranges::sort(heights);
  for (std::size_t k = 1; k < heights.size(); ++k) BOOST_TEST(heights[k] - heights[k - 1] > 12);
  BOOST_TEST(heights.back() < 400);
}

BOOST_AUTO_TEST_CASE(a_field_on_the_sphere_is_smooth_between_the_points_of_its_grid) {
  // z + x y and its neighbours: near the poles, across them and at the seam of the longitudes.
  auto const field = [](double theta, double phi) {
    return std::cos(theta) + 0.5 * std::sin(theta) * std::sin(theta) * std::sin(2 * phi);
  };
  constexpr int rows = 60, columns = 120;
  std::vector<double> values;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      values.push_back(field((i + 0.5) * M_PI / rows, 2 * M_PI * j / columns));
  book::SphereField const smooth(rows, columns, values);
  double worst = 0;
  for (int i = 0; i <= 200; ++i)
    for (int j = 0; j < 200; ++j) {
      double const theta = M_PI * i / 200, phi = 0.0314 * j - 1;
      worst = std::max(worst, std::abs(smooth(theta, phi) - field(theta, phi)));
    }
  // The error of the cubic is about a tenth of the third power of the distance of two points, 0.052.
  BOOST_TEST(worst < 2e-4);
  BOOST_TEST(book::signed_colours().size() == 255u);
  std::string const globe = book::globe({50, 50}, 40, smooth, 1, {20, 30});
  BOOST_TEST(globe.find("data:image/png;base64,iVBORw0KGgo") != std::string::npos);
}
