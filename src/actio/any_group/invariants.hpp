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

namespace actio::systems {

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
  std::string text() const;
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

/// How far a function is from a Casimir: the largest coefficient of its brackets with the coordinates,
/// relative to its own and those of the algebra.
double defect_of_casimir(MatrixAlgebra const& algebra, Casimir const& casimir);

/// Coefficients as small whole numbers without a common divisor, where they are in such a proportion; the
/// first one positive.
Casimir with_whole_coefficients(Casimir casimir);

/// The function with these coefficients of monomials.
Casimir casimir_of(MatrixAlgebra const& algebra, int degree, SparseRow const& polynomial);

/// The structure constants in the basis \f$e_a/2^{k_a}\f$ with largest entries near 1, so that units of the
/// basis do not matter to bounds on rounding.
class LevelBasis {
 public:
  explicit LevelBasis(MatrixAlgebra const& algebra);
  MatrixAlgebra constants;  ///< of this basis; without matrices

  /// The same function of the components of momenta in the first basis, or in this one: exact.
  Casimir in_basis(Casimir casimir, bool this_one) const;

 private:
  std::vector<double> powers_;
  double power(int a) const { return powers_[static_cast<std::size_t>(a)]; }
};

}  // namespace detail

/// All linear and quadratic Casimirs: a basis of the linear ones, and then quadratic ones that together with
/// products of linear ones are a basis. Coefficients are small whole numbers where there is such a basis of
/// the space, which is so for all groups with names.
///
/// Those of higher degree (the cubic one of SL(3), say) are not looked for. Each one that is returned has
/// been put into the conditions again: defects are below 1e-9 of its largest coefficient.
///
/// \snippet reduction.cpp casimirs
std::vector<Casimir> casimirs(MatrixAlgebra const& algebra);

}  // namespace actio::systems
