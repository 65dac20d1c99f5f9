// What goes wrong, said in full: what was required, what was measured, the bound, and the statement that asks
// for it.
#pragma once

#include <cstdio>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "actio/numbers/scalar.hpp"

namespace actio {

/// Root of everything the library throws.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A number for a message: enough digits to see on which side of the bound it lies.
inline std::string show(double x) {
  char digits[32];
  return {digits, digits + std::snprintf(digits, sizeof digits, "%.9g", x)};
}

namespace detail {
/// Pieces of a message, one after the other.
inline std::string joined(std::initializer_list<std::string_view> pieces) {
  std::string text;
  for (auto const piece : pieces) text += piece;
  return text;
}
}  // namespace detail

/// An argument outside the set a function is defined on. Carries the measured quantity and the bound it
/// breaks.
struct OutsideDomain : Error {
  double measured;
  double bound;
  OutsideDomain(std::string_view where, std::string_view required, double was, double limit)
      : Error(detail::joined({where, ": ", required, ", measured ", show(was), ", bound ", show(limit)})),
        measured(was),
        bound(limit) {}
};

/// A NaN or an infinity where a number is needed.
struct NotFinite : Error {
  explicit NotFinite(std::string_view where)
      : Error(detail::joined({where, ": a NaN or an infinity where a finite number is needed"})) {}
};

/// Refuses a matrix or vector with a plain value that is a NaN or an infinity.
///
/// What a scalar is extended by is not looked at: it is no number only where a value is none, or where a
/// derivative does not exist, and that is seen when the derivative is taken.
template <MatrixLike Derived>
void require_finite(Derived const& m, char const* where) {
  using T = Base<typename Derived::Scalar>;
  if constexpr (std::is_floating_point_v<T>) {
    // The difference of a number and itself is zero, of anything else it is no number: one question for all
    // entries.
    T sum(0);
    for (Index j = 0; j < m.cols(); ++j)
      for (Index i = 0; i < m.rows(); ++i) {
        T const x = base_value(m(i, j));
        sum += x - x;
      }
    if (!(sum == T(0))) throw NotFinite(where);
  } else if constexpr (!is_exact<T>)
    for (Index j = 0; j < m.cols(); ++j)
      for (Index i = 0; i < m.rows(); ++i)
        if (!is_finite(base_value(m(i, j)))) throw NotFinite(where);
}

/// A root or a transcendental function of a number whose field does not hold it.
struct NotInThisField : OutsideDomain {
  using OutsideDomain::OutsideDomain;
};

/// A linear map that has no inverse, for instance the second derivative of a Lagrangian that is not regular.
struct Singular : OutsideDomain {
  using OutsideDomain::OutsideDomain;
};

/// Moments of inertia that no distribution of mass has.
struct UnphysicalInertia : OutsideDomain {
  using OutsideDomain::OutsideDomain;
};

/// A step longer than the scheme has a solution for; says the longest that would do.
struct StepTooLong : OutsideDomain {
  double largest_step;
  StepTooLong(std::string_view where, double step, double largest)
      : OutsideDomain(where, detail::joined({wanted, show(largest)}), step, largest), largest_step(largest) {}

 private:
  static constexpr std::string_view wanted =
      "the step exceeds the solvability limit of the scheme; the largest step that would do is ";
};

/// An iteration that did not reach the rounding level of its residual.
struct NotConverged : Error {
  std::vector<double> residuals;  ///< norm of the residual at each iterate
  double tolerance;               ///< what it had to come under
  NotConverged(std::string_view where, std::vector<double> history, double bound)
      : Error(message(where, history, bound)), residuals(std::move(history)), tolerance(bound) {}

 private:
  static std::string message(std::string_view where, std::vector<double> const& residuals, double bound) {
    auto const last = residuals.empty() ? std::string("none") : show(residuals.back());
    return detail::joined({where, ": no convergence in ", std::to_string(residuals.size()),
                           " iterations, residual ", last, ", tolerance ", show(bound),
                           "; the step may be too long for the Lagrangian to be regular"});
  }
};

}  // namespace actio
