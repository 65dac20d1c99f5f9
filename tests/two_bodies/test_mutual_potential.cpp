// The mutual potential: values known from elsewhere, sums over points, derivatives by dual numbers,
// invariance over the rationals; and the straight-line code of orders 2 and 4 against it.
#include <boost/test/unit_test.hpp>

#include "actio/groups/rotations.hpp"
#include "actio/numbers/derivative.hpp"
#include "didymos.hpp"
#include "refused.hpp"
#include "shapes.hpp"

using namespace actio;
using namespace actio::bodies;
using Eigen::Vector3d;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();

template <class S, class M>
std::array<Three<S>, 3> rows(M const& R) {
  std::array<Three<S>, 3> a;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) a[i][j] = S(R(i, j));
  return a;
}
template <class S>
Matrix<S, 3, 1> vector(Three<S> const& x) {
  return {x[0], x[1], x[2]};
}
template <class M>
auto three(M const& x) {
  return Three<typename M::Scalar>{x[0], x[1], x[2]};
}

/// Point masses, and their moments.
struct Points {
  std::vector<double> mass;
  std::vector<Vector3d> at;

  Points(std::mt19937& random, double size, int count) {
    std::uniform_real_distribution<double> side(-size, size), part(0.5, 1.5);
    Vector3d centre(0, 0, 0);
    double all = 0;
    for (int k = 0; k < count; ++k) {
      mass.push_back(part(random)), at.push_back({side(random), side(random), side(random)});
      centre += mass.back() * at.back(), all += mass.back();
    }
    for (auto& x : at) x -= centre / all;
  }
  double radius() const {
    double r = 0;
    for (auto const& x : at) r = std::max(r, x.norm());
    return r;
  }
  Moments<double> moments(int order) const {
    Moments<double> A(order);
    over_exponents(0, order, [&](int i, int j, int l) {
      double sum = 0;
      for (std::size_t k = 0; k < at.size(); ++k)
        sum += mass[k] * std::pow(at[k][0], i) * std::pow(at[k][1], j) * std::pow(at[k][2], l);
      A.set(i, j, l, sum);
    });
    return A;
  }
};
}  // namespace

BOOST_AUTO_TEST_SUITE(mutual_potential)

BOOST_AUTO_TEST_CASE(two_other_programs_have_the_same_potential_of_didymos) {
  // From F2BPtoolkit, a descendant of GUBAS, and from a prototype of the difference body; kg km^2/s^2.
  testing::Didymos const d;
  for (auto const& [order, known] : {std::pair{2, -107.5718429485042}, {4, -107.5761970065138}}) {
    auto const pair = d.pair(60, pair_splitting(), order);
    BOOST_TEST(std::abs(pair.potential() / 1e6 / known - 1) <= 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(the_series_converges_to_the_sum_over_points_at_its_rate) {
  std::mt19937 random(testing::seed);
  Points const a(random, 1, 6), b(random, 0.6, 5);
  Vector3d const r(3, -2, 2.5);
  Eigen::Matrix3d const R = testing::rotation_of<double>(2, -1, 3, 1);
  double sum = 0;
  Vector3d force(0, 0, 0), torque_1(0, 0, 0), torque_2(0, 0, 0);
  for (std::size_t k = 0; k < a.at.size(); ++k)
    for (std::size_t m = 0; m < b.at.size(); ++m) {
      Vector3d const lever = R * b.at[m], d = r + lever - a.at[k],
                     pull = -a.mass[k] * b.mass[m] * d / std::pow(d.norm(), 3);
      sum -= a.mass[k] * b.mass[m] / d.norm();
      force += pull, torque_2 += lever.cross(pull), torque_1 -= a.at[k].cross(pull);
    }
  double const ratio = (a.radius() + b.radius()) / r.norm();
  BOOST_TEST(ratio < 0.6);
  double const size = std::abs(sum);
  for (int order : {2, 4, 6, 8, 10, 12, 16}) {
    MutualPotential<double> const V(a.moments(order), b.moments(order), order, 1);
    auto const found = V({r[0], r[1], r[2]}, rows<double>(R));
    // What is cut off: a geometric series, whose derivative has (N + 2)/r for each term.
    double const left = std::pow(ratio, order + 1) / (1 - ratio), slopes = left * (order + 2) / (1 - ratio);
    BOOST_TEST_MESSAGE("order " << order << ": V off by " << std::abs(found.potential - sum) / size
                                << ", allowed " << left);
    BOOST_TEST(std::abs(found.potential - sum) <= left * size);
    BOOST_TEST((vector(found.force) - force).norm() <= slopes * size / r.norm());
    BOOST_TEST((vector(found.torque_2) - torque_2).norm() <= slopes * size);
    BOOST_TEST((vector(found.torque_1) - torque_1).norm() <= 2 * slopes * size);
  }
}

BOOST_AUTO_TEST_CASE(force_and_torques_are_the_derivatives_of_the_potential) {
  std::mt19937 random(testing::seed);
  using D = Moved<double>;
  auto const first = polyhedron_body(testing::drawn_octahedron<double>(random, 2), 3, 5).moments,
             second = polyhedron_body(testing::drawn_octahedron<double>(random, 1), 2, 5).moments;
  Eigen::Matrix3d const R = testing::rotation_of<double>(1, 2, 2, -1);
  Vector3d const r(4, -3, 2);
  for (int order : {2, 3, 4, 5}) {
    MutualPotential<double> const V(first, second, order, 0.7);
    MutualPotential<D> const moved(first.over<D>(), second.over<D>(), order, D(0.7));
    auto const all = V(three(r), rows<double>(R));
    // Along r; and with the rotation by the infinitesimal vector w from the left of R, or of both, seen from
    // the first body.
    auto const along = derivative(
        [&](auto const& x) {
          return moved({x[0], x[1], x[2]}, rows<D>(R)).potential;
        },
        Matrix<double, 3, 1>(r));
    auto const turn = [](auto const& w, auto const& x) {
      using T = std::decay_t<decltype(w[0])>;
      Three<T> const y{T(x[0]), T(x[1]), T(x[2])};
      return Matrix<T, 3, 1>(y[0] + w[1] * y[2] - w[2] * y[1], y[1] + w[2] * y[0] - w[0] * y[2],
                             y[2] + w[0] * y[1] - w[1] * y[0]);
    };
    auto const about = derivative(
        [&](auto const& w) {
          std::array<Three<D>, 3> turned;
          for (int k = 0; k < 3; ++k) {
            auto const column = turn(w, R.col(k));
            for (int i = 0; i < 3; ++i) turned[i][k] = column[i];
          }
          return moved({D(r[0]), D(r[1]), D(r[2])}, turned).potential;
        },
        Matrix<double, 3, 1>(0, 0, 0));
    // The first body is turned by w where all the rest is turned by -w.
    auto const rest = derivative(
        [&](auto const& w) {
          auto const back = (-w).eval();
          std::array<Three<D>, 3> turned;
          for (int k = 0; k < 3; ++k) {
            auto const column = turn(back, R.col(k));
            for (int i = 0; i < 3; ++i) turned[i][k] = column[i];
          }
          return moved(three(turn(back, r)), turned).potential;
        },
        Matrix<double, 3, 1>(0, 0, 0));
    double const size = std::abs(all.potential);
    BOOST_TEST(along.value == all.potential);
    BOOST_TEST((vector(all.force) + along.gradient()).norm() <= 200 * eps * size);
    BOOST_TEST((vector(all.torque_2) + about.gradient()).norm() <= 200 * eps * size);
    BOOST_TEST((vector(all.torque_1) + rest.gradient()).norm() <= 200 * eps * size);
    BOOST_TEST(vector(all.torque_2).norm() > 1e-4 * size);
  }
}

BOOST_AUTO_TEST_CASE(exchange_of_the_bodies_exchanges_the_torques_over_the_rationals) {
  // The torque on the first body is what invariance leaves of the other; as the second body of the exchanged
  // pair it has a series of its own.
  std::mt19937 random(testing::seed);
  auto const mesh = [&](int size) {
    auto const m = polyhedron_moments<rational>(testing::drawn_octahedron<rational>(random, size), 1, 5);
    return m.seen_from(m.centre());
  };
  auto const A = mesh(2), B = mesh(1);
  auto const R = testing::rotation_of<rational>(1, -2, 2, 3);
  Matrix<rational, 3, 1> const r(4, -8, 8);  // of length 12
  Matrix<rational, 3, 1> const back = (-(R.transpose() * r)).eval();
  for (int order = 0; order <= 5; ++order) {
    auto const one = MutualPotential<rational>(A, B, order, 1)(three(r), rows<rational>(R)),
               two = MutualPotential<rational>(B, A, order, 1)(three(back),
                                                               rows<rational>(R.transpose().eval()));
    BOOST_TEST((one.potential == two.potential));
    BOOST_TEST((vector(one.torque_1) == (R * vector(two.torque_2)).eval()));
    BOOST_TEST((vector(one.torque_2) == (R * vector(two.torque_1)).eval()));
    BOOST_TEST((vector(one.force) == (-(R * vector(two.force))).eval()));
    if (order >= 2) BOOST_TEST((vector(one.torque_1) != Matrix<rational, 3, 1>(0, 0, 0)));
  }
  // A control: the torque of one order less.
  auto const less = MutualPotential<rational>(B, A, 4, 1)(three(back), rows<rational>(R.transpose().eval()));
  auto const more = MutualPotential<rational>(A, B, 5, 1)(three(r), rows<rational>(R));
  BOOST_TEST((vector(more.torque_1) != (R * vector(less.torque_2)).eval()));
}

BOOST_AUTO_TEST_CASE(what_the_orders_leave_out_of_the_potential_of_didymos) {
  testing::Didymos const d(12);
  auto const value = [&](int order) { return d.pair(60, pair_splitting(), order).potential(); };
  double const truth = value(12);
  for (auto const& [order, left] : {std::pair{2, 4.1e-5}, {4, 6.8e-7}, {6, 1.4e-8}, {8, 3e-10}}) {
    double const off = std::abs(value(order) / truth - 1);
    BOOST_TEST_MESSAGE("order " << order << " leaves out " << off);
    BOOST_TEST((off > left / 2 && off < 2 * left));
  }
}

BOOST_AUTO_TEST_CASE(straight_line_code_agrees_with_the_general_class) {
  std::mt19937 random(testing::seed);
  std::normal_distribution<double> normal;
  auto const quaternion = [&] {
    Eigen::Vector4d const q =
        Eigen::Vector4d(normal(random), normal(random), normal(random), normal(random)).normalized();
    return Four<double>{q[0], q[1], q[2], q[3]};
  };
  testing::Didymos const d;
  auto const p = polyhedron_body(testing::drawn_octahedron<double>(random, 400), 2000, 4),
             q = polyhedron_body(testing::drawn_octahedron<double>(random, 90), 2000, 4);
  double worst = 0;
  auto const compare = [&](auto const& fast, ExtendedBody const& a, ExtendedBody const& b, int order) {
    AnyOrderForce const general(a, b, order, 1e-10);
    for (int trial = 0; trial < 20; ++trial) {
      Vector3d const X = Vector3d(normal(random), normal(random), normal(random)).normalized() * 1000;
      auto const q1 = quaternion(), q2 = quaternion();
      auto const one = fast(three(X), q1, q2), two = general(three(X), q1, q2);
      double const scale = 1e-10 * a.mass() * b.mass() / 1000;
      // The general class has the attraction as points in it, which is taken off: its rounding is of that
      // size, by some hundred terms.
      double const room = 100 * eps * scale;
      double const off = std::max({std::abs(one.potential - two.potential),
                                   1000 * (vector(one.force) - vector(two.force)).norm(),
                                   (vector(one.torque_1) - vector(two.torque_1)).norm(),
                                   (vector(one.torque_2) - vector(two.torque_2)).norm()});
      worst = std::max(worst, off / scale);
      BOOST_TEST(off <= room);
      BOOST_TEST(vector(two.torque_2).norm() > 100 * room);
    }
  };
  compare(SecondOrderForce(d.primary, d.moon, 1e-10), d.primary, d.moon, 2);
  compare(SecondOrderForce(p, q, 1e-10), p, q, 2);
  compare(FourthOrderForce<true>(d.primary, d.moon, 1e-10), d.primary, d.moon, 4);
  compare(FourthOrderForce<false>(d.primary, d.moon, 1e-10), d.primary, d.moon, 4);
  compare(FourthOrderForce<false>(p, q, 1e-10), p, q, 4);
  BOOST_TEST_MESSAGE("straight-line code: off by " << worst << " of G m1 m2/r");
}

BOOST_AUTO_TEST_CASE(orders_that_the_moments_do_not_have_are_refused) {
  auto const a = sphere_moments<double>(1, 1, 4), b = sphere_moments<double>(1, 1, 2);
  CHECK_REFUSED(MutualPotential<double>(a, b, 4, 1), OutsideDomain);
  CHECK_REFUSED(MutualPotential<double>(a, b, -1, 1), OutsideDomain);
}

BOOST_AUTO_TEST_SUITE_END()
