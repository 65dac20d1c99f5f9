// Asynchronous steps: what every event and every region of space-time balances, the gain, orders, refusals.
//
// A momentum of a node is a mass times a velocity, and a kick is the difference of two of them, each rounded:
// balances are measured by the momenta before and after. Terms of a sum are rounded a few times each and
// independently, so sums of them stay near one rounding of the terms.
#include <boost/test/unit_test.hpp>

#include <numbers>
#include <numeric>

#include "actio/multisymplectic/asynchronous_steps.hpp"
#include "media.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::media;
using namespace actio::testing;

namespace {

/// A solid of St Venant and Kirchhoff whose mass density grows along the body.
template <int n>
auto uneven_solid() {
  Matrix<double, n, 1> slope;
  for (int i = 0; i < n; ++i) slope[i] = 0.1 / (1 + i);
  return Continuum{Euclidean<n>{}, Euclidean<n>{}, LinearDensity<double, n>{2, slope},
                   OfGreenTensor{StVenantKirchhoff<double>{0.5, 0.75}}};
}

/// Box-like cells cut into simplices, one for each order of the axes: the corners on a way along the edges
/// from the first corner to the last.
BodyMesh cut_into_simplices(BodyMesh const& boxes) {
  BodyMesh mesh = boxes;
  int const n = mesh.dimension;
  mesh.shape = n == 2 ? BodyMesh::Shape::triangle : BodyMesh::Shape::tetrahedron;
  mesh.cells.clear(), mesh.sides.clear();
  for (auto const& box : boxes.cells) {
    std::vector<int> axes(n);
    std::iota(axes.begin(), axes.end(), 0);
    do {
      std::array<int, 8> cell{};
      for (int k = 0, corner = 0; k <= n; ++k) {
        cell[k] = box[corner];
        if (k < n) corner |= 1 << axes[k];
      }
      mesh.cells.push_back(cell);
      if (corner_jacobian(mesh, int(mesh.cells.size()) - 1, 0).volume < 0)
        std::swap(mesh.cells.back()[1], mesh.cells.back()[2]);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }
  return mesh;
}

/// A plate whose columns of cells grow tenfold in width, from 0.1 to 1, and then stay as wide.
BodyMesh graded_plate() {
  auto mesh = box_mesh({0, 0}, {1, 3}, {24, 3});
  std::vector<double> x{0};
  for (int i = 0; i < 24; ++i) x.push_back(x.back() + std::pow(10.0, std::min(0.0, i / 8.0 - 1)));
  for (std::size_t k = 0; k < mesh.nodes.size(); ++k) mesh.nodes[k][0] = x[k % 25];
  return cut_into_simplices(mesh);
}

template <int n>
struct Start {
  Level<double, n> places, velocities;
};
/// The reference places, disturbed by a part of a width, moving at about the speed of sound and turning.
template <int n>
Start<n> disturbed(BodyMesh const& mesh, Draw& draw, double width) {
  Start<n> start;
  for (auto const& X : mesh.nodes) {
    Matrix<double, n, 1> x, v;
    for (int i = 0; i < n; ++i) x[i] = X[i];
    v = draw.vector<double, Matrix<double, n, 1>>(n) * 0.02;
    v[0] += 1 - 0.1 * x[1], v[1] += 0.5 + 0.1 * x[0];
    start.places.push_back(x + draw.vector<double, Matrix<double, n, 1>>(n) * width);
    start.velocities.push_back(v);
  }
  return start;
}
template <int n>
std::vector<double> steps_of(auto const& density, BodyMesh const& mesh, Start<n> const& start,
                             double fraction) {
  auto steps = longest_steps<n, n>(density, mesh, start.places);
  for (double& step : steps) step *= fraction;
  return steps;
}

/// Sums of momenta: linear ones along the axes, then the angular one in the plane of the first two.
template <int n>
using Momenta = std::array<SumOfTerms<double, double>, n + 1>;
/// Adds those of a node. An angular momentum is two products: far from the origin these are large, and it is
/// told to their rounding.
template <int n>
void add_momenta(Momenta<n>& sums, auto const& run, int node, double time, double sign) {
  Matrix<double, n, 1> const p = run.velocity(node) * (sign * run.mass(node)), x = run.place(node, time);
  for (int i = 0; i < n; ++i) sums[i].add(p[i]);
  sums[n].add(x[0] * p[1]);
  sums[n].add(-x[1] * p[0]);
}
double worst(auto const& sums) {
  double most = 0;
  for (auto const& sum : sums)
    if (sum.terms > 0) most = std::max(most, std::abs(sum.sum) / sum.terms);
  return most;
}

/// The worst balance of momenta over the events of a run.
template <int n>
double worst_event(auto& run, double until) {
  double most = 0;
  while (run.next().time <= until) {
    auto const event = run.next();
    Momenta<n> balance{};
    for (int node : run.corners(event.cell)) add_momenta<n>(balance, run, node, event.time, -1);
    run.step();
    for (int node : run.corners(event.cell)) add_momenta<n>(balance, run, node, event.time, 1);
    most = std::max(most, worst(balance));
  }
  return most;
}

/// A string along a line whose stiffness falls from 199 at 0 to 1 at 1 and stays: cells [0, 1] and [1, 2] are
/// springs of stiffness 100 and 1, and between them is the mass 1.
struct TwoSprings {
  template <class T>
  T operator()(Jet<T, 1, 1> const& j) const {
    T const k = j.x[1] < T(1) ? T(199) - j.x[1] * 198.0 : T(1), strain = j.v(0, 1) - T(1);
    return (j.v(0, 0) * j.v(0, 0) - k * strain * strain) * 0.5;
  }
};
/// How far the mass between two springs goes until time 100, with ends held and a step of the soft spring, if
/// it begins at a distance of one hundredth.
double farthest_between_springs(double soft_step) {
  auto run = asynchronous_steps<1>(
      TwoSprings{}, box_mesh({0}, {2}, {2}), {0.005, soft_step},
      Level<double, 1>{Matrix<double, 1, 1>(0.0), Matrix<double, 1, 1>(1.01), Matrix<double, 1, 1>(2.0)},
      Level<double, 1>(3, Matrix<double, 1, 1>(0.0)), {1, 0, 1});
  double most = 0;
  while (run.next().time < 100) most = std::max(most, std::abs(run.place(1, run.step().time)[0] - 1));
  return most;
}

/// What a corner carries before and after an event: the form on two first variations, by its two products.
struct Passage {
  int node;
  std::array<double, 2> before, after;
};

}  // namespace

BOOST_AUTO_TEST_CASE(equal_steps_on_segments_are_the_synchronous_scheme) {
  // The generic implementation takes the same discrete Lagrangian, another way.
  auto const density = gas<double, 1>();
  double const h = 0.01;
  int const steps = 40;
  SpaceTimeMesh<double, 1> const other(
      equal_steps(0.0, h, steps), {8}, all_sides<1>(Side::free),
      StraightBox<double, 1>{Matrix<double, 1, 1>(0.0), Matrix<double, 1, 1>(1.0)});
  auto const mesh = box_mesh({0}, {1}, {8});
  Level<double, 1> places, velocities;
  for (auto const& X : mesh.nodes) {
    places.emplace_back(X[0] + 0.1 * X[0] * X[0]);
    velocities.emplace_back(0.3 - 0.2 * X[0]);
  }
  DiscreteSection<double, 1, 1> section{{places}};
  first_step(density, other, section, velocities);
  run(density, other, section);
  auto events = asynchronous_steps<1>(density, mesh, std::vector<double>(8, h), places, velocities);
  events.run((steps - 0.5) * h);
  BOOST_TEST(events.events() == 8 * steps);
  double apart = 0;
  for (int node = 0; node < 9; ++node)
    apart = std::max(apart, std::abs(events.place(node, steps * h)[0] - section(steps, node)[0]));
  BOOST_TEST_MESSAGE("equal steps beside the generic implementation: " << apart);
  // Places near one, rounded twice in each step.
  BOOST_TEST(apart < 2 * steps * epsilon<double>());
}

BOOST_AUTO_TEST_CASE(every_event_balances_linear_and_angular_momentum) {
  Draw draw(1);
  auto const plate = graded_plate();
  auto const solid2 = uneven_solid<2>();
  auto const start2 = disturbed<2>(plate, draw, 0.01);
  auto flat = asynchronous_steps<2>(solid2, plate, steps_of(solid2, plate, start2, 0.5), start2.places,
                                    start2.velocities);
  auto const total = [&](double time) {
    Momenta<2> sums{};
    for (int node = 0; node < int(plate.nodes.size()); ++node) add_momenta<2>(sums, flat, node, time, 1);
    return sums;
  };
  auto const at_start = total(0);
  double const before = flat.energy(0), in_plane = worst_event<2>(flat, 60);
  auto at_end = total(60);
  for (int i = 0; i < 3; ++i) at_end[i].add(-at_start[i].sum);
  double const drift = worst(at_end), energy = flat.energy(60) / before - 1;

  auto const block = cut_into_simplices(box_mesh({0, 0, 0}, {1, 1, 2}, {2, 2, 3}));
  auto const solid3 = solid<double, 3>();
  auto const start3 = disturbed<3>(block, draw, 0.01);
  auto full = asynchronous_steps<3>(solid3, block, steps_of(solid3, block, start3, 0.5), start3.places,
                                    start3.velocities);
  double const in_space = worst_event<3>(full, 2);
  BOOST_TEST_MESSAGE("asynchronous steps: " << flat.events() << " events in the plane, momenta at an event "
                                            << in_plane << ", in all " << drift << ", energy " << energy
                                            << "; " << full.events() << " events in space, " << in_space);
  BOOST_TEST(flat.events() > 10000);
  BOOST_TEST(in_plane <= 1e-14);
  BOOST_TEST(in_space <= 1e-14);
  BOOST_TEST(drift <= 1e-14);
  BOOST_TEST(std::abs(energy) < 1e-2);
}

BOOST_AUTO_TEST_CASE(regions_of_events_balance_the_multisymplectic_form) {
  Draw draw(2);
  auto const mesh = graded_plate();
  auto const density = uneven_solid<2>();
  auto const start = disturbed<2>(mesh, draw, 0.01);
  auto const steps = steps_of(density, mesh, start, 0.5);
  auto const varied_run = [&] {
    Level<Dual<double>, 2> x, v;
    for (std::size_t k = 0; k < mesh.nodes.size(); ++k) {
      x.push_back(moved_along(start.places[k], draw.vector<double, Matrix<double, 2, 1>>(2)));
      v.push_back(moved_along(start.velocities[k], draw.vector<double, Matrix<double, 2, 1>>(2)));
    }
    return asynchronous_steps<2>(density, mesh, steps, x, v);
  };
  auto V = varied_run(), W = varied_run();
  // The two products of the form m (dv_V . dx_W - dv_W . dx_V) at a node.
  auto const form_at = [&](int node, double time) {
    auto const product = [&](auto const& p, auto const& q) {
      return rate_of(p.velocity(node)).dot(rate_of(q.place(node, time))) * p.mass(node);
    };
    return std::array<double, 2>{product(V, W), -product(W, V)};
  };
  struct Happening {
    decltype(V.next()) event;
    std::vector<Passage> corners;
  };
  std::vector<Happening> all;
  while (V.next().time <= 2) {
    Happening here{V.next(), {}};
    for (int node : V.corners(here.event.cell))
      here.corners.push_back({node, form_at(node, here.event.time), {}});
    V.step(), W.step();
    for (auto& corner : here.corners) corner.after = form_at(corner.node, here.event.time);
    all.push_back(here);
  }
  // A region: the events of a part of the cells in an interval of time. Its boundary on the line of a node
  // are the ends of each run of events that belong to it.
  auto const balance = [&](auto const& inside) {
    SumOfTerms<double, double> sum{0};
    std::vector<Passage const*> last(mesh.nodes.size(), nullptr);
    auto const add = [&](std::array<double, 2> const& products, double sign) {
      for (double x : products) sum.add(sign * x);
    };
    for (auto const& here : all)
      for (auto const& corner : here.corners) {
        auto& open = last[corner.node];
        if (!inside(here.event)) {
          if (open) add(open->after, 1);
          open = nullptr;
        } else {
          if (!open) add(corner.before, -1);
          open = &corner;
        }
      }
    for (auto const* open : last)
      if (open) add(open->after, 1);
    return sum;
  };
  auto const part = [&] { return std::abs(draw.number<double>()); };
  double most = 0, control = 1;
  for (int k = 0; k < 200; ++k) {
    double const from = 2 * part(), until = from + (2 - from) * part();
    std::vector<bool> chosen(mesh.cells.size());
    for (std::size_t c = 0; c < chosen.size(); ++c) chosen[c] = part() < 0.5;
    auto const inside = [&](auto const& event) {
      return event.time >= from && event.time <= until && chosen[event.cell];
    };
    auto const sum = balance(inside);
    if (sum.terms > 0) most = std::max(most, std::abs(sum.sum) / sum.terms);
  }
  // An event of which one corner is left out balances nothing.
  for (std::size_t k = all.size() / 2; k < all.size(); ++k) {
    auto const& corner = all[k].corners[0];
    double const jump = corner.after[0] + corner.after[1] - corner.before[0] - corner.before[1];
    control = std::min(control, std::abs(jump) / (std::abs(corner.after[0]) + std::abs(corner.after[1])));
  }
  BOOST_TEST_MESSAGE("asynchronous steps: form on 200 regions " << most << " (control " << control << ")");
  BOOST_TEST(most <= 1e-15);
  BOOST_TEST(control > 1e-9);
}

BOOST_AUTO_TEST_CASE(on_a_mesh_with_size_ratio_ten_most_work_of_equal_steps_is_saved) {
  auto const mesh = graded_plate();
  auto const density = uneven_solid<2>();
  Draw draw(3);
  auto const start = disturbed<2>(mesh, draw, 0);
  auto const steps = steps_of(density, mesh, start, 0.5);
  auto const [least, most] = std::minmax_element(steps.begin(), steps.end());
  auto run = asynchronous_steps<2>(density, mesh, steps, start.places, start.velocities);
  double const until = 20;
  run.run(until);
  double const synchronous = double(mesh.cells.size()) * std::floor(until / *least + 1),
               gain = synchronous / run.events();
  BOOST_TEST_MESSAGE("asynchronous steps: steps differ by " << *most / *least << ", " << run.events()
                                                            << " events instead of " << synchronous
                                                            << ", gain " << gain);
  // Eight columns of 24 are narrow, and their widths go down evenly on a logarithmic scale: with steps as the
  // narrower side of a cell the gain is above five. The other side is of length one, which makes the longest
  // steps shorter by a half at most.
  BOOST_TEST(*most / *least > 4);
  BOOST_TEST(gain > 3);
}

BOOST_AUTO_TEST_CASE(places_are_of_second_order_in_the_steps) {
  auto const mesh = graded_plate();
  auto const density = uneven_solid<2>();
  Level<double, 2> places, velocities;
  for (auto const& X : mesh.nodes) {
    places.emplace_back(X[0], X[1]);
    velocities.emplace_back(0.1 * std::sin(0.3 * X[0]), 0.1 * std::cos(X[1]));
  }
  auto const longest = longest_steps<2, 2>(density, mesh, places);
  double const until = 2;
  auto const at_end = [&](int refined) {
    std::vector<double> steps;
    for (double h : longest) steps.push_back(until / (std::ceil(until / (0.9 * h)) * refined));
    auto run = asynchronous_steps<2>(density, mesh, steps, places, velocities);
    while (run.next().time < until * (1 - 1e-9)) run.step();
    Level<double, 2> x;
    for (int node = 0; node < int(mesh.nodes.size()); ++node) x.push_back(run.place(node, until));
    return x;
  };
  auto const finest = at_end(16);
  std::array<double, 3> error{};
  for (int k = 0; k < 3; ++k) {
    auto const x = at_end(1 << k);
    for (std::size_t node = 0; node < x.size(); ++node)
      error[k] = std::max(error[k], (x[node] - finest[node]).norm());
  }
  double const first = std::log2(error[0] / error[1]), second = std::log2(error[1] / error[2]);
  BOOST_TEST_MESSAGE("asynchronous steps: errors " << error[0] << ", " << error[1] << ", " << error[2]
                                                   << ", orders " << first << ", " << second);
  // Measured by the finest steps, of one sixteenth, a scheme of order two has log2(255/63) = 2.02 and
  // log2(63/15) = 2.07.
  BOOST_TEST(std::abs(first - 2) < 0.2);
  BOOST_TEST(std::abs(second - 2) < 0.2);
}

BOOST_AUTO_TEST_CASE(kicks_at_half_the_period_of_a_fast_neighbour_pump_it) {
  // The stiff spring alone turns phase space by 10 h between kicks of the soft one. With 10 h = pi - d the
  // map from kick to kick has the trace -2 cos d - (h/10) sin d, below -2 for 0 < d < h/10. At half of that,
  // d = 0.0157, what grows of the motion does so by the factor exp(0.0157) with each of 320 kicks, in all by
  // 150, but for what the step of the stiff spring changes of its frequency, in the fourth digit.
  double const pumped = farthest_between_springs((std::numbers::pi - 0.0157) / 10),
               quiet = farthest_between_springs(0.25);
  BOOST_TEST_MESSAGE("asynchronous steps: at a resonance " << pumped / 0.01 << " times as far, beside it "
                                                           << quiet / 0.01);
  BOOST_TEST(pumped > 0.3);
  BOOST_TEST(quiet < 0.015);
}

BOOST_AUTO_TEST_CASE(sides_are_held_and_what_cannot_be_stepped_is_refused) {
  auto const mesh = cut_into_simplices(box_mesh({0, 0}, {1, 1}, {2, 2}));
  auto const density = uneven_solid<2>();
  Draw draw(4);
  auto const start = disturbed<2>(mesh, draw, 0);
  auto const longest = longest_steps<2, 2>(density, mesh, start.places);
  auto const make = [&](BodyMesh const& body, std::vector<double> const& steps, auto const& places,
                        std::vector<unsigned> const& held) {
    return asynchronous_steps<2>(density, body, steps, places, start.velocities, held);
  };
  auto const steps = steps_of(density, mesh, start, 0.9);
  std::vector<unsigned> held(9, 0);
  held[0] = 3, held[1] = 2;
  auto run = make(mesh, steps, start.places, held);
  run.run(0.3);
  BOOST_TEST((run.velocity(0) == start.velocities[0]));
  BOOST_TEST(run.velocity(1)[1] == start.velocities[1][1]);
  BOOST_TEST(run.velocity(1)[0] != start.velocities[1][0]);

  auto too_long = steps;
  too_long[5] = 1.2 * longest[5];
  BOOST_CHECK_EXCEPTION(make(mesh, too_long, start.places, {}), StepTooLong, [&](StepTooLong const& e) {
    return e.measured == too_long[5] && e.largest_step == longest[5] &&
           std::string(e.what()).find("cell 5") != std::string::npos;
  });
  too_long[5] = -1;
  CHECK_REFUSED(make(mesh, too_long, start.places, {}), OutsideDomain);
  too_long[5] = std::nan("");
  CHECK_REFUSED(make(mesh, too_long, start.places, {}), OutsideDomain);
  CHECK_REFUSED(make(mesh, std::vector<double>(7, 0.01), start.places, {}), OutsideDomain);
  CHECK_REFUSED(make(mesh, steps, Level<double, 2>(8), {}), OutsideDomain);
  CHECK_REFUSED(make(mesh, steps, start.places, std::vector<unsigned>(3, 0)), OutsideDomain);
  CHECK_REFUSED(make(box_mesh({0, 0}, {1, 1}, {2, 2}), std::vector<double>(4, 0.01), start.places, {}),
                NotABodyMesh);
}
