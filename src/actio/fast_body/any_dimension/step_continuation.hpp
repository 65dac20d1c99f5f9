// Long steps of the natural-chart scheme on SO(n), by numerical continuation: the solution is followed from
// rest, along a growing step.
//
// The equation J Z = Q(Z) depends on the step through P = h M0 alone, so a step that grows is a P that grows.
// Where n is small each piece of the way is solved by Newton, with differences for the derivative, whose
// determinant must stay positive; it ends where the derivative has no inverse, or an angle reaches half a
// turn. Where n is large sweeps must contract: so they do on this branch alone.
#pragma once

#include <Eigen/Core>

#include <gsl/gsl_linalg.h>

#include <vector>

#include "actio/fast_body/any_dimension/natural_chart_equation.hpp"
#include "actio/linear_algebra/eigenvalues.hpp"

namespace actio::bodies::detail {

/// The continuation of one solution in the length of the step.
class StepContinuation {
 public:
  /// @param p  h M0 of the whole step
  StepContinuation(NaturalChartEquation& equation, double const* p);

  /// Follows the solution as far as it goes.
  /// @return the part of the step that it reaches, 1 where it reaches all; z is the solution there
  double follow(double* z);

 private:
  static constexpr double smallest_gap = 1e-8;
  // next to the end of the branch half of the digits are lost
  static constexpr double rounding_at_end = 1e-8;

  int size() const { return algebra_.shape().n; }
  int unknowns() const { return size() * (size() - 1) / 2; }
  /// Of the way: where angles are a tenth or so.
  double first_part() {
    equation_.guess(whole_.data(), z_.data());
    return std::min(1.0, 0.1 / algebra_.norm(z_.data()));
  }
  std::vector<double> first_guess(double part) {
    equation_.guess(whole_.data(), z_.data());
    algebra_.scale(part, z_.data());
    return taken(z_.data());
  }

  void put(std::vector<double> const& x, double* z) const;
  std::vector<double> taken(double const* z) const;
  static double norm(std::vector<double> const& x) {
    return Eigen::Map<Eigen::VectorXd const>(x.data(), static_cast<Eigen::Index>(x.size())).norm();
  }
  static double distance(std::vector<double> x, std::vector<double> const& y) {
    for (std::size_t a = 0; a < x.size(); ++a) x[a] -= y[a];
    return norm(x);
  }
  std::vector<double> change(std::vector<double> const& x) {
    put(x, z_.data());
    return taken(equation_.change(p_.data(), z_.data()));
  }

  /// Newton for a part of the step. The derivative is taken where it begins, and again where the moves no
  /// longer fall; where they fall no more from there, they are rounding.
  bool solve(double part, std::vector<double>& x);

  /// The derivative of the change, by differences, in triangular factors. Whether its determinant has the
  /// sign that it has at rest.
  bool differentiate(std::vector<double> const& x);
  std::vector<double> newton_move(std::vector<double> move);

  NaturalChartEquation& equation_;
  MatrixAlgebra algebra_;
  Zeros whole_, p_, z_;
  Eigen::MatrixXd derivative_;
  std::vector<std::size_t> order_;
};

}  // namespace actio::bodies::detail
