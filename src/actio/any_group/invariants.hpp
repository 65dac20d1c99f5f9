// Functions on the dual of an algebra that no motion changes: Casimirs, found from the structure constants.
//
// C is a Casimir if {C, mu_b} = 0 for all coordinates mu_b. With {mu_a, mu_b} = +- sum_c C^c_ab mu_c these
// are linear conditions on the coefficients of C, one for each b and each monomial of the bracket.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "actio/any_group/matrix_algebra.hpp"
#include "actio/any_group/sparse_elimination.hpp"

namespace actio {

/// A linear or quadratic function on the dual of an algebra that Poisson-commutes with every function.
struct Casimir {
  /// \f$c\,\mu_i\f$, or \f$c\,\mu_i\mu_j\f$ with \f$i\le j\f$.
  struct Term {
    int i;               ///< of the first factor
    int j;               ///< of the second; -1 in a linear function
    double coefficient;  ///< c
  };
  int degree;                           ///< 1 or 2
  std::vector<Term> terms;              ///< none of them zero
  std::vector<std::string> components;  ///< names of the components of a momentum

  /// Its value at a momentum, at every scalar; the unit of the momentum, or its square.
  template <MatrixLike V>
  auto evaluate(V const& mu) const {
    using S = typename V::Scalar;
    S sum(0);
    for (Term const& t : terms) {
      S const factor = S(mu[t.i]) * S(t.coefficient);
      sum += t.j < 0 ? factor : S(factor * S(mu[t.j]));
    }
    return sum;
  }
  /// As a formula in the components: `w1^2 + w2^2 + w3^2`, `x1^2 + 4*x2*x3`.
  std::string text() const {
    std::string sum;
    for (Term const& t : terms) {
      double const size = std::abs(t.coefficient);
      sum += sum.empty() ? (t.coefficient < 0 ? "-" : "") : (t.coefficient < 0 ? " - " : " + ");
      if (size != 1) sum += show(size) + "*";
      std::string const& first = components[static_cast<std::size_t>(t.i)];
      sum += t.j == t.i ? first + "^2"
             : t.j < 0  ? first
                        : first + "*" + components[static_cast<std::size_t>(t.j)];
    }
    return sum;
  }
};

namespace detail {

/// Monomials of degree 1 and 2 in d variables, numbered.
struct Monomials {
  int d;  ///< variables
  int count(int degree) const { return degree == 1 ? d : d * (d + 1) / 2; }
  /// Of \f$\mu_i\mu_j\f$.
  int number(int i, int j) const {
    if (i > j) std::swap(i, j);
    return i * d - i * (i - 1) / 2 + j - i;
  }
  /// The two factors.
  std::pair<int, int> factors(int number_of_both) const {
    int i = 0;
    while (number_of_both >= d - i) number_of_both -= d - i++;
    return {i, i + number_of_both};
  }
};

/// The conditions \f$\{C, \mu_b\} = 0\f$ on the coefficients of a polynomial of degree 1 or 2, for one b.
inline std::map<int, SparseRow> casimir_conditions(MatrixAlgebra const& algebra, int degree, int b) {
  Monomials const monomials{algebra.dimension};
  std::map<int, SparseRow> rows;
  for (auto const& c : algebra.constants) {
    if (c.b != b) continue;
    if (degree == 1)
      rows[c.c][c.a] += c.value;
    else
      for (int i = 0; i < algebra.dimension; ++i)
        rows[monomials.number(i, c.c)][monomials.number(i, c.a)] += i == c.a ? 2 * c.value : c.value;
  }
  return rows;
}

/// How far a function is from a Casimir: the largest coefficient of its brackets with the coordinates,
/// relative to its own and those of the algebra.
inline double defect_of_casimir(MatrixAlgebra const& algebra, Casimir const& casimir) {
  Monomials const monomials{algebra.dimension};
  std::map<int, std::vector<Casimir::Term>> with;  // the terms with a variable, this one first
  double defect = 0, largest = 0, constants = 1e-300;
  for (auto const& t : casimir.terms) {
    with[t.i].push_back(t), largest = std::max(largest, std::abs(t.coefficient));
    if (t.j >= 0) with[t.j].push_back({t.j, t.i, t.coefficient});
  }
  std::map<std::pair<int, int>, double> brackets;  // by b and the monomial
  for (auto const& c : algebra.constants) {
    constants = std::max(constants, std::abs(c.value));
    for (auto const& t : with[c.a])
      brackets[{c.b, t.j < 0 ? c.c : monomials.number(c.c, t.j)}] += t.coefficient * c.value;
  }
  for (auto const& [which, x] : brackets) defect = std::max(defect, std::abs(x));
  return defect / (largest * constants);
}

/// Coefficients as small whole numbers without a common divisor, where they are in such a proportion; the
/// first one positive.
inline Casimir with_whole_coefficients(Casimir casimir) {
  double least = std::abs(casimir.terms.front().coefficient);
  for (auto const& t : casimir.terms) least = std::min(least, std::abs(t.coefficient));
  double const sign = casimir.terms.front().coefficient < 0 ? -1 : 1;
  for (int times = 1; times <= 60; ++times) {
    double const scale = sign * times / least;
    bool const whole = std::all_of(casimir.terms.begin(), casimir.terms.end(), [&](auto const& t) {
      double const x = t.coefficient * scale;
      return std::abs(x - std::round(x)) < 1e-9 * times && std::abs(x) < 1e6;
    });
    if (!whole) continue;
    for (auto& t : casimir.terms) t.coefficient = std::round(t.coefficient * scale);
    return casimir;
  }
  for (auto& t : casimir.terms) t.coefficient *= sign;
  return casimir;
}

/// The function with these coefficients of monomials.
inline Casimir casimir_of(MatrixAlgebra const& algebra, int degree, SparseRow const& polynomial) {
  Casimir casimir{degree, {}, algebra.components};
  for (auto const& [k, x] : polynomial) {
    auto const [i, j] = degree == 1 ? std::pair(k, -1) : Monomials{algebra.dimension}.factors(k);
    casimir.terms.push_back({i, j, x});
  }
  return casimir;
}

/// The structure constants in the basis \f$e_a/2^{k_a}\f$ with largest entries near 1, so that units of the
/// basis do not matter to bounds on rounding.
class LevelBasis {
 public:
  explicit LevelBasis(MatrixAlgebra const& algebra) {
    constants.dimension = algebra.dimension, constants.components = algebra.components;
    for (auto const& e : algebra.basis)
      powers_.push_back(std::exp2(std::round(std::log2(e.cwiseAbs().maxCoeff()))));
    for (auto c : algebra.constants) {
      c.value *= power(c.c) / (power(c.a) * power(c.b));
      constants.constants.push_back(c);
    }
  }
  MatrixAlgebra constants;  ///< of this basis; without matrices

  /// The same function of the components of momenta in the first basis, or in this one: exact.
  Casimir in_basis(Casimir casimir, bool this_one) const {
    for (auto& t : casimir.terms) {
      double const factor = power(t.i) * (t.j < 0 ? 1 : power(t.j));
      t.coefficient = this_one ? t.coefficient * factor : t.coefficient / factor;
    }
    return casimir;
  }

 private:
  std::vector<double> powers_;
  double power(int a) const { return powers_[static_cast<std::size_t>(a)]; }
};

/// All polynomials of degree 1 or 2 that meet the conditions.
inline std::vector<SparseRow> homogeneous_casimirs(MatrixAlgebra const& algebra, int degree) {
  SparseElimination conditions(Monomials{algebra.dimension}.count(degree));
  std::vector<SparseRow> waiting;
  for (int b = 0; b < algebra.dimension; ++b)
    for (auto&& [monomial, row] : casimir_conditions(algebra, degree, b)) waiting.push_back(std::move(row));
  // Those that say something new first, and those that repeat what is nearly known last.
  for (double const least : {0.3, 0.1, 0.01, 1e-4, 0.0})
    std::erase_if(waiting, [&](SparseRow const& row) {
      double const distance = conditions.add(row, least);
      return distance == 0 || distance >= least;
    });
  return conditions.null_space();
}

/// Quadratic ones that are no sums of products of linear ones.
inline std::vector<SparseRow> without_products(std::vector<SparseRow> const& quadratic,
                                               std::vector<SparseRow> const& linear, Monomials monomials) {
  SparseElimination span(monomials.count(2));
  for (std::size_t a = 0; a < linear.size(); ++a)
    for (std::size_t b = a; b < linear.size(); ++b) {
      SparseRow product;
      for (auto const& [i, x] : linear[a])
        for (auto const& [j, y] : linear[b]) product[monomials.number(i, j)] += x * y;
      span.add(product);
    }
  std::size_t const products = span.rows().size();
  for (SparseRow const& q : quadratic) span.add(q);
  return {span.rows().begin() + static_cast<std::ptrdiff_t>(products), span.rows().end()};
}

}  // namespace detail

/// All linear and quadratic Casimirs: a basis of the linear ones, and then quadratic ones that together with
/// products of linear ones are a basis. Coefficients are small whole numbers where there is such a basis of
/// the space, which is so for all groups with names.
///
/// Those of higher degree (the cubic one of SL(3), say) are not looked for. Each one that is returned has
/// been put into the conditions again: defects are below 1e-9 of its largest coefficient.
inline std::vector<Casimir> casimirs(MatrixAlgebra const& algebra) {
  detail::LevelBasis const level(algebra);
  std::vector<Casimir> found;
  auto const keep = [&](int degree, std::vector<detail::SparseRow> const& polynomials) {
    for (auto const& p : polynomials) {
      Casimir const level_one = detail::casimir_of(level.constants, degree, p),
                    raw = level.in_basis(level_one, false), whole = detail::with_whole_coefficients(raw);
      double const defect = detail::defect_of_casimir(level.constants, level_one),
                   whole_defect = detail::defect_of_casimir(level.constants, level.in_basis(whole, true));
      if (std::min(defect, whole_defect) < 1e-9) found.push_back(whole_defect <= defect ? whole : raw);
    }
  };
  auto const linear = detail::homogeneous_casimirs(level.constants, 1);
  keep(1, linear);
  keep(2, detail::without_products(detail::homogeneous_casimirs(level.constants, 2), linear,
                                   detail::Monomials{algebra.dimension}));
  return found;
}

}  // namespace actio
