// Stored energies of media in one, two and three dimensions against their formulas, and stresses and their
// rates against derivatives of these.
#include <boost/test/unit_test.hpp>

#include "actio/media_on_meshes/discrete_stress.hpp"
#include "witness/draw.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::media;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
template <int d>
using Square = Matrix<double, d, d>;

/// Up to rounding of numbers below 30, some twenty times.
constexpr double bound = 30 * 20 * eps;

/// W as in a book, over any scalar: what a medium is held to.
template <int d, class Medium, class Formula>
void is_that_of(Medium const& medium, Formula const& W, double power, Draw& draw) {
  auto const law = stored_energy<d>(medium);
  for (double const rho : {0.3, 1.0, 1.7})
    BOOST_TEST(std::abs(law->weight(rho) - std::exp(power * std::log(rho))) <= 8 * eps);
  auto const slope = [&]<class T>(Matrix<T, d, d> const& F) -> Matrix<T, d, d> {
    return derivative(W, F).gradient();
  };
  for (int k = 0; k < 8; ++k) {
    auto const drawn = [&](double size) {
      Square<d> out;
      for (int i = 0; i < d * d; ++i) out.data()[i] = size * draw.number<double>();
      return out;
    };
    Square<d> const F = Square<d>(Square<d>::Identity() * 1.1) + drawn(0.3), change = drawn(1);
    if (!(small_determinant(F) > 0.3)) continue;
    BOOST_TEST(std::abs(law->energy(F) - W(F)) <= bound);
    Square<d> const P = slope(F), S = inverse_matrix(F) * P, C = F.transpose() * F;
    BOOST_TEST(magnitude(Square<d>(law->stress(F) - P)) <= bound);
    // 2 dW/dC = F^{-1} dW/dF, for what turns do not change.
    BOOST_TEST(magnitude(Square<d>(law->green_stress(C) - S)) <= 10 * bound);
    Square<d> const rate = derivative_along(slope, F, change).rate;
    BOOST_TEST(magnitude(Square<d>(law->stress_rate(F, change) - rate)) <= 10 * bound);
  }
}

template <int d>
void every_medium() {
  Draw draw(d);
  auto const square = [](auto const& F) { return F.squaredNorm() - double(d); };
  auto const volume = [](auto const& F) { return small_determinant(F); };
  auto const logarithmic = [=](auto const& F) {
    using std::log;
    auto const l = log(volume(F));
    return square(F) * 0.35 - l * 0.7 + l * l * 0.65;
  };
  is_that_of<d>(neo_hookean(1.3, 0.7), logarithmic, 1, draw);
  is_that_of<d>(per_volume(neo_hookean(1.3, 0.7)), logarithmic, 0, draw);
  is_that_of<d>(
      FastNeoHookean<QuadraticLaw>{0.7, {0.7, 1.9}},
      [=](auto const& F) {
        using std::log;
        auto const J = volume(F);
        return square(F) * 0.35 - log(J) * 0.7 + (J - 1.0) * (J - 1.0) * 0.95;
      },
      1, draw);
  is_that_of<d>(
      blatz_ko<1>(0.8),
      [=](auto const& F) {
        auto const J = volume(F);
        return square(F) * 0.4 + 0.4 / (J * J);
      },
      1, draw);
  auto const gas = [=](auto const& F) {
    using std::exp, std::log;
    return exp(log(volume(F)) * -0.4) * (0.6 / 0.4);
  };
  is_that_of<d>(FastFluid<PolytropicGas>{{0.6, 1.4}}, gas, 1, draw);
  is_that_of<d>(isentropic_gas(0.6, 1.4), gas, 1.4, draw);
  // E = (C - 1)/2 entry by entry.
  auto const kirchhoff = [](auto const& F) {
    auto trace = F(0, 0) * 0.0, all = trace;
    for (int i = 0; i < d; ++i)
      for (int j = 0; j < d; ++j) {
        auto E = F(0, 0) * 0.0 - (i == j ? 0.5 : 0.0);
        for (int a = 0; a < d; ++a) E = E + F(a, i) * F(a, j) * 0.5;
        if (i == j) trace = trace + E;
        all = all + E * E;
      }
    return trace * trace * 0.45 + all * 0.6;
  };
  is_that_of<d>(FastStVenantKirchhoff{0.9, 0.6}, kirchhoff, 1, draw);
  is_that_of<d>(Weighed{FastStVenantKirchhoff{0.9, 0.6}, 1.0}, kirchhoff, 1, draw);
  // A reader's own law, with a fibre along the last direction.
  auto const own = [=](auto const& F) {
    auto const stretch = F.col(d - 1).squaredNorm() - 1.0;
    return F.squaredNorm() * 0.3 + stretch * stretch * 0.2 + 1.0 / volume(F);
  };
  is_that_of<d>(own, own, 1, draw);
  is_that_of<d>(Weighed{own, 2.0}, own, 2, draw);
}
}  // namespace

BOOST_AUTO_TEST_SUITE(stored_energies)

BOOST_AUTO_TEST_CASE(every_medium_has_the_energy_of_its_formula_and_the_stresses_of_that) {
  every_medium<1>(), every_medium<2>(), every_medium<3>();
}

// By the sum over permutations.
BOOST_AUTO_TEST_CASE(determinants_and_cofactors_are_those_of_the_definition) {
  WithArithmetic const exactly(Arithmetic::rationals());
  FineDraw draw(5);
  using Q = Number;
  Matrix<Q, 3, 3> F;
  for (int i = 0; i < 9; ++i) F.data()[i] = draw.number<Q>();
  auto const by_permutations = [](auto const& A) {
    Q sum(0);
    for (auto const& [i, j, k] : {std::array{0, 1, 2}, {1, 2, 0}, {2, 0, 1}})
      sum += A(i, 0) * A(j, 1) * A(k, 2) - A(j, 0) * A(i, 1) * A(k, 2);
    return sum;
  };
  BOOST_TEST((small_determinant(F) == by_permutations(F)));
  auto const c = cofactors(F);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      auto unit = F;
      for (int k = 0; k < 3; ++k) unit(k, j) = Q(k == i);
      BOOST_TEST((c(i, j) == by_permutations(unit)));
    }
  Matrix<Q, 2, 2> const G = {{Q(2), Q(3)}, {Q(5), Q(11)}}, of_G = {{Q(11), Q(-5)}, {Q(-3), Q(2)}};
  BOOST_TEST((small_determinant(G) == 7));
  BOOST_TEST((cofactors(G) == of_G));
}

BOOST_AUTO_TEST_SUITE_END()
