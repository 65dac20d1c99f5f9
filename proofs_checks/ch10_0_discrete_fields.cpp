// Chapter 10: discretisation of fields in space and time by the variational principle. Discrete fields on the
// nodes of a lattice, a function of the corner values for each cell, and their sum as the action.
#include "actio/jets/field_equations.hpp"

#include "fields.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// A block of cubic cells of a lattice in d dimensions of space-time, as many along each axis; the first axis
/// is time. Bit i of the number of a corner tells which end of axis i it is at.
template <int d>
struct Block {
  static constexpr int corners = 1 << d;
  int along;  ///< cells along an axis

  int nodes() const { return power(along + 1); }
  int cells() const { return power(along); }
  int node(int cell, int corner) const {
    int number = 0, stride = 1;
    for (int i = 0; i < d; ++i, cell /= along, stride *= along + 1)
      number += stride * (cell % along + (corner >> i & 1));
    return number;
  }
  int level(int node) const { return node % (along + 1); }  ///< in time
  int slab(int cell) const { return cell % along; }
  /// Where a node is, in numbers of cells.
  int place(int node, int axis) const {
    for (; axis > 0; --axis) node /= along + 1;
    return node % (along + 1);
  }

 private:
  static int power(int base) {
    int result = 1;
    for (int i = 0; i < d; ++i) result *= base;
    return result;
  }
};

/// Values at the corners of a cell, one after the other.
template <class T, int d, int N>
using Corners = Matrix<T, N << d, 1>;
/// Values at all nodes.
template <class T, int N>
using Nodes = std::vector<Matrix<T, N, 1>>;

// Lagrangians of a cell. Each can be changed so that the force on one corner goes down by a given amount, and
// no other force but those on corners at the other end of time.

/// Any function of the corner values: a cubic.
template <class S, int d, int N>
struct AnyCell {
  static constexpr bool invariant = false;
  Cubic<S, (N << d)> l;
  template <class V>
  auto operator()(V const& y) const { return l(y); }
  void balance(int corner, Corners<S, d, N> const&, Matrix<S, N, 1> const& force) {
    l.a.template segment<N>(N * corner) -= force;
  }
  static AnyCell drawn(Draw& draw) { return {draw_cubic<S, (N << d)>(draw, ratio<S>(1, 2))}; }
};

/// A function that is invariant under the rigid motions of space: a cubic in the squares of all distances.
template <class S, int d, int N>
struct RigidlyInvariantCell {
  static_assert(N <= d);
  static constexpr bool invariant = true;
  static constexpr int corners = 1 << d, pairs = corners * (corners - 1) / 2;
  Cubic<S, pairs> l;

  static int pair(int a, int b) { return a > b ? a * (a - 1) / 2 + b : b * (b - 1) / 2 + a; }
  template <class V>
  auto operator()(V const& y) const {
    using T = ScalarOf<V>;
    Matrix<T, pairs, 1> squares;
    for (int a = 1; a < corners; ++a)
      for (int b = 0; b < a; ++b) {
        T sum(0);
        for (int i = 0; i < N; ++i) {
          T const gap = y[N * a + i] - y[N * b + i];
          sum += gap * gap;
        }
        squares[pair(a, b)] = sum;
      }
    return l(squares);
  }
  /// By springs to N corners at the other end of time.
  void balance(int corner, Corners<S, d, N> const& y, Matrix<S, N, 1> const& force) {
    auto const other = [corner](int i) { return corner ^ 1 ^ (i == 0 ? 0 : 1 << i); };
    Matrix<S, N, N> pulls;
    for (int i = 0; i < N; ++i)
      pulls.col(i) = (y.template segment<N>(N * corner) - y.template segment<N>(N * other(i))) * S(2);
    auto const stiffness = solve_linear(pulls, force, "balance");
    for (int i = 0; i < N; ++i) l.a[pair(corner, other(i))] -= stiffness[i];
  }
  static RigidlyInvariantCell drawn(Draw& draw) { return {draw_cubic<S, pairs>(draw, ratio<S>(1, 8))}; }
};

/// A cell of a mesh that moves: nodes carry their time, their label and the place of the body there. The
/// Lagrangian is a density of the slopes at the middle times the area of the cell; shifts of time, of labels
/// and of space leave it as it is.
template <class S, int d, int N>
struct MovingCell {
  static_assert(d == 2 && N == 3);
  static constexpr bool invariant = true;
  Cubic<S, 2> density;
  Corners<S, 2, 3> pull;  ///< forces that add up to zero

  template <class V>
  auto operator()(V const& y) const {
    using T = ScalarOf<V>;
    // Twice the differences of (t, x, y) along the two axes.
    Matrix<T, 3, 2> D = Matrix<T, 3, 2>::Zero();
    T sum(0);
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < 3; ++i) {
        for (int axis = 0; axis < 2; ++axis)
          if (k >> axis & 1)
            D(i, axis) += y[3 * k + i];
          else
            D(i, axis) -= y[3 * k + i];
        sum += y[3 * k + i] * T(pull[3 * k + i]);
      }
    T const area = D(0, 0) * D(1, 1) - D(0, 1) * D(1, 0);
    Matrix<T, 2, 1> slopes;
    slopes[0] = (D(2, 0) * D(1, 1) - D(2, 1) * D(1, 0)) / area;
    slopes[1] = (D(2, 1) * D(0, 0) - D(2, 0) * D(0, 1)) / area;
    return T(area * density(slopes) / T(4) + sum);
  }
  void balance(int corner, Corners<S, 2, 3> const&, Matrix<S, 3, 1> const& force) {
    pull.template segment<3>(3 * corner) -= force;
    pull.template segment<3>(3 * (corner ^ 1)) += force;
  }
  static MovingCell drawn(Draw& draw) { return {draw_cubic<S, 2>(draw), Corners<S, 2, 3>::Zero()}; }
};

/// A discrete field with a Lagrangian of its own in each cell.
template <class S, int d, int N, template <class, int, int> class Cell>
struct DiscreteField {
  static constexpr int corners = 1 << d;
  Block<d> block;
  std::vector<Cell<S, d, N>> cells;
  Nodes<S, N> field;
  S friction = S(0);  ///< at both ends of the edges along time: no variational principle has that
  std::vector<int> all;

  /// Places that are those of the lattice and something else.
  DiscreteField(Draw& draw, int along) : block{along} {
    for (int c = 0; c < block.cells(); ++c) cells.push_back(Cell<S, d, N>::drawn(draw)), all.push_back(c);
    for (int p = 0; p < block.nodes(); ++p) {
      Matrix<S, N, 1> y = draw.vector<S, Matrix<S, N, 1>>(N) * ratio<S>(1, 4);
      for (int i = 0; i < N && i < d; ++i) y[i] += S(block.place(p, i));
      field.push_back(y);
    }
  }
  /// The discrete field equations are for these: all but the first and the last in time. At the walls they
  /// say that nothing pulls.
  bool moves(int node) const { return block.level(node) > 0 && block.level(node) < block.along; }

  template <class T>
  Corners<T, d, N> at_corners(int cell, Nodes<T, N> const& y) const {
    Corners<T, d, N> values;
    for (int k = 0; k < corners; ++k) values.template segment<N>(N * k) = y[block.node(cell, k)];
    return values;
  }
  /// The derivatives of a cell's Lagrangian by its corners, and what friction adds to them.
  template <class T>
  Corners<T, d, N> forces(int cell, Nodes<T, N> const& y) const {
    auto const values = at_corners(cell, y);
    Corners<T, d, N> force = derivative(cells[cell], values).gradient();
    for (int i = 0; i < force.size(); ++i) {
      int const k = i / N;
      force[i] += (values[N * (k | 1) + i % N] - values[N * (k & ~1) + i % N]) * T(friction);
    }
    return force;
  }
  /// The forces of the cells of a patch on each node: zero on those in it where the field equations hold.
  template <class T>
  Nodes<T, N> on_nodes(std::vector<int> const& patch, Nodes<T, N> const& y) const {
    Nodes<T, N> sums(block.nodes(), Matrix<T, N, 1>::Zero());
    for (int cell : patch) {
      auto const force = forces(cell, y);
      for (int k = 0; k < corners; ++k) sums[block.node(cell, k)] += force.template segment<N>(N * k);
    }
    return sums;
  }
  /// How they change along a variation.
  Nodes<S, N> rates(std::vector<int> const& patch, Nodes<S, N> const& V) const {
    Nodes<Dual<S>, N> moved;
    for (int p = 0; p < block.nodes(); ++p) moved.push_back(moved_along(field[p], V[p]));
    Nodes<S, N> rate;
    for (auto const& sum : on_nodes(patch, moved)) rate.push_back(rate_of(sum));
    return rate;
  }

  /// Changes the Lagrangians so that the field solves: those of the first cells in time for the nodes of the
  /// first level, those of the last for the others.
  void solve() {
    auto const excess = on_nodes(all, field);
    for (int p = 0; p < block.nodes(); ++p) {
      if (!moves(p)) continue;
      int const slab = block.level(p) == 1 ? 0 : block.along - 1;
      for (int cell = 0, done = 0; cell < block.cells() && !done; ++cell)
        for (int k = 0; k < corners && !done; ++k)
          if (block.slab(cell) == slab && block.node(cell, k) == p)
            cells[cell].balance(k, at_corners(cell, field), excess[p]), done = 1;
    }
  }
  Nodes<S, N> draw_variation(Draw& draw) const {
    Nodes<S, N> V;
    for (int p = 0; p < block.nodes(); ++p) V.push_back(draw.vector<S, Matrix<S, N, 1>>(N));
    return V;
  }
  /// Two first variations with random values at the first and the last time: the linearised equations solved
  /// for all others.
  std::array<Nodes<S, N>, 2> first_variations(Draw& draw) const {
    std::vector<int> inside;
    for (int p = 0; p < block.nodes(); ++p)
      if (moves(p)) inside.push_back(p);
    int const unknowns = N * static_cast<int>(inside.size());
    auto const residual = [&](Nodes<S, N> const& V) {
      auto const rate = rates(all, V);
      Matrix<S, Dynamic, 1> column(unknowns);
      for (int i = 0; i < unknowns; ++i) column[i] = rate[inside[i / N]][i % N];
      return column;
    };
    Matrix<S, Dynamic, Dynamic> slope(unknowns, unknowns), right(unknowns, 2);
    Nodes<S, N> const none(block.nodes(), Matrix<S, N, 1>::Zero());
    for (int i = 0; i < unknowns; ++i) {
      auto unit = none;
      unit[inside[i / N]][i % N] = S(1);
      slope.col(i) = residual(unit);
    }
    std::array<Nodes<S, N>, 2> V{draw_variation(draw), draw_variation(draw)};
    for (int k = 0; k < 2; ++k) {
      for (int p : inside) V[k][p].setZero();
      right.col(k) = -residual(V[k]);
    }
    auto const inner = solve_linear(slope, right, "first_variations");
    for (int k = 0; k < 2; ++k)
      for (int i = 0; i < unknowns; ++i) V[k][inside[i / N]][i % N] = inner(i, k);
    return V;
  }

  /// A set of cells, by chance, with the first one in it; and the nodes of a patch that are not inside it.
  std::vector<int> draw_patch(Draw& draw) const {
    std::vector<int> patch = {0};
    for (int c = 1; c < block.cells(); ++c)
      if (draw.below(4) > 0) patch.push_back(c);
    return patch;
  }
  std::vector<bool> boundary(std::vector<int> const& patch) const {
    std::vector<int> around(block.nodes(), 0);
    for (int cell : patch)
      for (int k = 0; k < corners; ++k) ++around[block.node(cell, k)];
    std::vector<bool> at;
    for (int p = 0; p < block.nodes(); ++p) at.push_back(around[p] > 0 && around[p] < corners);
    return at;
  }
};

/// A sum of products, and of their sizes.
template <class S>
struct Sum {
  S value = S(0), size = S(0);
  void add(S const& term) { value += term, size += magnitude(term); }
};

/// The discrete multisymplectic form of the cells of a patch on two variations, summed over its nodes on the
/// boundary, or inside.
template <class Motion, class Variations>
auto form_of(Motion const& motion, std::vector<int> const& patch, Variations const& V,
             bool on_boundary = true) {
  using S = std::remove_cvref_t<decltype(V[0][0][0])>;
  auto const by_V = motion.rates(patch, V[0]), by_W = motion.rates(patch, V[1]);
  auto const at = motion.boundary(patch);
  Sum<S> sum;
  for (std::size_t p = 0; p < at.size(); ++p)
    if (at[p] == on_boundary) sum.add(by_V[p].dot(V[1][p])), sum.add(-by_W[p].dot(V[0][p]));
  return sum;
}
/// What the cells of one slab of time make at their later corners: the form, or the momentum map.
template <class S, int d, int N, template <class, int, int> class Cell, class Term>
Sum<S> after_slab(DiscreteField<S, d, N, Cell> const& motion, int slab, Term const& term) {
  std::vector<int> cells;
  for (int c : motion.all)
    if (motion.block.slab(c) == slab) cells.push_back(c);
  auto const at_node = term(cells);
  Sum<S> sum;
  for (int p = 0; p < motion.block.nodes(); ++p)
    if (motion.block.level(p) == slab + 1) at_node(p, sum);
  return sum;
}
template <class S, int d, int N, template <class, int, int> class Cell>
Sum<S> form_after(DiscreteField<S, d, N, Cell> const& motion, int slab, std::array<Nodes<S, N>, 2> const& V) {
  return after_slab(motion, slab, [&](std::vector<int> const& cells) {
    return [&, by_V = motion.rates(cells, V[0]), by_W = motion.rates(cells, V[1])](int p, Sum<S>& sum) {
      sum.add(by_V[p].dot(V[1][p])), sum.add(-by_W[p].dot(V[0][p]));
    };
  });
}
template <class S, int d, int N, template <class, int, int> class Cell, class Xi>
Sum<S> momentum_after(DiscreteField<S, d, N, Cell> const& motion, int slab, Xi const& xi) {
  return after_slab(motion, slab, [&](std::vector<int> const& cells) {
    return [&, force = motion.on_nodes(cells, motion.field)](int p, Sum<S>& sum) {
      sum.add(force[p].dot(xi(motion.field[p])));
    };
  });
}
/// The values of the discrete momentum map of the cells of a patch, summed over the nodes of its boundary.
template <class S, int d, int N, template <class, int, int> class Cell, class Xi>
Sum<S> momenta_on_boundary(DiscreteField<S, d, N, Cell> const& motion, std::vector<int> const& patch,
                           Xi const& xi) {
  auto const force = motion.on_nodes(patch, motion.field);
  auto const at = motion.boundary(patch);
  Sum<S> sum;
  for (int p = 0; p < motion.block.nodes(); ++p)
    if (at[p]) sum.add(S(force[p].dot(xi(motion.field[p]))));
  return sum;
}

/// The field \f$Ay + b\f$ with a skew A.
template <class S, int N>
struct RigidField {
  Matrix<S, N, N> A;
  Matrix<S, N, 1> b;
  Matrix<S, N, 1> operator()(Matrix<S, N, 1> const& y) const { return A * y + b; }
};
template <class S, int N>
RigidField<S, N> draw_rigid_field(Draw& draw, bool turning = true) {
  RigidField<S, N> xi{Matrix<S, N, N>::Zero(), draw.vector<S, Matrix<S, N, 1>>(N)};
  for (int i = 0; turning && i < N; ++i)
    for (int k = 0; k < i; ++k) xi.A(i, k) = draw.number<S>(), xi.A(k, i) = -xi.A(i, k);
  return xi;
}

/// The field equations at the origin of the discretisation with squares of side h of a density, along a
/// section, over h^2; by the values at the middle of the cells, or by those at their first corner.
template <class S, class L, class Phi>
Matrix<S, 2, 1> discrete_equations(L const& density, Phi const& phi, S const& h, bool middle) {
  Matrix<S, 2, 1> sum = Matrix<S, 2, 1>::Zero();
  for (int corner = 0; corner < 4; ++corner) {
    // The cell in which the origin is this corner.
    Event<S, 1> const low((corner & 1 ? S(-h) : S(0)), (corner & 2 ? S(-h) : S(0)));
    auto const of_corner = [&]<class T>(Matrix<T, 2, 1> const& here) -> T {
      Jet<T, 1, 2> j{(low + Event<S, 1>::Constant(middle ? S(h / S(2)) : S(0))).template cast<T>(), {}, {}};
      j.y.setZero(), j.v.setZero();
      for (int k = 0; k < 4; ++k) {
        Event<S, 1> const at = low + Event<S, 1>(k & 1 ? h : S(0), k & 2 ? h : S(0));
        Matrix<T, 2, 1> const y = k == corner ? here : Matrix<T, 2, 1>(phi(at).template cast<T>());
        if (middle || k == 0) j.y += y * T(middle ? ratio<S>(1, 4) : S(1));
        for (int mu = 0; mu < 2; ++mu) j.v.col(mu) += y * T(S(k >> mu & 1 ? 1 : -1) / (h * S(2)));
      }
      return density(j);
    };
    sum += derivative(of_corner, Matrix<S, 2, 1>(phi(Event<S, 1>(Event<S, 1>::Zero())))).gradient();
  }
  return sum;
}

}  // namespace

STATEMENT(claim_10_0_variational_discretisation,
          "space-time variational discretisation: discrete form and momentum maps") {
  claim.holds(
      "On lattices of squares and of cubes, with any Lagrangian of the corner values in each cell: the "
      "discrete "
      "multisymplectic form formula on any set of cells, the form preserved from time to time, and the "
      "momentum maps "
      "of the symmetries that the discrete Lagrangian has: rigid motions, and on a mesh that moves shifts of "
      "time, "
      "labels and space. Values at the middle of a cell give the field equations of any density to second "
      "order.");
  auto const forms = [&](auto motion, std::string const& model) {
    motion.solve();
    auto const V = motion.first_variations(draw);
    auto const patch = motion.draw_patch(draw);
    auto const sum = form_of(motion, patch, V), whole = form_of(motion, motion.all, V);
    // First variations come out of an elimination with up to 16 unknowns.
    claim.zero("form formula on a set of cells", model, sum.value, sum.size, 1000);
    claim.zero("form formula on the whole block", model, whole.value, whole.size, 1000);
    auto const before = form_after(motion, 0, V), after = form_after(motion, motion.block.along - 1, V);
    claim.zero("the form after the first and the last step of time", model, S(before.value - after.value),
               S(before.size + after.size), 1000);
    std::array const any{motion.draw_variation(draw), motion.draw_variation(draw)};
    auto const outside = form_of(motion, motion.all, any), inside = form_of(motion, motion.all, any, false);
    claim.zero("any two variations: what is at the boundary comes from inside", model,
               decltype(outside.value)(outside.value + inside.value), outside.size);
    claim.refutes("variations that solve nothing", model, outside.value, outside.size);
    motion.friction = S(1);
    auto const damped = motion.first_variations(draw);
    auto const lost = form_of(motion, motion.all, damped);
    claim.refutes("a scheme with friction, which is not variational", model, lost.value, lost.size);
  };
  forms(DiscreteField<S, 2, 2, AnyCell>(draw, 3), "3 x 3 squares, values in the plane");
  forms(DiscreteField<S, 3, 1, AnyCell>(draw, 2), "2 x 2 x 2 cubes, values on a line");
  forms(DiscreteField<S, 2, 3, MovingCell>(draw, 2), "2 x 2 cells of a mesh that moves");

  auto const momenta = [&](auto motion, auto const& xi, std::string const& model) {
    auto const gained = [&] {
      auto const before = momentum_after(motion, 0, xi),
                 after = momentum_after(motion, motion.block.along - 1, xi);
      return Sum<S>{S(after.value - before.value), S(after.size + before.size)};
    };
    auto const off = gained();
    claim.refutes("momentum of a field that solves nothing", model, off.value, off.size);
    motion.solve();
    auto const on = gained();
    // The field solves by an elimination.
    claim.zero("momentum after the first and the last step of time", model, on.value, on.size, 100);
    motion.friction = S(1);
    auto const rubbed = gained();
    claim.refutes("momentum with friction", model, rubbed.value, rubbed.size);
  };
  momenta(DiscreteField<S, 2, 2, RigidlyInvariantCell>(draw, 3), draw_rigid_field<S, 2>(draw),
          "3 x 3 squares, motions of the plane");
  momenta(DiscreteField<S, 3, 3, RigidlyInvariantCell>(draw, 2), draw_rigid_field<S, 3>(draw),
          "2 x 2 x 2 cubes, motions of space");
  momenta(DiscreteField<S, 2, 3, MovingCell>(draw, 3), draw_rigid_field<S, 3>(draw, false),
          "3 x 3 cells of a mesh that moves, shifts");

  if (claim.fits_orders()) {
    auto const L = draw_density<S, 1, 2>(draw);
    auto const phi = draw_section<S, 1, 2>(draw);
    auto const E = euler_lagrange(L, second_jet(phi, Event<S, 1>(Event<S, 1>::Zero())));
    std::vector<double> steps, middle, corner;
    for (int k = 3; k <= 8; ++k) {
      S const h = ratio<S>(1, 1 << k);
      steps.push_back(to_double(h));
      middle.push_back(to_double(size_of((discrete_equations(L, phi, h, true) - E).eval())));
      corner.push_back(to_double(size_of((discrete_equations(L, phi, h, false) - E).eval())));
    }
    claim.order("discrete field equations against those of the density", "n = 1, N = 2", steps, middle, 2);
    claim.refutes_order("places at a corner of the cell in place of its middle", "n = 1, N = 2", steps,
                        corner, 2);
  }
}

STATEMENT(claim_10_0_discrete_noether_sum, "integral discrete Noether theorem over a set of nodes") {
  claim.holds(
      "The set of nodes is the boundary of any set of cells; the sum is that of the momenta of its cells. "
      "Shown for "
      "rigid motions of the plane and of space, on squares and cubes, and for shifts of time, labels and "
      "space on a "
      "mesh that moves.");
  auto const sums = [&](auto motion, auto const& xi, std::string const& model) {
    auto const off = momenta_on_boundary(motion, motion.all, xi);
    claim.refutes("along a field that solves nothing", model, off.value, off.size);
    motion.solve();
    auto const patch = motion.draw_patch(draw);
    auto const some = momenta_on_boundary(motion, patch, xi),
               whole = momenta_on_boundary(motion, motion.all, xi);
    claim.zero("boundary of a set of cells", model, some.value, some.size, 100);
    claim.zero("boundary of the whole block", model, whole.value, whole.size, 100);
    // One cell: invariance alone, off shell and on.
    auto const cell = momenta_on_boundary(motion, {0}, xi);
    claim.zero("the corners of one cell", model, cell.value, cell.size, 100);
    auto const dilation = [](auto const& y) { return y; };
    auto const stretched = momenta_on_boundary(motion, motion.all, dilation);
    claim.refutes("dilations, which are no symmetry", model, stretched.value, stretched.size);
    motion.friction = S(1);
    auto const rubbed = momenta_on_boundary(motion, motion.all, xi);
    claim.refutes("with friction", model, rubbed.value, rubbed.size);
  };
  sums(DiscreteField<S, 2, 2, RigidlyInvariantCell>(draw, 3), draw_rigid_field<S, 2>(draw),
       "3 x 3 squares, motions of the plane");
  sums(DiscreteField<S, 3, 3, RigidlyInvariantCell>(draw, 2), draw_rigid_field<S, 3>(draw),
       "2 x 2 x 2 cubes, motions of space");
  sums(DiscreteField<S, 2, 3, MovingCell>(draw, 3), draw_rigid_field<S, 3>(draw, false),
       "3 x 3 cells of a mesh that moves, shifts");
  // A Lagrangian without the symmetry, and a field that solves its equations.
  DiscreteField<S, 2, 2, AnyCell> other(draw, 3);
  other.solve();
  auto const sum = momenta_on_boundary(other, other.all, draw_rigid_field<S, 2>(draw));
  claim.refutes("along a solution, with a Lagrangian that is not invariant", "3 x 3 squares", sum.value,
                sum.size);
}
