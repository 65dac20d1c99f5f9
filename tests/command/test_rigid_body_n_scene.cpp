// Bodies in n dimensions from scenes: held to bodies in space, to the equations of motion integrated here,
// and to what is kept.
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>

#include "body_n.hpp"

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
using namespace command;

Square velocity_of(BodyN const& body) {
  Square xi(body.n(), Numbers(body.n(), 0));
  std::size_t a = 0;
  for (int i = 0; i < body.n(); ++i)
    for (int j = i + 1; j < body.n(); ++j, ++a) xi[i][j] = body.velocity[a], xi[j][i] = -xi[i][j];
  return xi;
}
Square times_inertia(BodyN const& body, Square xi, double power) {
  for (int i = 0; i < body.n(); ++i)
    for (int j = 0; j < body.n(); ++j) xi[i][j] *= std::pow(body.lambda[i] + body.lambda[j], power);
  return xi;
}
/// Momentum and attitude at time t by the equations of motion M' = [M, xi], g' = g xi, with the classical
/// rule of Runge and Kutta of order 4.
struct State {
  Square momentum, attitude;
};
State moved(BodyN const& body, double t) {
  auto const rate = [&](State const& s) {
    Square const xi = times_inertia(body, s.momentum, -1);
    return State{plus(times(s.momentum, xi), -1, times(xi, s.momentum)), times(s.attitude, xi)};
  };
  auto const ahead = [](State const& s, double h, State const& r) {
    return State{plus(s.momentum, h, r.momentum), plus(s.attitude, h, r.attitude)};
  };
  State s{times_inertia(body, velocity_of(body), 1), unit(body.n())};
  int const count = static_cast<int>(std::lround(t * 400));
  double const h = t / count;
  for (int k = 0; k < count; ++k) {
    State const a = rate(s), b = rate(ahead(s, h / 2, a)), c = rate(ahead(s, h / 2, b)),
                d = rate(ahead(s, h, c));
    for (auto const& [r, w] : {std::pair{a, 1.0}, {b, 2.0}, {c, 2.0}, {d, 1.0}}) s = ahead(s, h * w / 6, r);
  }
  return s;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(rigid_body_n_scene)

BOOST_AUTO_TEST_CASE(in_three_dimensions_it_is_the_body_in_space) {
  // Lambda_i = (I_j + I_k - I_i)/2.
  std::string const space = command::apophis({{"body", ""},
                                              {"kind", "\"rigid_body\"\ninertia = [2.5, 2.25, 1.25]"},
                                              {"order", "2"},
                                              {"step", "0.05"},
                                              {"until", "10.0"},
                                              {"every", "0.5"},
                                              {"angular_velocity", "[0.3, 1.1, -0.4]"}});
  BodyN const body{{0.5, 0.75, 1.75},
                   {0.4, 1.1, -0.3},
                   "moser_veselov",
                   "0.05",
                   "10",
                   "0.5",
                   "\"momentum\", \"energy\", \"casimir\", \"spectrum\"",
                   {},
                   "2"};
  auto const a = table_of(space), b = table_of(body.text());
  BOOST_REQUIRE(a.rows.size() == b.rows.size());
  for (std::size_t row = 0; row < a.rows.size(); ++row) {
    Numbers const M{a["body_momentum_x"][row], a["body_momentum_y"][row], a["body_momentum_z"][row]};
    double const size = std::sqrt(M[0] * M[0] + M[1] * M[1] + M[2] * M[2]);
    // Two solvers of one equation: 8 n roundings of a step, which over 200 steps may add up.
    double const bound = 8 * 3 * eps * 200 * size;
    BOOST_TEST(std::abs(b["momentum_12"][row] + M[2]) <= bound);
    BOOST_TEST(std::abs(b["momentum_13"][row] - M[1]) <= bound);
    BOOST_TEST(std::abs(b["momentum_23"][row] + M[0]) <= bound);
    BOOST_TEST(std::abs(b["energy"][row] / a["energy"][row] - 1) <= 200 * 24 * eps);
    // The eigenvalues of the cross product with M: 0 and +-i|M|.
    BOOST_TEST(b["spectrum_1"][row] == 0);
    BOOST_TEST(std::abs(b["spectrum_2"][row] / size - 1) <= 200 * 24 * eps);
    BOOST_TEST(b["spectrum_3"][row] == b["spectrum_2"][row]);
    BOOST_TEST(std::abs(b["casimir_2"][row] / (2 * size * size) - 1) <= 200 * 24 * eps);
  }
}

BOOST_AUTO_TEST_CASE(both_methods_are_of_order_2) {
  for (std::string const method : {"moser_veselov", "natural_chart"})
    for (BodyN body : {body_in_four(method), body_in_eight(method)}) {
      body.quantities = "\"momentum\", \"attitude\", \"energy\"", body.every = body.until, body.order = "2";
      State const exact = moved(body, 2);
      double momentum[2], attitude[2], energy[2];
      for (int k : {0, 1}) {
        body.step = k ? "0.01" : "0.02";
        auto const table = table_of(body.text());
        momentum[k] = difference(skew(table, "momentum", body.n(), 1), exact.momentum) / norm(exact.momentum);
        attitude[k] = difference(matrix(table, "attitude", body.n(), 1), exact.attitude);
        energy[k] = std::abs(table["energy"][1] / table["energy"][0] - 1);
      }
      BOOST_TEST_MESSAGE("SO(" << body.n() << "), " << method << ", steps of 0.02 and 0.01: momentum off by "
                               << momentum[0] << ", " << momentum[1] << ", attitude by " << attitude[0]
                               << ", " << attitude[1] << ", energy by " << energy[0] << ", " << energy[1]);
      // A ratio of 4, and 1 + O(h^2) of that.
      for (auto const* error : {momentum, attitude, energy}) {
        // That of Moser and Veselov keeps the energy: it is one of the integrals of its matrix polynomial.
        if (error == energy && method == "moser_veselov") {
          BOOST_TEST(energy[1] <= 200 * body.n() * eps);
          continue;
        }
        BOOST_TEST(error[0] / error[1] > 3.9);
        BOOST_TEST(error[0] / error[1] < 4.1);
      }
      BOOST_TEST(momentum[1] < 1e-3);
    }
}

BOOST_AUTO_TEST_CASE(casimirs_spectrum_and_momentum_in_space_stay) {
  for (std::string const method : {"moser_veselov", "natural_chart"})
    for (BodyN body : {body_in_four(method), body_in_eight(method)}) {
      int const n = body.n(), steps = 4000;
      double const h = 0.025;
      body.step = "0.025", body.until = "100", body.every = "10",
      body.quantities = "\"attitude\", \"momentum\", \"casimir\", \"spectrum\", \"energy\"";
      auto const table = table_of(body.text());
      Square const start = skew(table, "momentum", n, 0);
      double const fastest = table["spectrum_" + std::to_string(n)][0] / (2 * body.lambda[0]);
      // Were all roundings of the relative motion, h xi eps each, to pull the same way; and n for what is
      // made of the momentum in a row.
      double const bound = n * eps * (h * fastest * steps + n);
      double drift = 0;
      for (std::size_t row = 0; row < table.rows.size(); ++row) {
        Square const m = skew(table, "momentum", n, row), g = matrix(table, "attitude", n, row),
                     minus_square = times(m, transposed(m));
        BOOST_TEST(difference(times(g, transposed(g)), unit(n)) <= bound);
        BOOST_TEST(difference(times(times(g, m), transposed(g)), start) <= bound * norm(start));
        Square power = unit(n);
        for (int k = 1; k <= n / 2; ++k) {
          std::string const name = "casimir_" + std::to_string(2 * k);
          power = times(power, minus_square);
          // As traces of products, here; each factor adds n roundings.
          BOOST_TEST(std::abs(table[name][row] / trace(power) - 1) <= 4 * k * n * eps);
          drift = std::max(drift, std::abs(table[name][row] / table[name][0] - 1));
          BOOST_TEST(std::abs(table[name][row] / table[name][0] - 1) <= 2 * k * bound);
        }
        for (int k = 1; k <= n; ++k)
          BOOST_TEST(std::abs(table["spectrum_" + std::to_string(k)][row] -
                              table["spectrum_" + std::to_string(k)][0]) <= bound * norm(start));
        // Kept by one; of order 2 in the other, and it does not leave.
        BOOST_TEST(std::abs(table["energy"][row] / table["energy"][0] - 1) <=
                   (method == "moser_veselov" ? 2 * bound : h * h));
      }
      BOOST_TEST(difference(skew(table, "momentum", n, table.rows.size() - 1), start) > 0.1 * norm(start));
      BOOST_TEST_MESSAGE("SO(" << n << "), " << method << ", " << steps << " steps: Casimirs drift by "
                               << drift);
    }
}

BOOST_AUTO_TEST_CASE(compositions_are_of_orders_4_and_6) {
  for (std::string const method : {"moser_veselov", "natural_chart"})
    for (BodyN body : {body_in_four(method), body_in_eight(method)}) {
      body.quantities = "\"momentum\", \"attitude\"", body.every = body.until;
      State const exact = moved(body, 2);
      for (int order : {4, 6}) {
        body.order = std::to_string(order);
        Numbers momentum, attitude;
        for (std::string const& step : order == 4 ? std::vector<std::string>{"0.1", "0.05"}
                                                  : std::vector<std::string>{"0.25", "0.125"}) {
          body.step = step;
          auto const table = table_of(body.text());
          momentum.push_back(difference(skew(table, "momentum", body.n(), 1), exact.momentum) /
                             norm(exact.momentum));
          attitude.push_back(difference(matrix(table, "attitude", body.n(), 1), exact.attitude));
        }
        for (auto const& errors : {momentum, attitude})  // of which the reference itself has 1e-12
          BOOST_TEST((errors[1] < 4e-12 || std::abs(std::log2(errors[0] / errors[1]) - order) < 0.4),
                     "SO(" << body.n() << "), " << method << ", order " << order << ": errors " << errors[0]
                           << ", " << errors[1]);
      }
    }
}

BOOST_AUTO_TEST_CASE(indices_of_two_digits_are_kept_apart) {
  BodyN body{Numbers(11, 1.0), Numbers(55, 0.01)};
  body.lambda[3] = 2, body.quantities = "\"momentum\", \"attitude\", \"casimir\", \"spectrum\"",
  body.step = "0.5";
  auto const table = table_of(body.text());
  for (std::string const name :
       {"momentum_12", "momentum_19", "momentum_1_10", "momentum_1_11", "momentum_10_11", "attitude_11",
        "attitude_1_11", "attitude_11_1", "attitude_99", "casimir_10", "spectrum_11"})
    BOOST_TEST(std::count(table.columns.begin(), table.columns.end(), name) == 1, name);
  BOOST_TEST(table.columns.size() == 1u + 55 + 121 + 5 + 11);
}

BOOST_AUTO_TEST_CASE(defaults_are_written_back_and_repeat_the_run) {
  Folder const folder;
  BodyN body = body_in_four();
  std::string text = body.text();
  text.erase(text.find("[method]"), text.find("[run]") - text.find("[method]"));
  BOOST_TEST(command::actio({"run", folder.write("body.toml", text)}).status == 0);
  std::string const copy = command::contents(folder / "body/scene.toml");
  BOOST_TEST(
      copy.find("name = \"moser_veselov\"\norder = 6\nstep = 0.08333333333333333") != std::string::npos,
      copy);
  BOOST_TEST(copy.find("attitude = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]") != std::string::npos, copy);
  BOOST_TEST(command::actio({"run", folder / "body/scene.toml", "--out", folder / "again"}).status == 0);
  BOOST_TEST(command::contents(folder / "again/scene.toml") == copy);
  BOOST_TEST(command::contents(folder / "again/series.csv") == command::contents(folder / "body/series.csv"));
}

BOOST_AUTO_TEST_CASE(an_attitude_turns_all_that_follows) {
  BodyN body = body_in_four();
  body.quantities = "\"attitude\", \"momentum\"", body.step = "0.05";
  Square turned = unit(4);
  turned[0][0] = 0.6, turned[0][2] = -0.8, turned[2][0] = 0.8, turned[2][2] = 0.6;
  auto const plain = table_of(body.text());
  // Off by less than 1e-9: normalised, and said.
  for (double const off : {0.0, 1e-10}) {
    Square given = turned;
    given[0][0] += off;
    body.attitude = listed(given);
    Folder const folder;
    BOOST_TEST(command::actio({"run", folder.write("body.toml", body.text())}).status == 0);
    auto const table = command::read_csv(folder / "body/series.csv");
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      BOOST_TEST(
          difference(matrix(table, "attitude", 4, row), times(turned, matrix(plain, "attitude", 4, row))) <=
          1e-9 * (off > 0) + 100 * eps);
      BOOST_TEST(
          difference(times(matrix(table, "attitude", 4, row), transposed(matrix(table, "attitude", 4, row))),
                     unit(4)) <= 100 * eps);
      BOOST_TEST(difference(skew(table, "momentum", 4, row), skew(plain, "momentum", 4, row)) == 0);
    }
    bool const said = command::contents(folder / "body/summary.json").find("normalised") != std::string::npos;
    BOOST_TEST(said == (off > 0));
  }
}

BOOST_AUTO_TEST_CASE(where_all_moments_are_equal_the_momentum_rests) {
  for (BodyN body : {BodyN{{1.5, 1.5, 1.5, 1.5}, body_in_four().velocity}, BodyN{{0.5, 2.0}, {0.7}}})
    for (std::string const quantities : {"\"momentum\"", "\"momentum\", \"attitude\""}) {
      body.quantities = quantities, body.step = "0.05";
      auto const table = table_of(body.text());
      for (std::size_t row = 0; row < table.rows.size(); ++row)
        BOOST_TEST(difference(skew(table, "momentum", body.n(), row), skew(table, "momentum", body.n(), 0)) <=
                   40 * body.n() * eps * norm(skew(table, "momentum", body.n(), 0)));
    }
}

BOOST_AUTO_TEST_CASE(a_body_at_rest_stays) {
  for (std::string const method : {"moser_veselov", "natural_chart"}) {
    BodyN body{{1, 2, 3}, {0, 0, 0}, method};
    body.quantities = "\"momentum\", \"attitude\", \"energy\", \"casimir\", \"spectrum\"";
    auto const table = table_of(body.text());
    BOOST_TEST(table.rows.size() == 5u);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      BOOST_TEST(difference(matrix(table, "attitude", 3, row), unit(3)) == 0);
      for (std::string const name : {"momentum_12", "momentum_23", "energy", "casimir_2", "spectrum_3"})
        BOOST_TEST(table[name][row] == 0);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
