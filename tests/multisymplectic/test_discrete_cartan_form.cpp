// Identities that hold for any values, solutions or not: exact over the rationals.
#include <boost/test/unit_test.hpp>

#include "actio/jets/action.hpp"
#include "actio/noether/equivariance.hpp"
#include "media.hpp"
#include "witness/draw.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::media;
using namespace actio::testing;

namespace {

using Q = Number;

/// A density that depends on everything, of fourth degree, in which velocities meet gradients.
struct Everything {
  template <class T, int n, int N>
  T operator()(Jet<T, n, N> const& j) const {
    T sum = j.v(0, 0) * j.v(0, 0) + j.v(N - 1, 0) * j.v(N - 1, 0) * 2 - j.v(0, n) * j.v(0, n) * j.v(N - 1, 1);
    return sum + j.x[1] * j.y[0] * j.v(N - 1, n) + j.y[0] * j.y[N - 1] * j.v(0, 0) * j.v(0, 1) +
           j.x[0] * j.y[N - 1];
  }
};

template <int n>
SpaceTimeMesh<Q, n> bent_mesh(Side side) {
  GridIndex<n> cells;
  for (int i = 0; i < n; ++i) cells[i] = 2;
  return {{Q(0), ratio<Q>(1, 2), ratio<Q>(4, 5)}, cells, all_sides<n>(side), bent_cube<Q, n>()};
}

/// Draws a section over three levels.
template <int n, int N>
DiscreteSection<Q, n, N> drawn_section(SpaceTimeMesh<Q, n> const& mesh, FineDraw& draw) {
  DiscreteSection<Q, n, N> section;
  for (int k = 0; k < mesh.levels(); ++k) {
    section.levels.emplace_back();
    for (Index i = 0; i < mesh.node_count(); ++i)
      section.levels.back().push_back(draw.vector<Q, Matrix<Q, N, 1>>(N));
  }
  return section;
}

template <int n, int N>
void forms_of_a_cell() {
  WithArithmetic const exactly(Arithmetic::rationals());
  FineDraw draw(1);
  auto const mesh = bent_mesh<n>(Side::periodic);
  GridIndex<n> cell;
  cell.fill(1);
  auto const values = [&] { return cell_of(mesh, drawn_section<n, N>(mesh, draw), 1, cell); };
  auto const here = values();
  auto const V = values().y, W = values().y;
  Everything const L;

  // dL_d = sum_l Theta^l, the left side by one derivative along V.
  Q sum(0);
  for (int l = 0; l < here.nodes; ++l) sum += discrete_cartan_form(L, here, l).dot(V.col(l));
  auto const along = discrete_lagrangian(L, here.with(moved_along(here.y, V)));
  BOOST_TEST((rate_of(along) == sum));
  BOOST_TEST((sum != 0));

  // The two-forms of a cell sum up to zero, none of them does.
  Q forms(0);
  for (int l = 0; l < here.nodes; ++l) {
    Q const Omega = discrete_multisymplectic_form(L, here, l, V, W);
    BOOST_TEST((Omega != 0));
    BOOST_TEST((discrete_multisymplectic_form(L, here, l, W, V) == -Omega));
    forms += Omega;
  }
  BOOST_TEST((forms == 0));
}

/// A cell's Cartan form by the chain rule, with the momenta of the density at each corner.
template <class L, int n, int N>
Matrix<Q, N, 1> by_momenta(L const& density, SpaceTimeCell<Q, n, N> const& cell, int l) {
  Matrix<Q, N, 1> Theta = Matrix<Q, N, 1>::Zero();
  for (int k = 0; k < cell.nodes; ++k) {
    auto const j = discrete_jet(cell, k);
    auto const p = momenta(density, j);
    int const corner = k % cell.corners;
    // How the jet at k changes with the value at l: the place, the velocity, the edges, the correction.
    if (k == l) Theta += partial_y(density, j) * cell.volume(k);
    Matrix<Q, n + 1, 1> slope = Matrix<Q, n + 1, 1>::Zero();
    if (l % cell.corners == corner) slope[0] = (l < cell.corners ? Q(-1) : Q(1)) / cell.duration();
    for (int e = 0; e < n; ++e) {
      Q const change = l == (k ^ (1 << e)) ? Q(1) : l == k ? Q(-1) : Q(0);
      for (int i = 0; i < n; ++i) slope[1 + i] += change * cell.geometry->inverse_edges[corner](e, i);
    }
    auto const& correction = cell.geometry->correction;
    if (correction.any && k / cell.corners == l / cell.corners)
      for (int i = 0; i < n; ++i) slope[1 + i] += correction.slopes(i, l % cell.corners);
    Theta += p * slope * cell.volume(k);
  }
  return Theta;
}

}  // namespace

BOOST_AUTO_TEST_CASE(cartan_forms_sum_up_to_the_differential_and_their_two_forms_to_zero) {
  forms_of_a_cell<1, 1>();
  forms_of_a_cell<1, 3>();
  forms_of_a_cell<2, 2>();
  forms_of_a_cell<2, 3>();
  forms_of_a_cell<3, 3>();
}

BOOST_AUTO_TEST_CASE(cartan_forms_are_the_momenta_of_the_density_on_the_edges_of_a_cell) {
  WithArithmetic const exactly(Arithmetic::rationals());
  FineDraw draw(2);
  auto const mesh = bent_mesh<2>(Side::free);
  auto const here = cell_of(mesh, drawn_section<2, 3>(mesh, draw), 0, {{1, 0}});
  for (int l = 0; l < here.nodes; ++l)
    BOOST_TEST((discrete_cartan_form(Everything{}, here, l) == by_momenta(Everything{}, here, l)));
  // In space every value of a level is in every jet of it.
  auto const space = bent_mesh<3>(Side::free);
  auto const cell = cell_of(space, drawn_section<3, 2>(space, draw), 0, {{1, 0, 1}});
  BOOST_TEST(cell.geometry->correction.any);
  for (int l = 0; l < cell.nodes; l += 5)
    BOOST_TEST((discrete_cartan_form(Everything{}, cell, l) == by_momenta(Everything{}, cell, l)));
}

BOOST_AUTO_TEST_CASE(
    the_discrete_lagrangian_of_a_medium_is_lumped_kinetic_energy_less_stored_energy_at_both_ends) {
  WithArithmetic const exactly(Arithmetic::rationals());
  FineDraw draw(3);
  auto const mesh = bent_mesh<2>(Side::free);
  auto const here = cell_of(mesh, drawn_section<2, 2>(mesh, draw), 0, {{1, 1}});
  auto const medium = solid<Q, 2>();
  Q kinetic(0), stored(0);
  for (int b = 0; b < 4; ++b) {
    Q const mass = medium.rho.value * here.geometry->volume[b];
    kinetic += mass / 2 * (here.y.col(4 + b) - here.y.col(b)).squaredNorm() / here.duration();
    for (int level = 0; level < 2; ++level) {
      Matrix<Q, 2, 2> const C = green_tensor(Kronecker<2>{}, discrete_jet(here, b + 4 * level).gradient());
      stored += here.duration() / 2 * mass * medium.W.w(C);
    }
  }
  BOOST_TEST((discrete_lagrangian(medium, here) == Q(kinetic - stored)));
}

BOOST_AUTO_TEST_CASE(field_equations_are_the_variation_of_the_discrete_action) {
  WithArithmetic const exactly(Arithmetic::rationals());
  FineDraw draw(4);
  for (auto const side : {Side::free, Side::periodic}) {
    auto const mesh = bent_mesh<2>(side);
    auto const section = drawn_section<2, 2>(mesh, draw), V = drawn_section<2, 2>(mesh, draw);
    // The action is of fourth degree: two pairs of differences give its derivative, without duals.
    auto const moved = [&](Q const& h) {
      auto other = section;
      for (Index i = 0; i < mesh.node_count(); ++i) other(1, i) += V(1, i) * h;
      return discrete_action(Everything{}, mesh, other);
    };
    auto const slope = [&](Q const& h) { return Q((moved(h) - moved(-h)) / (h + h)); };
    Q const rate = (slope(Q(1)) * 4 - slope(Q(2))) / 3;
    Q sum(0);
    for (Index i = 0; i < mesh.node_count(); ++i)
      sum += discrete_euler_lagrange(Everything{}, mesh, section, 1, i).sum.dot(V(1, i));
    BOOST_TEST((sum == rate));
    BOOST_TEST((sum != 0));
  }
}

BOOST_AUTO_TEST_CASE(a_symmetry_of_the_density_is_one_of_every_cell_and_a_growth_is_none) {
  WithArithmetic const exactly(Arithmetic::rationals());
  FineDraw draw(5);
  auto const mesh = bent_mesh<3>(Side::free);
  auto const here = cell_of(mesh, drawn_section<3, 3>(mesh, draw), 0, {{1, 0, 1}});
  auto const medium = solid<Q, 3>();
  BOOST_TEST((equivariance_of_cell(medium, shifting<Q, 3>(2), here).sum == 0));
  BOOST_TEST((equivariance_of_cell(medium, turning<Q, 3>(), here).sum == 0));
  BOOST_TEST((equivariance_of_cell(medium, growing<Q, 3>(), here).sum != 0));
  // The rate is that of the density itself at the corners, with the volumes that they stand for.
  Q rate(0);
  for (int l = 0; l < here.nodes; ++l)
    rate += equivariance_rate(medium, growing<Q, 3>(), discrete_jet(here, l)) * here.volume(l);
  BOOST_TEST((equivariance_of_cell(medium, growing<Q, 3>(), here).sum == rate));
  // A generator that moves events has no discrete momentum.
  auto const drifting = []<class V>(V const& point) {
    V xi = V::Zero();
    xi[0] = point[0] * 0 + 1;
    return xi;
  };
  BOOST_CHECK_EXCEPTION(discrete_momentum(medium, drifting, here, 0), NotVertical,
                        [](NotVertical const& e) { return e.measured == 1; });
}

BOOST_AUTO_TEST_CASE(the_discrete_action_is_of_second_order) {
  // A smooth motion of a bent body; the action of the straight one by Gauss's rule is another way.
  auto const motion = []<class T>(Matrix<T, 3, 1> const& x) {
    return Matrix<T, 2, 1>(x[1] + x[0] * x[2] * x[1] / 3, x[2] * 2 + x[1] * x[1] * x[0] / 5 - x[0] * x[0]);
  };
  auto const medium = solid<double, 2>();
  Box<double, 2> const box{{0, 0, 0}, {1, 1, 1}};
  double const exact = action(medium, motion, box, 12);
  std::vector<double> errors;
  for (int cells : {4, 8, 16, 32}) {
    SpaceTimeMesh<double, 2> const mesh(equal_steps(0.0, 1.0 / cells, cells), {cells, cells},
                                        all_sides<2>(Side::free), bent_cube<double, 2>());
    errors.push_back(std::abs(discrete_action(medium, mesh, restricted(mesh, motion, cells + 1)) - exact));
  }
  for (std::size_t k = 1; k < errors.size(); ++k) {
    double const order = std::log2(errors[k - 1] / errors[k]);
    BOOST_TEST_MESSAGE("discrete action, order " << order << ", error " << errors[k]);
    BOOST_TEST(std::abs(order - 2) < 0.1);
  }
}

BOOST_AUTO_TEST_CASE(discrete_field_equations_are_those_of_the_density_to_second_order) {
  auto const motion = []<class T>(Matrix<T, 3, 1> const& x) {
    return Matrix<T, 2, 1>(x[1] + x[0] * x[2] * x[1] / 3, x[2] * 2 + x[1] * x[1] * x[0] / 5 - x[0] * x[0]);
  };
  auto const medium = solid<double, 2>();
  StraightBox<double, 2> const square{Matrix<double, 2, 1>(0.0, 0.0), Matrix<double, 2, 1>(1.0, 1.0)};
  Event<double, 2> const middle(0.5, 0.5, 0.5);
  auto const exact = euler_lagrange(medium, second_jet(motion, middle));
  std::vector<double> errors;
  for (int cells : {4, 8, 16, 32}) {
    double const h = 1.0 / cells;
    SpaceTimeMesh<double, 2> const mesh(equal_steps(0.5 - h, h, 2), {cells, cells}, all_sides<2>(Side::free),
                                        square);
    auto const section = restricted(mesh, motion, 3);
    Index const node = mesh.node({{cells / 2, cells / 2}}, 0);
    auto const E = discrete_euler_lagrange(medium, mesh, section, 1, node);
    errors.push_back(magnitude(E.sum / (h * h * h) - exact));
  }
  // The next term of the expansion is smaller by h^2: a few parts in a hundred of the order on the first
  // pair.
  for (std::size_t k = 1; k < errors.size(); ++k) {
    double const order = std::log2(errors[k - 1] / errors[k]);
    BOOST_TEST_MESSAGE("discrete field equations, order " << order << ", error " << errors[k]);
    BOOST_TEST(std::abs(order - 2) < 0.1);
  }
}
