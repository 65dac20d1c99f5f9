// G x H of two matrix groups: pairs of elements, as block diagonal matrices.
//
// Every operation is done block by block with the operations of the factors, so that their structure,
// accuracy and refusals are those of the factors. A factor may be a product itself.
#pragma once

#include <utility>

#include "actio/groups/group.hpp"

namespace actio {

/// \f$G\times H\f$. Coordinates: those of G, then those of H.
///
/// `DirectProduct<SO<3>, Aff1>{}`, or `DirectProduct{g, h}` of groups that carry data.
template <MatrixGroup G, MatrixGroup H>
struct DirectProduct {
  [[no_unique_address]] G first;   ///< G
  [[no_unique_address]] H second;  ///< H

  /// Whether the sizes of both factors are known to the compiler.
  static constexpr bool fixed = G::size != Dynamic && H::size != Dynamic;
  static constexpr int size = fixed ? G::size + H::size : Dynamic;
  static constexpr int dim = fixed ? G::dim + H::dim : Dynamic;
  constexpr int matrix_size() const { return first.matrix_size() + second.matrix_size(); }
  constexpr int dimension() const { return first.dimension() + second.dimension(); }
  template <class S>
  using Matrix = actio::Matrix<S, size, size>;
  template <class S>
  using Vector = actio::Matrix<S, dim, 1>;

  template <MatrixLike V>
  auto hat(V const& v) const {
    using S = typename V::Scalar;
    return blocks<S>(first.hat(head<S>(v)), second.hat(tail<S>(v)));
  }
  template <MatrixLike M>
  auto vee(M const& a) const {
    using S = typename M::Scalar;
    return stacked<S>(first.vee(upper<S>(a)), second.vee(lower<S>(a)));
  }
  template <class S>
  Matrix<S> inverse(Matrix<S> const& a) const {
    return blocks<S>(primitive::inverse(first, upper<S>(a)), primitive::inverse(second, lower<S>(a)));
  }
  template <class S>
  Vector<S> Ad(Matrix<S> const& a, Vector<S> const& v) const {
    return stacked<S>(primitive::Ad(first, upper<S>(a), head<S>(v)),
                      primitive::Ad(second, lower<S>(a), tail<S>(v)));
  }
  template <class S>
  Vector<S> bracket(Vector<S> const& v, Vector<S> const& w) const {
    return stacked<S>(primitive::bracket(first, head<S>(v), head<S>(w)),
                      primitive::bracket(second, tail<S>(v), tail<S>(w)));
  }
  template <class S>
  Matrix<S> retract(Vector<S> const& v) const {
    return blocks<S>(primitive::retract(first, head<S>(v)), primitive::retract(second, tail<S>(v)));
  }
  template <Real S>
  Matrix<S> exp(Vector<S> const& v) const {
    return blocks<S>(primitive::exp(first, head<S>(v)), primitive::exp(second, tail<S>(v)));
  }
  /// @throws OutsideDomain  where a factor refuses, and where the matrix is not block diagonal
  template <Real S>
  Vector<S> log(Matrix<S> const& a) const {
    require_blocks<S>(a, "log", 1e-8);
    return stacked<S>(primitive::log_of<G, S>(first, upper<S>(a)),
                      primitive::log_of<H, S>(second, lower<S>(a)));
  }
  /// @throws OutsideDomain  where a factor refuses, and where the matrix is not even nearly block diagonal
  template <Real S>
  Matrix<S> restore(Matrix<S> const& a) const {
    require_blocks<S>(a, "restore", 0.1);
    return blocks<S>(primitive::restore(first, upper<S>(a)), primitive::restore(second, lower<S>(a)));
  }

  // The parts of a matrix and of a vector, and what they make up.

  /// The block of G.
  template <class S, MatrixLike M>
  Storage<G, S> upper(M const& a) const { return a.topLeftCorner(first.matrix_size(), first.matrix_size()); }
  /// The block of H.
  template <class S, MatrixLike M>
  Storage<H, S> lower(M const& a) const {
    return a.bottomRightCorner(second.matrix_size(), second.matrix_size());
  }
  /// The coordinates of G.
  template <class S, MatrixLike V>
  Coordinates<G, S> head(V const& v) const { return v.head(first.dimension()); }
  /// The coordinates of H.
  template <class S, MatrixLike V>
  Coordinates<H, S> tail(V const& v) const { return v.tail(second.dimension()); }
  /// The matrix with these blocks.
  template <class S>
  Matrix<S> blocks(Storage<G, S> const& a, Storage<H, S> const& b) const {
    Matrix<S> ab = Matrix<S>::Zero(matrix_size(), matrix_size());
    ab.topLeftCorner(a.rows(), a.rows()) = a;
    ab.bottomRightCorner(b.rows(), b.rows()) = b;
    return ab;
  }
  /// Coordinates of G, then of H.
  template <class S>
  Vector<S> stacked(Coordinates<G, S> const& v, Coordinates<H, S> const& w) const {
    Vector<S> vw(dimension());
    vw << v, w;
    return vw;
  }

 private:
  template <class S>
  void require_blocks(Matrix<S> const& a, char const* where, double bound) const {
    Matrix<S> const outside = a - blocks<S>(upper<S>(a), lower<S>(a));
    double const distance = row_norm(outside);
    if (!(distance <= bound))
      throw OutsideDomain(where, "a block diagonal matrix is needed; largest row outside of the blocks",
                          distance, bound);
  }
};

/// The pair (g, h) as an element of the product.
template <MatrixGroup G, MatrixGroup H, Scalar S>
Element<DirectProduct<G, H>, S> element_of_product(Element<G, S> const& g, Element<H, S> const& h) {
  DirectProduct<G, H> const group{g.group, h.group};
  return {group, group.template blocks<S>(g.value, h.value)};
}
/// The pair (g, h) that an element of the product is.
template <MatrixGroup G, MatrixGroup H, Scalar S>
std::pair<Element<G, S>, Element<H, S>> factors(Element<DirectProduct<G, H>, S> const& gh) {
  return {{gh.group.first, gh.group.template upper<S>(gh.value)},
          {gh.group.second, gh.group.template lower<S>(gh.value)}};
}

}  // namespace actio
