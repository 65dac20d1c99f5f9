// Free bodies through the command: a benchmark, the exactness of rows, frames, quaternions, orders, and what
// is refused.
#include <boost/test/unit_test.hpp>

#include "body_scene.hpp"

using command::apart, command::BodyScene, command::contains, command::last;

namespace {
constexpr double eps = 2.220446049250313e-16;

/// A body without symmetry.
BodyScene const tumbling{"kind = 'rigid_body'\ninertia = [0.6, 0.8, 1.0]",
                         "angular_velocity = [0.7, -0.4, 0.5]", "", "until = 10",
                         "'angular_velocity', 'attitude', 'energy'"};

BodyScene with(BodyScene scene, std::string BodyScene::*section, std::string const& text) {
  scene.*section = text;
  return scene;
}
BodyScene of_method(std::string const& method) { return with(tumbling, &BodyScene::method, method); }
}  // namespace

BOOST_AUTO_TEST_SUITE(rigid_body_scene)

BOOST_AUTO_TEST_CASE(the_brick_of_nasa_tumbles_as_published) {
  // Check case 2 of NASA/TM-2015-218675: slug ft^2, degrees per second.
  double const degree = std::acos(-1.0) / 180;
  auto const left =
      command::run({"kind = 'rigid_body'\ninertia = [0.001894220, 0.006211019, 0.007194665]",
                    "angular_velocity = [0.17453292519943295, 0.3490658503988659, 0.5235987755982988]", "",
                    "until = 30", "'angular_velocity'"});
  BOOST_TEST(left.outcome.status == 0, left.outcome.err);
  // The published digits end at 1e-10.
  std::vector<double> in_degrees = last(left);
  for (double& x : in_degrees) x /= degree;
  BOOST_TEST(apart(in_degrees, {12.6183907759, -17.3974747616, 31.1195888869}) <= 1e-10);
}

BOOST_AUTO_TEST_CASE(exact_rows_are_the_same_to_the_bit_whichever_others_are_asked_for) {
  auto const many = command::run(with(tumbling, &BodyScene::run, "until = 10\nevery = 0.1")),
             few = command::run(with(tumbling, &BodyScene::run, "at = [0.1, 7.3, 10]")),
             stepped = command::run(
                 with(of_method("order = 'exact'\nstep = 3.0"), &BodyScene::run, "until = 10\nevery = 0.1"));
  BOOST_TEST(many.table.rows.size() == 101u);
  BOOST_TEST(few.table.rows.size() == 3u);
  // 0.1 * 1 and 0.1 * 100 are the same doubles as 0.1 and 10.
  BOOST_TEST((many.table.rows[1] == few.table.rows[0]));
  BOOST_TEST((many.table.rows[100] == few.table.rows[2]));
  BOOST_TEST((many.table.rows == stepped.table.rows));
}

BOOST_AUTO_TEST_CASE(momenta_alone_are_the_rows_of_the_whole_and_cost_no_attitude) {
  for (std::string const method : {"", "order = 4", "name = 'natural_chart'"}) {
    auto whole = of_method(method), alone = whole;
    whole.quantities = "'angular_velocity', 'attitude'", alone.quantities = "'angular_velocity'";
    auto const a = command::run(whole), b = command::run(alone);
    auto of_whole = last(a);
    of_whole.resize(3);
    // With the attitude the same steps; off the bit only where its restoration and that of the momentum are
    // joined.
    BOOST_TEST(apart(of_whole, last(b)) <= 8 * eps);
    BOOST_TEST(contains(b.summary, "momentum only: no attitude is reconstructed"));
    BOOST_TEST(!contains(a.summary, "momentum only"));
    BOOST_TEST(contains(b.summary, "\"attitude\": 0"));
  }
}

BOOST_AUTO_TEST_CASE(a_full_tensor_tells_the_same_motion_as_its_principal_axes) {
  // Turned by 0.7 about the second axis, and then by 0.4 about the third: R I R^T, with the start turned
  // alike.
  double const c = std::cos(0.7), s = std::sin(0.7), C = std::cos(0.4), S = std::sin(0.4);
  double const R[3][3] = {{C * c, -S, C * s}, {S * c, C, S * s}, {-s, 0, c}}, moments[3] = {0.6, 0.8, 1.0},
               velocity[3] = {0.7, -0.4, 0.5};
  std::string tensor = "inertia = [", start = "angular_velocity = [";
  char number[40];
  for (int i = 0; i < 3; ++i) {
    tensor += "[";
    double w = 0;
    for (int j = 0; j < 3; ++j) {
      double sum = 0;
      for (int k = 0; k < 3; ++k) sum += R[std::min(i, j)][k] * moments[k] * R[std::max(i, j)][k];
      std::snprintf(number, sizeof number, "%.17g,", sum);
      tensor += number, w += R[i][j] * velocity[j];
    }
    std::snprintf(number, sizeof number, "%.17g,", w);
    tensor += "],", start += number;
  }
  auto full = tumbling;
  full.system = "kind = 'rigid_body'\n" + tensor + "]", full.initial = start + "]";
  full.quantities = "'angular_velocity', 'energy', 'spatial_momentum'";
  auto principal = tumbling;
  principal.quantities = full.quantities;
  auto const a = last(command::run(principal)), b = last(command::run(full));
  BOOST_REQUIRE(a.size() == 7u);
  BOOST_REQUIRE(b.size() == 7u);
  std::vector<double> turned(7, 0);
  for (int i = 0; i < 3; ++i)
    // the attitude 1 is that of another frame
    for (int j = 0; j < 3; ++j) turned[i] += R[i][j] * a[j], turned[4 + i] += R[i][j] * a[4 + j];
  turned[3] = a[3];
  // Roundings of the tensor, some ten, times the angle turned.
  BOOST_TEST(apart(turned, b) <= 40 * eps * 10);
}

BOOST_AUTO_TEST_CASE(the_frame_is_that_of_the_inertia_whatever_the_order_of_its_moments) {
  auto diagonal = tumbling;
  diagonal.system = "kind = 'rigid_body'\ninertia = [[1.0, 0, 0], [0, 0.6, 0], [0, 0, 0.8]]";
  auto moments = tumbling;
  moments.system = "kind = 'rigid_body'\ninertia = [1.0, 0.6, 0.8]";
  BOOST_TEST(apart(last(command::run(diagonal)), last(command::run(moments))) <= 40 * eps);
}

BOOST_AUTO_TEST_CASE(
    quaternions_nearly_of_unit_length_are_normalised_and_said_and_others_refused_with_the_remedy) {
  auto near = tumbling, far = tumbling;
  near.initial += "\nattitude = [0.6000000003, 0, 0.8, 0]", far.initial += "\nattitude = [0.6, 0, 0.9, 0]";
  auto const taken = command::run(near), refused = command::run(far);
  BOOST_TEST(taken.outcome.status == 0, taken.outcome.err);
  BOOST_TEST(contains(taken.summary, "normalised"));
  double const length = std::hypot(taken.table["attitude_w"][0], taken.table["attitude_y"][0]);
  BOOST_TEST(std::abs(length - 1) <= 4 * eps);
  BOOST_TEST(refused.outcome.status == 2);
  BOOST_TEST(contains(refused.outcome.err,
                      "scene.toml:6:12: attitude: a unit quaternion is expected; its length is 1.08166"));
  BOOST_TEST(contains(refused.outcome.err, "normalised it is [0.554700196225229"));
}

BOOST_AUTO_TEST_CASE(the_sign_of_the_quaternion_goes_on_from_the_one_given) {
  auto steps = of_method("order = 10\nstep = 0.05"), exact = of_method("order = 'exact'"),
       chart = of_method("name = 'natural_chart'\norder = 6\nstep = 0.05");
  for (auto* scene : {&steps, &exact, &chart})
    scene->quantities = "'attitude'", scene->run = "until = 100\nevery = 0.5",
    scene->initial += "\nattitude = [-1, 0, 0, 0]";
  for (auto const& scene : {steps, exact, chart}) {
    auto const left = command::run(scene);
    BOOST_REQUIRE(left.table.rows.size() == 201u);
    BOOST_TEST(left.table["attitude_w"][0] == -1);
    bool changes_sign = false;
    for (std::size_t k = 1; k < 201; ++k) {
      // Half a time unit turns the body by less than half a radian, the quaternion by less than a quarter.
      auto const &now = left.table.rows[k], &before = left.table.rows[k - 1];
      BOOST_TEST(apart({now.begin() + 1, now.end()}, {before.begin() + 1, before.end()}) < 0.3);
      changes_sign = changes_sign || now[1] > 0.5;
    }
    BOOST_TEST(changes_sign);
  }
}

BOOST_AUTO_TEST_CASE(orders_are_those_that_are_asked_for) {
  auto const truth = last(command::run(tumbling));
  auto const errors = [&](std::string const& method, double h) {
    std::vector<double> out;
    for (int k = 0; k < 3; ++k, h /= 2)
      out.push_back(apart(last(command::run(of_method(method + "\nstep = " + std::to_string(h)))), truth));
    return out;
  };
  for (auto const& [method, order, h] : {std::tuple("order = 2", 2, 0.125),
                                         {"order = 4", 4, 0.25},
                                         {"order = 6", 6, 0.5},
                                         {"order = 8", 8, 0.5},
                                         {"order = 10", 10, 1.0},
                                         {"name = 'natural_chart'\norder = 2", 2, 0.125},
                                         {"name = 'natural_chart'\norder = 4", 4, 0.25},
                                         {"name = 'natural_chart'\norder = 6", 6, 0.5}}) {
    double const measured = command::order_of(errors(method, h));
    BOOST_TEST_MESSAGE(method << ": measured order " << measured);
    BOOST_TEST(std::abs(measured - order) < 0.3, method << " shows " << measured);
  }
}

BOOST_AUTO_TEST_CASE(defaults_are_written_back_and_make_the_same_run) {
  auto scene = tumbling;
  scene.run = "until = 9\nevery = 0.7";
  scene.method = "order = 2";
  auto const first = command::run(scene);
  BOOST_TEST(first.outcome.status == 0, first.outcome.err);
  command::Folder const folder;
  auto const again =
      command::actio({"run", "--quiet", "--out", folder / "again", folder.write("again.toml", first.scene)});
  BOOST_TEST(again.status == 0, again.err);
  BOOST_TEST((command::read_csv(folder / "again/series.csv").rows == first.table.rows));
  BOOST_TEST(
      contains(command::run(tumbling).scene, "name = \"moser_veselov\"\norder = \"exact\"\nstep = 0.0"));
}

BOOST_AUTO_TEST_CASE(orders_that_no_method_has_are_refused_with_those_it_has) {
  for (std::string const order : {"3", "12", "0", "-2", "'4'", "'exct'"}) {
    auto const left = command::run(of_method("order = " + order));
    BOOST_TEST(left.outcome.status == 2);
    BOOST_TEST(contains(left.outcome.err,
                        "scene.toml:7:9: order: moser_veselov takes 2, 4, 6, 8, 10 or \"exact\", found "),
               left.outcome.err);
  }
  auto const chart = command::run(of_method("name = 'natural_chart'\norder = 'exact'"));
  BOOST_TEST(chart.outcome.status == 2);
  BOOST_TEST(
      contains(chart.outcome.err, "scene.toml:8:9: order: natural_chart takes 2, 4 or 6, found \"exact\""),
      chart.outcome.err);
}

BOOST_AUTO_TEST_CASE(a_step_that_is_too_long_is_refused_with_one_that_does) {
  for (std::string const method : {"order = 2", "order = 4", "order = 6", "order = 10",
                                   "name = 'natural_chart'", "name = 'natural_chart'\norder = 6"}) {
    auto const left = command::run(of_method(method + "\nstep = 10"));
    BOOST_TEST(left.outcome.status == 3, left.outcome.err);
    BOOST_TEST(contains(left.outcome.err, method.find('\n') == std::string::npos ? "scene.toml:8:8: step: "
                                                                                 : "scene.toml:9:8: step: "),
               left.outcome.err);
    BOOST_TEST(contains(left.outcome.err, "measured 10, bound "));
    std::string const words = "the largest that meets the rows is ";
    auto const at = left.outcome.err.find(words);
    BOOST_REQUIRE(at != std::string::npos);
    auto const retry =
        command::run(of_method(method + "\nstep = " + left.outcome.err.substr(at + words.size())));
    BOOST_TEST(retry.outcome.status == 0, retry.outcome.err);
  }
  BOOST_TEST(command::run(of_method("order = 'exact'\nstep = 1e300")).outcome.status == 0);
}

BOOST_AUTO_TEST_CASE(a_body_that_none_can_be_is_pointed_at) {
  auto const of_inertia = [](std::string const& inertia) {
    return command::run(with(tumbling, &BodyScene::system, "kind = 'rigid_body'\ninertia = " + inertia))
        .outcome;
  };
  auto const triangle = of_inertia("[1.0, 1.0, 2.5]");
  BOOST_TEST(triangle.status == 2);
  BOOST_TEST(contains(triangle.err, "scene.toml:3:11: inertia: I_3 must not exceed the sum of the other two"),
             triangle.err);
  BOOST_TEST(contains(triangle.err, "measured 0.2, bound "));
  BOOST_TEST(of_inertia("[1.0, 1.0, -1.0]").status == 2);
  BOOST_TEST(of_inertia("[0.0, 0.0, 0.0]").status == 2);
  auto const skew = of_inertia("[[1, 0.1, 0], [0, 1, 0], [0, 0, 1]]");
  BOOST_TEST(skew.status == 2);
  BOOST_TEST(contains(skew.err, "a tensor of inertia is symmetric"), skew.err);
}

BOOST_AUTO_TEST_CASE(extremes_give_an_answer_or_a_reason) {
  for (std::string const inertia : {"1e-300", "1e-47", "1", "1e8", "1e300"})
    for (std::string const velocity : {"0", "1e-300", "1e-12", "1", "1e12", "1e300"})
      for (std::string const method : {"", "order = 2", "order = 10", "name = 'natural_chart'"}) {
        BodyScene const scene{
            "kind = 'rigid_body'\ninertia = [" + inertia + "," + inertia + "," + inertia + "]",
            "angular_velocity = [" + velocity + ", 0, " + velocity + "]", method, "until = 1e-10",
            "'angular_velocity', 'attitude', 'spatial_momentum', 'energy', 'casimir'"};
        auto const left = command::run(scene);
        bool const answered = left.outcome.status == 0,
                   told = (left.outcome.status == 2 || left.outcome.status == 3) && !left.outcome.err.empty();
        BOOST_TEST((answered || told), inertia << ", " << velocity << ": status " << left.outcome.status
                                               << " " << left.outcome.err);
        if (!answered) continue;
        BOOST_TEST(!contains(left.summary, "nan"));
        double const w = std::stod(velocity), found = last(left)[0], half = w * 1e-10 / std::sqrt(2.0);
        BOOST_TEST(std::abs(found - w) <= 8 * eps * w);
        // A sphere turns steadily, whatever the method but for its order.
        if (method.empty()) BOOST_TEST(std::abs(last(left)[3] - std::cos(half)) <= 8 * eps * (1 + half));
      }
}

BOOST_AUTO_TEST_CASE(long_runs_say_what_rounding_leaves_of_the_angle) {
  auto const far = command::run(with(tumbling, &BodyScene::run, "until = 1e12")),
             too_far = command::run(with(tumbling, &BodyScene::run, "until = 1e17"));
  BOOST_TEST(far.outcome.status == 0, far.outcome.err);
  BOOST_TEST(contains(far.summary, "rounding leaves an error of about 0.0002 rad"));
  BOOST_TEST(too_far.outcome.status == 3);
  BOOST_TEST(contains(too_far.outcome.err, "no digit of the angle is left"), too_far.outcome.err);
}

BOOST_AUTO_TEST_CASE(shortcuts_are_named_where_they_are_taken) {
  auto const of_inertia = [](std::string const& inertia) {
    return command::run(with(tumbling, &BodyScene::system, "kind = 'rigid_body'\ninertia = " + inertia))
        .summary;
  };
  BOOST_TEST(contains(of_inertia("[1, 1, 1.5]"), "axisymmetric body: closed form"));
  BOOST_TEST(contains(of_inertia("[1, 1, 1]"), "sphere: "));
  BOOST_TEST(!contains(of_inertia("[1, 1, 1]"), "axisymmetric"));
  BOOST_TEST(!contains(of_inertia("[0.6, 0.8, 1]"), "closed form"));
  BOOST_TEST(contains(of_inertia("[0.6, 0.8, 1]"),
                      "exact: rows are evaluated where they are asked for; the step is not used"));
  BOOST_TEST(!contains(command::run(of_method("order = 4")).summary, "exact:"));
}

BOOST_AUTO_TEST_SUITE_END()
