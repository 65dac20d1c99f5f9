// Units of mass, length and time do not matter to the instruments.
#include <boost/test/unit_test.hpp>

#include "actio/groups/motions.hpp"
#include "actio/instruments/discrete_spaces.hpp"
#include "actio/instruments/leaf_defect.hpp"
#include "actio/instruments/poisson_defect.hpp"
#include "actio/instruments/reversibility_defect.hpp"
#include "actio/instruments/symplectic_defect.hpp"
#include "actio/reduction/relative_motion.hpp"
#include "small_maps.hpp"

using namespace actio;
using namespace actio::testing;
using Vector3d = actio::Vector<double, 3>;

BOOST_AUTO_TEST_CASE(metres_and_kibimetres_give_the_same_defects) {
  using Vector6d = Matrix<double, 6, 1>;
  SE<3> const space;
  Vector6d const inertia{{2, 5, 6, 1, 3, 4}}, m{{0.4, -0.9, 0.7, 1.1, 0.3, -0.6}};
  Vector6d const where{{0.3, 0.2, -0.5, 1.0, -2.0, 0.5}}, ahead{{0.1, -0.2, 0.15, 0.4, 0.1, 0.3}};
  std::vector<double> before;
  for (double const unit : {1.0, 1024.0, 0x1p-30}) {
    Vector6d momentum_unit, inertia_unit, configuration_unit;
    momentum_unit << unit * unit * Vector3d::Ones(), unit * Vector3d::Ones();
    inertia_unit << unit * unit * Vector3d::Ones(), Vector3d::Ones();
    configuration_unit << Vector3d::Ones(), unit * Vector3d::Ones();
    DiagonalBody<SE<3>> const submarine{Vector6d(inertia.cwiseProduct(inertia_unit))};
    auto const at = momentum(space, Vector6d(m.cwiseProduct(momentum_unit)));
    auto const family = [&](auto const& h, auto const& mu) { return runge_kutta(submarine, h, mu); };
    auto const map = [&](auto const& mu) {
      return family(typename std::decay_t<decltype(mu)>::Scalar(0.25), mu);
    };
    auto const glide_square = [](auto const& mu) { return mu.components.template tail<3>().squaredNorm(); };
    auto const product = [](auto const& mu) {
      return mu.components.template head<3>().dot(mu.components.template tail<3>());
    };
    // On T*SE(3): the configuration moves on as fast as it does at first. On SE(3) x SE(3): the last relative
    // motion is repeated.
    auto const g0 = exp(velocity(space, Vector6d(where.cwiseProduct(configuration_unit)))),
               g1 = g0 * exp(velocity(space, Vector6d(ahead.cwiseProduct(configuration_unit))));
    auto const on_bundle = [&](auto const& p) {
      auto const body_momentum = Ad_star(p.configuration, p.momentum);
      using S = typename std::decay_t<decltype(p)>::Scalar;
      return std::decay_t<decltype(p)>{
          p.configuration * exp(ratio<S>(1, 4) * submarine.velocity(body_momentum)), p.momentum};
    };
    auto const on_pairs = [](auto const& x) {
      return std::decay_t<decltype(x)>{x.second, x.second * inverse(x.first) * x.second};
    };
    PairsOfConfigurations const pairs{lift_left(chart_lagrangian(submarine, 1.0))};
    std::vector<double> const now = {
        poisson_defect(LiePoissonMinus{}, map, at),
        orbit_defect(map, at),
        leaf_defect(LiePoissonMinus{}, family, 0.25, at),
        casimir_defect(LiePoissonMinus{}, map, at, glide_square, product),
        self_adjointness_defect(LiePoissonMinus{}, family, 0.25, at),
        symplectic_defect(CotangentBundle{}, on_bundle, Costate<SE<3>, double>{g0, at}),
        symplectic_defect(pairs, on_pairs, PairArrow<SE<3>, double>{g0, g1})};
    for (std::size_t i = 0; i < now.size(); ++i) BOOST_TEST_CONTEXT("defect " << i << ", unit " << unit) {
        BOOST_TEST(now[i] > 1e-8);
        BOOST_TEST(now[i] < 1);
        // A power of two rounds nothing, but for functions that are not homogeneous.
        if (!before.empty()) BOOST_TEST(std::abs(now[i] - before[i]) < 64 * eps);
      }
    before = now;
  }
}
