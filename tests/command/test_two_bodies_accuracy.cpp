// Steps of two bodies by accuracy: the true error of what is chosen, against steps of a tenth of the length.
#include "true_error.hpp"

namespace {

using namespace command;

/// The largest errors of both attitudes, radians, and of the position, relative to its largest modulus.
double error_of_pair(Table const& found, Table const& truth) {
  double worst = 0, apart = 0, modulus = 0;
  auto const a = columns(found, "position"), b = columns(truth, "position");
  for (std::size_t row = 0; row < truth.rows.size(); ++row) {
    double square = 0, size = 0;
    for (std::size_t i = 0; i < 3; ++i)
      square += std::pow(a[i][row] - b[i][row], 2), size += std::pow(b[i][row], 2);
    apart = std::max(apart, std::sqrt(square)), modulus = std::max(modulus, std::sqrt(size));
  }
  for (char const* const name : {"attitude_1", "attitude_2"}) {
    auto const p = columns(found, name), q = columns(truth, name);
    for (std::size_t row = 0; row < truth.rows.size(); ++row) {
      double square = 0;  // of unit quaternions with continuous signs
      for (std::size_t i = 0; i < 4; ++i) square += std::pow(p[i][row] - q[i][row], 2);
      worst = std::max(worst, 4 * std::asin(std::min(1.0, std::sqrt(square) / 2)));
    }
  }
  return std::max(worst, apart / modulus);
}

/// A scene of the catalogue with these changes.
struct Ran {
  Outcome outcome;
  Table table;
  std::string scene, summary;
};
Ran ran(std::string const& scene, std::vector<std::string> const& changes) {
  Folder const folder;
  std::vector<std::string> arguments{"run",
                                     scene,
                                     "--quiet",
                                     "--out",
                                     folder / "out",
                                     "--set",
                                     "output.quantities=['position', 'attitude_1', 'attitude_2']"};
  arguments.insert(arguments.end(), changes.begin(), changes.end());
  Ran out{actio(arguments), {}, "", ""};
  BOOST_REQUIRE_MESSAGE(out.outcome.status == 0, scene << ": " << out.outcome.err);
  out.table = read_csv(folder / "out/series.csv");
  out.scene = contents(folder / "out/scene.toml"), out.summary = contents(folder / "out/summary.json");
  return out;
}
double step_of(std::string const& scene) { return std::stod(scene.substr(scene.find("\nstep = ") + 8)); }

}  // namespace

BOOST_AUTO_TEST_SUITE(two_bodies_accuracy)

BOOST_AUTO_TEST_CASE(the_true_error_is_at_most_what_was_asked) {
  int near = 0;
  for (std::string const scene : {"didymos_before", "didymos_after", "kw4"})
    for (std::string const accuracy : {"1e-5", "1e-7", "1e-9"}) {
      std::vector<std::string> changes{"--set", "run.accuracy=" + accuracy};
      if (scene == "didymos_after") changes.insert(changes.end(), {"--unset", "method.step"});
      Ran const found = ran(scene, changes);
      BOOST_TEST(contains(found.outcome.err, "kepler_splitting of order 8,4 with steps of"),
                 found.outcome.err);
      BOOST_TEST(!contains(found.outcome.err, "the method is accurate"), found.outcome.err);
      BOOST_TEST(contains(found.scene, "order = \"8,4\""), found.scene);
      double const step = step_of(found.scene), asked = std::stod(accuracy);
      Ran const truth = ran(scene, {"--set", "method.step=" + number(step / 10)});
      double const error = error_of_pair(found.table, truth.table);
      BOOST_TEST_MESSAGE(scene << ", asked " << accuracy << ": steps of " << step << ", true error "
                               << error);
      BOOST_TEST(error <= asked, scene << ", " << accuracy << ": " << error);
      BOOST_TEST(!contains(found.summary, "is estimated as"), found.summary);
      near += error >= asked / 100;
    }
  BOOST_TEST(near >= 6, near << " of 9 within a hundred times");
}

BOOST_AUTO_TEST_CASE(tides_have_an_order_of_their_own) {
  // So strong that their error, of order 2, is that of the steps.
  std::vector<std::string> const tides{"--set", "system.tides={ love = [1e-2, 1e-2], lag = [0.3, 0.3] }"};
  auto const with = [&](std::string const& change) {
    auto changes = tides;
    changes.insert(changes.end(), {"--set", change});
    return ran("didymos_before", changes);
  };
  Ran const found = with("run.accuracy=1e-6");
  double const error =
      error_of_pair(found.table, with("method.step=" + number(step_of(found.scene) / 10)).table);
  BOOST_TEST_MESSAGE("tides: steps of " << step_of(found.scene) << ", true error " << error);
  BOOST_TEST((error <= 1e-6 && error >= 1e-8), error);
}

BOOST_AUTO_TEST_CASE(the_copy_makes_the_same_table) {
  Folder const folder;
  std::vector<std::string> const short_run{"--set", "run.until=90000", "--quiet"};
  auto const with = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), short_run.begin(), short_run.end());
    return actio(arguments);
  };
  auto const first = with({"run", "didymos_before", "--out", folder / "a", "--set", "run.accuracy=1e-6"});
  BOOST_TEST(first.status == 0, first.err);
  auto const second = with({"run", folder / "a/scene.toml", "--out", folder / "b"});
  BOOST_TEST(second.status == 0, second.err);
  BOOST_TEST(contains(second.err, "of order 8,4"), second.err);
  BOOST_TEST(contents(folder / "a/series.csv") == contents(folder / "b/series.csv"));
}

BOOST_AUTO_TEST_CASE(a_splitting_without_keplers_drifts_has_its_order_chosen) {
  // Rows so near to each other that order 2 has an error of a hundredth with the step from one to the next.
  for (auto const& [accuracy, order] : {std::pair("1e-2", "order = 2"), {"1e-6", "order = 4"}}) {
    Ran const found = ran("didymos_before", {"--set", "run.until=36000", "--set", "run.every=100", "--set",
                                             "method={ name = 'splitting' }", "--set",
                                             std::string("run.accuracy=") + accuracy});
    BOOST_TEST(contains(found.scene, order), accuracy << ": " << found.scene);
  }
}

BOOST_AUTO_TEST_SUITE_END()
