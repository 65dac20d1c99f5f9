// Between chapters 7 and 8 and the meshes of chapter 10: the discrete Hamilton principle of an augmented
// density, with a multiplier for each cell and level.
//
// Areas, volumes and their slopes are written out anew here: products of diagonals, lengths of edges,
// Simpson's rule.
#include "actio/constraints/directors.hpp"
#include "actio/constraints/inextensible.hpp"
#include "actio/constraints_on_meshes/cell_volumes.hpp"
#include "actio/incompressible/incompressible_density.hpp"
#include "fields/held_fields.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::media;
using namespace actio::checks;

namespace {

VolumeConstraint const plane{Euclidean<2>{}, Euclidean<2>{}};

/// A constraint of the most general kind without a velocity: two cubics in the point of the body, the value
/// and the slopes.
template <class S, int n, int N>
struct AnyConstraint {
  static constexpr int components = 2, arguments = n + N + N * n;
  std::array<Cubic<S, arguments>, 2> phi;
  template <class T>
  Matrix<T, 2, 1> operator()(Jet<T, n, N> const& j) const {
    Matrix<T, arguments, 1> all;
    all.template head<n>() = j.particle();
    all.template segment<N>(n) = j.y;
    for (int i = 0; i < n; ++i) all.template segment<N>(n + N + N * i) = j.v.col(i + 1);
    return Matrix<T, 2, 1>(phi[0](all), phi[1](all));
  }
};
template <class S, int n, int N>
AnyConstraint<S, n, N> draw_constraint(Draw& draw) {
  constexpr int arguments = AnyConstraint<S, n, N>::arguments;
  auto const first = draw_cubic<S, arguments>(draw);
  return {{first, draw_cubic<S, arguments>(draw)}};
}

/// The area of a quadrilateral, half the product of its diagonals, and its derivative by a corner: half the
/// other diagonal, turned. Corners are numbered by the bits of their place in the cell.
template <class S>
struct Quadrilateral {
  Matrix<S, 2, 4> y;
  static constexpr std::array<int, 4> around{0, 1, 3, 2}, place{0, 1, 3, 2};
  Matrix<S, 2, 1> corner(int i) const { return y.col(around[(i + 4) % 4]); }
  S area() const {
    Matrix<S, 2, 1> const d = corner(2) - corner(0), e = corner(3) - corner(1);
    return (d[0] * e[1] - d[1] * e[0]) / S(2);
  }
  Matrix<S, 2, 1> slope(int b) const {
    Matrix<S, 2, 1> const d = corner(place[b] + 1) - corner(place[b] - 1);
    return Matrix<S, 2, 1>(S(d[1] / S(2)), S(-d[0] / S(2)));
  }
};
/// What the area of a cell is more than that of the body, and its slopes.
template <class S>
struct AreaByDiagonals {
  static Matrix<S, 1, 1> value(SpaceTimeCell<S, 2, 2> const& cell, int level) {
    return Matrix<S, 1, 1>(S(Quadrilateral<S>{cell.y.template middleCols<4>(4 * level)}.area() -
                             Quadrilateral<S>{cell.geometry->places}.area()));
  }
  static Matrix<S, 1, 2> slope(SpaceTimeCell<S, 2, 2> const& cell, int level, int b) {
    return Quadrilateral<S>{cell.y.template middleCols<4>(4 * level)}.slope(b).transpose();
  }
};
/// What the square of an edge of a string of the length a is short of a^2, over 2a, and its slopes.
template <class S>
struct EdgeOfString {
  static Matrix<S, 3, 1> edge(SpaceTimeCell<S, 1, 3> const& cell, int level) {
    return cell.y.col(2 * level + 1) - cell.y.col(2 * level);
  }
  static S length(SpaceTimeCell<S, 1, 3> const& cell) {
    return cell.geometry->places(0, 1) - cell.geometry->places(0, 0);
  }
  static Matrix<S, 1, 1> value(SpaceTimeCell<S, 1, 3> const& cell, int level) {
    auto const e = edge(cell, level);
    S const a = length(cell);
    return Matrix<S, 1, 1>(S((a * a - e.dot(e)) / (a * S(2))));
  }
  static Matrix<S, 1, 3> slope(SpaceTimeCell<S, 1, 3> const& cell, int level, int b) {
    return Matrix<S, 1, 3>(edge(cell, level).transpose() * (S(b == 0 ? 1 : -1) / length(cell)));
  }
};
/// The same by the functions of the library, for constraints that have no closed form here.
template <class S, int n, int N, class Phi>
struct ByCorners {
  Phi phi;
  auto value(SpaceTimeCell<S, n, N> const& cell, int level) const {
    return constraint_of_cell(phi, cell, level);
  }
  auto slope(SpaceTimeCell<S, n, N> const& cell, int level, int b) const {
    return constraint_slope(phi, cell, level, b);
  }
};

/// The derivative of the discrete extended action by the value at a node, or by a multiplier, moved alone.
template <class S, class Field>
auto slope_of_action(Field const& field, int level, Index where, bool of_value) {
  using Section = typename Field::Section;
  constexpr int N = std::remove_cvref_t<decltype(field.section.phi(0, 0))>::RowsAtCompileTime;
  int const rows = of_value ? N : Field::k;
  Matrix<S, Dynamic, 1> rates(rows);
  for (int a = 0; a < rows; ++a) {
    Section unit = field.zero();
    (of_value ? unit.phi(level, where)[a] : unit.lambda[level][where][a]) = S(1);
    rates[a] = rate_of(discrete_action(field.density, field.mesh, varied(field.section, unit)));
  }
  return rates;
}

/// The volume of a cell with these corners, the integral of the Jacobian of the trilinear map by Simpson's
/// rule, which is exact for cubics in each coordinate.
template <class S>
S trilinear_volume(Matrix<S, 3, 8> const& y) {
  S sum(0);
  for (int point = 0; point < 27; ++point) {
    std::array<int, 3> const at{point % 3, point / 3 % 3, point / 9};
    S weight = ratio<S>(1, 216);
    for (int i = 0; i < 3; ++i) weight *= S(at[i] == 1 ? 4 : 1);
    Matrix<S, 3, 3> D = Matrix<S, 3, 3>::Zero();
    for (int b = 0; b < 8; ++b)
      for (int i = 0; i < 3; ++i) {
        S hat(b >> i & 1 ? 1 : -1);
        for (int j = 0; j < 3; ++j)
          if (j != i) hat *= (b >> j & 1 ? S(at[j]) : S(2 - at[j])) / S(2);
        for (int a = 0; a < 3; ++a) D(a, i) += y(a, b) * hat;
      }
    sum += determinant(D) * weight;
  }
  return sum;
}

/// The sum of a quantity of cells, before and after the inner nodes of a block of three cells in each
/// direction have moved.
template <int n, class S, class Quantity>
std::array<S, 2> sums_over_block(Draw& draw, Quantity const& quantity) {
  GridIndex<n> cells;
  cells.fill(3);
  Matrix<S, n, 1> const low = Matrix<S, n, 1>::Zero(), high = Matrix<S, n, 1>::Constant(S(3));
  SpaceTimeMesh<S, n> const mesh({S(0), S(1)}, cells, all_sides<n>(Side::fixed),
                                 StraightBox<S, n>{low, high});
  DiscreteSection<S, n, n> y;
  y.levels.resize(2);
  for (Index i = 0; i < mesh.node_count(); ++i) {
    y.levels[0].push_back(mesh.place(i));
    Matrix<S, n, 1> moved = mesh.place(i);
    if (!mesh.fixed(i)) moved += draw.vector<S, Matrix<S, n, 1>>(n) * ratio<S>(1, 2);
    y.levels[1].push_back(moved);
  }
  std::array<S, 2> sums{S(0), S(0)};
  mesh.for_cells([&](GridIndex<n> const& cell) {
    for (int level = 0; level < 2; ++level) sums[level] += quantity(cell_of(mesh, y, 0, cell), level);
  });
  return sums;
}

template <class S, int N>
RigidMotion<S, N> draw_motion(Draw& draw) {
  RigidMotion<S, N> xi{Matrix<S, N, N>::Zero(), draw.vector<S, Matrix<S, N, 1>>(N)};
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < i; ++j) xi.turn(i, j) = draw.number<S>(), xi.turn(j, i) = -xi.turn(i, j);
  return xi;
}

}  // namespace

STATEMENT(bridge_multiplier_equations,
          "the discrete Hamilton principle with a multiplier for each cell and level") {
  claim.holds(
      "For any density of first jets and any constraint without velocities, on curved cells and steps of "
      "different length: the derivative of the discrete action of the augmented density by a value is the "
      "field equation with the forces of the multipliers, and by a multiplier the constraint of its cell at "
      "its level. In the plane that is the area of a quadrilateral. In space the corners do not sum up to "
      "the volume: with closed walls their constraints contradict each other.");
  auto const varies = [&]<class Field>(Field const& field, auto const& by_hand, std::string const& model) {
    constexpr int N = std::remove_cvref_t<decltype(field.section.phi(0, 0))>::RowsAtCompileTime;
    auto const& y = field.section;
    Index const node = static_cast<Index>(draw.below(static_cast<std::uint64_t>(field.mesh.node_count())));
    auto const free = discrete_euler_lagrange(field.density.density, field.mesh, y.phi, 1, node);
    auto const forces = [&](int slope_level, int multiplier_level) {
      Matrix<S, N, 1> force = Matrix<S, N, 1>::Zero();
      field.mesh.for_cells_at(node, [&](auto const& cell, int b) {
        auto const slope = by_hand.slope(cell_of(field.mesh, y.phi, slope_level - 1, cell), 1, b);
        force += slope.transpose() * y.lambda[multiplier_level][field.mesh.number(cell)] * field.half(1);
      });
      return force;
    };
    S action(0), terms(0);
    for (int slab = 0; slab < field.slabs(); ++slab)
      field.mesh.for_cells([&](auto const& cell) {
        auto const part = discrete_lagrangian(field.density, cell_of(field.mesh, y, slab, cell));
        action += part, terms += magnitude(part);
      });
    claim.zero("the action: that of the augmented density on the extended bundle", model,
               S(discrete_action(field.density, field.mesh, y) - action), S(terms + S(1)), 10);
    Matrix<S, N, 1> const by_value = slope_of_action<S>(field, 1, node, true);
    Matrix<S, N, 1> const left = free.sum + forces(1, 1);
    S const scale = free.terms + magnitude(forces(1, 1));
    claim.zero("by a value: the field equation with the forces of the multipliers", model,
               Matrix<S, N, 1>(by_value - left), scale, 10);
    claim.refutes("multipliers of the next level", model, Matrix<S, N, 1>(by_value - free.sum - forces(1, 2)),
                  scale);
    claim.refutes("slopes of the constraint at the next level", model,
                  Matrix<S, N, 1>(by_value - free.sum - forces(2, 1)), scale);
    field.mesh.for_cells([&](auto const& cell) {
      auto const C = by_hand.value(cell_of(field.mesh, y.phi, 0, cell), 1),
                 later = by_hand.value(cell_of(field.mesh, y.phi, 1, cell), 1);
      auto const by_multiplier = slope_of_action<S>(field, 1, field.mesh.number(cell), false);
      S const size = S(1) + magnitude(C);
      claim.zero("the constraint by the corners of the cell", model,
                 Matrix<S, Field::k, 1>(field.constraint(y, 1, cell) - C), size, 10);
      claim.zero("by a multiplier: the constraint of its cell", model,
                 Matrix<S, Dynamic, 1>(by_multiplier - C * field.half(1)), size, 10);
      claim.refutes("the constraint at the next level", model,
                    Matrix<S, Dynamic, 1>(by_multiplier - later * field.half(1)), size, 1e-4);
    });
  };
  Sides<1> const free = all_sides<1>(Side::free);
  varies(
      pulled_held_field<2, 2, S>(draw, draw_density<S, 2, 2>(draw), plane, {2, 2}, all_sides<2>(Side::free)),
      AreaByDiagonals<S>{}, "n = 2, N = 2, volume");
  varies(
      pulled_held_field<1, 3, S>(draw, draw_density<S, 1, 3>(draw), Inextensible{Euclidean<3>{}}, {2}, free),
      EdgeOfString<S>{}, "n = 1, N = 3, length");
  auto const any = draw_constraint<S, 1, 2>(draw);
  varies(pulled_held_field<1, 2, S>(draw, draw_density<S, 1, 2>(draw), any, {2}, free),
         ByCorners<S, 1, 2, AnyConstraint<S, 1, 2>>{any}, "n = 1, N = 2, two constraints of any kind");
  varies(pulled_held_field<1, 6, S>(draw, SpaceString<S>{draw_cubic<S, 1>(draw)}, NormalDirector<1>{}, {2},
                                    free),
         ByCorners<S, 1, 6, NormalDirector<1>>{}, "n = 1, N = 6, a normal director");

  // A block with walls all round: what the cells must add up to.
  auto const corners = [](auto const& phi) {
    return [phi](auto const& cell, int level) { return S(constraint_of_cell(phi, cell, level)[0]); };
  };
  auto const sheet = sums_over_block<2, S>(draw, corners(plane));
  claim.zero("areas of the cells of a square with fixed sides", "n = 2, 9 cells", S(sheet[1] - sheet[0]),
             S(9));
  auto const exact = sums_over_block<3, S>(draw, [&](auto const& cell, int level) {
    S const volume = trilinear_volume<S>(cell.y.template middleCols<8>(8 * level));
    claim.zero("the volume of a cell", "n = 3",
               S(volume - S(1) - constraint_of_cell(CellVolumes{}, cell, level)[0]), S(8));
    return volume;
  });
  claim.zero("volumes of the cells of a cube with fixed sides", "n = 3, 27 cells", S(exact[1] - exact[0]),
             S(27));
  auto const space = VolumeConstraint{Euclidean<3>{}, Euclidean<3>{}};
  auto const means = sums_over_block<3, S>(draw, corners(space));
  // Inner nodes are moved by half of a cell, and the difference is of third order in that.
  claim.refutes("corners in place of volumes, in space", "n = 3, 27 cells", S(means[1] - means[0]), S(27),
                1e-4);
}

STATEMENT(bridge_multiplier_form, "the discrete form formula on variations that keep a constraint") {
  claim.holds(
      "For any density and any constraint without velocities: on first variations that keep the constraint "
      "of each cell at all levels the multisymplectic form of the values sums up to zero over the boundary "
      "of any box, however the multipliers change at the first and at the last level. They have no "
      "momentum.");
  auto const balances = [&](auto field, std::string const& model) {
    auto const V = field.first_variations(draw);
    auto const box = draw_cell_box(draw, field.mesh);
    auto const some = field.form_on(box, V), whole = field.form_on(field.whole(), V);
    // First variations come out of an elimination with up to 76 unknowns.
    claim.zero("form formula on a box of cells", model, some.sum, some.terms, 1000);
    claim.zero("form formula on the whole mesh", model, whole.sum, whole.terms, 1000);
    auto const loose = field.form_on(field.whole(), field.first_variations(draw, false));
    claim.refutes("variations that do not keep the constraint", model, loose.sum, loose.terms, 1e-6);
    // The multipliers of each level at the next one: on the part of the body without its first cells. On the
    // whole of a free body they cancel, since all nodes of a cell at an inner level are inner nodes.
    auto part = field.whole();
    part.cells[0] -= 1, part.first_cell[0] = 1;
    auto late = field;
    std::rotate(late.section.lambda.begin(), late.section.lambda.begin() + 1, late.section.lambda.end());
    auto const shifted = late.form_on(part, V);
    claim.refutes("multipliers of the next level", model, shifted.sum, shifted.terms, 1e-6);
  };
  auto const slopes_ahead = [&](auto const& field, std::string const& model) {
    auto const ahead = field.form_on(field.whole(), field.first_variations(draw));
    claim.refutes("a scheme with the slopes of the constraint at the next level", model, ahead.sum,
                  ahead.terms);
  };
  GridIndex<2> const cells{2, numbers_grow() ? 1 : 2};
  Sides<1> const free = all_sides<1>(Side::free);
  Sides<2> const sheet = all_sides<2>(Side::free);
  balances(pulled_held_field<2, 2, S>(draw, draw_density<S, 2, 2>(draw), plane, cells, sheet),
           "n = 2, N = 2, volume");
  slopes_ahead(
      pulled_held_field<2, 2, S>(draw, draw_density<S, 2, 2>(draw), plane, {2, 1}, sheet, {.slope = 1}),
      "n = 2, N = 2, volume");
  Inextensible const length{Euclidean<3>{}};
  Sides<1> const hung{{{Side::fixed, Side::free}}};
  balances(pulled_held_field<1, 3, S>(draw, draw_density<S, 1, 3>(draw), length, {2}, hung),
           "n = 1, N = 3, length, one end fixed");
  // In space once: an elimination with 76 unknowns.
  if (claim.first() && !numbers_grow()) {
    Continuum const solid{Euclidean<3>{}, Euclidean<3>{}, draw_mass<S, 3>(draw), draw_solid<S>(draw)};
    balances(pulled_held_field<3, 3, S>(draw, solid, CellVolumes{}, {2, 1, 1}, all_sides<3>(Side::free)),
             "n = 3, N = 3, volume");
  }
  slopes_ahead(pulled_held_field<1, 3, S>(draw, draw_density<S, 1, 3>(draw), length, {2}, free, {.slope = 1}),
               "n = 1, N = 3, length");
  balances(pulled_held_field<1, 2, S>(draw, draw_density<S, 1, 2>(draw), draw_constraint<S, 1, 2>(draw), {2},
                                      free),
           "n = 1, N = 2, two constraints of any kind");
}

STATEMENT(bridge_multiplier_noether, "the discrete Noether theorem with multipliers") {
  claim.holds(
      "Shown for rigid motions of the plane and of space, with the volume of a sheet and the length of a "
      "string, and for the volume of a block in one cell. The multipliers are drawn and the values stepped "
      "with them, so that the constraint takes any value: the theorem is on its slopes.");
  auto const one_cell = [&](auto const& phi, auto const& cell, auto const& xi, std::string const& model) {
    // Forces of the constraint of a cell, at any values: their sum, and their work on a rigid motion.
    constexpr int N = std::remove_cvref_t<decltype(cell.y)>::RowsAtCompileTime;
    Matrix<S, 1, N> sum = Matrix<S, 1, N>::Zero();
    S work(0), growth(0), terms(0), size(0);
    for (int b = 0; b < cell.corners; ++b) {
      auto const slope = constraint_slope(phi, cell, 0, b);
      Matrix<S, N, 1> const y = cell.y.col(b);
      sum += slope;
      work += (slope * xi(y))[0], growth += (slope * y)[0];
      size += magnitude(slope),
          terms += magnitude(slope) * (magnitude(Matrix<S, N, 1>(xi(y))) + magnitude(y));
    }
    claim.zero("slopes of the constraint of a cell sum up to zero", model, sum, size);
    claim.zero("and do no work on a rigid motion", model, work, terms, 10);
    claim.refutes("on a dilation", model, growth, terms);
  };
  auto const sums = [&](auto const& field, auto const& ahead, std::string const& model) {
    constexpr int N = std::remove_cvref_t<decltype(field.section.phi(0, 0))>::RowsAtCompileTime;
    auto const xi = draw_motion<S, N>(draw);
    auto const on_space = motion_of_space<N>(xi);
    one_cell(field.density.constraint, cell_of(field.mesh, field.section.phi, 0, {}), xi, model);
    auto const first = cell_of(field.mesh, field.section, 0, {});
    SumOfTerms<S, S> cell{S(0)};
    for (int l = 0; l < first.nodes; ++l) cell.add(momentum_of_values(field.density, on_space, first, l));
    // Values come out of an elimination for each step.
    claim.zero("the nodes of one cell, with its multipliers", model, cell.sum, cell.terms, 100);
    auto const box = draw_cell_box(draw, field.mesh);
    auto const some = field.momenta_on(box, on_space), whole = field.momenta_on(field.whole(), on_space);
    claim.zero("boundary of a box of cells", model, some.sum, some.terms, 1000);
    claim.zero("boundary of the whole mesh", model, whole.sum, whole.terms, 1000);
    // A box with faces inside of the body and with inner nodes: all slabs, and half of the cells.
    auto part = field.whole();
    part.cells[0] -= 1;
    auto late = field, without = field;
    std::rotate(late.section.lambda.begin(), late.section.lambda.begin() + 1, late.section.lambda.end());
    for (auto& level : without.section.lambda)
      for (auto& lambda : level) lambda.setZero();
    auto const shifted = late.momenta_on(part, on_space), none = without.momenta_on(part, on_space);
    claim.refutes("multipliers of the next level", model, shifted.sum, shifted.terms, 1e-6);
    claim.refutes("multipliers left out of the sum", model, none.sum, none.terms, 1e-6);
    auto const turned = ahead.momenta_on(ahead.whole(), on_space);
    claim.refutes("a scheme with the slopes of the constraint at the next level", model, turned.sum,
                  turned.terms, 1e-6);
  };
  // In space the corners of a bent hexahedron have a correction, which is made of differences as well.
  auto const block = mesh_with<S, 3>(levels_of<S>(S(1)), {2, 2, 2}, all_sides<3>(Side::free));
  auto const places = draw_extended<S, 3, 3, 1>(draw, block, ratio<S>(1, 16)).phi;
  auto const bent = cell_of(block, places, 0, {});
  one_cell(VolumeConstraint{Euclidean<3>{}, Euclidean<3>{}}, bent, draw_motion<S, 3>(draw),
           "n = 3, N = 3, volume at the corners");
  one_cell(CellVolumes{}, bent, draw_motion<S, 3>(draw), "n = 3, N = 3, volume of the cell");
  Continuum const solid{Euclidean<2>{}, Euclidean<2>{}, draw_mass<S, 2>(draw), draw_solid<S>(draw)};
  GridIndex<2> const cells{2, numbers_grow() ? 1 : 2};
  sums(stepped_held_field<2, 2, S>(draw, solid, plane, cells),
       stepped_held_field<2, 2, S>(draw, solid, plane, {2, 1}, {.slope = 1}), "n = 2, N = 2, volume");
  SpaceString<S> const string{draw_cubic<S, 1>(draw)};
  Inextensible const length{Euclidean<3>{}};
  sums(stepped_held_field<1, 3, S>(draw, string, length, {3}),
       stepped_held_field<1, 3, S>(draw, string, length, {2}, {.slope = 1}), "n = 1, N = 3, length");
}
