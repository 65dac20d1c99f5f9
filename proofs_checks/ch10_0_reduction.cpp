// Chapter 10: reduction of pairs of a configuration space that is larger than its symmetry group.
#include "actio/numbers/rank.hpp"
#include "actio/reduction/discrete_poisson.hpp"
#include "actio/variational/lie_poisson.hpp"
#include "actio/variational/momentum_map.hpp"

#include "pairs.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// A configuration space M with a symmetry group G that acts freely from the right: M is itself a group of
/// matrices and G the subgroup of the first few basis matrices, which fixes one vector of the standard basis.
/// Right-invariant functions of pairs are then those of \f$g_0g_1^{-1}\f$ and of the images of that vector.
struct SymmetricSpace {
  SpannedGroup m;
  int symmetries;  ///< dimension of G
  int fixed;       ///< the vector that G fixes
  int casimirs;    ///< how many functions of the dual of the algebra of G are constant on orbits

  std::string name() const { return m.name(); }
  /// An element of G.
  template <class S>
  GroupElement<S> draw_symmetry(Draw& draw) const {
    auto v = draw.template velocity<S>(m);
    v.coordinates.tail(m.dimension() - symmetries).setZero();
    return retract(v);
  }
};
/// A group beside the translations of the plane, as block matrices.
SpannedGroup with_translations(SpannedGroup const& group) {
  int const n = group.matrix_size(), size = n + 3;
  std::vector<SpannedGroup::WholeMatrix> basis(group.dimension() + 2,
                                               SpannedGroup::WholeMatrix::Zero(size, size));
  for (int a = 0; a < group.dimension(); ++a)
    basis[a].topLeftCorner(n, n) = group.hat(Vector<int>(Vector<int>::Unit(group.dimension(), a)));
  for (int i = 0; i < 2; ++i) basis[group.dimension() + i](n + i, size - 1) = 1;
  return SpannedGroup(group.name() + " x R^2", std::move(basis));
}
/// Frames in space with rotations about one of their axes, a bundle over the sphere that is no product; maps
/// of the line with stretchings about a point; products of a group with the plane.
std::vector<SymmetricSpace> const& spaces() {
  static std::vector<SymmetricSpace> const all = {
      {few_groups()[0], 1, 0, 1},
      {few_groups()[2], 1, 1, 1},
      {with_translations(few_groups()[0]), 3, 5, 1},
      {with_translations(few_groups()[2]), 2, 4, 0},
  };
  return all;
}
/// A function of pairs that is invariant under G.
template <class S>
auto draw_invariant(Draw& draw, SymmetricSpace const& space) {
  auto const heights = draw_vector<S>(draw, space.m.matrix_size());
  return lift_with_height(heights, space.fixed)(draw_group_polynomial<S>(draw, space.m));
}
/// The differential of a function of pairs, on (theta0, theta1).
template <class F, class S>
Vector<S> slopes(F const& f, GroupElement<S> const& g0, GroupElement<S> const& g1) {
  return stacked(std::vector<Momentum<SpannedGroup, S>>{D1(f, g0, g1), D2(f, g0, g1)});
}
/// Columns side by side.
template <class S>
Matrix<S> beside(std::vector<Vector<S>> const& columns) {
  Matrix<S> all(columns[0].size(), static_cast<Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k) all.col(static_cast<Index>(k)) = columns[k];
  return all;
}
/// The tangent of the discrete flow, on (theta0, theta1).
template <class L, class S>
Matrix<S> tangent_of_flow(L const& lagrangian, GroupElements<S> const& g) {
  auto const& group = g[0].group;
  int const d = group.dimension();
  Matrix<S> tangent(2 * d, 2 * d);
  for (int a = 0; a < 2 * d; ++a) {
    Change<S> w{rest<S>(group), rest<S>(group)};
    (a < d ? w.first : w.second).coordinates[a % d] = S(1);
    auto const moved = discrete_flow_tangent(lagrangian, g[0], g[1], g[2], w);
    tangent.col(a) << moved.first.coordinates, moved.second.coordinates;
  }
  return tangent;
}

}  // namespace

STATEMENT(claim_10_0_reduced_pair_space,
          "pairs of a general configuration space, reduced by its symmetries") {
  claim.convention(
      "Where $\\mathbb L$ is invariant and regular, the action free, and the momentum is $-D_1\\mathbb L$. "
      "Brackets of invariant functions are invariant, and the flow keeps them. The discrete momentum map "
      "commutes with invariant functions, the flow keeps it, and the leaves have the codimension of the "
      "coadjoint orbits of $G$. $-D_1\\mathbb L$ carries the bracket to that of $T^*M/G$. Instances of $M$ "
      "and $G$: frames in space with turns about one axis, a bundle that is no product; $\\mathrm{Aff}(1)$ "
      "with its stretchings; $\\SO(3)$ and $\\mathrm{Aff}(1)$, each beside a plane.");
  for (auto const& space : spaces()) {
    auto const& m = space.m;
    int const d = m.dimension();
    if (numbers_grow() && d > 3) continue;  // fractions grow with the size of a system
    auto const model = space.name();
    auto const g = draw_configurations<S>(draw, m, 3, ratio<S>(1, 2));
    auto const with_height = lift_with_height(draw_vector<S>(draw, m.matrix_size()), space.fixed);
    auto const L = with_height(with_motion_along(draw_group_polynomial<S>(draw, m), g, draw, with_height));
    Matrix<S> const pi = discrete_bivector(L, g[0], g[1]);
    int const dimension = 2 * d - space.symmetries;  // of (M x M)/G

    // Differentials of more invariant functions than there are coordinates, here and at a pair translated.
    std::vector<Vector<S>> here, there, outside;
    auto const k = space.draw_symmetry<S>(draw), other = draw.template element<S>(m, S(1));
    for (int i = 0; i <= dimension; ++i) {
      auto const f = draw_invariant<S>(draw, space);
      here.push_back(slopes(f, g[0], g[1])), there.push_back(slopes(f, g[0] * k, g[1] * k));
      outside.push_back(slopes(f, g[0] * other, g[1] * other));
    }
    Matrix<S> const forms = beside(here);
    auto const brackets = [&](Matrix<S> const& of, auto const& p, auto const& q) {
      return Matrix<S>(of.transpose() * discrete_bivector(L, p, q) * of);
    };
    Matrix<S> const reduced = brackets(forms, g[0], g[1]);
    auto const size = S(magnitude(forms) * magnitude(forms) * magnitude(pi));
    // Condition: omega is inverted, at configurations far apart.
    claim.zero("brackets of invariant functions are invariant", model,
               Matrix<S>(brackets(beside(there), g[0] * k, g[1] * k) - reduced), size, 100);
    claim.refutes("translated outside the symmetry group", model,
                  Matrix<S>(brackets(beside(outside), g[0] * other, g[1] * other) - reduced), size);

    // Leaves: the momentum map commutes with invariant functions, and as many of its functions as the orbits
    // of G leave free are the Casimir functions.
    auto const J = [&](int a, auto const& p, auto const& q) {
      using T = typename std::decay_t<decltype(p)>::Scalar;
      return discrete_momentum(L, p, q, right_translation(basis_velocity<T>(m, a)));
    };
    std::vector<Vector<S>> momenta;
    for (int a = 0; a < d; ++a)
      momenta.push_back(slopes([&](auto const& p, auto const& q) { return J(a, p, q); }, g[0], g[1]));
    Matrix<S> const all = beside(momenta), mixed = forms.transpose() * pi * all;
    auto const terms = S(magnitude(forms) * magnitude(pi) * magnitude(all));
    claim.zero("invariant functions commute with the momentum map", model,
               Matrix<S>(mixed.leftCols(space.symmetries)), terms, 100);
    claim.refutes("with momenta outside the symmetry group", model,
                  Matrix<S>(mixed.rightCols(d - space.symmetries)), terms);
    claim.fact("the reduced space has dimension 2 dim M - dim G", model, matrix_rank(forms) == dimension);
    claim.fact("its leaves have the codimension of the orbits of G", model,
               matrix_rank(reduced) == dimension - space.casimirs);

    // The flow keeps the brackets, and the momentum map with the leaves.
    Matrix<S> const step = tangent_of_flow(L, g), after = discrete_bivector(L, g[1], g[2]);
    auto const growth = S(magnitude(step) * magnitude(pi) * magnitude(step) + magnitude(after));
    claim.zero("the flow keeps the brackets", model, Matrix<S>(step * pi * step.transpose() - after), growth,
               1000);  // the tangent solves with a matrix of second derivatives, on both sides
    claim.refutes("the brackets at the pair before", model, Matrix<S>(step * pi * step.transpose() - pi),
                  growth, 1e-5);
    Vector<S> kept(space.symmetries), lost(d - space.symmetries);
    for (int a = 0; a < d; ++a)
      (a < space.symmetries ? kept[a] : lost[a - space.symmetries]) = J(a, g[1], g[2]) - J(a, g[0], g[1]);
    auto const momentum_terms = size_of(D2(L, g[0], g[1]));
    claim.zero("the flow keeps the momentum map", model, kept, momentum_terms, 100);
    claim.refutes("and momenta outside the symmetry group", model, lost, momentum_terms);

    // The Legendre transformation: spatial momenta, and heights of the image of the fixed vector, are
    // coordinates of T^*M/G; their brackets there are those of the dual algebra, the derivative of a height,
    // 0.
    auto const heights = draw_matrix<S>(draw, 2, m.matrix_size());
    auto const height = [&](int i, auto const& p) {
      using T = typename std::decay_t<decltype(p)>::Scalar;
      T sum(0);
      for (int r = 0; r < m.matrix_size(); ++r) sum += p.value(r, space.fixed) * T(heights(i, r));
      return sum;
    };
    auto const of_momenta = [&](S const& sign) {
      std::vector<Vector<S>> columns;
      for (int a = 0; a < d; ++a)
        columns.push_back(slopes(
            [&](auto const& p, auto const& q) {
              using T = typename std::decay_t<decltype(p)>::Scalar;
              return T(D1(L, p, q).components[a] * T(sign));
            },
            g[0], g[1]));
      for (int i = 0; i < 2; ++i)
        columns.push_back(slopes([&](auto const& p, auto const&) { return height(i, p); }, g[0], g[1]));
      return beside(columns);
    };
    auto const expected = [&](S const& sign) {
      Matrix<S> tensor = Matrix<S>::Zero(d + 2, d + 2);
      tensor.topLeftCorner(d, d) = lie_poisson_tensor_plus(
          Momentum<SpannedGroup, S>{m, Vector<S>(D1(L, g[0], g[1]).components * sign)});
      for (int i = 0; i < 2; ++i) {
        Vector<S> const slope =
            right_differential([&](auto const& p) { return height(i, p); }, g[0]).components;
        tensor.col(d + i).head(d) = -slope, tensor.row(d + i).head(d) = slope.transpose();
      }
      return tensor;
    };
    auto const defect = [&](S const& sign) {
      Matrix<S> const columns = of_momenta(sign);
      return Matrix<S>(columns.transpose() * pi * columns - expected(sign));
    };
    Matrix<S> const columns = of_momenta(S(-1));
    auto const sizes = S(magnitude(columns) * magnitude(pi) * magnitude(columns));
    claim.zero("-D_1 L carries the bracket to that of T*M/G", model, defect(S(-1)), sizes, 100);
    claim.refutes("D_1 L instead", model, defect(S(1)), sizes);
  }
}
