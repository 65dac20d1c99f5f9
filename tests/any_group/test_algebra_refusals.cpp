// What is measured, and against which bound, where an algebra or a name is refused, and how far a matrix is
// from a group.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/any_group/membership.hpp"
#include "actio/any_group/named_algebra.hpp"
#include "actio/any_group/semidirect_algebra.hpp"
#include "caught.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::systems;
using testing::caught;
using testing::message_of;

namespace {

using Square = Eigen::MatrixXd;
constexpr double eps = std::numeric_limits<double>::epsilon();

/// Refused with these figures, in these words.
template <class E, class Call>
void refused(Call const& call, double measured, double bound, std::string const& words) {
  E const e = caught<E>(call);
  BOOST_TEST(std::abs(e.measured - measured) <= 8 * eps * std::abs(measured), e.what());
  BOOST_TEST(e.bound == bound, e.what());
  BOOST_TEST(std::string(e.what()).find(words) != std::string::npos, e.what());
}
Square matrix(int n, std::initializer_list<double> row_by_row) {
  Square m(n, n);
  Index k = 0;
  for (double const x : row_by_row) m(k / n, k % n) = x, ++k;
  return m;
}
Square const up = matrix(2, {0, 1, 0, 0}), down = matrix(2, {0, 0, 1, 0});

/// The algebra alone, as if the basis had been given.
MatrixAlgebra bare(std::string const& name) { return spanned_algebra(named_algebra(name).basis); }
double distance(MatrixAlgebra const& algebra, Square const& g) {
  double found = -1;
  is_element(algebra, g, found);
  return found;
}
Square diagonal(std::initializer_list<double> of) {
  return Square(Eigen::Map<Eigen::VectorXd const>(of.begin(), static_cast<Index>(of.size())).asDiagonal());
}

}  // namespace

BOOST_AUTO_TEST_SUITE(algebra_refusals)

BOOST_AUTO_TEST_CASE(bases_are_refused_with_what_was_measured) {
  auto const of = [](std::vector<Square> const& basis) { return [basis] { spanned_algebra(basis); }; };
  refused<OutsideDomain>(of({}), 0, 1, "at least one matrix");
  refused<OutsideDomain>(of(std::vector<Square>(65, up)), 65, 64, "with a basis of its own");
  refused<OutsideDomain>(of({Square(0, 0)}), 0, 1, "1 to 128 rows");
  refused<OutsideDomain>(of({Square::Identity(129, 129)}), 129, 128, "1 to 128 rows");
  refused<OutsideDomain>(of({up, Square::Zero(2, 3)}), 3, 2, "matrix e_2 of a basis: square matrices of one");
  refused<OutsideDomain>(of({up, Square::Zero(3, 2)}), 2, 2, "it has 3 rows");
  refused<OutsideDomain>(of({1e-7 * up}), 1e-7, 1e-6, "matrix e_1 of a basis: a matrix with an entry");
  refused<OutsideDomain>(of({up, -1e7 * down}), 1e7, 1e6, "matrix e_2 of a basis: entries of moderate");
  // At the bounds themselves they are taken.
  BOOST_CHECK_NO_THROW(spanned_algebra({1e-6 * up}));
  BOOST_CHECK_NO_THROW(spanned_algebra({1e6 * up}));
  BOOST_CHECK_NO_THROW(spanned_algebra({Square::Identity(128, 128)}));
  BOOST_CHECK_NO_THROW(spanned_algebra({Square::Identity(1, 1)}));
  BOOST_TEST(message_of(of({up, down * std::nan("")})).find("matrix e_2") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(dependent_matrices_are_refused_with_their_distance) {
  // e_3 is e_2/2 - 3 e_1 and a part of 2^-40 across, over its own size.
  Square const across = matrix(2, {1, 0, 0, -1}) * 0x1p-40, sum = down / 2 - 3 * up + across;
  auto const e = caught<Singular>([&] { spanned_algebra({up, down, sum}); });
  BOOST_TEST(std::abs(e.measured / (across.norm() / sum.norm()) - 1) < 1e-3);  // rounding of 1 beside 2^-40
  BOOST_TEST(e.bound == 1e-10);
  std::string const said = e.what();
  BOOST_TEST(said.find("but e_3 = -3 e_1 + 0.5 e_2;") != std::string::npos, said);
  BOOST_TEST(said.find("distance of e_3 from") != std::string::npos, said);
  // Of two that commute: a part of 2e-10 is enough, one of 5e-11 is not.
  auto const nearly = [](double part) {
    return spanned_algebra(
        {Square(Eigen::Vector2d(1, 0).asDiagonal()), Square(Eigen::Vector2d(1, part).asDiagonal())});
  };
  BOOST_CHECK_NO_THROW(nearly(2e-10));
  CHECK_REFUSED(nearly(5e-11), Singular);
}

BOOST_AUTO_TEST_CASE(commutators_outside_of_the_span_are_refused_with_their_distance_in_any_units) {
  // [4 e, f/2] = 2 h: over |4 e| |f/2| = 2 it is |h| = sqrt(2) outside. e and h commute to -2 e.
  for (double const unit : {1.0, 8.0}) {
    Square const turn = matrix(3, {0, 1, 0, 0, 0, 0, 0, 0, 0}), back = turn.transpose() * (unit / 2),
                 apart = matrix(3, {0, 0, 0, 0, 0, 0, 0, 0, 1});
    auto const e = caught<OutsideDomain>([&] { spanned_algebra({apart, Square(4 * turn), back}); });
    BOOST_TEST(std::abs(e.measured - std::sqrt(2.0)) < 8 * eps);
    BOOST_TEST(e.bound == 1e-9);
    BOOST_TEST(std::string(e.what()).find("[e_2, e_3] leaves it") != std::string::npos, e.what());
  }
}

BOOST_AUTO_TEST_CASE(carried_vectors_are_refused_with_their_number) {
  MatrixAlgebra const group = named_algebra("SE(2)");
  refused<OutsideDomain>([&] { semidirect_algebra(group, 1, 2); }, 2, 3, "as many components");
  refused<OutsideDomain>([&] { semidirect_algebra(group, 0, 3); }, 0, 1, "from 1 to 128");
  refused<OutsideDomain>([&] { semidirect_algebra(group, 43, 3); }, 129, 128, "from 1 to 128");
  // Names of one vector, of several, and of those that have no name.
  auto const last = [&](int vectors, std::vector<std::string> const& names) {
    return semidirect_algebra(group, vectors, 3, names).components.back();
  };
  BOOST_TEST(last(1, {}) == "a3");
  BOOST_TEST(last(2, {}) == "a2_3");
  BOOST_TEST(last(2, {"p"}) == "a2_3");
  BOOST_TEST(last(1, {"p", "q"}) == "p3");
  BOOST_TEST(semidirect_algebra(group, 1, 3).name == "SE(2) with 1 vector");
  BOOST_TEST(semidirect_algebra(group, 2, 3).name == "SE(2) with 2 vectors");
}

BOOST_AUTO_TEST_CASE(groups_are_refused_with_their_number_or_their_dimension) {
  auto const named = [](std::string const& name) { return [name] { named_algebra(name); }; };
  for (auto const& [name, number, least] :
       std::vector<std::tuple<std::string, double, double>>{{"R^0", 0, 1},
                                                            {"SO(1)", 1, 2},
                                                            {"SE(1)", 1, 2},
                                                            {"GL(0)", 0, 1},
                                                            {"SL(1)", 1, 2},
                                                            {"U(0)", 0, 1},
                                                            {"SU(1)", 1, 2},
                                                            {"Sp(0)", 0, 2},
                                                            {"Sp(1)", 1, 2},
                                                            {"Aff(0)", 0, 1}})
    refused<OutsideDomain>(named(name), number, least, "group " + name + ": the number is too small");
  refused<OutsideDomain>(named("SE(4)"), 4, 3, "group SE(4): the number is too large");
  refused<OutsideDomain>(named("Aff(2)"), 2, 1, "too large");
  refused<OutsideDomain>(named("Sp(5)"), 5, 6, "an even number");
  for (auto const& [name, dimension] : std::vector<std::pair<std::string, double>>{{"R^65", 65},
                                                                                   {"SO(12)", 66},
                                                                                   {"GL(9)", 81},
                                                                                   {"SL(9)", 80},
                                                                                   {"U(9)", 81},
                                                                                   {"SU(9)", 80},
                                                                                   {"Sp(12)", 78},
                                                                                   {"R^32 x R^33", 65},
                                                                                   {"SL(8) |x R^8", 71},
                                                                                   {"SO(3) x SL(8)", 66}})
    refused<OutsideDomain>(named(name), dimension, 64, "group " + name + ": the dimension must be moderate");
  refused<OutsideDomain>(named(std::string(1001, '(')), 1001, 1000, "a shorter name");
  BOOST_TEST(message_of(named(std::string(1000, '('))).find("the name ends") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(names_near_a_group_keep_their_number_where_it_can_have_it) {
  auto const meant = [](std::string const& name) {
    std::string const said = message_of([&] { named_algebra(name); });
    auto const at = said.find("did you mean '");
    return at == std::string::npos ? said : said.substr(at + 14, said.find('\'', at + 14) - at - 14);
  };
  BOOST_TEST(meant("so(3)") == "SO(3)");
  BOOST_TEST(meant("so(12)") == "SO(12)");
  BOOST_TEST(meant("so(03)") == "SO(3)");
  BOOST_TEST(meant("so(1)") == "SO(n)");
  BOOST_TEST(meant("so(123)") == "SO(n)");
  BOOST_TEST(meant("se(3)") == "SE(3)");
  BOOST_TEST(meant("se(4)") == "SE(n)");
  BOOST_TEST(meant("sp(6)") == "Sp(6)");
  BOOST_TEST(meant("sp(5)") == "Sp(2n)");
  BOOST_TEST(meant("aff(7)") == "Aff(1)");
  BOOST_TEST(meant("heisenberg") == "Heisenberg");
  BOOST_TEST(meant("r3") == "R^3");
}

BOOST_AUTO_TEST_CASE(matrices_are_as_far_from_a_group_as_what_they_break) {
  // By what the algebra alone says: volume, a fixed vector, a fixed covector, the logarithm.
  BOOST_TEST(std::abs(distance(bare("SL(2)"), diagonal({4, 1})) - 3) < 16 * eps);
  BOOST_TEST(std::abs(distance(bare("SL(2)"), diagonal({1, 0.25})) - 0.75) < 16 * eps);
  BOOST_TEST(std::abs(distance(bare("R^2"), diagonal({2, 0.5, 1})) - 1) < 16 * eps);
  BOOST_TEST(std::abs(distance(bare("SE(2)"), diagonal({2, 2, 0.25})) - 0.75) < 16 * eps);
  MatrixAlgebra const line = spanned_algebra({diagonal({1, 1, -2})});
  double const a = 1.25, b = 1.1;
  BOOST_TEST(std::abs(distance(line, diagonal({a, b, 1 / (a * b)})) - std::log(a / b) / 2) < 64 * eps);
  BOOST_TEST(distance(line, diagonal({a, a, 1 / (a * a)})) < 64 * eps);
  // By the groups themselves.
  for (auto const& gl : {named_algebra("GL(2)"), bare("GL(2)")}) {
    BOOST_TEST(distance(gl, diagonal({2, -1.5})) == 4);
    BOOST_TEST(distance(gl, diagonal({2, 1.5})) == 0);
  }
  BOOST_TEST(std::abs(distance(named_algebra("R^2"), diagonal({2, 0.5, 1})) - 1) < 16 * eps);
  BOOST_TEST(std::abs(distance(named_algebra("SO(2) |x R^2"), diagonal({1, 1, 3})) - 2) < 16 * eps);
  Square motion = Square::Identity(3, 3);
  motion(2, 0) = 0.25, motion(2, 1) = -0.5, motion(0, 2) = 7;
  BOOST_TEST(distance(named_algebra("SO(2) |x R^2"), motion) >= 0.75);
  // In a product the factors stand for themselves, and the blocks beside them are zero.
  MatrixAlgebra const product = named_algebra("GL(1) x GL(2)");
  BOOST_TEST(distance(product, matrix(3, {2, 0, 0, 0, 1, 3, 0, 1, 4})) < 64 * eps);
  BOOST_TEST(distance(product, matrix(3, {-2, 0, 0, 0, 1, 3, 0, 4, 1})) >= 1);
}

BOOST_AUTO_TEST_SUITE_END()
