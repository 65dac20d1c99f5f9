// Field theories of second order: densities on second jets, their field equations, boundary term and Cartan
// form. Everything along a section is a function on space-time, differentiated there.
#pragma once

#include "fields/variations.hpp"

#include "actio/jets/field_equations.hpp"

namespace actio::checks {

/// A number as a constant over any scalar that is built on it, through as many levels as there are.
template <class T, class C>
T as_constant(C const& c) {
  if constexpr (std::constructible_from<T, C const&>)
    return T(c);
  else
    return T(as_constant<decltype(T::value)>(c));
}

/// How a density on second jets changes in a direction of their fibre.
template <class L, class S, int n, int N>
S rate_along(L const& density, SecondJet<S, n, N> const& j, SecondJet<S, n, N> const& direction) {
  return rate_of(density(varied(j, direction)));
}

/// The density L(x, y, v, w) along a section. With \f$p_a{}^{\mu\nu}\f$ symmetric, half of the derivative by
/// \f$w^a{}_{\mu\nu}\f$ where the indices differ, \f$P_a{}^\mu = \partial L/\partial v^a{}_\mu -
/// D_\nu p_a{}^{\mu\nu}\f$ and \f$E_a = \partial L/\partial y^a - D_\mu P_a{}^\mu\f$.
template <int n, int N, class L, class Phi>
struct SecondOrderTheory {
  L density;
  Phi phi;

  template <class T>
  using Momenta = Matrix<T, N, n + 1>;
  /// \f$p_a{}^{\mu\nu}\f$ stands in row \f$a + N\mu\f$ and column \f$\nu\f$.
  template <class T>
  using SecondMomenta = Matrix<T, N*(n + 1), n + 1>;

  template <class T>
  static SecondJet<T, n, N> no_direction() {
    SecondJet<T, n, N> d{};
    d.x.setZero(), d.y.setZero(), d.v.setZero();
    for (auto& w : d.w) w.setZero();
    return d;
  }
  template <class T>
  T value(Event<T, n> const& x) const { return density(second_jet(phi, x)); }
  template <class T>
  Matrix<T, N, 1> force(Event<T, n> const& x) const {
    auto const j = second_jet(phi, x);
    Matrix<T, N, 1> f;
    for (int a = 0; a < N; ++a) {
      auto d = no_direction<T>();
      d.y[a] = T(1);
      f[a] = rate_along(density, j, d);
    }
    return f;
  }
  /// \f$\partial L/\partial v^a{}_\mu\f$.
  template <class T>
  Momenta<T> by_first(Event<T, n> const& x) const {
    auto const j = second_jet(phi, x);
    Momenta<T> p;
    for (int a = 0; a < N; ++a)
      for (int mu = 0; mu <= n; ++mu) {
        auto d = no_direction<T>();
        d.v(a, mu) = T(1);
        p(a, mu) = rate_along(density, j, d);
      }
    return p;
  }
  template <class T>
  SecondMomenta<T> by_second(Event<T, n> const& x) const {
    auto const j = second_jet(phi, x);
    SecondMomenta<T> p;
    for (int a = 0; a < N; ++a)
      for (int mu = 0; mu <= n; ++mu)
        for (int nu = 0; nu <= mu; ++nu) {
          auto d = no_direction<T>();
          d.w[mu](a, nu) = d.w[nu](a, mu) = T(1);
          T const rate = rate_along(density, j, d);
          p(a + N * mu, nu) = p(a + N * nu, mu) = mu == nu ? rate : T(rate / T(2));
        }
    return p;
  }
  /// \f$P_a{}^\mu\f$.
  template <class T>
  Momenta<T> momenta(Event<T, n> const& x) const {
    auto const rates = derivative([this](auto const& u) { return by_second(u); }, x);
    Momenta<T> P = by_first(x);
    for (int nu = 0; nu <= n; ++nu) {
      auto const rate = rates.partial(nu);
      for (int mu = 0; mu <= n; ++mu) P.col(mu) -= rate.template block<N, 1>(N * mu, nu);
    }
    return P;
  }
  template <class T>
  Matrix<T, N, 1> field_equations(Event<T, n> const& x) const {
    return force(x) - divergence_of_rows([this](auto const& u) { return momenta(u); }, x);
  }
  /// What they would be without second derivatives in the density.
  template <class T>
  Matrix<T, N, 1> of_first_order(Event<T, n> const& x) const {
    return force(x) - divergence_of_rows([this](auto const& u) { return by_first(u); }, x);
  }
  /// \f$P_a{}^\mu Q^a + p_a{}^{\mu\nu}D_\nu Q^a\f$ for the vertical part of a variation, as a section is
  /// written.
  template <class T, class Q>
  Event<T, n> current(Q const& vertical, Event<T, n> const& x) const {
    auto const q = first_jet(vertical, x);
    auto const p = by_second(x);
    Event<T, n> B = momenta(x).transpose() * q.y;
    for (int mu = 0; mu <= n; ++mu)
      for (int nu = 0; nu <= n; ++nu) B[mu] += p.template block<N, 1>(N * mu, nu).dot(q.v.col(nu));
    return B;
  }

 private:
  template <class F, class T>
  static Matrix<T, N, 1> divergence_of_rows(F const& f, Event<T, n> const& x) {
    auto const rates = derivative(f, x);
    Matrix<T, N, 1> sum = Matrix<T, N, 1>::Zero();
    for (int mu = 0; mu <= n; ++mu) sum += rates.partial(mu).col(mu);
    return sum;
  }
};
template <int n, int N, class L, class Phi>
SecondOrderTheory<n, N, L, Phi> second_order_theory(L const& density, Phi const& phi) {
  return {density, phi};
}

/// \f$\phi + \epsilon Q\f$ over the dual numbers of \f$\epsilon\f$.
template <class S, class Phi, class Q>
auto varied_section(Phi const& phi, Q const& vertical) {
  return [phi, vertical]<class T, int rows>(Matrix<T, rows, 1> const& x) {
    auto y = phi(x);
    auto const q = vertical(x);
    Dual<S> epsilon(S(0));
    epsilon.part[0] = S(1);
    for (int a = 0; a < y.size(); ++a) y[a] += q[a] * as_constant<T>(epsilon);
    return y;
  };
}

// ---- Third jets, by the values of a section's derivatives: x, y, v in the order of first jets, then the
// rest.

/// Exponents of the derivatives of order three at most, by their order.
template <int n>
std::vector<std::array<int, n + 1>> exponents_of_third_jets() {
  std::vector<std::array<int, n + 1>> all;
  for (int order = 0; order <= 3; ++order)
    for (int code = 0; code < 1 << 2 * (n + 1); ++code) {
      // Two bits for each coordinate; the highest first, so that those of first order come in their order.
      std::array<int, n + 1> e{};
      int sum = 0;
      for (int mu = 0; mu <= n; ++mu) e[mu] = code >> 2 * mu & 3, sum += e[mu];
      if (sum == order) all.push_back(e);
    }
  return all;
}
constexpr int third_derivatives(int n) { return (n + 2) * (n + 3) * (n + 4) / 6; }
template <int n, int N>
inline constexpr int third_jet_dimension = n + 1 + N * third_derivatives(n);

/// The section of third degree with these derivatives at a point.
template <class S, int n, int N>
struct SectionOfJet {
  Matrix<S, third_jet_dimension<n, N>, 1> c;
  template <class X>
  auto operator()(X const& x) const {
    using T = ScalarOf<X>;
    Matrix<T, N, 1> y = Matrix<T, N, 1>::Zero();
    int k = n + 1;
    for (auto const& e : exponents_of_third_jets<n>()) {
      T power(1);
      for (int mu = 0; mu <= n; ++mu)
        for (int i = 1; i <= e[mu]; ++i) power *= (x[mu] - as_constant<T>(c[mu])) / T(i);
      for (int a = 0; a < N; ++a) y[a] += power * as_constant<T>(c[k++]);
    }
    return y;
  }
};
/// \f$j^3\phi\f$ as a map between coordinates.
template <int n, int N, class Phi>
auto third_jet_extension(Phi const& phi) {
  return [phi]<class T>(Event<T, n> const& x) {
    auto const second = [&phi](auto const& u) {
      using R = ScalarOf<std::remove_cvref_t<decltype(u)>>;
      auto const j = second_jet(phi, u);
      Matrix<R, N*(n + 1), n + 1> w;
      for (int mu = 0; mu <= n; ++mu)
        for (int nu = 0; nu <= n; ++nu) w.template block<N, 1>(N * mu, nu) = j.w[mu].col(nu);
      return w;
    };
    auto const j = second_jet(phi, x);
    auto const third = derivative(second, x);
    Matrix<T, third_jet_dimension<n, N>, 1> c;
    c.template head<n + 1>() = x;
    int k = n + 1;
    for (auto const& e : exponents_of_third_jets<n>()) {
      // The coordinates that it differentiates by, one after the other.
      std::vector<int> by;
      for (int mu = 0; mu <= n; ++mu) by.insert(by.end(), e[mu], mu);
      for (int a = 0; a < N; ++a)
        c[k++] = by.empty()       ? j.y[a]
                 : by.size() == 1 ? j.v(a, by[0])
                 : by.size() == 2 ? j.w[by[0]](a, by[1])
                                  : third.partial(by[2])(a + N * by[0], by[1]);
    }
    return c;
  };
}

/// The Cartan form of second order on third jets: \f$P_a{}^\mu\,dy^a\wedge d^nx_\mu +
/// p_a{}^{\mu\nu}\,dv^a{}_\nu\wedge d^nx_\mu + (L - P_a{}^\mu
/// v^a{}_\mu - p_a{}^{\mu\nu}w^a{}_{\mu\nu})\,d^{n+1}x\f$.
/// @param complete  or that of first order, with \f$\partial L/\partial v\f$ in place of P and no p
template <int n, int N, class L>
auto second_order_cartan_form(L const& density, bool complete = true) {
  return [density, complete]<class T, int D>(Matrix<T, D, 1> const& at, Tangents<T, D, n + 1> const& V) -> T {
    SectionOfJet<T, n, N> const section{at};
    auto const theory = second_order_theory<n, N>(density, section);
    Event<T, n> const x = at.template head<n + 1>();
    auto const P = complete ? theory.momenta(x) : theory.by_first(x);
    Matrix<T, N*(n + 1), n + 1> p = theory.by_second(x);
    if (!complete) p.setZero();
    auto const j = second_jet(section, x);
    T Pi = density(j) - P.cwiseProduct(j.v).sum();
    for (int mu = 0; mu <= n; ++mu)
      for (int nu = 0; nu <= n; ++nu) Pi -= p.template block<N, 1>(N * mu, nu).dot(j.w[mu].col(nu));
    T sum = Pi * volume_form<n>()(at, V);
    for (int mu = 0; mu <= n; ++mu) {
      auto const leg = [&P, &p, mu](auto const&, auto const& v) -> T {
        T part = P.col(mu).dot(v.template block<N, 1>(n + 1, 0));
        for (int nu = 0; nu <= n; ++nu)
          part += p.template block<N, 1>(N * mu, nu).dot(v.template block<N, 1>(n + 1 + N * (nu + 1), 0));
        return part;
      };
      sum += wedge(leg, volume_form<n>(mu))(at, V);
    }
    return sum;
  };
}

}  // namespace actio::checks
