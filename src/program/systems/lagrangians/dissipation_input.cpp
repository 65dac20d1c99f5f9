#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include "program/systems/lagrangians/dissipation_input.hpp"

#include <fmt/format.h>

#include <cmath>

namespace actio::scene {
namespace {

Eigen::MatrixXd read_sharp(SceneTable const& table, int dimension) {
  if (!dissipation_keys.metric.given(table)) return Eigen::MatrixXd::Identity(dimension, dimension);
  Eigen::MatrixXd const metric = table.matrix("metric", dimension);
  double const skew = (metric - metric.transpose()).cwiseAbs().maxCoeff(),
               size = metric.cwiseAbs().maxCoeff();
  if (skew > 1e-12 * size)
    dissipation_keys.metric.fail(
        table,
        fmt::format("a symmetric matrix is expected; this one differs from its transpose by {:.3g}", skew));
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> const axes(metric);
  double const least = axes.eigenvalues().minCoeff();
  if (!(least > 1e-12 * size))
    dissipation_keys.metric.fail(
        table, fmt::format("a positive definite matrix is expected; its least eigenvalue is {:.3g}", least));
  return axes.eigenvectors() * axes.eigenvalues().cwiseInverse().asDiagonal() *
         axes.eigenvectors().transpose();
}

}  // namespace

std::optional<systems::Dissipation> read_dissipation(SceneFile const& file,
                                                     systems::ReducedSystem const& system,
                                                     std::vector<std::string>& remarks) {
  SceneTable const whole = file.section("system");
  if (!whole.has("dissipation")) return {};
  SceneTable const table = whole.inside("dissipation"), method = file.section("method");
  using Kind = systems::Dissipation::Kind;
  systems::Dissipation out{dissipation_keys.kind.read(table) == "orbit" ? Kind::orbit : Kind::conformal,
                           dissipation_keys.rate.read(table)};
  if (out.rate < 0)
    dissipation_keys.rate.fail(table, fmt::format("a number >= 0 is expected, found {}", out.rate));
  std::string const name = method.is_text("name") ? method.text("name") : "natural_chart";
  bool const constrained = whole.has("constraints");
  bool const charts = name == "natural_chart" || name == "cayley_chart";
  if (out.kind == Kind::orbit) {
    if (constrained)
      dissipation_keys.kind.fail(
          table,
          "orbit: it takes no system.constraints, whose reactions lead away from the orbit; conformal does");
    if (system.vectors > 0)
      dissipation_keys.kind.fail(table,
                                 "orbit: it takes no carried vectors, and the scene has system.advected");
    if (system.algebra.constants.empty())
      dissipation_keys.kind.fail(
          table, "orbit: this group is commutative, so that each coadjoint orbit is one point");
    if (!charts)
      method.fail("name", fmt::format("{}: natural_chart and cayley_chart take friction on the orbit", name));
    out.sharp = read_sharp(table, system.dimension());
    return out;
  }
  if (dissipation_keys.metric.given(table))
    dissipation_keys.metric.fail(table, "it belongs to friction on the orbit, kind = \"orbit\"");
  bool const along = systems::damps_along_free_motion(system) && !system.force && !constrained;
  if (!along && !charts)
    method.fail(
        "name",
        fmt::format("{}: it takes damping where the Lagrangian is quadratic in the velocity, without carried "
                    "vectors and forces; natural_chart and cayley_chart do here",
                    name));
  if (along)
    remarks.push_back(
        fmt::format("dissipation: the damped motion is the free one, slowed; it stops after the time "
                    "{:.6g} of it",
                    1 / out.rate));
  return out;
}

}  // namespace actio::scene
