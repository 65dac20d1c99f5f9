// The velocity of a momentum, one equation after another, by few gradients of the Lagrangian.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "actio/reduction/column_sum.hpp"
#include "actio/variational/euler_poincare.hpp"

namespace actio::detail {

/// The velocity of a momentum, \f$\partial l/\partial\xi = \mu\f$, near one that is known.
///
/// The inverse of the second derivative is kept from one equation to the next. By its first correction the
/// velocity is a linear function of the momentum; where a second one has turned out to be rounding, as for
/// every quadratic Lagrangian, that function is taken until a check finds it to be wrong.
template <Group G, Real S>
class LegendreChord {
 public:
  /// Before a step.
  template <class F>
  void begin(F const& l, Velocity<G, S> const& xi) {
    if (inverse_.size() == 0 || !(contraction_ * Base<S>(20) < Base<S>(1))) differentiate(l, xi);
  }
  /// Whether the velocity has been found to be a linear function of the momentum.
  bool linear() const { return linear_; }
  /// That function, at a momentum.
  void by_line(Coordinates<G, S> const& mu, Velocity<G, S>& xi) const {
    correct(mu, momentum_, velocity_, xi.coordinates);
  }
  /// Solves, beginning at `xi`. Where velocities were taken for linear, that is checked: it is so if nothing
  /// is to be corrected.
  /// @throws NotConverged, Singular  where the solution is not near
  template <class F>
  void solve(F const& l, Coordinates<G, S> const& mu, Velocity<G, S>& xi) {
    Base<S> const tiny = epsilon<S>() * Base<S>(2);
    bool const checked = std::exchange(linear_, false);
    Base<S> corrections[fresh_derivatives * tries];
    int count = 0;
    for (int fresh = 0; fresh < fresh_derivatives; ++fresh, differentiate(l, xi)) {
      Base<S> before(-1);
      for (int k = 0; k < tries; ++k) {
        ++gradients_;
        look(l, xi, k > 0);
        correct(mu, momentum_, velocity_, xi.coordinates);
        Base<S> const now = magnitude(Coordinates<G, S>(xi.coordinates - velocity_)),
                      bound = tiny * magnitude(xi.coordinates);
        corrections[count++] = now;
        if (!is_finite(now)) break;
        if (before > Base<S>(0)) contraction_ = now / before;
        if (now <= bound || (before > Base<S>(0) && now * contraction_ <= bound)) {
          // Two solutions next to each other say nothing of a line.
          bool const far = before * Base<S>(1000) > magnitude(xi.coordinates);
          linear_ = now <= bound && (checked ? k == 0 : k == 1 && far);
          return;
        }
        if (before >= Base<S>(0) && now > before / Base<S>(4)) break;
        before = now;
      }
    }
    std::vector<double> history;
    for (int k = 0; k < count; ++k) history.push_back(to_double(corrections[k]));
    throw NotConverged("momentum level: the velocity of a momentum", std::move(history), to_double(tiny));
  }
  int take_gradients() { return std::exchange(gradients_, 0); }
  /// Saves, or restores, all that the next equation depends on.
  /// @param stream     called with spans of numbers and with numbers
  /// @param dimension  of the group
  template <class Stream>
  void remember(Stream& stream, Index dimension) {
    if (inverse_.size() == 0) {
      inverse_ = decltype(inverse_)::Zero(dimension, dimension);
      velocity_ = momentum_ = Coordinates<G, S>::Zero(dimension);
    }
    auto const numbers = [&stream](auto& matrix) {
      std::span<S> all(matrix.data(), static_cast<std::size_t>(matrix.size()));
      stream(all);
    };
    numbers(inverse_), numbers(velocity_), numbers(momentum_);
    stream(contraction_, linear_);
  }

 private:
  /// Takes the gradient at a velocity; Broyden's formula has the inverse map what the momentum has changed by
  /// since the last look to what the velocity has.
  template <class F>
  void look(F const& l, Velocity<G, S> const& xi, bool again) {
    Coordinates<G, S> const moved = again ? Coordinates<G, S>(xi.coordinates - velocity_) : xi.coordinates,
                            past = momentum_;
    velocity_ = xi.coordinates, momentum_ = gradient(l, xi).components;
    if (!again) return;
    Coordinates<G, S> mapped = moved, row = moved;
    S along(0);
    for (Index i = 0; i < moved.size(); ++i) {
      mapped[i] = row[i] = S(0);
      for (Index j = 0; j < moved.size(); ++j) {
        mapped[i] += inverse_(i, j) * (momentum_[j] - past[j]);
        row[i] += moved[j] * inverse_(j, i);
      }
      along += moved[i] * mapped[i];
    }
    // Rounding is nothing to learn from.
    Base<S> const missed = magnitude(Coordinates<G, S>(moved - mapped));
    if (!(missed > epsilon<S>() * Base<S>(64) * magnitude(velocity_)) || !(magnitude(along) > Base<S>(0)))
      return;
    for (Index i = 0; i < moved.size(); ++i)
      for (Index j = 0; j < moved.size(); ++j) inverse_(i, j) += (moved[i] - mapped[i]) * row[j] / along;
  }
  void correct(Coordinates<G, S> const& mu, Coordinates<G, S> const& there, Coordinates<G, S> const& from,
               Coordinates<G, S>& out) const {
    Coordinates<G, S> const changed = mu - there;
    multiply_and_add(from, inverse_, changed, out);
  }
  template <class F>
  void differentiate(F const& l, Velocity<G, S> const& xi) {
    auto const second = hessian(l, xi);
    inverse_ = solve_linear(second, std::decay_t<decltype(inverse_)>::Identity(second.rows(), second.cols()),
                            "momentum level: d2l/dxi2");
    contraction_ = Base<S>(1), linear_ = false;
  }
  static constexpr int fresh_derivatives = 3, tries = 12;
  Matrix<S, G::dim, G::dim> inverse_;
  Coordinates<G, S> velocity_, momentum_;
  Base<S> contraction_{1};
  bool linear_ = false;
  int gradients_ = 0;
};

}  // namespace actio::detail
