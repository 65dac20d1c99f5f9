// A frame that turns with the flow.
//
// The equations commute with rotations, so a flow may be computed in a frame that turns uniformly about its
// angular momentum, which is constant: dW/dt = [P - Q, W]/hbar with Q = -i rate hbar e.S, and W is turned
// back where it is looked at. In the frame of a Rossby-Haurwitz wave nothing moves.
#pragma once

#include <Eigen/Core>

#include "actio/quantized_sphere/spin_commutator.hpp"
#include "actio/skew_matrices/dense_matrices.hpp"

namespace actio::sphere {

/// A frame that turns about an axis through the centre of the sphere.
struct TurningFrame {
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< a unit vector
  double rate = 0;                                  ///< radians per time, counterclockwise seen from its tip

  /// The combination \f$\sum_je_j\,\mathrm{of}(j)\f$ of three matrices.
  template <class Of>
  SkewHermitian<> along_axis(Of const& of) const {
    SkewHermitian<> sum = axis[2] * of(2);
    for (int j : {0, 1})
      if (axis[j] != 0) sum += axis[j] * of(j);
    return sum;
  }
  /// \f$[ie\cdot S, W]\f$.
  SkewHermitian<> turn(QuantizedSphere const& sphere, SkewHermitian<> const& w) const {
    return along_axis([&](int j) { return spin_commutator(sphere, j, w); });
  }
  /// \f$ie\cdot S\f$.
  SkewHermitian<> generator(QuantizedSphere const& sphere) const {
    return along_axis(
        [&](int j) { return SkewHermitian<>(ComplexMatrix<>(std::complex<double>(0, 1) * sphere.spin(j))); });
  }
};

/// \f$\mathrm{Tr}(S_j(-iW))\f$, j = 1, 2, 3: a multiple of the angular momentum.
inline Eigen::Vector3d spin_components(QuantizedSphere const& sphere, SkewHermitian<> const& w) {
  return {spin_component(sphere, 0, w), spin_component(sphere, 1, w), spin_component(sphere, 2, w)};
}

/// The frame about the angular momentum in which W changes least: the rate makes
/// \f$|[P - Q, W]|\f$ smallest. No turning where there is no angular momentum.
template <class Stream>
TurningFrame calmest_frame(QuantizedSphere const& sphere, Stream const& stream, SkewHermitian<> const& w) {
  TurningFrame frame;
  Eigen::Vector3d const momentum = spin_components(sphere, w);
  // Below this it is the rounding of the state.
  if (!(momentum.norm() > 1e-13 * norm(w) * std::sqrt(std::pow(sphere.n, 3.0)))) return frame;
  frame.axis = momentum.normalized();
  // Along a coordinate axis, rounding apart, it is that axis.
  for (int j = 0; j < 3; ++j)
    if (std::abs(frame.axis[j]) > 1 - 1e-15)
      frame.axis = (frame.axis[j] > 0 ? 1 : -1) * Eigen::Vector3d::Unit(j);
  SkewHermitian<> const turned = frame.turn(sphere, w), moves = commutator(stream.solve(w), w);
  double const size = inner_product(turned, turned);
  if (size > 1e-26 * inner_product(w, w)) frame.rate = -inner_product(moves, turned) / (sphere.hbar() * size);
  return frame;
}

/// Turns matrices about an axis: \f$e^{-i\theta\,e\cdot S}\,W\,e^{i\theta\,e\cdot S}\f$.
///
/// Of the matrix with entries in the direction of e the eigenvectors are found once, O(N^3) operations; about
/// the third axis phases alone are needed.
class Turning {
 public:
  /// @param axis  e, a unit vector
  Turning(QuantizedSphere const& sphere, Eigen::Vector3d const& axis);

  SkewHermitian<> operator()(double angle, SkewHermitian<> const& w) const;

 private:
  /// \f$e^{-i\theta D}ae^{i\theta D}\f$ with the weights on the diagonal of D.
  ComplexMatrix<> conjugated(double angle, bool ascending, ComplexMatrix<> const& a) const;
  /// f a g with real f and g.
  static ComplexMatrix<> between(Eigen::MatrixXd const& f, ComplexMatrix<> const& a,
                                 Eigen::MatrixXd const& g);
  QuantizedSphere sphere_;
  Eigen::Vector3d axis_;
  double azimuth_ = 0;
  bool upright_ = true;
  Eigen::MatrixXd vectors_, transposed_;
};

}  // namespace actio::sphere
