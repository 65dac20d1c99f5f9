// Bases and structure constants of the groups with names are those of the library's types.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/any_group/named_algebra.hpp"
#include "actio/groups/direct_product.hpp"
#include "actio/groups/semidirect_product.hpp"
#include "actio/groups/unit_quaternions.hpp"
#include "caught.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::systems;
using testing::message_of;

namespace {

using Tables = std::vector<Eigen::MatrixXd>;

std::size_t n(int i) { return static_cast<std::size_t>(i); }

/// The matrices of ad of all basis vectors, from the bracket of a group of the library.
template <class G>
Tables brackets(G const& group) {
  using V = Coordinates<G, double>;
  int const d = group.dimension();
  Tables all;
  for (int a = 0; a < d; ++a) {
    V e = V::Zero(d);
    e[a] = 1;
    all.push_back(primitive::ad_matrix(group, e));
  }
  return all;
}
/// The same from structure constants.
Tables brackets(MatrixAlgebra const& algebra) {
  Tables all(n(algebra.dimension), Eigen::MatrixXd::Zero(algebra.dimension, algebra.dimension));
  for (auto const& c : algebra.constants) all[n(c.a)](c.c, c.b) += c.value;
  return all;
}
void same(std::string const& what, Tables const& a, Tables const& b) {
  BOOST_TEST_REQUIRE(a.size() == b.size(), what << ": " << a.size() << " and " << b.size());
  for (std::size_t k = 0; k < a.size(); ++k) BOOST_TEST((a[k] == b[k]), what << ", vector " << k + 1);
}
/// The same matrices and the same brackets as those of a type of the library, without rounding.
template <MatrixGroup G>
void is(std::string const& name, G const& group) {
  MatrixAlgebra const algebra = named_algebra(name);
  BOOST_TEST(algebra.size == group.matrix_size(), name);
  BOOST_TEST_REQUIRE(algebra.dimension == group.dimension(), name);
  Tables basis;
  for (int a = 0; a < algebra.dimension; ++a) {
    Coordinates<G, double> e = Coordinates<G, double>::Zero(group.dimension());
    e[a] = 1;
    basis.push_back(group.hat(e));
  }
  same(name + ", matrices", algebra.basis, basis);
  same(name + ", brackets", brackets(algebra), brackets(group));
}

std::vector<std::string> const names{"R^1",
                                     "R^3",
                                     "SO(2)",
                                     "SO(3)",
                                     "SO(4)",
                                     "SO(6)",
                                     "SE(2)",
                                     "SE(3)",
                                     "GL(1)",
                                     "GL(3)",
                                     "SL(2)",
                                     "SL(4)",
                                     "U(1)",
                                     "U(3)",
                                     "SU(2)",
                                     "SU(4)",
                                     "Sp(2)",
                                     "Sp(6)",
                                     "SU(3)",
                                     "Aff(1)",
                                     "Heisenberg",
                                     "SO(3) x SE(2) x R^1",
                                     "Heisenberg |x R^3",
                                     "(SO(2) x SO(2)) |x R^4"};

}  // namespace

BOOST_AUTO_TEST_SUITE(named_algebras)

BOOST_AUTO_TEST_CASE(groups_with_a_type_of_their_own_have_its_matrices_and_brackets) {
  is("SO(2)", SO<2>{});
  is("SO(3)", SO<3>{});
  is("SO(4)", SO<4>{});
  is("SO(6)", SO<6>{});
  is("SE(2)", SE<2>{});
  is("SE(3)", SE<3>{});
  is("GL(1)", GL<1>{});
  is("GL(3)", GL<3>{});
  is("Aff(1)", Aff1{});
  is("Heisenberg", Heisenberg{});
}

BOOST_AUTO_TEST_CASE(families_have_its_matrices_and_brackets_at_every_order) {
  for (int k = 1; k <= 4; ++k) {
    std::string const order = "(" + std::to_string(k) + ")";
    is("U" + order, U<>(k));
    if (k > 1) is("SL" + order, SL<>(k));
    if (k > 2) is("SU" + order, SU<>(k));
    is("Sp(" + std::to_string(2 * k) + ")", Sp<>(2 * k));
  }
}

BOOST_AUTO_TEST_CASE(unit_quaternions_and_translations_have_the_brackets_of_their_types) {
  same("SU(2)", brackets(named_algebra("SU(2)")), brackets(SU2{}));
  // The matrix of a quaternion's coordinates is half that of the coordinates of SU(n).
  auto const whole = brackets(SU<>(2));
  auto const half = brackets(named_algebra("SU(2)"));
  for (std::size_t a = 0; a < 3; ++a) BOOST_TEST((2 * half[a] == whole[a]));
  for (int k : {1, 3, 7})
    same("R^n", brackets(named_algebra("R^" + std::to_string(k))), brackets(Translations<Dynamic>{k}));
}

BOOST_AUTO_TEST_CASE(products_have_the_matrices_and_brackets_of_the_products_of_types) {
  is("SO(3) x SE(2)", DirectProduct<SO<3>, SE<2>>{});
  is("SL(3) x (U(1) x Sp(2))", DirectProduct{SL<>(3), DirectProduct{U<>(1), Sp<>(2)}});
  is("SL(3) |x R^3", SemidirectProduct{SL<>(3)});
  is("U(2) |x R^4", SemidirectProduct{U<>(2)});
  is("SO(3)|xR^3", SemidirectProduct<SO<3>, 3>{});
  is("(SL(2) |x R^2) x SL(2)", DirectProduct{SemidirectProduct{SL<>(2)}, SL<>(2)});
  is("SL(2) |x R^2 x SL(2)", DirectProduct{SemidirectProduct{SL<>(2)}, SL<>(2)});
  is("(SL(2) x SL(2)) |x R^4", SemidirectProduct{DirectProduct{SL<>(2), SL<>(2)}});
  BOOST_TEST(named_algebra(" ( SL(2) x SL(2) )|x R^4 ").name == "(SL(2) x SL(2)) |x R^4");
}

BOOST_AUTO_TEST_CASE(brackets_are_antisymmetric_and_satisfy_the_identity_of_Jacobi) {
  for (auto const& name : names) {
    MatrixAlgebra const algebra = named_algebra(name);
    Tables const ad = brackets(algebra);
    for (std::size_t a = 0; a < ad.size(); ++a)
      for (std::size_t b = 0; b < ad.size(); ++b) {
        Eigen::MatrixXd of_bracket = Eigen::MatrixXd::Zero(algebra.dimension, algebra.dimension);
        for (std::size_t c = 0; c < ad.size(); ++c)
          of_bracket += ad[a](static_cast<Index>(c), static_cast<Index>(b)) * ad[c];
        BOOST_TEST((ad[a] * ad[b] - ad[b] * ad[a] == of_bracket), name);
        BOOST_TEST((ad[a].col(static_cast<Index>(b)) == -ad[b].col(static_cast<Index>(a))), name);
      }
  }
}

BOOST_AUTO_TEST_CASE(whole_coordinates_come_back_from_their_matrix_without_rounding) {
  for (auto const& name : names) {
    MatrixAlgebra const algebra = named_algebra(name);
    Vector<double> v(algebra.dimension), w(algebra.dimension);
    for (int a = 0; a < algebra.dimension; ++a) v[a] = 3 - a * a % 7, w[a] = a % 5 - 2;
    BOOST_TEST((algebra.vee(algebra.hat(v)) == v), name);
    // Brackets by constants, by matrices and by ad.
    Matrix<double> const a = algebra.hat(v), b = algebra.hat(w);
    BOOST_TEST((algebra.bracket(v, w) == algebra.vee(Matrix<double>(a * b - b * a))), name);
    BOOST_TEST((Vector<double>(algebra.ad(v) * w) == algebra.bracket(v, w)), name);
  }
}

BOOST_AUTO_TEST_CASE(components_have_the_names_of_turns_and_shifts_where_there_are_some) {
  using Words = std::vector<std::string>;
  BOOST_TEST(named_algebra("SO(3)").components == (Words{"w1", "w2", "w3"}),
             boost::test_tools::per_element());
  BOOST_TEST(named_algebra("SE(2)").components == (Words{"w", "v1", "v2"}), boost::test_tools::per_element());
  BOOST_TEST(named_algebra("SE(3)").components == (Words{"w1", "w2", "w3", "v1", "v2", "v3"}),
             boost::test_tools::per_element());
  BOOST_TEST(named_algebra("SU(2)").components == (Words{"x1", "x2", "x3"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_largest_groups_are_made_and_the_next_ones_refused) {
  for (std::string const name : {"SO(11)", "GL(8)", "U(8)", "SL(8)", "Sp(10)"})
    BOOST_TEST(named_algebra(name).dimension > 54, name);
  for (std::string const name : {"SO(12)", "GL(9)", "U(9)", "SL(9)", "SU(9)", "Sp(12)", "R^65", "R^32 x R^33",
                                 "SO(999999999999)", "SL(8) |x R^8"})
    BOOST_TEST(message_of([&] { named_algebra(name); }).find("bound 64") != std::string::npos, name);
}

BOOST_AUTO_TEST_CASE(a_name_that_is_no_group_is_answered_with_the_nearest_one) {
  for (auto const& [wrong, right] :
       std::vector<std::pair<std::string, std::string>>{{"SO3", "'SO(3)'"},
                                                        {"so(3)", "'SO(3)'"},
                                                        {"SOO(3)", "'SO(3)'"},
                                                        {"R3", "'R^3'"},
                                                        {"Heisenburg", "'Heisenberg'"},
                                                        {"Af(1)", "'Aff(1)'"},
                                                        {"SP(4)", "'Sp(4)'"},
                                                        {"SO", "'SO(n)'"},
                                                        {"SO(3) x se(2)", "'SE(2)'"}}) {
    CHECK_REFUSED(named_algebra(wrong), UnknownGroup);
    std::string const message = message_of([&, w = wrong] { named_algebra(w); });
    BOOST_TEST(message.find("did you mean " + right) != std::string::npos, message);
  }
}

BOOST_AUTO_TEST_CASE(a_name_that_cannot_be_read_says_what_is_needed) {
  for (auto const& [wrong, needed] :
       std::vector<std::pair<std::string, std::string>>{{"", "the name of a group is needed"},
                                                        {"SO()", "')' stands where the number of SO(n)"},
                                                        {"SO(3", "the name ends where a closing bracket"},
                                                        {"(SO(3) x R^1", "a closing bracket"},
                                                        {"SO(3) SO(3)", "'x', '|x' or the end"},
                                                        {"SO(3) x", "the name of a group"},
                                                        {"SL(2) |x R^3", "'R^3' stands where R^2"},
                                                        {"SL(2) |x SO(2)", "where R^2"},
                                                        {"SO(1)", "measured 1, bound 2"},
                                                        {"SE(4)", "measured 4, bound 3"},
                                                        {"Sp(5)", "an even number"},
                                                        {"Aff(2)", "measured 2, bound 1"},
                                                        {"R^0", "measured 0, bound 1"},
                                                        {std::string(2000, '('), "a shorter name"},
                                                        {std::string(900, '('), "the name of a group"}}) {
    std::string const message = message_of([&, w = wrong] { named_algebra(w); });
    BOOST_TEST(message.find(needed) != std::string::npos, wrong << ": " << message);
  }
}

BOOST_AUTO_TEST_SUITE_END()
