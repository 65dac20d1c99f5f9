// The Hamilton-Jacobi equation of a free system, solved by a power series in the time.
//
// With the mean velocity w = -log(g)/t the generating function is S(g, t) = t (sigma_0(w) + t
//   sigma_1(w) + t^2 sigma_2(w) + ...). Put into (4.1), sigma_0 is the Lagrangian, and (k+1) sigma_k = -[t^k]
//   h(chi(-t ad_w)^T sum_{j<k} t^j sigma_j'(w)), for what (4.1) says of sigma_k' itself cancels. Each sigma_k
//   is a polynomial of degree k+2; those with odd k vanish, because S(1/g, -t) = -S(g, t). The first
//   correction is sigma_2 = -<ad*_w p, A^-1 ad*_w p>/24 with p = A w + b.
#pragma once

#include <map>
#include <vector>

#include "actio/groupoid/generating_function.hpp"

namespace actio {

/// A polynomial in the coordinates of a velocity: coefficients by their powers.
template <Scalar S>
struct Polynomial {
  using Powers = std::vector<int>;  ///< of each coordinate
  std::map<Powers, S> terms;        ///< coefficients that are not zero

  /// Adds c times a monomial.
  void add(Powers const& powers, S const& c) {
    if (c == S(0)) return;
    auto const [term, fresh] = terms.try_emplace(powers, c);
    if (!fresh && (term->second += c) == S(0)) terms.erase(term);
  }
  /// Adds q.
  Polynomial& operator+=(Polynomial const& q) {
    for (auto const& [powers, c] : q.terms) add(powers, c);
    return *this;
  }
  /// Adds c times q times the coordinate a, or times nothing where a is -1.
  void add_product(Polynomial const& q, S const& c, int a = -1) {
    if (c == S(0)) return;
    for (auto const& [powers, d] : q.terms) {
      Powers raised = powers;
      if (a >= 0) ++raised[a];
      add(raised, S(c * d));
    }
  }
  /// The product of two polynomials.
  friend Polynomial operator*(Polynomial const& p, Polynomial const& q) {
    Polynomial product;
    for (auto const& [powers, c] : q.terms)
      for (auto const& [others, d] : p.terms) {
        Powers sum = powers;
        for (std::size_t a = 0; a < sum.size(); ++a) sum[a] += others[a];
        product.add(sum, S(c * d));
      }
    return product;
  }
  /// The derivative by the coordinate a.
  Polynomial derivative(int a) const {
    Polynomial d;
    for (auto const& [powers, c] : terms)
      if (powers[a] > 0) {
        Powers lowered = powers;
        --lowered[a];
        d.add(lowered, S(c * S(powers[a])));
      }
    return d;
  }
  /// The value at a column of coordinates.
  template <MatrixLike V>
  typename V::Scalar at(V const& x) const {
    using T = typename V::Scalar;
    // Powers of each coordinate, as far as they are needed.
    std::vector<std::vector<T>> raised(x.size(), std::vector<T>{T(1)});
    T sum(0);
    for (auto const& [powers, c] : terms) {
      T term(c);
      for (std::size_t a = 0; a < powers.size(); ++a) {
        if (powers[a] == 0) continue;
        while (static_cast<int>(raised[a].size()) <= powers[a]) raised[a].push_back(raised[a].back() * x[a]);
        term *= raised[a][powers[a]];
      }
      sum += term;
    }
    return sum;
  }
};

/// A truncated solution of (4.1): \f$S(g, t) = t\sum_k t^k\sigma_k(w)\f$, \f$w = -\log(g)/t\f$. Made by
/// \ref generating_series.
template <Group G, Scalar S>
struct GeneratingSeries {
  [[no_unique_address]] G group;
  std::vector<Polynomial<S>> sigma;  ///< energy x time^-k

  /// \f$\sum_k t^k\sigma_k(w)\f$, energy
  template <Scalar T>
  T mean_lagrangian(Velocity<G, T> const& w, T const& t) const {
    T sum(0);
    for (auto k = sigma.size(); k-- > 0;) sum = sum * t + sigma[k].at(w.coordinates);
    return sum;
  }
  /// S, energy x time
  /// @throws OutsideDomain  where g has no logarithm
  template <Real T>
  T operator()(Element<G, T> const& g, T const& t) const { return t * mean_lagrangian(-log(g) / t, t); }
};

namespace detail {
/// \f$\mathrm{ad}^*_w p\f$ of a covector whose components are polynomials in w.
template <Group G, Scalar S>
std::vector<Polynomial<S>> ad_star_of_variable(G const& group, std::vector<Polynomial<S>> const& p) {
  int const n = group.dimension();
  std::vector<Polynomial<S>> result(n);
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b) {
      auto const c = bracket(basis_velocity<S>(group, a), basis_velocity<S>(group, b)).coordinates;
      for (int d = 0; d < n; ++d) result[b].add_product(p[d], S(c[d]), a);
    }
  return result;
}
/// The coefficients of \f$\chi(-x) = x/(1-e^{-x})\f$ up to \f$x^{order}\f$: 1, 1/2, 1/12, 0, -1/720, ...
template <Scalar S>
std::vector<S> chi_coefficients(int order) {
  // chi(x) iex(x) = 1, power by power.
  std::vector<S> chi(order + 1), iex(order + 1, S(1));
  for (int m = 1; m <= order; ++m) iex[m] = iex[m - 1] / S(m + 1);
  for (int m = 0; m <= order; ++m) {
    chi[m] = m == 0 ? S(1) : S(0);
    for (int i = 0; i < m; ++i) chi[m] -= chi[i] * iex[m - i];
  }
  for (int m = 1; m <= order; m += 2) chi[m] = -chi[m];
  return chi;
}
}  // namespace detail

/// The solution of (4.1) for a free left-invariant system up to \f$t^{order}\f$ in the mean Lagrangian. The
/// same series solves the equation of the right-invariant system.
///
/// With order 0 it is the discrete Lagrangian of the natural chart. With an even order it makes a Lie-Poisson
/// integrator of order `order` + 2; an odd one adds nothing to the even one below it.
/// @param order  0 or more; the last term has as many monomials as there are of degree `order` + 2: 28 on
///               SO(3) and 462 on SE(3) for order 4. It is computed once, for every step
/// @throws OutsideDomain  where the order is negative
/// Over any field; exact over the rationals.
template <Group G, Scalar S>
GeneratingSeries<G, S> generating_series(QuadraticLagrangian<G, S> const& l, int order) {
  if (order < 0) throw OutsideDomain("generating_series", "the order must not be negative", order, 0);
  using Covector = std::vector<Polynomial<S>>;
  int const n = l.group.dimension();
  auto const chi = detail::chi_coefficients<S>(order);

  // sigma_0 is the Lagrangian.
  GeneratingSeries<G, S> series{l.group, {{}}};
  for (int i = 0; i < n; ++i) {
    typename Polynomial<S>::Powers one(n, 0);
    ++one[i];
    series.sigma[0].add(one, l.b[i]);
    for (int j = 0; j < n; ++j) {
      auto two = one;
      ++two[j];
      series.sigma[0].add(two, S(l.a(i, j) / S(2)));
    }
  }

  // momentum[i] is what t^i multiplies in chi(-t ad_w)^T sigma'(w) - b, of the sigma known so far.
  std::vector<Covector> momentum(order + 1, Covector(n));
  auto const take_in = [&](int k) {
    Covector p(n);
    for (int a = 0; a < n; ++a) p[a] = series.sigma[k].derivative(a);
    for (int i = k;; ++i) {
      for (int a = 0; a < n; ++a) momentum[i][a].add_product(p[a], chi[i - k]);
      if (i == order) return;
      p = detail::ad_star_of_variable(l.group, p);
    }
  };
  take_in(0);
  for (int a = 0; a < n; ++a) momentum[0][a].add(typename Polynomial<S>::Powers(n, 0), S(-l.b[a]));

  for (int k = 1; k <= order; ++k) {
    // Terms of h with t^k, over -(k+1). For odd k they cancel.
    Polynomial<S> sigma;
    for (int i = 0; i <= k && k % 2 == 0; ++i)
      for (int a = 0; a < n; ++a) {
        Polynomial<S> velocity;
        for (int b = 0; b < n; ++b)
          velocity.add_product(momentum[k - i][b], S(l.inverse_a(a, b) / S(-2 * (k + 1))));
        sigma += momentum[i][a] * velocity;
      }
    series.sigma.push_back(std::move(sigma));
    take_in(k);
  }
  return series;
}

}  // namespace actio
