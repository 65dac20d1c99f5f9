// What is no mesh, body or step is refused with the numbers that say so.
#pragma once

#include <boost/test/unit_test.hpp>

#include "caught.hpp"

namespace actio::testing {

/// Refused with these numbers, the measured one up to some roundings, and these words somewhere in the
/// message.
template <class Failure, class Call>
void refuses(Call const& call, double measured, double bound, std::string const& words) {
  auto const error = caught<Failure>(call);
  auto const near = [](double x, double y) {
    return std::abs(x - y) <= 16 * std::numeric_limits<double>::epsilon() * std::abs(y);
  };
  BOOST_TEST(near(error.measured, measured), error.what());
  BOOST_TEST(error.bound == bound, error.what());
  BOOST_TEST(std::string(error.what()).find(words) != std::string::npos, error.what());
}

}  // namespace actio::testing
