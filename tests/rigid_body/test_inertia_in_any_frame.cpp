// Inertia in a frame of any choice and of bodies made of parts, against sums over point masses; and the
// bounds up to which rounding is forgiven.
#include <boost/test/unit_test.hpp>

#include <Eigen/Geometry>

#include "actio/rigid_body/inertia_of_parts.hpp"
#include "actio/rigid_body/largest_step.hpp"
#include "caught.hpp"
#include "refused.hpp"

using namespace actio;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();

/// The measured number and the bound of a refusal.
template <class Refusal, class F>
std::pair<double, double> refused(F const& f) {
  auto const refusal = testing::caught<Refusal>(f);
  return {refusal.measured, refusal.bound};
}
/// I_ij = sum m (|x|^2 delta_ij - x_i x_j), entry by entry.
Matrix3d sum_over(std::vector<PointMass> const& points) {
  Matrix3d sum = Matrix3d::Zero();
  for (auto const& [m, x] : points)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        sum(i, j) += m * ((i == j ? x[0] * x[0] + x[1] * x[1] + x[2] * x[2] : 0.0) - x[i] * x[j]);
  return sum;
}
/// Eight point masses with the second moments of a cylinder: on two circles of radius r over root two, at l
/// over root twelve from the centre.
std::vector<PointMass> points_of(Cylinder const& c) {
  Vector3d const axis = c.along.normalized(), across = axis.unitOrthogonal(), third = axis.cross(across);
  std::vector<PointMass> points;
  for (double const up : {1.0, -1.0})
    for (double const side : {1.0, -1.0})
      for (Vector3d const& way : {across, third})
        points.push_back({c.mass / 8, c.at + up * c.length / std::sqrt(12.0) * axis +
                                          side * c.radius / std::sqrt(2.0) * way});
  return points;
}
std::vector<Cylinder> const cylinders{{1.5, 0.2, 0.7, {0.3, -0.4, 0.5}, {1, 2, -2}},
                                      {0.5, 0.6, 0.1, {-0.2, 0.1, 0.9}, {0, 0.3, 0.1}},
                                      {2.5, 0.1, 1.1, {0.7, 0.8, -0.6}, {-1e200, 0, 1e200}}};
}  // namespace

BOOST_AUTO_TEST_SUITE(inertia_in_any_frame)

BOOST_AUTO_TEST_CASE(a_cylinder_has_the_second_moments_of_eight_points) {
  for (auto const& c : cylinders) {
    Cylinder const shorter{c.mass, c.radius, c.length, c.at, c.along.stableNormalized()};
    BOOST_TEST((inertia_tensor(c) - sum_over(points_of(shorter))).norm() <= 64 * eps * c.mass);
  }
  PointMass const p{1.7, {0.3, -0.4, 0.5}};
  BOOST_TEST((inertia_tensor(p) - sum_over({p})).norm() <= 8 * eps);
}

BOOST_AUTO_TEST_CASE(parts_are_summed_about_the_origin_and_about_their_centre_of_mass) {
  std::vector<PointMass> points;
  for (auto c : cylinders) {
    c.along = c.along.stableNormalized();
    for (auto const& p : points_of(c)) points.push_back(p);
  }
  BOOST_TEST((inertia_tensor(points) - sum_over(points)).norm() <= 256 * eps);
  BOOST_TEST((inertia_tensor(cylinders) - sum_over(points)).norm() <= 256 * eps);
  Vector3d centre(0, 0, 0);
  for (auto const& [m, x] : points) centre += m / 4.5 * x;
  auto moved = points;
  for (auto& p : moved) p.at -= centre;
  BOOST_TEST((inertia_about_centre(points) - sum_over(moved)).norm() <= 256 * eps);
  BOOST_TEST((inertia_about_centre(cylinders) - sum_over(moved)).norm() <= 256 * eps);
  auto const seen = from_centre_of_mass(cylinders);
  for (std::size_t k = 0; k < seen.size(); ++k) {
    BOOST_TEST((seen[k].at - (cylinders[k].at - centre)).norm() <= 16 * eps);
    BOOST_TEST((seen[k].mass == cylinders[k].mass && seen[k].along == cylinders[k].along));
  }
}

BOOST_AUTO_TEST_CASE(momentum_velocity_and_energy_are_those_of_the_tensor) {
  Matrix3d const tensor = inertia_about_centre(cylinders);
  auto const body = principal_inertia(tensor);
  BOOST_TEST(body.is_turned());
  BOOST_TEST(!PrincipalInertia(body.inertia).is_turned());
  double const size = tensor.norm();
  BOOST_TEST((body.tensor() - tensor).norm() <= 32 * eps * size);
  BOOST_TEST((body.inverse_tensor() * tensor - Matrix3d::Identity()).norm() <=
             64 * eps * size / body.inertia.moments.minCoeff());
  Vector3d const w(0.7, -1.1, 0.4), M = tensor * w;
  Velocity<SO<3>, double> const spin{{}, w};
  BOOST_TEST((body_momentum(body, spin).components - M).norm() <= 64 * eps * size);
  Momentum<SO<3>, double> const m{{}, M};
  double const room = 128 * eps * size / body.inertia.moments.minCoeff();
  BOOST_TEST((body_velocity(body, m).coordinates - w).norm() <= room * w.norm());
  BOOST_TEST(std::abs(kinetic_energy(body, m) - w.dot(M) / 2) <= room * w.dot(M));
  // Axes are a rotation, and moments ascend with them.
  BOOST_TEST(std::abs(body.axes.determinant() - 1) <= 16 * eps);
  for (int i = 0; i < 3; ++i)
    BOOST_TEST((tensor * body.axes.col(i) - body.inertia.moments[i] * body.axes.col(i)).norm() <=
               64 * eps * size);
}

BOOST_AUTO_TEST_CASE(an_excess_of_rounding_is_forgiven_and_a_larger_one_named) {
  // The tolerance is 16 epsilon of the largest moment for half of the excess.
  for (int axis = 0; axis < 3; ++axis)
    for (double const unit : {1.0, 0x1p-150}) {
      auto const moments = [&](double excess) {
        Vector3d I(0.25, 0.25, 0.25);
        I[axis] = 0.5, I[(axis + 1) % 3] -= excess / 2;
        return Vector3d(unit * I);
      };
      // In units of the largest moment, a half: 32 epsilon of it are 16.
      BOOST_TEST(inertia_from_moments<double>(moments(16 * eps)).lambda[axis] == 0);
      BOOST_TEST(inertia_from_moments<double>(moments(-16 * eps)).lambda[axis] == 0);
      BOOST_TEST(inertia_from_moments<double>(moments(-64 * eps)).lambda[axis] == unit * 16 * eps);
      auto const [excess, bound] =
          refused<UnphysicalInertia>([&] { inertia_from_moments<double>(moments(64 * eps)); });
      BOOST_TEST(excess == 64 * eps);
      BOOST_TEST(bound == 32 * eps);
      for (double const small : {0.0, 8 * eps, -0.125}) {
        Vector3d I(0.5, 0.5, 0.5);
        I[axis] = small;
        auto const [share, least] =
            refused<UnphysicalInertia>([&] { inertia_from_moments<double>(Vector3d(unit * I)); });
        BOOST_TEST(share == 2 * small);
        BOOST_TEST(least == 16 * eps);
      }
    }
  using Pair = std::pair<double, double>;
  BOOST_TEST((refused<UnphysicalInertia>([] { inertia_from_moments(0, 0, 0); }) == Pair{0, 16 * eps}));
  using Four = Vector<double, 4>;
  BOOST_TEST((refused<UnphysicalInertia>([] { inertia_from_lambda<4, double>(Four(2, -0.5, 0.25, 4)); }) ==
              Pair{-0.0625, 16 * eps}));
  BOOST_TEST((refused<UnphysicalInertia>([] { inertia_from_lambda<4, double>(Four(0, 0, 0, 0)); }) ==
              Pair{0, 16 * eps}));
  BOOST_CHECK_NO_THROW(
      (inertia_from_lambda<4, double>(Four(-1, 1 + 32 * eps, 1, 1) + Four(0, 0, 1, 1) * 1e-3)));
  using Any = Vector<double>;
  BOOST_TEST((refused<OutsideDomain>([] { inertia_from_lambda<Dynamic, double>(Any(Any::Ones(1))); }) ==
              Pair{1, 2}));
  CHECK_REFUSED((inertia_from_lambda<4, double>(Four(1e308, 1e308, 1, 1))), NotFinite);
}

BOOST_AUTO_TEST_CASE(a_tensor_may_be_skew_by_rounding_alone) {
  for (double const unit : {1.0, 0x1p-150}) {
    Matrix3d tensor = Vector3d(0.75, 0.875, 1).asDiagonal();
    tensor(0, 2) = tensor(2, 0) = 0.0625, tensor(1, 2) = tensor(2, 1) = -0.125;
    tensor(0, 2) += 16 * eps;
    BOOST_CHECK_NO_THROW(principal_inertia(unit * tensor));
    tensor(0, 2) += 16 * eps;
    auto const [skew, bound] = refused<OutsideDomain>([&] { principal_inertia(unit * tensor); });
    BOOST_TEST(skew == 32 * eps);
    BOOST_TEST(bound == 16 * eps);
  }
}

BOOST_AUTO_TEST_CASE(the_largest_step_is_named_in_the_unit_of_time) {
  // About an axis h |M| = I, whatever the units; a negative Lambda is named in units of the largest.
  for (double const mass : {1.0, 1e-40, 1e30})
    for (double const pace : {1.0, 1e-8, 1e8})
      for (int axis = 0; axis < 3; ++axis) {
        auto const inertia = inertia_from_moments<double>(Vector3d(mass * Vector3d(0.6, 0.8, 1)));
        Momentum<SO<3>, double> const pi{{}, Vector3d(-pace * inertia.moments[axis] * Vector3d::Unit(axis))};
        BOOST_TEST(std::abs(largest_step(inertia, pi) * pace - 1) <= 1e-12);
      }
  auto const negative = inertia_from_lambda<3, double>(Vector3d(2, -0.5, 4));
  Momentum<SO<3>, double> const pi{{}, Vector3d(1, 2, 3)};
  BOOST_TEST((refused<OutsideDomain>([&] { largest_step(negative, pi); }) == std::pair{-0.125, 0.0}));
}

BOOST_AUTO_TEST_SUITE_END()
