// The step of vorticity_step.hpp, found faster: mostly in single precision, with the same invariants.
//
// Any skew A gives an isospectral step W_1 = cay(A) W_0 cay(A)^*. So A alone is the unknown, and it is smooth
// in time, since P is. From the A of the steps before, extrapolated,
//
//   Wt = (1 - A)^{-1} W_0 (1 + A)^{-1}, in single precision (single_cayley.hpp), A <- eps P(Wt) as the form
//   has it,
//
// converges by a factor of about fifty a round; mostly one round or two are needed, and none where the flow
// is so smooth in time that the middle can be extrapolated, too. Then the equation of the step is evaluated
// once in double precision, with C = [A, Wt]:
//
//   r = W_0 + C + A Wt A - Wt,        W_1 = W_0 - r + 2C + U r U^*,  U = cay(A).
//
// This is cay(A) W_0 cay(A)^* whatever r is. As r is of the size of a rounding in single precision, U r U^*
// may be found in single precision, and the spectrum of W_1 is that of W_0 to the rounding of double
// precision. Energy and angular momentum, where the form conserves them, are then off by about the tolerance;
// they are taken back by a move along the orbit, W_1 + [Y, W_1] + [Y, [Y, W_1]]/2 with Y = sum c_i [Q_i,
// W_1], Q_i being the P of W_1 and the spin matrices; single precision will do for it, too.
//
// What would add up over many steps is kept small: r once more by what it does to itself (better_middle),
// since the error of the transform has made r and multiplies it.
//
// What it gives up against the plain step: the solution is that of the implicit equation to the tolerance,
// and not to rounding, so going back returns to the tolerance.
#pragma once

#include "actio/vorticity/single_cayley.hpp"
#include "actio/vorticity/spin_columns.hpp"
#include "actio/vorticity/vorticity_step.hpp"

namespace actio {

/// Steps of one length for one flow, in mixed precision.
/// @tparam Stream  a linear map W -> P that commutes with rotations: `solve(w, p)`, `solve(w)`, `size()`
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
        products_(products),
        cayley_(products),
        corrected_(sphere_, this->corrected_axes()),
        polished_(sphere_, polished_axes()) {}

  /// How well A solves its equation, relative to |A|: not below what single precision gives, about 1e-9.
  double tolerance = 1e-8;
  /// Steps from which the first guess is extrapolated, as polynomials.
  int extrapolated_steps = 5;

  /// \f$W_0 \to W_1\f$, in the frame. The report's iterations are rounds, its residual that of A, relative to
  /// |A|; those of a plain step where one was made.
  /// @throws NotContracting  W is then as it was
  VorticityReport advance(SkewHermitian<>& w);

  /// Forgets the steps that were made: the next one begins as if it were the first.
  void forget() { past_.clear(), factors_.setZero(), radius_ = 0; }

  /// Of what A is moved by: energy, and up to three directions.
  using Factors = Eigen::Vector4d;
  /// A step that was made, as the first guess of the next one needs it.
  struct Past {
    SkewHermitian<> displacement;    ///< A
    SkewHermitian<float> increment;  ///< Wt - W_0
    Factors factors;                 ///< of this step
    double first_change = 1;         ///< of A, relative, by the first of its rounds: how good the guess was
    int wait = 0;                    ///< steps for which the guess is not tried as the solution
    double radius = 0;               ///< an estimate of the largest eigenvalue of A over |A|
    int age = 0;                     ///< steps since it was made
  };
  /// All that the next step depends on beside W: the steps before, the newest first.
  std::deque<Past> const& past() const { return past_; }
  /// Goes on as from these.
  void go_on_from(std::deque<Past> past) {
    past_ = std::move(past), factors_.setZero();
    radius_ = past_.empty() ? 0 : past_.front().radius, age_ = past_.empty() ? 0 : past_.front().age;
  }

  /// The largest modulus of an eigenvalue of A by the method of Lanczos: an estimate from below, good to one
  /// per cent or so.
  static double spectral_radius(SkewHermitian<> const& a) {
    auto const n = a.size();
    constexpr int most = 16;
    using Vectors = Eigen::Matrix<double, Eigen::Dynamic, 2>;
    Vectors v(n, 2), before = Vectors::Zero(n, 2), u(n, 2);
    for (Eigen::Index k = 0; k < n; ++k) {
      auto const x = static_cast<double>(k);
      v.row(k) << std::cos(1.7 * x * x + x), std::sin(2.3 * x * x + 1);
    }
    v.normalize();
    Eigen::VectorXd diagonal(most), beside(most);
    int count = 0;
    while (count < most) {
      // u = -iA v.
      Vectors const r = a.real * v, j = a.imaginary * v;
      u.col(0) = j.col(0) + r.col(1), u.col(1) = j.col(1) - r.col(0);
      diagonal[count] = u.cwiseProduct(v).sum();
      u -= diagonal[count] * v;
      if (count > 0) u -= beside[count - 1] * before;
      beside[count] = u.norm();
      ++count;
      if (!(beside[count - 1] > 1e-12 * diagonal.head(count).cwiseAbs().maxCoeff())) break;
      before = v, v = u / beside[count - 1];
    }
    return tridiagonal_values<Eigen::MatrixXd>(diagonal.head(count), beside.head(count - 1))
        .cwiseAbs()
        .maxCoeff();
  }

 private:
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
  static constexpr double shortest_move_ = 5e-10;  ///< of W, relative, whose square matters after many steps
  static constexpr double cutoff_ = 1e-5;          ///< of eigenvalues that single precision tells from zero
  static constexpr int steps_to_wait_ = 16;        ///< after a guess that was not good enough
  static constexpr int steps_of_radius_ = 16;      ///< for which an estimate of the radius is taken as good

  /// Those along whose turns W_1 is moved.
  typename StepSetting<Stream>::Axes polished_axes() const {
    if (of_energy()) return this->corrected_axes();
    return {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()};
  }

  /// A step to rounding: any that cannot be found in single precision.
  VorticityReport plain_step(SkewHermitian<>& w) {
    VorticityStep<Stream> plain(stream_, conserved_, step_, frame_, products_of_plain_);
    VorticityReport report;
    try {
      report = plain.advance(w);
    } catch (NotContracting const&) {
      forget();
      throw;
    }
    first_change_ = 1;
    auto const& made = plain.past().front();
    remember(plain.displacement(), made.increment, made.factors);
    return report;
  }

  /// A as a polynomial in time through the steps before; the first one begins from that of W_0.
  void guess(SkewHermitian<> const& w) {
    factors_.setZero();
    auto const count = static_cast<int>(past_.size());
    if (count == 0) {
      stream_.solve(w, p_);
      this->subtract_turning(w, momentum_.norm(), p_);
      a_ = eps_ * p_;
    }
    double binomial = 1;
    for (int k = 0; k < count; ++k) {
      binomial *= static_cast<double>(count - k) / (k + 1);
      double const weight = k % 2 == 0 ? binomial : -binomial;
      auto const& past = past_[static_cast<std::size_t>(k)];
      factors_ += weight * past.factors;
      if (k == 0)
        a_.real = weight * past.displacement.real, a_.imaginary = weight * past.displacement.imaginary;
      else
        a_.real += weight * past.displacement.real, a_.imaginary += weight * past.displacement.imaginary;
    }
  }
  void remember(SkewHermitian<> const& displacement, SkewHermitian<> const& increment,
                Factors const& factors) {
    Past newest;
    // The memory of the oldest serves again.
    if (static_cast<int>(past_.size()) >= std::max(1, extrapolated_steps))
      newest = std::move(past_.back()), past_.pop_back();
    newest.displacement.real = displacement.real, newest.displacement.imaginary = displacement.imaginary;
    newest.increment.real = increment.real.template cast<float>();
    newest.increment.imaginary = increment.imaginary.template cast<float>();
    newest.factors = factors, newest.first_change = first_change_, newest.wait = wait_;
    newest.radius = radius_, newest.age = ++age_;
    past_.push_front(std::move(newest));
  }

  /// Whether the guess of A is likely to be the solution: it was in the step before.
  bool guess_is_enough() const {
    return static_cast<int>(past_.size()) == extrapolated_steps &&
           past_.front().first_change <= 0.5 * tolerance && wait_ == 0;
  }
  /// A flow that is smooth in time needs no round at all: the middle is extrapolated, too, and the double
  /// precision of the finish says whether both are good enough.
  bool find_by_guess(SkewHermitian<> const& w, double size, VorticityReport& report) {
    middle_ = w;
    double binomial = 1;
    auto const count = static_cast<int>(past_.size());
    for (int k = 0; k < count; ++k) {
      binomial *= static_cast<double>(count - k) / (k + 1);
      double const weight = k % 2 == 0 ? binomial : -binomial;
      auto const& past = past_[static_cast<std::size_t>(k)].increment;
      middle_.real += weight * past.real.template cast<double>();
      middle_.imaginary += weight * past.imaginary.template cast<double>();
    }
    if (!(residual_of_middle(w) <= largest_residual_ * size)) return false;
    if (of_energy()) average_ = w + commutator_;
    find_displacement(w);
    ++report.iterations;
    first_change_ = report.residual = distance_to_next();
    if (!(first_change_ <= tolerance)) return false;
    cayley_.factor(a_, radius_of_displacement());
    return true;
  }

  /// A and the middle, to the tolerance.
  /// @return false where the rounds do not contract
  bool find(SkewHermitian<> const& w, VorticityReport& report) {
    single_.real = w.real.template cast<float>(), single_.imaginary = w.imaginary.template cast<float>();
    double before = std::numeric_limits<double>::infinity();
    for (;;) {
      double const radius = radius_of_displacement();
      if (!(radius < 1)) return false;
      cayley_.factor(a_, radius);
      find_middle(w);
      find_displacement(w);
      ++report.iterations;
      double const change = report.residual = distance_to_next();
      if (std::isinf(before)) first_change_ = change;
      if (change <= tolerance) return true;
      if (!(change < 0.25 * before)) return change < lowest_;
      before = change;
      std::swap(a_, next_);
      // The new A is better by the factor of a round, and the middle and the transform of the old one are
      // good enough for the finish.
      if (change <= last_change_) return true;
    }
  }

  /// A bound of the eigenvalues of A; its ratio to |A| changes slowly.
  double radius_of_displacement() {
    double const size = norm(a_);
    if (radius_ == 0 || age_ >= steps_of_radius_)
      radius_ = size == 0 ? 1 : spectral_radius(a_) / size, age_ = 0;
    return std::max(1.05 * radius_ * size, 1e-6);
  }

  /// Wt of A, and the mean of both ends.
  void find_middle(SkewHermitian<> const& w) {
    for (SkewHermitian<>* m : {&middle_, &average_})
      if (m->size() != w.size()) *m = SkewHermitian<>(w.size());
    cayley_.conjugate(single_, twice_, square_);
    bool const average = of_energy();
    for (Eigen::Index c = 0; c < w.size(); ++c) {
      auto const below = [c, rows = w.size() - c](auto& m) { return m.col(c).tail(rows); };
      auto const put = [&](auto const& start, auto const& f, auto const& e, auto& middle, auto& mean) {
        below(middle) = below(start) + (below(f) + below(e)).template cast<double>();
        if (average) below(mean) = below(start) + (below(f) + 2.F * below(e)).template cast<double>();
      };
      put(w.real, twice_.real, square_.real, middle_.real, average_.real);
      put(w.imaginary, twice_.imaginary, square_.imaginary, middle_.imaginary, average_.imaginary);
    }
    mirror_lower(middle_);
    if (average) mirror_lower(average_);
  }

  /// The A that belongs to the middle.
  void find_displacement(SkewHermitian<> const& w) {
    stream_.solve(of_energy() ? average_ : middle_, p_);
    this->subtract_turning(middle_, momentum_.norm(), p_);
    next_.real = eps_ * p_.real, next_.imaginary = eps_ * p_.imaginary;
    if (corrected_.count() == 0) return;
    // X_0 = [A, Wt], and X_j = [iS_j, Wt].
    if (half_change_.size() != w.size()) half_change_ = SkewHermitian<>(w.size());
    half_change_.real = average_.real - w.real, half_change_.imaginary = average_.imaginary - w.imaginary;
    // The extrapolated factors are better than what single precision would find; what they lack is found at
    // the end.
    add_combination(corrected_, &half_change_, middle_, factors_, next_);
  }
  double distance_to_next() const {
    double apart = 0, size = 0;
    for (Eigen::Index c = 0; c < a_.size(); ++c) {
      auto const below = a_.size() - c;
      apart += (a_.real.col(c).tail(below) - next_.real.col(c).tail(below)).squaredNorm() +
               (a_.imaginary.col(c).tail(below) - next_.imaginary.col(c).tail(below)).squaredNorm();
      size += next_.real.col(c).tail(below).squaredNorm() + next_.imaginary.col(c).tail(below).squaredNorm();
    }
    return size == 0 ? std::sqrt(apart) : std::sqrt(apart / size);
  }

  /// |r|, with C and A Wt A in double precision.
  double residual_of_middle(SkewHermitian<> const& w) {
    products_.multiply(a_, middle_, commutator_);
    products_.multiply_again(a_, remainder_);
    residual_.real = (commutator_.real + remainder_.real - (middle_.real - w.real)).template cast<float>();
    residual_.imaginary = (commutator_.imaginary + remainder_.imaginary - (middle_.imaginary - w.imaginary))
                              .template cast<float>();
    return static_cast<double>(norm(residual_));
  }
  /// The residual of the middle that was found in single precision.
  /// @return false where r is too large for single precision
  bool settle(SkewHermitian<> const& w, double size) {
    // The polynomial of the transform is good on an interval of which the end was estimated.
    double found;
    for (int tries = 0; !((found = residual_of_middle(w)) <= largest_residual_ * size); ++tries) {
      if (tries == 4) return false;
      radius_ *= 1.2;
      cayley_.factor(a_, radius_of_displacement());
      find_middle(w);
    }
    if (found > smallest_residual_ * size) better_middle();
    return true;
  }
  /// The middle Wt + r in the place of Wt: C and r become C + [A, r] and [A, r] + A r A.
  ///
  /// What the transform is off by has made r, and makes the end wrong by its product with r: always to the
  /// same side, so that it would add up.
  void better_middle() {
    cayley_.evaluate(residual_, twice_, square_);
    residual_.real = twice_.real + square_.real, residual_.imaginary = twice_.imaginary + square_.imaginary;
    mirror_lower(residual_), mirror_lower(twice_);
    commutator_.real += twice_.real.template cast<double>();
    commutator_.imaginary += twice_.imaginary.template cast<double>();
  }
  /// W_1 = W_0 + 2C + (U r U^* - r).
  void finish(SkewHermitian<> const& w) {
    if (end_.size() != w.size()) end_ = SkewHermitian<>(w.size());
    cayley_.conjugate(residual_, twice_, square_);
    for (Eigen::Index c = 0; c < w.size(); ++c) {
      auto const below = [c, rows = w.size() - c](auto& m) { return m.col(c).tail(rows); };
      auto const put =
          [&](auto const& start, auto const& half_change, auto const& f, auto const& e, auto& end) {
        below(end) = below(start) +
                     (2 * below(half_change) + (2.F * (below(f) + 2.F * below(e))).template cast<double>());
      };
      put(w.real, commutator_.real, twice_.real, square_.real, end_.real);
      put(w.imaginary, commutator_.imaginary, twice_.imaginary, square_.imaginary, end_.imaginary);
    }
    mirror_lower(end_);
  }

  /// Takes energy and angular momentum back to what they were, along the orbit. The A that is found on the
  /// way is the one to be remembered: the middle of what double precision holds, without the noise of single
  /// precision.
  /// @return false where it would be a long way; the factors are then the better ones
  bool polish(SkewHermitian<> const& w) {
    Eigen::Index const first = of_energy() ? 1 : 0,
                       count = first + static_cast<Eigen::Index>(polished_.count());
    Eigen::VectorXd change(count);
    double scale = 0;
    average_.real = 0.5 * (w.real + end_.real), average_.imaginary = 0.5 * (w.imaginary + end_.imaginary);
    if (!of_energy()) {
      average_.real += remainder_.real, average_.imaginary += remainder_.imaginary;
      std::swap(average_, middle_);
    }
    stream_.solve(of_energy() ? average_ : middle_, p_);
    this->subtract_turning(middle_, momentum_.norm(), p_);
    next_.real = eps_ * p_.real, next_.imaginary = eps_ * p_.imaginary;
    if (of_energy()) {
      scale = std::abs(eps_) * norm(p_);
      change[0] = eps_ * (p_.real.cwiseProduct(end_.real - w.real).sum() +
                          p_.imaginary.cwiseProduct(end_.imaginary - w.imaginary).sum());
    }
    Eigen::Vector3d const momentum = spin_components(sphere_, end_) - momentum_;
    auto const axes = polished_axes();
    for (std::size_t j = 0; j < axes.size(); ++j)
      change[static_cast<Eigen::Index>(j) + first] = axes[j].dot(momentum);
    single_.real = end_.real.template cast<float>(),
    single_.imaginary = end_.imaginary.template cast<float>();
    if (of_energy()) {
      // What a move changes the energy by goes by P of the end.
      stream_.solve(end_, p_);
      this->subtract_turning(middle_, momentum_.norm(), p_);
      residual_.real = (eps_ * p_.real).template cast<float>(),
      residual_.imaginary = (eps_ * p_.imaginary).template cast<float>();
      cayley_.commutator(residual_, single_, direction_);
    }
    Eigen::VectorXd const move =
        newton(polished_, of_energy() ? &direction_ : nullptr, single_, change, scale);
    residual_.real.setZero(), residual_.imaginary.setZero();
    add_combination(polished_, of_energy() ? &direction_ : nullptr, single_, move, residual_);
    // The third power of the move is left out.
    if (!(static_cast<double>(norm(residual_)) <= longest_move_ * norm(next_))) {
      factors_.head(move.size()) += 0.5 * move;
      return false;
    }
    if (corrected_.count() != 0) {
      half_change_.real = average_.real - w.real, half_change_.imaginary = average_.imaginary - w.imaginary;
      factors_.head(move.size()) += 0.5 * move;
      add_combination(corrected_, &half_change_, middle_, factors_, next_);
    }
    move_end();
    return true;
  }
  /// \f$W_1 + [Y, W_1] + \tfrac12[Y, [Y, W_1]]\f$ with the Y in `residual_` and W_1 also in `single_`.
  /// Without the last term the squares of W would grow by that of each move, which never takes them back.
  void move_end() {
    cayley_.commutator(residual_, single_, direction_);
    mirror_lower(direction_);
    if (static_cast<double>(norm(direction_)) > shortest_move_ * static_cast<double>(norm(single_))) {
      cayley_.commutator(residual_, direction_, twice_);
      mirror_lower(twice_);
      direction_.real += 0.5F * twice_.real, direction_.imaginary += 0.5F * twice_.imaginary;
    }
    end_.real += direction_.real.template cast<double>();
    end_.imaginary += direction_.imaginary.template cast<double>();
  }

  /// The Newton step of factors of X_0, where there is one, and X_j = [iS_j, W]: the inner products of the X,
  /// in units of what they are commutators of, inverted as far as they are regular. Entries below the
  /// diagonal count for two.
  Eigen::VectorXd newton(SpinColumns<float> const& spins, SkewHermitian<float> const* x0,
                         SkewHermitian<float> const& w, Eigen::VectorXd change, double scale_of_first) const {
    auto const count = change.size(), first = count - static_cast<Eigen::Index>(spins.count());
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(count, count);
    auto const sum = [](auto const& a, auto const& b) {
      return 2 * static_cast<double>(a.dot(b)) - static_cast<double>(a[0]) * static_cast<double>(b[0]);
    };
    if (spins.count() == 0)
      for (Eigen::Index c = 0; c < w.size(); ++c) {
        auto const r = x0->real.col(c).tail(w.size() - c), i = x0->imaginary.col(c).tail(w.size() - c);
        gram(0, 0) += sum(r, r) + sum(i, i);
      }
    else
      spins.over(w, [&](Eigen::Index c, auto const& pieces) {
        auto const rows = w.size() - c;
        if (x0) {
          auto const r = x0->real.col(c).tail(rows), i = x0->imaginary.col(c).tail(rows);
          gram(0, 0) += sum(r, r) + sum(i, i);
          for (std::size_t a = 0; a < pieces.size(); ++a)
            gram(first + static_cast<Eigen::Index>(a), 0) +=
                sum(r, pieces[a].real.matrix()) + sum(i, pieces[a].imaginary.matrix());
        }
        for (std::size_t a = 0; a < pieces.size(); ++a)
          for (std::size_t b = 0; b <= a; ++b)
            gram(first + static_cast<Eigen::Index>(a), first + static_cast<Eigen::Index>(b)) +=
                sum(pieces[a].real.matrix(), pieces[b].real.matrix()) +
                sum(pieces[a].imaginary.matrix(), pieces[b].imaginary.matrix());
      });
    Eigen::VectorXd scale = Eigen::VectorXd::Constant(count, std::sqrt(sphere_.n / 3.0) / sphere_.hbar());
    if (x0) scale[0] = scale_of_first;
    gram = scale.cwiseInverse().asDiagonal() * gram * scale.cwiseInverse().asDiagonal();
    return regular_solution(gram, change.cwiseQuotient(scale), cutoff_).cwiseQuotient(scale);
  }
  template <class Real>
  static void add_combination(SpinColumns<Real> const& spins, SkewHermitian<Real> const* x0,
                              SkewHermitian<Real> const& w, Eigen::VectorXd const& factors,
                              SkewHermitian<Real>& out) {
    Eigen::Index const first = x0 ? 1 : 0;
    if (spins.count() != 0)
      spins.over(w, [&](Eigen::Index c, auto const& pieces) {
        for (std::size_t a = 0; a < pieces.size(); ++a) {
          Real const f = static_cast<Real>(factors[first + static_cast<Eigen::Index>(a)]);
          out.real.col(c).tail(w.size() - c) += f * pieces[a].real.matrix();
          out.imaginary.col(c).tail(w.size() - c) += f * pieces[a].imaginary.matrix();
        }
      });
    if (x0)
      for (Eigen::Index c = 0; c < w.size(); ++c) {
        auto const rows = w.size() - c;
        Real const f = static_cast<Real>(factors[0]);
        out.real.col(c).tail(rows) += f * x0->real.col(c).tail(rows);
        out.imaginary.col(c).tail(rows) += f * x0->imaginary.col(c).tail(rows);
      }
    mirror_lower(out);
  }

  Eigen::Vector3d momentum_ = Eigen::Vector3d::Zero();  ///< spin components of W_0
  Products products_of_plain_;
  SkewProducts<double> products_;
  SingleCayley cayley_;
  SpinColumns<double> corrected_;
  SpinColumns<float> polished_;

  SkewHermitian<> a_, next_, p_, middle_, average_, half_change_, commutator_, remainder_, end_;
  SkewHermitian<float> single_, residual_, direction_, twice_, square_;
  Factors factors_ = Factors::Zero();
  double first_change_ = 1;  ///< of A in this step, by the first of its rounds
  int wait_ = 0;             ///< steps for which the guess is not tried as the solution
  double radius_ = 0;        ///< the largest eigenvalue of A over |A|
  int age_ = 0;              ///< steps since it was estimated
  std::deque<Past> past_;    ///< the newest first
};

template <class Stream>
VorticityReport FastVorticityStep<Stream>::advance(SkewHermitian<>& w) {
  double const size = norm(w);
  if (size == 0) return {};
  if (!(size >= smallest_size_ && size <= largest_size_)) return plain_step(w);
  momentum_ = spin_components(sphere_, w);
  VorticityReport report;
  guess(w);
  wait_ = past_.empty() ? 0 : std::max(0, past_.front().wait - 1);
  // Without a history the factors are not known: what the polish finds then is where the next attempt begins.
  bool made = false, found = true;
  for (int tries = 0; found && !made && tries < (corrected_.count() == 0 ? 1 : 4); ++tries) {
    bool const tried = tries == 0 && guess_is_enough();
    found = tried && find_by_guess(w, size, report);
    if (tried && !found) wait_ = steps_to_wait_;
    if (!found) found = find(w, report) && settle(w, size);
    if (found) finish(w), made = polish(w);
  }
  if (!made) return plain_step(w);
  // Wt = (W_0 + W_1)/2 + A Wt A: what the middle was off by counts in this by the square of A.
  average_.real = 0.5 * (end_.real - w.real) + remainder_.real;
  average_.imaginary = 0.5 * (end_.imaginary - w.imaginary) + remainder_.imaginary;
  remember(next_, average_, factors_);
  w.real.swap(end_.real), w.imaginary.swap(end_.imaginary);
  return report;
}

#ifdef ACTIO_COMPILED_STEPS
extern template class FastVorticityStep<SphereLaplacian>;
#endif

}  // namespace actio
