// Scenes of a Lagrangian of one's own: against the systems that the program knows, against solutions by
// somebody else's code, and refused where they are wrong.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "last_row.hpp"
#include "refusal.hpp"
#include "witness/reference_solution.hpp"

using namespace actio::scene;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

double apart(std::vector<double> const& a, std::vector<double> const& b) {
  BOOST_REQUIRE_EQUAL(a.size(), b.size());
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference = std::max(difference, std::abs(a[i] - b[i])), size = std::max(size, std::abs(b[i]));
  return difference / size;
}

/// The same; what it is of is said.
double apart(std::string const& what, std::vector<double> const& a, std::vector<double> const& b) {
  double const found = apart(a, b);
  BOOST_TEST_MESSAGE(what << ": relative difference " << found);
  return found;
}

std::string own(std::string const& system, std::string const& initial, std::string const& rest) {
  return "[system]\nkind = \"euler_poincare\"\n" + system + "\n[initial]\n" + initial + "\n" + rest;
}

/// A sleigh, with a line for another.
std::string sleigh(std::string const& line = "", std::string const& instead = "") {
  std::string text =
      "[system]\nkind = \"euler_poincare\"\ngroup = \"SE(2)\"\nlagrangian = \"(w^2 + v1^2 + c*v2^2)/2\"\n"
      "parameters = { c = 6 }\n[initial]\nvelocity = [0.7, 1.0, 0.2]\n[method]\nstep = 0.1\n[run]\n"
      "until = 1\n[output]\nquantities = [\"energy\"]\n";
  return changed(std::move(text), line, instead);
}
void check_refused(std::string const& line, std::string const& instead, std::string const& says) {
  check_said(refusal(sleigh(line, instead), "own.toml"), says);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(own_lagrangian)

BOOST_AUTO_TEST_CASE(a_free_body_is_that_of_the_program) {
  std::string const rest =
      "[method]\nname = \"natural_chart\"\norder = 2\nstep = 0.05\n[run]\nuntil = 20\n[output]\n"
      "quantities = [\"body_momentum\", \"energy\"]\n";
  auto const known = last_row(
      "[system]\nkind = \"rigid_body\"\ninertia = [1, 2, 2.5]\n[initial]\n"
      "angular_velocity = [0.3, 1.1, -0.4]\n" +
      rest);
  auto const formula = last_row(own("group = \"SO(3)\"\nlagrangian = \"(w1^2 + 2*w2^2 + 2.5*w3^2)/2\"",
                                    "velocity = [0.3, 1.1, -0.4]", rest));
  // 400 steps, each solved to 16 epsilon
  BOOST_TEST(apart("a free body as a formula, 400 steps, against the optimised implementation", formula,
                   known) < 400 * 16 * eps);
}

BOOST_AUTO_TEST_CASE(a_body_in_four_dimensions_is_that_of_the_program) {
  std::string const rest =
      "[method]\nname = \"natural_chart\"\norder = 4\nstep = 0.05\n[run]\nuntil = 10\n[output]\n"
      "quantities = [";
  auto const known = last_row(
      "[system]\nkind = \"rigid_body_n\"\nlambda = [1, 2, 3, 4]\n[initial]\n"
      "angular_velocity = [0.9, -0.2, 0.3, 0.1, 0.4, -0.5]\n" +
      rest + "\"momentum\"]\n");
  auto const formula = last_row(
      own("group = \"SO(4)\"\nlagrangian = \"(3*x1^2 + 4*x2^2 + 5*x3^2 + 5*x4^2 + 6*x5^2 + 7*x6^2)/2\"",
          "velocity = [0.9, -0.2, 0.3, 0.1, 0.4, -0.5]", rest + "\"body_momentum\"]\n"));
  BOOST_TEST(apart("a body on SO(4) as a formula, 200 steps of order 4, against the optimised implementation",
                   formula, known) < 200 * 5 * 16 * eps);
}

BOOST_AUTO_TEST_CASE(a_heavy_top_is_that_of_the_program) {
  // Different schemes, with short steps of high order: both are at the motion itself.
  std::string const output = "[run]\nuntil = 0.25\n[output]\nquantities = [\"body_momentum\", \"energy\"]\n";
  auto const known = last_row(
      "[system]\nkind = \"heavy_top\"\nmass = 0.1\ninertia = [4e-5, 4e-5, 6e-5]\n"
      "centre_of_mass = [0, 0, 0.03]\ngravity = [0, 0, -9.81]\n[initial]\nattitude = [0.8, 0.6, 0, 0]\n"
      "angular_velocity = [0, 0, 150]\n[method]\norder = 4\nstep = 1.25e-5\n" +
      output);
  auto const formula = last_row(
      own("group = \"SO(3)\"\nlagrangian = \"(1.3e-4*(w1^2 + w2^2) + 6e-5*w3^2)/2 + 0.1*0.03*gravity3\"\n"
          "advected = { gravity = [0, 0, -9.81] }",
          "velocity = [0, 0, 150]\nconfiguration = [[1, 0, 0], [0, 0.28, -0.96], [0, 0.96, 0.28]]",
          "[method]\norder = 6\nstep = 2.5e-4\n" + output));
  // 20000 steps of one, 9000 substeps of the other
  BOOST_TEST(apart("a heavy top as a formula, against the optimised implementation", formula, known) < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_submarine_is_that_of_an_independent_solver) {
  using State = actio::Vector<double, 9>;  // angular velocity, velocity, direction of gravity
  Eigen::Vector3d const J(2, 1, 3), M(1, 2, 4), lever(0, 0.1, -0.3);
  State start;
  start << 0.4, 0.3, -0.5, 0.2, 0.6, -0.1, 0, 0, -1;
  State const end = actio::reference_solution(
      [&](double, State const& y) {
        Eigen::Vector3d const w = y.head<3>(), v = y.segment<3>(3), a = y.tail<3>();
        Eigen::Vector3d const Pi = J.cwiseProduct(w), P = M.cwiseProduct(v);
        State change;
        change << (Pi.cross(w) + P.cross(v) + lever.cross(a)).cwiseQuotient(J), P.cross(w).cwiseQuotient(M),
            a.cross(w);
        return change;
      },
      start, 0, 5);
  auto const row = last_row(
      own("group = \"SE(3)\"\n"
          "lagrangian = \"(2*w1^2 + w2^2 + 3*w3^2 + v1^2 + 2*v2^2 + 4*v3^2)/2 + 0.1*down2 - 0.3*down3\"\n"
          "advected = { down = [0, 0, -1] }",
          "velocity = [0.4, 0.3, -0.5, 0.2, 0.6, -0.1]",
          "[method]\norder = 6\nstep = 0.05\n[run]\nuntil = 5\n[output]\n"
          "quantities = [\"velocity\", \"down\"]\n"));
  std::vector<double> const nine(row.begin(), row.begin() + 9), solved(end.data(), end.data() + 9);
  BOOST_TEST(apart("a submarine as a formula, against GSL", nine, solved) < 1e-8);
  BOOST_TEST(row[9] == 0);  // a direction stays one
}

BOOST_AUTO_TEST_CASE(both_charts_keep_what_they_should_and_differ) {
  auto const run = [](std::string const& method) {
    return last_row(own("group = \"SE(2)\"\nlagrangian = \"(w^2 + v1^2 + 6*v2^2)/2\"",
                        "velocity = [0.7, 1.0, 0.2]",
                        "[method]\n" + method +
                            "\n[run]\nuntil = 5\n[output]\n"
                            "quantities = [\"spatial_momentum\", \"casimir\", \"poisson_defect\", "
                            "\"symplectic_defect\", \"leaf_defect\", \"order\"]\n"));
  };
  auto const natural = run("step = 0.1"), cayley = run("name = \"cayley_chart\"\nstep = 0.1"),
             galerkin = run("name = \"galerkin\"\norder = 4\nstep = 0.1");
  for (auto const& row : {natural, cayley, galerkin}) {
    BOOST_TEST(apart({row.begin(), row.begin() + 3}, {0.7, 1.0, 1.2}) < 50 * 16 * eps);
    BOOST_TEST(std::abs(row[3] - 2.44) < 50 * 16 * eps * 2.44);
    for (std::size_t k = 4; k < 7; ++k) BOOST_TEST(row[k] < 1e-13);
  }
  BOOST_TEST(std::abs(natural[7] - 2) < 0.1);
  BOOST_TEST(std::abs(cayley[7] - 2) < 0.1);
  BOOST_TEST(std::abs(galerkin[7] - 4) < 0.2);
}

BOOST_AUTO_TEST_CASE(tangent_maps_are_differences_of_motions) {
  // Two motions whose start differs by a thousandth each way: what their ends differ by, to the square of it
  // times what the third derivative may be.
  auto const run = [](double w) {
    std::string const start = "velocity = [" + std::to_string(w) + ", 1.0, 0.2]";
    return last_row(own("group = \"SE(2)\"\nlagrangian = \"(w^2 + v1^2 + 6*v2^2)/2\"", start,
                        "[method]\nstep = 0.1\n[run]\nuntil = 3\n[output]\n"
                        "quantities = [\"body_momentum\", \"tangent_map\"]\n"));
  };
  auto const here = run(0.7), above = run(0.701), below = run(0.699);
  for (std::size_t i = 0; i < 3; ++i) {
    double const slope = (above[i] - below[i]) / 0.002;
    BOOST_TEST(std::abs(slope - here[3 + 3 * i]) < 1e-4);
  }
}

BOOST_AUTO_TEST_CASE(what_is_wrong_is_said_at_its_place) {
  BOOST_TEST(refusal(sleigh(), "own.toml") == "");
  check_refused("c*v2^2", "c*vv2^2", "own.toml:4:31: unknown name 'vv2'; did you mean 'v2'?");
  check_refused("(w^2 + v1^2 + c*v2^2)/2", "(w^2 + v1^2 + c*v2^2/2", "own.toml:4:");
  check_refused("c*v2^2", "abs(v2)", "abs");
  check_refused("\"SE(2)\"", "\"SE(22)\"", "own.toml:3:9: group");
  check_refused("\"SE(2)\"", "\"SF(2)\"", "own.toml:3:9: group \"SF(2)\": there is no 'SF(2)'; did you mean");
  check_refused("group = \"SE(2)\"", "algebra = [[[0, 1], [0, 0]], [[0, 2], [0, 0]]]",
                "own.toml:3:11: algebra");
  check_refused("group = \"SE(2)\"", "algebra = [[[0, 1], [0, 0]], [[0, 0], [1, 0]]]", "[e_1, e_2]");
  check_refused("group = \"SE(2)\"\n", "", "needs 'group'");
  check_refused("group = \"SE(2)\"", "group = \"SE(2)\"\nside = \"both\"", "unknown side 'both'");
  check_refused("{ c = 6 }", "{ w = 6 }", "the name 'w' is taken already");
  check_refused("{ c = 6 }", "{ sin = 6 }", "the name 'sin' is taken already");
  check_refused("parameters", "advected = { a = [1, 2, 3, 4] }\nparameters", "3 (a point has 1 last)");
  check_refused("velocity = [0.7, 1.0, 0.2]", "velocity = [0.7, 1.0]", "own.toml:7:12: velocity: 3 numbers");
  check_refused("[method]", "configuration = [[2, 0, 0], [0, 1, 0], [0, 0, 1]]\n[method]",
                "element of the group");
  check_refused("c*v2^2", "0*c*v2^2", "it is not regular at the start: along v2");
  check_refused("c*v2^2", "c*v2^2 + 2*v1*v2*sqrt(6)", "not regular at the start: along");
  check_refused("c*v2^2", "c*log(v2 - 1)", "at the start");
  check_refused("step = 0.1", "name = \"galerkin\"\norder = 3\nstep = 0.1", "galerkin takes");
}

BOOST_AUTO_TEST_CASE(a_name_that_nothing_uses_is_refused_with_the_nearest) {
  check_refused("{ c = 6 }", "{ c = 6, C = 5 }",
                "own.toml:5:27: parameters: 'C' does not occur in the lagrangian; did you mean 'c'?");
  check_refused("{ c = 6 }", "{ c = 6, mass = 5 }",
                "own.toml:5:30: parameters: 'mass' does not occur in the lagrangian");
  check_refused("(w^2 +", "m = 2; (w^2 +",
                "own.toml:4:15: 'm' is defined, and nothing in the formula uses it");
  check_refused("(w^2 +", "m = 2; k = m; (w^2 +", "own.toml:4:22: 'k' is defined");
  check_refused("parameters", "advected = { down = [0, 1] }\nparameters",
                "own.toml:5:21: advected: down1 to down3 do not occur in the lagrangian, "
                "and output.quantities has no down");
  // Where it is asked for, or one component occurs, a vector is used.
  std::string const vector = sleigh("parameters", "advected = { down = [0, 1] }\nparameters");
  auto const with = [&vector](std::string const& what, std::string const& instead) {
    std::string text = vector;
    return refusal(text.replace(text.find(what), what.size(), instead), "own.toml");
  };
  BOOST_TEST(with("[\"energy\"]", "[\"energy\", \"down\"]") == "");
  BOOST_TEST(with("c*v2^2)/2", "c*v2^2)/2 - down2") == "");
  std::string const body =
      "[system]\nkind = \"rigid_body\"\ninertia = [1, 2, 2.5]\n"
      "torque = { potential = \"k = 2; j = 3; -k*r33\" }\n[initial]\nangular_velocity = [1, 0, 0]\n[run]\n"
      "until = 1\n[output]\nquantities = [\"energy\"]\n";
  check_said(refusal(body, "own.toml"), "own.toml:4:32: potential: 'j' is defined, and nothing");
}

BOOST_AUTO_TEST_CASE(formulas_share_definitions_to_the_last_digit) {
  auto const sleigh_of = [](std::string const& lagrangian, std::string const& force,
                            std::string const& constraint, std::string const& more) {
    return last_row(own("group = \"SE(2)\"\nlagrangian = \"" + lagrangian + "\"\nforce = { v1 = \"" + force +
                            "\" }\nconstraints = [\"" + constraint +
                            "\"]\nparameters = { c = 0.75, a = 0.5 }\n" + more,
                        "velocity = [1, 0.3, 0]",
                        "[method]\nstep = 0.05\n[run]\nuntil = 1\n[output]\n"
                        "quantities = [\"velocity\", \"reaction\", \"energy\"]\n"));
  };
  // Some are in an order in which none is known before it is used.
  auto const shared =
      sleigh_of("(v1^2 + side^2 + c*w^2)/2", "-fast*v1", "blade",
                "[system.definitions]\nfast = \"abs(v1) + abs(side)\"\nside = \"v2 + lever\"\n"
                "lever = \"a*w\"\nblade = \"v2 - tilt\"\ntilt = \"v1*t/10\"\n");
  auto const written =
      sleigh_of("(v1^2 + (v2 + a*w)^2 + c*w^2)/2", "-(abs(v1) + abs(v2 + a*w))*v1", "v2 - v1*t/10", "");
  BOOST_TEST((shared == written));
}

BOOST_AUTO_TEST_CASE(definitions_that_are_none_are_refused_at_their_places) {
  auto const with = [](std::string const& definitions, std::string const& says) {
    std::string text = sleigh("(w^2 + v1^2", "(a + v1^2");
    auto const at = text.find("parameters");
    check_said(refusal(text.insert(at, "definitions = { " + definitions + " }\n"), "own.toml"), says);
  };
  with("a = \"w^2\"", "");
  with("a = \"b\", b = \"c + a\"",
       "own.toml:5:35: b: a definition cannot use itself; here each uses the next: a, b, a");
  with("a = \"w^2 + v3\"", "own.toml:5:28: a: unknown name 'v3'; did you mean 'v1'?");
  with("b = \"w^2\"", "own.toml:4:16: unknown name 'a'");
  with("A = \"w^2\"", "unknown name 'a'; did you mean 'A'?");
  with("a = \"w^2\", b = \"v1\"", "own.toml:5:32: definitions: 'b' does not occur in the lagrangian");
  with("a = \"abs(w)\"", "own.toml:5:22: a: 'abs' has kinks");
  with("a = \"q = 2; q*w\"", "a: found 'q', expected one formula");
  with("a = \"w^2;\"", "a: found ';', expected an operator, or the end");
  with("w = \"1\"", "the name 'w' is taken already: it is a component");
  with("c = \"1\"", "the name 'c' is taken already: it is a parameter");
  with("t = \"1\"", "the name 't' is taken already: it is a number of the force");
  with("p_w = \"1\"", "the name 'p_w' is taken already: it is a number of the force");
  with("sin = \"1\"", "the name 'sin' is taken already: formulas know it");
  with("a = [1]", "own.toml:5:21");
  std::string const lines =
      "definitions = { u = \"w\" }\nforce = { w = \"u\" }\ninputs = { u = \"t\" }\nparameters";
  check_refused("parameters", lines, "own.toml:7:16: the name 'u' is taken already: it is a definition");
}

BOOST_AUTO_TEST_CASE(what_is_near_the_group_is_told_and_what_is_too_small_is_refused) {
  auto const scene = Scene::read(SceneFile::parse(
      sleigh("[method]", "configuration = [[1, 0, 0], [0, 1.0000000002, 0], [0, 0, 1]]\n[method]"),
      "own.toml"));
  BOOST_REQUIRE_EQUAL(scene.simulation.remarks.size(), 1u);
  check_said(scene.simulation.remarks[0], "configuration: it is taken as it is, 2e-10 away from the group");
  BOOST_TEST(Scene::read(SceneFile::parse(sleigh(), "own.toml")).simulation.remarks.empty());
  check_refused("[method]", "configuration = [[0, 0, 0], [0, 0, 0], [0, 0, 0]]\n[method]",
                "so far from it that no distance can be told");
  check_refused("(w^2 + v1^2 + c*v2^2)/2", "1e-300*(w^2 + v1^2 + c*v2^2)/2",
                "lagrangian: its second derivatives at the start are 6e-300 at most, and at least 1e-280 is");
}

BOOST_AUTO_TEST_CASE(a_step_too_long_is_told_with_the_longest) {
  std::string const start = "velocity = [3, 2, 9]",
                    body = "group = \"SO(3)\"\nlagrangian = \"(w1^2 + 2*w2^2 + 3*w3^2)/2\"";
  auto const run = [&](std::string const& step) {
    return refusal(own(body, start,
                       "[method]\nstep = " + step + "\n[run]\nuntil = " + step +
                           "\n[output]\nquantities = [\"energy\"]\n"),
                   "own.toml");
  };
  std::string const said = run("5"), words = "the largest step that would do is ";
  auto const at = said.find(words);
  BOOST_REQUIRE_MESSAGE(at != std::string::npos, said);
  std::string const largest =
      said.substr(at + words.size(), said.find_first_of(",;", at) - at - words.size());
  BOOST_TEST(run(largest) == "");
}

BOOST_AUTO_TEST_CASE(what_a_force_a_friction_or_a_shape_cannot_be_is_refused) {
  auto const with = [](std::string const& lines, std::string const& says) {
    check_refused("parameters =", lines + "\nparameters =", says);
  };
  std::string const good = "force = [\"-0.1*w\", \"u\", \"-v2*abs(v2) + 0.1*p_v1*sin(t)\"]\n";
  std::string const driven = sleigh("parameters =", good + "inputs = { u = \"t < 2\" }\nparameters =");
  BOOST_TEST(refusal(driven, "own.toml") == "");
  with("force = [\"w\", \"0\"]", "force: 3 formulas are expected, one for each of w, v1, v2; found 2");
  with("force = { v3 = \"1\" }", "unknown key of [system.force] 'v3'; did you mean 'v1'?");
  with("force = { v1 = \"x + 1\" }", "unknown name 'x'");
  with("force = { v1 = \"1/(w - 0.7)\" }", "along v1 it is inf at the start");
  with("inputs = { u = \"t\" }", "inputs: they are given to the force, and there is no system.force");
  with("force = { w = \"1\" }\ninputs = { u = \"t\" }", "inputs: 'u' does not occur in the force");
  with("force = { w = \"v1\" }\ninputs = { v1 = \"t\" }", "the name 'v1' is taken already");
  with("force = { w = \"u\" }\ninputs = { u = [[1, 0], [0, 1]] }", "times must ascend");
  with("force = { w = \"u\" }\ninputs = { u = \"no.csv\" }", "no.csv");
  with("force_in_space = [0]", "force_in_space: 3 formulas are expected, one for each of w, v1, v2; found 1");
  with("force_in_space = { v2 = \"u\" }", "force_in_space: unknown name 'u'");
  with("force_in_space = { v1 = \"1/(w - 0.7)\" }", "force_in_space: along v1 it is inf at the start");
  with("side = \"right\"\nforce_in_space = { w = \"1\" }", "the components of force are those of space");
  with("constraints = [\"v2\"]\nforce_in_space = { w = \"1\" }", "force_in_space: it takes no system.constr");
  check_said(
      refusal(sleigh("[initial]\nvelocity = [0.7, 1.0, 0.2]\n[method]\n",
                     "force_in_space = { w = \"1\" }\n[initial]\nvelocity = [0.7, 1.0, 0.2]\n[method]\n"
                     "name = \"galerkin\"\n"),
              "own.toml"),
      "galerkin: it takes no force_in_space");
  std::string const defect = sleigh("\"energy\"", "\"poisson_defect\"");
  check_said(refusal(defect.substr(0, defect.find("[initial]")) + "force_in_space = { w = \"1\" }\n" +
                         defect.substr(defect.find("[initial]")),
                     "own.toml"),
             "poisson_defect: with force_in_space a step is no map of momenta");
  with("dissipation = { kind = \"conformal\", rate = -1 }", "rate: a number >= 0 is expected, found -1");
  with("dissipation = { kind = \"orbital\", rate = 1 }", "did you mean 'orbit'?");
  with("dissipation = { kind = \"conformal\", rate = 1, metric = [[1]] }", "friction on the orbit");
  with("dissipation = { kind = \"orbit\", rate = 1, metric = [[1, 0, 0], [0, 1, 0], [0, 0, -1]] }",
       "its least eigenvalue is -1");
  with("dissipation = { kind = \"orbit\", rate = 1, metric = [[1, 1, 0], [0, 1, 0], [0, 0, 1]] }",
       "differs from its transpose by 1");
  with("shape = { w = 1 }", "w");
  with("shape = {}", "at least one variable is expected");
  with("shape = { angle = 1 }", "angle");
  std::string const galerkin = "name = \"momentum_level\"\nstep = 0.1";
  check_said(refusal(sleigh("step = 0.1", galerkin + "\n[system.force]\nw = \"1\""), "own.toml"),
             "momentum_level: it takes no force");
}

BOOST_AUTO_TEST_CASE(a_force_in_space_is_added_to_that_of_the_body) {
  // A puck that glides and turns, with a pull in space and a thrust of its own: its place and what the two
  // add.
  auto const run = [](std::string const& forces, std::string const& quantities) {
    return last_row(own("group = \"SE(2)\"\nlagrangian = \"(3*w^2 + 2*(v1^2 + v2^2))/2\"\n" + forces,
                        "velocity = [1, 0.5, 0]\nconfiguration = [[0, -1, 2], [1, 0, 1], [0, 0, 1]]",
                        "[method]\norder = 4\nstep = 0.0125\n[run]\nuntil = 1\n[output]\nquantities = [" +
                            quantities + "]\n"));
  };
  auto const pulled = run("force_in_space = { v1 = \"pull\" }\ninputs = { pull = \"0.6\" }",
                          "\"configuration\", \"spatial_momentum\", \"momentum_balance\", \"work\", "
                          "\"energy\", \"force\"");
  // 2 x'' = 0.6 from x = 2 at rest along x; y grows by 0.5.
  BOOST_TEST(std::abs(pulled[2] - 2.15) < 1e-8);
  BOOST_TEST(std::abs(pulled[5] - 1.5) < 1e-8);
  // w, v1, v2 of the momentum in space: 3 W + 2 (x y' - y x'), 2 x', 2 y' at the start, and 0.6 t.
  double const before[] = {3 + 2 * 2 * 0.5, 0, 1};
  BOOST_TEST(std::abs(pulled[9] - before[0]) < 1e-13);
  BOOST_TEST(std::abs(pulled[10] - 0.6) < 1e-13);
  BOOST_TEST(std::abs(pulled[11] - before[2]) < 1e-13);
  for (int i = 0; i < 3; ++i)
    BOOST_TEST(std::abs(pulled[static_cast<std::size_t>(12 + i)] - before[i]) < 1e-13);
  BOOST_TEST(std::abs(pulled[16] - (3 + 0.5) / 2 - pulled[15]) < 1e-8);
  // Along a line through the origin, as it is from the body: of the same size.
  BOOST_TEST(std::abs(std::hypot(pulled[18], pulled[19]) - 0.6) < 1e-13);
  auto const both = run("force_in_space = [0, 0.6, 0]\nforce = [\"0.3\", 0, 0]",
                        "\"spatial_momentum\", \"momentum_balance\"");
  // The body's torque about its own centre is one about the origin, as it has no force.
  BOOST_TEST(std::abs(both[0] - before[0] - 0.3) < 1e-13);
  BOOST_TEST(std::abs(both[1] - 0.6) < 1e-13);
}

BOOST_AUTO_TEST_CASE(a_shape_variable_is_the_coordinate_that_it_stands_for) {
  // An oscillator beside a body that turns freely: x'' = -4 x.
  auto const row = last_row(
      own("group = \"SO(3)\"\nshape = { x = 0.3 }\n"
          "lagrangian = \"(w1^2 + 2*w2^2 + 3*w3^2 + x_rate^2 - 4*x^2)/2\"",
          "velocity = [0.5, 0.1, 0.2, 0.7]",
          "[method]\norder = 6\nstep = 0.025\n[run]\nuntil = 1\n[output]\nquantities = [\"shape\"]\n"));
  BOOST_TEST(row.size() == 1);
  BOOST_TEST(std::abs(row[0] - (0.3 * std::cos(2.0) + 0.25 * std::sin(2.0))) < 1e-10);
  auto const right = last_row(
      own("group = \"SO(3)\"\nside = \"right\"\nshape = { x = 0.3 }\nforce = { x_rate = \"-0.2*x_rate\" }\n"
          "lagrangian = \"(w1^2 + 2*w2^2 + 3*w3^2 + x_rate^2 - 4*x^2)/2\"",
          "velocity = [0.5, 0.1, 0.2, 0.7]",
          "[method]\norder = 6\nstep = 0.025\n[run]\nuntil = 1\n[output]\nquantities = [\"shape\"]\n"));
  double const w = std::sqrt(4 - 0.01);
  BOOST_TEST(std::abs(right[0] - std::exp(-0.1) * (0.3 * std::cos(w) + (0.5 + 0.03) / w * std::sin(w))) <
             1e-10);
}

BOOST_AUTO_TEST_SUITE_END()
