// The state of a free body on SO(n) between two steps of the natural-chart scheme: momentum, attitude, and
// the rotation vectors of the last steps.
#pragma once

#include <Eigen/Core>

#include <array>
#include <span>

#include "actio/fast_body/any_dimension/least_squares_extrapolation.hpp"
#include "actio/fast_body/any_dimension/matrix_algebra.hpp"
#include "actio/rigid_body/inertia.hpp"

namespace actio::bodies {

class FastNaturalChart;

/// A free body in n dimensions on its way. Made by `FastNaturalChart::release`, moved by its steps; copies
/// are independent.
///
/// Momentum and attitude are each a rounded matrix and the accumulated rounding errors (compensated
/// summation).
class ChartedBody {
 public:
  using Group = SO<Eigen::Dynamic>;  ///< n at run time

  /// The body momentum; energy x time.
  Momentum<Group, double> momentum() const {
    Group const group{size()};
    return {group, group.vee(whole(momentum_))};
  }
  /// The attitude, body to space. It stays where it is under steps of the momentum alone.
  Element<Group, double> attitude() const { return {Group{size()}, whole(attitude_)}; }
  int size() const { return shape_.n; }
  /// How many steps it has made.
  long steps() const { return steps_; }
  /// How many sweeps the last step took.
  int sweeps() const { return sweeps_; }

  /// Saves, or restores, all that the bits of the next step depend on, besides the scheme:
  /// `memory(numbers...)` takes each of them by reference.
  /// @throws OutsideDomain  where what is restored is no body of this size
  template <class Memory>
  void remember(Memory& memory) {
    int size = shape_.n, continuation = static_cast<int>(continuation_);
    memory(size, continuation, latest_, past_, sweeps_, steps_, contraction_, step_);
    bool const fits = size == shape_.n && 0 <= continuation &&
                      continuation < static_cast<int>(detail::all_extrapolations().size()) && 0 <= latest_ &&
                      latest_ < longest && 0 <= past_ && past_ <= longest;
    if (!fits)
      throw OutsideDomain("charted body", "a body of this size is to be restored; dimensions", size,
                          shape_.n);
    continuation_ = static_cast<std::size_t>(continuation);
    for (int k = 0; k < first_turn_; ++k) remember_array(memory, array(k));
    for (int k = 0; k < past_; ++k) remember_array(memory, past(k));
  }

 private:
  friend class FastNaturalChart;
  static constexpr int longest = detail::Weights::longest + 1;
  enum : int {
    momentum_,
    momentum_rest_,
    attitude_,
    attitude_rest_,
    first_turn_,
    arrays = first_turn_ + longest
  };

  explicit ChartedBody(int n)
      : shape_(n), array_size_(detail::full_size(shape_)), numbers_(array_size_ * arrays) {}
  double* array(int k) { return numbers_.data() + array_size_ * static_cast<std::size_t>(k); }
  double const* array(int k) const { return numbers_.data() + array_size_ * static_cast<std::size_t>(k); }
  /// The rotation vector Z of the last step but k.
  double* past(int k) { return array(first_turn_ + (latest_ + k) % longest); }

  Eigen::MatrixXd whole(int k) const;
  void set(int k, Eigen::MatrixXd const& m) {
    for (int j = 0; j < size(); ++j)
      for (int i = 0; i < size(); ++i) array(k)[detail::full_entry(shape_, i, j)] = m(i, j);
  }
  template <class Memory>
  void remember_array(Memory& memory, double* array) {
    std::span<double> values(array, array_size_);
    memory(values);
  }

  detail::Blocked<0> shape_;
  std::size_t array_size_;
  detail::Zeros numbers_;
  // where the last rotation vector is, how many there are, and what the last one took
  int latest_ = 0, past_ = 0, sweeps_ = 0;
  long steps_ = 0;
  double contraction_ = 1;        // of the sweeps of the last step
  double step_ = 0;               // of the steps with these rotation vectors
  std::size_t continuation_ = 0;  // the index of the one in use among all
};

}  // namespace actio::bodies
