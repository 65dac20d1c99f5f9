// The algebra of a group of matrices as data: a basis, and the structure constants that follow from it.
//
// The groups of the library are types, known when the code is compiled. This one is told when the program
// runs, by its name (named_algebra.hpp) or by a basis of real matrices, and it is what a scene or a program
// in another language can give. Entries and constants that are zero are not stored.
#pragma once

#include <Eigen/Core>

#include <functional>
#include <utility>

#include "actio/any_group/span_projection.hpp"

namespace actio::systems {

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
  /// The matrix of \f$\mathrm{Ad}^*_g\f$ on covectors: \f$\langle x, \mathrm{vee}(g\,e_a\,g^{-1})\rangle\f$
  /// is the component a of what x becomes.
  /// @param g, back  an element of the group, and its inverse
  template <class S>
  Matrix<S> coadjoint(Matrix<S> const& g, Matrix<S> const& back) const {
    Matrix<S> out(dimension, dimension);
    for (int a = 0; a < dimension; ++a) {
      Matrix<S> moved = Matrix<S>::Zero(size, size);
      for (auto const& e : entries)
        if (e.direction == a)
          for (int i = 0; i < size; ++i)
            for (int j = 0; j < size; ++j) moved(i, j) += g(i, e.row) * back(e.column, j) * S(e.value);
      auto const along = vee(moved);
      for (int c = 0; c < dimension; ++c) out(a, c) = along[c];
    }
    return out;
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
Eigen::MatrixXd commutator(std::vector<MatrixAlgebra::Entry> const& a,
                           std::vector<MatrixAlgebra::Entry> const& b, int size);

/// Entries and projection, from the basis.
void find_projection(MatrixAlgebra& algebra);

/// The algebra with this basis of square matrices of one size, its components `x1`, `x2`, ...
MatrixAlgebra algebra_of_basis(std::string name, std::vector<Eigen::MatrixXd> basis);

/// The largest dimension of an algebra that is told at run time.
inline constexpr int largest_dimension_of_algebra = 64;
/// Refuses larger ones.
/// @throws OutsideDomain
inline void require_moderate_dimension(std::string const& name, double dimension) {
  if (!(dimension <= largest_dimension_of_algebra))
    throw OutsideDomain("group " + name, "the dimension must be moderate", dimension,
                        largest_dimension_of_algebra);
}

}  // namespace detail

/// The algebra spanned by some real matrices, with components `x1`, `x2`, ...
///
/// \snippet reduction.cpp spanned_algebra
/// @throws Singular       where a matrix is a combination of those before it: which one, and the combination
/// @throws OutsideDomain  where a commutator of two of them leaves their span, by more than 1e-9 relative to
///                        the two; where they are none, more than 64, not square of one size from 1 to 128,
///                        or with entries out of proportion
/// @throws NotFinite      where an entry is no number
MatrixAlgebra spanned_algebra(std::vector<Eigen::MatrixXd> basis);

}  // namespace actio::systems
