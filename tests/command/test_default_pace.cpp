// The step that a scene has by default: as long as the motion allows, whatever the times of its rows.
#include "medium_scene.hpp"

namespace {

using command::actio;
using command::contents;
using command::Folder;
using command::Medium;
using command::Table;

struct Scene {
  char const *kind, *rest, *quantities;
};
Scene const scenes[] = {
    {"rigid_body",
     "inertia = [1, 2, 2.5]\n[initial]\nangular_velocity = [0.1, 1, 0.2]\n[method]\norder = 2\n",
     "\"body_momentum\""},
    {"heavy_top",
     "mass = 1\ninertia = [1, 2, 2.5]\ncentre_of_mass = [0, 0.1, 0.5]\ngravity = [0, 0, -1]\n[initial]\n"
     "angular_velocity = [0.1, 1, 0.3]\n",
     "\"energy\""},
    {"rigid_body_n", "lambda = [1, 2, 3, 4]\n[initial]\nangular_velocity = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]\n",
     "\"energy\""},
    {"euler_poincare",
     "group = \"SE(2)\"\nlagrangian = \"(w^2 + v1^2 + 6*v2^2)/2\"\n[initial]\nvelocity = [0.7, 1.0, 0.2]\n",
     "\"energy\""},
    {"vorticity_sphere", "N = 8\n[initial]\nharmonics = [[3, 2, 0.2, 0.1], [1, 0, 0.5, 0.0]]\n",
     "\"energy\""},
    {"two_bodies",
     "G = 1\nprimary = { sphere = 0.5, mass = 1 }\nsecondary = { sphere = 0.1, mass = 0.1 }\n[initial]\n"
     "position = [2, 0, 0]\nvelocity = [0, 0.7, 0]\n",
     "\"separation\""},
    {"rod",
     "rod = { length = 1, elements = 8, section = { EA = 1, GA = 1, EI = 1, GJ = 1, rA = 1, rI = 0.1 } }\n"
     "[initial]\nvelocity = [\"0\", \"0.1*x^2\", \"0\"]\n",
     "\"energy\""},
    {"barotropic_fluid",
     "mesh = { shape = \"box\", lower = [0, 0], upper = [1, 1], cells = [4, 4], periodic = [true, true] }\n"
     "material = { name = \"polytropic_gas\", K = 1, gamma = 2 }\n[initial]\n"
     "placement = [\"X + 0.01*sin(2*pi*X)\", \"Y\"]\n",
     "\"energy\""},
    {"elastic_body",
     "mesh = { shape = \"box\", lower = [0], upper = [1], cells = [4] }\n"
     "material = { name = \"neo_hookean\", mu = 1, kappa = 2 }\n[initial]\nplacement = [\"1.01*X\"]\n",
     "\"energy\""},
};
std::string text(Scene const& scene, std::string const& run) {
  return std::string("[system]\nkind = \"") + scene.kind + "\"\n" + scene.rest + "[run]\n" + run +
         "\n[output]\nquantities = [" + scene.quantities + "]\nerror_estimate = false\n";
}
double number_after(std::string const& said, std::string const& before) {
  std::size_t const at = said.find(before);
  return at == std::string::npos ? -1 : std::stod(said.substr(at + before.size()));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(default_pace)

// A step that divides all times would be 1e-5, or 1e-4.
BOOST_AUTO_TEST_CASE(times_with_a_small_divisor_do_not_shorten_the_step_of_any_system) {
  for (auto const& scene : scenes) {
    Folder const folder;
    auto const steps = [&](std::string const& run) {
      auto const done =
          actio({"run", folder.write("s.toml", text(scene, run)), "--out", folder / "out", "--force"});
      BOOST_TEST(done.status == 0, scene.kind << ": " << done.err);
      return number_after(contents(folder / "out/summary.json"), "\"steps\": ");
    };
    double const even = steps("until = 4\nevery = 0.5");
    BOOST_TEST(contents(folder / "out/scene.toml").find("between_steps") == std::string::npos);
    for (char const* const run :
         {"until = 4\nevery = 0.33333", "until = 4\nat = [0.1, 0.2345, 0.77777, 4]"}) {
      double const odd = steps(run);
      BOOST_TEST((odd > 0 && odd <= 2 * even + 20),
                 scene.kind << ", " << run << ": " << odd << " for " << even);
      BOOST_TEST(contents(folder / "out/scene.toml").find("between_steps = true") != std::string::npos);
      BOOST_TEST(contents(folder / "out/summary.json").find("run.between_steps: ") != std::string::npos);
      // The copy of the scene has the same rows.
      std::string const rows = contents(folder / "out/series.csv");
      auto const again = actio({"run", folder / "out/scene.toml", "--out", folder / "again", "--force"});
      BOOST_TEST(again.status == 0, again.err);
      BOOST_TEST(contents(folder / "again/series.csv") == rows);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_scene_that_says_that_no_rows_are_between_steps_keeps_its_meaning) {
  Folder const folder;
  auto const done = actio(
      {"run", folder.write("s.toml", text(scenes[0], "until = 1\nevery = 0.3333\nbetween_steps = false")),
       "--out", folder / "out"});
  BOOST_TEST(done.status == 0, done.err);
  BOOST_TEST(number_after(contents(folder / "out/summary.json"), "\"steps\": ") == 10000);
}

// Rows beside the steps of a medium: those at steps do not know of them, and they are as near to the motion
// as steps are.
BOOST_AUTO_TEST_CASE(rows_of_a_medium_between_its_steps_change_no_step) {
  Medium wave;
  wave.initial = "placement = [\"X + 0.02*sin(2*pi*X)\", \"Y\"]";
  wave.quantities = "\"energy\", \"momentum\", \"circulation\"", wave.until = "0.06", wave.every = "";
  for (char const* const way : {"", "obstacle = { potential = \"0*x\" }\n"})
    for (char const* const method :
         {"", "conserve = \"energy\"\n", "order = 4\n", "viscosity = { linear = 0.5, quadratic = 2 }\n"}) {
      wave.system = way;
      auto const rows = [&](std::string const& step, std::string const& at) {
        Folder const folder;
        Medium scene = wave;
        scene.method = std::string(method) + "step = " + step;
        scene.until += "\nat = " + at;
        return run_in(folder, scene);
      };
      Table const few = rows("0.002", "[0.03, 0.06]"),
                  more = rows("0.002", "[0.03, 0.0305, 0.0451, 0.06]\nbetween_steps = true"),
                  fine = rows("0.0001", "[0.03, 0.0305, 0.0451, 0.06]");
      BOOST_TEST((few.rows[0] == more.rows[0] && few.rows[1] == more.rows[3]), way << method);
      for (std::size_t k = 0; k < 4; ++k)
        BOOST_TEST(std::abs(more["energy"][k] - fine["energy"][k]) <= 1e-4 * fine["energy"][k],
                   way << method);
      BOOST_TEST((more["energy"][1] != more["energy"][0]), way << method);
    }
}

BOOST_AUTO_TEST_SUITE_END()
