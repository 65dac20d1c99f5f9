#include "program/systems/media/energy_formula.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <numeric>

#include "actio/formula/tape_derivatives.hpp"
#include "program/systems/formula.hpp"

namespace actio::scene::materials {
namespace {

std::vector<std::string> inputs(int d) {
  std::vector<std::string> out{"I1", "J"};
  if (d == 3) out.insert(out.begin() + 1, "I2");
  for (int i = 1; i <= d; ++i)
    for (int j = i; j <= d; ++j) out.push_back(fmt::format("C{}{}", i, j));
  return out;
}

/// An orthonormal basis of symmetric matrices: the identity over its length, then those without a trace.
template <int d>
std::vector<Matrix<double, d, d>> symmetric_basis() {
  std::vector<Matrix<double, d, d>> out{Matrix<double, d, d>::Identity() * (1 / std::sqrt(d))};
  for (int k = 1; k < d; ++k) {
    auto& one = out.emplace_back(Matrix<double, d, d>::Zero());
    double const length = std::sqrt(k * (k + 1.0));
    for (int i = 0; i < k; ++i) one(i, i) = 1 / length;
    one(k, k) = -k / length;
  }
  for (int i = 0; i < d; ++i)
    for (int j = i + 1; j < d; ++j) {
      auto& one = out.emplace_back(Matrix<double, d, d>::Zero());
      one(i, j) = one(j, i) = std::sqrt(0.5);
    }
  return out;
}

/// A body as it is before anything moves, C = 1.
struct AtRest {
  double bulk = 0, shear = 0;  ///< moduli; the least of shear, which on a line there is not
  double least = 0;            ///< of the second derivatives by Green's strain
  double size = 0;             ///< of all of them
  double stress = 0;           ///< its largest component
  bool finite = true;          ///< all of them, and W
};

template <int d>
AtRest at_rest(EnergyFormula const& energy) {
  Matrix<double, d, d> const one = Matrix<double, d, d>::Identity();
  auto const basis = symmetric_basis<d>();
  auto const count = static_cast<Eigen::Index>(basis.size());
  Eigen::MatrixXd second(count, count);
  AtRest out;
  for (Eigen::Index b = 0; b < count; ++b) {
    Matrix<double, d, d> const change = basis[static_cast<std::size_t>(b)] * 2;
    auto const [S, rate] =
        derivative_along([&](auto const& C) { return energy.green_stress(C); }, one, change);
    for (int k = 0; k < d * d; ++k) out.stress = std::max(out.stress, std::abs(S.data()[k]));
    for (Eigen::Index a = 0; a < count; ++a) {
      double const* const e = basis[static_cast<std::size_t>(a)].data();
      second(a, b) = std::inner_product(e, e + d * d, rate.data(), 0.0);
    }
  }
  out.finite = second.allFinite() && std::isfinite(out.stress) && std::isfinite(energy(one));
  if (!out.finite) return out;
  auto const least = [](Eigen::MatrixXd const& of) {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(of, Eigen::EigenvaluesOnly).eigenvalues()[0];
  };
  out.bulk = second(0, 0) / d, out.least = least(second), out.size = second.cwiseAbs().maxCoeff();
  if (d > 1) out.shear = least(second.bottomRightCorner(count - 1, count - 1)) / 2;
  return out;
}
AtRest at_rest(EnergyFormula const& energy, int d) {
  return d == 1 ? at_rest<1>(energy) : d == 2 ? at_rest<2>(energy) : at_rest<3>(energy);
}

/// What is below it is rounding.
double rounding(AtRest const& body) { return 1e-10 * body.size; }

}  // namespace

/// \cond
std::vector<MaterialConstant> EnergyFormula::said() {
  return {
      {"energy", "w, a text; with it, the name may be left out", 0,
       "\"mu/2*(I1 - 2 - 2*log(J)) + kappa/2*(J - 1)^2\"", "energy/volume"},
      {"constants", "a table of the numbers that the formula has by names", 0, "{ mu = 1, kappa = 2 }", "1"}};
}
/// \endcond

EnergyFormula EnergyFormula::read(SceneTable const& table, int d) {
  table.allow({"name", "energy", "constants"});
  auto const names = inputs(d);
  auto const constants = formula_constants(table, "constants", names, "an invariant or a component of C");
  auto const energy =
      scene_formula(table.text("energy"), names, constants, table.text_place("energy"), "energy");
  require_used_constants(table, "constants", constants, energy.used, "energy");
  std::vector<int> all(names.size());
  std::iota(all.begin(), all.end(), 0);
  return {actio::with_gradient(energy.value, all)};
}

void EnergyFormula::require_stable(SceneTable const& table, int d) const {
  AtRest const body = at_rest(*this, d);
  if (!body.finite)
    table.fail("energy",
               "energy: at rest, where C is the identity and J = 1, its value or one of its first "
               "and second derivatives is no finite number");
  std::string const stressed =
      body.stress > rounding(body)
          ? fmt::format(
                "; its stress at rest is {:.6g} besides, where a multiple of log(J) or J takes it away",
                body.stress)
          : "";
  auto const require = [&](double modulus, std::string const& what) {
    if (!(modulus > rounding(body)))
      table.fail("energy", fmt::format("energy: {} at rest must be positive, or the solid is unstable; from "
                                       "the second derivatives by C at C = 1 it is {:.6g}{}",
                                       what, modulus, stressed));
  };
  if (d > 1) require(body.shear, "the least shear modulus");
  require(body.bulk, d > 1 ? "the bulk modulus" : "the modulus");
  require(body.least, "the least modulus");
}

std::vector<std::string> EnergyFormula::remarks(int d) const {
  AtRest const body = at_rest(*this, d);
  std::vector<std::string> out{
      d == 1 ? fmt::format("energy: the modulus of the material at rest is {:.6g}", body.bulk)
             : fmt::format("energy: at rest the bulk modulus of the material is {:.6g}, its least shear "
                           "modulus {:.6g}",
                           body.bulk, body.shear)};
  if (body.stress > rounding(body))
    out.push_back(
        fmt::format("energy: the material has a stress at rest, up to {:.6g}, so that a body that "
                    "nothing holds moves from C = 1",
                    body.stress));
  return out;
}

}  // namespace actio::scene::materials
