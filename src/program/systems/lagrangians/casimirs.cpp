#include <Eigen/Core>

#include "program/systems/lagrangians/casimirs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "actio/any_group/invariants.hpp"
#include "actio/any_group/semidirect_algebra.hpp"

namespace actio::scene {
namespace {

/// Of momentum and vectors, those that the motion leaves at zero: the last component of a direction on a
/// group of rigid motions.
std::vector<int> components_that_stay_zero(ReducedScene const& scene) {
  auto const& algebra = scene.system->algebra;
  std::vector<int> out;
  if (algebra.name != "SE(2)" && algebra.name != "SE(3)") return out;
  for (std::size_t k = 0; k < scene.carried.size(); ++k)
    if (scene.carried[k].constant[algebra.size - 1] == 0)
      out.push_back(algebra.dimension + static_cast<int>(k + 1) * algebra.size - 1);
  return out;
}
/// The structure of an algebra by an ideal that is spanned by one vector of the basis: on its dual that
/// component is zero.
systems::MatrixAlgebra without(systems::MatrixAlgebra algebra, int component) {
  std::erase_if(algebra.constants,
                [&](auto const& c) { return c.a == component || c.b == component || c.c == component; });
  for (auto& c : algebra.constants) c.a -= c.a > component, c.b -= c.b > component, c.c -= c.c > component;
  algebra.components.erase(algebra.components.begin() + component);
  --algebra.dimension;
  return algebra;
}

/// The Casimirs, on momentum and vectors.
std::vector<systems::Casimir> casimirs_of(ReducedScene const& scene) {
  auto const& algebra = scene.system->algebra;
  if (scene.carried.empty()) return casimirs(algebra);
  auto const names = names_of(scene.carried);
  auto whole = systems::semidirect_algebra(algebra, static_cast<int>(names.size()), algebra.size, names);
  auto const zero = components_that_stay_zero(scene);
  for (std::size_t k = zero.size(); k-- > 0;) whole = without(std::move(whole), zero[k]);
  return casimirs(whole);
}

}  // namespace

void define_casimirs(Simulation& simulation, Request const& request, ReducedScene const& scene,
                     ReducedMotion const& motion) {
  if (std::ranges::find(request.quantities, "casimir") == request.quantities.end()) return;
  auto const all = std::make_shared<std::vector<systems::Casimir> const>(casimirs_of(scene));
  if (all->empty())
    request.file.section("output").fail(
        "quantities", "casimir: the dual of this algebra has no Casimir of degree one or two");
  for (std::size_t k = 0; k < all->size(); ++k)
    simulation.remarks.push_back(fmt::format("casimir_{} is {}", k + 1, (*all)[k].text()));
  auto const now = [&motion, constant = components_that_stay_zero(scene)] {
    std::vector<double> x = motion.point().momentum;
    x.insert(x.end(), motion.point().vectors.begin(), motion.point().vectors.end());
    for (std::size_t k = constant.size(); k-- > 0;) x.erase(x.begin() + constant[k]);
    return Vector<double>(Eigen::Map<Eigen::VectorXd const>(x.data(), static_cast<Index>(x.size())));
  };
  simulation.quantities.define(
      "casimir", numbered(1, static_cast<int>(all->size())),
      [all, now](auto, double* out) {
        Vector<double> const x = now();
        for (auto const& casimir : *all) *out++ = casimir.evaluate(x);
      },
      // Its terms may cancel: their moduli added up.
      [all, now](auto, double const*, std::size_t k) {
        Vector<double> const x = now();
        double sum = 0;
        for (auto const& t : (*all)[k].terms)
          sum += std::abs(t.coefficient * x[t.i] * (t.j < 0 ? 1 : x[t.j]));
        return sum;
      });
}

}  // namespace actio::scene
