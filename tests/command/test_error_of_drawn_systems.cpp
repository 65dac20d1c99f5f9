// The error that a run tells of itself, against the true one, of systems that are drawn anew each time:
// tops, bodies under torques, bodies in space and in more dimensions, Lagrangians on groups; regular and
// chaotic motions, short and long ones.
//
//     bin/test_command -t error_of_drawn_systems -- --systems 60 --seed 17
//
// The truth is the closed form of a free body, and otherwise a run of an order at least as high with a step
// of a quarter to an eighth.
#include <boost/test/unit_test.hpp>

#include <cstdlib>
#include <random>

#include "true_error.hpp"

namespace {

using namespace command;

/// What follows a word on the command line of the tests, after `--`.
unsigned long option(std::string const& word, unsigned long otherwise) {
  auto const& suite = boost::unit_test::framework::master_test_suite();
  for (int k = 1; k + 1 < suite.argc; ++k)
    if (suite.argv[k] == word) return std::strtoul(suite.argv[k + 1], nullptr, 10);
  return otherwise;
}

/// A scene, and the method of its truth.
struct Drawn {
  std::string name;
  BodyScene scene;
  std::string truth;  // [method]
  int n = 3;          // of the matrices
};

class Draw {
 public:
  explicit Draw(unsigned long seed) : random_(seed) {}
  Drawn next() {
    constexpr Drawn (Draw::*kinds[])() = {&Draw::top,       &Draw::in_orbit, &Draw::under_formula,
                                          &Draw::free_body, &Draw::in_n,     &Draw::on_group};
    return (this->*kinds[kind_++ % 6])();
  }

 private:
  double u(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
  template <class T>
  T any(std::vector<T> const& list) {
    return list[static_cast<std::size_t>(u(0, static_cast<double>(list.size()) - 1e-9))];
  }
  Numbers numbers(int count, double from, double to) {
    Numbers out;
    for (int k = 0; k < count; ++k) out.push_back(u(from, to));
    return out;
  }
  Numbers moments() {
    double const a = u(0.5, 1), b = u(0.5, 1);
    return {a, b, std::abs(a - b) + u(0.2, 0.8) * (a + b - std::abs(a - b))};
  }
  /// Times, 32 rows of which are whole numbers of steps; the step is drawn, and the truth has a finer one.
  void times(Drawn& out, double until, double shortest, double longest, std::string const& order,
             std::string const& finer, std::string const& finer_order) {
    double const every = until / 32,
                 step = every / std::ceil(every / std::exp(u(std::log(shortest), std::log(longest))));
    out.scene.run = "until = " + number(until) + "\nevery = " + number(every);
    out.scene.method += "order = " + order + "\nstep = " + number(step);
    out.truth += "order = " + finer_order + "\nstep = " + number(step / std::stod(finer));
    out.name += ", order " + order + ", step " + number(step) + ", until " + number(until);
  }
  Drawn top() {
    Drawn out{"top", {}, ""};
    out.scene.system = "kind = 'heavy_top'\nmass = " + number(u(0.5, 2)) +
                       "\ninertia = " + listed(moments()) +
                       "\ncentre_of_mass = " + listed(numbers(3, -0.3, 0.3)) + "\ngravity = [0, 0, -9.81]";
    out.scene.initial = "angular_velocity = " + listed(numbers(3, -4, 4));
    out.scene.quantities = "'attitude', 'body_momentum'";
    std::string const order = any<std::string>({"2", "4", "4"});
    times(out, any<double>({2, 4, 8, order == "2" ? 4. : 20.}), 0.004, order == "2" ? 0.01 : 0.03, order, "8",
          "4");
    return out;
  }
  Drawn body(std::string const& torque) {
    Drawn out{"", {}, ""};
    out.scene.system = "kind = 'rigid_body'\ninertia = " + listed(moments()) + torque;
    out.scene.initial = "angular_velocity = " + listed(numbers(3, -1, 1));
    out.scene.quantities = "'attitude', 'body_momentum'";
    return out;
  }
  Drawn in_orbit() {
    Drawn out = body("\n[system.torque]\ngravity_gradient = { rate = " + number(u(0.2, 1)) +
                     ", direction = [1, 0, 0], normal = [0, 0, 1] }");
    out.name = "gravity gradient";
    std::string const order = any<std::string>({"2", "4", "4"});
    times(out, any<double>({4, 10, 25, 60}), 0.01, order == "2" ? 0.02 : 0.06, order, "8", "4");
    return out;
  }
  Drawn under_formula() {
    Drawn out = body("\n[system.torque]\npotential = '" + number(u(-2, 2)) + "*r33*(1 + 0.3*cos(" +
                     number(u(0.5, 2)) + "*t)) + " + number(u(-1, 1)) + "*r12^2'");
    out.name = "formula";
    std::string const order = any<std::string>({"2", "4", "4"});
    times(out, any<double>({4, 10, 20}), 0.01, order == "2" ? 0.015 : 0.04, order, "8", "4");
    return out;
  }
  Drawn free_body() {
    Drawn out = body("");
    out.name = any<std::string>({"moser_veselov", "natural_chart"});
    out.scene.method = "name = '" + out.name + "'\n";
    times(out, any<double>({5, 20, 100}), 0.02, 0.2, any<std::string>({"2", "4", "6"}), "1", "'exact'");
    return out;
  }
  Drawn in_n() {
    Drawn out;
    out.n = 3 + static_cast<int>(u(0, 3.99));
    bool const chart = u(0, 1) < 0.3;
    out.name = "SO(" + std::to_string(out.n) + ")" + (chart ? ", natural chart" : "");
    out.scene.system = "kind = 'rigid_body_n'\nlambda = " + listed(numbers(out.n, 0.5, 3.5));
    out.scene.initial = "angular_velocity = " + listed(numbers(out.n * (out.n - 1) / 2, -0.5, 0.5));
    out.scene.method = chart ? "name = 'natural_chart'\n" : "";
    out.scene.quantities = "'attitude', 'momentum']\nerror_estimate = true\nformats = ['csv'";
    std::string const order = any<std::string>({"2", "4", "6"});
    times(out, any<double>({5, 12, 40}), 0.03, order == "2" ? 0.06 : 0.15, order, "8", "6");
    return out;
  }
  Drawn on_group() {
    struct Model {
      std::string group, lagrangian;
      int velocities, n;
    };
    auto const c = [this] { return number(u(0.5, 3)); };
    Model const model =
        any<Model>({{"SO(3)", c() + "*w1^2 + " + c() + "*w2^2 + " + c() + "*w3^2 + 0.1*w1^2*w2^2", 3, 3},
                    {"SE(2)", c() + "*w^2 + " + c() + "*v1^2 + " + c() + "*v2^2", 3, 3},
                    {"SE(3)",
                     c() + "*w1^2 + " + c() + "*w2^2 + " + c() + "*w3^2 + " + c() + "*v1^2 + " + c() +
                         "*v2^2 + " + c() + "*v3^2",
                     6, 4},
                    {"SL(2)", c() + "*x1^2 + " + c() + "*x2^2 + " + c() + "*x3^2", 3, 2},
                    {"SO(4)",
                     c() + "*x1^2 + " + c() + "*x2^2 + " + c() + "*x3^2 + " + c() + "*x4^2 + " + c() +
                         "*x5^2 + " + c() + "*x6^2",
                     6, 4},
                    {"SO(3)'\nadvected = { gravity = [0, 0, -1] }\nparameters = { k = 1 }\nside = 'left",
                     c() + "*w1^2 + " + c() + "*w2^2 + " + c() + "*w3^2 + k*gravity3 + 0.3*gravity1", 3, 3}});
    Drawn out{model.group.substr(0, 5) + (model.group.size() > 5 ? ", carried" : ""), {}, "", model.n};
    out.scene.system =
        "kind = 'euler_poincare'\ngroup = '" + model.group + "'\nlagrangian = '" + model.lagrangian + "'";
    out.scene.initial = "velocity = " + listed(numbers(model.velocities, -1, 1));
    out.scene.quantities = "'configuration', 'body_momentum'";
    bool const galerkin = model.group.size() == 5 && u(0, 1) < 0.3;
    out.scene.method = galerkin ? "name = 'galerkin'\n" : "", out.truth = out.scene.method;
    std::string const order = galerkin ? "4" : any<std::string>({"2", "4", "6"});
    times(out, any<double>({4, 10, 30}), 0.02, order == "2" ? 0.04 : 0.12, order, galerkin ? "2" : "6",
          galerkin ? "10" : "6");
    return out;
  }

  std::mt19937_64 random_;
  int kind_ = 0;
};

/// The first value of a name after another in summary.json; empty where there is none.
std::string value(std::string const& summary, std::string const& section, std::string const& name) {
  std::size_t const begin = summary.find("\"" + section + "\": {");
  if (begin == std::string::npos) return "";
  std::size_t depth = 0, end = begin;
  for (; end < summary.size(); ++end) {
    depth += summary[end] == '{';
    if (summary[end] == '}' && --depth == 0) break;
  }
  std::size_t const at = summary.find("\"" + name + "\": ", begin);
  if (at == std::string::npos || at > end) return "";
  return summary.substr(at + name.size() + 4, end - at);
}
/// What the summary tells of a quantity.
struct Told {
  bool has_number = false;
  double error = 0, until = -1;  // without a number: what it was until then
};
Told told_of(std::string const& summary, std::string const& name) {
  std::string const now = value(summary, "error", name);
  BOOST_REQUIRE_MESSAGE(!now.empty(), name << ": " << summary);
  if (now[0] != '"') return {true, std::stod(now), -1};
  std::string const then = value(summary, "error_until", name);
  if (then.empty()) return {};
  auto const after = [&](std::string const& word) {
    return std::stod(then.substr(then.find("\"" + word + "\": ") + word.size() + 4));
  };
  return {false, after("error"), after("time")};
}

void within_a_factor_of_three_wherever_told_and_told_of_four_in_five(unsigned long seed,
                                                                     unsigned long systems) {
  BOOST_TEST_MESSAGE("systems drawn by --seed " << seed);
  Draw draw(seed);
  int asked = 0, numbers = 0;
  std::vector<double> ratios;
  for (unsigned long k = 0; k < systems; ++k) {
    Drawn drawn = draw.next();
    Left const found = run(drawn.scene);
    BOOST_TEST(found.outcome.status == 0, drawn.name << ": " << found.outcome.err);
    if (found.outcome.status != 0) continue;
    drawn.scene.method = drawn.truth;
    Left const truth = run(drawn.scene);
    BOOST_REQUIRE_MESSAGE(truth.outcome.status == 0, drawn.name << ": " << truth.outcome.err);
    for (std::string const name :
         {contains(drawn.scene.quantities, "configuration") ? "configuration" : "attitude", "momentum"}) {
      Told const told = told_of(found.summary, name);
      ++asked, numbers += told.has_number;
      if (!told.has_number && told.until < 0) {
        BOOST_TEST_MESSAGE(drawn.name << ": " << name << ": no number");
        continue;
      }
      double const error =
          error_of(name, drawn.n, found.table, truth.table, told.has_number ? HUGE_VAL : told.until);
      std::ostringstream line;
      line << drawn.name << ": " << name << " off by " << error << ", told " << told.error << ", ratio "
           << told.error / error;
      if (!told.has_number) line << ", until " << told.until;
      BOOST_TEST_MESSAGE(line.str());
      if (error < 1e-10) {  // as much as rounding, in the truth as well
        BOOST_TEST(told.error < 1e-9, line.str() << "\n" << drawn.scene.text());
        continue;
      }
      ratios.push_back(told.error / error);
      BOOST_TEST((told.error < 3 * error && told.error > error / 3), line.str() << "\n" << found.scene);
    }
  }
  std::ranges::sort(ratios);
  BOOST_REQUIRE(!ratios.empty());
  BOOST_TEST_MESSAGE("estimate to error: " << ratios.front() << " to " << ratios.back() << ", median "
                                           << ratios[ratios.size() / 2] << "; a number for " << numbers
                                           << " of " << asked);
  BOOST_TEST(numbers >= 0.8 * asked, numbers << " of " << asked);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(error_of_drawn_systems)

// Of 14 400 systems one, on SL(2), has an estimate that is further off, by a factor of five: companion and
// control go 0.4 and 0.8 far in the group in a step, where the order is not seen, and agree by chance.
BOOST_AUTO_TEST_CASE(it_is_within_a_factor_of_three_wherever_it_is_told_and_is_told_of_four_in_five) {
  within_a_factor_of_three_wherever_told_and_told_of_four_in_five(option("--seed", std::random_device{}()),
                                                                  option("--systems", 36));
}

// A body in orbit, the control of which had gone as far astray as it can, and so agreed with the companion.
BOOST_AUTO_TEST_CASE(it_is_so_where_the_control_is_lost) {
  within_a_factor_of_three_wherever_told_and_told_of_four_in_five(719769412, 36);
}

BOOST_AUTO_TEST_SUITE_END()
