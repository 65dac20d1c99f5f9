// What the steps of a flow have in common: what they conserve, what they report, how they fail.
//
// They are written for the sphere. A stream may say that its matrices are the functions on another surface:
// `Surface`, with its `hbar()`, and with `turns` where rotations commute with the flow. Where none does, as
// on the flat torus, there is no angular momentum to keep, and energy and spectrum are all that a step keeps.
#pragma once

#include <Eigen/Core>

#include "actio/quantized_sphere/turning_frame.hpp"
#include "actio/skew_matrices/products.hpp"

namespace actio::sphere {

/// What a step conserves beside the spectrum of W.
enum class Conserved {
  lie_poisson,     ///< the Lie-Poisson structure and the angular momentum
  energy_casimir,  ///< the energy, and the angular momentum along the axis of the frame
  all_invariants   ///< the energy and the angular momentum
};

/// How a step was found.
struct VorticityReport {
  int iterations = 0;   ///< evaluations of the equation of a step, each of them three products
  double residual = 0;  ///< of the equation, relative to |W|
};

/// A step whose iteration does not contract; `largest` is one that was found from the same state, zero where
/// none was.
struct NotContracting : Error {
  double step;     ///< that was tried, time
  double largest;  ///< one that does, time; its sign is that of the step
  /// @param tried, do_well  the two lengths
  NotContracting(double tried, double do_well);
};

namespace detail {
template <class Stream>
struct SurfaceOf {
  using Type = QuantizedSphere;
};
template <class Stream>
  requires requires { typename Stream::Surface; }
struct SurfaceOf<Stream> {
  using Type = typename Stream::Surface;
};
}  // namespace detail

/// Steps of one length for one flow: what they are given.
/// @tparam Stream  a map W -> P: `solve(w, p)`, `solve(w)`, `size()`; and `Surface`, where it is not the
///                 sphere. On the sphere it commutes with rotations
template <class Stream>
class StepSetting {
 public:
  using Surface = typename detail::SurfaceOf<Stream>::Type;  ///< of which the matrices are the functions
  double step() const { return step_; }                      ///< h, time
  /// In which the steps are made.
  TurningFrame const& frame() const { return frame_; }

 protected:
  using Axes = std::vector<Eigen::Vector3d>;  ///< unit vectors

  /// @throws NotFinite, OutsideDomain  where the step is none
  StepSetting(Stream const& stream, Conserved conserved, double step, TurningFrame frame)
      : stream_(stream),
        sphere_(stream.size()),
        conserved_(conserved),
        step_(step),
        frame_(frame),
        eps_(step / (2 * Surface(stream.size()).hbar())) {
    if (!std::isfinite(step)) throw NotFinite("vorticity: step");
    if (step == 0) throw OutsideDomain("vorticity", "the step must differ from zero", 0, 0);
    if (!Surface::turns && frame.rate != 0)
      throw OutsideDomain("vorticity", "this surface has no frame that turns; the rate", frame.rate, 0);
  }

  /// Whether the step conserves the energy, by taking P of the mean of both ends.
  bool of_energy() const { return conserved_ != Conserved::lie_poisson; }
  /// Those along whose turns A is moved.
  Axes corrected_axes() const {
    if (!Surface::turns) return {};
    if (conserved_ == Conserved::all_invariants)
      return {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()};
    // Where nothing turns A is parallel to P, and the energy is conserved as it is.
    if (conserved_ == Conserved::energy_casimir && frame_.rate != 0) return {frame_.axis};
    return {};
  }
  /// What the angular momentum is a multiple of; zero where none is conserved.
  Eigen::Vector3d spins(SkewHermitian<> const& w) const {
    if constexpr (Surface::turns) return spin_components(sphere_, w);
    return Eigen::Vector3d::Zero();
  }
  /// P - Q. Here \f$Q = -i\,\mathrm{rate}\,\hbar\,e\cdot S\f$; the Lie-Poisson form takes the part of the
  /// middle in the place of e, which by the angular momentum that is conserved is the same up to O(h^2): then
  /// P - Q commutes with rotations as P does, and the step conserves the angular momentum.
  /// @param momentum  the modulus of the spin components of W_0
  void subtract_turning(SkewHermitian<> const& middle, double momentum, SkewHermitian<>& p) const {
    double const turn = frame_.rate * sphere_.hbar();
    if (turn == 0) return;
    Eigen::Vector3d const e = of_energy() ? frame_.axis : spins(middle) / momentum;
    add_spin(sphere_, turn * e, p);
  }

  Stream const& stream_;    ///< the map W -> P
  QuantizedSphere sphere_;  ///< of the matrices, for the rotations
  Conserved conserved_;     ///< beside the spectrum
  double step_;             ///< h, time
  TurningFrame frame_;      ///< in which the steps are made
  double eps_;              ///< h/(2 hbar)
};

}  // namespace actio::sphere
