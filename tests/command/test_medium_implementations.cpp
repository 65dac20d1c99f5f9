// The ways of media through the command: fused steps beside plain ones, memory, loops, what is said of
// characteristics and of long shear.
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "medium_scene.hpp"

namespace {

using namespace command;

constexpr double pi = 3.14159265358979323846;

struct Sample {
  char const *kind, *material;
};
std::vector<Sample> const samples{
    {"barotropic_fluid", "name = \"polytropic_gas\", K = 0.7, gamma = 2"},
    {"barotropic_fluid", "name = \"polytropic_gas\", K = 0.7, gamma = 1.4"},
    {"barotropic_fluid", "name = \"shallow_water\", g = 2"},
    {"barotropic_fluid", "name = \"tait\", B = 0.3, gamma = 7"},
    {"elastic_body", "name = \"saint_venant_kirchhoff\", lambda = 0.9, mu = 0.6"},
    {"elastic_body", "name = \"neo_hookean\", mu = 1, kappa = 2"}};

Medium moving(Sample const& sample, bool in_space) {
  Medium out;
  out.kind = sample.kind, out.material = sample.material;
  out.mesh = in_space ? "shape = \"box\", lower = [-1, 0, 0], upper = [1, 1, 1], cells = [10, 5, 4], "
                        "periodic = [false, true, false]"
                      : "shape = \"box\", lower = [-1, 0], upper = [1, 1], cells = "
                        "[20, 9], periodic = [false, true]";
  out.system = "density = \"1.3\"\nboundary = { left = \"fixed\"" +
               std::string(in_space ? ", front = \"sliding\"" : "") + " }\n";
  out.initial = in_space ? "placement = [\"X + 0.02*sin(2*pi*Y)\", \"Y + "
                           "0.03*sin(2*pi*Y)*Z\", \"1.02*Z\"]\n"
                           "velocity = [\"0\", \"0.1*sin(2*pi*Y)*(X + 1)\", \"0\"]"
                         : "placement = [\"X + 0.02*sin(2*pi*Y)\", \"Y + 0.03*sin(2*pi*Y)\"]\n"
                           "velocity = [\"0\", \"0.1*sin(2*pi*Y)*(X + 1)\"]";
  out.method = "step = 0.01", out.until = "0.2", out.every = "0.2", out.output = "snapshots = []\n";
  return out;
}
/// The table of the nodes at the end, and the plan.
std::pair<Table, std::string> moved(Medium const& scene) {
  Folder const folder;
  auto const plan = actio({"run", folder.write("medium.toml", scene.text()), "--dry-run"});
  run_in(folder, scene);
  return {read_csv(folder / "out/snapshots/000001.csv"), plan.out};
}
/// Bytes that a process had at most.
double bytes_of_run(Folder const& folder, std::string const& scene, std::string const& out) {
  // By a small process: the peak of a child begins with what its parent has.
  std::string const file = folder / "peak";
  pid_t const id = ::fork();
  if (id == 0) {
    ::execl("/usr/bin/time", "time", "-f", "%M", "-o", file.c_str(), ACTIO_COMMAND, "run", scene.c_str(),
            "--out", out.c_str(), "--quiet", nullptr);
    ::_exit(127);
  }
  int status = 0;
  ::waitpid(id, &status, 0);
  BOOST_TEST(status == 0);
  return 1024.0 * std::stod(command::contents(file));
}
/// The number behind some words.
double number_after(std::string const& text, std::string const& words) {
  std::size_t const at = text.find(words);
  BOOST_REQUIRE_MESSAGE(at != std::string::npos, "expected '" << words << "', found '" << text << "'");
  return std::stod(text.substr(at + words.size()));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(medium_implementations)

// An obstacle that is none sends the same scene the generic implementation. Twenty steps, each with a few
// roundings of places and kicks below 2, which go on as velocities.
BOOST_AUTO_TEST_CASE(fused_steps_are_plain_ones_to_rounding_in_the_plane_and_in_space) {
  for (bool const in_space : {false, true})
    for (auto const& sample : samples) {
      Medium scene = moving(sample, in_space);
      auto const [fused, told] = moved(scene);
      BOOST_TEST(
          (told.find(in_space ? "in space without loads: fused steps" : "fused steps") != std::string::npos),
          told);
      scene.system += "obstacle = { potential = \"0*x\" }\n";
      auto const [plain, other] = moved(scene);
      BOOST_TEST((other.find("fused steps") == std::string::npos), other);
      double worst = 0, way = 0;
      for (char const* const column : {"x", "y", "z", "u", "v", "w"}) {
        if (!in_space && (*column == 'z' || *column == 'w')) continue;
        for (std::size_t k = 0; k < fused.rows.size(); ++k) {
          worst = std::max(worst, std::abs(fused[column][k] - plain[column][k]));
          way = std::max(way, std::abs(plain["x"][k] - plain["X"][k]));
        }
      }
      BOOST_TEST(worst <= 20 * 20 * 10 * 2.2e-16, sample.material << ": " << worst);
      BOOST_TEST(way > 0.01);
    }
}

// The fastest motions of flat cells are those across them: a step is stable that is not longer than sound
// takes to pass one. Nine tenths of it are safe, and what is told has six hundredths of room beyond that.
BOOST_AUTO_TEST_CASE(the_longest_stable_step_is_the_time_in_which_sound_passes_a_cell) {
  Medium flat;
  flat.kind = "elastic_body", flat.material = "name = \"saint_venant_kirchhoff\", lambda = 2, mu = 0.5";
  flat.method = "step = 1", flat.until = "1", flat.every = "1";
  for (std::string const box : {"lower = [0, 0], upper = [70, 4], cells = [7, 4]",
                                "lower = [0, 0, 0], upper = [70, 70, 4], cells = [7, 7, 4]"})
    for (std::string const way : {"", "obstacle = { potential = \"0\" }\n"}) {
      flat.mesh = "shape = \"box\", " + box, flat.system = way;
      Folder const folder;
      auto const told = actio({"run", folder.write("medium.toml", flat.text()), "--dry-run"});
      double const safe = number_after(told.err, "not stable; a step of ");
      BOOST_TEST(std::abs(safe * std::sqrt(3.0) / (0.94 * 0.9) - 1) <= 0.01, box << way << ": " << safe);
    }
}

BOOST_AUTO_TEST_CASE(a_box_in_space_begins_soon_and_takes_the_memory_that_was_told) {
  Medium box = moving(samples.back(), true);
  box.initial = "velocity = [\"1 - 0.5*Y\", \"1 + 0.5*X\", \"0\"]";
  box.method = "", box.until = box.every = "0.02", box.quantities = "\"energy\", \"momentum\"";
  struct Sized {
    char const *cells, *way, *output;
  };
  // A motion without snapshots, and on both ways cells with snapshots in both forms.
  char const* const frames =
      "formats = [\"vtu\", \"hdf5\"]\nsnapshots = [\"jacobian\", \"stress\"]\nsnapshot_every = 0.02\n";
  for (auto const& [cells, way, output] :
       {Sized{"[64, 40, 40]", "", ""}, Sized{"[40, 40, 40]", "", frames},
        Sized{"[16, 20, 20]", "obstacle = { potential = \"0*x\" }\n", frames}}) {
    Folder const folder;
    box.mesh = std::string("shape = \"box\", lower = [-1, 0, 0], upper = [1, 1, 1], cells = ") + cells;
    box.system = way, box.output = output;
    std::string const scene = folder.write("box.toml", box.text());
    auto const told = actio({"run", scene, "--dry-run"});
    double const memory = 1e6 * number_after(told.out, "memory      at most about "),
                 taken = bytes_of_run(folder, scene, folder / "out");
    BOOST_TEST_MESSAGE("a box of " << cells << " cells" << (*output ? " with snapshots" : "")
                                   << (*way ? ", plain steps" : "") << ": memory told " << memory
                                   << ", taken " << taken);
    BOOST_TEST(std::abs(memory / taken - 1) <= 0.05);
  }
}

// Rows of nodes around periodic boxes, rectangles of cells and sides that are closed: in an oblique flow all
// have circulations that are known.
BOOST_AUTO_TEST_CASE(circulation_is_that_of_the_loops_that_are_named) {
  Folder const folder;
  Medium gas;
  gas.mesh = "shape = \"box\", lower = [0, 0], upper = [1, 1], cells = [16, 16], periodic = [true, true]";
  gas.initial = "velocity = [\"0.3 + 0.2*cos(2*pi*Y)\", \"-0.1\"]";
  gas.system =
      "[system.loops]\nacross = { along = \"X\", through = [0, 0.25] }\n"
      "up = { along = \"Y\", through = [0.5, 0] }\nhalf = { lower = [0.25, 0], upper = [0.75, 0.5] }\n";
  gas.quantities = "\"circulation\"", gas.until = "0.05", gas.every = "0.05";
  Table const rows = run_in(folder, gas);
  BOOST_TEST(std::abs(rows["circulation_across"][0] - 0.3) <= 1e-15);
  BOOST_TEST(std::abs(rows["circulation_up"][0] + 0.1) <= 1e-15);
  // The lower edge with 0.5, the upper one backwards with 0.1, each half as long as the box.
  BOOST_TEST(std::abs(rows["circulation_half"][0] - 0.2) <= 1e-15);

  Medium ring;
  ring.mesh = "shape = \"annulus\", inner = 0.5, outer = 1, cells = [3, 24]";
  ring.initial = "velocity = [\"-Y\", \"X\"]", ring.quantities = "\"circulation\"";
  ring.system = "loops = { rim = \"outer\", hole = \"inner\" }\n";
  ring.until = "0.01", ring.every = "0.01";
  Table const turning = run_in(folder, ring);
  // Twice the area of a polygon; the body lies at the left of both, so that the hole is passed clockwise.
  double const area = 12 * std::sin(2 * pi / 24);
  BOOST_TEST(std::abs(turning["circulation_rim"][0] - 2 * area) <= 1e-13);
  BOOST_TEST(std::abs(turning["circulation_hole"][0] + 0.5 * area) <= 1e-13);

  auto const with = [&](std::string const& loops) {
    Medium out = gas;
    out.system = "loops = { " + loops + " }\n";
    return out;
  };
  check_ends(with("a = \"left\""), 2, "the body has no side 'left'");
  check_ends(with("a = { lower = [0, 0], upper = [2, 1] }"), 2, "a point within [0, 1] is expected, found 2");
  check_ends(with("a = { lower = [0, 0.5], upper = [1, 0.5] }"), 2, "no cell lies between lower and upper");
  check_ends(with("a = { along = \"Z\", through = [0, 0] }"), 2, "'Z'");
  check_ends(with("\"a b\" = { along = \"X\", through = [0, 0] }"), 2, "letters, digits and _");
  check_ends(with("\"\" = { along = \"X\", through = [0, 0] }"), 2, "letters, digits and _");
  gas.quantities = "\"energy\"";
  check_ends(with("a = { along = \"X\", through = [0, 0] }"), 2,
             "loops: nothing uses 'a': it is for 'circulation', which output.quantities does not have");
  gas.quantities = "\"circulation\"";
  gas.mesh = "shape = \"box\", lower = [0, 0], upper = [1, 1], cells = [16, 16]";
  check_ends(with("a = \"left\""), 2, "the side 'left' is no closed row of nodes");
}

// For gamma = 3 and rho = K = 1 the speed of characteristics is sqrt(3)/J^2.
BOOST_AUTO_TEST_CASE(it_is_said_when_characteristics_cross) {
  double steepest = 0, slope = 0;
  for (int k = 0; k < 100000; ++k) {
    double const X = k * 1e-5, J = 1 + 0.1 * std::cos(2 * pi * X), J_slope = -0.2 * pi * std::sin(2 * pi * X);
    steepest = std::max(steepest, 2 * std::sqrt(3.0) * J_slope / (J * J * J));
    slope = std::max(slope, std::sqrt(3.0) * J_slope / (J * J * J));
  }
  Medium wave;
  wave.initial =
      "placement = [\"X + 0.1*sin(2*pi*X)/(2*pi)\", \"Y\"]\n"
      "velocity = [\"sqrt(3)*(1/(1 + 0.1*cos(2*pi*X)) - 1)\", \"0\"]";
  wave.until = "0.5";
  double const cross = number_after(plan_of(wave), "characteristics cross at t = ");
  BOOST_TEST(std::abs(cross * steepest - 1) <= 1e-4);
  // Both families of waves of a gas at rest steepen half as much; of this gas they do not touch each other.
  wave.initial = "placement = [\"X + 0.1*sin(2*pi*X)/(2*pi)\", \"Y\"]", wave.until = "1";
  double const may = number_after(plan_of(wave), "characteristics may cross from t = ");
  BOOST_TEST(std::abs(may * slope - 1) <= 1e-3);
  // For another gas they do, and the bound is before the time at which they cross.
  wave.material = "name = \"polytropic_gas\", K = 1, gamma = 1.4", wave.until = "3";
  BOOST_TEST(number_after(plan_of(wave), "characteristics may cross from t = ") > may);
  wave.until = "0.2";
  BOOST_TEST(plan_of(wave).find("characteristics") == std::string::npos);
  // Neither a shear nor what is uniform nor what depends on both coordinates.
  wave.until = "9", wave.every = "1";
  for (char const* const start : {"velocity = [\"0\", \"sin(2*pi*X)\"]", "velocity = [\"1\", \"0\"]",
                                  "velocity = [\"0.1*sin(2*pi*X)*cos(8*pi*Y)\", \"0\"]"}) {
    wave.initial = start;
    BOOST_TEST(plan_of(wave).find("characteristics") == std::string::npos, start);
  }
}

BOOST_AUTO_TEST_CASE(a_fluid_that_is_sheared_for_long_ends_with_the_cell_its_jacobian_and_the_time) {
  Medium sheared;
  sheared.mesh = "shape = \"box\", lower = [0, 0], upper = [1, 1], cells = [12, 12], periodic = [true, true]";
  sheared.initial = "velocity = [\"sin(2*pi*Y)\", \"0.1*sin(2*pi*X)\"]";
  sheared.until = "40", sheared.every = "1";
  for (std::string const way : {"", "obstacle = { potential = \"0\" }\n"}) {
    sheared.system = way;
    // Its cells are flattened until the step is too long for them, or one turns inside out.
    check_ends(sheared, 3, "cell ", false);
    check_ends(sheared, 3, "Jacobian ", false);
    check_ends(sheared, 3, " at t = ", false);
  }
  // A step that conserves energy is not found any more; what is said is the same.
  sheared.mesh = "shape = \"box\", lower = [0, 0], upper = [1, 1], cells = [6, 6], periodic = [true, true]";
  sheared.method = "conserve = \"energy\"";
  for (char const* const says : {"cell (", "Jacobian ", "a step of ", "; the state is that at t = ",
                                 ": a fluid resists no shear, and cells that are sheared for long tangle"})
    check_ends(sheared, 3, says, false);
}

// What a refusal names is safe as well when cells are squeezed a little, as in the first steps here, by which
// the longest stable step falls.
BOOST_AUTO_TEST_CASE(a_step_that_a_refusal_names_goes_to_the_end) {
  Medium wave;
  wave.mesh = "shape = \"box\", lower = [0, 0], upper = [4, 4], cells = [16, 16], periodic = [true, true]";
  wave.initial = "velocity = [\"0.05*sin(pi*X/2)\", \"0\"]", wave.until = "8", wave.every = "8";
  wave.material = "name = \"polytropic_gas\", K = 1, gamma = 2";
  for (char const* const way : {"", "obstacle = { potential = \"0*x\" }\n"})
    // Beyond what is stable, and beyond what is safe of it.
    for (char const* const step : {"1", "0.1667"}) {
      wave.system = way, wave.method = std::string("step = ") + step + "\n";
      Folder const folder;
      auto const told = actio({"run", folder.write("medium.toml", wave.text()), "--dry-run"});
      BOOST_TEST(told.status == 3, told.err);
      std::string const words = "; the largest that meets the rows is ";
      std::size_t const at = told.err.find(words);
      BOOST_TEST_REQUIRE(at != std::string::npos, told.err);
      wave.method = "step = " + told.err.substr(at + words.size());
      run_in(folder, wave);
    }
}

// Of a gas without pressure to speak of characteristics cross at t = 1/(0.2 pi): its cells are flat then, and
// the run ends there however rarely it has been looked at.
BOOST_AUTO_TEST_CASE(a_motion_that_begins_slowly_is_watched_until_its_cells_are_flat) {
  Medium gas;
  gas.mesh = "shape = \"box\", lower = [0, 0], upper = [1, 0.125], cells = [32, 4], periodic = [true, true]";
  gas.material = "name = \"polytropic_gas\", K = 1e-9, gamma = 1.4";
  gas.initial = "velocity = [\"-0.1*sin(2*pi*X)\", \"0\"]";
  gas.method = "step = 0.0005", gas.until = "3", gas.every = "0.5";
  Folder const folder;
  auto const ended = actio({"run", folder.write("gas.toml", gas.text())});
  BOOST_TEST(ended.status == 3, ended.err);
  BOOST_TEST(std::abs(number_after(ended.err, "the state is that at t = ") * 0.2 * pi - 1) <= 0.05,
             ended.err);
}

BOOST_AUTO_TEST_SUITE_END()
