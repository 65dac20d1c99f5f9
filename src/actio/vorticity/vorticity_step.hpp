// One step of the ideal fluid on the sphere (thesis, chapter 10): discrete Lie-Poisson on SU(N).
//
// The equations are dW/dt = [P, W]/hbar with Delta P = W. A step is W_1 = cay(A) W_0 cay(A)^* with A = h/(2
// hbar) P; with the middle Wt, A Wt and its commutator it is
//
//   W_0 = (1 - A) Wt (1 + A)   or   Wt = W_0 + [A, Wt] + A Wt A,
//   W_1 = (1 + A) Wt (1 - A) = W_0 + 2 [A, Wt].
//
// Any skew A leaves the spectrum of W as it is. What P is taken of decides what else is conserved:
//
//   lie_poisson      P of Wt: the discrete Euler-Poincare algorithm of chapter 3 with the Cayley map. Angular
//                    momentum and the Lie-Poisson structure; energy up to O(h^2), without a drift.
//   energy_casimir   P of (W_0 + W_1)/2 = W_0 + [A, Wt]: energy, and the part of the angular momentum along
//                    the axis of the frame; no longer a Poisson map.
//   all_invariants   the same, and A moved along the orbit by what takes energy and angular momentum back.
//
// The step is made in a frame that turns (turning_frame.hpp).
//
// On a sphere that turns fast nearly all of W is the planet's, and what belongs to the flow would be lost in
// the rounding of it. There the state is what the flow has beside a zonal background bX, X = i hbar S_3, and
// no number of the size of b is added to one of the flow (zonal_background.hpp).
#pragma once

#include <Eigen/Core>

#include <deque>
#include <limits>

#include "actio/quantized_sphere/laplacian.hpp"
#include "actio/quantized_sphere/zonal_background.hpp"
#include "actio/skew_matrices/cayley_middle.hpp"
#include "actio/skew_matrices/operator_radius.hpp"
#include "actio/vorticity/orbit_correction.hpp"
#include "actio/vorticity/past_steps.hpp"
#include "actio/vorticity/step_setting.hpp"

namespace actio::sphere {

/// Steps of one length for one flow of the ideal fluid on the sphere (\ref ch10a).
///
/// The state is a matrix W, made of the harmonics of the vorticity by \ref matrix_of. Energy, angular
/// momentum and Casimirs are read by \ref vorticity_energy, \ref sphere_momentum and \ref vorticity_casimirs.
///
/// \snippet ch10_outlook/try_it.cpp vorticity_step
/// @tparam Stream  a map W -> P, as `StepSetting` has it: `solve(w, p)`, `solve(w)`, `size()`
template <class Stream = SphereLaplacian>
class VorticityStep : public StepSetting<Stream> {
 public:
  /// @param stream    of the Hamiltonian; referred to
  /// @param step      h, time; negative steps go back
  /// @param products    how real matrices are multiplied
  /// @param background  what W has beside the state that is advanced; the frame turns about the third axis
  VorticityStep(Stream const& stream, Conserved conserved, double step, TurningFrame frame = {},
                Products products = eigen_products(), ZonalBackground background = {})
      : StepSetting<Stream>(stream, conserved, step, frame),
        products_(std::move(products)),
        directions_(this->corrected_axes()),
        background_(background) {}

  /// Residuals of the equation are relative to |W|; below the default they are left to rounding.
  double tolerance = 0;
  /// Steps from which the first guess is extrapolated, as polynomials.
  int extrapolated_steps = 5;

  /// \f$W_0 \to W_1\f$, in the frame. The solution is accurate to rounding, or to the tolerance.
  ///
  /// Where the iteration does not contract, because A is large, each round finds the middle of its A without
  /// an error, by an elimination: a flow that is at rest in the frame then takes steps of any length.
  /// @throws NotContracting  W is then as it was
  /// @throws NotFinite, OutsideDomain  where the squares of W are no numbers, or all of them zero
  VorticityReport advance(SkewHermitian<>& w);

  /// The A of the last step, and its commutator with the middle: half the change of W.
  SkewHermitian<> const& displacement() const { return a_; }
  /// \f$[A, \tilde W]\f$.
  SkewHermitian<> const& half_change() const { return commutator_; }
  /// \f$\tilde W\f$.
  SkewHermitian<> const& middle() const { return middle_; }

  /// Forgets the steps that were made: the next one begins as if it were the first.
  void forget() { past_.clear(), factors_.setZero(); }

  /// Of what A is moved by: energy, and up to three directions.
  using Factors = Eigen::Vector4d;
  /// A step that was made, as the first guess of the next one needs it.
  struct Past {
    SkewHermitian<> increment;    ///< D = Wt - W_0
    SkewHermitian<> half_change;  ///< (W_1 - W_0)/2; empty for the Lie-Poisson form, which does not need it
    Factors factors;              ///< of this step
  };
  /// All that the next step depends on beside W: the steps before, the newest first.
  std::deque<Past> const& past() const { return past_; }
  /// Goes on as from these.
  void go_on_from(std::deque<Past> past) { past_ = std::move(past), factors_.setZero(); }

  /// The largest modulus of an eigenvalue of A: `power_radius`.
  static double spectral_radius(SkewHermitian<> const& a) { return power_radius(a); }

 private:
  using StepSetting<Stream>::stream_, StepSetting<Stream>::sphere_, StepSetting<Stream>::step_,
      StepSetting<Stream>::frame_, StepSetting<Stream>::eps_, StepSetting<Stream>::of_energy;
  static constexpr int most_iterations = 200;
  static constexpr double rounding_ = 1e-13;
  static constexpr double smallest_size = 1e-140;

  /// Solves the equation of a step; false where no iteration contracts.
  bool find(SkewHermitian<> const& w, double size, VorticityReport& report) {
    if (iterate(w, size, false, report)) return true;
    forget();
    return calm(w, size) && iterate(w, size, true, report);
  }
  /// Whether the flow changes W, in a step, by less than W. Cayley's transform of an A that is too large is
  /// near -1, and the equation then has solutions that hardly move.
  bool calm(SkewHermitian<> const& w, double size) {
    guess(w);
    middle_ = w;
    find_displacement(w);
    multiply();
    return 2 * norm(commutator_) <= size;
  }
  /// @param eliminate  whether the middle is found by elimination
  bool iterate(SkewHermitian<> const& w, double size, bool eliminate, VorticityReport& report) {
    guess(w);
    SkewHermitian<> increment_before, middle_before;  // those before the last, for the second-order iteration
    double least = std::numeric_limits<double>::infinity(), relax = 1;
    int stays = 0;  // evaluations since the residual was halved
    for (int made = 1;; ++made) {
      middle_ = w + increment_;
      find_displacement(w);
      if (eliminate)
        find_middle(w);
      else if (made == 1)
        relax = relaxation(w);
      multiply();
      ++report.iterations;
      // Both unknowns: D = Wt - W_0, and half the change of W.
      // [vorticity_fixed_point]
      SkewHermitian<> const found = commutator_ + remainder_;
      // [vorticity_fixed_point]
      // With elimination the first follows from the second, where P is taken of that.
      bool const middle_known = eliminate && of_energy();
      double const residual = std::hypot(middle_known ? 0 : norm(found - increment_),
                                         of_energy() ? norm(commutator_ - half_change_) : 0);
      double const imbalance = correct();
      double const all = std::max(residual, imbalance) / size;
      report.residual = all;
      if (!std::isfinite(all)) return false;
      double const moved = eliminate ? norm(a_) * norm(middle_) : norm(found);
      if (all <= std::max(tolerance, 0.25 * std::numeric_limits<double>::epsilon() * moved / size))
        return true;
      // Where rounding keeps it from falling it is done.
      stays = all < 0.5 * least ? 0 : stays + 1;
      if (least < rounding_ && stays >= 2) return true;
      if (made >= most_iterations || (made > 8 && all > 10)) return false;
      least = std::min(least, all);
      SkewHermitian<> next = found, next_half = commutator_;
      if (increment_before.size() != 0) {
        next *= relax, increment_before *= 1 - relax, next += increment_before;
        next_half *= relax, middle_before *= 1 - relax, next_half += middle_before;
      }
      increment_before = std::move(increment_), middle_before = std::move(half_change_);
      increment_ = std::move(next), half_change_ = std::move(next_half);
    }
  }
  /// The products of the equation of a step.
  void multiply() {
    // [vorticity_products]
    products_.multiply(a_, middle_, commutator_);  // [A, Wt], and A Wt beside it
    if (background_.is_there()) zonal_.add_to_product(a_, middle_, products_, commutator_);
    products_.multiply_again(a_, remainder_);  // A Wt A
    // [vorticity_products]
    if (background_.is_there()) zonal_.add_outside(a_, products_, remainder_);
  }
  /// A with its part of the background.
  SkewHermitian<> whole_displacement() const {
    SkewHermitian<> a = a_;
    if (background_.is_there()) zonal_.add_own(a);
    return a;
  }
  /// The middle of the A that was found, without an error.
  void find_middle(SkewHermitian<> start) {
    if (background_.is_there()) {
      // What there would be without a flow in the middle is brought to the other side.
      middle_ = SkewHermitian<>(start.size());
      multiply();
      start += commutator_, start += remainder_;
    }
    eliminate_middle(whole_displacement(), start, middle_);
  }
  /// The longest of some shorter steps from W that are found; each is half as long as the one before. Where A
  /// is eight times as large as one none is tried.
  double longest_from(SkewHermitian<> const& w, double size) {
    double const eps = eps_;
    forget();
    guess(w);
    middle_ = w;
    find_displacement(w);
    double part = std::min(1.0, 8 / spectral_radius(whole_displacement()));
    bool found = false;
    for (int tried = 0; tried < 20 && !found; ++tried) {
      part /= 2, eps_ = part * eps;
      forget();
      VorticityReport report;
      found = find(w, size, report);
    }
    eps_ = eps;
    forget();
    return found ? part * step_ : 0;
  }

  /// D and C as polynomials in time through the steps before.
  void guess(SkewHermitian<> const& w) {
    if (background_.is_there()) zonal_ = ZonalTerms(sphere_, background_, eps_);
    increment_ = half_change_ = SkewHermitian<>(w.size());
    if (!past_.empty()) factors_.setZero();
    extrapolate(past_, [this](Past const& past, double weight) {
      increment_.real += weight * past.increment.real,
          increment_.imaginary += weight * past.increment.imaginary;
      if (of_energy())
        half_change_.real += weight * past.half_change.real,
            half_change_.imaginary += weight * past.half_change.imaginary;
      factors_ += weight * past.factors;
    });
  }
  void remember() {
    if (extrapolated_steps == 0) return;
    past_.push_front({commutator_ + remainder_, of_energy() ? commutator_ : SkewHermitian<>(), factors_});
    if (static_cast<int>(past_.size()) > extrapolated_steps) past_.pop_back();
  }

  /// What P is taken of.
  SkewHermitian<> source_of_stream(SkewHermitian<> const& w) const {
    SkewHermitian<> source = of_energy() ? w + half_change_ : middle_;
    if (!of_energy()) {
      // What turns as a whole commutes with the rest, and the frame turns with it.
      if (background_.is_there())
        add_spin(sphere_, -1 / sphere_.spin_square() * spin_components(sphere_, source), source);
      return source;
    }
    // The angular momentum that is conserved is left out of the change: where a planet turns fast, it would
    // be amplified before it vanishes.
    Eigen::Vector3d const change = this->spins(half_change_);
    for (auto const& e : directions_) add_spin(sphere_, -e.dot(change) / sphere_.spin_square() * e, source);
    return source;
  }
  /// A, from the middle and the factors as they are.
  void find_displacement(SkewHermitian<> const& w) {
    // [vorticity_displacement]
    stream_.solve(source_of_stream(w), p_);
    if (!background_.is_there()) this->subtract_turning(middle_, momentum_, p_);
    a_ = eps_ * p_;
    // [vorticity_displacement]
    if (directions_.empty()) return;
    SkewHermitian<> whole = middle_;
    if (background_.is_there()) zonal_.add_middle(whole);
    turned_.clear();
    for (auto const& e : directions_) turned_.push_back(TurningFrame{e, 0}.turn(sphere_, whole));
    // [vorticity_along_orbit]
    a_ += factors_[0] * half_change_;
    for (std::size_t j = 0; j < turned_.size(); ++j)
      a_ += factors_[static_cast<Eigen::Index>(j) + 1] * turned_[j];
    // [vorticity_along_orbit]
  }

  /// What energy and angular momentum change by in the step, as a change of W; and a Newton step of the
  /// factors against it.
  double correct() {
    return correct_factors(sphere_, {eps_, p_, a_, middle_, commutator_, directions_, turned_},
                           background_.is_there() ? std::optional(zonal_.turn()) : std::nullopt, factors_);
  }

  /// That of the second-order iteration for a spectrum on the imaginary axis. Its radius is 2|A| by what A
  /// does to the middle; and where W is mostly a rotation with the rate r, P of a change of degree 2 turns it
  /// by hr/3.
  double relaxation(SkewHermitian<> const& w) const {
    double const rate = 0.5 * (this->spins(w).norm() / sphere_.spin_square() / sphere_.hbar() +
                               std::abs(background_.vorticity));
    double const beta = 2 * spectral_radius(whole_displacement()) + std::abs(step_) * rate / 3;
    return 2 / (1 + std::sqrt(1 + beta * beta));
  }

  double momentum_ = 0;  ///< modulus of the spin components of W
  SkewProducts<double> products_;
  typename StepSetting<Stream>::Axes directions_;
  ZonalBackground background_;
  ZonalTerms zonal_;  ///< of the background, for the step

  SkewHermitian<> increment_, half_change_;  ///< the unknowns: D, and C where P is taken of it
  SkewHermitian<> middle_, p_, a_, commutator_, remainder_;
  std::vector<SkewHermitian<>> turned_;
  Factors factors_ = Factors::Zero();
  std::deque<Past> past_;  ///< the newest first
};

template <class Stream>
VorticityReport VorticityStep<Stream>::advance(SkewHermitian<>& w) {
  double const size = norm(w);
  if (!std::isfinite(size)) throw NotFinite("vorticity: W, or its square");
  if (!(size > smallest_size) &&
      std::max(w.real.cwiseAbs().maxCoeff(), w.imaginary.cwiseAbs().maxCoeff()) > 0)
    throw OutsideDomain("vorticity", "its squares must be numbers: |W|", size, smallest_size);
  if (size == 0) return {};
  if (frame_.rate != 0 && !of_energy()) momentum_ = this->spins(w).norm();
  VorticityReport report;
  if (!find(w, size, report)) throw NotContracting(step_, longest_from(w, size));
  remember();
  // [vorticity_increment]
  w.real += 2 * commutator_.real, w.imaginary += 2 * commutator_.imaginary;
  // [vorticity_increment]
  return report;
}

// Our own programs have the steps compiled once (compiled_steps.cpp): it takes longer than most of them.
// What stands outside the class, and what it calls, is then compiled nowhere else.
extern template class VorticityStep<SphereLaplacian>;

}  // namespace actio::sphere
