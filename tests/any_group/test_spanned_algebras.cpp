// Algebras given by a basis: projection, refusals, carried vectors; and the Casimirs of all algebras.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/any_group/invariants.hpp"
#include "actio/any_group/named_algebra.hpp"
#include "actio/any_group/semidirect_algebra.hpp"
#include "caught.hpp"
#include "refused.hpp"
#include "witness/draw.hpp"

using namespace actio;
using namespace actio::systems;
using testing::message_of;

namespace {

using Square = Eigen::MatrixXd;
using Column = Eigen::VectorXd;
using Words = std::vector<std::string>;

constexpr double eps = std::numeric_limits<double>::epsilon();

Square random_square(Draw& draw, int rows) {
  Square m(rows, rows);
  for (double& x : m.reshaped()) x = draw.number<double>();
  return m;
}
/// A basis of the same space whose matrices are sums of all: no entry is whole any more.
std::vector<Square> mixed(Draw& draw, std::vector<Square> const& basis) {
  int const d = static_cast<int>(basis.size());
  Square const by = Square::Identity(d, d) + random_square(draw, d) / (2 * d);
  std::vector<Square> sums;
  for (int a = 0; a < d; ++a) {
    sums.push_back(Square::Zero(basis[0].rows(), basis[0].rows()));
    for (int b = 0; b < d; ++b) sums.back() += by(a, b) * basis[static_cast<std::size_t>(b)];
  }
  return sums;
}
Square matrix(std::initializer_list<double> row_by_row) {
  auto const n = static_cast<Index>(std::lround(std::sqrt(static_cast<double>(row_by_row.size()))));
  Square m(n, n);
  Index k = 0;
  for (double const x : row_by_row) m(k / n, k % n) = x, ++k;
  return m;
}
Words texts(MatrixAlgebra const& algebra) {
  Words all;
  for (Casimir const& c : casimirs(algebra)) all.push_back(c.text());
  return all;
}
void are(MatrixAlgebra const& algebra, Words const& expected) {
  Words const found = texts(algebra);
  BOOST_TEST_CONTEXT(algebra.name) BOOST_TEST(found == expected, boost::test_tools::per_element());
}
void are(std::string const& name, Words const& expected) { are(named_algebra(name), expected); }

/// How much Casimirs change along coadjoint orbits: mu moved by the exponential of ad, whose powers are
/// summed here.
void are_constant_on_orbits(std::string const& name, MatrixAlgebra const& algebra, std::size_t count) {
  Draw draw(11);
  auto const all = casimirs(algebra);
  BOOST_TEST(all.size() == count, name << ": " << all.size());
  int const d = algebra.dimension;
  Column const mu = Column(draw.vector<double>(d)), v = Column(draw.vector<double>(d)) / d;
  Square const ad = algebra.ad(v);
  Column moved = mu, term = mu;
  for (int k = 1; k < 60; ++k) term = ad.transpose() * term / k, moved += term;
  BOOST_TEST((moved - mu).norm() > 1e-3, name);
  for (Casimir const& c : all) {
    double size = 0;
    for (auto const& t : c.terms) size += std::abs(t.coefficient) * std::max(1.0, moved.squaredNorm());
    // Each coefficient comes out of an elimination with d conditions for each of d^2/2 monomials.
    double const change = std::abs(c.evaluate(moved) - c.evaluate(mu)) / size;
    BOOST_TEST(change < 64 * d * d * eps, name << ": " << c.text() << " changes by " << change);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(spanned_algebras)

BOOST_AUTO_TEST_CASE(coordinates_are_those_of_the_nearest_element) {
  Draw draw(5);
  for (std::string const name : {"SE(3)", "SL(3)", "U(2)", "SU(2)", "Heisenberg"})
    for (bool const mix : {false, true}) {
      MatrixAlgebra const named = named_algebra(name),
                          algebra = mix ? spanned_algebra(mixed(draw, named.basis)) : named;
      Square const a = random_square(draw, algebra.size), rest = Square(algebra.hat(algebra.vee(a))) - a;
      for (auto const& e : algebra.basis)
        BOOST_TEST(std::abs(e.cwiseProduct(rest).sum()) < 64 * algebra.size * eps, name);
      Vector<double> const v = draw.vector<double>(algebra.dimension);
      BOOST_TEST(magnitude((algebra.vee(algebra.hat(v)) - v).eval()) < 64 * eps, name);
    }
}

BOOST_AUTO_TEST_CASE(brackets_in_a_mixed_basis_are_those_of_the_matrices) {
  Draw draw(6);
  for (std::string const name : {"SE(3)", "SL(3)", "SU(3)"}) {
    MatrixAlgebra const algebra = spanned_algebra(mixed(draw, named_algebra(name).basis));
    BOOST_TEST(algebra.components.back() == "x" + std::to_string(algebra.dimension));
    Vector<double> const v = draw.vector<double>(algebra.dimension),
                         w = draw.vector<double>(algebra.dimension);
    Square const a = algebra.hat(v), b = algebra.hat(w), c = algebra.hat(algebra.bracket(v, w));
    BOOST_TEST((a * b - b * a - c).norm() < 256 * eps * a.norm() * b.norm(), name);
  }
}

BOOST_AUTO_TEST_CASE(dependent_matrices_are_refused_with_the_combination) {
  Square const e = matrix({0, 1, 0, 0}), f = matrix({0, 0, 1, 0});
  std::string const message = message_of([&] { spanned_algebra({e, f, 2 * e - 0.5 * f}); });
  BOOST_TEST(message.find("e_3 = 2 e_1 - 0.5 e_2;") != std::string::npos, message);
  CHECK_REFUSED(spanned_algebra({e, e}), Singular);
}

BOOST_AUTO_TEST_CASE(a_span_that_commutators_leave_is_refused_with_the_pair_and_the_distance) {
  Square const e = matrix({0, 1, 0, 0}), f = matrix({0, 0, 1, 0}), h = matrix({1, 0, 0, -1});
  std::string const message = message_of([&] { spanned_algebra({h, e, f + Square::Identity(2, 2)}); });
  BOOST_TEST(message.find("[e_1, e_3] leaves it") != std::string::npos, message);
  // |[e, f]| = |h| = sqrt(2), all of it outside.
  BOOST_TEST(message_of([&] {
               spanned_algebra({e, f});
             }).find("measured 1.41421356, bound 1e-09") != std::string::npos);
  // An entry with six good digits is not enough, one with twelve is.
  auto turned = named_algebra("SO(3)").basis;
  turned[1](0, 2) += 1e-6;
  CHECK_REFUSED(spanned_algebra(turned), OutsideDomain);
  turned[1](0, 2) -= 1e-6, turned[1](0, 2) += 1e-12;
  BOOST_CHECK_NO_THROW(spanned_algebra(turned));
}

BOOST_AUTO_TEST_CASE(what_is_no_basis_is_refused) {
  Square const e = matrix({0, 1, 0, 0});
  auto const refused = [](std::vector<Square> const& basis, std::string const& why) {
    std::string const message = message_of([&] { spanned_algebra(basis); });
    BOOST_TEST(message.find(why) != std::string::npos, why << ": " << message);
  };
  refused({}, "at least one matrix");
  refused({Square::Zero(2, 3)}, "square matrices of one size");
  refused({e, Square::Identity(3, 3)}, "square matrices of one size");
  refused({Square(0, 0)}, "1 to 128 rows");
  refused({Square::Identity(129, 129)}, "1 to 128 rows");
  refused({e, Square::Zero(2, 2)}, "e_2 of a basis: a matrix with an entry");
  refused({1e7 * e}, "scale the matrix; largest, measured 10000000");
  refused({e * std::nan("")}, "a NaN or an infinity");
  refused(std::vector<Square>(65, e), "bound 64");
}

BOOST_AUTO_TEST_CASE(carried_vectors_act_on_momenta_as_the_motion_acts_on_them) {
  Draw draw(9);
  MatrixAlgebra const group = named_algebra("SE(2)"), both = semidirect_algebra(group, 2, 3, {"p", "q"});
  BOOST_TEST(both.components[3] == "p1");
  BOOST_TEST(both.components[8] == "q3");
  // ad* of (xi, 0) on (mu, a) is (ad*_xi mu, -xi a), and <ad*_(0, w) (mu, a), eta> = w.(eta a).
  Column const xi = Column(draw.vector<double>(3)), mu = Column(draw.vector<double>(9)),
               w = Column(draw.vector<double>(6));
  Column v = Column::Zero(9), u = v;
  v.head(3) = xi, u.tail(6) = w;
  Column const turned = Square(both.ad(v)).transpose() * mu, pushed = Square(both.ad(u)).transpose() * mu;
  Square const a = group.hat(xi);
  BOOST_TEST((turned.head(3) - Square(group.ad(xi)).transpose() * mu.head(3)).norm() < 8 * eps);
  BOOST_TEST((turned.segment(3, 3) + a * mu.segment(3, 3)).norm() < 8 * eps);
  BOOST_TEST((turned.tail(3) + a * mu.tail(3)).norm() < 8 * eps);
  for (int c = 0; c < 3; ++c) {
    Square const& e = group.basis[static_cast<std::size_t>(c)];
    double const expected = w.head(3).dot(e * mu.segment(3, 3)) + w.tail(3).dot(e * mu.tail(3));
    BOOST_TEST(std::abs(pushed[c] - expected) < 8 * eps);
  }
  BOOST_TEST(pushed.tail(6).norm() == 0);
  CHECK_REFUSED(semidirect_algebra(group, 1, 2), OutsideDomain);
  CHECK_REFUSED(semidirect_algebra(group, 0, 3), OutsideDomain);
  CHECK_REFUSED(semidirect_algebra(group, 43, 3), OutsideDomain);
}

BOOST_AUTO_TEST_CASE(casimirs_are_those_of_the_textbooks) {
  are("SO(3)", {"w1^2 + w2^2 + w3^2"});
  are("SU(2)", {"x1^2 + x2^2 + x3^2"});
  are("SE(2)", {"v1^2 + v2^2"});
  are("SE(3)", {"w1*v1 + w2*v2 + w3*v3", "v1^2 + v2^2 + v3^2"});
  are("SO(4)", {"x1^2 + x2^2 + x3^2 + x4^2 + x5^2 + x6^2", "x1*x6 - x2*x5 + x3*x4"});
  are("SL(2)", {"x1^2 + 4*x2*x3"});
  are("GL(2)", {"x1 + x4", "x1^2 + 2*x2*x3 + x4^2"});
  are("Heisenberg", {"x3"});
  are("Aff(1)", {});
  are("R^2", {"x1", "x2"});
  are("U(1)", {"x1"});
  are("U(2)", {"x1 + x2", "2*x1^2 + 2*x2^2 + x3^2 + x4^2"});
  are("SU(3)", {"4*x1^2 + 4*x1*x2 + 4*x2^2 + 3*x3^2 + 3*x4^2 + 3*x5^2 + 3*x6^2 + 3*x7^2 + 3*x8^2"});
  are("SO(3) x Heisenberg", {"x6", "x1^2 + x2^2 + x3^2"});
  are(semidirect_algebra(named_algebra("SO(3)"), 1, 3, {"g"}),
      {"w1*g1 + w2*g2 + w3*g3", "g1^2 + g2^2 + g3^2"});
  are(semidirect_algebra(named_algebra("SO(3)"), 2, 3, {"p", "q"}),
      {"p1^2 + p2^2 + p3^2", "p1*q1 + p2*q2 + p3*q3", "q1^2 + q2^2 + q3^2"});
}

BOOST_AUTO_TEST_CASE(casimirs_are_constant_on_coadjoint_orbits_in_any_basis) {
  Draw draw(8);
  for (auto const& [name, count] : std::vector<std::pair<std::string, std::size_t>>{{"SE(3)", 2},
                                                                                    {"SO(4)", 2},
                                                                                    {"SO(5)", 1},
                                                                                    {"SL(3)", 1},
                                                                                    {"U(3)", 2},
                                                                                    {"Sp(4)", 1},
                                                                                    {"SO(3) x SL(2)", 2},
                                                                                    {"SE(2) x U(2)", 3},
                                                                                    {"SL(2) |x R^2", 0},
                                                                                    {"SO(3) |x R^3", 2}}) {
    MatrixAlgebra const algebra = named_algebra(name);
    are_constant_on_orbits(name, algebra, count);
    are_constant_on_orbits(name + ", mixed", spanned_algebra(mixed(draw, algebra.basis)), count);
  }
}

BOOST_AUTO_TEST_CASE(units_of_the_basis_do_not_matter) {
  auto basis = named_algebra("SE(2)").basis;
  basis[0] *= 3, basis[1] *= 1024, basis[2] /= 65536;
  auto const found = casimirs(spanned_algebra(basis));
  BOOST_TEST_REQUIRE(found.size() == 1u);
  // mu_2 = 1024 p_1 and mu_3 = p_2/65536.
  BOOST_TEST(found[0].evaluate(Column{{0, 1024 * 3.0, 4.0 / 65536}}) /
                 found[0].evaluate(Column{{7, 1024 * 5.0, 0}}) ==
             1);
}

BOOST_AUTO_TEST_CASE(the_largest_algebras_have_theirs_at_once) {
  BOOST_TEST(casimirs(named_algebra("SL(8)")).size() == 1u);
  BOOST_TEST(casimirs(named_algebra("R^64")).size() == 64u);
  BOOST_TEST(casimirs(semidirect_algebra(named_algebra("SO(8)"), 4, 8)).size() == 10u);
}

BOOST_AUTO_TEST_SUITE_END()
