// What is measured where a field is no symmetry, relative to its rates; automorphisms that mix places with
// points of the body; curls in space.
#include <boost/test/unit_test.hpp>

#include "actio/noether/automorphism.hpp"
#include "actio/noether/isometries.hpp"
#include "actio/noether/relabelling.hpp"
#include "actio/noether/time_translation.hpp"
#include "caught.hpp"
#include "refused.hpp"
#include "witness/number.hpp"

using namespace actio;
using testing::caught;

namespace {

using Q = Number;
constexpr double eps = std::numeric_limits<double>::epsilon();
template <class V>
using ScalarOf = typename std::remove_cvref_t<V>::Scalar;

auto const outward = [](auto const& y) { return y.eval(); };

/// A motion of the plane, and a map of space-time with its inverse; all polynomials.
struct Motion {
  template <class V>
  auto operator()(V const& x) const {
    using T = ScalarOf<V>;
    return Matrix<T, 2, 1>(x[1] + x[0] * x[2] * x[1], x[2] * x[2] - x[0] * x[0] * x[1]);
  }
};
auto const there = []<class T>(Matrix<T, 3, 1> const& x) {
  return Matrix<T, 3, 1>(x[0] + T(x[1] * x[1]), x[1] + T(x[2] * Q(2)), x[2]);
};
auto const back = []<class T>(Matrix<T, 3, 1> const& x) {
  T const first = x[1] - T(x[2] * Q(2));
  return Matrix<T, 3, 1>(T(x[0] - first * first), first, x[2]);
};
/// Places by all that there is.
auto const mixed = []<class T>(Matrix<T, 5, 1> const& p) {
  return Matrix<T, 2, 1>(T(p[3] * Q(3) + p[4] * p[0] + p[1] * p[2]),
                         T(p[4] - p[3] * p[2] * Q(2) + p[0] * p[0] + p[2]));
};

}  // namespace

BOOST_AUTO_TEST_SUITE(noether_figures)

BOOST_AUTO_TEST_CASE(a_divergence_is_measured_by_the_rates_of_the_field) {
  // The field (y_1, y_2) has divergence 2, and its Lie derivative of the metric is twice the identity.
  Vector<double, 2> const y(0.4, 1.3);
  auto const divergent = [&](double rate) { require_divergence_free(Euclidean<2>{}, outward, y, rate); };
  auto const stretching = [&](double rate) { require_killing(Euclidean<2>{}, outward, y, rate); };
  for (double const rate : {1.0, 4.0, 0.125}) {
    auto const one = caught<NotDivergenceFree>([&] { divergent(rate); });
    BOOST_TEST(one.measured == 2 / rate);
    BOOST_TEST(one.bound == 512 * eps);
    auto const other = caught<NotKilling>([&] { stretching(rate); });
    BOOST_TEST(other.measured == 2 / rate);
    BOOST_TEST(other.bound == 512 * eps);
  }
  // Where the field has no rate it is what it is.
  BOOST_TEST(caught<NotDivergenceFree>([&] { divergent(0); }).measured == 2);
  BOOST_TEST(caught<NotKilling>([&] { stretching(0); }).measured == 2);
  // Two is rounding beside a rate of 2/(512 eps), and not beside half of it.
  double const enough = 2 / (512 * eps);
  BOOST_CHECK_NO_THROW(divergent(enough));
  BOOST_CHECK_NO_THROW(stretching(enough));
  CHECK_REFUSED(divergent(enough / 2), NotDivergenceFree);
  CHECK_REFUSED(stretching(enough / 2), NotKilling);
  CHECK_REFUSED(require_killing(
                    Euclidean<2>{}, [](auto const& z) { return (z * std::nan("")).eval(); }, y, 1.0),
                NotFinite);
  // In space each has one part in 768.
  Vector<double, 3> const z(0.4, 1.3, -2);
  BOOST_TEST(caught<NotKilling>([&] { require_killing(Euclidean<3>{}, outward, z, 1.0); }).bound ==
             768 * eps);
  BOOST_TEST(caught<NotDivergenceFree>([&] {
               require_divergence_free(Euclidean<3>{}, outward, z, 2.0);
             }).measured == 1.5);
}

BOOST_AUTO_TEST_CASE(a_relabelling_of_space_is_the_curl_of_its_potential) {
  WithArithmetic const exactly(Arithmetic::rationals());
  auto const potential = []<class T>(Matrix<T, 3, 1> const& x) {
    return Matrix<T, 3, 1>(T(x[1] * x[2] * x[2]), T(x[0] * x[0] * x[2]), T(x[0] * x[1] * x[1]));
  };
  Matrix<Q, 3, 1> const x(Q(2), Q(3) / 2, Q(-5) / 7);
  auto const field = RelabellingField{Euclidean<3>{}, potential};
  BOOST_TEST((field(x) == Matrix<Q, 3, 1>(2 * x[0] * x[1] - x[0] * x[0], 2 * x[1] * x[2] - x[1] * x[1],
                                          2 * x[0] * x[2] - x[2] * x[2])));
  auto const stream = []<class T>(Matrix<T, 2, 1> const& p) {
    return Matrix<T, 1, 1>(T(p[0] * p[0] * p[1]));
  };
  auto const plane =
      RelabellingField{ConstantMetric<Q, 2>{Matrix<Q, 2, 2>(Matrix<Q, 2, 2>::Identity() * Q(3))}, stream};
  Matrix<Q, 2, 1> const p(Q(2), Q(5));
  BOOST_TEST((plane(p) == Matrix<Q, 2, 1>(Q(4) / 3, Q(-20) / 3)));
}

BOOST_AUTO_TEST_CASE(a_prolonged_jet_is_that_of_the_moved_section) {
  WithArithmetic const exactly(Arithmetic::rationals());
  Automorphism const eta{there, mixed};
  Matrix<Q, 3, 1> const x(Q(1) / 3, Q(-1) / 7, Q(2) / 5);
  BOOST_TEST((back(there(x)) == x));
  auto const j = first_jet(Motion{}, x), lifted = prolongation(eta, j),
             moved = first_jet(moved_section(eta, back, Motion{}), there(x));
  BOOST_TEST((lifted.x == moved.x));
  BOOST_TEST((lifted.y == moved.y));
  BOOST_TEST((lifted.v == moved.v));
  // On dual jets it leaves the value on a jet, as a density.
  DualJet<Q, 2, 2> z{j.x, j.y, Q(3) / 4, Matrix<Q, 2, 3>::Zero()};
  for (int a = 0; a < 2; ++a)
    for (int mu = 0; mu < 3; ++mu) z.p(a, mu) = Q(1 + 2 * a - 3 * mu + a * mu) / 5;
  auto const d = tangent<2, 2>(eta, j.x, j.y);
  BOOST_TEST((pairing(dual_prolongation(eta, z), lifted) * determinant(d.base) == pairing(z, j)));
}

BOOST_AUTO_TEST_CASE(an_automorphism_without_inverse_is_refused_with_the_figures_of_its_matrix) {
  auto const fold = []<class T>(Matrix<T, 3, 1> const& x) {
    return Matrix<T, 3, 1>(x[0], T(x[1] + x[2] * 2.0), T(x[1] * 2.0 + x[2] * 4.0));
  };
  Automorphism const eta{fold, FixedFibre<2>{}};
  Jet<double, 2, 2> const j{{0.3, 0.8, -0.4}, {1, 2}, Matrix<double, 2, 3>::Ones()};
  auto const of_matrix = caught<Singular>([&] { inverse_matrix(tangent<2, 2>(eta, j.x, j.y).base, "fold"); });
  auto const refused = caught<Singular>([&] { prolongation(eta, j); });
  BOOST_TEST(refused.measured == of_matrix.measured);
  BOOST_TEST(refused.bound == of_matrix.bound);
  DualJet<double, 2, 2> const z{j.x, j.y, 3, Matrix<double, 2, 3>::Ones()};
  auto const dual = caught<Singular>([&] { dual_prolongation(eta, z); });
  BOOST_TEST(dual.measured == 0);
  BOOST_TEST(dual.bound == 0);
}

BOOST_AUTO_TEST_CASE(energy_flows_with_the_momenta_times_the_velocity) {
  WithArithmetic const exactly(Arithmetic::rationals());
  // L = v_0^2 + 2 v_0 v_1 - 3 v_1^2 + x y: p = (2 v_0 + 2 v_1, 2 v_0 - 6 v_1), and p_0 v_0 - L.
  auto const density = []<class T>(Jet<T, 1, 1> const& j) {
    T const a = j.v(0, 0), b = j.v(0, 1);
    return T(a * a + a * b * Q(2) - b * b * Q(3) + j.x[1] * j.y[0]);
  };
  Jet<Q, 1, 1> const j{{Q(1), Q(2)}, Matrix<Q, 1, 1>(Q(5)), Matrix<Q, 1, 2>(Q(7), Q(11))};
  auto const current = energy_current(density, j);
  BOOST_TEST((current[0] == 7 * 7 + 3 * 11 * 11 - 2 * 5));
  BOOST_TEST((current[1] == (2 * 7 - 6 * 11) * 7));
}

BOOST_AUTO_TEST_SUITE_END()
