// The derivatives of a tape as further tapes.
//
// Reverse mode: from the output backwards each entry is told how the output changes with it, and passes that
// on to its operands. What it passes on is recorded and simplified like the formula itself; so is the
// gradient's derivative, the Hessian. Of a quadratic form it consists of constants.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "actio/formula/tape_builder.hpp"
#include "actio/formula/term.hpp"

namespace actio {

/// Records a tape once more.
/// @param b       has as many inputs
/// @param record  how the builder takes an operation: its `record`, or its `as_written`
/// @return        the entries of the outputs
std::vector<TapeBuilder::Entry> replay(
    Tape const& tape, TapeBuilder& b,
    TapeBuilder::Entry (TapeBuilder::*record)(Operation, TapeBuilder::Entry,
                                              TapeBuilder::Entry) = &TapeBuilder::record);

/// The outputs of tapes of the same inputs one after the other; what occurs in more than one is computed
/// once. Each is evaluated as before, operation by operation.
Tape joined(std::vector<Tape> const& tapes);

namespace detail {
/// Differentiates entries of a builder with respect to some of its inputs.
class ReverseMode {
 public:
  using Entry = TapeBuilder::Entry;

  ReverseMode(TapeBuilder& b, std::vector<int> const& wrt);

  /// The derivatives of f with respect to the inputs from `first` in the list on.
  std::vector<Entry> gradient(Entry f, std::size_t first = 0);

 private:
  void note_dependence(Entry last) {
    for (auto e = static_cast<Entry>(depends_.size()); e <= last; ++e)
      depends_.push_back(!b_.is_constant(e) && (depends_[b_.first(e)] || depends_[b_.second(e)]));
  }
  void receive(Entry e, Term const& part) {
    if (!depends_[e]) return;
    rate_[e] = rate_[e] ? b_.add(*rate_[e], part.entry()) : part.entry();
  }
  void lose(Entry e, Term const& part) {
    if (!depends_[e]) return;
    rate_[e] = rate_[e] ? b_.subtract(*rate_[e], part.entry()) : b_.negate(part.entry());
  }

  /// The rate r of an entry goes on to its operands x and y.
  void pass_on(Entry e, Term const& r);

  TapeBuilder& b_;
  std::vector<int> const& wrt_;
  std::vector<bool> depends_;
  std::vector<std::optional<Entry>> rate_;
};

/// The most entries that a formula with its derivatives takes.
inline constexpr std::size_t most_with_derivatives = 1000000;
}  // namespace detail

/// A function and its gradient: the outputs are \f$f, \partial f/\partial x_i, \dots\f$ for the inputs i in
/// `wrt`.
/// @param f    a tape, whose first output is differentiated
/// @param wrt  inputs, numbered from 0
/// @throws OutsideDomain  where there is no such input
/// Accuracy: exact; a call takes at most a few times as many instructions as that of f.
Tape with_gradient(Tape const& f, std::vector<int> const& wrt);

/// A function with its gradient and Hessian: \f$f, \partial_i f, \dots\f$ and the upper triangle of
/// \f$\partial_i\partial_j f\f$ row by row.
/// @param f    a tape, whose first output is differentiated
/// @param wrt  inputs, numbered from 0
/// @throws OutsideDomain  where there is no such input
Tape with_hessian(Tape const& f, std::vector<int> const& wrt);

}  // namespace actio
