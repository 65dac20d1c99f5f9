// One step of the natural chart (3.25) in the algebra, written out for structure constants.
//
// Over a step of length h the group moves by exp(h v). With A = h ad_v the momenta at its two ends are
//
//     P_0 = chi(A)^T p + (h/2) J(a_0),    P_1 = chi(-A)^T p - (h/2) J(a_1),    chi(A) = A/(e^A - 1),
//
// where p is the mean of dl/dv at both ends, a_1 = exp(-h v) a_0, and the action of the step is
// h (l(v, a_0) + l(v, a_1))/2. Without carried vectors this is (3.26), and chi(-A) = chi(A) + A makes
// P_1 = P_0 + h ad*_v p. A force F subtracts (h/2) F(t_0, v, a_0) from P_0 and adds (h/2) F(t_1, v, a_1) to
// P_1: the discrete Lagrange-d'Alembert form of (3.10) and (3.11). A force in components of the other side is
// moved to this one by Ad*_g, which e^{A^T} carries along the step. No exponential of a matrix and no
// logarithm is taken, and brackets are sums over the structure constants that are not zero. tests/any_group
// hold it to the generic implementation.
//
// In the chart by Cayley's transform the group moves by (1 - hv/2)^-1 (1 + hv/2), and chi is a polynomial:
// <chi(A)^T p, eta> = <p, eta - [hv, eta]/2 - (hv) eta (hv)/4>, with products of matrices in the last term.
#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <tuple>
#include <vector>

#include "actio/any_group/step_force.hpp"
#include "actio/groups/matrix_group.hpp"

namespace actio::systems {

namespace detail {
/// \f$B_{2k}/(2k)! = 2(-1)^{k+1}\zeta(2k)/(2\pi)^{2k}\f$: the even part of \f$x/(e^x - 1)\f$ is
/// \f$1 + \sum_k B_{2k}x^{2k}/(2k)!\f$.
std::array<double, 65> const& coefficients_of_chi();

/// The largest modulus among a number and its rates.
inline double largest_part(double x) { return std::abs(x); }
/// The largest modulus among a number and its rates.
template <int N>
double largest_part(Dual<double, N> const& x) {
  double largest = std::abs(x.value);
  for (double const part : x.part) largest = std::max(largest, std::abs(part));
  return largest;
}
/// The largest modulus in a list.
template <class S>
double largest_part(std::vector<S> const& list) {
  double largest = 0;
  for (S const& x : list) largest = std::max(largest, largest_part(x));
  return largest;
}
}  // namespace detail

/// The matrix of \f$h\,v\f$.
template <class S>
Matrix<S> hat_of_step(MatrixAlgebra const& algebra, S const& h, std::vector<S> const& v) {
  Vector<S> moved(static_cast<Index>(v.size()));
  for (std::size_t i = 0; i < v.size(); ++i) moved[static_cast<Index>(i)] = v[i] * h;
  return algebra.hat(moved);
}

/// A bound of the norm of \f$h\,v\f$ as a matrix: all its entries added up.
template <class S>
double size_of_step(MatrixAlgebra const& algebra, double h, std::vector<S> const& v) {
  double sum = 0;
  for (auto const& e : algebra.entries)
    sum += std::abs(h * to_double(base_value(v[static_cast<std::size_t>(e.direction)])) * e.value);
  return sum;
}

/// A step of the natural chart at one scalar, `double` or dual numbers over it, with its work space.
template <class S>
class ChartStep {
 public:
  /// Of a system that outlives it.
  explicit ChartStep(ReducedSystem const& system)
      : before(n(system.dimension())),
        after(before),
        vectors(n(system.carried())),
        force(system),
        system_(system),
        inputs_(n(system.lagrangian.inputs)),
        slopes_(inputs_.size() + 1),
        p_(before),
        odd_(before),
        even_(before),
        moved_(n(system.length())) {
    find_pattern();
    if (system.chart == Chart::cayley) find_products();
  }

  std::vector<S> before,  ///< the momentum at the start; energy x time
      after,              ///< at the end
      vectors,            ///< at the end
      halfway,         ///< in the middle, where it is as long: \f$e^{-hv/2}a\f$; in Cayley's chart the mean
      sizes;           ///< of what A p is the sum of, over double: its roundings are these times epsilon
  StepForce<S> force;  ///< at both ends

  /// When the next step starts, for a force, and the frame of the point there for one of the other side.
  /// @throws OutsideDomain  where there is such a force and no frame
  void begin_at(S const& time, std::vector<double> const& frame = {}) { force.begin_at(time, frame); }

  /// The momenta at both ends, and the vectors at the end, of a step with this velocity.
  /// @param h  step, time
  /// @param v  velocity, 1/time
  /// @param a  vectors at the start
  /// @return   false where the step leaves the chart: the turn is beyond the reach of the series of chi
  bool operator()(S const& h, std::vector<S> const& v, std::vector<S> const& a) {
    auto const d = v.size();
    slopes_at(v, a);
    for (std::size_t i = 0; i < d; ++i) p_[i] = slopes_[1 + i];
    if (!a.empty()) {
      push(h / S(2), a, before);
      for (std::size_t k = 0; k < a.size(); k += moved_.size())
        carry(h, v, &a[k], &vectors[k], halfway.empty() ? nullptr : &halfway[k]);
      slopes_at(v, vectors);
      for (std::size_t i = 0; i < d; ++i) p_[i] = (p_[i] + slopes_[1 + i]) / S(2);
      push(h / S(-2), vectors, after);
    }
    if (!add_chi(h, v, a.empty())) return false;
    if (system_.force) add_force(h, v, a);
    return true;
  }

  /// Carries a small covector from the start of the step to its end: \f$e^{A^T}x\f$, to second order.
  void transport(std::vector<S>& x) {
    apply_ad_star(x, odd_);
    apply_ad_star(odd_, even_);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += odd_[i] + even_[i] / S(2);
  }
  /// Carries a covector that is constant on the other side along the step of the last call:
  /// \f$e^{A^T}x\f$, in Cayley's chart \f$\mathrm{Ad}^*\f$ of its transform.
  void carry_covector(S const& h, std::vector<S> const& v, S* x) {
    auto const d = before.size();
    if (system_.chart == Chart::cayley) {
      S const signed_h = h * S(system_.sign());
      auto const moved =
          system_.algebra.template coadjoint<S>(cayley(hat_of_step(system_.algebra, signed_h, v)),
                                                cayley(hat_of_step(system_.algebra, S(-signed_h), v)));
      std::copy(x, x + d, odd_.begin());
      for (std::size_t i = 0; i < d; ++i) {
        x[i] = S(0);
        for (std::size_t c = 0; c < d; ++c)
          x[i] += moved(static_cast<Index>(i), static_cast<Index>(c)) * odd_[c];
      }
      return;
    }
    std::copy(x, x + d, odd_.begin());
    double const size = detail::largest_part(odd_);
    for (int k = 1; k < 200; ++k) {
      apply_ad_star(odd_, even_);
      for (std::size_t i = 0; i < d; ++i) x[i] += odd_[i] = even_[i] / S(k);
      if (!(detail::largest_part(odd_) > negligible_ * size)) return;
    }
  }
  /// The squares of the entries of \f$h\,\mathrm{ad}_v\f$ in the last call, added up: no eigenvalue is larger
  /// than its root.
  S square_of_ad() const {
    S sum(0);
    for (auto const& entry : ad_star_) sum += entry.value * entry.value;
    return sum;
  }

 private:
  static std::size_t n(int i) { return static_cast<std::size_t>(i); }

  void slopes_at(std::vector<S> const& v, std::vector<S> const& a) {
    std::copy(v.begin(), v.end(), inputs_.begin());
    std::copy(a.begin(), a.end(), inputs_.begin() + static_cast<std::ptrdiff_t>(v.size()));
    system_.slopes(inputs_.data(), slopes_.data(), work_);
  }

  /// Sets `sum` to \f$h J\f$, \f$J_c = \partial l/\partial a\cdot(e_ca)\f$ at the slopes last taken.
  void push(S const& h, std::vector<S> const& a, std::vector<S>& sum) {
    std::fill(sum.begin(), sum.end(), S(0));
    auto const d = sum.size(), m = moved_.size();
    S const signed_h = h * S(system_.sign());
    for (auto const& e : system_.algebra.entries)
      for (std::size_t k = 0; k < a.size(); k += m)
        sum[n(e.direction)] += slopes_[1 + d + k + n(e.row)] * a[k + n(e.column)] * signed_h * S(e.value);
  }

  /// \f$e^{-hv}a\f$ of one vector, by its series, and \f$e^{-hv/2}a\f$ where there is room for it; with the
  /// sign of the side.
  void carry(S const& h, std::vector<S> const& v, S const* a, S* out, S* half) {
    auto const m = moved_.size();
    S const signed_h = h * S(-system_.sign());
    if (system_.chart == Chart::cayley) {
      carry_by(cayley(hat_of_step(system_.algebra, signed_h, v)), a, out);
      for (std::size_t i = 0; half && i < m; ++i) half[i] = (a[i] + out[i]) / S(2);
      return;
    }
    if (size_of_step(system_.algebra, to_double(base_value(h)), v) > 1) {
      carry_by(matrix_exponential(hat_of_step(system_.algebra, signed_h, v)), a, out);
      if (half) carry_by(matrix_exponential(hat_of_step(system_.algebra, S(signed_h / S(2)), v)), a, half);
      return;
    }
    std::vector<S>& term = moved_;
    std::copy(a, a + m, term.begin()), std::fill(out, out + m, S(0));
    if (half) std::copy(a, a + m, half);
    double const size = detail::largest_part(term);
    next_.resize(m);
    double power_of_half = 1;
    for (int k = 1; k < 200; ++k) {
      std::fill(next_.begin(), next_.end(), S(0));
      for (auto const& e : system_.algebra.entries)
        next_[n(e.row)] += v[n(e.direction)] * term[n(e.column)] * S(e.value);
      for (std::size_t i = 0; i < m; ++i) {
        term[i] = next_[i] * signed_h / S(k);
        out[i] += term[i];
      }
      power_of_half /= 2;
      for (std::size_t i = 0; half && i < m; ++i) half[i] += term[i] * S(power_of_half);
      if (!(detail::largest_part(term) > negligible_ * size)) break;
    }
    for (std::size_t i = 0; i < m; ++i) out[i] = a[i] + out[i];
  }

  static void carry_by(Matrix<S> const& c, S const* a, S* out) {
    for (Index i = 0; i < c.rows(); ++i) {
      out[i] = S(0);
      for (Index j = 0; j < c.cols(); ++j) out[i] += c(i, j) * a[j];
    }
  }

  /// Adds the force at both ends, each over half of the step, at the momentum that is the mean over the step.
  void add_force(S const& h, std::vector<S> const& v, std::vector<S> const& a) {
    force.evaluate(h, v, a, vectors, p_, [&](S* x) { carry_covector(h, v, x); });
    for (std::size_t i = 0; i < v.size(); ++i) {
      before[i] -= h * force.before[i] / S(2);
      after[i] += h * force.after[i] / S(2);
    }
  }

  /// The matrix of \f$A^T = h\,\mathrm{ad}^*_v\f$, with the sign of the side; only what is not always zero.
  void set_ad_star(S const& h, std::vector<S> const& v) {
    S const signed_h = h * S(system_.sign());
    for (auto& entry : ad_star_) {
      S sum = v[entry.first->a] * S(entry.first->value);
      for (auto const* one = entry.first + 1; one != entry.end; ++one) sum += v[one->a] * S(one->value);
      entry.value = sum * signed_h;
    }
  }
  /// \f$A^Tx\f$.
  void apply_ad_star(std::vector<S> const& x, std::vector<S>& out) const {
    std::fill(out.begin(), out.end(), S(0));
    for (auto const& entry : ad_star_) out[entry.row] += entry.value * x[entry.column];
  }

  /// Adds \f$\chi(A)^Tp\f$ to `before` and \f$\chi(-A)^Tp\f$ to `after`: the even part of chi, and half of
  /// A p on either side.
  bool add_chi(S const& h, std::vector<S> const& v, bool alone) {
    auto const d = v.size();
    set_ad_star(h, v);
    apply_ad_star(p_, odd_);
    if constexpr (std::is_same_v<S, double>) {
      sizes.assign(d, 0.0);
      for (auto const& entry : ad_star_) sizes[entry.row] += std::abs(entry.value * p_[entry.column]);
    }
    if (alone) std::fill(before.begin(), before.end(), S(0)), std::fill(after.begin(), after.end(), S(0));
    for (std::size_t i = 0; i < d; ++i) {
      S const half = odd_[i] / S(2);
      before[i] += p_[i] - half, after[i] += p_[i] + half;
    }
    if (system_.chart == Chart::cayley) return add_products(h, v);
    double const allowed = negligible_ * detail::largest_part(p_);
    auto const& beta = detail::coefficients_of_chi();
    for (std::size_t k = 1; k < beta.size(); ++k) {
      apply_ad_star(odd_, even_);
      double const largest = detail::largest_part(even_) * std::abs(beta[k]);
      for (std::size_t i = 0; i < d; ++i) {
        S const part = even_[i] * S(beta[k]);
        before[i] += part, after[i] += part;
      }
      if (!(largest > allowed)) return largest == largest;
      apply_ad_star(even_, odd_);
    }
    return false;
  }

  /// The even part in the chart by Cayley's transform: \f$-\tfrac{h^2}4\langle p, v\,e_b\,v\rangle\f$.
  bool add_products(S const& h, std::vector<S> const& v) {
    S const factor = h * h / S(-4);
    for (auto const& t : *products_) {
      S const part = factor * v[t.a] * v[t.c] * p_[t.k] * S(t.value);
      before[t.b] += part, after[t.b] += part;
    }
    return true;
  }
  /// The part along \f$e_k\f$ of \f$e_a\,e_b\,e_c\f$, added up over the two orders of a and c.
  struct Product {
    std::size_t a, b, c, k;
    double value;
  };
  void find_products() {
    products_ = std::make_shared<std::vector<Product>>();
    auto const& basis = system_.algebra.basis;
    for (std::size_t b = 0; b < basis.size(); ++b)
      for (std::size_t a = 0; a < basis.size(); ++a) {
        Eigen::MatrixXd const ab = basis[a] * basis[b], ba = basis[b] * basis[a];
        if (ab.isZero(0) && ba.isZero(0)) continue;
        for (std::size_t c = a; c < basis.size(); ++c) {
          Eigen::MatrixXd const both =
              a == c ? Eigen::MatrixXd(ab * basis[c]) : ab * basis[c] + basis[c] * ba;
          auto const along = system_.algebra.vee(Matrix<double>(both));
          for (std::size_t k = 0; k < basis.size(); ++k)
            if (double const x = along[static_cast<Index>(k)]; x != 0) products_->push_back({a, b, c, k, x});
        }
      }
  }

  /// A part of a structure constant: what the component a of the velocity contributes.
  struct Part {
    std::size_t a;
    double value;
  };
  /// An entry of the matrix of \f$A^T\f$.
  struct AdStarEntry {
    std::size_t row, column;
    Part const *first, *end;
    S value;
  };
  void find_pattern() {
    auto constants = system_.algebra.constants;
    std::sort(constants.begin(), constants.end(),
              [](auto const& x, auto const& y) { return std::tie(x.b, x.c, x.a) < std::tie(y.b, y.c, y.a); });
    parts_ = std::make_shared<std::vector<Part>>();
    parts_->reserve(constants.size());
    for (std::size_t k = 0; k < constants.size(); ++k) {
      auto const& c = constants[k];
      parts_->push_back({n(c.a), c.value});
      bool const same = k > 0 && constants[k - 1].b == c.b && constants[k - 1].c == c.c;
      if (same)
        ++ad_star_.back().end;
      else
        ad_star_.push_back({n(c.b), n(c.c), &parts_->back(), &parts_->back() + 1, S(0)});
    }
  }

  static constexpr double negligible_ = 0x1p-55;
  ReducedSystem const& system_;
  std::vector<S> inputs_, slopes_, work_, p_, odd_, even_, moved_, next_;
  std::vector<AdStarEntry> ad_star_;
  std::shared_ptr<std::vector<Product>> products_;
  std::shared_ptr<std::vector<Part>> parts_;  // to which the entries point, in copies too
};

}  // namespace actio::systems
