// The constraint of incompressible media, what it refuses, and the pressure that goes with it.
#include <boost/test/unit_test.hpp>

#include "actio/incompressible/two_pressures.hpp"
#include "actio/jets/field_equations.hpp"
#include "caught.hpp"
#include "refused.hpp"

using namespace actio;
using testing::caught;

namespace {

using Flat = Euclidean<2>;
VolumeConstraint<Flat, Flat> const volume_kept{};

/// The jet of a linear map at rest.
Jet<double, 2, 2> jet_of(Matrix<double, 2, 2> const& F,
                         Vector<double, 2> const& velocity = Vector<double, 2>::Zero()) {
  Jet<double, 2, 2> j{{0, 0.3, -0.2}, F * Vector<double, 2>(0.3, -0.2), {}};
  j.v << velocity, F;
  return j;
}
Matrix<double, 2, 2> matrix(double a, double b, double c, double d) {
  return (Matrix<double, 2, 2>() << a, b, c, d).finished();
}

auto const fluid = incompressible(Continuum{Flat{}, Flat{}, Homogeneous<double>{2}, NoStoredEnergy{}});

/// A jet of the extended bundle over a linear map with pressure.
Jet<double, 2, 3> with_multiplier(Matrix<double, 2, 2> const& F, double lambda) {
  auto const below = jet_of(F, {0.5, 1.5});
  Jet<double, 2, 3> j{below.x, {below.y[0], below.y[1], lambda}, Matrix<double, 3, 3>::Zero()};
  j.v.topRows<2>() = below.v;
  return j;
}

/// A metric that is not one.
struct Indefinite {
  template <class V>
  auto operator()(V const&) const {
    Matrix<typename V::Scalar, 2, 2> g = Matrix<typename V::Scalar, 2, 2>::Identity();
    g(1, 1) = typename V::Scalar(-1.0);
    return g;
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(shears_keep_the_volume_and_stretches_do_not) {
  BOOST_TEST(volume_kept(jet_of(matrix(1, 3, 0, 1)))[0] == 0);
  BOOST_TEST(volume_kept(jet_of(matrix(2, 0, 0, 0.5)))[0] == 0);
  BOOST_TEST(volume_kept(jet_of(matrix(2, 0, 0, 2)))[0] == 3);
}

BOOST_AUTO_TEST_CASE(a_body_turned_inside_out_or_flattened_is_refused_with_its_volume) {
  auto const error =
      caught<NotOrientationPreserving>([&] { momenta(fluid, with_multiplier(matrix(1, 0, 0, -2), 1)); });
  BOOST_TEST(error.measured == -2);
  BOOST_TEST(std::string(error.what()).find("volume constraint") != std::string::npos);
  CHECK_REFUSED(momenta(fluid, with_multiplier(matrix(1, 2, 2, 4), 1)), NotOrientationPreserving);
  CHECK_REFUSED(legendre(fluid, with_multiplier(Matrix<double, 2, 2>::Zero(), 1)), NotOrientationPreserving);
  CHECK_REFUSED(incompressible_momenta(fluid, with_multiplier(matrix(1, 0, 0, -2), 1)),
                NotOrientationPreserving);
}

BOOST_AUTO_TEST_CASE(numbers_that_are_none_and_metrics_that_are_none_are_refused) {
  CHECK_REFUSED(momenta(fluid, with_multiplier(matrix(NAN, 0, 0, 1), 1)), Error);
  CHECK_REFUSED(momenta(fluid, with_multiplier(matrix(1, 0, 0, 1), NAN)), NotFinite);
  auto const odd = incompressible(Continuum{Indefinite{}, Flat{}, Homogeneous<double>{1}, NoStoredEnergy{}});
  CHECK_REFUSED(momenta(odd, with_multiplier(matrix(1, 0, 0, 1), 1)), NotAMetric);
}

BOOST_AUTO_TEST_CASE(the_constraint_is_regular_where_the_volume_is_positive_and_not_where_all_is_flat) {
  BOOST_CHECK_NO_THROW(require_regular(volume_kept, jet_of(matrix(1, 3, 0, 1))));
  CHECK_REFUSED(require_regular(volume_kept, jet_of(Matrix<double, 2, 2>::Zero())), NotRegular);
}

BOOST_AUTO_TEST_CASE(the_pressure_of_the_multiplier_pushes_outwards) {
  // A square of fluid at rest under pressure 5: the momenta of space are the pressure times the normals'
  // areas.
  auto const z = legendre(fluid, with_multiplier(Matrix<double, 2, 2>::Identity(), 5));
  BOOST_TEST(z.p(0, 1) == 5);
  BOOST_TEST(z.p(1, 2) == 5);
  BOOST_TEST(z.p(0, 2) == 0);
  BOOST_TEST(z.p.row(2).cwiseAbs().maxCoeff() == 0);
  BOOST_TEST(z.p(0, 0) == 1);
}

BOOST_AUTO_TEST_CASE(two_pressures_add) {
  auto const gas =
      Continuum{Flat{}, Flat{}, Homogeneous<double>{2}, Barotropic{WholePolytropic<double, 1>{3}}};
  auto const both = pressures(gas, with_multiplier(matrix(2, 0, 0, 0.5), 7));
  // W = 3/J: the pressure is 2 * 3 at J = 1.
  BOOST_TEST(both.stored == 6);
  BOOST_TEST(both.multiplier == 7);
  BOOST_TEST(both.total() == 13);
  CHECK_REFUSED(pressures(gas, with_multiplier(matrix(1, 0, 0, -1), 7)), NotOrientationPreserving);
}
