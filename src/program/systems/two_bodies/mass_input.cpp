#include <Eigen/Core>

#include "program/systems/two_bodies/mass_input.hpp"

#include <fmt/format.h>

#include <numbers>

#include "actio/two_bodies/obj_file.hpp"
#include "program/catalogue/bodies.hpp"

namespace actio::scene {
namespace {

using bodies::ExtendedBody, bodies::Moments;

/// [system.primary] or [system.secondary].
struct MassKeys : KeyTable {
  MassKeys(std::string const& name, std::string const& which)
      : KeyTable(name, needed, "The " + which + ".", "{ sphere = 390, density = 2400 }") {}

  Key<std::vector<double>> ellipsoid =
      key("ellipsoid", numbers("three numbers > 0", 3).in("length"),
          without({"sphere", "shape", "moments", "body"}),
          "The half axes of a homogeneous ellipsoid, along the axes of its frame.", "[394, 394, 290]");
  Key<double> sphere =
      key("sphere", positive.in("length"), without({"ellipsoid", "shape", "moments", "body"}),
          "The radius of a ball.", "390");
  AnyKey shape = key("shape", "a text", without({"ellipsoid", "sphere", "moments", "body"}),
                     "A file in the format .obj with the closed surface of a homogeneous body, its triangles "
                     "counter-clockwise as seen from outside.",
                     "\"kw4.obj\"");
  Key<double> length_unit =
      key("length_unit", positive.in("length"), 1, "What a length of 1 in the file of the shape is.", "100");
  Key<Eigen::MatrixXd> moments = key(
      "moments", rows("rows of four numbers: i, j, l and the moment", 4).in("mass x length^(i+j+l)"),
      without({"ellipsoid", "sphere", "shape", "body", "density", "mass"}),
      "The integrals of x^i y^j z^l over the mass; that of 0, 0, 0 is the mass. Those that are not listed "
      "are zero, and those beyond system.order are not used.",
      "[[0, 0, 0, 6], [2, 0, 0, 2], [0, 2, 0, 2], [0, 0, 2, 2], [4, 0, 0, 2], [0, 4, 0, 2], [0, 0, 4, 2]]");
  Key<double> radius = key("radius", positive.in("length"), LeftOut{"needed with moments or body"},
                           "No part of the body is farther from the origin of its frame.", "400");
  Key<double> density = key("density", positive.in("mass/length^3"), without({"mass", "moments", "body"}),
                            "The density.", "2400");
  Key<double> mass = key("mass", positive.in("mass"), without({"density", "moments"}), "The mass.", "5.3e11");
  // The words are those of the library, of which not all have a mass.
  Key<std::string> body = key(
      "body", Pattern<std::string>{"a text", one_of("body", names_of_bodies(), "actio list bodies").read},
      without({"ellipsoid", "sphere", "shape", "moments", "density"}),
      "A body of the library with moments of inertia in kg m^2, beside its mass and radius; the potential is "
      "then of order 2.",
      "\"iss\"");

 private:
  /// A key that these exclude.
  LeftOut without(Words const& others) const {
    std::string out;
    for (auto const& other : others) out += (out.empty() ? "or " : " or ") + name() + "." + other;
    return {out};
  }
};
GivenBody homogeneous(MassKeys const& keys, SceneTable const& table, double volume,
                      std::function<ExtendedBody(double density)> const& make) {
  auto const density = keys.density.find(table), mass = keys.mass.find(table);
  if (bool(density) == bool(mass))
    throw SceneError(table.place(), table.name() + (density ? ": density and mass exclude each other"
                                                            : ": 'density' or 'mass' is needed"));
  double const of = density ? *density : *mass / volume;
  return {make(of), of};
}

GivenBody from_shape(MassKeys const& keys, SceneTable table, int order, std::vector<std::string>& remarks) {
  auto const [path, text] = table.read_file("shape", "a surface in the format .obj");
  double const unit = keys.length_unit.read(table);
  return refused_at(table, "shape", [&] {
    auto const surface = bodies::parse_obj(text, unit);
    double const volume = bodies::polyhedron_moments<double>(surface, 1, 0).mass();
    GivenBody given = homogeneous(keys, table, volume, [&](double density) {
      return bodies::polyhedron_body(surface, density, order);
    });
    auto const& [body, density] = given;
    if (double const shift = body.centre.norm(); shift > 1e-9 * body.radius)
      remarks.push_back(
          fmt::format("{}.shape: the centre of mass is at ({:.6g}, {:.6g}, {:.6g}) of the file, and "
                      "positions are those of the centre of mass",
                      table.name(), body.centre[0], body.centre[1], body.centre[2]));
    // The cosine of the angle that is least turned.
    double const along = body.axes.cwiseAbs().rowwise().maxCoeff().minCoeff();
    if (along < 1 - 1e-9)
      remarks.push_back(
          fmt::format("{}.shape: the principal axes are turned by up to {:.3g} degrees from those of the "
                      "file, in which attitudes and angular velocities are",
                      table.name(), std::acos(along) * 180 / std::numbers::pi));
    return given;
  });
}

GivenBody from_moments(MassKeys const& keys, SceneTable const& table, int order) {
  auto const listed = keys.moments.read(table);
  Moments<double> moments(order);
  for (Eigen::Index row = 0; row < listed.rows(); ++row) {
    Eigen::Vector3d const k = listed.block<1, 3>(row, 0).transpose();
    if (k != k.array().round().matrix() || k.minCoeff() < 0)
      keys.moments.fail_at(
          table, static_cast<std::size_t>(row),
          fmt::format("exponents are whole numbers, 0 or more, found {}, {}, {}", k[0], k[1], k[2]));
    if (k.sum() <= order) moments.set(int(k[0]), int(k[1]), int(k[2]), listed(row, 3));
  }
  double const radius = keys.radius.read(table);
  return {refused_at(table, "moments", [&] { return bodies::extended_body(moments, radius); }), 0};
}

GivenBody from_library(MassKeys const& keys, SceneTable const& table) {
  Body const& known = *find_body(keys.body.read(table));
  if (known.unit != "kg m^2")
    keys.body.fail(table, fmt::format("moments of inertia in kg m^2 are needed, and those of {} are in: {}",
                                      known.name, known.unit));
  double const mass = keys.mass.read(table), radius = keys.radius.read(table);
  Moments<double> moments(2);
  moments.set(0, 0, 0, mass);
  Eigen::Matrix3d const I = known.principal.tensor(), S = Eigen::Matrix3d::Identity() * (I.trace() / 2) - I;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      moments.set((i == 0) + (j == 0), (i == 1) + (j == 1), (i == 2) + (j == 2), S(i, j));
  return {refused_at(table, "body", [&] { return bodies::extended_body(moments, radius); }), 0};
}

}  // namespace

std::vector<Parameter> mass_parameters(std::string const& name, std::string const& which) {
  return MassKeys(name, which).records();
}
bool is_of_order_two(SceneTable const& table) { return table.has("body"); }

GivenBody read_mass(SceneTable const& table, int order, std::vector<std::string>& remarks) {
  MassKeys const keys(table.name(), "");
  std::vector<std::string> given;
  for (char const* const form : {"ellipsoid", "sphere", "shape", "moments", "body"})
    if (table.has(form)) given.emplace_back(form);
  if (given.size() != 1)
    throw SceneError(given.empty() ? table.place() : table.place(given[1]),
                     given.empty() ? table.name() + ": ellipsoid, sphere, shape, moments or body is needed"
                                   : given[0] + " and " + given[1] + " exclude each other");
  for (auto const& [form, key] : {std::pair("moments", "density"), {"moments", "mass"}, {"body", "density"}})
    if (given[0] == form && table.has(key))
      table.fail(key, fmt::format("{} and {} exclude each other", form, key));
  if (given[0] == "shape") return from_shape(keys, table, order, remarks);
  if (given[0] == "moments") return from_moments(keys, table, order);
  if (given[0] == "body") return from_library(keys, table);
  return refused_at(table, given[0], [&] {
    std::array<double, 3> a;
    if (given[0] == "sphere")
      a.fill(keys.sphere.read(table));
    else
      std::ranges::copy(keys.ellipsoid.read(table), a.begin());
    for (double const x : a)
      if (!(x > 0)) table.fail("ellipsoid", fmt::format("ellipsoid: a half axis must be > 0, found {}", x));
    double const volume = 4 * std::numbers::pi / 3 * a[0] * a[1] * a[2];
    return homogeneous(keys, table, volume,
                       [&](double density) { return bodies::ellipsoid_body(density * volume, a, order); });
  });
}

}  // namespace actio::scene
