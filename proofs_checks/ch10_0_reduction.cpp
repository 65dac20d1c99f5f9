// Chapter 10: reduction of pairs of a configuration space that is larger than its symmetry group.
#include "actio/linear_algebra/rank.hpp"
#include "actio/reduction/discrete_poisson.hpp"
#include "actio/variational/lie_poisson.hpp"
#include "actio/variational/momentum_map.hpp"

#include "models/pairs.hpp"
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
  return in_one_column(std::vector<Momentum<SpannedGroup, S>>{D1(f, g0, g1), D2(f, g0, g1)});
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

/// A Legendre transformation of reduced pairs, in coordinates of \f$T^*M/G\f$: the momentum, translated to
/// the identity on the right, and heights of the image of the vector that G fixes.
template <class S, class L>
struct ReducedLegendre {
  SymmetricSpace const& space;
  L const& lagrangian;
  Matrix<S> heights;    ///< a row for each
  S sign = S(-1);       ///< of \f$D_1\mathbb L\f$
  bool at_end = false;  ///< \f$D_2\mathbb L\f$ at the end of the step in place of it

  template <class T>
  Momentum<SpannedGroup, T> momentum(GroupElement<T> const& p, GroupElement<T> const& q) const {
    if (at_end) return D2(lagrangian, p, q);
    auto mu = D1(lagrangian, p, q);
    for (Index a = 0; a < mu.components.size(); ++a) mu.components[a] *= T(sign);
    return mu;
  }
  template <class T>
  T height(Index i, GroupElement<T> const& p) const {
    T sum(0);
    for (int r = 0; r < space.m.matrix_size(); ++r) sum += p.value(r, space.fixed) * T(heights(i, r));
    return sum;
  }
  /// The differentials of all coordinates.
  Matrix<S> slopes_at(GroupElement<S> const& g0, GroupElement<S> const& g1) const {
    std::vector<Vector<S>> columns;
    for (int a = 0; a < space.m.dimension(); ++a)
      columns.push_back(
          slopes([&](auto const& p, auto const& q) { return momentum(p, q).components[a]; }, g0, g1));
    for (Index i = 0; i < heights.rows(); ++i)
      columns.push_back(
          slopes([&](auto const& p, auto const& q) { return height(i, at_end ? q : p); }, g0, g1));
    return beside(columns);
  }
  /// The brackets of the coordinates in \f$T^*M/G\f$: momenta have those of the dual algebra, and a momentum
  /// and a height the derivative of the height.
  Matrix<S> tensor_at(GroupElement<S> const& g0, GroupElement<S> const& g1) const {
    return tensor_of(momentum(g0, g1), at_end ? g1 : g0);
  }
  Matrix<S> tensor_of(Momentum<SpannedGroup, S> const& mu, GroupElement<S> const& g) const {
    Index const d = space.m.dimension(), all = d + heights.rows();
    Matrix<S> tensor = Matrix<S>::Zero(all, all);
    tensor.topLeftCorner(d, d) = lie_poisson_tensor_plus(mu);
    for (Index i = 0; i < heights.rows(); ++i) {
      Vector<S> const slope = right_differential([&](auto const& p) { return height(i, p); }, g).components;
      tensor.col(d + i).head(d) = -slope, tensor.row(d + i).head(d) = slope.transpose();
    }
    return tensor;
  }
};

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
    auto const g = draw_points<S>(draw, m, 3, ratio<S>(1, 2));
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
    auto const defect = [&](S const& sign) {
      ReducedLegendre<S, decltype(L)> const map{space, L, heights, sign};
      Matrix<S> const columns = map.slopes_at(g[0], g[1]);
      return Matrix<S>(columns.transpose() * pi * columns - map.tensor_at(g[0], g[1]));
    };
    Matrix<S> const columns = ReducedLegendre<S, decltype(L)>{space, L, heights}.slopes_at(g[0], g[1]);
    auto const sizes = S(magnitude(columns) * magnitude(pi) * magnitude(columns));
    claim.zero("-D_1 L carries the bracket to that of T*M/G", model, defect(S(-1)), sizes, 100);
    claim.refutes("D_1 L instead", model, defect(S(1)), sizes);
  }
}

namespace {

/// A function on the dual of the algebra of G that is constant on its orbits, of the momenta of G: of one
/// dimension the momentum, of three the square of its length, of those of Aff(1), whose orbits are open,
/// none.
template <class T>
T casimir_of(std::vector<T> const& momenta) {
  if (momenta.size() == 1) return momenta[0];
  T sum(0);
  for (T const& mu : momenta) sum += mu * mu;
  return sum;
}

}  // namespace

STATEMENT(claim_10_0_reduced_leaves, "leaves of reduced pairs as images under Legendre transformations") {
  claim.convention(
      "The Legendre transformations are $-D_1\\mathbb L$ and $D_2\\mathbb L$ of an invariant regular "
      "$\\mathbb L$, near the pair; the images are those of their local inverses, and the integrator is "
      "the flow of $\\mathbb L$. Both map the leaf through a pair onto the leaf through its image, in "
      "which the functions of the momentum of $G$ that are constant on coadjoint orbits have one value, "
      "and the flow keeps it. A Poisson map need not: a momentum shifted by a character of the group has "
      "the same brackets and lies in another leaf. The spaces are those of claim_10_0_reduced_pair_space.");
  claim.leaves(
      "A set of one value may have several components: that the flow stays in one of them is not shown, "
      "nor that a leaf as a whole, and not its part near a pair, is an image.");
  for (auto const& space : spaces()) {
    auto const& m = space.m;
    int const d = m.dimension();
    if (numbers_grow() && d > 3) continue;
    auto const model = space.name();
    auto const g = draw_points<S>(draw, m, 3, ratio<S>(1, 2));
    auto const with_height = lift_with_height(draw_vector<S>(draw, m.matrix_size()), space.fixed);
    auto const L = with_height(with_motion_along(draw_group_polynomial<S>(draw, m), g, draw, with_height));
    auto const symmetric = [&](Momentum<SpannedGroup, S> const& mu, GroupElement<S> const& at) {
      std::vector<S> momenta;
      for (int a = 0; a < space.symmetries; ++a)
        momenta.push_back(pair(mu, right_translation(basis_velocity<S>(m, a))(at)));
      return momenta;
    };
    int const dimension = 2 * d - space.symmetries;
    std::vector<Vector<S>> invariants;
    for (int i = 0; i <= dimension; ++i)
      invariants.push_back(slopes(draw_invariant<S>(draw, space), g[0], g[1]));
    Matrix<S> const pi = discrete_bivector(L, g[0], g[1]), forms = beside(invariants);
    Matrix<S> const leaf = pi * forms;  // its tangent vectors
    auto const heights = draw_matrix<S>(draw, m.matrix_size(), m.matrix_size());
    ReducedLegendre<S, decltype(L)> const start{space, L, heights}, end{space, L, heights, S(-1), true},
        wrong{space, L, heights, S(1)};
    auto const leaf_and_image = [&](ReducedLegendre<S, decltype(L)> const& map) {
      Matrix<S> const slope = map.slopes_at(g[0], g[1]), image = slope.transpose() * leaf,
                      tensor = map.tensor_at(g[0], g[1]);
      Matrix<S> both(image.rows(), image.cols() + tensor.cols());
      both << image, tensor;
      return std::array{matrix_rank(slope), matrix_rank(image), matrix_rank(tensor), matrix_rank(both)};
    };
    for (auto const* map : {&start, &end}) {
      std::string const name = map == &start ? "-D_1 L" : "D_2 L";
      auto const [all, image, tensor, both] = leaf_and_image(*map);
      claim.fact(name + " is a local diffeomorphism of reduced pairs", model, all == dimension);
      claim.fact(name + ": the image of the leaf is tangent to the leaf there, and as large", model,
                 image == dimension - space.casimirs && tensor == image && both == image);
    }
    // The bracket at the end of the step: what makes the rest more than a count.
    auto const defect = [&](ReducedLegendre<S, decltype(L)> const& map) {
      Matrix<S> const slope = map.slopes_at(g[0], g[1]);
      return Matrix<S>(slope.transpose() * pi * slope - map.tensor_at(g[0], g[1]));
    };
    Matrix<S> const slope = end.slopes_at(g[0], g[1]);
    auto const sizes = S(magnitude(slope) * magnitude(pi) * magnitude(slope));
    // Condition: omega is inverted, at configurations far apart.
    claim.zero("D_2 L carries the bracket to that of T*M/G", model, defect(end), sizes, 100);
    claim.refutes("D_1 L does", model, defect(wrong), sizes);

    // The function that tells leaves apart, on both ends and after a step.
    if (space.casimirs > 0) {
      auto const value = [&](Momentum<SpannedGroup, S> const& mu, GroupElement<S> const& at) {
        return casimir_of(symmetric(mu, at));
      };
      S const before = value(start.momentum(g[0], g[1]), g[0]), after = value(end.momentum(g[0], g[1]), g[1]),
              next = value(end.momentum(g[1], g[2]), g[2]);
      auto const size_of_momentum = size_of(D2(L, g[0], g[1])) + size_of(D2(L, g[1], g[2]));
      S const terms = space.symmetries == 1 ? S(size_of_momentum) : S(size_of_momentum * size_of_momentum);
      claim.zero("one value at the images of a pair", model, S(before - after), terms, 100);
      claim.zero("and one step later", model, S(next - after), terms, 100);
      auto const other = ReducedLegendre<S, decltype(L)>{space, L, heights, S(1)}.momentum(g[0], g[1]);
      if (space.symmetries == 1)
        claim.refutes("the image under D_1 L", model, S(value(other, g[0]) - after), terms);
      // Of the functions of the momentum it is one of reduced pairs, and it commutes with the others there.
      auto const of_momenta = [&](auto const& function) {
        return [&, function](auto const& p, auto const& q) {
          using T = typename std::decay_t<decltype(p)>::Scalar;
          std::vector<T> momenta;
          for (int a = 0; a < space.symmetries; ++a)
            momenta.push_back(discrete_momentum(L, p, q, right_translation(basis_velocity<T>(m, a))));
          return function(momenta);
        };
      };
      auto const weighed = of_momenta([](auto const& momenta) {
        auto sum = momenta[0] * momenta[0];
        for (std::size_t a = 1; a < momenta.size(); ++a) sum += momenta[a] * momenta[a] * (a + 1);
        return sum;
      });
      auto const constant = of_momenta([](auto const& momenta) { return casimir_of(momenta); });
      auto const k = space.draw_symmetry<S>(draw);
      auto const change = [&](auto const& f) { return S(f(g[0] * k, g[1] * k) - f(g[0], g[1])); };
      claim.zero("it is a function of reduced pairs", model, change(constant), terms, 100);
      if (space.symmetries == 3)
        claim.refutes("a square that is not constant on orbits is one", model, change(weighed), terms);
      Vector<S> const slope_of_value = slopes(constant, g[0], g[1]);
      auto const moved = S(magnitude(forms) * magnitude(pi) * magnitude(slope_of_value));
      claim.zero("its brackets with invariant functions", model, Vector<S>(leaf.transpose() * slope_of_value),
                 moved, 100);
      claim.refutes("those of any invariant function", model, Vector<S>(leaf.transpose() * invariants[0]),
                    S(magnitude(forms) * magnitude(pi) * magnitude(invariants[0])));
      claim.refutes("it is the same on all of the reduced space", model, slope_of_value,
                    S(size_of(D2(L, g[0], g[1]))));
    }
  }
  // A map of phase space that keeps the brackets and leaves the leaf: the momentum shifted by a character.
  {
    auto const& space = spaces()[1];
    auto const g = draw_points<S>(draw, space.m, 2, ratio<S>(1, 2));
    auto const L = lift_right(draw_group_polynomial<S>(draw, space.m));
    ReducedLegendre<S, decltype(L)> const map{space, L, draw_matrix<S>(draw, 2, space.m.matrix_size())};
    auto const mu = map.momentum(g[0], g[1]);
    auto const shifted_along = [&](int a) {
      auto shifted = mu;
      shifted.components[a] += S(2) + draw.template number<S>();
      return shifted;
    };
    auto const J = [&](Momentum<SpannedGroup, S> const& of) {
      return pair(of, right_translation(basis_velocity<S>(space.m, 0))(g[0]));
    };
    auto const by_character = shifted_along(0);
    Matrix<S> const tensor = map.tensor_of(mu, g[0]);
    claim.equal("brackets after a shift of the momentum by a character", space.name(),
                map.tensor_of(by_character, g[0]), tensor);
    claim.refutes("the momentum of G after that shift", space.name(), S(J(by_character) - J(mu)),
                  size_of(by_character));
    claim.differs("brackets after a shift along another covector", space.name(),
                  map.tensor_of(shifted_along(1), g[0]), tensor);
  }
}
