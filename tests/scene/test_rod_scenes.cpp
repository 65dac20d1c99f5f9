// Rods of scenes: against a published benchmark and relative equilibria, and what is refused of them.
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>

#include "program/run/run.hpp"
#include "refusal.hpp"

using namespace actio::scene;
using std::numbers::pi;

namespace {

/// The rows of a scene, by the names of their columns.
struct Rows {
  std::vector<std::string> columns;
  std::vector<double> table;
  std::vector<std::string> remarks;
  std::vector<SnapshotArray> reference, fields;  // of snapshots at the end, where there are any

  double at(std::size_t row, std::string const& column) const {
    auto const found = std::ranges::find(columns, column);
    BOOST_REQUIRE_MESSAGE(found != columns.end(), column);
    return table[row * (columns.size() + 1) + 1 + static_cast<std::size_t>(found - columns.begin())];
  }
  std::size_t count() const { return table.size() / (columns.size() + 1); }
  double last(std::string const& column) const { return at(count() - 1, column); }
  double largest(std::string const& column) const {
    double out = 0;
    for (std::size_t row = 0; row < count(); ++row) out = std::max(out, std::abs(at(row, column)));
    return out;
  }
};
Rows rows_in(SceneFile file) {
  Scene scene = Scene::read(std::move(file));
  Rows out{scene.simulation.quantities.columns(), {}, scene.simulation.remarks, {}, {}};
  auto const report = run_in_memory(scene, out.table, {.quiet = true});
  BOOST_REQUIRE_MESSAGE((report.ending == Ending::done), report.message);
  if (scene.simulation.snapshots)
    out.reference = scene.simulation.snapshots->coordinates(),
    out.fields = scene.simulation.snapshots->fields();
  return out;
}
Rows rows_of(std::string const& name, std::vector<std::string> const& overrides) {
  return rows_in(SceneFile::read(ACTIO_DATA "/scenes/" + name + ".toml", overrides));
}

std::string const plain =
    "[system]\nkind = \"rod\"\n[system.rod]\nlength = 1\nelements = 8\n"
    "section = { EA = 90, GA = 40, EI = 1, GJ = 1, rA = 1, rI = 0.01 }\n[run]\nuntil = 0.1\n"
    "every = 0.05\n[output]\nquantities = [\"energy\"]\n";
std::string const section = "section = { EA = 90, GA = 40, EI = 1, GJ = 1, rA = 1, rI = 0.01 }\n";
/// What the plain rod is refused with where one line is another.
std::string said(std::string const& line, std::string const& instead) {
  return refusal(changed(plain, line, instead), "rod.toml");
}
std::string with_lines(std::string const& scene, std::string const& more) {
  return changed(scene, "[run]\n", more + "[run]\n");
}
std::string with(std::string const& more) { return refusal(with_lines(plain, more), "rod.toml"); }

}  // namespace

BOOST_AUTO_TEST_SUITE(rod_scenes)

// Positions of the loaded end at t = 2.5 and t = 5, from a program of its own with 20 to 160 elements,
// extrapolated; those with 20 and 40 elements are off by a fourth as much, the scheme having order 2.
BOOST_AUTO_TEST_CASE(a_rod_flies_off_as_in_the_benchmark) {
  struct Known {
    double t, place[3];
  };
  static constexpr Known known[] = {{2.5, {3.41295, 0.19690, 0.01735}}, {5, {19.56276, 1.52134, -1.50770}}};
  double off[2][2] = {};
  for (int finer = 0; finer < 2; ++finer) {
    auto const rows =
        rows_of("flying_spaghetti",
                {"run.until=5", "run.every=2.5", finer ? "system.rod.elements=40" : "system.rod.elements=20",
                 "!output.snapshots", "!output.snapshot_every", "output.formats=[\"csv\"]"});
    for (int k = 0; k < 2; ++k)
      for (int a = 0; a < 3; ++a)
        off[finer][k] = std::hypot(
            off[finer][k], rows.at(static_cast<std::size_t>(k) + 1, std::string("start_place_") + "xyz"[a]) -
                               known[k].place[a]);
    BOOST_TEST(rows.largest("noether_balance") <= 1e-13);
    BOOST_TEST(std::abs(rows.last("momentum_x") - 50) <= 1e-11);
  }
  for (int k = 0; k < 2; ++k) {
    double const order = std::log2(off[0][k] / off[1][k]);
    BOOST_TEST_MESSAGE("flying rod: off by " << off[0][k] << ", " << off[1][k] << ", order " << order);
    BOOST_TEST(std::abs(order - 2) <= 0.1);
  }
}

// The relative equilibrium is that of the continuous rod, which the scheme has to the square of its steps.
BOOST_AUTO_TEST_CASE(a_helix_turns_without_changing_its_shape_to_the_order_of_the_scheme) {
  double off[2];
  for (int finer = 0; finer < 2; ++finer) {
    auto const rows =
        rows_of("turning_helix", {"run.until=2", finer ? "system.rod.elements=96" : "system.rod.elements=48",
                                  "!output.snapshots", "!output.snapshot_every"});
    off[finer] = std::max(std::abs(std::hypot(rows.last("end_place_x"), rows.last("end_place_y")) - 1),
                          std::abs(std::hypot(rows.last("start_place_x") - std::cos(2),
                                              rows.last("start_place_y") - std::sin(2))));
  }
  double const order = std::log2(off[0] / off[1]);
  BOOST_TEST_MESSAGE("helix: off by " << off[0] << ", " << off[1] << ", order " << order);
  BOOST_TEST(std::abs(order - 2) <= 0.2);
}

BOOST_AUTO_TEST_CASE(a_ring_that_turns_keeps_its_radius_and_its_momenta) {
  auto const rows = rows_of("spinning_ring", {"run.until=6", "initial.velocity=[\"-y\", \"x\", \"0\"]"});
  for (std::size_t row = 0; row < rows.count(); ++row)
    // To the square of the angle of an element, 2 pi/96.
    BOOST_TEST(std::abs(std::hypot(rows.at(row, "start_place_x"), rows.at(row, "start_place_y")) - 1.25) <=
               2 * std::pow(2 * pi / 96, 2));
  BOOST_TEST(rows.largest("noether_balance") <= 1e-14);
}

BOOST_AUTO_TEST_CASE(an_unshearable_rod_keeps_its_constraint) {
  auto const rows = rows_of("swinging_chain", {"run.until=0.5"});
  BOOST_TEST(rows.largest("constraint_residual") <= 1e-12);
  BOOST_TEST(rows.largest("noether_balance") <= 1e-11);
}

// The arm goes round with its hub: long after that turns evenly the root has its angle, and the tension there
// holds rA w^2 L^2/2.
BOOST_AUTO_TEST_CASE(an_end_is_moved_as_its_formulas_say) {
  auto const rows = rows_of("whirling_rod", {"run.until=16", "run.every=16"});
  double const half = (6 * 16 - 45) / 2.0;
  BOOST_TEST(std::abs(std::abs(rows.last("start_attitude_w")) - std::abs(std::cos(half))) <= 1e-9);
  double const tension = std::hypot(rows.last("contact_force_start_x"), rows.last("contact_force_start_y"));
  BOOST_TEST(std::abs(tension / (1.2 * 36 * 50) - 1) <= 0.05);
}

BOOST_AUTO_TEST_CASE(sections_are_at_equal_distances_along_a_curve) {
  // A parabola by a parameter that is not its length.
  auto const rows = rows_in(SceneFile::parse(
      changed(changed(plain, "length = 1\n", "curve = [\"2*s^2 + s\", \"(2*s^2 + s)^2\", \"0\"]\n"),
              "[output]\n", "[output]\nsnapshots = [\"stretch\", \"curvature\"]\n"),
      "rod.toml"));
  auto const& x = rows.fields[0].numbers;
  BOOST_REQUIRE(rows.fields[0].name == "position");
  BOOST_REQUIRE(x.size() == 27u);
  auto const length = [](double u) { return (2 * u * std::sqrt(1 + 4 * u * u) + std::asinh(2 * u)) / 4; };
  for (std::size_t k = 0; k < 9; ++k)
    BOOST_TEST(std::abs(length(x[3 * k]) - length(3) * static_cast<double>(k) / 8) <= 1e-9);
  BOOST_TEST(std::abs(rows.reference[0].numbers.back() - length(3)) <= 1e-9);
  // At rest it is without stress.
  BOOST_TEST(rows.largest("energy") <= 1e-25);
  for (auto const& field : rows.fields)
    if (field.name == "stretch" || field.name == "curvature")
      for (double const one : field.numbers) BOOST_TEST(std::abs(one) <= 1e-12);
}

BOOST_AUTO_TEST_CASE(a_shape_by_its_strains_is_the_circle_that_they_say) {
  auto const rows = rows_in(SceneFile::parse(
      changed(changed(plain, "elements = 8\n", "elements = 64\ncurvature = [\"0\", \"0\", \"pi/2\"]\n"),
              "\"energy\"", "\"energy\", \"end_place\""),
      "rod.toml"));
  // A quarter of a circle from the origin along the first axis.
  BOOST_TEST(std::abs(rows.at(0, "end_place_x") - 2 / pi) <= 1e-4);
  BOOST_TEST(std::abs(rows.at(0, "end_place_y") - 2 / pi) <= 1e-4);
  BOOST_TEST(rows.largest("energy") <= 1e-25);
}

BOOST_AUTO_TEST_CASE(what_a_rod_cannot_be_is_refused_at_its_key) {
  check_said(said("EA = 90", "EA = 0"),
             "rod.toml:6:18: EA: a number > 0 is expected, found 0; constraint = "
             "\"unshearable\" is for rods that neither stretch nor shear");
  check_said(said("GA = 40", "GA = -1"), "GA: a number > 0 is expected, found -1");
  check_said(said("EI = 1,", "EI = 0,"), "EI");
  check_said(said("rI = 0.01", "rI = 0.01, rJ = 0.03"), "triangle inequality");
  check_said(said("rI = 0.01", "rI = 0.01, rJ = 0.03"), "measured 0.01");
  check_said(said("elements = 8\n", "elements = 1\n"), "elements");
  check_said(said(section, ""), "section");
  check_said(said("EI = 1, ", ""), "neither radius nor EI is there");
  check_said(said(section, section + "constraint = \"unshearable\"\n"), "EA: a rod with constraint");
  check_said(said("EI = 1", "E1 = 1"), "unknown key");
  check_said(said("length = 1\n", ""), "needs length");
  check_said(said("length = 1\n", "length = 1\ncurve = [\"s\", \"s^2\", \"0\"]\n"), "length: curve says it");
  check_said(said("length = 1\n", "curve = [\"s\", \"abs(s)\", \"0\"]\n"), "abs");
  check_said(said("length = 1\n", "curve = [\"s\", \"0\", \"0\"]\nclosed = true\n"),
             "its end is 1 away from its start, bound 1e-09");
  check_said(said("length = 1\n", "length = 1\nclosed = true\n"), "curve is missing");
  check_said(said("length = 1\n", "length = 1\naxis = [0, 0, 0]\n"), "found one of length 0");
  check_said(said("length = 1\n", "length = 1\nacross = [1, 0, 0]\n"), "across");
  // A turn by 2 atan(pi) in an element, about 145 degrees.
  check_said(said("length = 1\n", "length = 1\ncurvature = [\"0\", \"0\", \"16*pi\"]\n"),
             "turns by an angle of");
  check_said(said("length = 1\n", "length = 1\ncurvature = [\"0\", \"1/s\", \"log(s - 1)\"]\n"),
             "curvature: a finite value is expected, found nan at s = 0.0625");
  check_said(with("[system.parameters]\nr = 1\n"), "'r'");
}

BOOST_AUTO_TEST_CASE(an_element_that_turns_by_more_than_sixty_degrees_is_remarked_on) {
  auto const rows = rows_in(SceneFile::parse(
      changed(plain, "length = 1\n", "length = 1\ncurvature = [\"0\", \"0\", \"10\"]\n"), "rod.toml"));
  // 2 atan(10/16) = 64 degrees
  BOOST_REQUIRE(rows.remarks.size() == 1u);
  check_said(rows.remarks[0], "an element turns by 64 degrees");
}

BOOST_AUTO_TEST_CASE(supports_and_loads_that_exclude_each_other_are_refused_at_their_keys) {
  check_said(with("[system.boundary]\nstart = \"clmped\"\n"), "did you mean 'clamped'?");
  check_said(
      with("[system.boundary]\nend = { place = [\"1.5\", \"0\", \"0\"] }\n"),
      "place: at t = 0 it is (1.5, 0, 0), and the end of the rod is at (1, 0, 0), 0.5 away; bound 1e-09");
  check_said(with("[system.boundary]\nend = { axis = [0, 0, 1], angle = \"0.1 + t\" }\n"),
             "angle: at t = 0 it is 0.1");
  check_said(with("[system.boundary]\nend = { angle = \"t\" }\n"), "axis and angle go together");
  check_said(with("[system.boundary]\nend = {}\n"), "place or angle is needed");
  check_said(with("[system.boundary]\nend = \"pinned\"\n[system.load]\nend_force = [\"0\", \"0\", \"1\"]\n"),
             "end_force: system.boundary holds the place there");
  check_said(
      with("[system.boundary]\nend = \"clamped\"\n[system.load]\nend_moment = [\"0\", \"0\", \"1\"]\n"),
      "end_moment: system.boundary holds the attitude there");
  check_said(with("[system.load]\nend_force = [\"0\", \"1\"]\n"),
             "three formulas in t are expected, found 2");
  check_said(with("[system.load]\nframe = \"body\"\n"), "no force and no moment");
  check_said(with("[system.load]\nend_force = [\"x\", \"0\", \"0\"]\n"), "'x'");
  check_said(said("length = 1\n", "curve = [\"cos(2*pi*s)\", \"sin(2*pi*s)\", \"0\"]\nclosed = true\n"), "");
  std::string const ring =
      changed(plain, "length = 1\n", "curve = [\"cos(2*pi*s)\", \"sin(2*pi*s)\", \"0\"]\nclosed = true\n");
  check_said(refusal(with_lines(ring, "[system.load]\nend_force = [\"0\", \"0\", \"1\"]\n"), "r"),
             "a ring has no ends");
  check_said(refusal(with_lines(ring, "[system.boundary]\nstart = \"pinned\"\n"), "r"), "a ring has no ends");
}

BOOST_AUTO_TEST_CASE(a_step_beyond_the_limit_is_refused_with_what_binds_it) {
  std::string const told = with("[method]\nstep = 0.025\n");
  check_said(told, "step: steps of 0.025 are not stable, bound by waves of bending and shear");
  check_said(told, "the longest that would do is 0.01249999");
  BOOST_TEST(with("[method]\nstep = 0.01\n").empty());
  // That of a slender rod is bound by 2 sqrt(rI/GA), and the constraint takes that away.
  std::string const slender =
      changed(changed(with_lines(plain, "[method]\nstep = 0.01\n"), "rI = 0.01", "rI = 1e-5"), "EI = 1,",
              "EI = 0.01,");
  check_said(
      refusal(changed(slender, "GJ = 1,", "GJ = 0.005,"), "r"),
      "shear that turns the sections, 2 sqrt(rI/GA); with constraint = \"unshearable\" those up to 0.00");
}

BOOST_AUTO_TEST_SUITE_END()
