// First variations of the spreading gas, and the flux of two variations through the boundary of a box.
#pragma once

#include "actio/jets/action.hpp"
#include "actio/jets/cartan.hpp"
#include "gas_ellipse.hpp"
#include "witness/draw.hpp"

// [first_variation]
// A first variation: the rate at which the cloud changes with its state at the time `start`.
inline LinearMotion<double, 2> neighbour(EllipticGas const& gas, double start, std::uint64_t seed) {
  actio::Draw draw(seed);
  auto state = thrown_gas().cast<actio::Dual<double>>().eval();
  for (auto& s : state) s.part[0] = draw.number<double>();
  // The series of a dual motion: its rates of change are a linear motion again.
  LinearMotion<double, 2> variation{start, {}};
  for (auto const& term : linear_motion<2>(gas, state, start).terms)
    variation.terms.push_back(actio::rate_of(term));
  return variation;
}
// [first_variation]

// [flux_of_variations]
// The flux of two vertical variations through the boundary of a box, an integral of the multisymplectic form.
template <class Medium, class Phi, class FieldV, class FieldW>
double flux(Medium const& medium, Phi const& phi, FieldV const& V, FieldW const& W,
            actio::Box<double, 2> const& box, int degree) {
  auto const form = actio::multisymplectic_form<2, 2>(medium);
  // A vertical variation along the solution as a tangent vector of the jet bundle: no change of x, its own
  // value and slopes.
  auto const lifted = [](auto const& variation, auto const& x) {
    auto jet = actio::first_jet(variation, x);
    jet.x.setZero();
    return coordinates(jet);
  };
  auto const pulled_back_form = [&](actio::Event<double, 2> const& x,
                                    actio::Tangents<double, 3, 2> const& sides) {
    actio::Tangents<double, 11, 4> T;
    // W is contracted first, so it stands in the first slot.
    T << lifted(W, x), lifted(V, x), pushed(actio::jet_extension(phi), x, sides);
    return form(coordinates(actio::first_jet(phi, x)), T);
  };
  // [eq_6_11]
  return boundary_integral(pulled_back_form, box, degree);
  // [eq_6_11]
}
// [flux_of_variations]
