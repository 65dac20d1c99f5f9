// The generic implementation on an algebra told at run time is that on the types of the library; which
// matrices are elements.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/any_group/membership.hpp"
#include "actio/any_group/named_algebra.hpp"
#include "actio/reduction/momentum_step.hpp"
#include "witness/draw.hpp"

using namespace actio;
using namespace actio::systems;

namespace {

static_assert(MatrixGroup<SpanOfMatrices> && ExponentialGroup<SpanOfMatrices>);

using Square = Eigen::MatrixXd;
constexpr double eps = std::numeric_limits<double>::epsilon();
double const infinite = std::numeric_limits<double>::infinity();

SpanOfMatrices span_of(std::string const& name) { return SpanOfMatrices(named_algebra(name)); }
/// The algebra alone, as if the basis had been given.
MatrixAlgebra bare(std::string const& name) { return spanned_algebra(named_algebra(name).basis); }
double difference(Matrix<double> const& a, Matrix<double> const& b) {
  return row_norm(Matrix<double>(a - b));
}

/// All primitives against those of a type, at some velocities.
template <MatrixGroup G>
void agrees(std::string const& name, G const& group) {
  SpanOfMatrices const span = span_of(name);
  Draw draw(2);
  using V = Coordinates<G, double>;
  V const v = draw.vector<double>(group.dimension()) / 2, w = draw.vector<double>(group.dimension());
  Storage<G, double> const g = primitive::exp(group, v);
  Matrix<double> const h = g;
  Vector<double> const x = v, y = w;
  double const bound = 256 * eps * row_norm(h);
  BOOST_TEST_CONTEXT(name) {
    BOOST_TEST(difference(primitive::exp(span, x), h) < bound);
    BOOST_TEST(difference(primitive::log_of<SpanOfMatrices, double>(span, h), x) < bound);
    BOOST_TEST(difference(primitive::Ad(span, h, y), primitive::Ad(group, g, w)) < bound * row_norm(h));
    BOOST_TEST(difference(primitive::bracket(span, x, y), primitive::bracket(group, v, w)) < bound);
    BOOST_TEST(difference(primitive::restore(span, h), h) < bound);
    // Off the group by 1e-4, and back on it.
    Matrix<double> off = h;
    for (int i = 0; i < off.rows(); ++i)
      for (int j = 0; j < off.cols(); ++j) off(i, j) += 1e-4 * draw.number<double>();
    double distance = 0;
    BOOST_TEST(is_element(span.algebra(), Square(primitive::restore(span, off)), distance), distance);
    BOOST_TEST(difference(primitive::restore(span, off), off) < 1e-2);
    // The retraction is in the group, and odd.
    Matrix<double> const r = primitive::retract(span, x), back = primitive::retract(span, Vector<double>(-x));
    BOOST_TEST(is_element(span.algebra(), Square(r), distance), distance);
    BOOST_TEST(difference(r * back, Matrix<double>::Identity(r.rows(), r.rows())) < bound * row_norm(h));
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(spans_of_matrices)

BOOST_AUTO_TEST_CASE(primitives_are_those_of_the_types) {
  agrees("SO(5)", SO<Dynamic>{5});
  agrees("SE(2)", SE<2>{});
  agrees("SL(3)", SL<>(3));
  agrees("SU(3)", SU<>(3));
  agrees("Sp(4)", Sp<>(4));
  BOOST_TEST(span_of("SE(3)").cayley_stays());
  BOOST_TEST(span_of("Sp(4)").cayley_stays());
  BOOST_TEST(!span_of("SL(3)").cayley_stays());
  BOOST_TEST(!span_of("SL(3) x SO(3)").cayley_stays());
}

BOOST_AUTO_TEST_CASE(steps_of_the_natural_chart_are_those_of_the_type) {
  auto const l = [](auto const& xi) {
    auto const& v = xi.coordinates;
    using S = typename std::decay_t<decltype(xi)>::Scalar;
    return S((v[0] * v[0] + v[1] * v[1] + v[2] * v[2] * S(6)) / S(2) + v[0] * v[1] / S(4));
  };
  SE<2> const type;
  SpanOfMatrices const span = span_of("SE(2)");
  auto const step = natural_chart_step_left(l), same = natural_chart_step_left(l);
  auto state = momentum_state(l, velocity(type, Vector<double, 3>(0.7, 1.0, 0.2)));
  auto other = momentum_state(l, velocity(span, Vector<double>(0.7, 1.0, 0.2)));
  for (int k = 0; k < 20; ++k) {
    auto const a = step(state, 0.1);
    auto const b = same(other, 0.1);
    BOOST_TEST(difference(a.relative_motion.value, b.relative_motion.value) < 64 * eps);
    state = a.state, other = b.state;
  }
  BOOST_TEST(difference(state.momentum.components, other.momentum.components) < 20 * 64 * eps);
  BOOST_TEST(
      difference(state.momentum.components,
                 momentum_state(l, velocity(type, Vector<double, 3>(0.7, 1.0, 0.2))).momentum.components) >
      0.1);
}

BOOST_AUTO_TEST_CASE(products_of_exponentials_are_elements_with_a_name_and_without) {
  Draw draw(7);
  for (std::string const name :
       {"R^3", "SO(2)", "SO(3)", "SO(5)", "SE(2)", "SE(3)", "GL(3)", "SL(2)", "SL(3)", "U(2)", "SU(2)",
        "SU(3)", "Sp(4)", "Aff(1)", "Heisenberg", "SO(3) x SE(2) x R^1", "SL(2) |x R^2"}) {
    SpanOfMatrices const group = span_of(name);
    Square g = Square::Identity(group.matrix_size(), group.matrix_size());
    for (int k = 0; k < 4; ++k)
      g *= Square(primitive::exp(group, Vector<double>(draw.vector<double>(group.dimension()))));
    double distance = infinite;
    BOOST_TEST(is_element(group.algebra(), g, distance), name << ": " << distance);
    BOOST_TEST(is_element(bare(name), g, distance), name << ": " << distance);
    Square off = g;
    for (double& x : off.reshaped()) x += 1e-6 * draw.number<double>();
    BOOST_TEST(is_element(group.algebra(), off, distance) == (name == "GL(3)"), name << ": " << distance);
    BOOST_TEST(is_element(bare(name), off, distance) == (name == "GL(3)"), name << ": " << distance);
    if (name != "GL(3)") BOOST_TEST((distance > 1e-8 && distance < 1e-3), name << ": " << distance);
  }
}

BOOST_AUTO_TEST_CASE(a_rate_of_change_is_restored_to_that_of_elements) {
  SpanOfMatrices const span = span_of("SL(3)");
  Draw draw(5);
  Vector<double> const x = draw.vector<double>(8) / 2, y = draw.vector<double>(8);
  Matrix<double> const g = primitive::exp(span, x), tangent = span.hat(y) * g;
  // Two rates: one of elements, and the same with a change of scale, which leaves the group.
  Matrix<Dual<double, 2>> moving(3, 3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      moving(i, j).value = g(i, j);
      moving(i, j).part[0] = tangent(i, j);
      moving(i, j).part[1] = tangent(i, j) + 0.25 * g(i, j);
    }
  auto const restored = primitive::restore_by_logarithm(span, moving);
  double const bound = 256 * eps * row_norm(g) * row_norm(g);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      BOOST_TEST(std::abs(restored(i, j).value - g(i, j)) < bound);
      BOOST_TEST(std::abs(restored(i, j).part[0] - tangent(i, j)) < bound);
      BOOST_TEST(std::abs(restored(i, j).part[1] - tangent(i, j)) < bound);
    }
}

BOOST_AUTO_TEST_CASE(matrices_of_larger_groups_are_no_elements) {
  auto const refused = [](MatrixAlgebra const& algebra, Square const& g) {
    double distance = 0;
    BOOST_TEST(!is_element(algebra, g, distance), algebra.name << "\n" << g);
    BOOST_TEST(distance > 1e-9);
    return distance;
  };
  auto const diagonal = [](std::initializer_list<double> of) {
    return Square(Eigen::Map<Eigen::VectorXd const>(of.begin(), static_cast<Index>(of.size())).asDiagonal());
  };
  // Reflections, alone and in pairs, and multiples.
  for (auto const& so3 : {named_algebra("SO(3)"), bare("SO(3)")}) {
    double distance = 1;
    BOOST_TEST(is_element(so3, diagonal({1, -1, -1}), distance), distance);
    BOOST_TEST(refused(so3, diagonal({1, 1, -1})) == 2);
    refused(so3, diagonal({2, 2, 2}));
    refused(so3, -Square::Identity(3, 3));
  }
  refused(named_algebra("SO(2) x SO(2)"), diagonal({1, -1, 1, -1}));
  for (auto const& gl2 : {named_algebra("GL(2)"), bare("GL(2)")}) refused(gl2, diagonal({1, -1}));
  // Each factor of a product by itself, and what stands outside of the blocks.
  refused(named_algebra("GL(1) x SO(3)"), diagonal({1, 2, 2, 2}));
  refused(named_algebra("SO(3) x GL(1)"), diagonal({2, 2, 2, 1}));
  refused(named_algebra("SO(3) |x R^3"), diagonal({2, 2, 2, 1}));
  refused(named_algebra("SL(3)"), diagonal({2, 1, 1}));
  refused(named_algebra("Aff(1)"), diagonal({-1, 1}));
  // A phase is unitary, and its determinant is not 1.
  Square phase = Square::Zero(6, 6);
  for (int i = 0; i < 3; ++i)
    phase(i, i) = phase(i + 3, i + 3) = std::cos(1e-3), phase(i + 3, i) = std::sin(1e-3),
             phase(i, i + 3) = -std::sin(1e-3);
  double distance = 1;
  BOOST_TEST(is_element(named_algebra("U(3)"), phase, distance), distance);
  refused(named_algebra("SU(3)"), phase);
  refused(bare("SU(3)"), phase);
  // Motions whose last row is another one; translations of a turned space.
  Square motion = Square::Identity(3, 3);
  motion(2, 0) = 1e-8;
  refused(named_algebra("SE(2)"), motion);
  refused(bare("SE(2)"), motion);
  for (auto const& plane : {named_algebra("R^2"), bare("R^2")}) refused(plane, diagonal({2, 0.5, 1}));
}

BOOST_AUTO_TEST_CASE(what_is_no_matrix_of_the_size_or_has_no_inverse_is_infinitely_far) {
  for (auto const& algebra : {named_algebra("GL(2)"), bare("GL(2)")})
    for (Square const& g :
         {Square(Square::Zero(2, 2)), Square(Square::Ones(2, 2)), Square(Square::Identity(3, 3)),
          Square(Square::Identity(2, 3)), Square(0, 0), Square(Square::Constant(2, 2, std::nan(""))),
          Square(Square::Constant(2, 2, infinite)),
          Square(1e300 * Square::Identity(2, 2) + 1e300 * Square::Ones(2, 2))}) {
      double distance = 0;
      bool const is = is_element(algebra, g, distance);
      BOOST_TEST((is ? distance == 0 : distance == infinite), g);
      if (g.rows() != 2 || !g.allFinite() || g(0, 0) == g(0, 1)) BOOST_TEST(!is, g);
    }
  // Multiples of a rotation, which move the algebra as the rotation does, beyond what squares can hold.
  Square large(2, 2);
  large << 1, -1, 1, 1;
  for (auto const& so2 : {named_algebra("SO(2)"), bare("SO(2)")})
    for (double const size : {1e150, 1e160, 1e200, 1e300}) {
      double distance = 0;
      BOOST_TEST(!is_element(so2, size * large, distance), so2.name << ", " << size);
      BOOST_TEST(distance > 1, so2.name << ", " << size);
    }
}

BOOST_AUTO_TEST_SUITE_END()
