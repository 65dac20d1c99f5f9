// A million steps of two bodies: the momentum of the whole stays to rounding, the energy does not drift.
#include <boost/test/unit_test.hpp>

#include "didymos.hpp"

using namespace actio;
using namespace actio::bodies;
using testing::Didymos;

BOOST_AUTO_TEST_SUITE(two_bodies_long_run)

BOOST_AUTO_TEST_CASE(momentum_and_energy_over_a_million_steps) {
  Didymos const d;
  struct Run {
    PairMethod method;
    int order;
    double step;
  };
  for (auto const& [method, order, step] : {Run{pair_splitting(), 2, 60},
                                            {pair_splitting(), 4, 60},
                                            {kepler_splitting(), 4, 1200},
                                            {moser_veselov_pair(), 2, 60}}) {
    auto pair = d.pair(step, method, order);
    double const E = pair.energy();
    Eigen::Vector3d const J = pair.angular_momentum();
    double early = 0, late = 0, lost = 0;
    long const rounds = 10000, all = method.kepler ? 140000 : 1000000;  // a million stages
    for (long k = 0; k < rounds; ++k) {
      pair.step(all / rounds);
      double const off = std::abs(pair.energy() / E - 1);
      (k < rounds / 2 ? early : late) = std::max(k < rounds / 2 ? early : late, off);
      lost = std::max(lost, (pair.angular_momentum() - J).norm() / J.norm());
    }
    BOOST_TEST_MESSAGE(method.splitting.name << (method.rotor == Rotor::exact ? "" : ", Moser-Veselov")
                                             << ", order of the potential " << order << ": energy off by "
                                             << early << " in the first half, " << late
                                             << " in the second; momentum by " << lost);
    // A walk of a million roundings is 1e3 epsilon.
    BOOST_TEST(late <= 1.2 * early + 1e3 * std::numeric_limits<double>::epsilon());
    BOOST_TEST(lost <= 1e-13);
  }
}

BOOST_AUTO_TEST_SUITE_END()
