#include "actio/two_bodies/extended_body.hpp"

#include <Eigen/Geometry>

namespace actio::bodies {
namespace {

/// The principal axes with the middle moment in the middle, as near to those of the frame as the count
/// allows.
Eigen::Matrix3d principal_axes_of(Eigen::Matrix3d const& tensor) {
  double const off = std::max({std::abs(tensor(0, 1)), std::abs(tensor(1, 2)), std::abs(tensor(2, 0))});
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Eigen::Vector3d values = tensor.diagonal();
  if (off > inertia_tolerance<double>() * values.maxCoeff()) {
    PrincipalInertia const found = principal_inertia(tensor);
    axes = found.axes, values = found.inertia.moments;
  }
  for (int first = 0; first < 3; ++first) {
    double const a = values[first], b = values[(first + 1) % 3], c = values[(first + 2) % 3];
    if (!((a <= b && b <= c) || (a >= b && b >= c))) continue;
    Eigen::Matrix3d counted;
    for (int i = 0; i < 3; ++i) counted.col(i) = axes.col((first + i) % 3);
    return counted;
  }
  return axes;
}

/// Refuses what the moments of no mass are: for a polynomial p the integral of p^2 is not negative.
void require_mass(Moments<double> const& moments, double length) {
  int const half = moments.order() / 2, size = coefficients_to(half);
  Eigen::MatrixXd products(size, size);
  over_exponents(0, half, [&](int i, int j, int l) {
    over_exponents(0, half, [&](int a, int b, int c) {
      double const scale = std::pow(length, i + j + l + a + b + c) * moments.mass();
      products(place_of(i, j, l), place_of(a, b, c)) = moments(i + a, j + b, l + c) / scale;
    });
  });
  auto const values = symmetric_eigen(products).values;
  double const bound = -64 * epsilon<double>() * size * values.maxCoeff();
  if (values.minCoeff() < bound)
    throw OutsideDomain(
        "moments of a body",
        "no distribution of mass has them: there is a polynomial whose square has a negative integral; "
        "least eigenvalue of the matrix of moments",
        values.minCoeff(), bound);
}

void require_sound(Moments<double> const& moments, double radius) {
  for (double const c : moments.series.coefficients)
    if (!is_finite(c)) throw NotFinite("moments of a body");
  if (moments.order() < 2)
    throw OutsideDomain("moments of a body", "the order must be at least 2", moments.order(), 2);
  if (!(moments.mass() > 0))
    throw OutsideDomain("moments of a body", "the mass must be positive", moments.mass(), 0);
  if (!(radius > 0) || !is_finite(radius))
    throw OutsideDomain("moments of a body", "the radius must be positive", radius, 0);
}

ExtendedBody along(Moments<double> const& centred, double radius, Eigen::Matrix3d const& axes,
                   Eigen::Vector3d const& centre) {
  Moments<double> turned = axes == Eigen::Matrix3d::Identity() ? centred : centred.along(axes);
  for (auto const& [i, j, l] : {std::array{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}, {1, 0, 1}})
    turned.set(i, j, l, 0);  // by the choice of origin and axes
  auto const tensor = turned.inertia_tensor();
  Matrix<double, 3, 1> const I(tensor(0, 0), tensor(1, 1), tensor(2, 2));
  inertia_from_moments<double>(I);  // which refuses what is none
  require_mass(turned, std::sqrt((I[0] + I[1] + I[2]) / 2 / turned.mass()));
  return {turned, {I[0], I[1], I[2]}, radius, axes, centre};
}

}  // namespace

ExtendedBody extended_body(Moments<double> const& moments, double radius) {
  require_sound(moments, radius);
  Eigen::Vector3d const centre = moments.centre();
  Moments<double> const centred = centre.isZero(0) ? moments : moments.seen_from(centre);
  return along(centred, radius + centre.norm(), principal_axes_of(centred.inertia_tensor()), centre);
}

bool has_planes_of_symmetry(ExtendedBody const& body) {
  bool symmetric = true;
  auto const& series = body.moments.series;
  over_exponents(0, series.degree, [&](int i, int j, int l) {
    if ((i % 2 || j % 2 || l % 2) && series(i, j, l) != 0) symmetric = false;
  });
  return symmetric;
}

ExtendedBody sphere_body(double mass, double radius, int order) {
  return ellipsoid_body(mass, {radius, radius, radius}, order);
}

ExtendedBody ellipsoid_body(double mass, std::array<double, 3> const& half_axes, int order) {
  return extended_body(ellipsoid_moments<double>(mass, half_axes, order),
                       std::max({half_axes[0], half_axes[1], half_axes[2]}));
}

ExtendedBody polyhedron_body(Polyhedron<double> const& shape, double density, int order) {
  Moments<double> const given = polyhedron_moments<double>(shape, density, 2);
  Eigen::Vector3d const centre = given.centre();
  Polyhedron<double> moved = shape;
  for (auto& x : moved.vertices) x -= centre;
  Eigen::Matrix3d const axes =
      principal_axes_of(polyhedron_moments<double>(moved, density, 2).inertia_tensor());
  double radius = 0;
  for (auto& x : moved.vertices) {
    x = (axes.transpose() * x).eval();
    radius = std::max(radius, x.norm());
  }
  Moments<double> const moments = polyhedron_moments<double>(moved, density, order);
  require_sound(moments, radius);
  ExtendedBody body = along(moments, radius, Eigen::Matrix3d::Identity(), centre);
  body.axes = axes;
  return body;
}

}  // namespace actio::bodies
