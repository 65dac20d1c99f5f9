#include "actio/rods/rod_shape.hpp"

#include <algorithm>
#include <cmath>

#include "actio/numbers/errors.hpp"

namespace actio::rods {
namespace {

double length_of(Three<double> const& v) { return std::hypot(v[0], v[1], v[2]); }

/// The rotation \f$\mathrm{cay}(w)\f$, a unit quaternion.
Four<double> cayley(Three<double> const& w) {
  double const scale = 1 / std::sqrt(1 + bodies::dot(w, w) / 4);
  return {scale, scale * w[0] / 2, scale * w[1] / 2, scale * w[2] / 2};
}
/// The inverse of \ref RelativePlacement::stretch.
Three<double> shift_of(Three<double> const& w, Three<double> const& stretch) {
  return times(1 / (1 + bodies::dot(w, w) / 4), cayley_differential(w, stretch));
}
/// The least rotation that takes one unit vector to another.
Four<double> least_turn(Three<double> const& from, Three<double> const& to) {
  Three<double> const axis = cross(from, to);
  double const c = 1 + bodies::dot(from, to), size = std::sqrt(c * c + bodies::dot(axis, axis));
  return {c / size, axis[0] / size, axis[1] / size, axis[2] / size};
}

void require_elements(int elements) {
  if (elements < 2) throw OutsideDomain("rod", "a rod has two elements at least; elements", elements, 2);
}
void require_turn(std::size_t element, Three<double> const& w) {
  if (double const turn = length_of(w); !(turn <= largest_turn))
    throw OutsideDomain("rod",
                        "more elements are needed where a rod is bent more: element " +
                            std::to_string(element) + " turns by an angle of",
                        2 * std::atan(turn / 2), 2 * std::atan(largest_turn / 2));
}

/// The attitude with this first axis, and the second one near a direction.
Four<double> attitude_of(Three<double> const& along, Three<double> const& across) {
  Three<double> const third = cross(along, across);
  double const size = length_of(third);
  if (!(size > 1e-12 * length_of(across)))
    throw OutsideDomain("rod", "the second axis must not point along the rod; sine of the angle between them",
                        size, 1e-12);
  Four<double> const first = least_turn({1, 0, 0}, along);
  // About the first axis to the second one.
  Three<double> const second = bodies::turned_back(first, cross(times(1 / size, third), along));
  double const angle = std::atan2(second[2], second[1]) / 2;
  return bodies::compose(first, {std::cos(angle), std::sin(angle), 0, 0});
}

}  // namespace

RelativePlacement<double> RodShape::element(std::size_t k) const {
  auto const next = after(k);
  Three<double> dx;
  for (std::size_t i = 0; i < 3; ++i) dx[i] = places[next][i] - places[k][i];
  return RelativePlacement<double>::of(attitudes[k], attitudes[next], dx);
}

RodShape RodShape::of_strains(double length, int elements, Three<double> const& place,
                              Four<double> const& attitude, Strain const& kappa, Strain const& Gamma) {
  require_elements(elements);
  if (!(length > 0 && std::isfinite(length)))
    throw OutsideDomain("rod", "the length must be a positive number; it", length, 0);
  double const D = length / elements;
  RodShape out{{place}, {attitude}};
  for (int k = 0; k < elements; ++k) {
    double const s = (k + 0.5) * D;
    Three<double> const w = times(D, kappa ? kappa(s) : Three<double>{}),
                        stretch = times(D, Gamma ? Gamma(s) : Three<double>{1, 0, 0});
    require_turn(static_cast<std::size_t>(k), w);
    out.places.push_back(bodies::plus(out.places.back(), turned(out.attitudes.back(), shift_of(w, stretch))));
    out.attitudes.push_back(bodies::compose(out.attitudes.back(), cayley(w)));
  }
  return out;
}

RodShape RodShape::along(std::function<std::pair<Three<double>, Three<double>>(double)> const& at,
                         int elements, Three<double> const& across, bool closed) {
  require_elements(elements);
  RodShape out;
  out.closed = closed;
  Three<double> before{};
  for (int k = 0; k <= elements; ++k) {
    auto const [place, slope] = at(static_cast<double>(k) / elements);
    double const size = length_of(slope);
    if (!(size > 0 && std::isfinite(size)))
      throw OutsideDomain("rod", "the curve has no tangent at node " + std::to_string(k) + "; its length",
                          size, 0);
    Three<double> const tangent = times(1 / size, slope);
    out.places.push_back(place);
    out.attitudes.push_back(k == 0 ? attitude_of(tangent, across)
                                   : bodies::compose(least_turn(before, tangent), out.attitudes.back()));
    before = tangent;
  }
  if (closed) {
    // What the axes are turned by after one round is taken back by equal parts.
    Four<double> const round = bodies::compose(inverse_turn(out.attitudes.front()), out.attitudes.back());
    double const angle = std::remainder(2 * std::atan2(round[1], round[0]), 2 * M_PI);
    for (int k = 0; k < elements; ++k) {
      double const part = -angle / 2 * k / elements;
      auto& q = out.attitudes[static_cast<std::size_t>(k)];
      q = bodies::compose(q, {std::cos(part), std::sin(part), 0, 0});
    }
    out.places.pop_back(), out.attitudes.pop_back();
  }
  for (std::size_t k = 0; k < out.elements(); ++k) require_turn(k, out.element(k).w);
  return out;
}

std::vector<ElementAtRest<double>> elements_at_rest(RodShape const& shape) {
  std::vector<ElementAtRest<double>> out;
  for (std::size_t k = 0; k < shape.elements(); ++k) {
    auto const e = shape.element(k);
    Three<double> const stretch = e.stretch();
    double const inverse = 1 / length_of(stretch);
    if (!std::isfinite(inverse))
      throw OutsideDomain("rod", "two neighbouring sections are at one place; element",
                          static_cast<double>(k), 0);
    out.push_back({inverse, times(inverse, stretch), times(inverse, e.w)});
  }
  return out;
}

}  // namespace actio::rods
