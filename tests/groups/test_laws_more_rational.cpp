#include "laws_of_more_groups.hpp"
#include "witness/draw.hpp"

using namespace actio;

namespace {

using laws::from_span;
using Q = Number;
using Any = laws::AnyGroup<Q>;
using Square = laws::AnyMatrix<Q>;

// By how much a matrix breaks the equations of a group: zero on the group, and exactly there.

Q unitary_defect(Square const& a) {
  int const n = static_cast<int>(a.rows()) / 2;
  Square product = a.transpose() * a;
  product.diagonal().array() -= Q(1);
  Q worst = magnitude(product);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      worst =
          std::max({worst, magnitude(Q(a(i, j) - a(n + i, n + j))), magnitude(Q(a(n + i, j) + a(i, n + j)))});
  return worst;
}
Q special_unitary_defect(Square const& a) {
  auto const d = complex_determinant(a);
  return std::max({unitary_defect(a), magnitude(Q(d.re - Q(1))), magnitude(d.im)});
}
Q special_linear_defect(Square const& a) { return magnitude(Q(determinant_by_elimination(a) - Q(1))); }
Q symplectic_defect(Square const& a) {
  int const n = static_cast<int>(a.rows()) / 2;
  Square form = Square::Zero(2 * n, 2 * n);
  for (int i = 0; i < n; ++i) form(i, n + i) = Q(1), form(n + i, i) = Q(-1);
  return magnitude((a.transpose() * form * a - form).eval());
}

/// The largest defect among retractions, their products and their inverses.
Q defect_of_retractions(Any const& group, Q (*defect)(Square const&)) {
  FineDraw draw(11);
  Q worst(0);
  for (int k = 0; k < 3; ++k) {
    Square const g = draw.element<Q>(group).value, h = draw.element<Q>(group).value;
    worst = std::max({worst, defect(g), defect(group.compose(g, h)), defect(group.inverse(g))});
  }
  return worst;
}

}  // namespace

BOOST_AUTO_TEST_CASE(retractions_stay_in_the_group_over_the_rationals) {
  WithArithmetic const exactly(Arithmetic::rationals());
  for (int const n : {1, 2, 3})
    BOOST_TEST((defect_of_retractions(Any(U<>(n)), unitary_defect) == 0), "U(" << n << ")");
  for (int const n : {2, 3})
    BOOST_TEST((defect_of_retractions(Any(SU<>(n)), special_unitary_defect) == 0), "SU(" << n << ")");
  for (int const n : {2, 3, 4, 5})
    BOOST_TEST((defect_of_retractions(Any(SL<>(n)), special_linear_defect) == 0), "SL(" << n << ")");
  for (int const n : {2, 4, 6})
    BOOST_TEST((defect_of_retractions(Any(Sp<>(n)), symplectic_defect) == 0), "Sp(" << n << ")");
  BOOST_TEST((defect_of_retractions(Any(from_span("SL(3)", SL<>(3))), special_linear_defect) == 0));
  BOOST_TEST((defect_of_retractions(Any(from_span("SU(3)", SU<>(3))), special_unitary_defect) == 0));
  BOOST_TEST((defect_of_retractions(Any(from_span("Sp(4)", Sp<>(4))), symplectic_defect) == 0));
  BOOST_TEST((defect_of_retractions(Any(from_span("Sp(4)", Sp<>(4), Retraction::elementary)),
                                    symplectic_defect) == 0));
  BOOST_TEST((defect_of_retractions(Any(DirectProduct{SL<>(2), SL<>(3)}), special_linear_defect) == 0));

  // Cayley's transform alone leaves SL(3) and SU(3), but not their larger relatives.
  FineDraw draw(11);
  auto const v = draw.velocity<Q>(SL<>(3)).coordinates, w = draw.velocity<Q>(SU<>(3)).coordinates;
  BOOST_TEST((special_linear_defect(cayley(SL<>(3).hat(v))) != 0));
  BOOST_TEST((special_unitary_defect(cayley(SU<>(3).hat(w))) != 0));
  BOOST_TEST((unitary_defect(cayley(SU<>(3).hat(w))) == 0));
}
