// The laws of a Lie group, written once, for the groups of the library and for a reader's own.
//
//   auto const findings = actio::laws::check<double>(MyGroup{}, seed, edges);
//   for (auto const& f : findings) BOOST_TEST(f.holds(), f.text());
//
// Every law is a residual that vanishes: exactly over the rationals, to `allowed` roundings of the size of
// its terms otherwise. They are tried in four regimes: at the identity, within 1e-8 of it, at random
// elements, and at the velocities `edges` next to the edge of the chart. The laws of a Group need no roots
// and run over any field; those of an ExponentialGroup run where the scalar is Real.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "any_group.hpp"

#include "actio/linear_algebra/iex.hpp"
#include "witness/draw.hpp"

namespace actio::laws {

/// The worst that was measured for one law: the residual in units of (epsilon x size of the terms), and how
/// much of it is rounding.
struct Finding {
  std::string law, regime;
  double measured = 0, allowed = 0;

  bool holds() const { return measured <= allowed; }
  std::string text() const {
    return law + " (" + regime + "): " + show(measured) + " roundings, allowed " + show(allowed);
  }
};

/// A velocity next to the edge of the chart, and by how much the logarithm magnifies rounding there.
template <class S>
struct Edge {
  AnyVector<S> velocity;
  double condition = 1;
};

template <Scalar S>
class Laws {
  using G = AnyGroup<S>;

 public:
  Laws(G const& which, std::uint64_t seed) : group(which), draw(seed) {}

  std::vector<Finding> findings;

  void run(std::vector<Edge<S>> const& edges) {
    for (auto const& [name, size] : {std::pair<char const*, S>{"identity", S(0)},
                                     {"within 1e-8", ratio<S>(1, 100000000)},
                                     {"generic", ratio<S>(1, 2)}})
      for (int repeat = 0; repeat < 3; ++repeat) {
        regime = name;
        algebraic(size);
        if constexpr (Real<S>) {
          if (exact_arithmetic<S>()) continue;
          exponential(velocity(size), velocity(S(1)), 1);
          if (repeat == 0) restoring(exp(velocity(size)));
        }
      }
    if constexpr (Real<S>)
      for (auto const& edge : edges) {
        if (exact_arithmetic<S>()) continue;
        regime = "edge of the chart";
        exponential({group, edge.velocity}, velocity(S(1)), edge.condition);
      }
  }

 private:
  G group;
  Draw draw;
  std::string regime;

  Velocity<G, S> velocity(S const& size) { return draw.velocity<S>(group, size); }
  Element<G, S> element(S const& size) { return draw.element<S>(group, size); }
  template <Scalar T>
  static Element<G, T> near_one(Velocity<G, T> const& v) {
    return {v.group, primitive::near_identity(v.group, v.coordinates)};
  }
  /// The size of a matrix that multiplies, at least 1.
  template <Scalar T>
  static double size(Element<G, T> const& g) {
    return std::max(1.0, to_double(magnitude(g.value)) * static_cast<double>(g.value.rows()));
  }
  template <Scalar T>
  static double size(Velocity<G, T> const& v) { return to_double(magnitude(v.coordinates)); }

  /// The residual vanishes: it is at most `allowed` roundings of `scale`.
  template <MatrixLike M>
  void vanishes(std::string const& law, M const& residual, double scale, double allowed) {
    auto const size = magnitude(residual.eval());
    double measured = 0;
    if (!is_finite(size))
      measured = HUGE_VAL;
    else if (size != Base<S>(0))
      measured = exact_arithmetic<S>() ? HUGE_VAL
                 : scale > 0           ? to_double(size) / (scale * to_double(epsilon<S>()))
                                       : HUGE_VAL;
    for (Finding& f : findings)
      if (f.law == law) {
        if (!(measured <= f.measured)) f.measured = measured, f.regime = regime;
        return;
      }
    findings.push_back({law, regime, measured, exact_arithmetic<S>() ? 0 : allowed});
  }
  void vanishes(std::string const& law, S const& residual, double scale, double allowed) {
    vanishes(law, Matrix<S, 1, 1>(residual), scale, allowed);
  }

  // Laws over any field.

  void algebraic(S const& chart) {
    auto const g = element(chart), h = element(chart), k = element(chart);
    auto const one = identity<S>(group);
    double const three = size(g) * size(h) * size(k);
    vanishes("compose is associative", ((g * h) * k).value - (g * (h * k)).value, three, 8);
    vanishes("identity is neutral", (g * one).value - g.value, size(g), 4);
    vanishes("identity is neutral", (one * g).value - g.value, size(g), 4);
    double const conditioned = size(g) * size(inverse(g));
    vanishes("inverse is inverse", (g * inverse(g)).value - one.value, conditioned, 16);
    vanishes("inverse is inverse", (inverse(g) * g).value - one.value, conditioned, 16);

    auto const xi = velocity(S(1)), eta = velocity(S(1)), zeta = velocity(S(1));
    auto const mu = draw.momentum<S>(group);
    double const turned = conditioned * size(h) * size(inverse(h)) * size(xi);
    vanishes("Ad(gh) = Ad(g) Ad(h)", (Ad(g * h, xi) - Ad(g, Ad(h, xi))).coordinates, turned, 32);
    vanishes("bracket is antisymmetric", (bracket(xi, eta) + bracket(eta, xi)).coordinates,
             size(xi) * size(eta), 4);
    auto const jacobi =
        bracket(xi, bracket(eta, zeta)) + bracket(eta, bracket(zeta, xi)) + bracket(zeta, bracket(xi, eta));
    vanishes("bracket satisfies Jacobi's identity", jacobi.coordinates,
             size(xi) * size(eta) * size(zeta) * group.dimension(), 16);
    S const c = draw.number<S>();
    auto const linear = bracket(xi + c * zeta, eta) - bracket(xi, eta) - c * bracket(zeta, eta);
    vanishes("bracket is linear", linear.coordinates, (size(xi) + size(zeta)) * size(eta) * group.dimension(),
             8);
    vanishes("Ad preserves brackets", (Ad(g, bracket(xi, eta)) - bracket(Ad(g, xi), Ad(g, eta))).coordinates,
             conditioned * conditioned * group.dimension(), 32);

    vanishes("<Ad*_g mu, xi> = <mu, Ad_g xi>", pair(Ad_star(g, mu), xi) - pair(mu, Ad(g, xi)),
             conditioned * group.dimension(), 16);
    vanishes("<ad*_xi mu, eta> = <mu, [xi, eta]>", pair(ad_star(xi, mu), eta) - pair(mu, bracket(xi, eta)),
             group.dimension(), 16);

    infinitesimal(g, xi, eta, conditioned);
    retraction(chart);
    differentials(g, conditioned);
  }

  /// Laws on elements infinitely near the identity.
  void infinitesimal(Element<G, S> const& g, Velocity<G, S> const& xi, Velocity<G, S> const& eta,
                     double conditioned) {
    using D = First<S>;
    D const e = infinitesimal_number<D>();
    auto const moved = near_one(e * over<D>(xi)), there = over<D>(g);
    vanishes("Ad_g xi is g xi g^-1",
             (there * moved * inverse(there)).value - near_one(e * over<D>(Ad(g, xi))).value, conditioned,
             16);
    vanishes("bracket is the derivative of Ad",
             (Ad(moved, over<D>(eta)) - over<D>(eta) - e * over<D>(bracket(xi, eta))).coordinates,
             group.dimension(), 16);
    vanishes("near_identity is retract of infinitesimals", moved.value - retract(e * over<D>(xi)).value, 1,
             8);
  }

  /// Laws of the stand-in for the exponential.
  void retraction(S const& chart) {
    auto const v = velocity(chart);
    vanishes("retract(0) is the identity", retract(S(0) * v).value - identity<S>(group).value, 1, 0);
    vanishes("retract(-v) inverts retract(v)", (retract(v) * retract(-v)).value - identity<S>(group).value,
             size(retract(v)) * size(retract(-v)), 16);
    // With e1^2 = e2^2 = 0 but e1 e2 not: a one-parameter subgroup to second order, which is what the
    // exponential is.
    using D = Second<S>;
    D e1, e2;
    e1.value.part[0] = S(1), e2.part[0] = Dual<S, 1>(S(1));
    auto const w = over<D>(velocity(S(1)));
    double const scale = group.dimension() * group.dimension();
    vanishes("retract is exp to second order",
             retract((e1 + e2) * w).value - (retract(e1 * w) * retract(e2 * w)).value, scale, 16);
  }

  /// A polynomial in the numbers that store an element has the same differential from both sides, up to Ad*.
  void differentials(Element<G, S> const& g, double conditioned) {
    int const rows = static_cast<int>(g.value.rows()), columns = static_cast<int>(g.value.cols());
    auto const weights = draw.vector<S>(rows * columns);
    auto const f = [&](auto const& k) {
      auto sum = k.value(0, 0) * k.value(rows - 1, columns - 1);
      for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j)
          sum += k.value(i, j) * k.value(i, 0) * std::decay_t<decltype(sum)>(weights[i * columns + j]);
      return sum;
    };
    double const scale = conditioned * size(g) * size(g) * group.dimension();
    vanishes("L* l' = Ad* R* l'", (left_differential(f, g) - Ad_star(g, right_differential(f, g))).components,
             scale, 16);
  }

  template <class D>
  static D infinitesimal_number() {
    D e;
    e.part[0] = S(1);
    return e;
  }

  // Laws where the scalar has roots.

  /// @param condition  by how much the logarithm magnifies rounding at exp(v)
  void exponential(Velocity<G, S> const& v, Velocity<G, S> const& w, double condition)
    requires Real<S>
  {
    auto const g = exp(v);
    double const conditioned = size(g) * size(inverse(g));
    vanishes("exp(log g) = g", exp(log(g)).value - g.value, conditioned, 32);
    vanishes("log(exp v) = v", (log(g) - v).coordinates, condition * std::max(1.0, size(v)) * conditioned,
             64);

    S const s = ratio<S>(3, 7), t = ratio<S>(4, 7);
    vanishes("exp((s+t)v) = exp(sv) exp(tv)", g.value - (exp(s * v) * exp(t * v)).value, conditioned, 32);
    vanishes("exp(-v) inverts exp(v)", (g * exp(-v)).value - identity<S>(group).value, conditioned, 32);

    // The differential of the exponential, from both sides, against iex.
    using D = First<S>;
    D const e = infinitesimal_number<D>();
    auto const moved = exp(over<D>(v) + e * over<D>(w)), there = over<D>(g);
    Velocity<G, S> const right{group, iex(ad_matrix(v)) * w.coordinates},
        left{group, iex(ad_matrix(-v)) * w.coordinates};
    double const scale = conditioned * (1 + size(v)) * group.dimension();
    vanishes("exp(v + dv) = (1 + iex(ad_v) dv) exp(v)",
             moved.value - (near_one(e * over<D>(right)) * there).value, scale, 32);
    vanishes("exp(v + dv) = exp(v) (1 + iex(-ad_v) dv)",
             moved.value - (there * near_one(e * over<D>(left))).value, scale, 32);
    vanishes("log(exp(v + dv)) = v + dv", (log(moved) - over<D>(v) - e * over<D>(w)).coordinates,
             condition * condition * scale, 64);
  }

  /// An element that a push has moved off the group comes back, up to the square of the push.
  void restoring(Element<G, S> const& g)
    requires Real<S>
  {
    vanishes("restore leaves elements alone", restore(g).value - g.value, size(g) * size(g), 32);
    S const push = ratio<S>(1, 1000000);
    Element<G, S> pushed = g;
    for (Index i = 0; i < pushed.value.rows(); ++i)
      for (Index j = 0; j < pushed.value.cols(); ++j) pushed.value(i, j) += push * draw.number<S>();
    auto const back = restore(pushed);
    // Both count the push as the unit of rounding: back by about a push, and off by its square.
    double const unit = to_double(push) / to_double(epsilon<S>());
    vanishes("restore moves by no more than the push", back.value - pushed.value, size(g) * size(g) * unit,
             4);
    vanishes("restore brings back on the group", back.value - exp(log(back)).value,
             size(g) * size(g) * (unit * to_double(push) + 1), 32);
  }
};

/// All laws of `group` over the scalar S, the worst finding for each. A primitive that throws where it should
/// not breaks a law as well.
template <Scalar S>
std::vector<Finding> check_any(AnyGroup<S> const& group, std::uint64_t seed,
                               std::vector<Edge<S>> const& edges) {
  Laws<S> laws(group, seed);
  try {
    laws.run(edges);
  } catch (Error const& error) {
    laws.findings.push_back({std::string("every law can be tried, but ") + error.what(), "", HUGE_VAL, 0});
  }
  return std::move(laws.findings);
}
template <Scalar S, Group G>
std::vector<Finding> check(G const& group, std::uint64_t seed, std::vector<Edge<S>> const& edges = {}) {
  return check_any<S>(AnyGroup<S>(group), seed, edges);
}

}  // namespace actio::laws
