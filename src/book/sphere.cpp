// A sphere as a picture: what lies before it, what lies behind it.
#include "book/sphere.hpp"

#include <numbers>

namespace book {

Sphere::Sphere(double azimuth, double elevation) {
  double const a = azimuth * std::numbers::pi / 180, e = elevation * std::numbers::pi / 180;
  right_ = {-std::sin(a), std::cos(a), 0};
  up_ = {-std::sin(e) * std::cos(a), -std::sin(e) * std::sin(a), std::cos(e)};
  eye_ = {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
}

void Sphere::add(Curve const& c, std::string& behind, std::string& before) const {
  Look hidden = c.look;
  hidden.dashed = true;
  std::vector<svg::Point> seen, unseen;
  svg::Point const gap{std::numeric_limits<double>::quiet_NaN(), 0};
  for (std::size_t i = 0; i < c.points.size(); ++i) {
    Vector const& p = c.points[i];
    bool const front = depth(p) >= 0;
    if (i > 0 && !c.look.dots && front != (depth(c.points[i - 1]) >= 0)) {
      auto const edge = place(crossing(c.points[i - 1], p));
      for (auto* part : {&seen, &unseen}) part->push_back(edge);
      (front ? unseen : seen).push_back(gap);
    }
    (front ? seen : unseen).push_back(place(p));
  }
  before += svg::curve(seen, c.look);
  behind += svg::curve(unseen, hidden);
}

Sphere::Vector Sphere::crossing(Vector const& a, Vector const& b) const {
  double const t = depth(a) / (depth(a) - depth(b));
  Vector p{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
  double const length = std::sqrt(dot(p, p));
  return {p[0] / length, p[1] / length, p[2] / length};
}

void Sphere::add_graticule(std::string& behind, std::string& before) const {
  constexpr double degree = std::numbers::pi / 180;
  auto const draw = [&](auto&& point) {
    Curve circle{{}, "", {.colour = 1, .width = 0.8}};
    for (int t = 0; t <= 360; t += 3) circle.points.push_back(point(t * degree));
    std::string hidden, shown;
    add(circle, hidden, shown);
    for (auto* part : {&hidden, &shown}) part->replace(part->find("line1"), 5, "grid");
    behind += hidden, before += shown;
  };
  for (int latitude = -60; latitude <= 60; latitude += 30)
    draw([&](double t) {
      return Vector{std::cos(latitude * degree) * std::cos(t), std::cos(latitude * degree) * std::sin(t),
                    std::sin(latitude * degree)};
    });
  for (int longitude = 0; longitude < 180; longitude += 30)
    draw([&](double t) {
      return Vector{std::cos(t) * std::cos(longitude * degree), std::cos(t) * std::sin(longitude * degree),
                    std::sin(t)};
    });
}

std::string Sphere::axis_arrows() const {
  std::string out;
  for (int i = 0; i < 3; ++i) {
    if (names_[i].empty()) continue;
    Vector unit{};
    unit[i] = 1;
    auto const foot = place(unit);
    unit[i] = 1.16;
    auto const tip = place(unit);
    unit[i] = 1.25;
    auto const name = place(unit);
    if (depth(unit) >= 0 || std::hypot(tip.x - centre, tip.y - centre) > radius)
      out += svg::segment(foot, tip, "axis");
    out += svg::label({name.x, name.y + 4}, names_[i], "middle");
  }
  return out;
}

std::string Sphere::svg() const {
  std::string behind, before;
  add_graticule(behind, before);
  for (auto const& c : curves_) add(c, behind, before);
  auto const disc = [](std::string const& look) {
    return "<circle " + look + " cx=\"" + svg::pixel(centre) + "\" cy=\"" + svg::pixel(centre) + "\" r=\"" +
           svg::pixel(radius) + "\"/>\n";
  };
  std::string out = disc("fill=\"var(--grid)\" fill-opacity=\"0.35\"") + "<g opacity=\"0.45\">\n" + behind +
                    "</g>\n" + disc("class=\"axis\"") + before + axis_arrows();
  double y = 2 * centre + 6;
  for (auto const& c : curves_) {
    if (c.label.empty()) continue;
    svg::Point const sample[] = {{40, y}, {66, y}}, dot[] = {{53, y}};
    out += svg::curve(c.look.dots ? std::span<svg::Point const>(dot) : sample, c.look) +
           svg::label({76, y + 4}, c.label);
    y += 18;
  }
  return svg::picture(2 * centre, y + 2, out);
}

}  // namespace book
