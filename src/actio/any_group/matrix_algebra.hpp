// The algebra of a group of matrices as data: a basis, and the structure constants that follow from it.
//
// The groups of the library are types, known when the code is compiled. This one is told when the program
// runs, by its name (named_algebra.hpp) or by a basis of real matrices, and it is what a scene or a program
// in another language can give. Entries and constants that are zero are not stored.
#pragma once

#include <functional>
#include <utility>

#include "actio/any_group/span_projection.hpp"

namespace actio {

/// A Lie algebra of real square matrices with a basis \f$e_1, \dots, e_d\f$.
struct MatrixAlgebra {
  /// An entry other than zero of one of several matrices.
  struct Entry {
    int direction;  ///< which of the matrices
    int row;        ///< of the entry
    int column;     ///< of the entry
    double value;   ///< the entry
  };
  /// A structure constant other than zero: the part of \f$[e_a, e_b]\f$ along \f$e_c\f$.
  struct Constant {
    int a;         ///< of the first vector of the bracket
    int b;         ///< of the second
    int c;         ///< of the component
    double value;  ///< the component
  };

  std::string name;                     ///< of the group, `SE(2)`; empty where it was given by its basis
  std::vector<std::string> components;  ///< names of the coordinates, one for each basis matrix
  int size = 0;                         ///< rows of a matrix
  int dimension = 0;                    ///< of the algebra
  std::vector<Eigen::MatrixXd> basis;   ///< \f$e_a\f$
  std::vector<Entry> entries;           ///< of the basis
  std::vector<Entry> projection;        ///< of the dual basis inside the span, times the denominator
  double denominator = 1;               ///< of the projection
  std::vector<Constant> constants;      ///< \f$[e_a, e_b] = \sum_c C^c_{ab}\,e_c\f$, for all ordered pairs
  /// How far a matrix is from the group, by the largest row of the difference from the element of the group
  /// that the library restores it to; empty where no more is known of the group than its algebra.
  std::function<double(Eigen::MatrixXd const&)> distance_from_group;

  /// \f$\sum_a v^ae_a\f$.
  template <MatrixLike V>
  auto hat(V const& v) const {
    using S = typename V::Scalar;
    Matrix<S> a = Matrix<S>::Zero(size, size);
    for (auto const& e : entries) a(e.row, e.column) += S(v[e.direction]) * S(e.value);
    return a;
  }
  /// The coordinates of the orthogonal projection of a matrix on the span of the basis: by one division of a
  /// sum of whole multiples where the basis is simple, as those of all groups with names are.
  template <MatrixLike M>
  auto vee(M const& a) const {
    using S = typename M::Scalar;
    Vector<S> v = Vector<S>::Zero(dimension);
    for (auto const& e : projection) v[e.direction] += S(a(e.row, e.column)) * S(e.value);
    if (denominator != 1)
      for (int c = 0; c < dimension; ++c) v[c] /= S(denominator);
    return v;
  }
  /// \f$[v, w]\f$.
  template <MatrixLike V>
  auto bracket(V const& v, V const& w) const {
    using S = typename V::Scalar;
    Vector<S> u = Vector<S>::Zero(dimension);
    for (auto const& c : constants) u[c.c] += S(v[c.a]) * S(w[c.b]) * S(c.value);
    return u;
  }
  /// The matrix of \f$\mathrm{ad}_v\f$ in the basis.
  template <MatrixLike V>
  auto ad(V const& v) const {
    using S = typename V::Scalar;
    Matrix<S> m = Matrix<S>::Zero(dimension, dimension);
    for (auto const& c : constants) m(c.c, c.b) += S(v[c.a]) * S(c.value);
    return m;
  }
};

namespace detail {

/// The entries of a matrix, column by column.
inline Eigen::VectorXd entries_of(Eigen::MatrixXd const& a) {
  return Eigen::Map<Eigen::VectorXd const>(a.data(), a.size());
}

/// The commutator of two basis matrices, from their entries that are not zero.
inline Eigen::MatrixXd commutator(std::vector<MatrixAlgebra::Entry> const& a,
                                  std::vector<MatrixAlgebra::Entry> const& b, int size) {
  Eigen::MatrixXd c = Eigen::MatrixXd::Zero(size, size);
  for (auto const& x : a)
    for (auto const& y : b) {
      if (x.column == y.row) c(x.row, y.column) += x.value * y.value;
      if (y.column == x.row) c(y.row, x.column) -= x.value * y.value;
    }
  return c;
}

/// Entries and projection, from the basis.
inline void find_projection(MatrixAlgebra& algebra) {
  std::vector<Eigen::VectorXd> rows;
  for (auto const& e : algebra.basis) rows.push_back(entries_of(e));
  SpanProjection const span(rows);
  algebra.denominator = span.denominator;
  for (int a = 0; a < algebra.dimension; ++a)
    for (int j = 0; j < algebra.size; ++j)
      for (int i = 0; i < algebra.size; ++i) {
        auto const k = static_cast<std::size_t>(a);
        if (double const x = algebra.basis[k](i, j); x != 0) algebra.entries.push_back({a, i, j, x});
        double const y = span.dual[k][i + j * algebra.size];
        if (y != 0) algebra.projection.push_back({a, i, j, y});
      }
}

/// Structure constants, from the commutators.
/// @throws OutsideDomain  where a commutator leaves the span: which one, and how far
inline void find_constants(MatrixAlgebra& algebra) {
  constexpr double bound = 1e-9, rounding = 1e-14;
  auto const d = static_cast<std::size_t>(algebra.dimension);
  std::vector<std::vector<MatrixAlgebra::Entry>> of(d);
  for (auto const& e : algebra.entries) of[static_cast<std::size_t>(e.direction)].push_back(e);
  for (std::size_t a = 0; a < d; ++a)
    for (std::size_t b = a + 1; b < d; ++b) {
      Eigen::MatrixXd const c = commutator(of[a], of[b], algebra.size);
      Vector<double> const v = algebra.vee(c);
      double const scale = algebra.basis[a].norm() * algebra.basis[b].norm(),
                   outside = (Eigen::MatrixXd(algebra.hat(v)) - c).norm() / scale;
      if (!(outside <= bound))
        throw OutsideDomain("basis of an algebra",
                            "commutators of the matrices must be in their span, but [e_" +
                                std::to_string(a + 1) + ", e_" + std::to_string(b + 1) +
                                "] leaves it; distance relative to the two",
                            outside, bound);
      for (std::size_t k = 0; k < d; ++k) {
        double const x = v[static_cast<Index>(k)];
        if (!(std::abs(x) * algebra.basis[k].norm() > rounding * scale)) continue;
        int const i = static_cast<int>(a), j = static_cast<int>(b), l = static_cast<int>(k);
        algebra.constants.push_back({i, j, l, x}), algebra.constants.push_back({j, i, l, -x});
      }
    }
}

/// The algebra with this basis of square matrices of one size, its components `x1`, `x2`, ...
inline MatrixAlgebra algebra_of_basis(std::string name, std::vector<Eigen::MatrixXd> basis) {
  MatrixAlgebra algebra;
  algebra.name = std::move(name);
  algebra.basis = std::move(basis);
  algebra.size = static_cast<int>(algebra.basis.front().rows());
  algebra.dimension = static_cast<int>(algebra.basis.size());
  for (int a = 1; a <= algebra.dimension; ++a) algebra.components.push_back("x" + std::to_string(a));
  find_projection(algebra);
  find_constants(algebra);
  return algebra;
}

/// The largest dimension of an algebra that is told at run time.
inline constexpr int largest_dimension_of_algebra = 64;
/// Refuses larger ones.
/// @throws OutsideDomain
inline void require_moderate_dimension(std::string const& name, double dimension) {
  if (!(dimension <= largest_dimension_of_algebra))
    throw OutsideDomain("group " + name, "the dimension must be moderate", dimension,
                        largest_dimension_of_algebra);
}

/// @throws OutsideDomain, NotFinite
inline void check_basis_matrix(Eigen::MatrixXd const& e, Index rows, std::size_t number) {
  std::string const which = "matrix e_" + std::to_string(number) + " of a basis";
  if (e.rows() != rows || e.cols() != rows)
    throw OutsideDomain(which,
                        "square matrices of one size are needed; it has " + std::to_string(e.rows()) +
                            " rows; its columns and the rows of the first",
                        static_cast<double>(e.cols()), static_cast<double>(rows));
  require_finite(e, which.c_str());
  double const largest = e.cwiseAbs().maxCoeff();
  if (!(largest >= 1e-6))
    throw OutsideDomain(which, "a matrix with an entry of moderate size is needed, scale it; largest",
                        largest, 1e-6);
  if (!(largest <= 1e6))
    throw OutsideDomain(which, "entries of moderate size are needed, scale the matrix; largest", largest,
                        1e6);
}

}  // namespace detail

/// The algebra spanned by some real matrices, with components `x1`, `x2`, ...
///
/// @throws Singular       where a matrix is a combination of those before it: which one, and the combination
/// @throws OutsideDomain  where a commutator of two of them leaves their span, by more than 1e-9 relative to
///                        the two; where they are none, more than 64, not square of one size from 1 to 128,
///                        or with entries out of proportion
/// @throws NotFinite      where an entry is no number
inline MatrixAlgebra spanned_algebra(std::vector<Eigen::MatrixXd> basis) {
  if (basis.empty()) throw OutsideDomain("basis of an algebra", "at least one matrix is needed", 0, 1);
  detail::require_moderate_dimension("with a basis of its own", static_cast<double>(basis.size()));
  Index const rows = basis.front().rows();
  if (rows < 1 || rows > 128)
    throw OutsideDomain("basis of an algebra", "matrices of 1 to 128 rows are needed",
                        static_cast<double>(rows), rows < 1 ? 1 : 128);
  for (std::size_t a = 0; a < basis.size(); ++a) detail::check_basis_matrix(basis[a], rows, a + 1);
  return detail::algebra_of_basis("", std::move(basis));
}

}  // namespace actio
