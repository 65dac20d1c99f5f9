#include "program/systems/media/loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "actio/formula/tape_derivatives.hpp"
#include "actio/numbers/nearest_name.hpp"
#include "program/registry/change_in_time.hpp"
#include "program/systems/formula.hpp"

namespace actio::scene {
namespace {

std::vector<std::string> first_names(std::vector<std::string> names, int d) {
  names.resize(static_cast<std::size_t>(d));
  return names;
}

Tape parsed(std::string const& text, std::vector<std::string> const& variables, TextPlace const& place) {
  return scene_formula(text, variables, {}, place).value;
}

/// A tape with the memory that it works in.
struct Evaluated {
  Tape tape;
  std::vector<double> work = {};
  void operator()(double const* x, double* y) { tape(x, y, work); }
};

/// A potential per mass in the coordinates of space.
template <int d>
media::SpacePotential<d> read_potential(SceneTable const& table, std::string const& key) {
  using Place = std::array<double, d>;
  if (!table.is_text(key))
    table.fail(
        key, fmt::format(
                 "{0}: a potential, a formula in {1}, is expected, for example {0} = \"9.81*{2}\", found {3}",
                 key, listed(first_names({"x", "y", "z"}, d)), "xyz"[d - 1], table.found(key)));
  std::string const text = table.text(key);
  Tape const value = parsed(text, first_names({"x", "y", "z"}, d), table.text_place(key));
  std::vector<int> all(d);
  for (int k = 0; k < d; ++k) all[static_cast<std::size_t>(k)] = k;
  constexpr int size = 1 + d + d * (d + 1) / 2;
  auto const level = std::make_shared<Evaluated>(Evaluated{value}),
             first = std::make_shared<Evaluated>(Evaluated{with_gradient(value, all)}),
             second = std::make_shared<Evaluated>(Evaluated{with_hessian(value, all)});
  auto const slope = [first](Place const& x) {
    std::array<double, 1 + d> y;
    (*first)(x.data(), y.data());
    return y;
  };
  return {[level](Place const& x) {
            double V;
            (*level)(x.data(), &V);
            return V;
          },
          [slope](Place const& x) {
            Place out;
            std::copy_n(slope(x).begin() + 1, d, out.begin());
            return out;
          },
          [second](Place const& x, Place const& u) {
            double y[size];
            (*second)(x.data(), y);
            Place out{};
            double const* h = y + 1 + d;
            for (int i = 0; i < d; ++i)
              for (int j = i; j < d; ++j, ++h) {
                out[i] += *h * u[j];
                if (j > i) out[j] += *h * u[i];
              }
            return out;
          }};
}

/// A motion of a side, formulas in X, Y, Z and t.
template <int d>
media::PrescribedMotion<d> read_motion(SceneTable const& table, std::string const& side,
                                       std::vector<LoadInTime>& in_time) {
  using Place = std::array<double, d>;
  auto variables = first_names({"X", "Y", "Z"}, d);
  variables.emplace_back("t");
  auto const texts = table.formulas(side);
  if (texts.size() != d)
    table.fail(side, fmt::format("motion: {} formulas in {} are expected, found {}", d, listed(variables),
                                 texts.size()));
  auto const tapes = std::make_shared<std::vector<Evaluated>>();
  for (std::size_t k = 0; k < texts.size(); ++k) {
    Tape const value = parsed(texts[k], variables, table.text_place(side, k));
    tapes->push_back({with_gradient(value, {d})});
    if (value.depends_on(d)) in_time.push_back({"motion." + side, with_hessian(value, {d})});
  }
  auto const at = [tapes](Place const& X, double t, int which) {
    double x[d + 1], y[2];
    std::copy(X.begin(), X.end(), x), x[d] = t;
    Place out;
    for (int k = 0; k < d; ++k) (*tapes)[static_cast<std::size_t>(k)](x, y), out[k] = y[which];
    return out;
  };
  return {[at](Place const& X, double t) { return at(X, t, 0); },
          [at](Place const& X, double t) { return at(X, t, 1); }};
}

/// The table of sides that a key of [system.load] is.
/// @throws SceneError  where it is something else, with an example
SceneTable table_of_sides(SceneFile const& file, std::string const& key, std::string const& example) {
  SceneTable const load = medium_keys.load.table(file);
  if (load.has(key) && !load.is_table(key))
    load.fail(key, fmt::format("{0}: a table with a side is expected, for example {0}.{1}, found {2}", key,
                               example, load.found(key)));
  return load.inside(key);
}

void require_known_side(SceneTable const& table, std::string const& side, MediumMesh const& mesh) {
  std::vector<std::string> names;
  for (auto const& [name, does] : mesh.sides) names.push_back(name);
  if (std::find(names.begin(), names.end(), side) == names.end())
    table.fail(side, fmt::format("{}: the body has no side '{}'{} (its sides: {})", table.name(), shown(side),
                                 did_you_mean(side, names), names.empty() ? "none" : listed(names)));
}

template <int d>
void read_tractions(SceneFile const& file, MediumMesh const& mesh, MediumLoads<d>& out) {
  SceneTable const table = table_of_sides(file, "traction", "right = [0, 1]");
  for (auto const& side : table.keys()) {
    require_known_side(table, side, mesh);
    auto const force = table.numbers(side, d);
    std::copy_n(force.begin(), d, out.loads.tractions[side].begin());
  }
}

/// Numbers, or formulas in t.
template <int d>
void read_pressures(SceneFile const& file, MediumMesh const& mesh, MediumLoads<d>& out) {
  SceneTable const load = medium_keys.load.table(file);
  if (!load.has("pressure") || !load.is_table("pressure")) return;
  SceneTable const table = load.inside("pressure");
  for (auto const& side : table.keys()) {
    require_known_side(table, side, mesh);
    if (!table.is_text(side)) {
      double const p = table.number(side);
      out.loads.pressures[side] = [p](double) { return p; };
      continue;
    }
    Tape const value = parsed(table.text(side), {"t"}, table.text_place(side));
    out.in_time.push_back({"pressure." + side, with_hessian(value, {0})});
    auto const tape = std::make_shared<Evaluated>(Evaluated{value});
    out.loads.pressures[side] = [tape](double t) {
      double p;
      (*tape)(&t, &p);
      return p;
    };
  }
}

template <int d>
void read_motions(SceneFile const& file, MediumMesh const& mesh, MediumLoads<d>& out) {
  SceneTable const table = table_of_sides(file, "motion", "left = [\"X\", \"Y + 0.1*sin(t)\"]");
  for (auto const& side : table.keys()) {
    require_known_side(table, side, mesh);
    if (mesh.sides.at(side) != media::Side::free)
      table.fail(side, fmt::format("motion: the side '{}' is {} and cannot be moved besides", side,
                                   name_of(mesh.sides.at(side))));
    out.sides[side] = {media::Side::moved, read_motion<d>(table, side, out.in_time)};
  }
}

}  // namespace

template <int d>
double MediumLoads<d>::slope_of_gravity(std::array<double, d> const& x) const {
  double square = 0;
  if (gravity)
    for (double const one : loads.potentials.front().gradient(x)) square += one * one;
  return std::sqrt(square);
}
template <int d>
std::string MediumLoads<d>::pull_of_gravity(std::array<double, d> const& x, double steepest) const {
  if (!gravity) return "";
  double const size = slope_of_gravity(x), nothing = 1e-12 * steepest;
  if (!(size > nothing)) return "gravity does not pull at the centre of the body";
  auto const slope = loads.potentials.front().gradient(x);
  std::string along;
  for (double const one : slope)
    along += fmt::format("{}{:.4g}", along.empty() ? "" : ", ", std::abs(one) <= nothing ? 0 : -one / size);
  return fmt::format("gravity pulls along ({}) with {:.6g} at the centre of the body", along, size);
}
/// Along a line.
template struct MediumLoads<1>;
/// In the plane.
template struct MediumLoads<2>;
/// In space.
template struct MediumLoads<3>;

double frequency_of(std::vector<LoadInTime> const& loads, std::vector<std::array<double, 3>> const& points,
                    double until, std::vector<std::string>& remarks) {
  double fastest = 0;
  for (auto const& load : loads) {
    ChangeInTime change{HUGE_VAL, -HUGE_VAL};
    auto const coordinates = static_cast<std::ptrdiff_t>(load.second.inputs) - 1;
    for (std::size_t const k : {std::size_t{0}, points.size() / 2, points.size() - 1}) {
      std::vector<double> x(points[k].begin(), points[k].begin() + coordinates);
      x.push_back(0);
      change.join(change_in_time(load.second, std::move(x), until, 0, 1000));
    }
    fastest = std::max(fastest, change.frequency());
    if (!change.settled)
      remarks.push_back(fmt::format("{}: from t = {:.9g} to {:.9g} it may change faster than steps know of",
                                    load.key, change.from, change.to));
  }
  return fastest;
}

bool has_loads(SceneFile const& file) {
  return !medium_keys.load.table(file).keys().empty() || !medium_keys.obstacle.table(file).keys().empty();
}

template <int d>
MediumLoads<d> read_medium_loads(SceneFile const& file, MediumMesh const& mesh) {
  MediumLoads<d> out;
  for (auto const& [name, does] : mesh.sides) {
    if (does != media::Side::free) out.sides[name] = {does, {}};
  }
  SceneTable const load = medium_keys.load.table(file), obstacle = medium_keys.obstacle.table(file);
  load.allow({"gravity", "pressure", "traction", "motion"});
  obstacle.allow({"potential"});
  if (load.has("gravity")) out.loads.potentials.push_back(read_potential<d>(load, "gravity"));
  out.gravity = load.has("gravity");
  if (obstacle.has("potential")) out.loads.potentials.push_back(read_potential<d>(obstacle, "potential"));
  if (load.has("pressure") && !load.is_table("pressure"))
    out.loads.outside_pressure = load.number("pressure");
  read_tractions(file, mesh, out), read_pressures(file, mesh, out), read_motions(file, mesh, out);
  return out;
}
/// Along a line.
template MediumLoads<1> read_medium_loads<1>(SceneFile const&, MediumMesh const&);
/// In the plane.
template MediumLoads<2> read_medium_loads<2>(SceneFile const&, MediumMesh const&);
/// In space.
template MediumLoads<3> read_medium_loads<3>(SceneFile const&, MediumMesh const&);

}  // namespace actio::scene
