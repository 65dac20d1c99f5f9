// Chapter 10: discretization of fields in space and time by the variational principle, on the meshes,
// discrete jets and discrete Cartan forms of the library.
#include "actio/jets/field_equations.hpp"
#include "fields/discrete_fields.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::media;
using namespace actio::checks;

namespace {

/// A turn of space with a shift, or a shift alone.
template <class S, int N>
auto draw_rigid_motion(Draw& draw, bool turning) {
  RigidMotion<S, N> xi{Matrix<S, N, N>::Zero(), draw.vector<S, Matrix<S, N, 1>>(N)};
  for (int i = 0; turning && i < N; ++i)
    for (int k = 0; k < i; ++k) xi.turn(i, k) = draw.number<S>(), xi.turn(k, i) = -xi.turn(i, k);
  return motion_of_space<N>(xi);
}

/// The discrete field equations of a density at the middle of two cells of width 2h and two slabs, over the
/// volume of the node; by the jets at all nodes of a cell, or at its first one alone.
template <class S, class L, class Phi>
Matrix<S, 2, 1> discrete_equations(L const& density, Phi const& phi, S const& h, bool all) {
  using X = Matrix<S, 1, 1>;
  SpaceTimeMesh<S, 1> const mesh({S(-h), S(0), h}, {2}, all_sides<1>(Side::free),
                                 StraightBox<S, 1>{X(S(-h)), X(h)});
  auto const section = restricted(mesh, phi, 3);
  S const volume = h * h;
  if (all) return discrete_euler_lagrange(density, mesh, section, 1, 1).sum / volume;
  Matrix<S, 2, 1> E = Matrix<S, 2, 1>::Zero();
  for (int slab : {0, 1})
    mesh.for_cells_at(1, [&](GridIndex<1> const& cell, int b) {
      auto const here = cell_of(mesh, section, slab, cell);
      int const l = node_of_corner<1>(b, 1 - slab);
      auto const first = [&]<class T>(Matrix<T, 2, 1> const& y) -> T {
        auto moved = here.template cast<T>();
        moved.y.col(l) = y;
        return action_at_node(density, moved, 0) * T(S(here.nodes));
      };
      E += derivative(first, Matrix<S, 2, 1>(here.y.col(l))).gradient();
    });
  return E / volume;
}

}  // namespace

STATEMENT(claim_10_0_variational_discretisation,
          "space-time variational discretisation: discrete form and momentum maps") {
  claim.holds(
      "On meshes of space-time with bodies of one and two dimensions, curved cells, steps of different "
      "length and free, fixed and periodic sides, for any density of first jets by the trapezoidal rule: "
      "the discrete multisymplectic form formula on any box of cells, the form preserved from time to "
      "time, and the momentum maps of the symmetries that the discrete Lagrangian has: rigid motions, and "
      "where the events of the mesh move shifts of time, labels and space. The discrete field equations "
      "are those of the density to second order.");
  auto const balances = [&](auto const& field, auto const& V, std::string const& model, double condition) {
    auto const box = draw_cell_box(draw, field.mesh);
    auto const sum = field.form_on(box, V), whole = field.form_on(field.whole(), V);
    claim.zero("form formula on a box of cells", model, sum.sum, sum.terms, condition);
    claim.zero("form formula on the whole mesh", model, whole.sum, whole.terms, condition);
    auto const before = field.form_after(0, V), after = field.form_after(field.slabs() - 1, V);
    claim.zero("the form after the first and the last step of time", model, S(before.sum - after.sum),
               S(before.terms + after.terms), condition);
    std::array const any{field.draw_variation(draw), field.draw_variation(draw)};
    auto const outside = field.form_on(field.whole(), any);
    claim.refutes("variations that solve nothing", model, outside.sum, outside.terms);
  };
  auto const forms = [&](auto field, std::string const& model) {
    // First variations come out of an elimination with up to 18 unknowns.
    balances(field, field.first_variations(draw), model, 1000);
    field.friction = S(1);
    auto const lost = field.form_on(field.whole(), field.first_variations(draw));
    claim.refutes("a scheme with friction, which is not variational", model, lost.sum, lost.terms);
  };
  Sides<1> const free = all_sides<1>(Side::free), ring = all_sides<1>(Side::periodic);
  Sides<2> const held{{{Side::fixed, Side::free}, {Side::free, Side::free}}};
  forms(pulled_field<1, 2, S>(draw, draw_density<S, 1, 2>(draw), {2}, free), "n = 1, N = 2, free");
  forms(pulled_field<1, 2, S>(draw, draw_density<S, 1, 2>(draw), {2}, ring), "n = 1, N = 2, periodic");
  forms(pulled_field<2, 1, S>(draw, draw_density<S, 2, 1>(draw), {2, 2}, held),
        "n = 2, N = 1, one side fixed");
  forms(pulled_field<1, 3, S>(draw, MovingEvents<S>{draw_cubic<S, 2>(draw)}, {2}, free),
        "n = 1, events that move");

  auto const momenta = [&](auto const& solution, auto const& other, auto const& rubbed, auto const& xi,
                           std::string const& model) {
    auto const gained = [&](auto const& field) {
      auto const before = momentum_of_level(field.density, xi, field.mesh, field.section, 0),
                 after = momentum_of_level(field.density, xi, field.mesh, field.section, field.slabs() - 1);
      return SumOfTerms<S, S>{S(after.sum - before.sum), S(after.terms + before.terms)};
    };
    auto const on = gained(solution), off = gained(other), less = gained(rubbed);
    // The pulls come out of a division by the mass, the steps out of an elimination.
    claim.zero("momentum after the first and the last step of time", model, on.sum, on.terms, 100);
    claim.refutes("momentum of a field that solves nothing", model, off.sum, off.terms);
    claim.refutes("momentum with friction", model, less.sum, less.terms);
  };
  // A field that solves another density's equations solves nothing here.
  auto const swapped = [](auto field, auto const& other) {
    field.section = other.section;
    return field;
  };
  {
    auto const events = [&](S const& friction) {
      return pulled_field<1, 3, S>(draw, MovingEvents<S>{draw_cubic<S, 2>(draw)}, {2}, free, friction);
    };
    auto const solution = events(S(0));
    momenta(solution, swapped(solution, events(S(0))), events(S(1)), draw_rigid_motion<S, 3>(draw, false),
            "n = 1, events that move: shifts");
  }
  {
    Continuum const solid{Euclidean<2>{}, Euclidean<2>{}, draw_mass<S, 2>(draw), draw_solid<S>(draw)};
    auto const field = stepped_field<2, 2, S>(draw, solid, {2, numbers_grow() ? 1 : 2});
    // Steps and their derivatives are solved node by node, three times.
    balances(field, stepped_variations(draw, field), "n = 2, N = 2, isotropic solid", 1000);
  }

  if (claim.fits_orders()) {
    auto const L = draw_density<S, 1, 2>(draw);
    auto const phi = draw_section<S, 1, 2>(draw);
    auto const E = euler_lagrange(L, second_jet(phi, Event<S, 1>(Event<S, 1>::Zero())));
    std::vector<double> steps, all, first;
    for (int k = 3; k <= 8; ++k) {
      S const h = ratio<S>(1, 1 << k);
      steps.push_back(to_double(h));
      all.push_back(to_double(size_of((discrete_equations(L, phi, h, true) - E).eval())));
      first.push_back(to_double(size_of((discrete_equations(L, phi, h, false) - E).eval())));
    }
    claim.order("discrete field equations against those of the density", "n = 1, N = 2", steps, all, 2);
    claim.refutes_order("the jet at the first node of a cell in place of those at all", "n = 1, N = 2", steps,
                        first, 2);
  }
}

STATEMENT(claim_10_0_discrete_noether_sum, "integral discrete Noether theorem over a set of nodes") {
  claim.holds(
      "The set of nodes is the boundary of any box of cells; the sum is that of the momenta of its cells. "
      "Shown for rigid motions of the plane and of space, for a sheet and a string, and for shifts of "
      "time, labels and space where the events of the mesh move.");
  auto const sums = [&](auto const& field, auto const& xi, std::string const& model) {
    auto const box = draw_cell_box(draw, field.mesh);
    auto const some = field.momenta_on(box, xi), whole = field.momenta_on(field.whole(), xi);
    claim.zero("boundary of a box of cells", model, some.sum, some.terms, 100);
    claim.zero("boundary of the whole mesh", model, whole.sum, whole.terms, 100);
    // One cell: invariance alone, off shell and on.
    auto const cell = equivariance_of_cell(field.density, xi, cell_of(field.mesh, field.section, 0, {}));
    claim.zero("the nodes of one cell", model, cell.sum, cell.terms, 100);
    constexpr int N = std::remove_cvref_t<decltype(field.section(0, 0))>::RowsAtCompileTime;
    auto const dilation =
        motion_of_space<N>([](auto const& y) { return std::remove_cvref_t<decltype(y)>(y); });
    auto const stretched = field.momenta_on(field.whole(), dilation);
    claim.refutes("dilations, which are no symmetry", model, stretched.sum, stretched.terms);
    auto moved = field;
    moved.section(1, 1) += draw.vector<S, Matrix<S, N, 1>>(N) * ratio<S>(1, 16);
    auto const off = moved.momenta_on(field.whole(), xi);
    claim.refutes("along a field that solves nothing at one node", model, off.sum, off.terms);
  };
  Continuum const solid{Euclidean<2>{}, Euclidean<2>{}, draw_mass<S, 2>(draw), draw_solid<S>(draw)};
  sums(stepped_field<2, 2, S>(draw, solid, {2, numbers_grow() ? 1 : 2}), draw_rigid_motion<S, 2>(draw, true),
       "n = 2, N = 2, motions of the plane");
  sums(stepped_field<1, 3, S>(draw, SpaceString<S>{draw_cubic<S, 1>(draw)}, {3}),
       draw_rigid_motion<S, 3>(draw, true), "n = 1, N = 3, motions of space");
  auto const events = [&](S const& friction) {
    return pulled_field<1, 3, S>(draw, MovingEvents<S>{draw_cubic<S, 2>(draw)}, {2}, all_sides<1>(Side::free),
                                 friction);
  };
  auto const shifts = draw_rigid_motion<S, 3>(draw, false);
  sums(events(S(0)), shifts, "n = 1, events that move: shifts");
  auto const damped = events(S(1));
  auto const rubbed = damped.momenta_on(damped.whole(), shifts);
  claim.refutes("with friction", "n = 1, events that move: shifts", rubbed.sum, rubbed.terms);
  // A density without the symmetry, and a field that solves its equations.
  auto const other = pulled_field<1, 2, S>(draw, draw_density<S, 1, 2>(draw), {2}, all_sides<1>(Side::free));
  auto const sum = other.momenta_on(other.whole(), draw_rigid_motion<S, 2>(draw, true));
  claim.refutes("along a solution, with a density that is not invariant", "n = 1, N = 2", sum.sum, sum.terms);
}
