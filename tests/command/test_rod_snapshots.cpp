// Snapshots of a rod: tables, frames and lines for ParaView have the same numbers.
#include <boost/test/unit_test.hpp>

#include <cmath>

#include "command.hpp"
#include "hdf5_table.hpp"

namespace {

using command::actio, command::contents, command::Folder, command::read_csv, command::read_hdf5_numbers;

std::string const clamped =
    "[system]\nkind = \"rod\"\nrod = { length = 2, elements = 4, section = { EA = 90, GA = 40, EI = 1, "
    "GJ = 1, rA = 1, rI = 0.01 } }\nboundary = { start = \"clamped\" }\n"
    "load = { end_force = [\"0\", \"0.1\", \"0\"] }\n[run]\nuntil = 0.5\nevery = 0.25\n[output]\n"
    "quantities = [\"end_place\", \"contact_force\"]\nformats = [\"csv\", \"hdf5\", \"vtu\"]\n"
    "snapshots = [\"contact_force\", \"curvature\"]\n";

}  // namespace

BOOST_AUTO_TEST_SUITE(rod_snapshots)

BOOST_AUTO_TEST_CASE(tables_and_frames_of_a_rod_have_the_numbers_of_its_rows) {
  Folder const folder;
  auto const outcome = actio({"run", folder.write("rod.toml", clamped), "--out", folder / "out"});
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.err);
  auto const rows = read_csv(folder / "out/series.csv"),
             sections = read_csv(folder / "out/snapshots/000001.csv"),
             elements = read_csv(folder / "out/snapshots/000001.elements.csv");
  BOOST_REQUIRE(sections.rows.size() == 5u);
  BOOST_REQUIRE(elements.rows.size() == 4u);
  for (std::size_t k = 0; k < 5; ++k) {
    BOOST_TEST(sections["s"][k] == 0.5 * static_cast<double>(k));
    double norm = 0;
    for (char const* const q : {"qw", "qx", "qy", "qz"}) norm += std::pow(sections[q][k], 2);
    BOOST_TEST(std::abs(norm - 1) <= 1e-14);
  }
  BOOST_TEST(elements["s"][0] == 0.25);
  std::string const frames = folder / "out/snapshots/frames.h5";
  std::vector<unsigned long long> extent;
  auto const position = read_hdf5_numbers(frames, "position", &extent);
  BOOST_TEST((extent == std::vector<unsigned long long>{2, 5, 3}));
  auto const force = read_hdf5_numbers(frames, "contact_force", &extent);
  BOOST_TEST((extent == std::vector<unsigned long long>{2, 4, 3}));
  for (int a = 0; a < 3; ++a) {
    std::string const axis(1, "xyz"[a]);
    auto const at = static_cast<std::size_t>(a);
    BOOST_TEST(sections[axis][4] == rows["end_place_" + axis].back());
    BOOST_TEST(elements["contact_force_" + axis][3] == rows["contact_force_end_" + axis].back());
    BOOST_TEST(position[27 + at] == sections[axis][4]);
    BOOST_TEST(force[21 + at] == elements["contact_force_" + axis][3]);
  }
  // Bent about the third axis alone.
  for (std::size_t k = 0; k < 4; ++k) {
    BOOST_TEST(std::abs(elements["curvature_1"][k]) + std::abs(elements["curvature_2"][k]) <= 1e-15);
    BOOST_TEST(elements["curvature_3"][k] != 0);
  }
  auto const grid = contents(folder / "out/snapshots/000001.vtu");
  for (char const* const part :
       {"NumberOfPoints=\"5\" NumberOfCells=\"4\"", "Name=\"d1\" NumberOfComponents=\"3\"",
        "Name=\"curvature\" NumberOfComponents=\"3\""})
    BOOST_TEST(grid.find(part) != std::string::npos, part);
  BOOST_TEST(contents(folder / "out/snapshots/series.pvd").find("000001.vtu") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_ring_closes_in_the_lines_of_a_grid) {
  Folder const folder;
  std::string const ring =
      "[system]\nkind = \"rod\"\nrod = { elements = 12, closed = true, curve = [\"cos(2*pi*s)\", "
      "\"sin(2*pi*s)\", \"0\"], section = { EA = 90, GA = 40, EI = 1, GJ = 1, rA = 1, rI = 0.01 } }\n[run]\n"
      "until = 0.01\nevery = 0.01\n[output]\nquantities = [\"energy\"]\nformats = [\"csv\", \"vtu\"]\n"
      "snapshots = []\n";
  auto const outcome = actio({"run", folder.write("ring.toml", ring), "--out", folder / "out", "--plots"});
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.err);
  BOOST_TEST(
      contents(folder / "out/snapshots/000000.vtu").find("NumberOfPoints=\"12\" NumberOfCells=\"12\"") !=
      std::string::npos);
  BOOST_TEST(read_csv(folder / "out/snapshots/000000.csv").rows.size() == 12u);
}

BOOST_AUTO_TEST_SUITE_END()
