// A flow on the sphere is the same bit for bit for any number of threads, and so is what goes on from a
// checkpoint.
#include <boost/test/unit_test.hpp>

#include "sphere_scene.hpp"

namespace {

using namespace command;

/// Large enough for products that are shared between threads.
Sphere shared_between_threads() {
  Sphere scene;
  scene.n = "192", scene.rotation = "0.0", scene.step = "0.0625", scene.every = "0.125";
  scene.quantities = "\"energy\", \"angular_momentum\", \"casimirs\"";
  scene.initial = "random = { lmin = 1, lmax = 12, slope = -3, energy = 1 }";
  return scene;
}
std::string run_with(int threads, std::string const& arguments) {
  Outcome const outcome = shell("ACTIO_THREADS=" + std::to_string(threads) + " $ACTIO " + arguments);
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.err);
  return outcome.err;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(sphere_threads)

BOOST_AUTO_TEST_CASE(no_bit_depends_on_the_number_of_threads) {
  for (std::string const method : {"lie_poisson", "all_invariants"}) {
    Folder const folder;
    Sphere scene = shared_between_threads();
    scene.method = method, scene.until = "0.75";
    std::string const whole = folder.write("whole.toml", scene.text());
    for (int threads : {1, 2, 4})
      run_with(threads, "run " + whole + " --quiet --out " + folder / std::to_string(threads));
    std::string const alone = contents(folder / "1/series.csv");
    // Each row as often as it is asked for, and a flow that moves.
    Table const table = read_csv(folder / "1/series.csv");
    BOOST_TEST(table["t"].size() == 7u);
    BOOST_TEST(table["casimirs_3"].front() != table["casimirs_3"].back());
    BOOST_TEST(contents(folder / "2/series.csv") == alone);
    BOOST_TEST(contents(folder / "4/series.csv") == alone);
    // In the middle of the steps from which the next ones are guessed, by another number of threads.
    scene.until = "0.25";
    run_with(2, "run " + folder.write("half.toml", scene.text()) + " --quiet --out " + folder / "half");
    run_with(4, "resume " + folder / "half" + " --quiet --until 0.75");
    BOOST_TEST(contents(folder / "half/series.csv") == alone);
  }
}

BOOST_AUTO_TEST_SUITE_END()
