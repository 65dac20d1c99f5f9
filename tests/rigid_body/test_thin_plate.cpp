// A plate that is a million million times as wide as it is long: moments of inertia of very different size in
// one body, against 50 digits.
#include <boost/test/unit_test.hpp>

#include "actio/rigid_body/moser_veselov.hpp"
#include "witness/number.hpp"

using namespace actio;
using Vector3d = actio::Vector<double, 3>;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
}

BOOST_AUTO_TEST_CASE(a_thin_plate_keeps_its_digits) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  for (double const thin : {1e-3, 1e-6, 1e-9, 1e-12}) {
    auto const inertia = inertia_from_lambda<3, double>(Vector3d(1, 0, thin));
    Momentum<SO<3>, double> const pi{{}, Vector3d(0.5, 0.3, 0.2)};
    auto const f = MoserVeselov<3>(inertia, 0.9 * thin).relative_motion(pi).value;
    auto const exact = MoserVeselov<3, Number>(inertia.over<Number>(), Number(0.9 * thin))
                           .relative_motion({{}, pi.components.cast<Number>()})
                           .value;
    BOOST_TEST(to_double(magnitude((f.value.cast<Number>() - exact.value).eval())) < 64 * eps);
  }
}
