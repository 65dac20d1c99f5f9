// Maps under judgement: ways to step a free body on a group, our own among them.
//
// The body is left-invariant with a diagonal inertia: its momentum, in the body frame, changes by Pi' =
// ad*_Omega Pi with Omega = Pi/I, on SO(3) by Euler's equations. A rival is a family (h, Pi) -> Pi, written
// at every scalar. Most of them find a motion k of one step first: the configuration moves from g to g k and
// the momentum from Pi to Ad*_k Pi. The same k makes a family (h, p) -> p on T*G, where a costate has the
// spatial momentum.
#pragma once

#include <functional>
#include <string>
#include <tuple>
#include <vector>

#include "actio/groups/rotations.hpp"
#include "actio/groups/unipotent_groups.hpp"
#include "actio/instruments/implicit_map.hpp"

namespace rivals {

using namespace actio;

// A body on G and its inertia: kg m^2 of turning, kg of gliding.
template <Group G>
struct DiagonalBody {
  Coordinates<G, double> inertia;

  template <Scalar S>
  Velocity<G, S> velocity(Momentum<G, S> const& pi) const {
    return {pi.group, pi.components.cwiseQuotient(inertia.template cast<S>())};
  }
  template <Scalar S>
  Momentum<G, S> rate(Momentum<G, S> const& pi) const { return ad_star(velocity(pi), pi); }
};

// The fourth-order Runge-Kutta method, for anything that adds up.
template <class X, class S, class Rate>
X runge_kutta_4(Rate const& rate, S const& h, X const& x) {
  X const k1 = rate(x), k2 = rate(X(x + h / S(2) * k1)), k3 = rate(X(x + h / S(2) * k2)),
          k4 = rate(X(x + h * k3));
  return x + h / S(6) * (k1 + S(2) * k2 + S(2) * k3 + k4);
}

// The implicit midpoint rule: the new momentum solves Pi1 = Pi0 + h rate((Pi0 + Pi1)/2).
template <Group G>
auto midpoint(DiagonalBody<G> body) {
  return [body]<class S>(S const& h, Momentum<G, S> const& pi) {
    using Line = Translations<G::dim>;
    auto const residual = [&](auto const& y, auto const& p) {
      using T = typename std::decay_t<decltype(y)>::Scalar;
      auto const& [step, start] = p;
      Momentum<G, T> const from = over<T>(start), to{start.group, y.value};
      return Momentum<Line, T>{{}, (to - from - T(step) * body.rate((from + to) / T(2))).components};
    };
    return Momentum<G, S>{
        pi.group, solve_implicit(residual, std::tuple(h, pi), Element<Line, S>{{}, pi.components}).value};
  };
}

// Motions k of one step, each a family (h, Pi) -> k.

// Lie and Euler: the velocity as it is at the start.
template <Group G>
auto lie_euler(DiagonalBody<G> body) {
  return [body]<class S>(S const& h, Momentum<G, S> const& pi) { return exp(h * body.velocity(pi)); };
}

// Runge-Kutta-Munthe-Kaas, order 4: classical Runge-Kutta for u with k = exp(u), u' = Omega + [u,
// Omega]/2 + [u, [u, Omega]]/12.
template <Group G>
auto munthe_kaas(DiagonalBody<G> body) {
  return [body]<class S>(S const& h, Momentum<G, S> const& pi) {
    auto const rate = [&](Velocity<G, S> const& u) {
      auto const omega = body.velocity(Ad_star(exp(u), pi)), twist = bracket(u, omega);
      return omega + twist / S(2) + bracket(u, twist) / S(12);
    };
    return exp(
        runge_kutta_4(rate, h, Velocity<G, S>{pi.group, Coordinates<G, S>::Zero(pi.group.dimension())}));
  };
}

// Strang's splitting: the flow of each Pi_a^2/(2 I_a) is a turn (or a shift) at constant speed; half a step
// of each forwards, half a step of each backwards.
template <Group G>
auto strang_splitting(DiagonalBody<G> body) {
  return [body]<class S>(S const& h, Momentum<G, S> pi) {
    auto k = identity<S>(pi.group);
    int const n = pi.group.dimension();
    for (int i = 0; i < 2 * n; ++i) {
      auto const axis = basis_velocity<S>(pi.group, i < n ? i : 2 * n - 1 - i);
      auto const part =
          exp(h / S(2) * pair(Momentum<G, S>{pi.group, body.velocity(pi).coordinates}, axis) * axis);
      k = k * part, pi = Ad_star(part, pi);
    }
    return k;
  };
}

// A discrete Lagrangian l(h, f): the relative motion f starts with the momentum, -L*_f l'(f) = Pi (3.18), and
// k is its inverse.
template <Group G, class Lagrangian>
auto discrete_lagrangian(DiagonalBody<G> body, Lagrangian l) {
  return [body, l]<class S>(S const& h, Momentum<G, S> const& pi) {
    auto const residual = [&](auto const& f, auto const& p) {
      auto const& [step, momentum] = p;
      return left_differential([&](auto const& x) { return l(step, x); }, f) + like(f, momentum);
    };
    return inverse(solve_implicit(residual, std::tuple(h, pi), exp(-h * body.velocity(pi))));
  };
}
// The kinetic energy in a natural chart (3.25): <I log f, log f>/2h.
template <Group G>
auto natural_chart(DiagonalBody<G> body) {
  return [body](auto const& h, auto const& f) {
    using S = typename std::decay_t<decltype(f)>::Scalar;
    auto const eta = log(f).coordinates;
    S sum(0);
    for (Index a = 0; a < eta.size(); ++a) sum += eta[a] * eta[a] * body.inertia[a];
    return S(sum / (S(2) * S(h)));
  };
}
// That of Moser and Veselov on SO(3): Tr((1 - f) Lambda)/h with I_1 = Lambda_2 + Lambda_3 and so on.
template <class Body>
auto moser_veselov(Body body) {
  return [body](auto const& h, auto const& f) {
    using S = typename std::decay_t<decltype(f)>::Scalar;
    S sum(0);
    for (int i = 0; i < 3; ++i) sum += (S(1) - f.value(i, i)) * (body.inertia.sum() / 2 - body.inertia[i]);
    return S(sum / S(h));
  };
}

// From a motion to the family on the dual of the algebra and to the family on T*G.
template <class Motion>
auto on_momenta(Motion motion) {
  return [motion](auto const& h, auto const& pi) { return Ad_star(motion(h, pi), pi); };
}
template <class Motion>
auto on_costates(Motion motion) {
  return [motion](auto const& h, auto const& p) {
    return std::decay_t<decltype(p)>{p.configuration * motion(h, body_momentum(p)), p.momentum};
  };
}

// Classical Runge-Kutta, with no element of the group for a step: on momenta, and on attitudes with momenta
// as matrices of numbers; the attitude is brought back on the group.
template <Group G>
auto classical(DiagonalBody<G> body) {
  return [body](auto const& h, auto const& pi) {
    return runge_kutta_4([&](auto const& m) { return body.rate(m); }, h, pi);
  };
}
template <Group G, Scalar S>
struct Numbers {
  Storage<G, S> g;
  Momentum<G, S> pi;
  Numbers operator+(Numbers const& b) const { return {g + b.g, pi + b.pi}; }
};
template <Group G, Scalar S>
Numbers<G, S> operator*(std::type_identity_t<S> const& s, Numbers<G, S> const& a) {
  return {a.g * s, s * a.pi};
}
template <Group G>
auto classical_on_costates(DiagonalBody<G> body) {
  return [body]<class S>(S const& h, Costate<G, S> const& p) {
    auto const rate = [&](Numbers<G, S> const& x) {
      return Numbers<G, S>{x.g * x.pi.group.hat(body.velocity(x.pi).coordinates), body.rate(x.pi)};
    };
    auto const end = runge_kutta_4(rate, h, Numbers<G, S>{p.configuration.value, body_momentum(p)});
    auto const configuration = restore(Element<G, S>{p.configuration.group, end.g});
    return Costate<G, S>{configuration, Ad_star(inverse(configuration), end.pi)};
  };
}
// The midpoint rule on attitudes too: g1 = g0 + h (g0 + g1)/2 Omega at the middle, which on SO(3) is a Cayley
// transform.
template <Group G>
auto midpoint_on_costates(DiagonalBody<G> body) {
  return [body]<class S>(S const& h, Costate<G, S> const& p) {
    auto const pi = body_momentum(p), after = midpoint(body)(h, pi);
    auto const configuration = p.configuration * retract(h * body.velocity((pi + after) / S(2)));
    return Costate<G, S>{configuration, Ad_star(inverse(configuration), after)};
  };
}

// A family of maps at the two scalars that the instruments ask for: one type for all rivals.
template <template <class, class> class Point, class G>
struct Family {
  template <class S>
  using At = std::function<Point<G, S>(S const&, Point<G, S> const&)>;
  At<double> plain;
  At<Moved<double>> moved;

  template <class F>
  Family(F const& family) : plain(family), moved(family) {}
  auto operator()(double h, Point<G, double> const& x) const { return plain(h, x); }
  auto operator()(Moved<double> const& h, Point<G, Moved<double>> const& x) const { return moved(h, x); }
  // The map of one step h.
  auto with_step(double h) const {
    return [this, h](auto const& x) { return (*this)(typename std::decay_t<decltype(x)>::Scalar(h), x); };
  }
};
template <class G>
struct Rival {
  std::string name;
  Family<Momentum, G> on_momenta;
  Family<Costate, G> on_costates;
};

// Everybody on SO(3), with the attitude; and on any other group, by momenta alone.
inline std::vector<Rival<SO<3>>> on_rotations(DiagonalBody<SO<3>> const& b) {
  auto const from = [](std::string name, auto const& motion) {
    return Rival<SO<3>>{std::move(name), on_momenta(motion), on_costates(motion)};
  };
  return {{"Runge-Kutta 4", classical(b), classical_on_costates(b)},
          {"implicit midpoint", midpoint(b), midpoint_on_costates(b)},
          from("Lie-Euler", lie_euler(b)),
          from("Munthe-Kaas 4", munthe_kaas(b)),
          from("Strang splitting", strang_splitting(b)),
          from("natural chart", discrete_lagrangian(b, natural_chart(b))),
          from("Moser-Veselov", discrete_lagrangian(b, moser_veselov(b)))};
}
template <class G>
std::vector<std::pair<std::string, Family<Momentum, G>>> on_any_group(DiagonalBody<G> const& b) {
  return {{"Runge-Kutta 4", classical(b)},
          {"implicit midpoint", midpoint(b)},
          {"Lie-Euler", on_momenta(lie_euler(b))},
          {"Munthe-Kaas 4", on_momenta(munthe_kaas(b))},
          {"Strang splitting", on_momenta(strang_splitting(b))},
          {"natural chart", on_momenta(discrete_lagrangian(b, natural_chart(b)))}};
}

}  // namespace rivals
