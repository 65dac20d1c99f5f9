// A charted body on SO(n) that is saved between two steps and restored elsewhere continues bit for bit, also
// before it remembers as many turns as it can.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "../rigid_body/random_bodies.hpp"
#include "actio/fast_body/any_dimension/natural_chart_n.hpp"
#include "bytes.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::bodies;

namespace {

constexpr int n_ = Eigen::Dynamic;

void is_the_same(ChartedBody const& a, ChartedBody const& b) {
  BOOST_TEST((a.momentum().components == b.momentum().components));
  BOOST_TEST((a.attitude().value == b.attitude().value));
  BOOST_TEST(a.steps() == b.steps());
  BOOST_TEST(a.sweeps() == b.sweeps());
}

}  // namespace

BOOST_AUTO_TEST_SUITE(charted_body_memory)

BOOST_AUTO_TEST_CASE(a_run_that_is_broken_off_after_any_number_of_steps_has_the_bits_of_an_unbroken_one) {
  std::mt19937 random(testing::seed);
  for (int n : {3, 4, 6})
    for (int before = 0; before <= 14; ++before)
      BOOST_TEST_CONTEXT("n = " << n << ", " << before << " steps before") {
        auto const [inertia, spin] = testing::random_body<n_>(random, n);
        double const h = 0.1 / spin.coordinates.norm();
        auto const pi = body_momentum(inertia, spin);
        FastNaturalChart scheme(inertia, h), again(inertia, h);
        auto first = scheme.release(pi);
        for (int k = 0; k < before; ++k) scheme.step_with_attitude(first);
        testing::Bytes bytes;
        first.remember(bytes);
        // Another body, which has not moved.
        auto second = again.release(momentum(inertia.group, Eigen::VectorXd(-0.5 * pi.components)));
        second.remember(bytes.rewind());
        BOOST_TEST(bytes.at_end());
        for (int k = 0; k < 12; ++k) {
          scheme.step_with_attitude(first), again.step_with_attitude(second);
          is_the_same(second, first);
        }
      }
}

BOOST_AUTO_TEST_CASE(what_is_no_memory_of_such_a_body_is_refused) {
  auto const inertia = inertia_from_lambda<n_, double>(Eigen::VectorXd::LinSpaced(4, 1, 2));
  FastNaturalChart scheme(inertia, 0.1);
  auto body = scheme.release(momentum(inertia.group, Eigen::VectorXd::Ones(6)));
  for (int k = 0; k < 5; ++k) scheme.step(body);
  int const size = 0, continuation = 1, latest = 2, past = 3;
  auto restore = [&](int place, int value) {
    testing::Bytes bytes;
    body.remember(bytes);
    auto other = scheme.release(momentum(inertia.group, Eigen::VectorXd::Ones(6)));
    bytes.rewind();
    testing::Damaged damaged{bytes, place, value};
    other.remember(damaged);
  };
  BOOST_CHECK_NO_THROW(restore(-1, 0));
  for (auto const& [place, value] : std::initializer_list<std::pair<int, int>>{{size, 3},
                                                                               {size, 5},
                                                                               {continuation, -1},
                                                                               {continuation, 36},
                                                                               {continuation, 1000},
                                                                               {latest, -1},
                                                                               {latest, 17},
                                                                               {latest, 1000},
                                                                               {past, -1},
                                                                               {past, 18},
                                                                               {past, 1000}})
    BOOST_TEST_CONTEXT("number " << place << " is " << value)
  CHECK_REFUSED(restore(place, value), OutsideDomain);
  // The last numbers that a body may have. So many turns are not there, and are missed.
  for (auto const& [place, value] :
       {std::pair{continuation, 0}, {continuation, 35}, {latest, 0}, {latest, 16}, {past, 0}})
    BOOST_CHECK_NO_THROW(restore(place, value));
  BOOST_CHECK_EXCEPTION(restore(past, 17), std::runtime_error, [](std::runtime_error const& e) {
    return std::string(e.what()) == "bytes: they end too early";
  });
}

BOOST_AUTO_TEST_SUITE_END()
