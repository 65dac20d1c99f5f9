#include "laws_of_more_groups.hpp"
#include "refused.hpp"

BOOST_AUTO_TEST_CASE(laws_of_families_hold_over_double) { actio::laws::laws_of_families<double>(); }
BOOST_AUTO_TEST_CASE(laws_of_products_and_spans_hold_over_double) {
  actio::laws::laws_of_products_and_spans<double>();
}

using namespace actio;

namespace {

using laws::from_span;
using Any = laws::AnyGroup<double>;
using Square = actio::Matrix<double>;
double const eps = epsilon<double>();

/// The numbers of an error, which must break their bound.
template <class F>
bool refuses(F const& f) {
  try {
    f();
  } catch (OutsideDomain const& e) {
    return std::isfinite(e.measured) && std::isfinite(e.bound) && e.measured != e.bound;
  }
  return false;
}
Element<Any, double> element(Any const& group, Square const& a) { return {group, a}; }

}  // namespace

BOOST_AUTO_TEST_CASE(the_order_of_a_group_is_checked) {
  BOOST_TEST(refuses([] { U<>(0); }));
  BOOST_TEST(refuses([] { SU<>(1); }));
  BOOST_TEST(refuses([] { SL<>(1); }));
  BOOST_TEST(refuses([] { SL<>(-1); }));
  BOOST_TEST(refuses([] { Sp<>(3); }));
  BOOST_TEST(refuses([] { U<>(100000); }));
}

BOOST_AUTO_TEST_CASE(a_matrix_that_is_not_in_the_group_has_no_logarithm_and_is_not_restored) {
  Square const two = Square::Identity(4, 4) * 2;
  Square off_blocks = Square::Identity(4, 4), lying = Square::Identity(4, 4),
         orthogonal = Square::Identity(4, 4);
  off_blocks(0, 3) = 0.5, lying(3, 0) = 0.5;
  // A turn in the plane of the real and imaginary parts of different coordinates is orthogonal and not
  // complex linear.
  orthogonal.topLeftCorner(2, 2) << 0, -1, 1, 0;
  auto const all = [&](Any const& group, Square const& bad) {
    BOOST_TEST(refuses([&] { log(element(group, bad)); }));
    BOOST_TEST(refuses([&] { restore(element(group, bad)); }));
  };
  all(Any(U<>(2)), two), all(Any(U<>(2)), orthogonal), all(Any(SU<>(2)), two), all(Any(SL<>(4)), two),
      all(Any(Sp<>(4)), two), all(Any(Sp<>(4)), off_blocks);
  all(Any(DirectProduct{SL<>(2), SL<>(2)}), off_blocks), all(Any(DirectProduct{SL<>(2), SL<>(2)}), two),
      all(Any(SemidirectProduct{SL<>(3)}), lying);
  // On U(2), but not on SU(2): a turn of both phases by 1.
  Square phases = Square::Identity(4, 4) * std::cos(1);
  for (int k = 0; k < 2; ++k) phases(2 + k, k) = std::sin(1), phases(k, 2 + k) = -std::sin(1);
  all(Any(SU<>(2)), phases);
  BOOST_TEST((log(element(Any(U<>(2)), phases)).coordinates.head(2) - actio::Vector<double, 2>(1, 1))
                 .isZero(16 * eps));
  // A reflection has determinant -1; a singular matrix has none that counts.
  Square reflection = Square::Identity(3, 3);
  reflection(0, 0) = -1;
  all(Any(SL<>(3)), reflection), all(Any(SL<>(3)), Square::Zero(3, 3));
  // From a span, where only the algebra is known.
  Any const span(from_span("SU(3)", SU<>(3)));
  Square stretched = Square::Identity(6, 6);
  stretched(0, 0) = 1.5;
  all(span, stretched);
  stretched(0, 0) = -3;
  all(span, stretched);
}

BOOST_AUTO_TEST_CASE(a_logarithm_ends_at_the_negative_axis) {
  actio::Vector<double> const half = M_PI * actio::Vector<double>::Unit(8, 0);
  for (Any const& group : {Any(SU<>(3)), Any(from_span("SU(3)", SU<>(3)))})
    BOOST_TEST(refuses([&] { log(exp(velocity(group, half))); }));
  Square negative = Square::Identity(4, 4);
  negative.diagonal() << -2, 1, -0.5, 1;
  BOOST_TEST(refuses([&] { log(element(Any(Sp<>(4)), negative)); }));
  BOOST_TEST(refuses([&] { log(element(Any(SL<>(4)), negative)); }));
}

BOOST_AUTO_TEST_CASE(angles_that_add_up_to_a_whole_turn_have_no_logarithm_in_SU3) {
  // 2 and 2 and -4, which is a turn less than 2.28: the principal logarithm has the trace 2 pi i.
  actio::Vector<double> v = 2 * actio::Vector<double>::Unit(8, 0) + 4 * actio::Vector<double>::Unit(8, 1);
  for (Any const& group : {Any(SU<>(3)), Any(from_span("SU(3)", SU<>(3)))}) {
    auto const g = exp(velocity(group, v));
    BOOST_TEST(refuses([&] { log(g); }));
    // It is an element all the same, and restored as one. In U(3) it has a logarithm.
    BOOST_TEST(magnitude((restore(g).value - g.value).eval()) < 16 * eps);
    BOOST_TEST(std::abs(log(element(Any(U<>(3)), g.value)).coordinates.head(3).sum() - 2 * M_PI) < 64 * eps);
  }
}

BOOST_AUTO_TEST_CASE(what_is_no_number_is_refused) {
  for (double const bad : {std::nan(""), HUGE_VAL}) {
    Square a = Square::Identity(4, 4);
    a(1, 2) = bad;
    for (Any const& group : {Any(U<>(2)), Any(SU<>(2)), Any(SL<>(4)), Any(Sp<>(4)),
                             Any(DirectProduct{SL<>(2), SL<>(2)}), Any(SemidirectProduct{SL<>(3)})}) {
      actio::Vector<double> const v = actio::Vector<double>::Constant(group.dimension(), bad);
      CHECK_REFUSED(log(element(group, a)), NotFinite);
      CHECK_REFUSED(restore(element(group, a)), NotFinite);
      CHECK_REFUSED(retract(velocity(group, v)), NotFinite);
      CHECK_REFUSED(exp(velocity(group, v)), NotFinite);
    }
  }
  // An eigenvalue 4 of the matrix is where Cayley's transform of its half ends.
  CHECK_REFUSED(retract(velocity(Any(SL<>(3)), actio::Vector<double>(4 * actio::Vector<double>::Unit(8, 0)))),
                Singular);
}
