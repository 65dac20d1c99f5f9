// Between chapter 3 and the fields of chapter 10: the discrete Euler-Poincare equations of fields with values
// in a group, once in time and once in space.
//
// The action is written out anew here, in the values of the field; its derivatives move one value at a time.
#include "models/covariant_fields.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

std::array<End, 2> const open_line{End::free, End::free}, one_held{End::held, End::free},
    both_held{End::held, End::held}, ring{End::joined, End::joined};
std::vector<std::pair<std::string, std::array<End, 2>>> const lines{
    {"free ends", open_line}, {"one end held", one_held}, {"a ring", ring}};

/// The action of a whole field, from its values one after the other, level by level.
template <class S, class L>
auto whole_action(L const& l, SpaceTimeGrid const& grid) {
  return [&l, grid](auto const& q) {
    using T = typename std::decay_t<decltype(q[0])>::Scalar;
    Index const n = grid.nodes;
    T sum(0);
    for (Index k = 0; k < grid.levels; ++k)
      for (Index a = 0; a < n; ++a) {
        auto const& here = q[k * n + a];
        if (k + 1 < grid.levels)
          sum += l(GridEdge{Direction::time, a, k}, inverse(q[(k + 1) * n + a]) * here);
        if (a + 1 < n || grid.ring())
          sum += l(GridEdge{Direction::space, a, k}, inverse(q[k * n + (a + 1) % n]) * here);
      }
    return sum;
  };
}
template <class S>
GroupElements<S> in_one_list(Field<S> const& g) {
  GroupElements<S> all;
  for (auto const& level : g.levels) all.insert(all.end(), level.begin(), level.end());
  return all;
}
/// The left sides of the field equation at all nodes, as space sees them.
template <class S, class L, class Relative>
Vector<S> equations_in_space(L const& l, Relative const& reduced, Field<S> const& g) {
  std::vector<Momentum<SpannedGroup, S>> all;
  for (Index k = 0; k < g.grid().levels; ++k)
    for (Index a = 0; a < g.grid().nodes; ++a)
      all.push_back(Ad_star(inverse(g(a, k)), field_equation(l, reduced, a, k)));
  return in_one_column(all);
}
/// The field equation at all nodes where it has to hold.
template <class S, class L, class Any>
Vector<S> residuals(L const& l, Any const& field) {
  std::vector<Momentum<SpannedGroup, S>> all;
  for (auto const& [a, k] : inner_nodes(field.grid())) all.push_back(field_equation(l, field, a, k));
  return in_one_column(all);
}
/// Moves from node 0 of level 0 to the last node of the last level, in an order that is drawn, with a detour.
std::vector<GridMove> draw_path(Draw& draw, SpaceTimeGrid const& grid) {
  std::vector<GridMove> path{
      {Direction::time, true}, {Direction::space, true}, {Direction::time, false}, {Direction::space, false}};
  Index right = grid.nodes - 1, later = grid.levels - 1;
  while (right + later > 0) {
    bool const in_time = static_cast<Index>(draw.below(static_cast<std::uint64_t>(right + later))) < later;
    (in_time ? later : right) -= 1;
    path.push_back({in_time ? Direction::time : Direction::space, true});
  }
  return path;
}
template <class S>
GroupElement<S> element_near(GroupElement<S> const& g, Draw& draw) {
  return g * draw.template element<S>(g.group, ratio<S>(1, 2));
}
/// The groups with their dimension in bounds where numbers grow.
template <class S>
std::vector<SpannedGroup> groups_of_fields() { return groups_for_motions<S>(3); }

/// Those of them whose traces depend on all directions.
template <class S>
std::vector<SpannedGroup> groups_with_traces() {
  auto groups = groups_of_fields<S>();
  std::erase_if(groups, [](auto const& group) {
    return group.name() == "SE(2)" || group.name() == "SE(3)" || group.name() == "Aff(1)" ||
           group.name() == "Heisenberg";
  });
  return groups;
}

/// Calls `visit(group, l, model)` for a rod in SE(3) and a spin chain, with the group that each has.
template <class S, class Visit>
void over_named(Draw& draw, Visit const& visit) {
  visit(
      spanned("SO(3)", SO<3>{}),
      SpinChain<S>{Matrix<S>(draw_matrix<S>(draw, 3, 3) / S(8) + Matrix<S>::Identity(3, 3)), ratio<S>(1, 3)},
      "spin chain, SO(3)");
  if (!numbers_grow()) visit(spanned("SE(3)", SE<3>{}), draw_rod<S>(draw), "rod, SE(3)");
}

}  // namespace

STATEMENT(bridge_covariant_euler_poincare,
          "discrete field equations of an invariant Lagrangian: (3.11) in time and in space") {
  claim.holds(
      "For any actions of edges, which may differ from edge to edge, on lines with free and held ends and on "
      "rings: the derivative of the action of the whole field by a value is the sum of (3.11) in time and "
      "(3.11) in space, of the edges that there are. Named Lagrangians: sigma models, a chain of rotors of "
      "Moser and Veselov, a rod of Cayley's strains in SE(3).");
  claim.leaves("Meshes of space in more than one dimension: the grid has one direction in space.");

  auto const at_any_field = [&](auto const& l, Field<S> const& g, std::string const& model) {
    auto const reduced = relative_motions(g);
    auto const list = in_one_list(g);
    auto const slope = differential(list, whole_action<S>(l, g.grid()));
    auto const scale = S(S(1) + magnitude(slope));
    claim.zero("derivative of the action of the whole field", model,
               Vector<S>(slope - equations_in_space(l, reduced, g)), scale, 10);
    auto const backwards = [&](GridEdge const& e, auto const& f) { return l(e, inverse(f)); };
    claim.refutes("relative motions inverted", model,
                  Vector<S>(slope - equations_in_space(backwards, reduced, g)), scale);
    Vector<S> in_body = slope;
    for (std::size_t i = 0; i < list.size(); ++i)
      in_body.segment(i * list[0].group.dimension(), list[0].group.dimension()) =
          field_equation(l, reduced, static_cast<Index>(i) % g.grid().nodes,
                         static_cast<Index>(i) / g.grid().nodes)
              .components;
    claim.refutes("the body's covectors in the place of those of space", model, Vector<S>(slope - in_body),
                  scale);
  };
  over_groups(groups_of_fields<S>(), claim, [&](auto const& group, std::string const& model) {
    for (auto const& [name, ends] : lines) {
      auto const g = draw_field<S>(draw, group, 3, 3, ends);
      at_any_field(draw_uneven_actions<S>(draw, group, g.grid()), g, model + ", " + name);
    }

    // The same actions on all edges: the line of the equation, and a Lagrangian of which a field is a
    // solution.
    auto g = draw_field<S>(draw, group, 3, 3, both_held);
    auto const reduced = relative_motions(g);
    auto const f = [&](Index k) { return reduced.motion({Direction::time, 1, k}); };
    auto const e = [&](Index a) { return reduced.motion({Direction::space, a, 1}); };
    auto const l_s = draw_group_polynomial<S>(draw, group);
    auto const any = draw_group_polynomial<S>(draw, group);
    claim.equal("the terms at a node are (3.11) twice", model,
                field_equation(time_and_space(any, l_s), reduced, 1, 1),
                covariant_euler_poincare(any, f(0), f(1), l_s, e(0), e(1)), 10);
    auto const l_t = checks::detail::corrected(any, group, draw, [&](auto const& trial) {
      return covariant_euler_poincare(trial, f(0), f(1), l_s, e(0), e(1));
    });
    auto const l = time_and_space(l_t, l_s);
    // Condition: the coefficients of the Lagrangian are found by elimination.
    auto const terms = size_of(left_differential(l_t, f(1))) + size_of(left_differential(l_s, e(1)));
    auto const slope = [&](Field<S> const& field) {
      auto const all = differential(in_one_list(field), whole_action<S>(l, field.grid()));
      return Vector<S>(all.segment(4 * group.dimension(), group.dimension()));
    };
    claim.zero("a field whose relative motions satisfy (3.11) twice is stationary", model, slope(g), terms,
               1000);
    g.levels[1][1] = element_near(g(1, 1), draw);
    claim.refutes("one that is moved at a node is not", model, slope(g), terms);
    claim.refutes("(3.11) in time alone", model, euler_poincare_left(l_t, f(0), f(1)), terms);
    claim.refutes("time and space exchanged", model,
                  covariant_euler_poincare(l_t, e(0), e(1), l_s, f(0), f(1)), terms);
    claim.refutes("the right-invariant equation (3.10)", model,
                  euler_poincare_right(l_t, f(0), f(1)) + euler_poincare_right(l_s, e(0), e(1)), terms);
  });
  over_named<S>(draw, [&](auto const& group, auto const& l, std::string const& model) {
    at_any_field(l, draw_field<S>(draw, group, 2, 3, open_line, ratio<S>(1, 4)), model);
  });

  // A solution in closed form.
  for (auto const& group : groups_with_traces<S>()) {
    auto const A = draw.template element<S>(group), B = draw.template element<S>(group),
               C = draw.template element<S>(group);
    SigmaModel<S> const sigma{draw.number<S>() + S(2), draw.number<S>() + S(2)};
    auto const g = product_solution(A, B, 3, 4);
    claim.zero("A^k B^a is a solution of the sigma model", group.name(), residuals<S>(sigma, g), S(4), 10);
    auto other = g;
    for (auto& level : other.levels) level[1] = level[1] * C;
    claim.refutes("with one node multiplied by C on the right", group.name(), residuals<S>(sigma, other),
                  S(4));
  }
}

STATEMENT(bridge_covariant_reconstruction,
          "flat relative motions are those of a field, which they fix up to one element of the group") {
  claim.holds(
      "On a line: relative motions are those of a field if and only if each cell is flat. On a ring the "
      "product of the relative motions round its first level has to be the identity as well.");
  over_groups(groups_of_fields<S>(), claim, [&](auto const& group, std::string const& model) {
    auto const g = draw_field<S>(draw, group, 3, 3, open_line);
    auto const h = draw.template element<S>(group);
    auto const one = identity<S>(group);
    auto const reduced = relative_motions(g);
    auto moved = g;
    for (auto& level : moved.levels)
      for (auto& value : level) value = h * value;

    // Of a field: flat, and the field comes back, along any path.
    auto const here = g(2, 2), there = h * here;
    for (Index k = 0; k < 2; ++k)
      for (Index a = 0; a < 2; ++a)
        claim.zero("the cells of a field are flat", model, curvature(reduced, a, k) - one, S(1), 100);
    auto const back = reconstruct(reduced, g(0, 0));
    for (Index k = 0; k < 3; ++k)
      for (Index a = 0; a < 3; ++a)
        claim.zero("the field of its relative motions", model, back(a, k) - g(a, k),
                   S(size_of(g(a, k)) + S(1)), 100);
    claim.zero("along a path that is drawn", model,
               reconstruct_along(reduced, 0, 0, g(0, 0), draw_path(draw, g.grid())) - here,
               S(size_of(here) + S(1)), 100);
    // Unique up to h on the left, and no more.
    auto const multiplied = relative_motions(moved);
    claim.zero("relative motions do not change with h g", model,
               multiplied.motion({Direction::space, 1, 2}) - reduced.motion({Direction::space, 1, 2}), S(1),
               100);
    claim.zero("from another first value the field is h g", model,
               reconstruct(reduced, h * g(0, 0))(2, 2) - there, S(size_of(there) + S(1)), 100);
    auto turned = g;
    for (auto& level : turned.levels)
      for (auto& value : level) value = value * h;
    claim.refutes(
        "relative motions of g h", model,
        relative_motions(turned).motion({Direction::space, 1, 2}) - reduced.motion({Direction::space, 1, 2}),
        S(1));

    // Conversely: relative motions that are drawn, flat in each cell.
    RelativeField<SpannedGroup, S> drawn{{}, {draw_points<S>(draw, group, 2, ratio<S>(1, 2))}, open_line};
    for (int k = 0; k < 2; ++k) drawn.append(draw_points<S>(draw, group, 3, ratio<S>(1, 2)));
    auto const field = reconstruct(drawn, h);
    for (auto const direction : {Direction::time, Direction::space})
      for (Index k = 0; k < 2; ++k)
        for (Index a = 0; a < 2; ++a) {
          GridEdge const edge{direction, a, k + (direction == Direction::space ? 1 : 0)};
          claim.zero("flat relative motions are those of a field", model,
                     field.motion(edge) - drawn.motion(edge), S(size_of(drawn.motion(edge)) + S(1)), 100);
        }
    drawn.space[1][1] = element_near(drawn.space[1][1], draw);
    claim.refutes("with one relative motion changed: curvature", model, curvature(drawn, 1, 0) - one, S(1));
    std::vector<GridMove> const up_first{
        {Direction::time, true}, {Direction::space, true}, {Direction::space, true}},
        right_first{{Direction::space, true}, {Direction::space, true}, {Direction::time, true}};
    claim.refutes(
        "and two paths to one node", model,
        reconstruct_along(drawn, 0, 0, h, up_first) - reconstruct_along(drawn, 0, 0, h, right_first), S(1));

    // A ring.
    auto const circle = relative_motions(draw_field<S>(draw, group, 3, 2, ring));
    auto const round = [&](auto const& relative, Index k) {
      auto product = one;
      for (Index a = 0; a < 3; ++a) product = relative.motion({Direction::space, a, k}) * product;
      return product;
    };
    claim.zero("round a ring", model, round(circle, 1) - one, S(1), 100);
    RelativeField<SpannedGroup, S> gap{{}, {draw_points<S>(draw, group, 3, ratio<S>(1, 2))}, ring};
    gap.append(draw_points<S>(draw, group, 3, ratio<S>(1, 2)));
    claim.zero("a ring that does not close: its cells are flat", model, curvature(gap, 2, 0) - one, S(1),
               100);
    claim.refutes("and it is not of a field", model, round(gap, 1) - one, S(1));
  });
}

STATEMENT(bridge_covariant_noether, "the momentum through the boundary of any box of nodes") {
  claim.holds(
      "For any actions of edges, on lines with free and held ends and on rings, whose boxes may go round. "
      "An edge carries the same momentum at its two ends, for any field; the sum is zero along solutions.");
  auto const sums = [&](auto const& l, Field<S> g, std::string const& model, double condition) {
    GridEdge const edge{Direction::space, 0, 1};
    auto const action = [&](auto const& f) { return l(edge, f); };
    claim.equal("an edge has one momentum", model, edge_momentum(l, g, g, edge),
                Ad_star(inverse(g(1, 1)), -right_differential(action, g.motion(edge))), 10);
    claim.differs("the momentum at its end, at its start", model, edge_momentum(l, g, g, edge),
                  Ad_star(inverse(g(0, 1)), -right_differential(action, g.motion(edge))), 1e-6);
    for (int i = 0; i < 3; ++i) {
      auto const balance = noether_balance(l, g, draw_node_box(draw, g.grid()));
      claim.zero("boundary of a box of nodes", model, balance.sum, balance.terms, condition);
    }
    NodeBox const box{g.ends[0] == End::held ? 1 : 0, g.grid().nodes - 1, 1, 2};
    auto body = zero_momentum<S>(g(0, 0).group);
    over_boundary(g.grid(), box, [&](GridEdge const& e, bool leaves) {
      auto const mu = left_differential([&](auto const& f) { return l(e, f); }, g.motion(e));
      body = leaves ? body - mu : body + mu;
    });
    auto const all = noether_balance(l, g, box);
    claim.zero("the box of the controls", model, all.sum, all.terms, condition);
    claim.refutes("body momenta, summed up where they are", model, body, all.terms, 1e-6);
    auto& value = g.levels[1][1];
    value = element_near(value, draw);
    auto const off = noether_balance(l, g, box);
    claim.refutes("along a field that solves nothing at one node", model, off.sum, off.terms, 1e-6);
  };
  over_groups(groups_of_fields<S>(), claim, [&](auto const& group, std::string const& model) {
    for (auto const& [name, ends] : lines) {
      auto const g = draw_field<S>(draw, group, 3, 4, ends);
      // Condition: the actions are found by elimination.
      sums(with_solution(draw, draw_uneven_actions<S>(draw, group, g.grid()), g), g, model + ", " + name,
           1000);
    }
  });
  over_named<S>(draw, [&](auto const& group, auto const& l, std::string const& model) {
    auto const g = draw_field<S>(draw, group, 3, 4, open_line, ratio<S>(1, 4));
    sums(with_solution(draw, l, g), g, model, 1000);
    if (exact_arithmetic<S>()) return;
    // A run: three levels by the solver, from a row at rest with momenta.
    auto run = draw_field<S>(draw, group, 3, 1, open_line, ratio<S>(1, 16));
    std::vector<Momentum<SpannedGroup, S>> momenta;
    for (int a = 0; a < 3; ++a) momenta.push_back(draw.template momentum<S>(group, ratio<S>(1, 64)));
    step_in_time(l, run, momenta);
    for (int k = 0; k < 2; ++k) step_in_time(l, run);
    // Condition: the solver stops at 16 roundings of the derivative, which is many times a momentum.
    sums(l, run, model + ", a run", 3000);
  });
}

STATEMENT(bridge_covariant_form, "the multisymplectic form formula of fields with values in a group") {
  claim.holds(
      "For any actions of edges, on lines with free and held ends and on rings, and two first variations. "
      "The form of an edge is the exterior derivative of the discrete Lagrange one-form of its two values, "
      "and needs its relative motion alone.");
  auto const balances = [&](auto const& l, Field<S> const& g, std::string const& model, double condition) {
    auto const& group = g(0, 0).group;
    auto const V = first_variation(draw, l, g), W = first_variation(draw, l, g);
    auto const reduced = relative_motions(g);
    for (int i = 0; i < 3; ++i) {
      auto const balance = form_balance(l, reduced, V, W, draw_node_box(draw, g.grid()));
      claim.zero("boundary of a box of nodes", model, balance.sum, balance.terms, condition);
    }
    NodeBox const box{g.ends[0] == End::held ? 1 : 0, g.grid().nodes - 1, 1, 2};
    auto const any = form_balance(l, reduced, V, draw_variation(draw, g, g.grid().levels), box);
    claim.refutes("a variation that solves nothing", model, any.sum, any.terms, 1e-6);
    // A field that is turned as a whole: the form with it is the change of a momentum.
    auto const xi = draw.template velocity<S>(group);
    FieldVariation<SpannedGroup, S> turn;
    for (auto const& level : g.levels) {
      turn.emplace_back();
      for (auto const& value : level) turn.back().push_back(Ad(inverse(value), xi));
    }
    if (g.ends[0] != End::held) {
      auto const change = linearised_equation(l, g, turn, 1, 1);
      claim.zero("turns of the whole field are first variations", model, change,
                 S(size_of(left_second_differential(
                       [&](auto const& f) {
                         return l(GridEdge{Direction::time, 1, 1}, f);
                       },
                       g.motion({Direction::time, 1, 1}))) +
                   S(1)),
                 condition);
    }
    // The form of one edge, by the exterior derivative on pairs.
    GridEdge const edge{Direction::space, 1, 1};
    auto const on_pairs = lift_left([&](auto const& f) { return l(edge, f); });
    auto const theta = [&](auto const& p, auto const& q, auto const& w) {
      return discrete_one_form_minus(on_pairs, p, q, w);
    };
    auto const in_space = [&](auto const& U) {
      return Change<S>{Ad(g(1, 1), U[1][1]), Ad(g(2, 1), U[1][2])};
    };
    S const form = edge_form(l, reduced, edge, V, W).sum,
            d_theta = exterior_derivative(theta, g(1, 1), g(2, 1), in_space(V), in_space(W));
    claim.zero("form of an edge: exterior derivative of its one-form", model, S(form - d_theta),
               S(magnitude(form) + S(1)), condition);
    claim.refutes("with the other sign", model, S(form + d_theta), S(magnitude(form)));
  };
  over_groups(groups_of_fields<S>(), claim, [&](auto const& group, std::string const& model) {
    for (auto const& [name, ends] : lines) {
      auto const g = draw_field<S>(draw, group, 3, 4, ends);
      // Condition: actions and variations are found by elimination.
      balances(with_solution(draw, draw_uneven_actions<S>(draw, group, g.grid()), g), g, model + ", " + name,
               1e4);
    }
  });
  over_named<S>(draw, [&](auto const& group, auto const& l, std::string const& model) {
    auto const g = draw_field<S>(draw, group, 3, 4, open_line, ratio<S>(1, 4));
    balances(with_solution(draw, l, g), g, model, 1e4);
  });

  // A family of solutions in closed form: its derivatives are first variations, by no solver.
  for (auto const& group : groups_with_traces<S>()) {
    auto const A = draw.template element<S>(group), B = draw.template element<S>(group);
    auto const alpha = draw.template velocity<S>(group), beta = draw.template velocity<S>(group);
    SigmaModel<S> const sigma{draw.number<S>() + S(2), draw.number<S>() + S(2)};
    auto g = product_solution(A, B, 3, 4);
    auto const family = product_solution(nudged(A, alpha), nudged(B, beta), 3, 4);
    g.ends = open_line;  // the values at the ends vary
    FieldVariation<SpannedGroup, S> V, wrong;
    for (Index k = 0; k < 4; ++k) {
      V.emplace_back(), wrong.emplace_back();
      for (Index a = 0; a < 3; ++a) {
        auto const theta = state_of(family(a, k)).velocity;
        V.back().push_back(Ad(inverse(g(a, k)), theta)), wrong.back().push_back(theta);
      }
    }
    claim.zero("derivatives of A^k B^a are first variations", group.name(),
               linearised_equation(sigma, g, V, 1, 1), S(16), 100);
    claim.refutes("translated to the identity on the other side", group.name(),
                  linearised_equation(sigma, g, wrong, 1, 1), S(16), 1e-6);
  }
}
