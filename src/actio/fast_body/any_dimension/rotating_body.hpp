// The state of a free body on SO(n) between two steps: momentum, attitude, and the data of earlier steps for
// the initial guess of the next.
#pragma once

#include <Eigen/Core>

#include <array>
#include <span>

#include "actio/fast_body/any_dimension/relative_motion_sweeps.hpp"
#include "actio/rigid_body/inertia.hpp"

namespace actio::bodies {

class FastMoserVeselov;
namespace detail {
struct FixedPointStep;
}

/// A free body in n dimensions on its way. Made by `FastMoserVeselov::release`, moved by its steps; copies
/// are independent.
///
/// Momentum and attitude are each a rounded matrix and the accumulated rounding errors (compensated
/// summation), so that a million small steps add up as one sum.
class RotatingBody {
 public:
  using Group = SO<Eigen::Dynamic>;  ///< n at run time

  /// The body momentum; energy x time.
  Momentum<Group, double> momentum() const { return skew(momentum_); }
  /// What is to be added to it to have it to twice the digits.
  Momentum<Group, double> momentum_remainder() const { return skew(momentum_rest_); }
  /// The attitude, body to space. It stays where it is under steps of the momentum alone.
  Element<Group, double> attitude() const;
  /// The momentum in space, \f$gMg^T\f$ in coordinates: constant along the motion, unless steps were taken
  /// without the attitude.
  Momentum<Group, double> spatial_momentum() const {
    auto const g = attitude();
    return {g.group,
            g.group.vee((g.value * g.group.hat(momentum().components) * g.value.transpose()).eval())};
  }
  int size() const { return shape_.n; }
  /// How many steps it has made under this scheme.
  long steps() const { return steps_; }
  /// How many squares the last step took.
  int squares() const { return sweeps_; }
  /// \f$|ff^T-1|\f$ in the norm of Frobenius, the last that was seen: the relative motion used is nearer by
  /// one sweep.
  double defect() const { return std::sqrt(defect_); }
  /// How many steps the guess at the next one is made of.
  int remembered() const { return continuation_ ? continuation_->length : 0; }

  /// Saves, or restores, all that the bits of the next step depend on, besides the scheme:
  /// `memory(numbers...)` takes each of them by reference.
  ///
  /// It is restored into a body of the same size, and continues under the next scheme that steps it, which
  /// must be the one it was saved under or its equal.
  /// @throws OutsideDomain  where what is restored is no body of this size
  template <class Memory>
  void remember(Memory& memory) {
    int size = shape_.n,
        continuation =
            continuation_ ? static_cast<int>(continuation_ - detail::all_extrapolations().data()) : -1;
    unsigned long scheme = scheme_;
    memory(size, continuation, scheme, latest_, past_, sweeps_, expected_, steps_, chosen_, defect_,
           contraction_, solved_);
    bool const fits = size == shape_.n && -1 <= continuation &&
                      continuation < static_cast<int>(detail::all_extrapolations().size()) && 0 <= latest_ &&
                      latest_ < longest && 0 <= past_ && past_ <= longest;
    if (!fits)
      throw OutsideDomain("rotating body", "a body of this size is to be restored; dimensions", size,
                          shape_.n);
    continuation_ =
        continuation < 0 ? nullptr : &detail::all_extrapolations()[static_cast<std::size_t>(continuation)];
    // The number of a scheme means nothing in another process.
    if (scheme != scheme_) scheme_ = scheme ? next_scheme : 0;
    for (int const k : {motion_, attitude_, attitude_rest_}) remember_array(memory, full(k), full_size_);
    for (int const k : {static_cast<int>(momentum_), static_cast<int>(momentum_rest_), guess_})
      remember_array(memory, half(k), half_size_);
    for (int k = 0; k < past_; ++k)
      remember_array(memory, half(ring_[static_cast<std::size_t>((latest_ + k) % longest)]), half_size_);
  }

 private:
  friend struct detail::FixedPointStep;
  friend class FastMoserVeselov;

  // e, g and what rounding left of it, room to work in
  enum : int { motion_, attitude_, attitude_rest_, room_, full_arrays };
  static constexpr int longest = detail::Weights::longest + 1;  // squares of the past
  enum : int { momentum_, momentum_rest_, first_square_, half_arrays = first_square_ + longest + 2 };

  explicit RotatingBody(int n);
  template <class Memory>
  static void remember_array(Memory& memory, double* array, std::size_t size) {
    std::span<double> values(array, size);
    memory(values);
  }
  double* full(int k) { return full_.data() + full_size_ * static_cast<std::size_t>(k); }
  double const* full(int k) const { return full_.data() + full_size_ * static_cast<std::size_t>(k); }
  double* half(int k) { return halves_.data() + half_size_ * static_cast<std::size_t>(k); }
  double const* half(int k) const { return halves_.data() + half_size_ * static_cast<std::size_t>(k); }

  /// The square of the last step but k.
  double const* past(int k) const {
    int const at = latest_ + k;
    return half(ring_[static_cast<std::size_t>(at < longest ? at : at - longest)]);
  }
  Momentum<Group, double> skew(int array) const;
  void set_momentum(Eigen::MatrixXd const& m) {
    for (int j = 0; j < size(); ++j)
      for (int i = j / 4 * 4; i < size(); ++i) half(momentum_)[detail::half_entry(shape_, i, j)] = m(i, j);
  }
  void set_attitude(Eigen::MatrixXd const& g) {
    for (int j = 0; j < size(); ++j)
      for (int i = 0; i < size(); ++i) full(attitude_)[detail::full_entry(shape_, i, j)] = g(i, j);
  }

  detail::Blocked<0> shape_;
  std::size_t full_size_, half_size_;
  detail::Zeros full_, halves_;
  // Which array holds which square: the one being formed, the guess at it, and those of the past in a ring
  // that continues from the latest to the oldest.
  int formed_ = first_square_, guess_ = first_square_ + 1, latest_ = 0;
  std::array<int, longest> ring_{};
  detail::Weights const* continuation_ = nullptr;
  int past_ = 0, sweeps_ = 0, expected_ = 0;  // squares of the last step, and how many it was to take
  long steps_ = 0, chosen_ = 0;               // and when the continuation was chosen
  // squares of the last defect, and of the factor by which sweeps make it smaller
  double defect_ = 0, contraction_ = 1;
  bool solved_ = false;  // whether the last sweeps came to an end
  // Whose steps are remembered: none's, those of the scheme that steps next, or one's by its number.
  static constexpr unsigned long next_scheme = ~0ul;
  unsigned long scheme_ = 0;
};

}  // namespace actio::bodies
