// The page of a run of a Lagrangian on a group: frames that move, and trajectories of momenta.
#include <boost/test/unit_test.hpp>

#include "page_in_node.hpp"

using command::number_after, command::page_in_node, command::there_is_node;

namespace {

struct Played {
  std::string name, system, velocity, quantities, views;
};

std::string const momenta = "\"body_momentum\", \"spatial_momentum\", ", frame = "\"configuration\"",
                  plane = "group = \"SE(2)\"\nlagrangian = \"(w^2 + v1^2 + 6*v2^2)/2\"",
                  turning = "group = \"SO(3)\"\nlagrangian = \"(w1^2 + 2*w2^2 + 3*w3^2)/2",
                  rigid = "group = \"SE(3)\"\nlagrangian = \"(w1^2 + 2*w2^2 + w3^2 + v1^2 + v2^2 + 3*v3^2)/2",
                  basis =
                      "algebra = [[[0,-1,0],[1,0,0],[0,0,0]], "
                      "[[0,0,1],[0,0,0],[0,0,0]], [[0,0,0],[0,0,1],[0,0,0]]]\n"
                      "lagrangian = \"(x1^2 + x2^2 + 6*x3^2)/2\"";

std::vector<Played> const all{
    {"plane", plane, "0.7, 1, 0.2", momenta + frame, "FrameView, TrajectoryView in a box"},
    {"nothing", plane, "0.7, 1, 0.2", "\"energy\"", ""},
    {"basis", basis, "0.7, 1, 0.2", frame, "FrameView"},
    {"free", turning + "\"", "0.2, 1.4, 0.3", momenta + frame, "FrameView, TrajectoryView on a sphere"},
    {"heavy", turning + " - down3\"\nadvected = { down = [0, 0.1, -1] }", "0.2, 1.4, 0.3",
     momenta + frame + ", \"down\"", "FrameView, TrajectoryView in a box"},
    {"right", turning + " - mast1\"\nside = \"right\"\nadvected = { mast = [0, 0.1, -1] }", "0.2, 1.4, 0.3",
     frame + ", \"mast\"", "FrameView"},
    {"tied", rigid + " - (post1^2 + post2^2)/5\"\nadvected = { post = [1, 0.5, 0, 1] }",
     "0.2, 1.4, 0.3, 0.3, 0.1, 0.9", momenta + frame + ", \"post\"", "FrameView, TrajectoryView of pairs"},
    {"linear", "group = \"SL(2)\"\nlagrangian = \"(x1^2 + 2*x2^2 + 3*x3^2)/2\"", "0.7, 1, 0.2",
     momenta + frame, "TrajectoryView in a box"},
    {"affine", "group = \"Aff(1)\"\nlagrangian = \"(x1^2 + 2*x2^2)/2\"", "0.7, 1", momenta + frame,
     "TrajectoryView of pairs"}};

std::string scene_of(Played const& played) {
  return "[system]\nkind = \"euler_poincare\"\n" + played.system + "\n[initial]\nvelocity = [" +
         played.velocity + "]\n[run]\nuntil = 6\nevery = 0.1\n[output]\nquantities = [" + played.quantities +
         "]\n";
}

}  // namespace

BOOST_AUTO_TEST_SUITE(page_of_groups)

BOOST_AUTO_TEST_CASE(the_page_plays_frames_and_trajectories_of_momenta) {
  if (!there_is_node()) return;
  command::Folder const folder;
  for (auto const& played : all) {
    std::string const scene = folder.write(played.name + ".toml", scene_of(played));
    auto const outcome = command::actio({"run", scene, "--plots"});
    BOOST_TEST(outcome.status == 0, outcome.err);
    // The script holds frames to the matrices of the run, and what they carry to where it has to stand still.
    auto const said = page_in_node(folder / (played.name + "/plots/index.html"));
    BOOST_TEST(said.status == 0, played.name + ": " + said.err);
    BOOST_TEST(said.out.find("\"views\":\"" + played.views + "\"") != std::string::npos,
               played.name + ": " + said.out);
    BOOST_TEST((number_after(said.out, "asks") == 1) == (played.name == "nothing"),
               played.name + ": " + said.out);
  }
}

BOOST_AUTO_TEST_CASE(a_long_run_is_played_from_as_many_rows_as_a_frame_can_be_followed_through) {
  command::Folder const folder;
  // It turns by 2 radians in a unit of time, a row by 0.2: every second row is within 30 degrees, every
  // fourth not.
  std::string const scene = folder.write(
      "long.toml",
      scene_of({"", "group = \"SE(2)\"\nlagrangian = \"(w^2 + v1^2 + v2^2)/2\"", "2, 0.1, 0", frame, ""}));
  auto const outcome = command::actio({"run", scene, "--plots", "--set", "run.until=700"});
  BOOST_TEST_REQUIRE(outcome.status == 0, outcome.err);
  std::string const page = command::contents(folder / "long/plots/index.html");
  BOOST_TEST(number_after(page, "stride") == 2);
  BOOST_TEST(page.find("\"beginning_only\":true") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
