#include "program/systems/media/material.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "actio/numbers/nearest_name.hpp"
#include "program/systems/media/keys.hpp"

namespace actio::scene {

std::string MediumKeys::constants_of_materials(bool fluid) {
  std::string out;
  for (auto const& material : library_materials()) {
    if (material.fluid != fluid) continue;
    out += (out.empty() ? "" : "; ") + material.name + " with ";
    for (auto const& constant : material.constants)
      out += (&constant == &material.constants.front() ? "" : ", ") + constant.name;
  }
  return out;
}

namespace {

template <class M>
NamedMaterial record_of() {
  NamedMaterial out{M::name, M::meaning, M::formula, M::fluid, {}};
  if constexpr (requires { M::said(); })
    out.constants = M::said();
  else
    for (auto const& constant : M::constants()) out.constants.push_back(constant.said);
  return out;
}

/// Its numbers, each above its bound.
template <class M>
M read_numbers(SceneTable const& table) {
  M out;
  auto const constants = M::constants();
  std::vector<std::string> known{"name"};
  for (auto const& constant : constants) known.push_back(constant.said.name);
  table.allow(known);
  for (auto const& [number, said] : constants) {
    out.*number = table.number(said.name);
    if (!(out.*number > said.above))
      table.fail(said.name, fmt::format("{}: a number greater than {} is expected, found {}", said.name,
                                        said.above, out.*number));
  }
  return out;
}

/// One of the list, as the table has it.
template <class M>
M read(SceneTable const& table, int d) {
  M out;
  if constexpr (requires { M::read(table, d); })
    out = M::read(table, d);
  else
    out = read_numbers<M>(table);
  if constexpr (requires { out.require_stable(table, d); }) out.require_stable(table, d);
  return out;
}

/// All of the list.
template <class... M>
std::vector<NamedMaterial> materials_of(std::variant<M...> const&) {
  return {record_of<M>()...};
}
/// The one of that name of the list.
template <class... M>
Material read_named(std::string const& name, SceneTable const& table, int d, std::variant<M...> out) {
  (void)((name == M::name && (out = read<M>(table, d), true)) || ...);
  return out;
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
  static std::vector<NamedMaterial> const all = materials_of(Material());
  return all;
}

NamedMaterial const* find_material(std::string const& name) {
  for (auto const& material : library_materials())
    if (material.name == name) return &material;
  return nullptr;
}

Material read_material(SceneTable const& system, bool fluid, int d) {
  AnyKey const& material = medium_keys.material;
  if (!material.given(system))
    throw SceneError(system.place(),
                     fmt::format("[system.material] is needed, with a name, one of {}, and its "
                                 "constants (actio list materials)",
                                 listed(names_of(fluid))));
  SceneTable table = material.table(system);
  if (!fluid && !table.has("name") && table.has("energy")) table.set("name", materials::EnergyFormula::name);
  if (!table.has("name"))
    table.fail("name", fmt::format("[system.material] needs 'name', one of {}", listed(names_of(fluid))));
  refuse_of_other_kind(table, fluid);
  return read_named(table.choice("name", "material", names_of(fluid), "actio list materials"), table, d,
                    Material());
}

std::vector<std::string> remarks_on(Material const& material, int d) {
  return std::visit(
      [&](auto const& own) -> std::vector<std::string> {
        if constexpr (requires { own.remarks(d); })
          return own.remarks(d);
        else
          return {};
      },
      material);
}

bool is_fluid(Material const& material) {
  return std::visit([](auto const& own) { return own.fluid; }, material);
}

bool pressure_is_of_density(Material const& material) {
  return std::visit(
      [](auto const& own) {
        if constexpr (requires { own.pressure_of_density; })
          return own.pressure_of_density;
        else
          return false;
      },
      material);
}

namespace materials {

void require_volume_modulus(SceneTable const& table, std::string const& key, double constant, double mu,
                            int d, double more, std::string const& sum) {
  double const first = constant + more, bound = -2 * mu / d;
  if (first > bound) return;
  table.fail(
      key, fmt::format("{}: Lame's first modulus at rest{} must be greater than -2 mu/{} = {}, or the solid "
                       "is unstable; found {}, greater than {} would do",
                       key, more != 0 ? fmt::format(" {} = {}", sum, first) : "", d, bound, first - more,
                       bound - more));
}

/// \cond
void MooneyRivlin::require_stable(SceneTable const& table, int d) const {
  double const shear = 2 * (c1 + std::max(0, d - 2) * c2);
  // What is stored at rest is a minimum where a change of shape takes energy, and so does one of volume.
  if (!(shear > 0))
    table.fail("c2",
               fmt::format("c2: the shear modulus at rest, 2 (c1 + c2), must be positive, and it is {}; c2 "
                           "is greater than -c1 = {}, found {}",
                           shear, -c1, c2));
  require_volume_modulus(table, "lambda", lambda, shear, d, d > 1 ? 4 * c2 : 0, "lambda + 4 c2");
}
/// \endcond

}  // namespace materials
}  // namespace actio::scene
