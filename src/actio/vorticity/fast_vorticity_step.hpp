// The step of vorticity_step.hpp, found faster: mostly in single precision, with the same invariants.
//
// Any skew A gives an isospectral step W_1 = cay(A) W_0 cay(A)^*. So A alone is the unknown, and it is smooth
// in time, since P is. From the A of the steps before, extrapolated,
//
//   Wt = (1 - A)^{-1} W_0 (1 + A)^{-1}, in single precision (single_cayley.hpp), A <- eps P(Wt) as the form
//   has it,
//
// converges by a factor of about fifty a round; mostly one round or two are needed, and none where the flow
// is so smooth in time that the middle can be extrapolated, too. The end is found from A and the middle with
// the spectrum of W_0 to the rounding of double precision (isospectral_finish.hpp). Energy and angular
// momentum, where the form conserves them, are then off by about the tolerance; they are taken back by a
// small move along the orbit (orbit_move.hpp).
//
// What it gives up against the plain step: the solution is that of the implicit equation to the tolerance,
// and not to rounding, so going back returns to the tolerance.
#pragma once

#include <Eigen/Core>

#include "actio/skew_matrices/operator_radius.hpp"
#include "actio/vorticity/isospectral_finish.hpp"
#include "actio/vorticity/orbit_move.hpp"
#include "actio/vorticity/past_steps.hpp"
#include "actio/vorticity/vorticity_step.hpp"

namespace actio::sphere {

/// Steps of one length for one flow, in mixed precision.
///
/// \snippet sphere.cpp fast_vorticity_step
/// @tparam Stream  a linear map W -> P, as `StepSetting` has it: `solve(w, p)`, `solve(w)`, `size()`
template <class Stream = SphereLaplacian>
class FastVorticityStep : public StepSetting<Stream> {
 public:
  /// @param stream    of the Hamiltonian; referred to
  /// @param step      h, time; negative steps go back
  /// @param products  how real matrices are multiplied
  FastVorticityStep(Stream const& stream, Conserved conserved, double step, TurningFrame frame = {},
                    Products products = eigen_products())
      : StepSetting<Stream>(stream, conserved, step, frame),
        products_of_plain_(products),
        finish_(products),
        corrected_(sphere_, this->corrected_axes()),
        move_(sphere_, moved_axes()) {}

  /// How well A solves its equation, relative to |A|: not below what single precision gives, about 1e-9.
  double tolerance = 1e-8;
  /// Steps from which the first guess is extrapolated, as polynomials. Where the energy is conserved, A moves
  /// along the orbit by numbers that are less smooth in time, and more steps would amplify that.
  int extrapolated_steps = of_energy() ? 5 : 8;

  /// \f$W_0 \to W_1\f$, in the frame. The report's iterations are rounds, its residual that of A, relative to
  /// |A|; those of a plain step where one was made.
  /// @throws NotContracting  W is then as it was
  VorticityReport advance(SkewHermitian<>& w);

  /// Forgets the steps that were made: the next one begins as if it were the first.
  void forget() { past_.clear(), factors_.setZero(), radius_ = {}; }

  using Factors = PastStep::Factors;  ///< of what A is moved by
  using Past = PastStep;              ///< what the first guess of the next step needs of one that was made
  /// All that the next step depends on beside W: the steps before, the newest first.
  std::deque<Past> const& past() const { return past_; }
  /// Goes on as from these.
  void go_on_from(std::deque<Past> past) {
    past_ = std::move(past), factors_.setZero();
    radius_ = {};
    if (!past_.empty()) radius_ = {past_.front().radius, past_.front().age};
  }

  /// The largest modulus of an eigenvalue of A: `lanczos_radius`.
  static double spectral_radius(SkewHermitian<> const& a);

 private:
  using typename StepSetting<Stream>::Surface;
  using StepSetting<Stream>::stream_, StepSetting<Stream>::sphere_, StepSetting<Stream>::conserved_,
      StepSetting<Stream>::step_, StepSetting<Stream>::frame_, StepSetting<Stream>::eps_,
      StepSetting<Stream>::of_energy;
  static constexpr double lowest_ = 1e-6;              ///< changes above this are not put down to rounding
  static constexpr double last_change_ = 2e-8;         ///< of A, relative, whose square is below rounding
  static constexpr double largest_residual_ = 4e-7;    ///< relative to |W|, of what single precision finds
  static constexpr double smallest_residual_ = 5e-10;  ///< whose square matters after many steps
  static constexpr double longest_move_ = 3e-8;        ///< along the orbit, relative to |A|
  /// Of |W|: beyond, squares of what is found in single precision are no numbers of it.
  static constexpr double smallest_size_ = 1e-7, largest_size_ = 1e12;
  static constexpr int steps_to_wait_ = 16;  ///< after a guess that was not good enough
  /// Through which the polynomial of a guess goes that is the solution. Nothing then takes back what rounding
  /// is amplified by, and through more of them it would grow from step to step.
  static constexpr int explicit_steps_ = 5;
  /// Through which that of its middle goes. What it is off by, the finish takes back: more steps will do no
  /// harm until rounding is amplified to what they gain.
  static constexpr int middle_steps_ = 7;

  /// Those along which the angular momentum of the end is taken back.
  typename StepSetting<Stream>::Axes moved_axes() const {
    if (of_energy() || !Surface::turns) return this->corrected_axes();
    return {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()};
  }

  /// A step to rounding: any that cannot be found in single precision.
  VorticityReport plain_step(SkewHermitian<>& w) {
    VorticityStep<Stream> plain(stream_, conserved_, step_, frame_, products_of_plain_);
    VorticityReport report;
    SkewHermitian<> const before = w;
    try {
      report = plain.advance(w);
    } catch (NotContracting const&) {
      forget();
      throw;
    }
    auto const& made = plain.past().front();
    factors_ = made.factors;
    remember(before, plain.displacement(), before + made.increment, 1);
    return report;
  }

  /// A as a polynomial in time through the steps before; the first one begins from that of W_0.
  void guess(SkewHermitian<> const& w) {
    factors_.setZero();
    if (past_.empty()) {
      stream_.solve(w, p_);
      this->subtract_turning(w, momentum_.norm(), p_);
      a_ = eps_ * p_;
      return;
    }
    int const most = guess_is_enough() ? explicit_steps_ : extrapolated_steps;
    extrapolate(
        past_, [this](Past const& past, double weight) { factors_ += weight * past.factors; },
        explicit_steps_);
    extrapolate(past_, &Past::displacement, most, sum_);
    sum_.put(w.size(), a_);
  }
  /// @param middle  of which the increment is that from w
  void remember(SkewHermitian<> const& w, SkewHermitian<> const& displacement, SkewHermitian<> const& middle,
                double guess_error) {
    Past newest = make_room(past_, std::max(1, extrapolated_steps));
    newest.displacement.take(displacement), newest.increment.take_difference(middle, w);
    newest.factors = factors_, newest.guess_error = guess_error, newest.wait = wait_;
    newest.radius = radius_.ratio, newest.age = ++radius_.age;
    past_.push_front(std::move(newest));
  }

  /// Whether the guess of A is likely to be the solution: it was in the step before.
  bool guess_is_enough() const {
    return static_cast<int>(past_.size()) >= explicit_steps_ &&
           past_.front().guess_error <= 0.5 * tolerance && past_.front().wait <= 1;
  }
  /// A flow that is smooth in time needs no round at all: the middle is extrapolated, too, and the double
  /// precision of the finish says whether both are good enough.
  bool find_by_guess(SkewHermitian<> const& w, double size) {
    extrapolate(past_, &Past::increment, std::min(extrapolated_steps, middle_steps_), sum_);
    sum_.put_sum(w, middle_);
    double const radius = radius_.bound(a_);
    double const found = finish_.evaluate(w, a_, middle_, Negligible::beside(radius, size, w.size()));
    if (!(found <= largest_residual_ * size)) return false;
    // What the transform is off by is multiplied by r, and should not add up to a rounding in many steps.
    double const error = std::clamp(1e-18 * size / found, 2e-9, 1e-6);
    finish_.transform().factor(a_, radius, error);
    if (found > smallest_residual_ * size) finish_.better_middle(a_, radius_.age, middle_);
    return true;
  }

  /// A and the middle, to the tolerance.
  /// @return false where the rounds do not contract
  bool find(SkewHermitian<> const& w, VorticityReport& report) {
    single_.real = w.real.template cast<float>(), single_.imaginary = w.imaginary.template cast<float>();
    double before = std::numeric_limits<double>::infinity();
    for (;;) {
      double const radius = radius_.bound(a_);
      if (!(radius < 1)) return false;
      finish_.transform().factor(a_, radius);
      finish_.find_middle(w, single_, of_energy(), middle_, average_);
      find_displacement(w);
      ++report.iterations;
      double const change = report.residual = relative_distance(a_, next_);
      if (change <= tolerance) return true;
      if (!(change < 0.25 * before)) return change < lowest_;
      before = change;
      std::swap(a_, next_);
      // The new A is better by the factor of a round, and the middle and the transform of the old one are
      // good enough for the finish.
      if (change <= last_change_) return true;
    }
  }

  /// The A that belongs to the middle.
  void find_displacement(SkewHermitian<> const& w) {
    stream_.solve(of_energy() ? average_ : middle_, p_);
    this->subtract_turning(middle_, momentum_.norm(), p_);
    next_.real = eps_ * p_.real, next_.imaginary = eps_ * p_.imaginary;
    // The extrapolated factors are better than what single precision would find; what they lack is found at
    // the end.
    if (corrected_.count() != 0) move_displacement(w);
  }
  /// Adds what the factors say to the A that was found, along X_0 = [A, Wt] and X_j = [iS_j, Wt].
  void move_displacement(SkewHermitian<> const& w) {
    if (half_change_.size() != w.size()) half_change_ = SkewHermitian<>(w.size());
    half_change_.real = average_.real - w.real, half_change_.imaginary = average_.imaginary - w.imaginary;
    add_combination(corrected_, &half_change_, middle_, factors_, next_);
  }

  /// Evaluates the equation of the step at the middle that was found in single precision.
  /// @return false where r is too large for single precision
  bool settle(SkewHermitian<> const& w, double size) {
    // The polynomial of the transform is good on an interval of which the end was estimated.
    double found;
    Negligible const nothing = Negligible::beside(radius_.bound(a_), size, w.size());
    for (int tries = 0; !((found = finish_.evaluate(w, a_, middle_, nothing)) <= largest_residual_ * size);
         ++tries) {
      if (tries == 4) return false;
      radius_.ratio *= 1.2;
      finish_.transform().factor(a_, radius_.bound(a_));
      finish_.find_middle(w, single_, of_energy(), middle_, average_);
    }
    if (found > smallest_residual_ * size) finish_.better_middle(a_, radius_.age, middle_);
    return true;
  }

  /// Takes energy and angular momentum back to what they were, along the orbit. The A that is found on the
  /// way is the one to be remembered: that of the middle in double precision, without the noise of single
  /// precision.
  /// @return false where it would be a long way; the factors are then the better ones
  bool polish(SkewHermitian<> const& w) {
    bool const energy = of_energy();
    auto const& axes = move_.axes();
    Eigen::Index const first = energy ? 1 : 0;
    Eigen::VectorXd change(first + static_cast<Eigen::Index>(axes.size()));
    double scale = 0;
    if (energy)
      average_.real = 0.5 * (w.real + end_.real), average_.imaginary = 0.5 * (w.imaginary + end_.imaginary);
    stream_.solve(energy ? average_ : middle_, p_);
    this->subtract_turning(middle_, momentum_.norm(), p_);
    next_.real = eps_ * p_.real, next_.imaginary = eps_ * p_.imaginary;
    if (energy) {
      scale = std::abs(eps_) * norm(p_);
      change[0] = eps_ * (p_.real.cwiseProduct(end_.real - w.real).sum() +
                          p_.imaginary.cwiseProduct(end_.imaginary - w.imaginary).sum());
    }
    if (change.size() == 0) return true;
    Eigen::Vector3d const momentum = this->spins(end_) - momentum_;
    for (std::size_t j = 0; j < axes.size(); ++j)
      change[static_cast<Eigen::Index>(j) + first] = axes[j].dot(momentum);
    single_.real = end_.real.template cast<float>();
    single_.imaginary = end_.imaginary.template cast<float>();
    if (energy) {
      // What a move changes the energy by goes by P of the end.
      stream_.solve(end_, p_);
      this->subtract_turning(middle_, momentum_.norm(), p_);
      stream_of_end_.real = (eps_ * p_.real).template cast<float>();
      stream_of_end_.imaginary = (eps_ * p_.imaginary).template cast<float>();
    }
    // The third power of the move is left out.
    double const longest = longest_move_ * norm(next_);
    Eigen::VectorXd const move =
        move_.find(finish_.transform(), energy ? &stream_of_end_ : nullptr, single_, change, scale, longest);
    bool const is_short = move_.length() <= longest;
    if (corrected_.count() != 0 || !is_short) factors_.head(move.size()) += 0.5 * move;
    if (!is_short) return false;
    // Commutators with the spins reach across the diagonal, above which the finish leaves the middle as it
    // was.
    if (corrected_.count() != 0) mirror_lower(middle_), move_displacement(w);
    move_.move(finish_.transform(), single_, end_);
    return true;
  }

  Eigen::Vector3d momentum_ = Eigen::Vector3d::Zero();  ///< spin components of W_0
  Products products_of_plain_;
  IsospectralFinish<> finish_;
  SpinColumns<double> corrected_;
  OrbitMove<> move_;

  SkewHermitian<> a_, next_, p_, middle_, average_, half_change_, end_;
  SkewHermitian<float> single_, stream_of_end_;
  LowerHalf sum_;
  Factors factors_ = Factors::Zero();
  int wait_ = 0;           ///< steps for which the guess is not tried as the solution
  FollowedRadius radius_;  ///< the largest eigenvalue of A
  std::deque<Past> past_;  ///< the newest first
};

template <class Stream>
VorticityReport FastVorticityStep<Stream>::advance(SkewHermitian<>& w) {
  double const size = norm(w);
  if (size == 0) return {};
  if (!(size >= smallest_size_ && size <= largest_size_)) return plain_step(w);
  momentum_ = this->spins(w);
  VorticityReport report;
  guess(w);
  wait_ = past_.empty() ? 0 : std::max(0, past_.front().wait - 1);
  bool made = false;
  double guess_error = 1;
  if (guess_is_enough()) {
    ++report.iterations;
    if (find_by_guess(w, size)) {
      finish_.find_end(w, middle_, end_);
      made = polish(w);
      guess_error = report.residual = relative_distance(a_, next_);
      // Not good enough, it is where the rounds begin.
      if (!(guess_error <= tolerance)) made = false, std::swap(a_, next_);
    }
    if (!made) wait_ = steps_to_wait_;
  }
  // Without a history the factors are not known: what the polish finds then is where the next attempt begins.
  for (int tries = corrected_.count() == 0 ? 1 : 4; !made && tries > 0; --tries) {
    if (!find(w, report) || !settle(w, size)) break;
    finish_.find_end(w, middle_, end_);
    made = polish(w);
    if (made && static_cast<int>(past_.size()) >= explicit_steps_)
      guess_error = error_of_guess(past_, explicit_steps_, next_);
  }
  if (!made) return plain_step(w);
  remember(w, next_, middle_, guess_error);
  w.real.swap(end_.real), w.imaginary.swap(end_.imaginary);
  return report;
}

template <class Stream>
double FastVorticityStep<Stream>::spectral_radius(SkewHermitian<> const& a) { return lanczos_radius(a); }

extern template class FastVorticityStep<SphereLaplacian>;

}  // namespace actio::sphere
