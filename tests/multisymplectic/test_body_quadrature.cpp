// Points and weights on cells: what they integrate exactly, against the integrals in closed form.
#include <boost/test/unit_test.hpp>

#include "actio/media_on_meshes/body_quadrature.hpp"

using namespace actio;
using namespace actio::media;

namespace {
/// The mean over a cell of the product of three hat functions.
double mean_of(media::detail::HatQuadrature const& rule, int a, int b, int c) {
  double sum = 0;
  for (auto const& s : rule.samples)
    sum += s.weight * s.hat[static_cast<std::size_t>(a)] * s.hat[static_cast<std::size_t>(b)] *
           s.hat[static_cast<std::size_t>(c)];
  return sum / rule.all;
}
/// Of a simplex: d! a! b! ... / (d + 3)!, where a, b, ... are the powers of the corners.
double on_simplex(int d, int a, int b, int c) {
  int const alike = (a == b) + (b == c) + (a == c);
  return (alike == 3 ? 6 : alike == 1 ? 2 : 1) / static_cast<double>((d + 1) * (d + 2) * (d + 3));
}
/// Of a box: in each direction the mean of x^3, 1/4, or of x^2 (1 - x), 1/12.
double on_box(int d, int a, int b, int c) {
  double product = 1;
  for (int i = 0; i < d; ++i) {
    int const up = (a >> i & 1) + (b >> i & 1) + (c >> i & 1);
    product *= up == 0 || up == 3 ? 1.0 / 4 : 1.0 / 12;
  }
  return product;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(body_quadrature)

BOOST_AUTO_TEST_CASE(products_of_three_hat_functions_are_integrated_exactly_on_every_shape) {
  using enum BodyMesh::Shape;
  for (auto const& [shape, d] : {std::pair{segment, 1}, std::pair{triangle, 2}, std::pair{quadrilateral, 2},
                                 std::pair{tetrahedron, 3}, std::pair{hexahedron, 3}}) {
    media::detail::HatQuadrature const rule(shape, d);
    bool const simplex = is_simplex(shape);
    int const corners = corner_count(shape);
    double worst = 0;
    for (int a = 0; a < corners; ++a) {
      worst = std::max(worst, std::abs(rule.total[static_cast<std::size_t>(a)] / rule.all * corners - 1));
      for (int b = 0; b < corners; ++b)
        for (int c = 0; c < corners; ++c) {
          double const exact = simplex ? on_simplex(d, a, b, c) : on_box(d, a, b, c);
          worst = std::max(worst, std::abs(mean_of(rule, a, b, c) / exact - 1));
        }
    }
    // Sums of 27 positive terms, of some five roundings each.
    BOOST_TEST_INFO("shape " << static_cast<int>(shape));
    BOOST_TEST(worst <= 40 * std::numeric_limits<double>::epsilon());
  }
}

BOOST_AUTO_TEST_SUITE_END()
