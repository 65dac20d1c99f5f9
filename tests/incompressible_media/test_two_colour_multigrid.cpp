// The multigrid solver of incompressible media against Cholesky's factors of the dense matrix, which is
// assembled here from its definition.
#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "actio/incompressible_media/two_colour_multigrid.hpp"
#include "actio/numbers/errors.hpp"
#include "actio/parallel/thread_ranks.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::media;

namespace {

using Pressures = Eigen::VectorXd;
using Position = Eigen::Vector2d;

/// A box of cells of length 1, moved by a map that repeats with the box along periodic directions.
struct Box {
  std::array<int, 2> cells;
  std::string walls = "";  ///< of left, right, below, above those along which nodes slide
  std::function<Position(Position const&)> map = [](Position const& X) { return X; };
  std::array<bool, 2> periodic{};

  /// S = G M^-1 Pi G^T from the areas 1/2 d1 x d2 of the cells.
  Eigen::MatrixXd matrix() const {
    int const n0 = cells[0], n1 = cells[1];
    std::array const nodes{periodic[0] ? n0 : n0 + 1, periodic[1] ? n1 : n1 + 1};
    auto const node = [&](int i, int j) { return (j % nodes[1]) * nodes[0] + i % nodes[0]; };
    auto const wall = [&](char side) { return walls.find(side) != std::string::npos; };
    Pressures mass = Pressures::Zero(nodes[0] * nodes[1]);
    Eigen::MatrixXd G = Eigen::MatrixXd::Zero(n0 * n1, 2 * mass.size());
    constexpr int corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int j = 0; j < n1; ++j)
      for (int i = 0; i < n0; ++i)
        for (std::size_t a = 0; a < 4; ++a) {
          auto const at = [&](std::size_t b) {
            return map(Position(i + corners[b % 4][0], j + corners[b % 4][1]));
          };
          Position const d = at(a + 1) - at(a + 3);
          int const v = node(i + corners[a][0], j + corners[a][1]);
          mass[v] += 0.25;
          G(i + n0 * j, 2 * v) += d.y() / 2, G(i + n0 * j, 2 * v + 1) -= d.x() / 2;
        }
    for (int j = 0; j < nodes[1]; ++j)
      for (int i = 0; i < nodes[0]; ++i) {
        int const v = node(i, j);
        bool const across = (i == 0 && wall('l')) || (i == n0 && wall('r')),
                   along = (j == 0 && wall('b')) || (j == n1 && wall('a'));
        G.col(2 * v) *= across ? 0 : 1 / std::sqrt(mass[v]);
        G.col(2 * v + 1) *= along ? 0 : 1 / std::sqrt(mass[v]);
      }
    return G * G.transpose();
  }
};

/// The same entries as the solver takes them; the rest is zero.
NinePointMatrix nine_points(Box const& box, Eigen::MatrixXd const& S) {
  NinePointMatrix m(box.cells, box.periodic);
  for (int j = 0; j < box.cells[1]; ++j)
    for (int i = 0; i < box.cells[0]; ++i) {
      auto const k = m.at(i, j);
      auto const entry = [&](int x, int y) {
        return m.holds(i + x, j + y)
                   ? S(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(m.at(i + x, j + y)))
                   : 0;
      };
      m.self[k] = entry(0, 0), m.east[k] = entry(1, 0), m.north[k] = entry(0, 1);
      m.north_east[k] = entry(1, 1), m.north_west[k] = entry(-1, 1);
    }
  return m;
}

Pressures random_vector(Eigen::Index size) {
  std::mt19937 draw(7);
  std::uniform_real_distribution<> uniform(-1, 1);
  return Pressures::NullaryExpr(size, [&] { return uniform(draw); });
}
Pressures applied(TwoColourMultigrid& solver, Pressures const& r) {
  Pressures delta(r.size());
  solver.apply(r.data(), delta.data());
  return delta;
}
double energy_norm(Eigen::MatrixXd const& S, Pressures const& e) {
  return std::sqrt(std::max(0.0, e.dot(S * e)));
}

/// Stretched by 1.6, sheared by a half and wavy, of area 1.
Box stretched(int n0, int n1) {
  double const length = std::max(n0, n1);
  return {{n0, n1}, "", [length](Position const& X) {
            double const y = X.y() / 1.6;
            Position z(1.6 * X.x() + 0.5 * y, y);
            z.x() += 0.05 * length * std::sin(2 * z.y() / length);
            z.y() += 0.05 * length * std::sin(3 * z.x() / length);
            return z;
          }};
}
/// Moved by the vortex of the Taylor-Green flow within its walls; areas are those of the mesh and not exact.
Box stirred(int n0, int n1, std::string const& walls) {
  Position const k(std::numbers::pi / n0, std::numbers::pi / n1);
  return {{n0, n1}, walls, [k](Position X) {
            for (int step = 0; step < 15; ++step) {
              Position const at(k.x() * X.x(), k.y() * X.y());
              X += 0.01 * Position(std::sin(at.x()) * std::cos(at.y()) / k.x(),
                                   -std::cos(at.x()) * std::sin(at.y()) / k.y());
            }
            return X;
          }};
}

/// What is asked of a box: that each cycle multiplies the energy norm of the error by this at most. Conjugate
/// gradients then take a number of cycles that follows from the condition number 1/(1 - factor).
struct Demand {
  char const* name;
  Box box;
  double factor;
};
std::vector<Demand> demands() {
  return {{"undeformed", {{32, 32}}, 0.4},
          {"undeformed, odd", {{31, 17}}, 0.4},
          {"undeformed, long", {{6, 130}}, 0.4},
          {"undeformed, flat", {{130, 6}}, 0.4},
          {"undeformed, periodic", {{24, 20}, "", [](Position const& X) { return X; }, {true, false}}, 0.4},
          {"undeformed, periodic across",
           {{19, 16}, "", [](Position const& X) { return X; }, {false, true}},
           0.4},
          {"stretched", stretched(32, 32), 0.8},
          {"stretched, odd", stretched(27, 38), 0.8},
          {"closed", stirred(32, 32, "lrba"), 0.8},
          {"closed, odd", stirred(25, 33, "lrba"), 0.8},
          {"tank", stirred(32, 32, "lrb"), 0.8},
          {"channel", stirred(29, 32, "ba"), 0.8}};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(two_colour_multigrid)

BOOST_AUTO_TEST_CASE(a_product_is_that_of_the_assembled_matrix) {
  for (auto const& demand : demands()) {
    Eigen::MatrixXd const S = demand.box.matrix();
    auto const m = nine_points(demand.box, S);
    Pressures const x = random_vector(S.rows()), b = x.reverse();
    Pressures out(x.size());
    m.product(x.data(), out.data());
    // Nine terms, each of which rounds.
    double const bound = 20 * std::numeric_limits<double>::epsilon() * S.cwiseAbs().maxCoeff() * 9;
    BOOST_CHECK_LE((out - S * x).cwiseAbs().maxCoeff(), bound);
    out = b;
    m.residual(out.data(), x.data(), out.data());
    BOOST_CHECK_LE((out - (b - S * x)).cwiseAbs().maxCoeff(), bound);
  }
}

BOOST_AUTO_TEST_CASE(each_cycle_reduces_the_error_and_all_lead_to_the_solution_of_cholesky) {
  for (auto const& demand : demands()) {
    Eigen::MatrixXd const S = demand.box.matrix();
    bool const closed = demand.box.walls.size() == 4;
    TwoColourMultigrid solver;
    solver.build(nine_points(demand.box, S));
    Pressures r = random_vector(S.rows());
    if (closed) r.array() -= r.mean();
    // Constants, which a closed box leaves open, are fixed by the mean.
    Eigen::MatrixXd const definite =
        closed ? (S.array() + S(0, 0) / static_cast<double>(S.rows())).matrix() : S;
    Pressures const exact = definite.llt().solve(r);
    double const size = energy_norm(S, exact);
    Pressures x = Pressures::Zero(r.size());
    double before = size, worst = 0;
    int cycles = 0;
    for (; before > 1e-10 * size && cycles < 150; ++cycles) {
      x += applied(solver, r - S * x);
      double const after = energy_norm(S, exact - x);
      worst = std::max(worst, after / before), before = after;
    }
    BOOST_TEST_MESSAGE(demand.name << ": " << cycles << " cycles, energy norm times at most " << worst);
    BOOST_CHECK_LE(worst, demand.factor);
    BOOST_CHECK_LE(energy_norm(S, exact - x), 1e-10 * size);
    BOOST_CHECK_LE((exact - x).norm(), 1e-8 * exact.norm());
  }
}

BOOST_AUTO_TEST_CASE(a_cycle_for_undeformed_cells_is_none_for_stretched_ones) {
  Box const box = stretched(32, 32), at_rest{{32, 32}};
  Eigen::MatrixXd const S = box.matrix();
  TwoColourMultigrid solver;
  solver.build(nine_points(at_rest, at_rest.matrix()));
  Pressures error = random_vector(S.rows());
  double worst = 0;
  for (int cycle = 0; cycle < 10; ++cycle) {
    double const before = energy_norm(S, error);
    error -= applied(solver, S * error);
    worst = std::max(worst, energy_norm(S, error) / before);
  }
  BOOST_CHECK_GT(worst, 1);
}

BOOST_AUTO_TEST_CASE(conjugate_gradients_take_the_cycles_that_follow_from_the_factor) {
  for (auto const& demand : demands()) {
    Eigen::MatrixXd const S = demand.box.matrix();
    bool const closed = demand.box.walls.size() == 4;
    TwoColourMultigrid solver;
    solver.build(nine_points(demand.box, S));
    Pressures exact = random_vector(S.rows());
    if (closed) exact.array() -= exact.mean();
    Pressures r = S * exact, x = Pressures::Zero(r.size()), p;
    // |e_k| <= 2 q^k |e_0| with q = (sqrt(c) - 1)/(sqrt(c) + 1), c = 1/(1 - factor).
    double const root = 1 / std::sqrt(1 - demand.factor), size = energy_norm(S, exact);
    int const most = static_cast<int>(std::ceil(std::log(2e8) / std::log((root + 1) / (root - 1))));
    int cycles = 0;
    for (double last = 0; energy_norm(S, exact - x) > 1e-8 * size && cycles <= most; ++cycles) {
      Pressures const z = applied(solver, r);
      double const now = r.dot(z);
      p = cycles == 0 ? z : Pressures(z + now / last * p);
      last = now;
      Pressures const q = S * p;
      double const length = now / p.dot(q);
      x += length * p, r -= length * q;
    }
    BOOST_TEST_MESSAGE(demand.name << ": " << cycles << " cycles for eight digits, bound " << most);
    BOOST_CHECK_LE(cycles, most);
  }
}

BOOST_AUTO_TEST_CASE(a_cycle_is_symmetric_and_positive) {
  for (auto const& demand : demands()) {
    Eigen::MatrixXd const S = demand.box.matrix();
    TwoColourMultigrid solver;
    solver.build(nine_points(demand.box, S));
    Pressures r = random_vector(S.rows()), s = r.reverse();
    Pressures const Br = applied(solver, r), Bs = applied(solver, s);
    // Single precision, in sums of so many numbers.
    double const bound = 16 * std::numeric_limits<float>::epsilon() * std::sqrt(r.dot(Br) * s.dot(Bs));
    BOOST_CHECK_LE(std::abs(s.dot(Br) - r.dot(Bs)), bound);
    BOOST_CHECK_GT(r.dot(Br), 0);
  }
}

BOOST_AUTO_TEST_CASE(a_pinned_cell_has_the_pressure_of_its_equation_and_costs_no_cycles) {
  Box const box = stirred(21, 24, "lrba");
  Eigen::MatrixXd S = box.matrix();
  for (Eigen::Index const cell : {Eigen::Index(0), Eigen::Index(217)}) {
    Eigen::MatrixXd pinned = S;
    pinned(cell, cell) *= 2;
    TwoColourMultigrid solver;
    solver.build(nine_points(box, pinned));
    // With a sum: the pressure of the pinned cell is not zero.
    Pressures const r = random_vector(S.rows()), exact = pinned.llt().solve(r);
    Pressures x = Pressures::Zero(r.size());
    double before = energy_norm(pinned, exact), worst = 0;
    for (double const size = before; before > 1e-10 * size && worst < 1;) {
      x += applied(solver, r - pinned * x);
      double const after = energy_norm(pinned, exact - x);
      worst = std::max(worst, after / before), before = after;
    }
    BOOST_CHECK_LE(worst, 0.8);
    BOOST_CHECK_LE((exact - x).norm(), 1e-8 * exact.norm());
  }
}

BOOST_AUTO_TEST_CASE(units_change_no_bit_and_registers_no_more_than_the_last_digits) {
  Box const box = stretched(37, 20);
  Eigen::MatrixXd const S = box.matrix();
  Pressures const r = random_vector(S.rows());
  TwoColourMultigrid solver, scaled;
  solver.build(nine_points(box, S));
  scaled.build(nine_points(box, 0x1p-200 * S));
  Pressures const x = applied(solver, r);
  BOOST_CHECK(applied(scaled, 0x1p-300 * r) == 0x1p-100 * x);
  for (auto const registers : usable_registers()) {
    TwoColourMultigrid other(registers);
    other.build(nine_points(box, S));
    BOOST_CHECK_LE((applied(other, r) - x).norm(), 100 * std::numeric_limits<float>::epsilon() * x.norm());
  }
  // A hierarchy that was another one before, and a result in the place of the right side.
  solver.build(nine_points({{40, 9}}, Box{{40, 9}}.matrix()));
  solver.build(nine_points(box, S));
  Pressures in_place = r;
  solver.apply(in_place.data(), in_place.data());
  BOOST_CHECK(in_place == x);
}

BOOST_AUTO_TEST_CASE(ranks_change_no_bit) {
  Box ring = {{13, 64}}, wide = {{24, 64}}, tube = {{24, 64}, "l"};
  ring.periodic = wide.periodic = tube.periodic = {false, true};
  double const none = std::numeric_limits<double>::quiet_NaN();
  for (Box const& box : {stretched(19, 73), stirred(20, 68, "lrba"), Box{{7, 66}, "b"}, ring, wide, tube}) {
    Eigen::MatrixXd const S = box.matrix();
    NinePointMatrix const whole = nine_points(box, S);
    Pressures r = random_vector(S.rows());
    r.array() -= r.mean();
    TwoColourMultigrid alone;
    alone.build(whole);
    Pressures const x = applied(alone, r);
    for (int const count : {2, 3, 4}) {
      BOOST_CHECK(TwoColourMultigrid::can_be_shared(box.cells[1], count));
      on_thread_ranks(count, [&](Ranks& ranks) {
        RowShare const rows(&ranks, box.cells[1], box.periodic[1]);
        auto const inside = [&](int beyond) {
          std::vector<char> out(whole.size());
          for_each(rows.with(beyond, beyond, box.cells[0]), [&](std::size_t k) { out[k] = true; });
          return out;
        };
        // What a rank does not have.
        NinePointMatrix mine = whole;
        Pressures given = r;
        auto const seen = inside(3), near = inside(1), own = inside(0);
        for (std::size_t k = 0; k < seen.size(); ++k) {
          if (!near[k]) given[static_cast<Eigen::Index>(k)] = none;
          if (seen[k]) continue;
          for (auto* part : {&mine.self, &mine.east, &mine.north, &mine.north_east, &mine.north_west})
            (*part)[k] = none;
        }
        TwoColourMultigrid shared(best_registers(), rows);
        for (int again = 0; again < 2; ++again) shared.build(mine);
        Pressures const found = applied(shared, given);
        bool same = true;
        for (std::size_t k = 0; k < near.size(); ++k)
          same = same && (!near[k] || found[static_cast<Eigen::Index>(k)] == x[static_cast<Eigen::Index>(k)]);
        BOOST_CHECK_MESSAGE(same, "other bits on " << count << " ranks, " << box.cells[0] << " x "
                                                   << box.cells[1] << ", rank " << ranks.rank());
      });
    }
  }
}

BOOST_AUTO_TEST_CASE(small_boxes_are_solved_at_once) {
  for (auto const cells : {std::array{2, 2}, {2, 9}, {9, 2}, {5, 4}}) {
    Box const box = {cells};
    Eigen::MatrixXd const S = box.matrix();
    TwoColourMultigrid solver;
    solver.build(nine_points(box, S));
    Pressures const r = random_vector(S.rows()), exact = S.llt().solve(r);
    // The right side and the solution are rounded to single precision.
    double const condition = S.norm() * S.inverse().norm();
    BOOST_CHECK_LE((applied(solver, r) - exact).norm(),
                   (1 + condition) * std::numeric_limits<float>::epsilon() * exact.norm());
  }
}

BOOST_AUTO_TEST_CASE(what_cannot_be_coarsened_or_solved_is_refused) {
  BOOST_CHECK(TwoColourMultigrid::can_be_coarsened({2, 7}, {false, false}));
  BOOST_CHECK(TwoColourMultigrid::can_be_coarsened({12, 7}, {true, false}));
  BOOST_CHECK(!TwoColourMultigrid::can_be_coarsened({13, 7}, {true, false}));
  BOOST_CHECK(!TwoColourMultigrid::can_be_coarsened({8, 14}, {false, true}));
  BOOST_CHECK(!TwoColourMultigrid::can_be_coarsened({1, 8}, {false, false}));
  TwoColourMultigrid solver;
  CHECK_REFUSED(solver.build(NinePointMatrix({13, 7}, {true, false})), OutsideDomain);
  CHECK_REFUSED(solver.build(NinePointMatrix({1, 7})), OutsideDomain);
  CHECK_REFUSED(solver.build(NinePointMatrix({6, 7})), OutsideDomain);
  Box const box{{12, 9}};
  auto matrix = nine_points(box, box.matrix());
  solver.build(matrix);
  Pressures r = random_vector(12 * 9);
  r[50] = std::nan("");
  BOOST_CHECK(applied(solver, r).array().isNaN().all());
  r.setZero();
  BOOST_CHECK(applied(solver, r) == r);
  matrix.north[3] = std::nan("");
  CHECK_REFUSED(solver.build(matrix), NotFinite);
  // Even counts along two periodic directions: the two colours have a constant each.
  Box const torus{{16, 16}, "", [](Position const& X) { return X; }, {true, true}};
  CHECK_REFUSED(solver.build(nine_points(torus, torus.matrix())), Singular);
}

BOOST_AUTO_TEST_SUITE_END()
