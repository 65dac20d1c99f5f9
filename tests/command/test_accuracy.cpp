// Steps by accuracy: the true error of what is chosen, copies of scenes, refusals.
#include <boost/test/unit_test.hpp>

#include "true_error.hpp"

namespace {

using namespace command;

/// A system whose motion is known otherwise: in closed form, or by a higher order with short steps.
struct Known {
  std::string name;
  BodyScene scene;    // its [method] without order and step
  std::string truth;  // [method]
  char const* turn = "attitude";
  int n = 3;
};

std::string body_of_four() { return "kind = 'rigid_body_n'\nlambda = [1, 2, 3, 4]"; }

std::vector<Known> known_systems() {
  std::string const run = "until = 20\nevery = 5", state = "'attitude', 'body_momentum'";
  BodyScene const free{"kind = 'rigid_body'\ninertia = [1, 1.7, 2.1]", "angular_velocity = [0.6, 1.2, -0.9]",
                       "name = 'natural_chart'", run, state};
  BodyScene orbit = free;
  orbit.system +=
      "\n[system.torque]\ngravity_gradient = { rate = 0.3, direction = [1, 0, 0], normal = [0, 0, 1] }";
  orbit.method = "";
  return {
      {"free body", free, "order = 'exact'"},
      {"body in orbit", orbit, "order = 4\nstep = 0.001"},
      {"heavy top",
       {"kind = 'heavy_top'\nmass = 1\ninertia = [1, 1.2, 0.5]\ncentre_of_mass = [0.1, 0, 0.4]\n"
        "gravity = [0, 0, -1]",
        "angular_velocity = [0.5, 0.3, 2]", "", run, state},
       "order = 4\nstep = 0.001"},
      {"body in four dimensions",
       {body_of_four(), "angular_velocity = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]", "", run,
        "'attitude', 'momentum'"},
       "order = 6\nstep = 0.005",
       "attitude",
       4},
      {"Lagrangian on SE(3)",
       {"kind = 'euler_poincare'\ngroup = 'SE(3)'\n"
        "lagrangian = '(w1^2 + 2*w2^2 + 2.5*w3^2 + v1^2 + 1.5*v2^2 + 2*v3^2)/2 + 0.2*w1*v2'",
        "velocity = [0.5, 0.4, -0.3, 0.6, -0.2, 0.3]", "", "until = 8\nevery = 4",
        "'configuration', 'body_momentum'"},
       "name = 'galerkin'\norder = 10\nstep = 0.05",
       "configuration",
       4},
  };
}

/// [method] of a copy of a scene, with so many times the step.
std::string method_of(std::string const& copy, double times) {
  std::size_t const begin = copy.find("[method]\n") + 9, end = copy.find("\n\n", begin),
                    step = copy.find("step = ", begin);
  BOOST_REQUIRE(step < end);
  return copy.substr(begin, step - begin) + "step = " + number(times * std::stod(copy.substr(step + 7)));
}

std::string with_accuracy(BodyScene scene, std::string const& accuracy) {
  scene.run += "\naccuracy = " + accuracy;
  return scene.text();
}

Outcome said_by(std::string const& scene) {
  Folder const folder;
  Outcome out = actio({"run", "--quiet", "--out", folder / "out", folder.write("scene.toml", scene)});
  for (std::string const name = folder / "scene.toml"; contains(out.err, name);)
    out.err.replace(out.err.find(name), name.size(), "scene.toml");
  return out;
}
void check_said(std::string const& scene, std::string const& message) {
  Outcome const out = said_by(scene);
  BOOST_TEST(out.status == 2, out.err);
  BOOST_TEST(contains(out.err, message), out.err);
}

BodyScene top() { return known_systems()[2].scene; }

}  // namespace

BOOST_AUTO_TEST_SUITE(accuracy)

// The error is smaller than was asked, but not by more than a hundred times, unless longer steps have none
// that can be told.
BOOST_AUTO_TEST_CASE(the_true_error_is_at_most_what_was_asked_and_not_much_less) {
  int near = 0;
  for (auto const& known : known_systems()) {
    BodyScene exact = known.scene;
    exact.method = known.truth;
    Left const truth = run(exact);
    BOOST_REQUIRE_MESSAGE(truth.outcome.status == 0, known.name << ": " << truth.outcome.err);
    for (std::string const accuracy : {"1e-4", "1e-6", "1e-8", "1e-10"}) {
      BodyScene scene = known.scene;
      scene.run += "\naccuracy = " + accuracy;
      Left const found = run(scene);
      BOOST_TEST(found.outcome.status == 0, known.name << ": " << found.outcome.err);
      double error = 0;
      for (std::string const name : {known.turn, "momentum"})
        error = std::max(error, error_of(name, known.n, found.table, truth.table, HUGE_VAL));
      double const asked = std::stod(accuracy);
      BOOST_TEST_MESSAGE(known.name << ": asked " << accuracy << ", true error " << error << "; "
                                    << found.outcome.err);
      BOOST_TEST(error <= asked, known.name << ", " << accuracy << ": " << error);
      BOOST_TEST(!contains(found.summary, "was asked"), found.summary);
      if (error >= asked / 100) {
        ++near;
        continue;
      }
      bool told_of_all = true;
      scene.run = known.scene.run + "\nbetween_steps = true";
      for (double const times : {1.25, 1.5, 1.75, 2.0})
        scene.method = method_of(found.scene, times),
        told_of_all = told_of_all && !contains(run(scene).summary, "\"no number");
      BOOST_TEST(!told_of_all, known.name << ", " << accuracy << ": " << error << "\n" << found.scene);
    }
  }
  BOOST_TEST(near >= 14, near << " of 20 within a hundred times");
}

BOOST_AUTO_TEST_CASE(the_copy_of_the_scene_has_order_and_step_and_makes_the_same_table) {
  Folder const folder;
  std::string const scene = folder.write("top.toml", with_accuracy(top(), "1e-7"));
  auto const out = actio({"run", scene, "--out", folder / "a"});
  BOOST_TEST(out.status == 0, out.err);
  BOOST_TEST(contains(out.err, " of order "), out.err);
  std::string const copy = contents(folder / "a/scene.toml");
  for (char const* const line : {"order = 4", "step = 0.", "accuracy = 1e-07", "chosen_for = 1e-07"})
    BOOST_TEST(contains(copy, line), copy);
  BOOST_TEST(actio({"run", folder / "a/scene.toml", "--out", folder / "b"}).status == 0);
  BOOST_TEST(contents(folder / "a/series.csv") == contents(folder / "b/series.csv"));
  BOOST_TEST(contents(folder / "b/scene.toml") == copy);
  // The scene itself chooses the same.
  BOOST_TEST(actio({"run", scene, "--out", folder / "c"}).status == 0);
  BOOST_TEST(contents(folder / "c/scene.toml") == copy);
  auto const plan = actio({"run", scene, "--dry-run"});
  BOOST_TEST(contains(plan.out, " estimated"), plan.out);

  auto const other =
      actio({"run", folder / "a/scene.toml", "--set", "run.accuracy=1e-8", "--out", folder / "d"});
  BOOST_TEST(other.status == 2);
  BOOST_TEST(contains(other.err, "was chosen for an accuracy of 1e-07, and 1e-08 is asked"), other.err);
  auto const anew = actio({"run", folder / "a/scene.toml", "--set", "run.accuracy=1e-8", "--unset",
                           "method.step", "--out", folder / "d"});
  BOOST_TEST(anew.status == 0, anew.err);

  // To a later time with the same step; with another one it is no run of that accuracy.
  BOOST_TEST(actio({"resume", folder / "a", "--until", "25"}).status == 0);
  BOOST_TEST(contains(contents(folder / "a/scene.toml"), "chosen_for"));
  auto const shorter = actio({"resume", folder / "a", "--until", "30", "--step", "0.01"});
  BOOST_TEST(shorter.status == 0, shorter.err);
  BOOST_TEST(!contains(contents(folder / "a/scene.toml"), "chosen_for"), contents(folder / "a/scene.toml"));
}

BOOST_AUTO_TEST_CASE(an_order_or_a_method_that_is_given_stays) {
  BodyScene scene = top();
  scene.method = "order = 2";
  Left const low =
      run({scene.system, scene.initial, scene.method, scene.run + "\naccuracy = 1e-4", scene.quantities});
  BOOST_TEST(low.outcome.status == 0, low.outcome.err);
  BOOST_TEST(contains(low.outcome.err, "order 2 with steps of"), low.outcome.err);
}

BOOST_AUTO_TEST_CASE(an_exact_method_meets_any) {
  BodyScene scene = known_systems()[0].scene;
  scene.method = "", scene.run += "\naccuracy = 1e-16";
  Left const free = run(scene);
  BOOST_TEST(free.outcome.status == 0, free.outcome.err);
  BOOST_TEST(contains(free.outcome.err, "accuracy 1e-16: the method is exact"), free.outcome.err);
  BOOST_TEST(contains(free.scene, "order = \"exact\""), free.scene);
}

BOOST_AUTO_TEST_CASE(members_of_a_sweep_choose_each_for_themselves) {
  Folder const folder;
  std::string const scene = folder.write("top.toml", with_accuracy(top(), "1e-7"));
  auto const out = actio({"sweep", scene, "--over", "run.accuracy=1e-6,1e-12", "--out", folder / "out"});
  BOOST_TEST(out.status == 0, out.err);
  auto const steps = [&](std::string const& member) {
    std::string const text = contents(folder / ("out/" + member + "/scene.toml"));
    return std::stod(text.substr(text.find("\nstep = ") + 8));
  };
  BOOST_TEST(steps("000001") < steps("000000") / 4);
}

BOOST_AUTO_TEST_CASE(a_run_that_is_worse_than_was_asked_says_so) {
  BodyScene scene = top();
  scene.method = "order = 4\nstep = 0.125", scene.run += "\naccuracy = 1e-9\nchosen_for = 1e-9";
  Left const found = run(scene);
  BOOST_TEST(found.outcome.status == 0, found.outcome.err);
  BOOST_TEST(contains(found.outcome.err, "accuracy: 1e-09 was asked, and the error of the "),
             found.outcome.err);
  BOOST_TEST(contains(found.summary, "accuracy: 1e-09 was asked"), found.summary);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_met_is_refused) {
  BodyScene scene = top();
  check_said(with_accuracy(scene, "1e-15"), "rounding alone adds up to");
  // A top that falls over and over: neighbouring motions part.
  scene.initial = "angular_velocity = [0.5, 0.3, 0.2]", scene.run = "until = 2000";
  check_said(with_accuracy(scene, "1e-9"), "it would be met until about t = ");
  scene = top();
  for (char const* const bad : {"0", "-1e-9", "0.2", "nan", "inf", "'small'"}) {
    Outcome const out = said_by(with_accuracy(scene, bad));
    BOOST_TEST(out.status == 2, bad << ": " << out.err);
    BOOST_TEST(contains(out.err, "accuracy: "), out.err);
    BOOST_TEST_MESSAGE(out.err);
  }
  scene.method = "step = 0.01";
  check_said(with_accuracy(scene, "1e-9"), "it chooses the step, and method.step = 0.01 is given");
  scene = top(), scene.run += "\nchosen_for = 1e-9";
  check_said(scene.text(), "it goes with run.accuracy, which is missing");
}

BOOST_AUTO_TEST_SUITE_END()
