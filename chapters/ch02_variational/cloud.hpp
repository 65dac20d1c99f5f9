// Clouds of nearby states: how a step carries them, the closed curve round them, and the area they cover.
//
// A state is a dual number that carries a tangent vector along: with the tangent of the rim, in the programs
// of this folder.
#pragma once

#include "actio/variational/curves.hpp"
#include "actio/variational/lagrange_forms.hpp"

// A step of the length h along the motion, at any scalar: with dual numbers the step carries tangent vectors
// along. Explicit Euler: the whole step with the velocity and acceleration of its beginning.
template <class G, class S, class Acceleration>
actio::State<G, S> explicit_euler(Acceleration const& acceleration, actio::State<G, S> const& v, double h) {
  return {actio::exp(S(h) * v.velocity) * v.configuration, v.velocity + S(h) * acceleration(v)};
}
// The classical Runge-Kutta method, on matrices: with short steps as good as the flow itself.
template <class G, class S, class Acceleration>
actio::State<G, S> runge_kutta(Acceleration const& acceleration, actio::State<G, S> const& v, double h) {
  actio::State<G, S> sum = v, stage = v;
  for (int i = 0; i < 4; ++i) {
    actio::Storage<G, S> const configuration =
        v.configuration.group.hat(stage.velocity.coordinates) * stage.configuration.value;
    auto const rate = acceleration(stage);
    S const share(h * (i == 0 || i == 3 ? 1 : 2) / 6), next(i == 2 ? h : h / 2);
    sum.configuration.value += configuration * share, sum.velocity = sum.velocity + share * rate;
    stage.configuration.value = v.configuration.value + configuration * next,
    stage.velocity = v.velocity + next * rate;
  }
  return sum;
}
// A closed curve of states, `states(s)` for s from 0 to 2 pi, each with its tangent.
template <class States>
auto closed_curve(int points, States const& states) {
  std::vector<decltype(states(actio::Dual<double>(0)))> rim;
  for (int k = 0; k < points; ++k) {
    actio::Dual<double> s(2 * M_PI * k / points);
    s.part[0] = 2 * M_PI / points;
    rim.push_back(states(s));
  }
  return rim;
}
// The integral of the Lagrange one-form round the rim, the sum of the areas of the shadows: to rounding where
// it is smooth.
template <class Lagrangian, class Rim>
double shadows(Lagrangian const& L, Rim const& rim) {
  double sum = 0;
  for (auto const& v : rim) sum += actio::lagrange_one_form(L, actio::value_of(v), actio::change_of(v));
  return sum;
}
