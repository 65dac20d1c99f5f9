// Symmetries of media: what is refused, with what was measured, and laws beside the theorem checks.
#include <boost/test/unit_test.hpp>

#include "actio/noether/circulation.hpp"
#include "actio/noether/current_divergence.hpp"
#include "actio/noether/isometries.hpp"
#include "actio/noether/relabelling.hpp"
#include "actio/noether/time_translation.hpp"
#include "refused.hpp"

using namespace actio;

namespace {

using Place = Vector<double, 2>;

/// The plane in polar coordinates: its volume is r.
struct Polar {
  template <class V>
  auto operator()(V const& x) const {
    Matrix<typename V::Scalar, 2, 2> G = Matrix<typename V::Scalar, 2, 2>::Identity();
    G(1, 1) = x[0] * x[0];
    return G;
  }
};
/// A stream function on the body.
struct Stream {
  template <class V>
  auto operator()(V const& x) const {
    return Matrix<typename V::Scalar, 1, 1>(x[0] * x[0] * x[1] + x[1] * x[1]);
  }
};
/// A gas of the plane that moves along, turning about the origin at unit rate when it is laid out in polar
/// coordinates.
struct Turning {
  template <class V>
  auto operator()(V const& x) const {
    using std::cos, std::sin;
    using T = typename V::Scalar;
    T const angle = x[2] + x[0];
    return Matrix<T, 2, 1>(x[1] * cos(angle), x[1] * sin(angle));
  }
};
auto const gas =
    Continuum{Polar{}, Euclidean<2>{}, Homogeneous<double>{2}, Barotropic{WholePolytropic<double, 1>{0.5}}};
Event<double, 2> const event(0.3, 0.8, -0.4);
auto const fold = [](auto const& x) { return std::remove_cvref_t<decltype(x)>(x[0] + x[1], x[0] + x[1]); };

}  // namespace

BOOST_AUTO_TEST_CASE(an_automorphism_without_inverse_is_refused_with_its_pivot_and_point) {
  auto const j = first_jet(Turning{}, event);
  auto const says_where = [](Singular const& e) {
    return e.measured <= e.bound && std::string(e.what()).find("(0.3, 0.8, -0.4)") != std::string::npos;
  };
  BOOST_CHECK_EXCEPTION(prolongation(relabelling<2>(fold), j), Singular, says_where);
  BOOST_CHECK_EXCEPTION(equivariance_defect(gas, relabelling<2>(fold), j), Singular, says_where);
  DualJet<double, 2, 2> const z{event, {1, 2}, 3, Matrix<double, 2, 3>::Ones()};
  BOOST_CHECK_EXCEPTION(dual_prolongation(relabelling<2>(fold), z), Singular, says_where);
  auto const flat = Automorphism{[](auto const& x) { return x; },
                                 [](auto const& point) {
                                   return Matrix<typename std::remove_cvref_t<decltype(point)>::Scalar, 2, 1>(
                                       point[3], point[3]);
                                 }};
  CHECK_REFUSED(dual_prolongation(flat, z), Singular);
}

BOOST_AUTO_TEST_CASE(a_field_with_divergence_is_refused_with_the_divergence_measured) {
  Place const x(0.8, -0.4);
  BOOST_CHECK_NO_THROW(require_divergence_free(Polar{}, RelabellingField{Polar{}, Stream{}}, x, 1.0));
  auto const outward = [](auto const& y) { return std::remove_cvref_t<decltype(y)>(y[0], 0 * y[1]); };
  // In polar coordinates the divergence of r d/dr is 2.
  BOOST_CHECK_EXCEPTION(
      require_divergence_free(Polar{}, outward, x, 1.0), NotDivergenceFree,
      [](NotDivergenceFree const& e) { return std::abs(e.measured - 2) < 1e-14 && e.bound < 1e-12; });
  // A field that is divergence-free for a body with constant volume is not one here.
  CHECK_REFUSED(require_divergence_free(Polar{}, RelabellingField{Euclidean<2>{}, Stream{}}, x, 1.0),
                NotDivergenceFree);
  auto const none = [](auto const& y) { return (y * std::nan("")).eval(); };
  CHECK_REFUSED(require_divergence_free(Polar{}, none, x, 1.0), NotFinite);
}

BOOST_AUTO_TEST_CASE(a_field_that_does_not_preserve_the_metric_is_refused) {
  StereographicSphere<double, 2> const sphere{3};
  Matrix<double, 2, 2> turn;
  turn << 0, -2, 2, 0;
  Place const y(0.4, 1.3), tilt(0.5, -1);
  BOOST_CHECK_NO_THROW(require_killing(sphere, SphereRotation<double, 2>{turn, tilt}, y, 9.0));
  BOOST_CHECK_NO_THROW(require_killing(Euclidean<2>{}, RigidMotion<double, 2>{turn, tilt}, y, 1.0));
  BOOST_CHECK_EXCEPTION(require_killing(
                            Euclidean<2>{}, [](auto const& at) { return at.eval(); }, y, 1.0),
                        NotKilling, [](NotKilling const& e) { return e.measured == 2; });
  CHECK_REFUSED(require_killing(sphere, RigidMotion<double, 2>{turn, tilt}, y, 9.0), NotKilling);
}

BOOST_AUTO_TEST_CASE(a_gas_turned_inside_out_has_no_current) {
  auto const mirrored = [](auto const& x) {
    return Matrix<typename std::remove_cvref_t<decltype(x)>::Scalar, 2, 1>(x[2], x[1]);
  };
  auto const j = second_jet(mirrored, event);
  auto const first = static_cast<Jet<double, 2, 2> const&>(j);
  auto const field = relabelling_field<2>(RelabellingField{Polar{}, Stream{}});
  CHECK_REFUSED(noether_current(gas, field, first), NotOrientationPreserving);
  CHECK_REFUSED(current_divergence(gas, field, j), NotOrientationPreserving);
  CHECK_REFUSED(equivariance_rate(gas, field, first), NotOrientationPreserving);
  CHECK_REFUSED(barotropic_relabelling_current(gas, Place(1, 0), first), NotOrientationPreserving);
  CHECK_REFUSED(energy_current(gas, first), NotOrientationPreserving);
}

BOOST_AUTO_TEST_CASE(prolongations_compose) {
  auto const shear = [](auto const& x) { return std::remove_cvref_t<decltype(x)>(x[0] + x[1] * x[1], x[1]); };
  auto const squeeze = [](auto const& x) {
    return std::remove_cvref_t<decltype(x)>(x[0] * 2 + x[1], x[1] * 3);
  };
  auto const both = [&](auto const& x) { return squeeze(shear(x)); };
  auto const j = first_jet(Turning{}, event);
  auto const once = prolongation(relabelling<2>(both), j),
             twice = prolongation(relabelling<2>(squeeze), prolongation(relabelling<2>(shear), j));
  BOOST_TEST((once.v - twice.v).norm() < 1e-14);
  BOOST_TEST((once.x - twice.x).norm() < 1e-14);
}

BOOST_AUTO_TEST_CASE(a_turning_disc_has_the_circulation_of_its_rotation) {
  // Along a material circle of radius r: 2 pi r^2, wherever the loop is wavy in between twice the area it
  // encloses.
  auto const circle = [](auto const& a) {
    return Matrix<std::remove_cvref_t<decltype(a)>, 2, 1>(0 * a + 0.5, a);
  };
  BOOST_TEST(std::abs(circulation(Turning{}, Euclidean<2>{}, circle, 0.7) - std::numbers::pi / 2) < 1e-14);
  auto const wavy = [](auto const& a) {
    using std::cos;
    return Matrix<std::remove_cvref_t<decltype(a)>, 2, 1>(0.5 + 0.1 * cos(4 * a), a);
  };
  double const area = std::numbers::pi * (0.25 + 0.005);
  BOOST_TEST(std::abs(circulation(Turning{}, Euclidean<2>{}, wavy, 0.7) - 2 * area) < 1e-14);
  // The vorticity form is twice the area form, r dr dtheta.
  BOOST_TEST(std::abs(material_vorticity(Euclidean<2>{}, second_jet(Turning{}, event))(0, 1) - 2 * event[1]) <
             1e-14);
  // y = (x1 + 2 t x2, x2 + t x1) at t = 0: the velocity form is (2 x2, x1), with both slopes across.
  auto const across = [](auto const& x) {
    using T = typename std::remove_cvref_t<decltype(x)>::Scalar;
    return Matrix<T, 2, 1>(T(x[1] + x[0] * x[2] * 2.0), T(x[2] + x[0] * x[1]));
  };
  auto const vorticity =
      material_vorticity(Euclidean<2>{}, second_jet(across, Vector<double, 3>(0, 0.4, 0.7)));
  BOOST_TEST(std::abs(vorticity(0, 1) + 1) < 1e-14);
  BOOST_TEST(std::abs(vorticity(1, 0) - 1) < 1e-14);
  BOOST_TEST(vorticity.diagonal().norm() == 0);
}
