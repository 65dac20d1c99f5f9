// Energy and angular momentum taken back along the coadjoint orbit, after any step that conserves the
// spectrum.
//
// Such a step leaves energy and angular momentum off by its error. A conjugation W <- cay(Y) W cay(Y)^*
// takes them back, and no conjugation changes the spectrum. To first order it adds 2[Y, W], so with
//
//   Y = sum_i c_i X_i,   X_i = [Q_i, W],   Q_0 = P/|P|,   Q_j = iS_j/|S_j|,
//
// and f_0 = <P, W>/(2|P|), f_j = <Q_j, W>, the derivatives of the four numbers are -2<X_i, X_k>: twice the
// Gram matrix that `all_invariants` takes its Newton steps with. Newton's iteration begins at a state that is
// off by an error of order h^(p+1), so it takes two rounds, moves W by as little, and the order of the step
// stays p. The step back does not undo it: such a step is no longer reversible.
//
// At a relative equilibrium the X_i are dependent: a combination of energy and angular momentum is stationary
// along the orbit. Near one it hardly changes with W, and the eigenvalue of the Gram matrix is the square of
// that little. So the X_i themselves are made orthonormal.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <limits>

#include "actio/quantized_sphere/laplacian.hpp"
#include "actio/quantized_sphere/sphere_invariants.hpp"
#include "actio/skew_matrices/products.hpp"

namespace actio::sphere {

/// Energy and angular momentum of a state: the levels on which its motion stays.
struct EnergyMomentum {
  double energy = 0;                                   ///< as `vorticity_energy` has it
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();  ///< as `sphere_momentum` has it
};
/// Those of W.
/// @param stream  the map W -> P, for instance a `SphereLaplacian`
template <class Stream>
EnergyMomentum energy_momentum(Stream const& stream, SkewHermitian<> const& w) {
  return {vorticity_energy(stream, w), sphere_momentum(w)};
}

/// How a state was taken back.
struct ProjectionReport {
  int newton_steps = 0;  ///< each of them one commutator and a conjugation
  double found = 0;      ///< how far the levels were missed: the four numbers f above, relative to |W|
  double left = 0;       ///< the same at the end
};

/// Takes states to given levels of energy and angular momentum along their coadjoint orbits.
/// @tparam Stream  a linear map W -> P that commutes with rotations: `solve(w, p)`, `solve(w)`, `size()`
template <class Stream = SphereLaplacian>
class OrbitProjection {
 public:
  /// @param stream    of the Hamiltonian; referred to, so that it may not be a temporary
  /// @param products  how real matrices are multiplied
  explicit OrbitProjection(Stream const& stream, Products products = eigen_products())
      : stream_(stream), sphere_(stream.size()), products_(std::move(products)) {}
  explicit OrbitProjection(Stream const&& stream, Products products = eigen_products()) = delete;

  /// W on the levels, conjugated by a unitary matrix. Two Newton steps where W is the result of a step with
  /// small errors, none where W is there already. Accuracy: rounding, in the levels and in the spectrum.
  /// @throws OutsideDomain  where the orbit does not lead from W to these levels; W is then as it was
  /// @throws NotFinite      where W, its square or the levels are no numbers
  ProjectionReport project(EnergyMomentum const& levels, SkewHermitian<>& w) {
    double const size = norm(w);
    if (!std::isfinite(size)) throw NotFinite("orbit projection: W, or its square");
    if (!std::isfinite(levels.energy) || !levels.momentum.allFinite())
      throw NotFinite("orbit projection: the levels");
    if (size == 0 && levels.energy == 0 && levels.momentum.norm() == 0) return {};
    SkewHermitian<> now = w;
    Eigen::Vector4d change = missed(levels, now, size);
    ProjectionReport report{0, change.norm(), change.norm()};
    while (report.left > 2 * rounding && report.newton_steps < most_steps) {
      SkewHermitian<> y = direction(change, now, size);
      double const before = report.left;
      // Near an equilibrium the gradients change along a Newton step: a shorter one leads on.
      for (int tries = before > reach ? 8 : 1; tries > 0 && report.left == before; --tries, y *= 0.5) {
        SkewHermitian<> next = now;
        conjugate(y, size, next);
        ++report.newton_steps;
        Eigen::Vector4d const then = missed(levels, next, size);
        if (then.norm() < before) now = std::move(next), change = then, report.left = then.norm();
      }
      // Below the reach rounding may keep it from falling.
      if (report.left == before || (report.left > before / 2 && report.left <= reach)) break;
    }
    if (!(report.left <= reach))
      throw OutsideDomain("orbit projection",
                          "along the orbit energy and angular momentum must come to their "
                          "levels; the residual, relative to |W|",
                          report.left, reach);
    if (report.newton_steps != 0) w = std::move(now);
    return report;
  }

 private:
  static constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
  static constexpr double reach = 1e-12;   ///< farther off than this is no rounding
  static constexpr double longest = 0.25;  ///< a conjugation: its fixed point contracts by a half
  static constexpr int most_steps = 100;   ///< two in general; more near an extremum of the energy

  /// What the four numbers f are above their levels, relative to |W|; keeps P.
  Eigen::Vector4d missed(EnergyMomentum const& levels, SkewHermitian<> const& w, double size) {
    double const area = sphere_.area_element();
    stream_.solve(w, p_);
    // No P is smaller, unless it is zero.
    double const least = std::numeric_limits<double>::epsilon() * size / (sphere_.n * double(sphere_.n));
    p_size_ = std::max({norm(p_), least, std::numeric_limits<double>::min()});
    Eigen::Vector4d change;
    change[0] = (inner_product(p_, w) / 2 + levels.energy / area) / p_size_;
    change.tail<3>() = (spin_components(sphere_, w) - levels.momentum / (area * sphere_.hbar())) /
                       std::sqrt(sphere_.spin_square());
    return change / size;
  }
  /// Y, from P and what is missed.
  SkewHermitian<> direction(Eigen::Vector4d change, SkewHermitian<> const& w, double size) {
    std::array<SkewHermitian<>, 4> x;  // X_i/|W|
    products_.multiply(p_, w, x[0]);
    x[0] *= 1 / (size * p_size_);
    for (int j = 0; j < 3; ++j)
      x[j + 1] = (1 / (size * std::sqrt(sphere_.spin_square()))) * spin_commutator(sphere_, j, w);
    // The directions are made orthonormal, the longest first, and what is missed is taken back along one
    // after another. A remainder of a direction that is mere rounding is no direction, and a miss that is
    // mere rounding is not taken back: divided by a small length it would become a motion.
    SkewHermitian<> y(w.size());
    double most = 0;
    for (int k = 0; k < 4; ++k) {
      int at = k;
      double length = norm(x[k]);
      for (int i = k + 1; i < 4; ++i)
        if (double const other = norm(x[i]); other > length) at = i, length = other;
      std::swap(x[k], x[at]), std::swap(change[k], change[at]);
      most = std::max(most, length);
      if (!(length > 1e-9 * most)) break;
      // [orbit_projection]
      x[k] *= 1 / length;
      double const part = std::abs(change[k]) > rounding ? change[k] / length : 0;
      y += (part / 2) * x[k];
      for (int i = k + 1; i < 4; ++i) {
        double const along = inner_product(x[k], x[i]);
        x[i] -= along * x[k], change[i] -= along * part;
      }
      // [orbit_projection]
    }
    double const length = norm(y);
    if (length > longest) y *= longest / length;
    return y;
  }
  /// \f$\mathrm{cay}(Y)\,W\,\mathrm{cay}(Y)^*\f$ in the place of W, by the fixed point of a step.
  void conjugate(SkewHermitian<> const& y, double size, SkewHermitian<>& w) {
    SkewHermitian<> increment(w.size());  // Wt - W
    for (double moved = size; moved > std::numeric_limits<double>::epsilon() / 4 * size;) {
      products_.multiply(y, w + increment, commutator_);
      products_.multiply_again(y, remainder_);
      SkewHermitian<> found = commutator_ + remainder_;
      double const by = norm(found - increment);
      if (!(by < moved)) break;
      moved = by, increment = std::move(found);
    }
    commutator_ *= 2, w += commutator_;
  }

  Stream const& stream_;
  QuantizedSphere sphere_;
  SkewProducts<double> products_;
  SkewHermitian<> p_, commutator_, remainder_;
  double p_size_ = 0;
};

}  // namespace actio::sphere
