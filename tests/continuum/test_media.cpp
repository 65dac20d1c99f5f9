// Laws of continuous media: metrics as types and as matrices, Christoffel symbols, materials at rest, under
// small strains, turned, and compressed.
#include <boost/test/unit_test.hpp>

#include <algorithm>

#include "actio/continuum/continuum_equations.hpp"
#include "actio/jets/field_equations.hpp"
#include "witness/draw.hpp"
#include "witness/number.hpp"

using namespace actio;

namespace {

double const eps = epsilon<double>();
template <class S, int n>
using Square = Matrix<S, n, n>;

/// A second jet near that of the body at rest, of no section.
template <class S, int n>
SecondJet<S, n, n> any_second_jet(FineDraw& draw) {
  SecondJet<S, n, n> j;
  S const size = ratio<S>(1, 5);
  j.x = draw.vector<S, Event<S, n>>(n + 1);
  j.y = draw.vector<S, Matrix<S, n, 1>>(n);
  for (int mu = 0; mu <= n; ++mu) {
    j.v.col(mu) = draw.vector<S, Matrix<S, n, 1>>(n) * size;
    if (mu > 0) j.v(mu - 1, mu) += S(1);
    for (int nu = 0; nu <= mu; ++nu)
      j.w[mu].col(nu) = draw.vector<S, Matrix<S, n, 1>>(n), j.w[nu].col(mu) = j.w[mu].col(nu);
  }
  return j;
}

/// The body at rest but for its deformation gradient.
template <class S, int n>
Jet<S, n, n> strained(Square<S, n> const& F) {
  Jet<S, n, n> j{Event<S, n>::Zero(), Matrix<S, n, 1>::Zero(), Matrix<S, n, n + 1>::Zero()};
  j.v.template rightCols<n>() = F;
  return j;
}

/// The identity as a matrix that is the same everywhere, and as a function that the compiler knows nothing
/// about.
template <class S, int n>
ConstantMetric<S, n> constant_identity() { return {Square<S, n>::Identity()}; }
struct IdentitySomehow {
  template <class T, int n>
  Square<T, n> operator()(Matrix<T, n, 1> const&) const { return Square<T, n>::Identity(); }
};

/// The unit sphere in angles.
struct Sphere {
  template <class T>
  Square<T, 2> operator()(Matrix<T, 2, 1> const& y) const {
    using std::sin;
    Square<T, 2> g;
    g << T(1), T(0), T(0), sin(y[0]) * sin(y[0]);
    return g;
  }
};

/// The largest difference between what two media make of the same motion: momenta, field equations, and all
/// the forms of them.
template <class A, class B, int n>
Number gap(A const& a, B const& b, SecondJet<Number, n, n> const& j) {
  Jet<Number, n, n> const& first = j;
  std::vector<Number> const gaps{magnitude((momenta(a, first) - momenta(b, first)).eval()),
                                 magnitude((euler_lagrange(a, j) - euler_lagrange(b, j)).eval()),
                                 magnitude((medium_equation(a, j) - medium_equation(b, j)).eval()),
                                 magnitude((stress_equation(a, j) - stress_equation(b, j)).eval()),
                                 magnitude((solid_equation(a, j) - solid_equation(b, j)).eval()),
                                 magnitude((cauchy_stress(a, first) - cauchy_stress(b, first)).eval())};
  return *std::max_element(gaps.begin(), gaps.end());
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_flat_space_as_a_type_as_a_matrix_and_as_a_function_are_one) {
  WithArithmetic const exactly(Arithmetic::rationals());
  FineDraw draw(1);
  using S = Number;
  auto const j = any_second_jet<S, 2>(draw);
  LinearDensity<S, 2> const rho{S(3), {ratio<S>(1, 5), ratio<S>(-1, 7)}};
  OfGreenTensor<NeoHookean<S, PowerVolume<1>>> const W{{S(2), {}}};
  Continuum const type{Euclidean<2>{}, Euclidean<2>{}, rho, W};
  Continuum const matrix{constant_identity<S, 2>(), constant_identity<S, 2>(), rho, W};
  Continuum const function{IdentitySomehow{}, IdentitySomehow{}, rho, W};
  BOOST_TEST((gap(type, matrix, j) == S(0)));
  BOOST_TEST((gap(type, function, j) == S(0)));
  // And all forms of the equations agree: minus the field equations, where volumes and metrics are one.
  BOOST_TEST((magnitude((euler_lagrange(type, j) + medium_equation(type, j)).eval()) == S(0)));
  BOOST_TEST((magnitude((euler_lagrange(type, j) + stress_equation(type, j)).eval()) == S(0)));
  BOOST_TEST((magnitude((euler_lagrange(type, j) + solid_equation(type, j)).eval()) == S(0)));
}

BOOST_AUTO_TEST_CASE(a_flat_metric_stores_nothing) {
  static_assert(std::is_empty_v<Euclidean<3>> && std::is_empty_v<Kronecker<3>>);
  static_assert(is_constant_metric<Euclidean<3>> && is_constant_metric<ConstantMetric<double, 3>> &&
                !is_constant_metric<Sphere>);
  Continuum const flat{Euclidean<3>{}, Euclidean<3>{}, Homogeneous<double>{1},
                       Barotropic{WholeTait<double, 6>{1}}};
  // Two numbers, and an empty object or two that must have an address.
  BOOST_TEST(sizeof(flat) <= 3 * sizeof(double));
}

BOOST_AUTO_TEST_CASE(the_symbols_of_the_sphere_are_the_known_ones) {
  Vector<double, 2> const y(0.7, 2.1);
  auto const gamma = christoffel(Sphere{}, y);
  BOOST_TEST(std::abs(gamma[0](1, 1) + std::sin(0.7) * std::cos(0.7)) < 4 * eps);
  BOOST_TEST(std::abs(gamma[1](0, 1) - std::cos(0.7) / std::sin(0.7)) < 8 * eps);
  BOOST_TEST(gamma[1](0, 1) == gamma[1](1, 0));
  BOOST_TEST(gamma[0](0, 0) == 0);
  BOOST_TEST(gamma[0](0, 1) == 0);
  BOOST_TEST(gamma[1](0, 0) == 0);
  BOOST_TEST(gamma[1](1, 1) == 0);
}

BOOST_AUTO_TEST_CASE(divergences_and_lie_derivatives_on_the_sphere_are_the_known_ones) {
  Vector<double, 2> const y(0.7, 2.1);
  double const s = std::sin(0.7), c = std::cos(0.7);
  // Down the meridians with the velocity theta^2, and around the axis.
  auto const down = [](auto const& z) { return std::remove_cvref_t<decltype(z)>(z[0] * z[0], 0 * z[1]); };
  auto const around = [](auto const& z) { return std::remove_cvref_t<decltype(z)>(0 * z[0], 1 + 0 * z[1]); };
  BOOST_TEST(std::abs(divergence(Sphere{}, down, y) - (2 * 0.7 + 0.49 * c / s)) < 8 * eps);
  BOOST_TEST(divergence(Sphere{}, around, y) == 0);
  BOOST_TEST(divergence(down, y) == 2 * 0.7);
  Square<double, 2> const stretched = lie_derivative(Sphere{}, down, y);
  BOOST_TEST(std::abs(stretched(0, 0) - 4 * 0.7) < 8 * eps);
  BOOST_TEST(std::abs(stretched(1, 1) - 0.49 * 2 * s * c) < 8 * eps);
  BOOST_TEST(stretched(0, 1) == 0);
  BOOST_TEST(stretched(1, 0) == 0);
  BOOST_TEST(magnitude(lie_derivative(Sphere{}, around, y)) == 0);
  // Half of its trace is the divergence.
  Square<double, 2> const g = Sphere{}(y);
  BOOST_TEST(std::abs((stretched(0, 0) / g(0, 0) + stretched(1, 1) / g(1, 1)) / 2 -
                      divergence(Sphere{}, down, y)) < 16 * eps);
}

namespace {

/// \f$\lambda\,(\mathrm{tr}\,\epsilon)\,1 + 2\mu\,\epsilon\f$.
template <class S, int n>
Square<S, n> hooke(Square<S, n> const& strain, S const& lambda, S const& mu) {
  return Square<S, n>::Identity() * (lambda * strain.trace()) + strain * (S(2) * mu);
}

/// A law of a solid: stress-free and without energy at rest, linear elasticity with these moduli under small
/// strains, and blind to turns.
template <int n, class S, class Law>
void is_a_solid(Law const& law, S const& lambda, S const& mu, double bound) {
  Continuum const body{Euclidean<n>{}, Euclidean<n>{}, Homogeneous<S>{S(3)}, OfGreenTensor{law}};
  Square<S, n> const one = Square<S, n>::Identity();
  auto const size = [](auto const& m) { return to_double(magnitude(m.eval())); };
  BOOST_TEST(std::abs(to_double(law(one))) <= bound);
  BOOST_TEST(size(first_piola_kirchhoff_stress(body, strained<S, n>(one))) <= bound);
  BOOST_TEST(size(cauchy_stress(body, strained<S, n>(one))) <= bound);

  FineDraw draw(3);
  for (int sample = 0; sample < 4; ++sample) {
    // The derivative of the stress at rest along H is Hooke's stress of the symmetric part of H.
    Square<S, n> H, A;
    for (int i = 0; i < n; ++i)
      H.col(i) = draw.vector<S, Matrix<S, n, 1>>(n), A.col(i) = draw.vector<S, Matrix<S, n, 1>>(n);
    Square<Dual<S>, n> moved = one.template cast<Dual<S>>();
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < n; ++i) moved(a, i).part[0] = H(a, i);
    auto const stress = first_piola_kirchhoff_stress(body, strained<Dual<S>, n>(moved));
    Square<S, n> rate;
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < n; ++i) rate(a, i) = stress(a, i).part[0];
    Square<S, n> const strain = (H + H.transpose()) / S(2), expected = hooke(strain, lambda, mu) * S(3);
    BOOST_TEST(size(rate - expected) <= bound);

    // A turn by Cayley's map: exact over the rationals.
    Square<S, n> const spin = A - A.transpose(),
                       turn = solve_linear(Square<S, n>(one - spin), Square<S, n>(one + spin)),
                       F = one + H / S(5);
    auto const kept = [&](Square<S, n> const& at) {
      return body.W(Matrix<S, n, 1>(Matrix<S, n, 1>::Zero()), Kronecker<n>{}, Kronecker<n>{}, at);
    };
    BOOST_TEST(std::abs(to_double(S(kept(turn * F) - kept(F)))) <= bound);
    // The stress turns with the body: sigma(QF) = Q sigma(F) Q^T.
    Square<S, n> const sigma = cauchy_stress(body, strained<S, n>(F)),
                       turned = cauchy_stress(body, strained<S, n>(turn * F));
    BOOST_TEST(size(turned - turn * sigma * turn.transpose()) <= bound);
    // And Cauchy's stress is Piola and Kirchhoff's, transformed.
    BOOST_TEST(size(piola_transformation(Kronecker<n>{}, Kronecker<n>{}, F, sigma) -
                    first_piola_kirchhoff_stress(body, strained<S, n>(F))) <= bound);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(solids_are_free_of_stress_at_rest_and_obey_hooke_nearby) {
  WithArithmetic const exactly(Arithmetic::rationals());
  // Exactly: moduli of size 1, mass 3.
  using S = Number;
  S const lambda = ratio<S>(7, 3), mu = ratio<S>(5, 4), c1 = ratio<S>(2, 3), c2 = ratio<S>(1, 5);
  is_a_solid<2>(StVenantKirchhoff<S>{lambda, mu}, lambda, mu, 0);
  is_a_solid<2>(NeoHookean<S, PowerVolume<2>>{mu, {}}, S(4 * mu), mu, 0);
  // lambda = 4 U'' - 2 mu with U'' = (m + 1) (c1 + 2 c2), mu = 2 (c1 + c2).
  is_a_solid<3>(MooneyRivlin<S, PowerVolume<1>>{c1, c2, {}}, S(8 * (c1 + 2 * c2) - 4 * (c1 + c2)),
                S(2 * (c1 + c2)), 0);
  // With logarithms, in double: stresses of size 10, some hundred operations.
  is_a_solid<2>(NeoHookean{1.25, LogarithmicVolume<double>{7.0 / 3}}, 7.0 / 3, 1.25, 1000 * eps);
}

BOOST_AUTO_TEST_CASE(fluids_have_the_pressures_that_their_names_say) {
  double const J = 1.3, rho = 2.5, K = 0.8, gamma = 1.4;
  Matrix<double, 2, 2> F;
  F << 1.3, 0.4, 0, 1;
  auto const pressure = [&](auto const& law) {
    return material_pressure(
        Continuum{Euclidean<2>{}, Euclidean<2>{}, Homogeneous<double>{rho}, Barotropic{law}},
        strained<double, 2>(F));
  };
  BOOST_TEST(std::abs(pressure(Polytropic<double>{K, gamma}) - rho * K * std::pow(J, -gamma)) < 16 * eps);
  BOOST_TEST(std::abs(pressure(WholePolytropic<double, 2>{K}) - rho * K * std::pow(J, -3)) < 16 * eps);
  BOOST_TEST(std::abs(pressure(Tait<double>{K, 7.15}) - rho * K * (std::pow(J, -7.15) - 1)) < 16 * eps);
  BOOST_TEST(std::abs(pressure(WholeTait<double, 6>{K}) - pressure(Tait<double>{K, 7})) < 16 * eps);
  BOOST_TEST(std::abs(pressure([](auto const& at) { return 1.0 / at; }) - rho / (J * J)) < 16 * eps);
  WithArithmetic const exactly(Arithmetic::rationals());
  // Tait's liquid at rest: no energy, no pressure, and the square of the speed of sound is gamma B.
  WholeTait<Number, 6> const water{Number(5)};
  Dual<Dual<Number>> one(Dual<Number>(Number(1)));
  one.part[0] = Dual<Number>(Number(1)), one.value.part[0] = Number(1);
  auto const w = water(one);
  BOOST_TEST((w.value.value == Number(0)));
  BOOST_TEST((w.part[0].value == Number(0)));
  BOOST_TEST((w.part[0].part[0] == Number(35)));
}

namespace {
/// A fluid that is the stiffer the farther a particle is along the first coordinate.
struct StifferAlong {
  WholeTait<Number, 2> w;
  template <class BodyMetric, class SpaceMetric, class S, int n>
  S operator()(Matrix<S, n, 1> const& x, BodyMetric const& G, SpaceMetric const& g,
               Matrix<S, n, n> const& F) const {
    return (x[0] + S(1)) * w(jacobian(G, g, F));
  }
  template <class V>
  auto law_at(V const& x) const {
    return [this, scale = x[0]]<class T>(T const& J) { return T((T(scale) + T(1)) * w(J)); };
  }
};
}  // namespace
template <>
inline constexpr bool actio::is_barotropic<StifferAlong> = true;

BOOST_AUTO_TEST_CASE(a_fluid_whose_law_differs_from_particle_to_particle_has_a_pressure) {
  WithArithmetic const exactly(Arithmetic::rationals());
  FineDraw draw(8);
  using S = Number;
  auto const j = any_second_jet<S, 2>(draw);
  Jet<S, 2, 2> const& first = j;
  Continuum const fluid{Euclidean<2>{}, Euclidean<2>{}, Homogeneous<S>{S(2)}, StifferAlong{{S(3)}}};
  static_assert(FluidMedium<decltype(fluid)>);
  Square<S, 2> const push = Square<S, 2>::Identity() * material_pressure(fluid, first);
  BOOST_TEST((magnitude((cauchy_stress(fluid, first) + push).eval()) == S(0)));
  BOOST_TEST((magnitude((euler_lagrange(fluid, j) + fluid_equation(fluid, j)).eval()) == S(0)));
}

BOOST_AUTO_TEST_CASE(a_fluid_stays_at_rest_and_its_stress_is_its_pressure) {
  WithArithmetic const exactly(Arithmetic::rationals());
  FineDraw draw(5);
  using S = Number;
  auto const j = any_second_jet<S, 2>(draw);
  Jet<S, 2, 2> const& first = j;
  Continuum const fluid{Euclidean<2>{}, Euclidean<2>{}, Homogeneous<S>{S(2)},
                        Barotropic{WholeTait<S, 2>{S(3)}}};
  Square<S, 2> const push = Square<S, 2>::Identity() * material_pressure(fluid, first);
  BOOST_TEST((magnitude((cauchy_stress(fluid, first) + push).eval()) == S(0)));
  BOOST_TEST((magnitude((euler_lagrange(fluid, j) + fluid_equation(fluid, j)).eval()) == S(0)));
  BOOST_TEST((magnitude(piola_identity(Euclidean<2>{}, Euclidean<2>{}, j)) == S(0)));
  // Whatever its pressure is, one that is the same everywhere moves nothing.
  SecondJet<S, 2, 2> still{strained<S, 2>(Square<S, 2>::Identity() * ratio<S>(3, 2)), {}};
  for (auto& w : still.w) w.setZero();
  BOOST_TEST((magnitude(fluid_equation(fluid, still)) == S(0)));
}

BOOST_AUTO_TEST_CASE(mass_grows_linearly_and_pulls_the_pressure_with_it) {
  WithArithmetic const exactly(Arithmetic::rationals());
  using S = Number;
  LinearDensity<S, 2> const rho{S(2), {ratio<S>(1, 2), S(0)}};
  Continuum const fluid{Euclidean<2>{}, Euclidean<2>{}, rho, Barotropic{WholePolytropic<S, 1>{S(3)}}};
  SecondJet<S, 2, 2> still{strained<S, 2>(Square<S, 2>::Identity()), {}};
  for (auto& w : still.w) w.setZero();
  // P = 3 rho at J = 1, so its slope is 3.
  Matrix<S, 2, 1> const force = fluid_equation(fluid, still);
  BOOST_TEST((force[0] == S(3)));
  BOOST_TEST((force[1] == S(0)));
}
