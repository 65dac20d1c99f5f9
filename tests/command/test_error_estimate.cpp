// The error that a run tells of itself, against the true one; drift in natural units; rows between steps;
// steps that a top is not meant for.
#include <boost/test/unit_test.hpp>

#include <random>

#include "body_n.hpp"
#include "body_scene.hpp"

namespace {

using namespace command;

/// A number of summary.json: the first with this name after `section`; NaN where there is none, or a
/// sentence.
double figure(std::string const& summary, std::string const& section, std::string const& name) {
  std::size_t const begin = summary.find("\"" + section + "\": {"), end = summary.find('}', begin),
                    at = summary.find("\"" + name + "\": ", begin);
  if (begin == std::string::npos || at > end) return NAN;
  char const* const value = summary.c_str() + at + name.size() + 4;
  return *value == '"' ? NAN : std::strtod(value, nullptr);
}

/// The largest errors of attitude (radians) and momentum (of the largest modulus) of one table against
/// another, row by row.
struct Errors {
  double attitude = 0, momentum = 0;
};
Errors errors_in_space(Table const& found, Table const& truth) {
  double attitude = 0, momentum = 0, modulus = 0;
  auto const column = [](Table const& t, std::string const& name, std::size_t row) { return t[name][row]; };
  for (std::size_t row = 0; row < truth.rows.size(); ++row) {
    double less = 0, more = 0, apart = 0, size = 0;  // of the two signs of a quaternion
    for (std::string const c : {"_w", "_x", "_y", "_z"}) {
      double const q = column(found, "attitude" + c, row), p = column(truth, "attitude" + c, row);
      less += (q - p) * (q - p), more += (q + p) * (q + p);
    }
    for (std::string const c : {"_x", "_y", "_z"}) {
      apart += std::pow(column(found, "body_momentum" + c, row) - column(truth, "body_momentum" + c, row), 2);
      size += std::pow(column(truth, "body_momentum" + c, row), 2);
    }
    attitude = std::max(attitude, 4 * std::asin(std::sqrt(std::min(less, more)) / 2));
    momentum = std::max(momentum, std::sqrt(apart)), modulus = std::max(modulus, std::sqrt(size));
  }
  return {attitude, momentum / modulus};
}
Errors errors_in_n(Table const& found, Table const& truth, int n) {
  double attitude = 0, momentum = 0, modulus = 0;
  for (std::size_t row = 0; row < truth.rows.size(); ++row) {
    Square const M = skew(truth, "momentum", n, row);
    attitude =
        std::max(attitude, difference(matrix(found, "attitude", n, row), matrix(truth, "attitude", n, row)) /
                               std::sqrt(2.0));
    momentum = std::max(momentum, difference(skew(found, "momentum", n, row), M)),
    modulus = std::max(modulus, norm(M));
  }
  return {attitude, momentum / modulus};
}

/// A run with its table and its summary.
Left left_by(std::string const& scene) {
  Folder const folder;
  Left left{
      actio({"run", "--quiet", "--out", folder / "out", folder.write("scene.toml", scene)}), {}, "", ""};
  if (left.outcome.status == 0) left.table = read_csv(folder / "out/series.csv");
  left.scene = contents(folder / "out/scene.toml"), left.summary = contents(folder / "out/summary.json");
  return left;
}

/// How many errors were held, and of how many there was a number.
struct Held {
  int all = 0, told = 0;
};
void hold(std::string const& what, std::string const& summary, Errors const& truth, Held& held) {
  for (auto const& [name, error] :
       {std::pair<std::string, double>{"attitude", truth.attitude}, {"momentum", truth.momentum}}) {
    double const told = figure(summary, "error", name);
    BOOST_TEST_MESSAGE(what << ": " << name << " off by " << error << ", estimated " << told << ", ratio "
                            << told / error);
    BOOST_TEST(error > 1e-12,
               what << ": the error of the " << name << " is too small to be told from rounding: " << error);
    ++held.all;
    if (std::isnan(told)) {
      BOOST_TEST(contains(summary, "\"" + name + "\": \"no number"), summary);
      continue;
    }
    ++held.told;
    BOOST_TEST((told < 3 * error && told > error / 3),
               what << ": " << name << " off by " << error << ", estimated " << told);
  }
}
/// Four in five have a number.
void require_most_told(Held const& held) {
  BOOST_TEST(5 * held.told >= 4 * held.all, held.told << " of " << held.all << " have a number");
}

/// Tops, all different.
BodyScene top(std::mt19937& random, std::string const& method) {
  std::uniform_real_distribution<double> u(0, 1);
  auto const list = [](std::vector<double> const& x) { return listed(x); };
  BodyScene scene;
  scene.system =
      "kind = 'heavy_top'\nmass = " + number(1 + u(random)) +
      "\ninertia = " + list({0.5 + 0.3 * u(random), 0.5 + 0.3 * u(random), 0.4 + 0.3 * u(random)}) +
      "\ncentre_of_mass = " + list({0.2 * u(random), 0.2 * u(random), 0.3}) + "\ngravity = [0, 0, -9.81]";
  scene.initial = "angular_velocity = " + list({u(random), 2 * u(random), 4 + u(random)});
  scene.method = method, scene.run = "until = 4\nevery = 0.125",
  scene.quantities = "'attitude', 'body_momentum'";
  return scene;
}

/// Hung up by a point, axle level: what is conserved beside the energy is zero.
BodyScene wheel() {
  return {
      "kind = 'heavy_top'\nmass = 2\ninertia = [0.04, 0.04, 0.08]\ncentre_of_mass = [0, 0, 0.2]\n"
      "gravity = [0, 0, -9.81]",
      "attitude = [0.7071067811865476, 0.7071067811865476, 0, 0]\nangular_velocity = [0, 0, 40]", "",
      "until = 10\nevery = 0.02", "'energy', 'vertical_momentum', 'casimir', 'attitude'"};
}
/// Let go from the level: its energy is zero.
BodyScene pendulum() {
  return {
      "kind = 'heavy_top'\nmass = 1\ninertia = [0.1, 0.1, 0.1]\ncentre_of_mass = [1, 0, 0]\n"
      "gravity = [0, 0, -9.81]",
      "angular_velocity = [0, 0, 0]", "", "until = 10\nevery = 0.02",
      "'energy', 'vertical_momentum', 'casimir', 'body_momentum', "
      "'angular_velocity', 'direction_of_gravity'"};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(error_estimate)

BOOST_AUTO_TEST_CASE(it_is_within_a_factor_of_three_of_the_error_of_twenty_systems) {
  std::mt19937 random(11);
  Held held;
  // Tops, against a sixteenth of the step in order 4.
  for (auto const& [order, step] : {std::pair("2", "0.015625"),
                                    {"4", "0.03125"},
                                    {"2", "0.0078125"},
                                    {"4", "0.041666666666666664"},
                                    {"2", "0.03125"},
                                    {"4", "0.03125"},
                                    {"2", "0.015625"},
                                    {"4", "0.041666666666666664"}}) {
    BodyScene scene = top(random, std::string("order = ") + order + "\nstep = " + step);
    Left const found = run(scene);
    BOOST_TEST(found.outcome.status == 0, found.outcome.err);
    scene.method = "order = 4\nstep = 0.001953125";
    hold(std::string("top, order ") + order + ", step " + step, found.summary,
         errors_in_space(found.table, run(scene).table), held);
  }
  // Bodies in three to six dimensions, against a sixteenth of the step in order 6.
  std::uniform_real_distribution<double> u(0, 1);
  for (auto const& [method, order, step] : {std::tuple("moser_veselov", "2", "0.0625"),
                                            {"moser_veselov", "4", "0.0625"},
                                            {"moser_veselov", "6", "0.125"},
                                            {"moser_veselov", "2", "0.03125"},
                                            {"moser_veselov", "4", "0.125"},
                                            {"moser_veselov", "6", "0.0625"},
                                            {"natural_chart", "2", "0.0625"},
                                            {"natural_chart", "4", "0.125"}}) {
    int const n = 3 + static_cast<int>(4 * u(random));
    BodyN body{{}, {}, method, step, "12", "0.5", "\"attitude\", \"momentum\"", {}, order};
    for (int i = 0; i < n; ++i) body.lambda.push_back(0.5 + 3 * u(random));
    for (int a = 0; a < n * (n - 1) / 2; ++a) body.velocity.push_back(u(random) - 0.5);
    Left const found = left_by(body.text() + "error_estimate = true\n");
    BOOST_TEST(found.outcome.status == 0, found.outcome.err);
    body.method = "moser_veselov", body.order = "6", body.step = "0.0078125";
    hold(std::string(method) + " on SO(" + std::to_string(n) + "), order " + order + ", step " + step,
         found.summary, errors_in_n(found.table, left_by(body.text()).table, n), held);
  }
  // Free bodies in space, against the exact motion.
  for (std::string const method : {"order = 2\nstep = 0.0625", "order = 4\nstep = 0.25",
                                   "name = 'natural_chart'\norder = 2\nstep = 0.0625",
                                   "name = 'natural_chart'\norder = 4\nstep = 0.25"}) {
    BodyScene scene{"kind = 'rigid_body'\ninertia = " + listed({1, 1.5 + u(random), 2.6 + u(random) / 2}),
                    "angular_velocity = " + listed({u(random), 1, u(random)}), method,
                    "until = 20\nevery = 0.25", "'attitude', 'body_momentum'"};
    Left const found = run(scene);
    scene.method = "order = 'exact'";
    Left const exact = run(scene);
    hold("free body, " + method, found.summary, errors_in_space(found.table, exact.table), held);
    BOOST_TEST(contains(exact.summary, "exact: no error but that of rounding"));
    BOOST_TEST(std::isnan(figure(exact.summary, "error", "momentum")));
  }
  require_most_told(held);
}

BOOST_AUTO_TEST_CASE(it_is_within_a_factor_of_three_of_the_error_under_a_torque) {
  Held held;
  for (std::string const torque :
       {"gravity_gradient = { rate = 0.8, direction = [1, 0, 0], normal = [0, 0, 1] }",
        "potential = '-2*r33*(1 + 0.3*cos(t)) + 0.5*r12^2'"})
    for (std::string const method : {"order = 2\nstep = 0.015625", "order = 4\nstep = 0.03125"}) {
      BodyScene scene{"kind = 'rigid_body'\ninertia = [1, 1.7, 2.1]\n[system.torque]\n" + torque,
                      "angular_velocity = [0.6, 1.2, -0.9]", method, "until = 4\nevery = 0.25",
                      "'attitude', 'body_momentum'"};
      Left const found = run(scene);
      BOOST_TEST(found.outcome.status == 0, found.outcome.err);
      scene.method = "order = 4\nstep = 0.00390625";
      hold(torque + ", " + method, found.summary, errors_in_space(found.table, run(scene).table), held);
    }
  require_most_told(held);
}

BOOST_AUTO_TEST_CASE(a_default_in_n_dimensions_reaches_a_millionth_until_the_end) {
  for (std::string const until : {"10", "1000"}) {
    BodyN body{{0.5, 1, 1.7, 2.9, 4.1},
               {0.3, 0.2, -0.4, 0.1, 0.5, 0.2, -0.3, 0.4, 0.1, -0.2},
               "moser_veselov",
               {},
               until,
               until,
               "\"attitude\", \"momentum\""};
    Left const found = left_by(body.text());
    BOOST_TEST(contains(found.scene, "order = 6"), found.scene);
    BOOST_TEST(contains(found.scene, "error_estimate = true"), found.scene);
    body.step = "0.015625";
    Errors const truth = errors_in_n(found.table, left_by(body.text()).table, 5);
    BOOST_TEST_MESSAGE("five dimensions, until " << until << ": attitude off by " << truth.attitude
                                                 << ", momentum by " << truth.momentum);
    BOOST_TEST(truth.attitude < 1e-6);
    BOOST_TEST(truth.momentum < 1e-6);
    BOOST_TEST(figure(found.summary, "error", "attitude") < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(it_is_told_at_the_end_and_left_out_where_it_is_not_wanted) {
  Folder const folder;
  BodyScene scene{"kind = 'rigid_body'\ninertia = [1, 2, 3]", "angular_velocity = [0.1, 1, 0.1]",
                  "order = 2\nstep = 0.125", "until = 10\nevery = 0.25", "'energy'"};
  auto const told = actio({"run", "--out", folder / "a", folder.write("a.toml", scene.text())});
  BOOST_TEST(contains(told.out, "; error: momentum "), told.out);
  BOOST_TEST(!contains(told.out, "attitude"), told.out);  // which the scene does not ask for
  auto const none = actio(
      {"run", "--out", folder / "b", folder.write("b.toml", scene.text() + "error_estimate = false\n")});
  BOOST_TEST(!contains(none.out, "error"), none.out);
  BOOST_TEST(contains(contents(folder / "b/summary.json"), "left out by output.error_estimate"));
  // The numbers are the same.
  BOOST_TEST(contents(folder / "a/series.csv") == contents(folder / "b/series.csv"));
  BodyN chart{{1, 2, 3, 4}, {0.9, -0.2, 0.3, 0.1, 0.4, -0.5}, "natural_chart"};
  BOOST_TEST(contains(
      left_by(chart.text()).summary,
      "not estimated: it costs more than half of the run; output.error_estimate = true asks for it"));
}

/// A top that turns fast, and comes to be chaotic.
std::string tumbling_top(std::string const& until) {
  return "[system]\nkind = 'heavy_top'\nmass = 1\ninertia = [1.0, 0.9, 0.4]\ncentre_of_mass = [0.3, 0.1, "
         "0.2]\ngravity = [0, 0, -9.81]\n[initial]\nangular_velocity = [1, 2, 3]\n[run]\nuntil = " +
         until + "\nevery = 0.5\n[output]\nquantities = ['attitude', 'body_momentum', 'energy']\n";
}

BOOST_AUTO_TEST_CASE(
    beyond_a_tenth_of_a_radian_it_is_no_number_but_a_sentence_with_the_time_until_which_one_held) {
  Folder const folder;
  std::string const scene = folder.write("top.toml", tumbling_top("90"));
  auto const told = actio({"run", "--out", folder / "out", scene});
  BOOST_TEST(contains(told.out, "; error of attitude: no number after t = "), told.out);
  BOOST_TEST(contains(told.out, "and up to 0.01 tells an error"), told.out);
  std::string const summary = contents(folder / "out/summary.json");
  BOOST_TEST(contains(summary, "\"attitude\": \"no number after t = "), summary);
  std::string const until = summary.substr(summary.find("\"error_until\""));
  double const time = std::stod(until.substr(until.find("\"time\": ") + 8)),
               error = std::stod(until.substr(until.find("\"error\": ") + 9));
  BOOST_TEST((time > 20 && time < 89), until);
  // Until then it is a number.
  auto const earlier =
      actio({"run", "--out", folder / "earlier", "--set", "run.until=" + number(time), scene});
  double const before = figure(contents(folder / "earlier/summary.json"), "error", "attitude");
  BOOST_TEST((before <= 3 * error && before >= error / 3), earlier.out << error);
  // A sweep leaves the cell empty.
  auto const swept =
      actio({"sweep", scene, "--over", "run.until=2,90", "--out", folder / "sweep", "--quiet"});
  BOOST_TEST(swept.status == 0, swept.err);
  BOOST_TEST(!contains(contents(folder / "sweep/sweep.csv"), "nan"), contents(folder / "sweep/sweep.csv"));
}

BOOST_AUTO_TEST_CASE(a_configuration_that_is_asked_for_has_an_error_of_its_own) {
  auto const steady = [](std::string const& method, std::string const& until) {
    return left_by(
        "[system]\nkind = 'euler_poincare'\ngroup = 'SO(3)'\nlagrangian = '(w1^2 + 2*w2^2 + 3*w3^2)/2'\n"
        "[initial]\nvelocity = [0, 0, 2]\n[method]\n" +
        method + "\n[run]\nuntil = " + until + "\nevery = 0.8\n[output]\nquantities = " +
        "['configuration', 'velocity', 'body_momentum', 'energy']\n");
  };
  // Cayley's transform turns by 2 arctan(h v/2) in a step, where v (1 + (h v/2)^2) = 2 is the velocity.
  double const h = 0.02, until = 4.8;
  double v = 2;
  for (int k = 0; k < 100; ++k) v = 2 / (1 + h * h * v * v / 4);
  double const off = until / h * std::abs(2 * std::atan(h * v / 2) - 2 * h),
               told = figure(steady("name = 'cayley_chart'\nstep = 0.02", "4.8").summary, "error",
                             "configuration");
  BOOST_TEST_MESSAGE("a steady turn by Cayley's transform: off by " << off << ", told " << told);
  BOOST_TEST((told > off / 3 && told < 3 * off), told << " of " << off);
  Left const far = steady("name = 'cayley_chart'\nstep = 0.1", "80");
  BOOST_TEST(contains(far.summary, "\"configuration\": \"no number"), far.summary);
  BOOST_TEST(figure(far.summary, "error", "momentum") < 1e-12);
}

BOOST_AUTO_TEST_CASE(a_short_torque_is_not_stepped_over) {
  // It lasts a tenth, in two thousand; and all of it comes at one attitude, nearly.
  auto const scene = [](std::string const& step) {
    return BodyScene{
        "kind = 'rigid_body'\ninertia = [0.64, 0.97, 1.0]\n[system.torque]\n"
        "potential = 'k = 0.8*exp(-((t - 1013.7)/0.1)^2); k*(0.64*r11^2 + 0.97*r12^2 + 1.0*r13^2)'",
        "angular_velocity = [0.0002, 0.0004, 0.001]\nattitude = { axis = [0, 0, 1], degrees = 40 }", step,
        "until = 2000\nevery = 500", "'attitude', 'body_momentum'"};
  };
  Left const found = run(scene("")), fine = run(scene("step = 0.001"));
  BOOST_TEST(found.outcome.status == 0, found.outcome.err);
  Errors const truth = errors_in_space(found.table, fine.table);
  // Without the torque no component exceeds the modulus, 1.1e-3.
  BOOST_TEST(std::abs(found.table["body_momentum_z"].back()) > 5 * 1.1e-3);
  BOOST_TEST_MESSAGE("a pulse: attitude off by " << truth.attitude << ", momentum by " << truth.momentum);
  BOOST_TEST(truth.attitude < 1e-8, truth.attitude);
  BOOST_TEST(truth.momentum < 1e-8, truth.momentum);
  BOOST_TEST(figure(found.summary, "error", "attitude") < 1e-8, found.summary);
  // A step that strides over it is refused, with one that does not.
  Left const stride = run(scene("step = 1"));
  BOOST_TEST(stride.outcome.status == 3);
  BOOST_TEST(contains(stride.outcome.err, "the longest that would do is 0.0"), stride.outcome.err);
}

BOOST_AUTO_TEST_CASE(drift_is_measured_in_a_unit_of_the_quantity_where_that_starts_at_zero) {
  for (auto scene : {wheel(), pendulum()})
    for (bool aside : {false, true}) {
      if (aside)
        scene.initial.insert(0, contains(scene.initial, "attitude")
                                    ? ""
                                    : "attitude = [0.7071067811865475, 0.7071067811865475, 0, 0]\n");
      Left const left = run(scene);
      BOOST_TEST(left.outcome.status == 0, left.outcome.err);
      for (std::string const name : {"energy", "vertical_momentum", "casimir_gamma", "casimir_cross"}) {
        double const drift = figure(left.summary, "drift", name);
        BOOST_TEST((drift >= 0 && drift < 1e-11), name << ": " << drift);
      }
    }
}

BOOST_AUTO_TEST_CASE(a_drift_that_is_real_is_told_as_large_as_it_is) {
  BodyScene scene = pendulum();
  scene.method = "order = 2\nstep = 0.002";
  Left const left = run(scene);
  auto const& t = left.table;
  double difference = 0, unit = 0;
  for (std::size_t row = 0; row < t.rows.size(); ++row) {
    double kinetic = 0;
    for (std::string const c : {"_x", "_y", "_z"})
      kinetic += t["body_momentum" + c][row] * t["angular_velocity" + c][row] / 2;
    difference = std::max(difference, std::abs(t["energy"][row] - t["energy"][0]));
    unit = std::max(unit, kinetic + std::abs(9.81 * t["direction_of_gravity_x"][row]));
  }
  BOOST_TEST_MESSAGE("pendulum, order 2: energy drifts by " << difference / unit);
  BOOST_TEST((difference / unit > 1e-7 && difference / unit < 1e-4), difference / unit);
  BOOST_TEST(figure(left.summary, "drift", "energy") == difference / unit,
             boost::test_tools::tolerance(1e-6));
  BOOST_TEST(figure(left.summary, "drift_units", "energy") == unit, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_step_that_a_top_is_not_meant_for_is_refused_and_a_long_one_remarked_on) {
  BodyScene scene = wheel();
  scene.run = "until = 2\nevery = 0.5";
  for (std::string const step : {"0.5", "0.25", "0.1"}) {
    scene.method = "step = " + step;
    Left const left = run(scene);
    BOOST_TEST(left.outcome.status == 3, step);
    BOOST_TEST(contains(left.outcome.err,
                        "and the scheme is meant for at most 1 rad; the longest that would do is "),
               left.outcome.err);
    std::string const said = left.outcome.err, before = "the largest that meets the rows is ";
    BOOST_REQUIRE(contains(said, before));
    scene.method = "step = " + said.substr(said.find(before) + before.size());
    Left const accepted = run(scene);
    BOOST_TEST(accepted.outcome.status == 0, accepted.outcome.err);
    // It is accepted, and remarked on where a reader looks.
    BOOST_TEST(contains(accepted.outcome.err, "the scheme is accurate"), accepted.outcome.err);
    BOOST_TEST(contains(accepted.summary, "the scheme is accurate"));
  }
  scene.method = "";
  BOOST_TEST(!contains(run(scene).summary, "the scheme is accurate"));
}

BOOST_AUTO_TEST_CASE(rows_at_any_times_are_reached_by_a_shorter_step_of_the_same_scheme) {
  for (BodyScene scene :
       {wheel(),
        BodyScene{"kind = 'rigid_body_n'\nlambda = [0.5, 1, 1.7, 2.9]",
                  "angular_velocity = [0.3, 0.2, -0.4, 0.1, 0.5, 0.2]", "", "", "'attitude', 'momentum'"},
        BodyScene{"kind = 'rigid_body'\ninertia = [1, 2, 3]", "angular_velocity = [0.1, 1, 0.1]",
                  "order = 4\nSTEP", "", "'attitude', 'body_momentum'"},
        BodyScene{"kind = 'rigid_body'\ninertia = [1, 2, 3]", "angular_velocity = [0.1, 1, 0.1]",
                  "name = 'natural_chart'\norder = 4\nSTEP", "", "'body_momentum'"}}) {
    auto const method = [&](std::string const& step) {
      std::string const all = scene.method;
      return contains(all, "STEP") ? all.substr(0, all.find("STEP")) + step : step;
    };
    BodyScene odd = scene, fine = scene;
    odd.method = method(""), odd.run = "at = [0.1, 0.37, 3.14159265, 4]";
    fine.method = method("step = 1e-4"), fine.run = "at = [0.1, 0.37, 3.1415, 4]";
    Left const found = run(odd), truth = run(fine);
    BOOST_TEST(found.outcome.status == 0, found.outcome.err);
    BOOST_TEST(truth.outcome.status == 0, truth.outcome.err);
    BOOST_TEST(
        contains(found.outcome.err, "a shorter step of the same scheme goes to each row between two steps"),
        found.outcome.err);
    BOOST_TEST(contains(found.scene, "between_steps = true"), found.scene);
    BOOST_REQUIRE(found.table.rows.size() == 4u);
    double size = 0;
    for (double const x : truth.table.rows[0]) size = std::max(size, std::abs(x));
    for (std::size_t row : {0u, 1u, 3u})
      BOOST_TEST(apart(found.table.rows[row], truth.table.rows[row]) <= 2e-5 * size,
                 odd.system << ", row " << row);
    // The steps go on as if a row had not been asked for.
    BodyScene fewer = odd;
    fewer.run = "at = [3.14159265, 4]\nbetween_steps = true";
    fewer.method = method("step = " + number(found.table.rows[3][0] / std::ceil(4 / 0.01)));
    odd.method = fewer.method;
    odd.run = "at = [0.1, 0.37, 3.14159265, 4]\nbetween_steps = true";
    Left const few = run(fewer), all = run(odd);
    BOOST_TEST(apart(few.table.rows[1], all.table.rows[3]) <= 1e-12 * size);
    BOOST_TEST(apart(few.table.rows[0], all.table.rows[2]) <= 1e-12 * size);
  }
}

BOOST_AUTO_TEST_SUITE_END()
