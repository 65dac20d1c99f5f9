// Explicit steps of order 8 that conserve the momentum of the symmetry by construction.
//
// On a level of that momentum the velocity is a function of the configuration: l'(xi) is the constant
// momentum, transported by Ad*. So a motion is a solution of a first-order equation on G, which a Runge-Kutta
// method solves in the natural chart at the earlier configuration. The momentum at the end of a step is that
// at its start, transported by the relative motion: it stays on its coadjoint orbit, and every Casimir and
// the momentum of the symmetry are what they were, whatever the error of the step. The step is no variational
// one: it preserves no bracket, and the error of the energy grows with time.
#pragma once

#include <any>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "actio/reduction/momentum_step.hpp"
#include "actio/variational/euler_poincare.hpp"

namespace actio {

namespace detail {

/// Cooper and Verner's explicit method of order 8 in 11 stages, whose coefficients are numbers in
/// \f$Q(\sqrt{21})\f$ (Some explicit Runge-Kutta methods of high order, SIAM J. Numer. Anal. 9, 1972).
template <Real S>
struct CooperVerner {
  static constexpr int stages = 11;
  /// What a stage takes of the rates of those before it; zeros are left out.
  struct Row {
    int count = 0;
    std::array<int, stages> of{};
    std::array<S, stages> weight{};
    void add(int stage, S const& of_it) { of[count] = stage, weight[count++] = of_it; }
  };
  std::array<Row, stages + 1> rows{};  ///< of the stages, and of the end of the step

  CooperVerner() {
    using std::sqrt;
    S const r = sqrt(S(21));
    // (whole + root sqrt(21))/by of the rate of a stage.
    auto const take = [&](int row, int stage, int whole, int root, int by) {
      rows[row].add(stage, S((S(whole) + S(root) * r) / S(by)));
    };
    take(1, 0, 1, 0, 2);
    take(2, 0, 1, 0, 4), take(2, 1, 1, 0, 4);
    take(3, 0, 1, 0, 7), take(3, 1, -7, -3, 98), take(3, 2, 21, 5, 49);
    take(4, 0, 11, 1, 84), take(4, 2, 18, 4, 63), take(4, 3, 21, -1, 252);
    take(5, 0, 5, 1, 48), take(5, 2, 9, 1, 36), take(5, 3, -231, 14, 360), take(5, 4, 63, -7, 80);
    take(6, 0, 10, -1, 42), take(6, 2, -432, 92, 315), take(6, 3, 633, -145, 90);
    take(6, 4, -504, 115, 70), take(6, 5, 63, -13, 35);
    take(7, 0, 1, 0, 14), take(7, 4, 14, -3, 126), take(7, 5, 13, -3, 63), take(7, 6, 1, 0, 9);
    take(8, 0, 1, 0, 32), take(8, 4, 91, -21, 576), take(8, 5, 11, 0, 72), take(8, 6, -385, -75, 1152);
    take(8, 7, 63, 13, 128);
    take(9, 0, 1, 0, 14), take(9, 4, 1, 0, 9), take(9, 5, -733, -147, 2205), take(9, 6, 515, 111, 504);
    take(9, 7, -51, -11, 56), take(9, 8, 132, 28, 245);
    take(10, 4, -42, 7, 18), take(10, 5, -18, 28, 45), take(10, 6, -273, -53, 72);
    take(10, 7, 301, 53, 72), take(10, 8, 28, -28, 45), take(10, 9, 49, -7, 18);
    take(11, 0, 1, 0, 20), take(11, 7, 49, 0, 180), take(11, 8, 16, 0, 45), take(11, 9, 49, 0, 180);
    take(11, 10, 1, 0, 20);
  }
};

/// The commutator of an algebra and its dual by the structure constants that are not zero.
template <Real B>
class Commutators {
 public:
  template <Group G>
  explicit Commutators(G const& group) {
    int const n = group.dimension();
    for (int a = 0; a < n; ++a)
      for (int b = a + 1; b < n; ++b) {
        auto const unit = [&](int k) {
          Coordinates<G, B> e = Coordinates<G, B>::Zero(n);
          e[k] = B(1);
          return Velocity<G, B>{group, e};
        };
        auto const c = actio::bracket(unit(a), unit(b)).coordinates;
        for (int k = 0; k < n; ++k)
          if (c[k] != B(0)) constants_.push_back({a, b, k, c[k]});
      }
  }
  /// \f$[v, w]\f$ in `out`.
  template <class V>
  void bracket(V const& v, V const& w, V& out) const {
    for (Index k = 0; k < out.size(); ++k) out[k] = typename V::Scalar(0);
    for (auto const& c : constants_) out[c.k] += (v[c.a] * w[c.b] - v[c.b] * w[c.a]) * c.value;
  }
  /// \f$\mathrm{ad}^*_v\,\mu\f$ in `out`.
  template <class V>
  void ad_star(V const& v, V const& mu, V& out) const {
    for (Index k = 0; k < out.size(); ++k) out[k] = typename V::Scalar(0);
    for (auto const& c : constants_) {
      auto const part = mu[c.k] * c.value;
      out[c.b] += v[c.a] * part, out[c.a] -= v[c.b] * part;
    }
  }

 private:
  struct Constant {
    int a, b, k;
    B value;
  };
  std::vector<Constant> constants_;
};

/// The velocity of a momentum, \f$\partial l/\partial\xi = \mu\f$, near one that is known.
///
/// The inverse of the second derivative is kept from one equation to the next. By its first correction the
/// velocity is a linear function of the momentum; where a second one has turned out to be rounding, as for
/// every quadratic Lagrangian, that function is taken until a check finds it to be wrong.
template <Group G, Real S>
class LegendreChord {
 public:
  /// Before a step.
  template <class F>
  void begin(F const& l, Velocity<G, S> const& xi) {
    if (inverse_.size() == 0 || !(contraction_ * Base<S>(20) < Base<S>(1))) differentiate(l, xi);
  }
  /// Whether the velocity has been found to be a linear function of the momentum.
  bool linear() const { return linear_; }
  /// That function, at a momentum.
  void by_line(Momentum<G, S> const& mu, Velocity<G, S>& xi) const {
    correct(mu, momentum_, velocity_, xi.coordinates);
  }
  /// Solves, beginning at `xi`. Where velocities were taken for linear, that is checked: it is so if nothing
  /// is to be corrected.
  /// @throws NotConverged, Singular  where the solution is not near
  template <class F>
  void solve(F const& l, Momentum<G, S> const& mu, Velocity<G, S>& xi) {
    Base<S> const tiny = epsilon<S>() * Base<S>(2);
    bool const checked = std::exchange(linear_, false);
    Base<S> corrections[fresh_derivatives * tries];
    int count = 0;
    for (int fresh = 0; fresh < fresh_derivatives; ++fresh, differentiate(l, xi)) {
      Base<S> before(-1);
      for (int k = 0; k < tries; ++k) {
        ++gradients_;
        look(l, xi, k > 0);
        correct(mu, momentum_, velocity_, xi.coordinates);
        Base<S> const now = magnitude(Coordinates<G, S>(xi.coordinates - velocity_)),
                      bound = tiny * magnitude(xi.coordinates);
        corrections[count++] = now;
        if (!is_finite(now)) break;
        if (before > Base<S>(0)) contraction_ = now / before;
        if (now <= bound || (before > Base<S>(0) && now * contraction_ <= bound)) {
          // Two solutions next to each other say nothing of a line.
          bool const far = before * Base<S>(1000) > magnitude(xi.coordinates);
          linear_ = now <= bound && (checked ? k == 0 : k == 1 && far);
          return;
        }
        if (before >= Base<S>(0) && now > before / Base<S>(4)) break;
        before = now;
      }
    }
    std::vector<double> history;
    for (int k = 0; k < count; ++k) history.push_back(to_double(corrections[k]));
    throw NotConverged("momentum level: the velocity of a momentum", std::move(history), to_double(tiny));
  }
  int take_gradients() { return std::exchange(gradients_, 0); }

 private:
  /// Takes the gradient at a velocity; Broyden's formula has the inverse map what the momentum has changed by
  /// since the last look to what the velocity has.
  template <class F>
  void look(F const& l, Velocity<G, S> const& xi, bool again) {
    Coordinates<G, S> const moved = again ? Coordinates<G, S>(xi.coordinates - velocity_) : xi.coordinates,
                            past = momentum_;
    velocity_ = xi.coordinates, momentum_ = gradient(l, xi).components;
    if (!again) return;
    Coordinates<G, S> mapped = moved, row = moved;
    S along(0);
    for (Index i = 0; i < moved.size(); ++i) {
      mapped[i] = row[i] = S(0);
      for (Index j = 0; j < moved.size(); ++j) {
        mapped[i] += inverse_(i, j) * (momentum_[j] - past[j]);
        row[i] += moved[j] * inverse_(j, i);
      }
      along += moved[i] * mapped[i];
    }
    // Rounding is nothing to learn from.
    Base<S> const missed = magnitude(Coordinates<G, S>(moved - mapped));
    if (!(missed > epsilon<S>() * Base<S>(64) * magnitude(velocity_)) || !(magnitude(along) > Base<S>(0)))
      return;
    for (Index i = 0; i < moved.size(); ++i)
      for (Index j = 0; j < moved.size(); ++j) inverse_(i, j) += (moved[i] - mapped[i]) * row[j] / along;
  }
  void correct(Momentum<G, S> const& mu, Coordinates<G, S> const& there, Coordinates<G, S> const& from,
               Coordinates<G, S>& out) const {
    for (Index i = 0; i < from.size(); ++i) {
      S sum = from[i];
      for (Index j = 0; j < from.size(); ++j) sum += inverse_(i, j) * (mu.components[j] - there[j]);
      out[i] = sum;
    }
  }
  template <class F>
  void differentiate(F const& l, Velocity<G, S> const& xi) {
    auto const second = hessian(l, xi);
    inverse_ = solve_linear(second, std::decay_t<decltype(inverse_)>::Identity(second.rows(), second.cols()),
                            "momentum level: d2l/dxi2");
    contraction_ = Base<S>(1), linear_ = false;
  }
  static constexpr int fresh_derivatives = 3, tries = 12;
  Matrix<S, G::dim, G::dim> inverse_;
  Coordinates<G, S> velocity_, momentum_;
  Base<S> contraction_{1};
  bool linear_ = false;
  int gradients_ = 0;
};

/// A step on a level of the momentum; side: +1 right, -1 left.
template <int side, class F, Real B>
struct MomentumLevelStep {
  F l;
  CooperVerner<B> method = {};
  mutable std::any memory = {};  ///< of the last call

  template <ExponentialGroup G, Real S>
  MomentumStep<G, S> operator()(MomentumState<G, S> const& from, std::type_identity_t<B> const& h) const {
    require_steppable(from, h);
    auto const& group = from.momentum.group;
    using Kept = Memory<G, S>;
    auto* kept = std::any_cast<Kept>(&memory);
    if (!kept) kept = &memory.template emplace<Kept>(group);
    kept->legendre.begin(l, from.velocity);
    Velocity<G, S> xi = from.velocity, eta{group, Coordinates<G, S>::Zero(group.dimension())};
    if (!stages(*kept, from, h, xi, eta)) stages(*kept, from, h, xi = from.velocity, eta);
    auto const f = exp(-eta);
    using Invariance = std::conditional_t<(side > 0), RightInvariant, LeftInvariant>;
    return {f, {Invariance::lie_poisson_update(f, from.momentum), xi}, kept->legendre.take_gradients()};
  }

 private:
  static constexpr int last = CooperVerner<B>::stages - 1;
  template <Group G, Real S>
  struct Memory {
    LegendreChord<G, S> legendre = {};
    Commutators<B> commutators;
    std::array<Coordinates<G, S>, last + 1> turned = {}, changed = {};  ///< rates at the stages
    explicit Memory(G const& group) : commutators(group) {
      for (int i = 0; i <= last; ++i) turned[i] = changed[i] = Coordinates<G, S>::Zero(group.dimension());
    }
  };

  /// The displacement over the step, and the velocity near its end.
  /// @return  false where velocities were taken for a linear function of momenta, and are none
  template <Group G, Real S>
  bool stages(Memory<G, S>& kept, MomentumState<G, S> const& from, B const& h, Velocity<G, S>& xi,
              Velocity<G, S>& eta) const {
    Momentum<G, S> mu = from.momentum;
    Coordinates<G, S> const zero = Coordinates<G, S>::Zero(mu.group.dimension());
    Coordinates<G, S> powers[] = {zero, zero, zero, zero, zero, zero};
    bool const linear = kept.legendre.linear();
    for (int i = 0; i <= last; ++i) {
      add(method.rows[i], kept.turned, h, zero, eta.coordinates);
      add(method.rows[i], kept.changed, h * B(-side), from.momentum.components, mu.components);
      if (linear) kept.legendre.by_line(mu, xi);
      if (!linear || i == last / 2 || i == last) {
        kept.legendre.solve(l, mu, xi);
        if (linear && !kept.legendre.linear()) return false;
      }
      // [momentum_level]
      kept.commutators.ad_star(xi.coordinates, mu.components, kept.changed[i]);
      rate_in_chart(kept.commutators, eta.coordinates, xi.coordinates, powers, kept.turned[i]);
      // [momentum_level]
    }
    add(method.rows[last + 1], kept.turned, h, zero, eta.coordinates);
    return true;
  }

  /// out = from + h times a row of the method.
  template <class V>
  static void add(typename CooperVerner<B>::Row const& row, std::array<V, last + 1> const& rates, B const& h,
                  V const& from, V& out) {
    out = from;
    for (int k = 0; k < row.count; ++k) {
      V const& rate = rates[row.of[k]];
      B const weight = h * row.weight[k];
      for (Index a = 0; a < out.size(); ++a) out[a] += rate[a] * weight;
    }
  }

  /// \f$\eta' = \mathrm{iex}(\pm\mathrm{ad}_\eta)^{-1}\xi\f$ up to the sixth power of ad: what follows is of
  /// the ninth order in h, since \f$\eta\f$ and \f$\xi\f$ commute to first order.
  template <class V>
  static void rate_in_chart(Commutators<B> const& commutators, V const& eta, V const& xi, V (&powers)[6],
                            V& rate) {
    using S = typename V::Scalar;
    V const* last_one = &xi;
    for (V& p : powers) commutators.bracket(eta, *last_one, p), last_one = &p;
    S const odd = S(-side) / S(2), of[] = {S(1) / S(12), S(-1) / S(720), S(1) / S(30240)};
    for (Index a = 0; a < rate.size(); ++a)
      rate[a] =
          xi[a] + powers[0][a] * odd + powers[1][a] * of[0] + powers[3][a] * of[1] + powers[5][a] * of[2];
  }
};

}  // namespace detail

/// A step of order 8 of a left-invariant system on a level of the momentum of its symmetry: a callable
/// (state, h) -> \ref MomentumStep on body momenta.
///
/// Solves \f$\dot g = g\,\xi\f$ with \f$\partial l/\partial\xi = \Pi\f$ by Cooper and Verner's explicit
/// method in the natural chart at g0, and transports \f$\Pi_1 = \mathrm{Ad}^*_{f^{-1}}\,\Pi_0\f$.
/// @param l  reduced Lagrangian, function of \f$g^{-1}\dot g\f$, energy; its Legendre map is regular
/// @throws OutsideDomain  when called, for a step that is zero or not finite
/// @throws NotConverged, Singular  when called, where the velocity of a momentum is not found
template <Real S, class F>
auto momentum_level_step_left(F l) {
  return detail::MomentumLevelStep<-1, F, S>{std::move(l)};
}
/// The same of a right-invariant system, on spatial momenta: \f$\mu_1 = \mathrm{Ad}^*_f\,\mu_0\f$.
/// @param l  reduced Lagrangian, function of \f$\dot g g^{-1}\f$, energy
template <Real S, class F>
auto momentum_level_step_right(F l) {
  return detail::MomentumLevelStep<1, F, S>{std::move(l)};
}

}  // namespace actio
