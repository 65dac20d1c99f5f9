// Inertia: the operator J, principal moments and tensors, every kind of input that is no inertia, and sizes
// from 1e-47 to 1e+47.
#include <boost/test/unit_test.hpp>

#include "actio/forms/forms.hpp"
#include "actio/rigid_body/principal_inertia.hpp"
#include "caught.hpp"
#include "random_bodies.hpp"
#include "refused.hpp"

using namespace actio;
using testing::caught;
using Matrix3d = actio::Matrix<double, 3, 3>;
using Vector3d = actio::Vector<double, 3>;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();

// J in coordinates against its definition with matrices, and the normalisation of (5.1).
template <int n>
void operator_is_the_anticommutator(int size = n) {
  std::mt19937 random(testing::seed);
  auto const [inertia, xi] = testing::random_body<n>(random, size);
  auto const hat = inertia.group.hat(xi.coordinates);
  auto const j = (inertia.lambda.asDiagonal() * hat + hat * inertia.lambda.asDiagonal()).eval();
  double const scale = magnitude(j);
  BOOST_TEST(magnitude((inertia.group.hat(body_momentum(inertia, xi).components) - j).eval()) <=
             4 * eps * scale);
  // A quarter of Tr(xi^T J xi) is the kinetic energy.
  double const energy = (hat.transpose() * j).trace() / 4;
  BOOST_TEST(std::abs(kinetic_energy(inertia, xi) - energy) <= 4 * size * size * eps * energy);
  BOOST_TEST(std::abs(kinetic_energy(inertia, body_momentum(inertia, xi)) - energy) <=
             4 * size * size * eps * energy);
  BOOST_TEST(magnitude((body_velocity(inertia, body_momentum(inertia, xi)) - xi).coordinates) <= 2 * eps);
}
}  // namespace

BOOST_AUTO_TEST_SUITE(inertia)

BOOST_AUTO_TEST_CASE(the_operator_is_the_anticommutator_with_lambda) {
  operator_is_the_anticommutator<2>();
  operator_is_the_anticommutator<3>();
  operator_is_the_anticommutator<4>();
  operator_is_the_anticommutator<5>();
  operator_is_the_anticommutator<Dynamic>(3);
  operator_is_the_anticommutator<Dynamic>(7);
}

BOOST_AUTO_TEST_CASE(coordinates_at_run_time_are_those_of_a_fixed_size) {
  std::mt19937 random(testing::seed);
  for (int repeat = 0; repeat < 3; ++repeat) {
    auto const three = testing::random_body<3>(random).spin.coordinates;
    BOOST_TEST((SO<Dynamic>{3}.hat(three) - SO<3>::hat(three)).norm() == 0);
    auto const four = testing::random_body<4>(random).spin.coordinates;
    BOOST_TEST((SO<Dynamic>{4}.hat(four) - SO<4>::hat(four)).norm() == 0);
    auto const two = testing::random_body<2>(random).spin.coordinates;
    BOOST_TEST((SO<Dynamic>{2}.hat(two) - SO<2>::hat(two)).norm() == 0);
  }
}

BOOST_AUTO_TEST_CASE(principal_moments_and_lambda_agree_at_any_size) {
  for (double const unit : {1.0, 1e-47, 1e47, 1e-200, 1e200}) {
    Vector3d const moments = unit * Vector3d(0.6, 0.8, 1.0);
    auto const body = inertia_from_moments<double>(moments);
    auto const same = inertia_from_lambda<3, double>(body.lambda);
    for (int i = 0; i < 3; ++i) BOOST_TEST(std::abs(same.moments[i] / moments[i] - 1) <= 4 * eps);
  }
}

BOOST_AUTO_TEST_CASE(equality_in_the_triangle_inequality_is_a_planar_body) {
  BOOST_TEST(inertia_from_moments(1, 2, 3).lambda[2] == 0);
  BOOST_TEST(inertia_from_moments(0.1, 0.2, 0.3).lambda[2] == 0);  // 0.1 + 0.2 is not 0.3 in binary
  BOOST_TEST(inertia_from_moments(0.3e-47, 0.1e-47, 0.2e-47).lambda[0] == 0);
}

BOOST_AUTO_TEST_CASE(moments_that_no_body_has_are_refused_with_the_excess) {
  // Water from its rotational constants: an inertial defect of a vibrating molecule, no rigid body.
  auto const water = caught<UnphysicalInertia>([&] { inertia_from_moments(0.604715, 1.161634, 1.815577); });
  BOOST_TEST(std::abs(water.measured - (1.815577 - 0.604715 - 1.161634) / 1.815577) < 1e-12);
  BOOST_TEST(water.bound < 1e-13);
  BOOST_TEST(std::string(water.what()).find("triangle") != std::string::npos);
  auto const negative = caught<UnphysicalInertia>([&] { inertia_from_moments(1, -0.25, 2); });
  BOOST_TEST(negative.measured == -0.125);  // in units of the largest
  BOOST_TEST(std::string(negative.what()).find("I_2") != std::string::npos);
  CHECK_REFUSED(inertia_from_moments(1, 1, 3), UnphysicalInertia);
  CHECK_REFUSED(inertia_from_moments(1e-47, 1e-47, 3e-47), UnphysicalInertia);
  CHECK_REFUSED(inertia_from_moments(1e47, 1e47, 3e47), UnphysicalInertia);
  CHECK_REFUSED(inertia_from_moments(3, 5, 9), UnphysicalInertia);
  CHECK_REFUSED(inertia_from_moments(0, 1, 1), UnphysicalInertia);  // a rod without thickness
  CHECK_REFUSED(inertia_from_moments(-1, 1, 1), UnphysicalInertia);
  CHECK_REFUSED(inertia_from_moments(0, 0, 0), UnphysicalInertia);
}

BOOST_AUTO_TEST_CASE(a_generalized_body_needs_positive_sums_only) {
  using Vector4 = Vector<double, 4>;
  BOOST_CHECK_NO_THROW((inertia_from_lambda<4, double>(Vector4(-0.5, 1, 2, 3))));
  BOOST_CHECK_NO_THROW((inertia_from_lambda<4, double>(Vector4(0, 1, 2, 3))));
  BOOST_CHECK_EXCEPTION((inertia_from_lambda<4, double>(Vector4(-1, 1, 2, 3))), UnphysicalInertia,
                        [](UnphysicalInertia const& error) {
                          return std::string(error.what()).find("Lambda_1 + Lambda_2") != std::string::npos;
                        });
  CHECK_REFUSED((inertia_from_lambda<4, double>(Vector4(0, 0, 2, 3))), UnphysicalInertia);
  CHECK_REFUSED((inertia_from_lambda<4, double>(Vector4(0, 0, 0, 0))), UnphysicalInertia);
  CHECK_REFUSED((inertia_from_lambda<Dynamic, double>(Vector<double>(Vector<double>::Ones(1)))),
                OutsideDomain);
}

BOOST_AUTO_TEST_CASE(no_number_is_no_inertia) {
  for (double const bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    CHECK_REFUSED(inertia_from_moments(1, bad, 1), NotFinite);
    CHECK_REFUSED((inertia_from_lambda<4, double>(Vector<double, 4>(1, 1, bad, 1))), NotFinite);
    Matrix3d tensor = Matrix3d::Identity();
    tensor(1, 2) = bad;
    CHECK_REFUSED(principal_inertia(tensor), NotFinite);
  }
}

BOOST_AUTO_TEST_CASE(a_tensor_gives_its_moments_and_axes) {
  for (double const unit : {1.0, 1e-47, 1e47}) {
    Vector3d const moments(0.5, 0.8, 1.1);
    Matrix3d const axes = SO<3>::exp<double>(Vector3d(0.3, -1.1, 0.7));
    Matrix3d const tensor = unit * (axes * moments.asDiagonal() * axes.transpose());
    auto const found = principal_inertia((tensor + tensor.transpose()) / 2);
    for (int i = 0; i < 3; ++i)
      BOOST_TEST(std::abs(found.inertia.moments[i] / unit - moments[i]) <= 16 * eps);
    BOOST_TEST(determinant(actio::Matrix<double, 3, 3>(found.axes)) > 0);
    BOOST_TEST(magnitude((found.axes * (found.inertia.moments / unit).asDiagonal() * found.axes.transpose() -
                          tensor / unit)
                             .eval()) <= 32 * eps);
  }
}

BOOST_AUTO_TEST_CASE(a_tensor_that_is_none_is_refused) {
  Matrix3d skew = Matrix3d::Identity();
  skew(0, 1) = 1e-6;
  CHECK_REFUSED(principal_inertia(skew), OutsideDomain);
  CHECK_REFUSED(principal_inertia(Matrix3d::Zero()), UnphysicalInertia);
  CHECK_REFUSED(principal_inertia(-Matrix3d::Identity()), UnphysicalInertia);
  CHECK_REFUSED(principal_inertia(Vector3d(1, 1, 3).asDiagonal()), UnphysicalInertia);
}

BOOST_AUTO_TEST_SUITE_END()
