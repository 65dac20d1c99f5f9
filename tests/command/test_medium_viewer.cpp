// The page and the pictures of a run show media: in the plane, along a line and in space, out of whatever
// format the snapshots have.
#include <filesystem>

#include "medium_scene.hpp"
#include "page_in_node.hpp"

namespace {

using namespace command;

/// A disc of rubber that swings, with its pictures.
Medium swinging_disc() {
  Medium out;
  out.kind = "elastic_body", out.material = "name = \"neo_hookean\", mu = 1, kappa = 3";
  out.mesh = "shape = \"disc\", radius = 1, cells = [3, 3]";
  out.initial = "placement = [\"1.1*X\", \"0.9*Y\"]\nvelocity = [\"0.3\", \"0\"]";
  out.until = "1", out.output = "snapshots = []\nsnapshot_every = 0.1\nplots = true\n";
  return out;
}
/// A cube of six tetrahedra around a diagonal, in the format of Gmsh.
char const* const cube_of_tetrahedra =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 1 1 0\n5 0 0 1\n"
    "6 1 0 1\n7 0 1 1\n8 1 1 1\n$EndNodes\n$Elements\n6\n1 4 2 0 1 1 2 4 8\n2 4 2 0 1 1 6 2 8\n"
    "3 4 2 0 1 1 4 3 8\n4 4 2 0 1 1 3 7 8\n5 4 2 0 1 1 5 6 8\n6 4 2 0 1 1 7 5 8\n$EndElements\n";
/// What its page has of it.
std::string medium_in_page(Folder const& folder) {
  std::string const page = contents(folder / "out/plots/index.html");
  auto const at = page.find("\"medium\":{");
  return at == std::string::npos ? "" : page.substr(at, page.find("]}}</script>", at) - at);
}
std::string told_by_page(Folder const& folder) {
  auto const told = page_in_node(folder / "out/plots/index.html");
  BOOST_TEST(told.status == 0, told.err);
  return told.out;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(medium_viewer)

BOOST_AUTO_TEST_CASE(snapshots_are_played_whatever_is_made_of_them) {
  std::vector<std::string> played;
  for (char const* const formats : {"[\"csv\"]", "[\"hdf5\", \"vtu\"]"}) {
    Folder const folder;
    Medium scene = swinging_disc();
    scene.output += std::string("formats = ") + formats + "\n";
    auto const outcome =
        actio({"run", folder.write("medium.toml", scene.text()), "--out", folder / "out", "--quiet"});
    BOOST_TEST_REQUIRE(outcome.status == 0, outcome.err);
    played.push_back(medium_in_page(folder));
    BOOST_TEST(played.back().size() > 1000u);
    BOOST_TEST((played.back() == played.front()), formats);
    BOOST_TEST(contents(folder / "out/plots/medium.svg").find(">t = 0.6<") != std::string::npos);
  }
}

BOOST_AUTO_TEST_CASE(the_page_plays_bodies_of_each_dimension) {
  if (!there_is_node()) return;
  struct Played {
    std::string mesh, initial, view;
    int faces;
  };
  // The ball has three by three facets on each side of its cube, a box in space 2 (3 4 + 4 2 + 2 3) facets, a
  // cube of tetrahedra two on each side.
  for (auto const& [mesh, initial, view, faces] :
       {Played{"shape = \"box\", lower = [0], upper = [1], cells = [8], periodic = [true]",
               "placement = [\"X + 0.02*sin(2*pi*X)\"]", "PlaneMediumView", 8},
        {"shape = \"box\", lower = [0, 0], upper = [1, 0.5], cells = [8, 4], periodic = [true, false]",
         "placement = [\"X + 0.02*sin(2*pi*X)\", \"Y\"]\nvelocity = [\"1\", \"0\"]", "PlaneMediumView", 32},
        {"shape = \"disc\", radius = 1, cells = [3, 3]", "placement = [\"1.1*X\", \"0.9*Y\"]",
         "PlaneMediumView", 45},
        {"shape = \"ball\", radius = 1, cells = [2, 3]", "placement = [\"1.1*X\", \"0.9*Y\", \"Z\"]",
         "SpaceMediumView", 54},
        {"shape = \"box\", lower = [0, 0, 0], upper = [1, 1, 1], cells = [2, 3, "
         "4], periodic = [true, true, true]",
         "velocity = [\"0.1\", \"0\", \"0\"]", "SpaceMediumView", 52},
        {"shape = \"file\", file = \"cube.msh\"", "velocity = [\"0.1*Y\", \"0\", \"0\"]", "SpaceMediumView",
         12}}) {
    Folder const folder;
    folder.write("cube.msh", cube_of_tetrahedra);
    Medium scene = swinging_disc();
    scene.mesh = mesh, scene.initial = initial;
    run_in(folder, scene);
    std::string const told = told_by_page(folder);
    BOOST_TEST(told.find("\"views\":\"" + view + "\"") != std::string::npos, mesh << told);
    BOOST_TEST(number_after(told, "faces") == faces, mesh << told);
    BOOST_TEST(number_after(told, "asks") == 0);
  }
}

BOOST_AUTO_TEST_CASE(its_box_and_its_colours_are_those_of_the_snapshots) {
  if (!there_is_node()) return;
  Folder const folder;
  Medium scene = swinging_disc();
  scene.output += "snapshot_at = [0, 0.5]\n";
  scene.output.erase(scene.output.find("snapshot_every"), std::string("snapshot_every = 0.1\n").size());
  run_in(folder, scene);
  double lowest = 0, highest = 0;
  for (char const* const number : {"000000", "000001"}) {
    Table const nodes = read_csv(folder / "out/snapshots/" + number + ".csv");
    for (double const x : nodes["x"]) lowest = std::min(lowest, x), highest = std::max(highest, x);
  }
  std::string const page = medium_in_page(folder);
  auto const first_of = [&page](std::string const& list) {
    return std::strtod(page.c_str() + page.find(list) + list.size(), nullptr);
  };
  BOOST_TEST(first_of("\"lower\":[") == lowest);
  BOOST_TEST(first_of("\"upper\":[") == highest);
  std::string const told = told_by_page(folder);
  for (char const* const field : {"jacobian 0.", "pressure -", "density ", "energy density 0.", "speed 0."})
    BOOST_TEST(told.find(field) != std::string::npos, field << told);
}

BOOST_AUTO_TEST_CASE(a_large_medium_is_shown_by_larger_cells) {
  Folder const folder;
  Medium scene;
  scene.mesh = "shape = \"box\", lower = [0, 0], upper = [1, 1], cells = [300, 300]";
  scene.initial = "velocity = [\"0.5*X\", \"0\"]";
  scene.until = "0.01", scene.every = "0.01";
  scene.output = "snapshots = []\nsnapshot_every = 0.002\nformats = [\"hdf5\"]\nplots = true\n";
  auto const outcome =
      actio({"run", folder.write("medium.toml", scene.text()), "--out", folder / "out", "--quiet"});
  BOOST_TEST_REQUIRE(outcome.status == 0, outcome.err);
  // Two megabytes, a third more as text, and the page itself.
  BOOST_TEST(std::filesystem::file_size(folder / "out/plots/index.html") < 3'000'000u);
  if (!there_is_node()) return;
  double const faces = number_after(told_by_page(folder), "faces");
  BOOST_TEST(faces > 7500);
  BOOST_TEST(faces <= 15000);
}

BOOST_AUTO_TEST_CASE(a_run_without_snapshots_is_told_what_to_ask_for) {
  Folder const folder;
  Medium scene = swinging_disc();
  scene.output = "plots = true\n";
  auto const outcome = actio({"run", folder.write("medium.toml", scene.text()), "--out", folder / "out"});
  BOOST_TEST(outcome.status == 0);
  BOOST_TEST(outcome.err.find("add snapshots = [] and snapshot_every to [output] to see it move") !=
                 std::string::npos,
             outcome.err);
  BOOST_TEST(!std::filesystem::exists(folder / "out/plots/medium.svg"));
  if (there_is_node()) BOOST_TEST(number_after(told_by_page(folder), "asks") == 1);
}

BOOST_AUTO_TEST_SUITE_END()
