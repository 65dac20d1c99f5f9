// Constraints on the velocity of a reduced system, c(v, a, t) = A(a, t) v - b(a, t) = 0, given as formulas.
//
// A blade that does not slip, a ball that rolls: the rows of A are covectors, and by the principle of
// Lagrange and d'Alembert the reaction is a combination of them,
//
//     p' = +- (ad*_v p - J) + A^T lambda,      A v = b.
//
// This is no principle of a stationary action (the thesis, chapters 7 and 10, calls that one vakonomic and
// says that it is wrong for rolling).
#pragma once

#include <vector>

#include "actio/any_group/reduced_system.hpp"

namespace actio::systems {

/// Constraints linear in the velocity, as formulas of the velocity, the carried vectors and the time.
struct VelocityConstraints {
  int dimension;  ///< of the group
  int carried;    ///< numbers in all vectors
  int count;      ///< how many constraints there are
  Tape values;    ///< \f$c(v, a, t)\f$, one output for each; velocity, vectors, time
  Tape rows;      ///< \f$A(a, t)\f$, row by row, of the same inputs

  /// @param system  whose velocity they constrain
  /// @param each    one tape for each constraint, whose only output vanishes; its inputs are the velocity,
  ///                the vectors one after the other, and the time
  /// @throws OutsideDomain  where there is none; where there are as many as dimensions of the group or more,
  ///                        so that no motion is left; where a tape has another number of inputs; where one
  ///                        is not linear in the velocity as it is written; where one has no velocity in it
  VelocityConstraints(ReducedSystem const& system, std::vector<Tape> const& each);
};

/// The values and the rows at one scalar, with the work space of the tapes.
template <class S>
class ConstraintValues {
 public:
  /// Of constraints that outlive it.
  explicit ConstraintValues(VelocityConstraints const& of)
      : values(static_cast<std::size_t>(of.count)),
        rows(static_cast<std::size_t>(of.count * of.dimension)),
        of_(&of),
        inputs_(static_cast<std::size_t>(of.dimension + of.carried + 1)) {}

  std::vector<S> values,  ///< \f$c(v, a, t)\f$
      rows;               ///< \f$A(a, t)\f$, row by row

  /// Sets the values.
  void set_values(std::vector<S> const& v, std::vector<S> const& a, S const& t) {
    std::copy(v.begin(), v.end(), inputs_.begin());
    set_place(a, t);
    of_->values(inputs_.data(), values.data(), work_);
  }
  /// Sets the rows.
  void set_rows(std::vector<S> const& a, S const& t) {
    std::fill_n(inputs_.begin(), of_->dimension, S(0));
    set_place(a, t);
    of_->rows(inputs_.data(), rows.data(), work_);
  }

 private:
  void set_place(std::vector<S> const& a, S const& t) {
    std::copy(a.begin(), a.end(), inputs_.begin() + of_->dimension);
    inputs_.back() = t;
  }

  VelocityConstraints const* of_;
  std::vector<S> inputs_, work_;
};

}  // namespace actio::systems
