// A body on SO(n) that is saved between two steps and restored elsewhere continues bit for bit.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "../rigid_body/random_bodies.hpp"
#include "actio/fast_body/any_dimension/moser_veselov_n.hpp"
#include "bytes.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::bodies;

namespace {

constexpr int n_ = Eigen::Dynamic;

void take(FastMoserVeselov const& scheme, RotatingBody& body, int count, bool with_attitude) {
  for (int k = 0; k < count; ++k) with_attitude ? scheme.step_with_attitude(body) : scheme.step(body);
}
void is_the_same(RotatingBody const& a, RotatingBody const& b) {
  BOOST_TEST((a.momentum().components == b.momentum().components));
  BOOST_TEST((a.momentum_remainder().components == b.momentum_remainder().components));
  BOOST_TEST((a.attitude().value == b.attitude().value));
  BOOST_TEST(a.steps() == b.steps());
  BOOST_TEST(a.remembered() == b.remembered());
}

}  // namespace

BOOST_AUTO_TEST_SUITE(rotating_body_memory)

BOOST_AUTO_TEST_CASE(a_run_that_is_broken_off_and_taken_up_has_the_bits_of_an_unbroken_one) {
  std::mt19937 random(testing::seed);
  for (int n : {3, 4, 8, 33})
    for (bool with_attitude : {false, true})
      for (double angle : {0.02, 0.3})
        BOOST_TEST_CONTEXT("n = " << n << ", attitude " << with_attitude << ", angle " << angle) {
          auto const [inertia, spin] = testing::random_body<n_>(random, n);
          double const h = angle / spin.coordinates.norm();
          auto const pi = body_momentum(inertia, spin);
          FastMoserVeselov const scheme(inertia, h, Sweeps::beyond_rounding);
          auto unbroken = scheme.release(pi);
          take(scheme, unbroken, 100, with_attitude);

          auto first = scheme.release(pi);
          take(scheme, first, 37, with_attitude);
          testing::Bytes bytes;
          first.remember(bytes);
          // Another scheme with the same numbers, and a body that began elsewhere and has made steps.
          FastMoserVeselov const again(inertia, h, Sweeps::beyond_rounding);
          auto second = again.release(momentum(inertia.group, Eigen::VectorXd(-0.5 * pi.components)));
          take(again, second, n == 8 ? 5 : 0, with_attitude);
          second.remember(bytes.rewind());
          BOOST_TEST(bytes.at_end());
          take(again, second, 63, with_attitude);
          is_the_same(second, unbroken);
          // Saving changes nothing.
          take(scheme, first, 63, with_attitude);
          is_the_same(first, unbroken);
        }
}

BOOST_AUTO_TEST_CASE(a_body_of_another_size_is_not_restored) {
  auto const small = inertia_from_lambda<n_, double>(Eigen::VectorXd::LinSpaced(4, 1, 2)),
             large = inertia_from_lambda<n_, double>(Eigen::VectorXd::LinSpaced(5, 1, 2));
  auto body = FastMoserVeselov(small, 0.1).release(momentum(small.group, Eigen::VectorXd::Ones(6)));
  testing::Bytes bytes;
  body.remember(bytes);
  auto other = FastMoserVeselov(large, 0.1).release(momentum(large.group, Eigen::VectorXd::Ones(10)));
  CHECK_REFUSED(other.remember(bytes.rewind()), OutsideDomain);
}

BOOST_AUTO_TEST_CASE(what_is_no_memory_of_such_a_body_is_refused) {
  auto const inertia = inertia_from_lambda<n_, double>(Eigen::VectorXd::LinSpaced(4, 1, 2));
  FastMoserVeselov const scheme(inertia, 0.1);
  auto body = scheme.release(momentum(inertia.group, Eigen::VectorXd::Ones(6)));
  take(scheme, body, 5, false);
  int const size = 0, continuation = 1, latest = 2, past = 3;
  auto restore = [&](int place, int value) {
    testing::Bytes bytes;
    body.remember(bytes);
    auto other = scheme.release(momentum(inertia.group, Eigen::VectorXd::Ones(6)));
    testing::Damaged damaged{bytes.rewind(), place, value};
    other.remember(damaged);
    return other.remembered();
  };
  BOOST_TEST(restore(-1, 0) == body.remembered());
  for (std::pair<int, int> const& change : std::initializer_list<std::pair<int, int>>{{size, 3},
                                                                                      {size, 5},
                                                                                      {continuation, -2},
                                                                                      {continuation, 36},
                                                                                      {latest, -1},
                                                                                      {latest, 17},
                                                                                      {past, -1},
                                                                                      {past, 18}})
    BOOST_TEST_CONTEXT("number " << change.first << " is " << change.second)
  BOOST_CHECK_EXCEPTION(restore(change.first, change.second), OutsideDomain, [&](OutsideDomain const& e) {
    return e.measured == (change.first == size ? change.second : 4) && e.bound == 4;
  });
  // The last numbers that a body may have. So many squares are not there, and are missed.
  for (auto const& [place, value] : {std::pair{latest, 0}, {latest, 16}, {past, 0}})
    BOOST_CHECK_NO_THROW(restore(place, value));
  BOOST_TEST(restore(continuation, -1) == 0);
  BOOST_TEST(restore(continuation, 0) == 1);
  BOOST_TEST(restore(continuation, 35) == 16);
  BOOST_CHECK_EXCEPTION(restore(past, 17), std::runtime_error, [](std::runtime_error const& e) {
    return std::string(e.what()) == "bytes: they end too early";
  });
}

BOOST_AUTO_TEST_SUITE_END()
