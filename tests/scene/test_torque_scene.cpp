// Scenes of bodies under a torque, against solutions by somebody else's code and against closed forms.
#include <boost/test/unit_test.hpp>

#include <Eigen/Geometry>

#include <cmath>
#include <complex>
#include <numbers>

#include "last_row.hpp"
#include "program/systems/bodies/formula_potential.hpp"
#include "refusal.hpp"
#include "witness/reference_solution.hpp"

using namespace actio::scene;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

std::vector<double> last_row(std::string const& system, std::string const& initial, std::string const& rest) {
  return last_row(SceneFile::parse("[system]\nkind = \"rigid_body\"\n" + system + "\n[initial]\n" + initial +
                                       "\n[output]\nquantities = [\"attitude\", \"angular_velocity\"]\n" +
                                       rest,
                                   "torque.toml"));
}

using Seven = actio::Vector<double, 7>;

/// Attitude and angular velocity of a body under a torque, a function (R, t) -> tau in the frame of the body.
template <class Torque>
Seven solved(Matrix3d const& inertia, Seven const& start, double until, Torque const& torque) {
  Matrix3d const inverse = inertia.inverse();
  return actio::reference_solution(
      [&](double t, Seven const& y) {
        Vector3d const w = y.tail<3>(), q = y.segment<3>(1), M = inertia * w;
        Matrix3d const R = Eigen::Quaterniond(y[0], y[1], y[2], y[3]).normalized().toRotationMatrix();
        Seven change;
        change << -0.5 * q.dot(w), 0.5 * (y[0] * w + q.cross(w)), inverse * (M.cross(w) + torque(R, t));
        return change;
      },
      start, 0, until);
}
/// The largest difference; quaternions of either sign.
double apart(std::vector<double> const& row, Seven y) {
  double dot = 0, most = 0;
  for (std::size_t i = 0; i < 4; ++i) dot += row[i] * y[static_cast<long>(i)];
  if (dot < 0) y.head<4>() = Eigen::Vector4d(-y.head<4>());
  for (std::size_t i = 0; i < 7; ++i) most = std::max(most, std::abs(row[i] - y[static_cast<long>(i)]));
  return most;
}

Matrix3d const tensor = (Matrix3d() << 0.9, 0.1, -0.05, 0.1, 1.1, 0.15, -0.05, 0.15, 1.4).finished();
std::string const in_tensor = "inertia = [[0.9, 0.1, -0.05], [0.1, 1.1, 0.15], [-0.05, 0.15, 1.4]]\n";
Seven start() {
  Seven y;
  y << 0.5, 0.5, -0.5, 0.5, 0.3, -0.2, 0.4;
  return y;
}
std::string const started = "attitude = [0.5, 0.5, -0.5, 0.5]\nangular_velocity = [0.3, -0.2, 0.4]";

}  // namespace

BOOST_AUTO_TEST_SUITE(torque_scenes)

BOOST_AUTO_TEST_CASE(the_gradient_of_gravity_on_an_orbit_is_that_of_a_solver) {
  Vector3d const normal = Vector3d(0, 0.6, 0.8), towards = Vector3d(2, -0.8, 0.6).normalized();
  double const rate = 0.7, strength = 0.8;
  auto const torque = [&](Matrix3d const& R, double t) {
    Vector3d const n = R.transpose() * (Eigen::AngleAxisd(rate * t, normal) * towards);
    return Vector3d(3 * strength * n.cross(tensor * n));
  };
  auto const found = last_row(in_tensor +
                                  "[system.torque.gravity_gradient]\nrate = 0.7\nstrength = 0.8\n"
                                  "direction = [2, -0.8, 0.6]\nnormal = [0, 0.6, 0.8]",
                              started, "[method]\nstep = 0.005\n[run]\nuntil = 12");
  double const off = apart(found, solved(tensor, start(), 12, torque));
  BOOST_TEST_MESSAGE("gravity gradient on an orbit: off by " << off);
  BOOST_TEST(off <= 1e-10);
}

BOOST_AUTO_TEST_CASE(a_direction_that_stands_still_is_the_limit_of_one_that_turns) {
  Vector3d const towards = Vector3d(1, 2, -1).normalized();
  auto const torque = [&](Matrix3d const& R, double) {
    Vector3d const n = R.transpose() * towards;
    return Vector3d(3 * 0.5 * n.cross(tensor * n));
  };
  auto const found =
      last_row(in_tensor + "[system.torque]\ngravity_gradient = { strength = 0.5, direction = [1, 2, -1] }",
               started, "[method]\nstep = 0.005\n[run]\nuntil = 12");
  BOOST_TEST(apart(found, solved(tensor, start(), 12, torque)) <= 1e-10);
}

// In the plane of the orbit the angle phi from the direction to the centre obeys the equation of a pendulum,
// (2 phi)'' = -w^2 sin(2 phi) with w = n sqrt(3 (I_2 - I_1)/I_3), the frequency of small swings. So from
// phi_0, at rest there, it comes back after 4 K(sin phi_0)/w, K the complete elliptic integral.
BOOST_AUTO_TEST_CASE(a_satellite_librates_with_the_period_of_a_pendulum) {
  double const n = 0.25, pi = std::numbers::pi;
  for (double const degrees : {0.01, 30.0, 80.0}) {
    double const phi = degrees * pi / 180, frequency = n * std::sqrt(3 * (9.5 - 1) / 10),
                 period = 4 * std::comp_ellint_1(std::sin(phi)) / frequency;
    if (degrees < 1) BOOST_TEST(period == 2 * pi / frequency, boost::test_tools::tolerance(1e-8));
    std::ostringstream step, until;
    step.precision(17), until.precision(17);
    step << period / 2000, until << period;
    auto const found = last_row(
        "inertia = [1, 9.5, 10]\n[system.torque]\n"
        "gravity_gradient = { rate = 0.25, direction = [1, 0, 0], normal = [0, 0, 1] }",
        "angular_velocity = [0, 0, 0.25]\n[initial.attitude]\naxis = [0, 0, 1]\ndegrees = " +
            std::to_string(degrees),
        "[method]\nstep = " + step.str() + "\n[run]\nuntil = " + until.str());
    double const turned = (phi + n * period) / 2;
    Seven expected;
    expected << std::cos(turned), 0, 0, std::sin(turned), 0, 0, n;
    double const off = apart(found, expected);
    BOOST_TEST_MESSAGE("libration by " << degrees << " degrees: after a period off by " << off);
    BOOST_TEST(off <= 1e-10 * (1 + phi));
  }
}

BOOST_AUTO_TEST_CASE(a_potential_of_ones_own_has_its_exact_torque) {
  // Its derivative along turns about the axes of the body, by hand: of r33^4 it is 4 r33^3 (r32, -r31, 0),
  // and so on.
  auto const torque = [](Matrix3d const& R, double t) {
    double const quartic = -2 * std::pow(R(2, 2), 3), wave = 0.7 * std::cos(3 * t);
    Vector3d const down = quartic * Vector3d(R(2, 1), -R(2, 0), 0),
                   side = wave * Vector3d(-R(0, 2), 0, R(0, 0));
    return Vector3d(down + side);
  };
  auto const found =
      last_row(in_tensor + "[system.torque]\npotential = \"a = 0.5; -a*r33^4 + 7/10*cos(3*t)*r12\"", started,
               "[method]\nstep = 0.005\n[run]\nuntil = 12");
  double const off = apart(found, solved(tensor, start(), 12, torque));
  BOOST_TEST_MESSAGE("a potential in time: off by " << off);
  BOOST_TEST(off <= 1e-9);
}

// The scene solves Kepler's equation; here the way of Apophis comes from Newton's equation, from the nearest
// point back to the start and on again.
BOOST_AUTO_TEST_CASE(apophis_passes_the_earth_as_by_newtons_law) {
  using Four = actio::Vector<double, 4>;
  // The unit of length is the least distance, so that no component is large beside the others.
  double const hour = 3600, nearest = 38012, mu = 398600.4418 * hour * hour / (nearest * nearest * nearest),
               far = 5.84 * hour / nearest;
  auto const fall = [mu](double, Four const& y) {
    double const r = y.head<2>().norm();
    Four change;
    change << y.tail<2>(), -mu / (r * r * r) * y.head<2>();
    return change;
  };
  Four pericentre;
  pericentre << 1, 0, 0, std::sqrt(far * far + 2 * mu);
  Four const begin = actio::reference_solution(fall, pericentre, 30, 0);

  using Eleven = actio::Vector<double, 11>;
  Vector3d const moments(0.64, 0.97, 1), axis = Vector3d(0.6, 1, 0).normalized();
  Eleven y;
  y << std::cos(std::numbers::pi / 6), std::sin(std::numbers::pi / 6) * axis, 0.06490079731, 0, 0.2232090597,
      begin;
  Eleven const end = actio::reference_solution(
      [&](double t, Eleven const& s) {
        Vector3d const w = s.segment<3>(4), q = s.segment<3>(1), M = moments.cwiseProduct(w);
        Matrix3d const R = Eigen::Quaterniond(s[0], s[1], s[2], s[3]).normalized().toRotationMatrix();
        double const r = s.segment<2>(7).norm();
        Vector3d const n = R.transpose() * Vector3d(s[7] / r, s[8] / r, 0);
        Vector3d const torque = 3 * mu / (r * r * r) * n.cross(moments.cwiseProduct(n));
        Eleven change;
        change << -0.5 * q.dot(w), 0.5 * (s[0] * w + q.cross(w)),
            (M.cross(w) + torque).cwiseQuotient(moments), fall(t, s.tail<4>());
        return change;
      },
      y, 0, 60);
  auto const found = last_row(SceneFile::read(ACTIO_DATA "/scenes/earth_flyby.toml",
                                              {"output.quantities=[\"attitude\", \"angular_velocity\"]"}));
  double const off = apart(found, end.head<7>());
  BOOST_TEST_MESSAGE("Apophis passes the Earth: off by " << off);
  BOOST_TEST(off <= 1e-10);
}

BOOST_AUTO_TEST_CASE(second_derivatives_of_a_formula_are_along_turns) {
  FormulaPotential const potential("r33^4*cos(2*t) - 0.7*r12*exp(r21) + sin(3*t)*r11*r23", {{"test"}, false});
  Eigen::Quaterniond const q = Eigen::Quaterniond(1, 0.2, 0.3, -0.4).normalized();
  double const t = 0.6, small = 1e-4;
  auto const value = [&](Eigen::Vector3d const& turn, double time) {
    Eigen::Quaterniond const p =
        turn.norm() > 0 ? q * Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized())) : q;
    actio::bodies::NineEntries slope;
    return potential(actio::bodies::rotation_entries({p.w(), p.x(), p.y(), p.z()}), time, slope);
  };
  actio::bodies::NineEntries const rotation = actio::bodies::rotation_entries({q.w(), q.x(), q.y(), q.z()});
  Matrix3d const K = potential.curvature(rotation, t);
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      Vector3d const x = small * Vector3d::Unit(a), y = small * Vector3d::Unit(b);
      // (V(x + y) - V(x - y) - V(y - x) + V(-x - y))/4
      double const second = (value(x + y, t) - value(x - y, t) - value(y - x, t) + value(-x - y, t)) / 4;
      BOOST_TEST(std::abs(K(a, b) - second / (small * small)) <= 1e-6);
    }
  double const bend = (value({0, 0, 0}, t + small) - 2 * value({0, 0, 0}, t) + value({0, 0, 0}, t - small));
  BOOST_TEST(std::abs(potential.change(rotation, 2 * t, 0).bend - std::abs(bend) / (small * small)) <= 1e-6);
  BOOST_TEST(potential.uses_time());
  BOOST_TEST(potential.axis() == -1);
  BOOST_TEST(FormulaPotential("2*r21 - r23^2", {{"test"}, false}).axis() == 1);
}

BOOST_AUTO_TEST_CASE(the_default_step_of_a_formula_is_about_that_of_the_same_torque_with_a_name) {
  auto const step = [](std::string const& torque, std::string const& velocity) {
    return Scene::read(SceneFile::parse(
                           "[system]\nkind = \"rigid_body\"\ninertia = [0.7, 1.1, 0.9]\n[system.torque]\n" +
                               torque + "\n[initial]\nangular_velocity = " + velocity +
                               "\n[run]\nuntil = 1000\n[output]\nquantities = [\"energy\"]\n",
                           "step.toml"))
        .simulation.step;
  };
  for (auto const& [named, own] :
       {std::pair("uniform_gravity = { mass = 2, lever = [0, 0, 0.5], acceleration = [0, 0, -9] }",
                  "potential = \"9*r33\""),
        {"gravity_gradient = { strength = 4, direction = [1, 0, 0] }",
         "potential = \"6*(0.7*r11^2 + 1.1*r12^2 + 0.9*r13^2)\""},
        {"gravity_gradient = { rate = 2, direction = [1, 0, 0], normal = [0, 0, 1] }",
         "potential = \"c = cos(2*t); s = sin(2*t); 6*(0.7*(c*r11 + s*r21)^2 + 1.1*(c*r12 + "
         "s*r22)^2 + 0.9*(c*r13 + s*r23)^2)\""}})
    for (auto const* const velocity : {"[0, 0, 0]", "[1, 2, 20]"}) {
      double const ratio = step(own, velocity) / step(named, velocity);
      BOOST_TEST((ratio > 0.5 && ratio < 2), own << " from " << velocity << ": " << ratio);
    }
}

// w_3 grows in proportion to the time, and w_1 + i w_2 turns at the rate lambda w_3.
BOOST_AUTO_TEST_CASE(a_motor_about_the_axis_of_symmetry_turns_the_others_as_the_closed_form_has_it) {
  double const I = 1.3, I3 = 0.8, M3 = 0.4, until = 3;
  std::complex<double> const i(0, 1), before(0.7, -0.3);
  double const lambda = (I3 - I) / I, phase = lambda * (1.1 * until + M3 * until * until / (2 * I3));
  auto const truth = before * std::exp(i * phase);
  for (char const* const order : {"2", "4"}) {
    auto const row = last_row(
        "inertia = [1.3, 1.3, 0.8]\n[system.torque]\nbody = [0, 0, \"motor\"]\n"
        "parameters = { motor = 0.4 }",
        "angular_velocity = [0.7, -0.3, 1.1]",
        std::string("[method]\norder = ") + order + "\nstep = 0.05\n[run]\nuntil = 3");
    // Over a drift w_3 is the mean of that at both ends, so that the phase has no error but rounding.
    BOOST_TEST(std::abs(row[4] - truth.real()) < 1e-13);
    BOOST_TEST(std::abs(row[5] - truth.imag()) < 1e-13);
    BOOST_TEST(std::abs(row[6] - (1.1 + M3 * until / I3)) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(a_torque_of_formulas_beside_a_potential_has_its_order_in_any_frame) {
  Matrix3d const inverse = tensor.inverse();
  // Drag, a torque that depends on the attitude, one in time, and the weight of the body.
  auto const equations = [&](double t, Seven const& y) {
    Vector3d const w = y.tail<3>(), q = y.segment<3>(1), M = tensor * w;
    Matrix3d const R = Eigen::Quaterniond(y[0], y[1], y[2], y[3]).normalized().toRotationMatrix();
    Vector3d const own(-0.2 * w[0] - 0.1 * w[0] * w[1], -0.3 * w[1] * w[1] + 0.2 * R(2, 0),
                       0.3 * std::cos(2 * t)),
        weight = Vector3d(0.1, -0.15, 0.2).cross(R.transpose() * Vector3d(0, 0, -1.5));
    Seven change;
    change << -0.5 * q.dot(w), 0.5 * (y[0] * w + q.cross(w)), inverse * (M.cross(w) + own + weight);
    return change;
  };
  Seven const truth = actio::reference_solution(equations, start(), 0, 2);
  std::string const torque =
      "[system.torque]\n"
      "uniform_gravity = { mass = 1.5, lever = [0.1, -0.15, 0.2], acceleration = [0, 0, -1] }\n"
      "body = [\"-c*w1 - 0.1*w1*w2\", \"-0.3*w2^2 + tilt\", \"jet\"]\nparameters = { c = 0.2 }\n"
      "definitions = { tilt = \"c*r31\", jet = \"0.3*cos(2*t)\" }";
  for (int const order : {2, 4}) {
    std::vector<double> errors;
    for (char const* const step : {"0.05", "0.025", "0.0125"})
      errors.push_back(apart(
          last_row(in_tensor + torque, started,
                   "[method]\norder = " + std::to_string(order) + "\nstep = " + step + "\n[run]\nuntil = 2"),
          truth));
    BOOST_TEST_MESSAGE("formulas beside a weight, order " << order << ": " << errors[0] << " " << errors[2]);
    BOOST_TEST(std::abs(std::log2(errors[1] / errors[2]) - order) < 0.1);
  }
}

BOOST_AUTO_TEST_CASE(a_jet_that_stops_between_two_steps_is_held_over_each) {
  // About a principal axis: I w' = 0.4 until t = 1, with drag c w: w = 0.4/c (1 - e^(-ct/I)), then it decays.
  double const I = 2, c = 0.5, end = 0.4 / c * (1 - std::exp(-c / I)) * std::exp(-c / I);
  for (char const* const jet : {"\"0.4*(t < 1)\"", "[[0, 0.4], [1, 0]]"}) {
    std::vector<double> errors;
    for (char const* const step : {"0.1", "0.05"})
      errors.push_back(
          std::abs(last_row(std::string("inertia = [1, 2, 2.5]\n[system.torque]\n"
                                        "body = [0, \"jet - 0.5*w2\", 0]\ninputs = { jet = ") +
                                jet + " }",
                            "angular_velocity = [0, 0, 0]",
                            std::string("[method]\norder = 4\nstep = ") + step + "\n[run]\nuntil = 2")[5] -
                   end));
    // The kicks are of order 4 in the drag alone; a jump within a step would leave an error of the order of
    // the step.
    BOOST_TEST(errors[0] < 1e-7);
    BOOST_TEST(std::abs(std::log2(errors[0] / errors[1]) - 4) < 0.1);
  }
}

BOOST_AUTO_TEST_CASE(what_a_torque_of_formulas_cannot_be_is_refused) {
  auto const check = [](std::string const& torque, std::string const& says, std::string const& method = "") {
    check_said(refusal("[system]\nkind = \"rigid_body\"\ninertia = [1, 2, 2.5]\ntorque = { " + torque +
                           " }\n[initial]\nangular_velocity = [1, 0.2, 0.3]\n[method]\n" + method +
                           "[run]\nuntil = 1\n[output]\nquantities = [\"energy\"]\n",
                       "body.toml"),
               says);
  };
  check("body = [0, 0]", "body.toml:4:19: body: three formulas are expected, one for each axis; found 2");
  check("body = [\"w4\", 0, 0]", "body.toml:4:21: body: unknown name 'w4'; did you mean 'w1'?");
  check("body = [\"1/(w1 - 1)\", 0, 0]",
        "body: at the start it is [inf, 0, 0], where finite numbers are needed");
  check("body = [\"w1\", 0, 0], parameters = { c = 1 }", "parameters: 'c' does not occur in the torque");
  check("body = [\"w1\", 0, 0], definitions = { c = \"w2\" }",
        "definitions: 'c' does not occur in the torque");
  check("body = [\"w1\", 0, 0], inputs = { u = \"t\" }", "inputs: 'u' does not occur in the torque");
  check("body = [\"w1\", 0, 0], inputs = { w1 = \"t\" }", "the name 'w1' is taken already");
  check("parameters = { c = 1 }", "parameters: they are given to system.torque.body, which is missing");
  check("", "needs one of 'gravity_gradient', 'uniform_gravity', 'potential' and 'body'");
  check("body = [\"w1\", 0, 0]", "moser_veselov steps free bodies", "name = \"moser_veselov\"\n");
  check("body = [\"-30*w1\", 0, 0]", "may turn by", "step = 0.1\n");
  check("body = [\"-w1\", \"-w2*abs(w2)\", 0]", "");
}

BOOST_AUTO_TEST_SUITE_END()
