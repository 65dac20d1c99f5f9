// What media refuse, and what does not compile: each refusal names the point, what was measured and the
// bound.
#include <boost/test/unit_test.hpp>

#include "actio/continuum/continuum_equations.hpp"
#include "actio/jets/field_equations.hpp"
#include "refused.hpp"
#include "witness/number.hpp"

using namespace actio;

namespace {

/// A jet at the point (0, 3/10, -2/5) of the body with this deformation gradient.
template <class S>
SecondJet<S, 2, 2> jet_with(Matrix<S, 2, 2> const& F) {
  SecondJet<S, 2, 2> j;
  j.x << S(0), ratio<S>(3, 10), ratio<S>(-2, 5);
  j.y << ratio<S>(1, 2), ratio<S>(1, 4);
  j.v.setZero();
  j.v.template rightCols<2>() = F;
  for (auto& w : j.w) w.setZero();
  return j;
}
template <class S>
SecondJet<S, 2, 2> at_rest() { return jet_with<S>(Matrix<S, 2, 2>::Identity()); }

/// A metric of this value.
template <class S>
ConstantMetric<S, 2> metric(S const& a, S const& b, S const& c, S const& d) {
  Matrix<S, 2, 2> g;
  g << a, b, c, d;
  return {g};
}

/// Calls everything that takes a medium with any metric, and checks that all refuse alike.
template <class E, class Medium, class S, class Judge>
void all_refuse(Medium const& medium, SecondJet<S, 2, 2> const& j, Judge const& judge) {
  Jet<S, 2, 2> const& first = j;
  BOOST_CHECK_EXCEPTION(momenta(medium, first), E, judge);
  BOOST_CHECK_EXCEPTION(legendre(medium, first), E, judge);
  BOOST_CHECK_EXCEPTION(euler_lagrange(medium, j), E, judge);
  BOOST_CHECK_EXCEPTION(medium_equation(medium, j), E, judge);
  BOOST_CHECK_EXCEPTION(stress_equation(medium, j), E, judge);
  BOOST_CHECK_EXCEPTION(solid_equation(medium, j), E, judge);
  BOOST_CHECK_EXCEPTION(first_piola_kirchhoff_stress(medium, first), E, judge);
  BOOST_CHECK_EXCEPTION(cauchy_stress(medium, first), E, judge);
}
bool says(Error const& error, std::string const& text) {
  return std::string(error.what()).find(text) != std::string::npos;
}

Homogeneous<double> const mass{2.0};
Barotropic<WholePolytropic<double, 2>> const gas{{1.0}};
std::string const particle = "(0.3, -0.4)", place = "(0.5, 0.25)";

}  // namespace

BOOST_AUTO_TEST_CASE(a_matrix_that_is_not_symmetric_is_no_metric) {
  auto const judge = [&](std::string const& where) {
    return [where](NotAMetric const& e) {
      return says(e, where) && says(e, "symmetric") && e.measured > 0.2 && e.bound < 1e-13;
    };
  };
  all_refuse<NotAMetric>(Continuum{metric(1.0, 0.5, 0.2, 1.0), Euclidean<2>{}, mass, gas}, at_rest<double>(),
                         judge("body at " + particle));
  all_refuse<NotAMetric>(Continuum{Euclidean<2>{}, metric(1.0, 0.5, 0.2, 1.0), mass, gas}, at_rest<double>(),
                         judge("space at " + place));
}

BOOST_AUTO_TEST_CASE(a_matrix_that_is_not_positive_is_no_metric) {
  auto const judge = [&](std::string const& where) {
    return [where](NotAMetric const& e) {
      return says(e, where) && says(e, "positive definite") && e.measured <= e.bound;
    };
  };
  all_refuse<NotAMetric>(Continuum{metric(1.0, 2.0, 2.0, 1.0), Euclidean<2>{}, mass, gas}, at_rest<double>(),
                         judge("body at " + particle));
  all_refuse<NotAMetric>(Continuum{Euclidean<2>{}, metric(1.0, 1.0, 1.0, 1.0), mass, gas}, at_rest<double>(),
                         judge("space at " + place));
  all_refuse<NotAMetric>(Continuum{Euclidean<2>{}, metric(-1.0, 0.0, 0.0, -1.0), mass, gas},
                         at_rest<double>(), judge("space at " + place));
  double const none = std::nan("");
  all_refuse<NotFinite>(Continuum{Euclidean<2>{}, metric(none, 0.0, 0.0, 1.0), mass, gas}, at_rest<double>(),
                        [](NotFinite const& e) { return says(e, place); });
}

BOOST_AUTO_TEST_CASE(a_body_turned_inside_out_is_refused_with_its_jacobian) {
  auto const judge = [](double J) {
    return [J](NotOrientationPreserving const& e) {
      return says(e, particle) && e.measured == J && e.bound == 0;
    };
  };
  Continuum const fluid{Euclidean<2>{}, Euclidean<2>{}, mass, gas};
  Continuum const solid{Euclidean<2>{}, Euclidean<2>{}, mass,
                        OfGreenTensor{NeoHookean{1.0, LogarithmicVolume<double>{1.0}}}};
  for (double const J : {0.0, -2.0}) {
    Matrix<double, 2, 2> F;
    F << 1, 0.5, 0, J;
    auto const j = jet_with<double>(F);
    all_refuse<NotOrientationPreserving>(fluid, j, judge(J));
    all_refuse<NotOrientationPreserving>(solid, j, judge(J));
    BOOST_CHECK_EXCEPTION(fluid_equation(fluid, j), NotOrientationPreserving, judge(J));
    BOOST_CHECK_EXCEPTION(material_pressure(fluid, static_cast<Jet<double, 2, 2> const&>(j)),
                          NotOrientationPreserving, judge(J));
    // A solid whose energy does not see it has momenta there, and no Cauchy stress.
    Continuum const soft{Euclidean<2>{}, Euclidean<2>{}, mass,
                         OfGreenTensor{StVenantKirchhoff<double>{1, 1}}};
    BOOST_CHECK_NO_THROW(euler_lagrange(soft, j));
    BOOST_CHECK_EXCEPTION(cauchy_stress(soft, static_cast<Jet<double, 2, 2> const&>(j)),
                          NotOrientationPreserving, judge(J));
  }
  Matrix<double, 2, 2> F;
  F << std::nan(""), 0, 0, 1;
  all_refuse<NotOrientationPreserving>(
      fluid, jet_with<double>(F), [](NotOrientationPreserving const& e) { return std::isnan(e.measured); });
}

BOOST_AUTO_TEST_CASE(mass_that_is_not_positive_is_refused) {
  // 1 - 5 x^1 at x^1 = 3/10.
  LinearDensity<double, 2> const rho{1.0, {-5.0, 0.0}};
  all_refuse<NotAMassDensity>(
      Continuum{Euclidean<2>{}, Euclidean<2>{}, rho, gas}, at_rest<double>(), [](NotAMassDensity const& e) {
        return says(e, particle) && std::abs(e.measured + 0.5) < 1e-15 && e.bound == 0;
      });
}

BOOST_AUTO_TEST_CASE(an_energy_without_derivative_at_rest_is_refused_with_the_point) {
  // The size of the strain, not its square: a cone.
  auto const cone = [](auto const& C) {
    using std::sqrt;
    auto E = C;
    for (int i = 0; i < 2; ++i) E(i, i) -= 1;
    return sqrt(E.cwiseProduct(E).sum());
  };
  Continuum const solid{Euclidean<2>{}, Euclidean<2>{}, mass, OfGreenTensor{cone}};
  all_refuse<NoDerivative>(solid, at_rest<double>(),
                           [](NoDerivative const& e) { return says(e, "(0, 0.3, -0.4)"); });
  Matrix<double, 2, 2> F;
  F << 1.1, 0, 0, 1;
  BOOST_CHECK_NO_THROW(euler_lagrange(solid, jet_with<double>(F)));
  // At rest there is a first derivative of the strain to the power 3/2, and no second one.
  auto const cusp = [](auto const& C) {
    using std::pow;
    auto E = C;
    for (int i = 0; i < 2; ++i) E(i, i) -= 1;
    return pow(E.cwiseProduct(E).sum(), 0.75);
  };
  auto j = at_rest<double>();
  j.w[1](0, 1) = 1;
  Continuum const blunt{Euclidean<2>{}, Euclidean<2>{}, mass, OfGreenTensor{cusp}};
  CHECK_REFUSED(euler_lagrange(blunt, j), NoDerivative);
  CHECK_REFUSED(medium_equation(blunt, j), NoDerivative);
  CHECK_REFUSED(solid_equation(blunt, j), NoDerivative);
}

BOOST_AUTO_TEST_CASE(an_irrational_volume_is_refused_over_the_rationals) {
  WithArithmetic const exactly(Arithmetic::rationals());
  using S = Number;
  auto const judge = [](std::string const& where) {
    return [where](NotASquare const& e) { return says(e, where) && e.measured == 2 && e.bound == 0; };
  };
  auto const two = metric(S(2), S(0), S(0), S(1));
  Barotropic<WholePolytropic<S, 2>> const W{{S(1)}};
  all_refuse<NotASquare>(Continuum{two, Euclidean<2>{}, Homogeneous<S>{S(2)}, W}, at_rest<S>(),
                         judge("body at " + particle));
  all_refuse<NotASquare>(Continuum{Euclidean<2>{}, two, Homogeneous<S>{S(2)}, W}, at_rest<S>(),
                         judge(particle));
  // A solid has no use for the volume of space until it is asked for its Cauchy stress.
  Continuum const solid{Euclidean<2>{}, two, Homogeneous<S>{S(2)},
                        OfGreenTensor{StVenantKirchhoff<S>{S(1), S(1)}}};
  BOOST_CHECK_NO_THROW(euler_lagrange(solid, at_rest<S>()));
  BOOST_CHECK_EXCEPTION(cauchy_stress(solid, static_cast<Jet<S, 2, 2> const&>(at_rest<S>())), NotASquare,
                        judge("space at " + place));
}

BOOST_AUTO_TEST_CASE(dimensions_that_do_not_fit_do_not_compile) {
  using Fluid =
      Continuum<Euclidean<2>, Euclidean<3>, Homogeneous<double>, Barotropic<WholePolytropic<double, 2>>>;
  using Membrane =
      Continuum<Euclidean<2>, Euclidean<3>, Homogeneous<double>, OfGreenTensor<StVenantKirchhoff<double>>>;
  using Planar =
      Continuum<Euclidean<2>, Euclidean<2>, Homogeneous<double>, OfGreenTensor<StVenantKirchhoff<double>>>;
  using Constant = Continuum<ConstantMetric<double, 2>, ConstantMetric<double, 2>, Homogeneous<double>,
                             OfGreenTensor<StVenantKirchhoff<double>>>;
  // A surface in space may be a solid; a fluid has a Jacobian, so that body and space are of one dimension.
  static_assert(DensityOver<Membrane, double, 2, 3>);
  static_assert(!DensityOver<Fluid, double, 2, 3>);
  static_assert(!DensityOver<Planar, double, 3, 3> && !DensityOver<Planar, double, 2, 3> &&
                !DensityOver<Constant, double, 3, 3>);
  static_assert(DensityOver<Planar, double, 2, 2> && DensityOver<Constant, double, 2, 2>);

  auto const field_equations = []<class Medium, int n, int N>(Medium const& medium,
                                                              SecondJet<double, n, N> const& j) {
    return requires { euler_lagrange(medium, j); } && requires { medium_equation(medium, j); } &&
           requires { solid_equation(medium, j); };
  };
  auto const cauchy = []<class Medium, int n, int N>(Medium const& medium, Jet<double, n, N> const& j) {
    return requires { cauchy_stress(medium, j); };
  };
  auto const pressure = []<class Medium, int n, int N>(Medium const& medium, Jet<double, n, N> const& j) {
    return requires { material_pressure(medium, j); };
  };
  Membrane const membrane{};
  Planar const planar{};
  Continuum const fluid{Euclidean<2>{}, Euclidean<2>{}, mass, gas};
  BOOST_TEST(field_equations(membrane, SecondJet<double, 2, 3>{}));
  BOOST_TEST(!field_equations(planar, SecondJet<double, 3, 3>{}));
  BOOST_TEST(!field_equations(planar, SecondJet<double, 2, 3>{}));
  BOOST_TEST(!field_equations(Fluid{}, SecondJet<double, 2, 3>{}));
  BOOST_TEST(cauchy(planar, Jet<double, 2, 2>{}));
  BOOST_TEST(!cauchy(membrane, Jet<double, 2, 3>{}));
  // Only a fluid has a material pressure.
  BOOST_TEST(pressure(fluid, Jet<double, 2, 2>{}));
  BOOST_TEST(!pressure(planar, Jet<double, 2, 2>{}));
}
