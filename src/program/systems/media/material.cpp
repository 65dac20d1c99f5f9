#include "program/systems/media/material.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "actio/continuum/materials.hpp"
#include "actio/numbers/nearest_name.hpp"
#include "program/systems/media/laws.hpp"

namespace actio::scene {
namespace {

std::vector<NamedMaterial> fluids() {
  return {
      {"polytropic_gas",
       "A gas of one entropy everywhere: its pressure is K times the power gamma of its density.",
       "p = K\\,(\\rho/J)^\\gamma",
       true,
       {{"K", "pressure at the density 1", 0, "1"}, {"gamma", "exponent, above 1", 1, "2"}}},
      {"shallow_water",
       "Water in a layer that is thin beside its waves: the density is the depth of "
       "the layer times that of water, 1.",
       "p = \\tfrac g2\\,(\\rho/J)^2",
       true,
       {{"g", "acceleration of gravity", 0, "9.81"}}},
      {"tait",
       "Tait's liquid: without pressure at J = 1, where the speed of sound is the root of gamma B over the "
       "density; under J = 1 it withstands a tension less than B.",
       "p = B\\,(J^{-\\gamma} - 1)",
       true,
       {{"B", "modulus, a pressure", 0, "100"}, {"gamma", "exponent, above 1; about 7 for water", 1, "7"}}},
  };
}

std::vector<NamedMaterial> solids() {
  MaterialConstant const mu{"mu", "shear modulus", 0, "1"};
  constexpr double any = -1e300;
  MaterialConstant const lambda{"lambda", "Lame's first modulus, more than -2 mu/d", any, "1"};
  return {
      {"saint_venant_kirchhoff",
       "The solid of St Venant and Kirchhoff: linear in the Green strain E. It does not resist collapse, "
       "and is for small strains at any rotation.",
       "\\rho W = \\tfrac\\lambda2(\\mathrm{tr}\\,E)^2 + \\mu\\,\\mathrm{tr}\\,E^2",
       false,
       {lambda, mu}},
      {"neo_hookean",
       "A neo-Hookean solid of d dimensions, free of stress at rest, with a quadratic energy of the "
       "volume; Lame's first modulus at rest is kappa, more than -2 mu/d.",
       "\\rho W = \\tfrac\\mu2(\\mathrm{tr}\\,C - d - 2\\ln J) + \\tfrac\\kappa2(J-1)^2",
       false,
       {mu, {"kappa", "modulus of the volume", any, "2"}}},
      {"mooney_rivlin",
       "The solid of Mooney and Rivlin of d dimensions, free of stress at rest, with I_1 = tr C "
       "and I_2 = ((tr C)^2 - tr C^2)/2. For d > 1 its shear modulus at rest is mu = 2 (c1 + (d - "
       "2) c2) > 0 and Lame's first modulus lambda + 4 c2 > -2 mu/d; on a line c2 does nothing, "
       "and the modulus is 4 c1 + lambda.",
       "\\rho W = c_1(I_1-d) + c_2(I_2-\\tfrac{d(d-1)}2) - 2(c_1+(d-1)c_2)\\ln "
       "J + \\tfrac\\lambda2(\\ln J)^2",
       false,
       {{"c1", "modulus of the first invariant", 0, "0.4"},
        {"c2", "modulus of the second invariant", any, "0.1"},
        {"lambda", "modulus of the logarithm of the volume", any, "1"}}},
  };
}

/// Mooney and Rivlin's law as a function of the deformation gradient.
struct MooneyRivlinOfGradient {
  MooneyRivlin<double> law;
  template <class T, int d>
  T operator()(Matrix<T, d, d> const& F) const {
    Matrix<T, d, d> C;
    for (int i = 0; i < d; ++i)
      for (int j = 0; j < d; ++j) {
        C(i, j) = T(0);
        for (int k = 0; k < d; ++k) C(i, j) = C(i, j) + F(k, i) * F(k, j);
      }
    return law(C);
  }
};
/// Its energy as a function of Green's strain, and the stress of that.
template <int d>
double strain_energy(MooneyRivlinOfGradient const& medium, Matrix<double, d, d> const& E) {
  auto const& [c1, c2, volume] = medium.law;
  media::StrainMeasures<d> const of(E);
  return 2 * (c1 + (d - 1) * c2) * of.distortion + 4 * c2 * of.second +
         volume.lambda / 2 * of.logarithm * of.logarithm;
}
/// \f$(4(c_1+(d-1)c_2)E+\lambda\log J)\,C^{-1}+4c_2(\Tr E-E)\f$.
template <int d>
Matrix<double, d, d> strain_stress(MooneyRivlinOfGradient const& medium, Matrix<double, d, d> const& E) {
  auto const& [c1, c2, volume] = medium.law;
  media::StrainMeasures<d> const of(E);
  double const J = 1 + of.volume;
  Matrix<double, d, d> left = E * (4 * (c1 + (d - 1) * c2)), rest = E * (-4 * c2);
  for (int i = 0; i < d; ++i) left(i, i) += volume.lambda * of.logarithm, rest(i, i) += 4 * c2 * E.trace();
  return left * media::cofactors(media::beyond_identity<d>(E * 2)) * (1 / (J * J)) + rest;
}

std::vector<std::string> names_of(bool fluid) {
  std::vector<std::string> out;
  for (auto const& material : library_materials())
    if (material.fluid == fluid) out.push_back(material.name);
  return out;
}

/// A material of the other kind of system is told as one.
void refuse_of_other_kind(SceneTable const& table, bool fluid) {
  NamedMaterial const* const named = find_material(table.text("name"));
  if (!named || named->fluid == fluid) return;
  table.fail("name",
             fmt::format("material: {} is a material of {}; here is one of {} expected", named->name,
                         named->fluid ? "barotropic_fluid" : "elastic_body", listed(names_of(fluid))));
}

}  // namespace

std::vector<NamedMaterial> const& library_materials() {
  static std::vector<NamedMaterial> const all = [] {
    auto out = fluids();
    for (auto& solid : solids()) out.push_back(std::move(solid));
    return out;
  }();
  return all;
}

NamedMaterial const* find_material(std::string const& name) {
  for (auto const& material : library_materials())
    if (material.name == name) return &material;
  return nullptr;
}

Material read_material(SceneTable const& system, bool fluid) {
  if (!system.has("material"))
    system.fail("material", fmt::format("[system.material] is needed, with a name, one of {}, and its "
                                        "constants (actio list materials)",
                                        listed(names_of(fluid))));
  SceneTable const table = system.inside("material");
  if (!table.has("name"))
    table.fail("name", fmt::format("[system.material] needs 'name', one of {}", listed(names_of(fluid))));
  refuse_of_other_kind(table, fluid);
  Material out{find_material(table.choice("name", "material", names_of(fluid), "actio list materials")), {}};
  std::vector<std::string> known{"name"};
  for (auto const& constant : out.record->constants) known.push_back(constant.name);
  table.allow(known);
  for (auto const& constant : out.record->constants) {
    double const value = table.number(constant.name);
    if (!(value > constant.above))
      table.fail(constant.name, fmt::format("{}: a number greater than {} is expected, found {}",
                                            constant.name, constant.above, value));
    out.constants.push_back(value);
  }
  return out;
}

void require_stable_material(SceneTable const& system, Material const& material, int d) {
  if (material.record->fluid) return;
  SceneTable const table = system.inside("material");
  auto const& c = material.constants;
  std::string const& name = material.record->name;
  bool const mooney = name == "mooney_rivlin", neo = name == "neo_hookean";
  double const mu = mooney ? 2 * (c[0] + std::max(0, d - 2) * c[1]) : neo ? c[0] : c[1];
  double const more = mooney && d > 1 ? 4 * c[1] : 0, first = neo ? c[1] : mooney ? c[2] + more : c[0];
  // What is stored at rest is a minimum where a change of shape takes energy, and so does one of volume.
  if (!(mu > 0))
    table.fail("c2",
               fmt::format("c2: the shear modulus at rest, 2 (c1 + c2), must be positive, and it is {}; c2 "
                           "is greater than -c1 = {}, found {}",
                           mu, -c[0], c[1]));
  if (first > -2 * mu / d) return;
  std::string const key = neo ? "kappa" : "lambda";
  table.fail(
      key,
      fmt::format("{}: Lame's first modulus at rest{} must be greater than -2 mu/{} = {}, or the solid is "
                  "unstable; found {}, greater than {} would do",
                  key, more != 0 ? " lambda + 4 c2 = " + fmt::format("{}", first) : "", d, -2 * mu / d,
                  first - more, -2 * mu / d - more));
}

bool pressure_is_of_density(Material const& material) {
  return material.record->name == "polytropic_gas" || material.record->name == "shallow_water";
}

template <int d>
std::shared_ptr<media::StoredEnergy<d> const> stored_energy_of(Material const& material) {
  std::string const& name = material.record->name;
  auto const& c = material.constants;
  if (name == "polytropic_gas") return media::stored_energy<d>(media::isentropic_gas(c[0], c[1]));
  if (name == "shallow_water") return media::stored_energy<d>(media::isentropic_gas(c[0] / 2, 2));
  if (name == "tait")
    return media::stored_energy<d>(media::per_volume(media::FastFluid{GasLaw{c[0], c[1], c[0]}}));
  if (name == "saint_venant_kirchhoff")
    return media::stored_energy<d>(media::per_volume(media::FastStVenantKirchhoff{c[0], c[1]}));
  if (name == "neo_hookean")
    return media::stored_energy<d>(
        media::per_volume(media::FastNeoHookean{c[0], media::QuadraticLaw{c[0], c[1]}}));
  return media::stored_energy<d>(
      media::per_volume(MooneyRivlinOfGradient{MooneyRivlin{c[0], c[1], LogarithmicVolume<double>{c[2]}}}));
}
/// Along a line.
template std::shared_ptr<media::StoredEnergy<1> const> stored_energy_of<1>(Material const&);
/// In the plane.
template std::shared_ptr<media::StoredEnergy<2> const> stored_energy_of<2>(Material const&);
/// In space.
template std::shared_ptr<media::StoredEnergy<3> const> stored_energy_of<3>(Material const&);

}  // namespace actio::scene
