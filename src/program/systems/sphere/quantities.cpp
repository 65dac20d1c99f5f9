#include "program/systems/sphere/quantities.hpp"

namespace actio::scene {
namespace {

using Kind = Quantity::Kind;

std::vector<Quantity> quadratic_invariants() {
  return {
      {"energy", Kind::scalar,
       "The energy of the flow relative to the sphere, of unit radius and unit density: the kinetic one, "
       "and in a layer with it the potential one of its surface; in averaged flow that of its metric.",
       "H = -\\tfrac12\\int\\psi\\,\\zeta = -\\tfrac12\\tfrac{4\\pi}N\\langle P, W\\rangle", "1/time^2"},
      {"enstrophy", Kind::scalar,
       "Half of the integral of the square of the vorticity relative to the sphere; half of casimirs_2, "
       "that of the absolute vorticity, where the sphere does not turn.",
       "Z = \\tfrac12\\int\\zeta^2", "1/time^2"},
      {"angular_momentum", Kind::vector,
       "The angular momentum of the absolute motion, the rotation of the sphere included, along axes that "
       "do not turn with the sphere: those of the sphere at t = 0, the third the pole. So it is constant; "
       "along axes of the sphere x and y would go round with the angular velocity -rotation, in a layer "
       "with -2 rotation/(2 + gamma), in averaged flow with the rough metric with -rotation/(1 + 2 "
       "alpha^2). The flow relative to the sphere has z less by 8 pi rotation/3.",
       "L_j = \\int x_j\\,(\\zeta + 2\\Omega\\cos\\theta) = \\tfrac{4\\pi}N\\hbar\\,\\mathrm{Tr}(S_j(-iW))",
       "1/time"},
  };
}

std::vector<Quantity> values_of_vorticity() {
  return {
      {"casimirs", Kind::list,
       "The integrals of the powers 2 to 8 of the absolute vorticity, as traces of the powers of the "
       "matrix: they name the coadjoint orbit. A row takes less than a step.",
       "C_k = \\int(\\zeta + 2\\Omega\\cos\\theta)^k = "
       "\\tfrac{4\\pi}N\\mathrm{Tr}((-iW)^k),\\quad k = 2,\\dots,8",
       "1/time^k", "eq_3_17"},
      {"eigenvalues", Kind::list,
       "All values of the absolute vorticity in ascending order, each on 1/N of the sphere: the "
       "eigenvalues of the matrix. They are constant; for their drift ask for extrema and "
       "casimirs. A row takes less than a step.",
       "\\sigma(-iW)", "1/time", "eq_3_17"},
      Quantity{
          "extrema", Kind::list,
          "The least and the greatest absolute vorticity: of the eigenvalues of the matrix, each of which is "
          "the value on 1/N of the sphere.",
          "\\min,\\,\\max\\ \\sigma(-iW)", "1/time", "eq_3_17"}
          .from({"eigenvalues"}),
      Quantity{
          "histogram", Kind::list,
          "How much of the sphere has which absolute vorticity: the share of it with values in each of 32 "
          "bins of equal width between the extrema at t = 0; their sum is 1. It is constant, as the "
          "eigenvalues are, from which it comes.",
          "p_k = \\tfrac1N\\,\\#\\{\\lambda\\in\\sigma(-iW):\\ \\lambda\\text{ in the bin }k\\}", "1",
          "eq_3_17"}
          .from({"eigenvalues"}),
  };
}

std::vector<Quantity> parts_by_degree() {
  return {
      {"spectrum", Kind::list,
       "The energy of the flow relative to the sphere in each degree l = 1, ..., N - 1; their sum is the "
       "energy. The divisor is l (l + 1), for a layer l (l + 1) + gamma, and for averaged flow l (l + 1) "
       "times 1 + alpha^2 (l (l + 1) - 2), with the rough metric times 1 + alpha^2 l (l + 1).",
       "H_l = \\tfrac12\\sum_m\\frac{|\\zeta_{lm}|^2}{d_l}", "1/time^2"},
      {"velocity_spectrum", Kind::list,
       "Half of the integral of the square of the velocity relative to the sphere, of its part in each "
       "degree l = 1, ..., N - 1. For Euler's fluid it is the spectrum; with d_l as there:",
       "K_l = \\tfrac12\\sum_ml(l+1)\\frac{|\\zeta_{lm}|^2}{d_l^2}", "1/time^2"},
      {"enstrophy_spectrum", Kind::list,
       "The enstrophy of the flow relative to the sphere in each degree l = 1, ..., N - "
       "1; their sum is the enstrophy.",
       "Z_l = \\tfrac12\\sum_m|\\zeta_{lm}|^2", "1/time^2"},
  };
}

std::vector<Quantity> parts_by_splitting() {
  return {
      {"splitting", Kind::list,
       "Energy and enstrophy of the two parts of the canonical splitting (Modin and Viviani, 2022) of the "
       "vorticity relative to the sphere: the steady part, which commutes with the matrix of the stream "
       "function, being a function of it along the streamlines, and the rest. The enstrophies add up to "
       "that of the flow; the energy of the flow is that of the steady part less that of the rest. A row "
       "takes the eigenvectors of a matrix, about as long as two steps.",
       "W = W_s + W_r,\\quad [W_s, P] = 0,\\quad \\langle W_r, X\\rangle = 0\\text{ where }[X, P] = 0",
       "1/time^2"},
  };
}

}  // namespace

std::vector<Quantity> vorticity_quantities() {
  std::vector<Quantity> all;
  for (auto&& part : {quadratic_invariants(), values_of_vorticity(), parts_by_degree(), parts_by_splitting()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace actio::scene
