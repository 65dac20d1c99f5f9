// The move along the orbit by its definition: commutators with the spins column by column, the Newton step
// from whole matrices in double precision, and what the unit and the size of a move change.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/vorticity/orbit_move.hpp"
#include "flows.hpp"

using namespace actio;
using namespace actio::sphere;
using testing::random_matrix, testing::random_state;

namespace {

constexpr double single_unit = std::numeric_limits<float>::epsilon();

/// \f$[ie\cdot S, W]\f$ by products of whole matrices.
SkewHermitian<> turned(QuantizedSphere const& sphere, Eigen::Vector3d const& e, SkewHermitian<> const& w) {
  SkewHermitian<> sum(w.size());
  for (int j = 0; j < 3; ++j)
    sum +=
        e[j] * commutator(SkewHermitian<>(ComplexMatrix<>(std::complex<double>(0, 1) * sphere.spin(j))), w);
  return sum;
}
/// What is at most so far from the diagonal.
SkewHermitian<> near_diagonal(SkewHermitian<> w, Eigen::Index reach) {
  for (Eigen::Index c = 0; c < w.size(); ++c)
    for (Eigen::Index r = 0; r < w.size(); ++r)
      if (std::abs(r - c) > reach) w.real(r, c) = w.imaginary(r, c) = 0;
  return w;
}
std::vector<Eigen::Vector3d> const& coordinate_axes() {
  static std::vector<Eigen::Vector3d> const axes{Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(),
                                                 Eigen::Vector3d::UnitZ()};
  return axes;
}

/// The Newton step of \ref OrbitMove with whole matrices in double precision.
struct Twin {
  std::vector<SkewHermitian<>> x;  ///< X, of which parts are taken
  Eigen::VectorXd factors;
  SkewHermitian<> y;
  double condition = 0;  ///< of the Gram matrix in its units

  Twin(std::vector<SkewHermitian<>> parts, Eigen::VectorXd const& change, Eigen::VectorXd const& units)
      : x(std::move(parts)), y(x.front().size()) {
    Eigen::MatrixXd gram(change.size(), change.size());
    for (Eigen::Index i = 0; i < change.size(); ++i)
      for (Eigen::Index j = 0; j < change.size(); ++j)
        gram(i, j) = inner_product(x[static_cast<std::size_t>(i)], x[static_cast<std::size_t>(j)]) /
                     (units[i] * units[j]);
    Eigen::VectorXd const values = hermitian_values(gram);
    condition = values[values.size() - 1] / values[0];
    factors = regular_solution(gram, Eigen::VectorXd(change.cwiseQuotient(units)), 0).cwiseQuotient(units);
    for (Eigen::Index j = 0; j < change.size(); ++j) y += factors[j] * x[static_cast<std::size_t>(j)];
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(orbit_move)

BOOST_AUTO_TEST_CASE(columns_of_commutators_with_the_spins_are_those_of_whole_matrices) {
  std::vector<Eigen::Vector3d> const axes{
      {0.6, 0, -0.8}, {-1.0 / 3, 2.0 / 3, 2.0 / 3}, {0, 0, 1}, {0, -1, 0}};
  for (int n : {2, 3, 8, 17}) {
    QuantizedSphere const sphere(n);
    SkewHermitian<> const w = random_matrix(n);
    std::vector<SkewHermitian<>> truth;
    for (auto const& e : axes) truth.push_back(turned(sphere, e, w));
    SpinColumns<double> const spins(sphere, axes);
    for (Eigen::Index depth : {Eigen::Index(1), Eigen::Index(2), Eigen::Index(5), Eigen::Index(1000)}) {
      int columns = 0;
      double largest = 0;
      spins.over(
          w,
          [&](Eigen::Index c, auto const& pieces) {
            BOOST_TEST(c == columns++);
            BOOST_TEST(pieces.size() == axes.size());
            auto const rows = std::min(depth, n - c);
            for (std::size_t a = 0; a < pieces.size(); ++a) {
              BOOST_TEST((pieces[a].real.size() == rows && pieces[a].imaginary.size() == rows));
              Eigen::VectorXd const real = truth[a].real.col(c).segment(c, rows),
                                    imaginary = truth[a].imaginary.col(c).segment(c, rows);
              largest = std::max({largest, (pieces[a].real.matrix() - real).cwiseAbs().maxCoeff(),
                                  (pieces[a].imaginary.matrix() - imaginary).cwiseAbs().maxCoeff()});
            }
          },
          depth);
      BOOST_TEST(columns == n);
      // Four terms of size N/2, three times, against rows of a product.
      BOOST_TEST(largest <= 8e-15 * n);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_combination_is_added_to_what_is_there) {
  for (int n : {2, 3, 12}) {
    QuantizedSphere const sphere(n);
    SkewHermitian<> const w = random_matrix(n, 1), x0 = random_matrix(n, 2), before = random_matrix(n, 3);
    std::vector<Eigen::Vector3d> const axes{{0.6, 0, 0.8}, {0, 1, 0}};
    SpinColumns<double> const spins(sphere, axes), none(sphere, {});
    Eigen::VectorXd factors(3);
    factors << -1.5, 0.25, 3;
    SkewHermitian<> const by_turns = 0.25 * turned(sphere, axes[0], w) + 3.0 * turned(sphere, axes[1], w);
    SkewHermitian<> with_first = before, without = before, alone = before;
    add_combination(spins, &x0, w, factors, with_first);
    add_combination<double>(spins, nullptr, w, factors.tail(2), without);
    add_combination(none, &x0, w, factors, alone);
    double const bound = 4e-14 * n;
    BOOST_TEST(norm(with_first - (before + by_turns - 1.5 * x0)) <= bound * n);
    BOOST_TEST(norm(without - (before + by_turns)) <= bound * n);
    BOOST_TEST(norm(alone - (before - 1.5 * x0)) <= bound * n);
  }
}

// All four numbers at once, by a few diagonals and by the whole of Y; without an energy the factors are those
// of the Y that is taken.
BOOST_AUTO_TEST_CASE(a_newton_step_is_the_solution_with_the_matrix_of_inner_products) {
  int const n = 14;
  QuantizedSphere const sphere(n);
  SkewHermitian<> const w = random_state(n, 1, n - 1, 5), p = 0.3 * SphereLaplacian(n).solve(w);
  SkewHermitian<float> const w_single = w.cast<float>(), p_single = p.cast<float>();
  double const spin_scale = std::sqrt(sphere.spin_square());
  for (bool energy : {true, false})
    for (bool banded : {true, false}) {
      std::vector<SkewHermitian<>> x, parts;
      if (energy) x.push_back(commutator(p, w));
      for (auto const& e : coordinate_axes()) x.push_back(turned(sphere, e, w));
      for (auto const& whole : x) parts.push_back(near_diagonal(whole, OrbitMove<>::few_diagonals));
      auto const count = static_cast<Eigen::Index>(x.size());
      Eigen::VectorXd units = Eigen::VectorXd::Constant(count, spin_scale), change(count);
      if (energy) units[0] = norm(p);
      for (Eigen::Index j = 0; j < count; ++j) change[j] = (j % 2 == 0 ? 2e-3 : -1e-3) * (j + 1.0) * units[j];
      Twin const whole(x, change, units), few(parts, change, units);
      Twin const& taken = banded ? few : whole;
      Twin const& told = energy ? whole : taken;
      OrbitMove<> move(sphere, coordinate_axes());
      SingleCayley products;
      // Just longer than the Y on a few diagonals, or just shorter.
      double const longest = (banded ? 1.01 : 0.99) * norm(few.y);
      Eigen::VectorXd const factors =
          move.find(products, energy ? &p_single : nullptr, w_single, change, norm(p), longest);
      BOOST_TEST(move.is_banded() == banded);
      // Inner products of n^2 terms in single precision, and what their matrix amplifies.
      double const bound = 4 * n * single_unit * std::max(whole.condition, few.condition);
      BOOST_TEST(bound < 0.05);
      BOOST_TEST(factors.size() == count);
      BOOST_TEST((factors - told.factors).cwiseProduct(units).norm() <=
                 bound * told.factors.cwiseProduct(units).norm());
      BOOST_TEST(std::abs(move.length() / norm(taken.y) - 1) <= bound);
      SkewHermitian<> state = w;
      move.move(products, w_single, state);
      SkewHermitian<> const once = commutator(taken.y, w), by = once + 0.5 * commutator(taken.y, once);
      BOOST_TEST(norm(state - w - by) <= bound * norm(by));
      // The second order is seen.
      BOOST_TEST(norm(by - once) > 0);
    }
}

// Only the energy: no spin is asked for.
BOOST_AUTO_TEST_CASE(the_energy_is_taken_back_alone) {
  int const n = 9;
  QuantizedSphere const sphere(n);
  SkewHermitian<> const w = random_state(n, 1, n - 1, 6), p = SphereLaplacian(n).solve(w);
  SkewHermitian<float> const w_single = w.cast<float>(), p_single = p.cast<float>();
  Eigen::VectorXd const change = Eigen::VectorXd::Constant(1, 1e-3 * norm(p)),
                        units = Eigen::VectorXd::Constant(1, norm(p));
  for (bool banded : {true, false}) {
    SkewHermitian<> const x = commutator(p, w);
    Twin const whole({x}, change, units), few({near_diagonal(x, 2)}, change, units);
    OrbitMove<> move(sphere, {});
    SingleCayley products;
    Eigen::VectorXd const factors = move.find(products, &p_single, w_single, change, norm(p), banded ? 1 : 0);
    BOOST_TEST(move.is_banded() == banded);
    BOOST_TEST(std::abs(factors[0] / whole.factors[0] - 1) <= 8 * n * single_unit);
    BOOST_TEST(std::abs(move.length() / norm((banded ? few : whole).y) - 1) <= 8 * n * single_unit);
  }
}

// A flow with a fourfold axis has nothing on a few diagonals for a turn about it; the least move needs the
// whole Y as well. The unit of vorticity changes no digit.
BOOST_AUTO_TEST_CASE(neither_its_size_nor_the_unit_changes_what_a_move_does) {
  int const n = 16;
  QuantizedSphere const sphere(n);
  SphereHarmonics fourfold(n);
  fourfold(1, 0) = 1, fourfold(4, 4) = {1, 0.5}, fourfold(6, 4) = {-0.7, 1};
  for (bool symmetric : {false, true})
    for (double size : {1e-3, 1e-7, 1e-10}) {
      SkewHermitian<> const start = symmetric ? matrix_of(fourfold) : random_state(n, 1, 9);
      Eigen::Vector3d change = Eigen::Vector3d::Zero();
      change[2] = size * norm(spin_commutator(sphere, 2, start));
      std::vector<SkewHermitian<>> ends;
      for (double unit : {1.0, 0x1p-30, 0x1p30}) {
        SkewHermitian<> const from = unit * start;
        OrbitMove<> move(sphere, coordinate_axes());
        SingleCayley products;
        move.find(products, nullptr, from.cast<float>(), unit * change, 1, 1);
        SkewHermitian<> w = from;
        move.move(products, from.cast<float>(), w);
        BOOST_TEST(move.is_banded() == !symmetric);
        ends.push_back((1 / unit) * w);
      }
      for (auto const& end : ends)
        BOOST_TEST((end.real == ends[0].real && end.imaginary == ends[0].imaginary));
      // What Y changes is by its size smaller; and a rounding of W, in parts of the change.
      Eigen::Vector3d const left = spin_components(sphere, start) - spin_components(sphere, ends[0]) - change;
      double const rounding = n * std::numeric_limits<double>::epsilon() / size;
      BOOST_TEST(left.norm() <= (10 * size + 4 * n * single_unit + rounding) * change.norm());
    }
}

BOOST_AUTO_TEST_CASE(where_nothing_is_to_be_taken_back_nothing_moves) {
  int const n = 6;
  SkewHermitian<> const start = random_state(n, 1, n - 1);
  OrbitMove<> move(QuantizedSphere(n), coordinate_axes());
  SingleCayley products;
  Eigen::VectorXd const factors =
      move.find(products, nullptr, start.cast<float>(), Eigen::VectorXd::Zero(3), 1, 1e-3);
  SkewHermitian<> w = start;
  move.move(products, start.cast<float>(), w);
  BOOST_TEST((factors.norm() == 0 && move.length() == 0 && move.is_banded()));
  BOOST_TEST((w.real == start.real && w.imaginary == start.imaginary));
}

// Directions that are dependent, whatever the unit: the least solution, and nothing along what is cut off.
BOOST_AUTO_TEST_CASE(a_regular_solution_leaves_out_what_is_small_beside_the_largest) {
  for (double unit : {1.0, 0x1p-60, 0x1p60}) {
    Eigen::Vector3d const values(1, 0x1p-10, 0x1p-21), b(3, -2, 5);
    Eigen::MatrixXd const diagonal = unit * values.asDiagonal().toDenseMatrix();
    Eigen::VectorXd const x = regular_solution(diagonal, Eigen::VectorXd(unit * b), 0x1p-20);
    BOOST_TEST((x - Eigen::Vector3d(3, -2048, 0)).norm() <= 1e-11);
    // One that equals the cut-off is left out, too.
    BOOST_TEST(regular_solution(diagonal, Eigen::VectorXd(unit * b), 0x1p-10)[1] == 0);
    // Twice the same direction.
    Eigen::Matrix2d const same = Eigen::Matrix2d::Constant(unit);
    Eigen::VectorXd const half =
        regular_solution(Eigen::MatrixXd(same), Eigen::VectorXd(Eigen::Vector2d(unit, unit)), 1e-8);
    BOOST_TEST((half - Eigen::Vector2d(0.5, 0.5)).norm() <= 1e-14);
  }
}

BOOST_AUTO_TEST_SUITE_END()
