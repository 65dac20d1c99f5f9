// What scenes of bodies in n dimensions are refused for, where, and with which words.
#include <boost/test/unit_test.hpp>

#include "body_n.hpp"

using namespace command;

BOOST_AUTO_TEST_SUITE(rigid_body_n_refusals)

BOOST_AUTO_TEST_CASE(a_step_too_long_is_refused_with_the_largest_that_would_do) {
  for (std::string const method : {"moser_veselov", "natural_chart"})
    for (BodyN body : {body_in_four(method), body_in_eight(method)}) {
      Folder const folder;
      body.step = "20", body.until = "20", body.every = "20";
      std::string const scene = folder.write("body.toml", body.text());
      auto const outcome = command::actio({"run", scene});
      BOOST_TEST(outcome.status == 3, outcome.err);
      BOOST_TEST(outcome.err.starts_with(scene + ":8:8: "), outcome.err);
      std::string const before = "the largest step that would do is ";
      std::size_t const at = outcome.err.find(before);
      BOOST_REQUIRE(at != std::string::npos);
      double const largest = std::stod(outcome.err.substr(at + before.size()));
      // That step, and not one a hundredth longer.
      for (double const factor : {1 - 1e-6, 1.01}) {
        body.step = body.until = body.every = number(largest * factor);
        auto const second = command::actio({"run", folder.write("second.toml", body.text()), "--out",
                                            folder / (factor < 1 ? "taken" : "refused")});
        BOOST_TEST(second.status == (factor < 1 ? 0 : 3), second.err);
      }
    }
}

BOOST_AUTO_TEST_CASE(what_no_body_has_is_refused_at_its_place) {
  struct Refusal {
    std::string from, to, message;
  };
  std::string const good = body_in_four().text();
  for (auto const& [from, to, message] : std::vector<Refusal>{
           {"lambda = [1, 2, 3, 4]", "lambda = [1, 2, -1, 4]",
            ":3:10: inertia: Lambda_1 + Lambda_3 must be positive"},
           {"lambda = [1, 2, 3, 4]", "lambda = [1, -2, 3, 4]",
            ":3:10: inertia: Lambda_1 + Lambda_2 must be positive"},
           {"lambda = [1, 2, 3, 4]", "lambda = [0, 0, 0, 0]",
            ":3:10: inertia: Lambda_1 + Lambda_2 must be positive"},
           {"lambda = [1, 2, 3, 4]", "lambda = [1, 2, nan, 4]",
            ":3:17: lambda: a finite number is expected, found nan"},
           {"lambda = [1, 2, 3, 4]", "lambda = [1e308, 1e308, 1e308, 1e308]",
            ":3:10: inertia: sums of Lambda"},
           {"lambda = [1, 2, 3, 4]", "lambda = [1]",
            ":3:10: lambda: from 2 to 512 numbers are expected, found 1"},
           {"lambda = [1, 2, 3, 4]", "lambda = []",
            ":3:10: lambda: from 2 to 512 numbers are expected, found 0"},
           {"lambda = [1, 2, 3, 4]", "lambda = " + listed(Numbers(513, 1.0)),
            ":3:10: lambda: from 2 to 512 numbers are expected, found 513"},
           {"lambda = [1, 2, 3, 4]", "lambda = [1, 2, 3]",
            "angular_velocity: the upper triangle of a matrix with 3 rows is expected, 3 numbers, found 6"},
           {"lambda = [1, 2, 3, 4]", "body = \"apophis\"", "unknown key of [system] 'body'"},
           {"lambda = [1, 2, 3, 4]\n", "", "[system] needs 'lambda'"},
           {"angular_velocity = [", "angular_velocity = [inf, ", ":5:21: "},
           {"angular_velocity = [", "angular_velocity = [\"a\", ", ":5:21: "},
           {"[0.90000000000000002,", "[1e200,", "the numbers are too large"},
           {"angular_velocity", "angular_momentum", "unknown key of [initial] 'angular_momentum'"},
           {"[method]", "attitude = [1, 0, 0, 0]\n[method]", ":6:"},
           {"[method]", "attitude = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\n[method]",
            "4 rows are expected, found 3"},
           {"[method]", "attitude = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, -1]]\n[method]",
            ":6:12: attitude: a rotation is expected, with determinant 1"},
           {"[method]", "attitude = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1.00001]]\n[method]",
            ":6:12: attitude: a rotation is expected; the largest entry of g^T g - 1 is 2e-05 where 1e-9 "
            "is taken; normalised it is [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]"},
           {"[method]", "attitude = [[0, 0, 0, 0], [0, 0, 0, 0], [0, 0, 0, 0], [0, 0, 0, 0]]\n[method]",
            "the largest entry of g^T g - 1 is 1 where"},
           {"[method]", "attitude = [[1e300, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]\n[method]",
            "a rotation is expected"},
           {"name = \"moser_veselov\"", "name = \"variational\"", ":7:8: unknown method 'variational'"},
           {"name = \"moser_veselov\"", "name = \"moser_veselov\"\norder = 3",
            ":8:9: order: moser_veselov takes 2, 4 or 6, found 3"},
           {"name = \"moser_veselov\"", "name = \"natural_chart\"\norder = \"exact\"",
            ":8:9: order: natural_chart takes 2, 4 or 6, found \"exact\""},
           {"name = \"moser_veselov\"", "name = \"moser_veselov\"\nstep = -0.1", ":8:8: step: a number > 0"},
           {"name = \"moser_veselov\"", "name = \"moser_veselov\"\nstep = 0.03",
            "the nearest step that would do is"},
           {"\"momentum\"", "\"angular_velocity\"", "unknown quantity 'angular_velocity'"},
       }) {
    Folder const folder;
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    std::string const scene = folder.write("body.toml", text);
    auto const outcome = command::actio({"run", scene});
    BOOST_TEST_CONTEXT(to.substr(0, 100)) {
      BOOST_TEST(outcome.status == 2);
      BOOST_TEST(outcome.err.starts_with(scene + ":"), outcome.err);
      BOOST_TEST(outcome.err.find(message) != std::string::npos, outcome.err);
    }
  }
}

BOOST_AUTO_TEST_CASE(casimirs_beyond_all_numbers_are_refused_and_the_spectrum_is_not) {
  BodyN body{Numbers(40, 1.0), Numbers(780, 1e8)};
  body.lambda[0] = 2, body.until = "1e-9", body.every = "1e-9";
  for (bool const casimir : {true, false}) {
    Folder const folder;
    body.quantities = casimir ? "\"casimir\"" : "\"spectrum\"";
    auto const outcome = command::actio({"run", folder.write("body.toml", body.text())});
    BOOST_TEST(outcome.status == (casimir ? 2 : 0), outcome.err);
    if (casimir) BOOST_TEST(outcome.err.find("casimir_40 is beyond 1e300") != std::string::npos, outcome.err);
  }
}

BOOST_AUTO_TEST_SUITE_END()
