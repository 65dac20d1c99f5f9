// Symplectic diagonally implicit Runge-Kutta methods: steps of the fluid on the sphere, one after another.
//
// A method with the weights b_i and the triangular tableau a_ij is symplectic if
// b_i a_ij + b_j a_ji = b_i b_j. On the diagonal the condition says a_ii = b_i/2, below it a_ij = b_j: the
// weights are all there is. Stage i is then the middle of a midpoint step of length b_i h from where the step
// before it has ended. For dg/dt = (P/hbar) g with W = g W_0 g^* the midpoint step is the Lie-Poisson step of
// vorticity_step.hpp,
//
//   (1 - A) g~ = g_0,   g_1 = (1 + A) g~,   Wt = g~ W_0 g~^*,   A = h/(2 hbar) P(Wt),
//
// so that such a method is a composition of it, and nothing has to be written for it but the weights:
// `triple_jump` and `suzuki` of reduction/composition.hpp, and the family `five_stages`. The other forms of
// the step are self-adjoint, too, and are composed in the same way.
#pragma once

#include <Eigen/Core>

#include "actio/reduction/composition.hpp"
#include "actio/vorticity/vorticity_step.hpp"

namespace actio::sphere {

/// The tableau \f$a_{ij}\f$ of the symplectic diagonally implicit method with the weights \f$b_i\f$:
/// \f$a_{ii} = b_i/2\f$, \f$a_{ij} = b_j\f$ for j < i.
Eigen::MatrixXd diagonal_tableau(std::vector<double> const& weights);

/// The palindromes of order 4 in five stages, \f$\gamma_1, \gamma_2, \gamma_3, \gamma_2, \gamma_1\f$: one for
/// each first weight. With \f$s = 1 - 2\gamma_1\f$ the second solves \f$6\,\gamma_2(\gamma_2 - s)^2 = s^3 +
/// 2\gamma_1^3\f$, which has one root above s and zero.
/// @param first  \f$\gamma_1 < 1/(2-\sqrt[3]2)\f$, at which the triple jump is reached
/// @throws OutsideDomain, NotFinite  for another
std::vector<double> five_stages(double first);
/// Order 4 in five stages (McLachlan): \f$\gamma_1 = 0.28\f$.
inline std::vector<double> mclachlan() { return five_stages(0.28); }

/// The two constants of the error of a composition of order 4.
///
/// The substeps are \f$\exp(hA_1 + h^3A_3 + h^5A_5 + \dots)\f$, and
/// \f[ \exp(\gamma_1hA_1+\dots)\cdots\exp(\gamma_shA_1+\dots)
///   = \exp\bigl(hA_1 + h^5(e_5A_5 + e_{113}[A_1,[A_1,A_3]]) + \dots\bigr) , \qquad
///   e_5 = \sum_k\gamma_k^5 , \quad e_{113} = \tfrac12\sum_k\gamma_k^3m_k^2 + \tfrac1{24}e_5 , \f]
/// with the middles \f$m_k\f$ of \ref composition_conditions. For the same work the steps are as many times
/// longer as there are stages, so compare the constants times the fourth power of that number.
struct CompositionError {
  double fifth;   ///< \f$e_5\f$, of \f$A_5\f$
  double nested;  ///< \f$e_{113}\f$, of \f$[A_1,[A_1,A_3]]\f$
};
/// Those of a palindrome of order 4.
inline CompositionError composition_error(std::vector<double> const& weights) {
  auto const conditions = composition_conditions(weights);
  return {conditions[2], conditions[3] / 2 + conditions[2] / 24};
}

/// Steps of lengths \f$b_1h, \dots, b_sh\f$ as one step of length h.
/// @tparam Step  of one form, as `VorticityStep` is
template <class Step = VorticityStep<>>
class ComposedVorticityStep {
 public:
  /// @param stream     of the Hamiltonian; referred to
  /// @param step       h, time; negative steps go back
  /// @param fractions  the weights \f$b_i\f$; they add up to 1, and none of them is zero
  /// @param products   how real matrices are multiplied
  /// @throws OutsideDomain, NotFinite  where the fractions are not such
  template <class Stream>
  ComposedVorticityStep(Stream const& stream, Conserved conserved, double step, std::vector<double> fractions,
                        TurningFrame frame = {}, Products products = eigen_products())
      : step_(step) {
    if (fractions.empty()) throw OutsideDomain("composition", "there must be steps; their number is", 0, 1);
    // Each remembers the steps of its own place, from which it guesses: these are evenly spaced.
    for (double const b : actio::detail::fractions_of_a_step(std::move(fractions))) {
      steps_.emplace_back(stream, conserved, b * step, frame, products);
      longest_ = std::max(longest_, std::abs(b));
    }
  }

  double step() const { return step_; }  ///< h, time

  /// \f$W_0 \to W_1\f$, in the frame. The report has the iterations of all steps and the largest residual.
  /// @throws NotContracting  for the whole step; W is then as it was
  VorticityReport advance(SkewHermitian<>& w) {
    SkewHermitian<> const before = w;
    VorticityReport all;
    try {
      for (Step& step : steps_) {
        VorticityReport const one = step.advance(w);
        all.iterations += one.iterations, all.residual = std::max(all.residual, one.residual);
      }
    } catch (NotContracting const& error) {
      w = before;
      forget();
      throw NotContracting(step_, std::copysign(error.largest / longest_, step_));
    }
    return all;
  }
  /// Forgets the steps that were made: the next one begins as if it were the first.
  void forget() {
    for (Step& step : steps_) step.forget();
  }

 private:
  double step_, longest_ = 0;
  std::vector<Step> steps_;
};

}  // namespace actio::sphere
