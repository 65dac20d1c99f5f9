// Snapshots of media: tables of the nodes, grids for ParaView and their list, frames in HDF5, read back byte
// by byte.
#include <zlib.h>

#include <cmath>
#include <cstdint>
#include <cstring>

#include "hdf5_table.hpp"
#include "medium_scene.hpp"

namespace {

using namespace command;

/// The number behind `name="` in a piece of XML.
std::string attribute(std::string const& text, std::string const& name) {
  std::size_t const at = text.find(" " + name + "=\"");
  if (at == std::string::npos) return "";
  std::size_t const begin = at + name.size() + 3;
  return text.substr(begin, text.find('"', begin) - begin);
}

/// A .vtu file.
class Grid {
 public:
  explicit Grid(std::string const& path) : text_(contents(path)) {
    std::string const mark = "<AppendedData encoding=\"raw\">";
    std::size_t const at = text_.find(mark);
    BOOST_REQUIRE(at != std::string::npos);
    data_ = text_.find('_', at) + 1;
    head_ = text_.substr(0, at);
    std::string const piece = head_.substr(head_.find("<Piece"));
    points = std::stoul(attribute(piece, "NumberOfPoints"));
    cells = std::stoul(attribute(piece, "NumberOfCells"));
  }
  std::string const& head() const { return head_; }
  /// The numbers of an array.
  template <class T>
  std::vector<T> array(std::string const& name) const {
    std::size_t const at = head_.find("Name=\"" + name + "\"");
    BOOST_REQUIRE_MESSAGE(at != std::string::npos, "no array " << name);
    std::size_t from = data_ + std::stoul(attribute(head_.substr(at), "offset"));
    auto const number = [&] {
      std::uint64_t out = 0;
      std::memcpy(&out, text_.data() + from, sizeof out);
      from += sizeof out;
      return out;
    };
    std::uint64_t const blocks = number(), size = number(), last = number();
    std::vector<std::uint64_t> packed;
    for (std::uint64_t k = 0; k < blocks; ++k) packed.push_back(number());
    std::string bytes;
    for (std::uint64_t k = 0; k < blocks; ++k) {
      uLongf length = k + 1 == blocks && last ? last : size;
      std::string block(length, '\0');
      BOOST_REQUIRE(uncompress(reinterpret_cast<Bytef*>(block.data()), &length,
                               reinterpret_cast<Bytef const*>(text_.data() + from), packed[k]) == Z_OK);
      bytes += block, from += packed[k];
    }
    std::vector<T> out(bytes.size() / sizeof(T));
    std::memcpy(out.data(), bytes.data(), bytes.size());
    return out;
  }
  std::size_t points = 0, cells = 0;

 private:
  std::string text_, head_;
  std::size_t data_ = 0;
};

/// A run in a periodic box, with tables and grids.
Medium sheared() {
  Medium out;
  out.kind = "elastic_body", out.material = "name = \"neo_hookean\", mu = 1, kappa = 3";
  out.mesh = "shape = \"box\", lower = [0, 0], upper = [1, 0.5], cells = [8, 4], periodic = [true, true]";
  out.initial = "placement = [\"X\", \"Y + 0.1*sin(2*pi*X)\"]\nvelocity = [\"1\", \"0\"]";
  out.output =
      "formats = [\"csv\", \"vtu\"]\nsnapshots = [\"jacobian\", \"pressure\", \"stress\"]\n"
      "snapshot_every = 0.1\n";
  return out;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(medium_snapshots)

BOOST_AUTO_TEST_CASE(a_table_has_the_nodes_with_what_was_asked) {
  Folder const folder;
  run_in(folder, sheared());
  Table const nodes = read_csv(folder / "out/snapshots/000000.csv");
  BOOST_TEST((nodes.columns == std::vector<std::string>{"X", "Y", "x", "y", "u", "v", "jacobian", "pressure",
                                                        "stress_xx", "stress_xy", "stress_yy"}),
             boost::test_tools::per_element());
  BOOST_REQUIRE(nodes.rows.size() == 32u);
  for (std::size_t k = 0; k < 32; ++k) {
    BOOST_TEST(nodes["X"][k] == static_cast<double>(k % 8) / 8);
    BOOST_TEST(nodes["x"][k] == nodes["X"][k]);
    BOOST_TEST(std::abs(nodes["u"][k] - 1) <= 1e-15);  // what it kicks half a step ahead is taken back
    BOOST_TEST(std::abs(nodes["jacobian"][k] - 1) <= 1e-15);
    // Under a shear g the stress is mu g across and mu g^2 along; a node has the means of both its sides.
    double const h = 0.125, X = nodes["X"][k], pi = std::acos(-1.0);
    auto const y = [&](double at) { return 0.1 * std::sin(2 * pi * at); };
    double const right = (y(X + h) - y(X)) / h, left = (y(X) - y(X - h)) / h;
    BOOST_TEST(std::abs(nodes["stress_xy"][k] - (right + left) / 2) <= 1e-14);
    BOOST_TEST(std::abs(nodes["stress_yy"][k] - (right * right + left * left) / 2) <= 1e-14);
    BOOST_TEST(std::abs(nodes["stress_xx"][k]) <= 1e-14);
  }
  BOOST_TEST(contents(folder / "out/snapshots/times.csv").starts_with("snapshot,t\n0,0\n1,0.1"));
}

BOOST_AUTO_TEST_CASE(grids_on_the_sphere_have_the_pressures_of_their_own_time) {
  Folder const folder;
  std::string const scene =
      "[system]\nkind = \"fluid_on_sphere\"\nmesh = { cells = 4 }\n[initial]\nstream = \"-z + 0.5*x*y\"\n"
      "[run]\nuntil = 0.5\nevery = 0.25\n[output]\nquantities = [\"energy\"]\nformats = [\"csv\", \"vtu\"]\n"
      "snapshots = [\"pressure\", \"jacobian\"]\n";
  auto const outcome = actio({"run", folder.write("sphere.toml", scene), "--out", folder / "out", "--force"});
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.err);
  std::vector<double> first;
  for (std::string const number : {"000000", "000001"}) {
    std::string const path = folder / "out/snapshots/" + number;
    Grid const grid(path + ".vtu");
    Table const nodes = read_csv(path + ".csv");
    auto const written = read_csv(path + ".cells.csv")["pressure"], shown = grid.array<double>("pressure"),
               points = grid.array<double>("Points"), jacobians = grid.array<double>("jacobian");
    BOOST_TEST(grid.points == 98u);
    BOOST_REQUIRE(grid.cells == 96u);
    BOOST_REQUIRE(written.size() == 96u);
    for (unsigned char const type : grid.array<unsigned char>("types")) BOOST_TEST(type == 9);
    double change = 0;
    for (std::size_t k = 0; k < 96; ++k) {
      BOOST_TEST(std::abs(shown[k] - written[k]) <= 1e-14);
      // The cell keeps its area on the sphere, and that of its edges, which are straight, to their bend.
      BOOST_TEST(std::abs(jacobians[k] - 1) <= 0.1);
      if (!first.empty()) change = std::max(change, std::abs(written[k] - first[k]));
    }
    BOOST_TEST((first.empty() || change >= 1e-2));
    first = written;
    for (std::size_t k = 0; k < 98; ++k) {
      BOOST_TEST(points[3 * k + 2] == nodes["z"][k]);
      BOOST_TEST(std::abs(std::hypot(points[3 * k], points[3 * k + 1], points[3 * k + 2]) - 1) <= 1e-14);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_grid_has_the_same_numbers_and_closes_its_seams) {
  Folder const folder;
  run_in(folder, sheared());
  for (char const* number : {"000000", "000002"}) {
    Grid const grid(folder / "out/snapshots/" + number + ".vtu");
    Table const nodes = read_csv(folder / "out/snapshots/" + number + ".csv");
    BOOST_TEST(grid.cells == 32u);
    BOOST_TEST(grid.points == 9u * 5u);
    for (char const* const part : {"compressor=\"vtkZLibDataCompressor\"", "header_type=\"UInt64\"",
                                   "Name=\"TimeValue\" NumberOfTuples=\"1\""})
      BOOST_TEST(grid.head().find(part) != std::string::npos, part);
    auto const places = grid.array<double>("Points"), reference = grid.array<double>("reference"),
               velocity = grid.array<double>("velocity");
    BOOST_REQUIRE(places.size() == 3 * grid.points);
    for (std::size_t k = 0; k < 32; ++k) {
      BOOST_TEST(places[3 * k] == nodes["x"][k]);
      BOOST_TEST(places[3 * k + 1] == nodes["y"][k]);
      BOOST_TEST(places[3 * k + 2] == 0);
      BOOST_TEST(reference[3 * k] == nodes["X"][k]);
      BOOST_TEST(velocity[3 * k + 1] == nodes["v"][k]);
    }
    // Every cell goes around counterclockwise with its whole area.
    auto const corners = grid.array<std::int64_t>("connectivity"), ends = grid.array<std::int64_t>("offsets");
    BOOST_TEST(ends.back() == 4 * 32);
    for (unsigned char const type : grid.array<unsigned char>("types")) BOOST_TEST(type == 9);
    double area = 0;
    for (std::size_t c = 0; c < grid.cells; ++c)
      for (std::size_t k = 0; k < 4; ++k) {
        auto const a = static_cast<std::size_t>(3 * corners[4 * c + k]),
                   b = static_cast<std::size_t>(3 * corners[4 * c + (k + 1) % 4]);
        area += 0.5 * (reference[a] * reference[b + 1] - reference[a + 1] * reference[b]);
      }
    BOOST_TEST(std::abs(area - 0.5) <= 1e-14);
    // A shear has no stress along x; VTK has the diagonal first, and the names say so.
    auto const stress = grid.array<double>("stress");
    BOOST_REQUIRE(stress.size() == 3 * grid.cells);
    for (std::size_t c = 0; c < grid.cells; ++c) BOOST_TEST(std::abs(stress[3 * c]) <= 1e-13);
    BOOST_TEST(grid.head().find("ComponentName0=\"XX\" ComponentName1=\"YY\" ComponentName2=\"XY\"") !=
               std::string::npos);
    BOOST_TEST(grid.array<double>("jacobian").size() == grid.cells);
  }
}

BOOST_AUTO_TEST_CASE(the_list_of_grids_has_each_with_its_time_after_a_resumption_as_well) {
  Folder const folder;
  run_in(folder, sheared());
  std::string const path = folder / "out/snapshots/series.pvd", list = contents(path);
  for (char const* const entry :
       {"timestep=\"0\" group=\"\" part=\"0\" file=\"000000.vtu\"", "file=\"000001.vtu\"",
        "file=\"000002.vtu\"", "</Collection>\n</VTKFile>\n"})
    BOOST_TEST(list.find(entry) != std::string::npos, list);
  BOOST_TEST(actio({"resume", folder / "out", "--until", "0.4"}).status == 0);
  std::string const longer = contents(path);
  BOOST_TEST(longer.find("file=\"000004.vtu\"") != std::string::npos, longer);
  BOOST_TEST(Grid(folder / "out/snapshots/000004.vtu").cells == 32u);
}

BOOST_AUTO_TEST_CASE(snapshots_that_were_removed_are_named_when_a_run_goes_on) {
  Folder const folder;
  run_in(folder, sheared());
  for (char const* const ending : {".csv", ".vtu"})
    std::filesystem::remove(folder / "out/snapshots/000001" + ending);
  std::string const says = "snapshots/000001.csv is not in " + folder / "out any more; a run of the scene";
  auto const finished = actio({"resume", folder / "out"});
  BOOST_TEST((finished.status == 0 && finished.err.find(says) == 0u), finished.err);
  auto const longer = actio({"resume", folder / "out", "--until", "0.4"});
  BOOST_TEST((longer.status == 0 && longer.err.find(says) != std::string::npos), longer.err);
  BOOST_TEST(contents(folder / "out/summary.json").find(says) != std::string::npos);
  std::string const list = contents(folder / "out/snapshots/series.pvd");
  BOOST_TEST(list.find("000001.vtu") == std::string::npos, list);
  BOOST_TEST((list.find("000002.vtu") != std::string::npos && list.find("000004.vtu") != std::string::npos),
             list);
  for (int k = 0; k < 5; ++k)
    std::filesystem::remove(folder / ("out/snapshots/00000" + std::to_string(k) + ".csv"));
  BOOST_TEST(actio({"resume", folder / "out"}).err.find(" and 2 others are not in ") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(frames_in_hdf5_are_the_tables_one_after_the_other) {
  Folder const folder;
  Medium scene = sheared();
  scene.output =
      "formats = [\"csv\", \"hdf5\"]\nsnapshots = [\"jacobian\", \"stress\"]\nsnapshot_every = 0.1\n";
  run_in(folder, scene);
  std::string const path = folder / "out/snapshots/frames.h5";
  std::vector<unsigned long long> extent;
  BOOST_TEST((read_hdf5_numbers(path, "time", &extent) == std::vector<double>{0, 0.1, 0.2}));
  auto const place = read_hdf5_numbers(path, "position", &extent);
  BOOST_TEST((extent == std::vector<unsigned long long>{3, 32, 2}));
  auto const velocity = read_hdf5_numbers(path, "velocity"), jacobian = read_hdf5_numbers(path, "jacobian"),
             stress = read_hdf5_numbers(path, "stress", &extent);
  BOOST_TEST((extent == std::vector<unsigned long long>{3, 32, 3}));
  auto const reference = read_hdf5_numbers(path, "reference");
  for (std::size_t k = 0; k < 3; ++k) {
    Table const table = read_csv(folder / "out/snapshots/00000" + std::to_string(k) + ".csv");
    for (std::size_t i = 0; i < 32; ++i) {
      std::size_t const at = 32 * k + i;
      BOOST_TEST(table.rows[i] == (std::vector<double>{reference[2 * i], reference[2 * i + 1], place[2 * at],
                                                       place[2 * at + 1], velocity[2 * at],
                                                       velocity[2 * at + 1], jacobian[at], stress[3 * at],
                                                       stress[3 * at + 1], stress[3 * at + 2]}),
                 boost::test_tools::per_element());
    }
  }
  // Cells go around counterclockwise, and those at a seam are closed by the period beyond it.
  auto const cells = read_hdf5_numbers(path, "cells"), beyond = read_hdf5_numbers(path, "beyond"),
             periods = read_hdf5_numbers(path, "periods");
  BOOST_TEST((periods == std::vector<double>{1, 0.5}));
  auto const corner = [&](std::size_t cell, std::size_t k, std::size_t a) {
    auto const node = static_cast<std::size_t>(cells[4 * cell + k]);
    return reference[2 * node + a] + beyond[2 * (4 * cell + k) + a] * periods[a];
  };
  for (std::size_t c = 0; c < 32; ++c) {
    double area = 0;
    for (std::size_t k = 0; k < 4; ++k)
      area +=
          0.5 * (corner(c, k, 0) * corner(c, (k + 1) % 4, 1) - corner(c, k, 1) * corner(c, (k + 1) % 4, 0));
    BOOST_TEST(std::abs(area - 0.5 / 32) <= 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(frames_of_a_run_that_was_killed_are_those_of_an_unbroken_one) {
  Folder const folder;
  Medium scene = sheared();
  scene.until = "60", scene.every = "1";
  scene.output = "formats = [\"hdf5\"]\nsnapshots = [\"pressure\"]\nsnapshot_every = 0.1\n";
  std::string const file = folder.write("medium.toml", scene.text()), whole = folder / "whole",
                    out = folder / "out", frames = out + "/snapshots/frames.h5";
  BOOST_REQUIRE(actio({"run", file, "--out", whole, "--quiet"}).status == 0);
  auto const all = read_hdf5_numbers(whole + "/snapshots/frames.h5", "position");
  BOOST_REQUIRE(all.size() == 601u * 32 * 2);
  // Killed when it has so many snapshots; the frames that are there are whole, and the beginning of all.
  std::size_t left = 0;
  for (int const kill_at : {20, 200, 350}) {
    std::string const begin = left == 0 ? "run " + file + " --out " + out : "resume " + out;
    shell("export ACTIO_CHECKPOINT_SECONDS=0.001; $ACTIO " + begin + " --quiet & run=$!; while [ $(cat " +
          out + "/snapshots/times.csv 2>/dev/null | wc -l) -lt " + std::to_string(kill_at) + " -o ! -e " +
          frames + " ] && kill -0 $run; do sleep 0.002; done; kill -9 $run; wait $run");
    auto const time = read_hdf5_numbers(frames, "time"), place = read_hdf5_numbers(frames, "position");
    BOOST_TEST(time.size() >= left);
    BOOST_TEST(place.size() == 64 * time.size());
    BOOST_TEST((std::equal(place.begin(), place.end(), all.begin())));
    left = time.size();
    BOOST_TEST_REQUIRE(left > 0u);
  }
  auto const resumed = actio({"resume", out, "--quiet"});
  BOOST_TEST_REQUIRE(resumed.status == 0, resumed.err);
  BOOST_TEST((contents(frames) == contents(whole + "/snapshots/frames.h5")));
  // A file that was damaged since is made anew.
  std::filesystem::resize_file(frames, std::filesystem::file_size(frames) / 2);
  BOOST_TEST(actio({"resume", out, "--until", "61"}).status == 0);
  BOOST_TEST(read_hdf5_numbers(frames, "time").size() == 611u);
}

BOOST_AUTO_TEST_CASE(the_reader_of_vtk_opens_them) {
  if (shell("python3 -c 'import vtk'").status != 0) {
    BOOST_TEST_MESSAGE("VTK for Python is not installed, and is not asked");
    return;
  }
  Folder const folder;
  run_in(folder, sheared());
  std::string const script = folder.write(
      "read.py",
      "import sys, vtk\nreader = vtk.vtkXMLUnstructuredGridReader()\nreader.SetFileName(sys.argv[1])\n"
      "reader.Update()\ngrid = reader.GetOutput()\n"
      "print(grid.GetNumberOfPoints(), grid.GetNumberOfCells(), "
      "grid.GetCellData().GetArray('jacobian').GetRange()[0] > 0.99, "
      "grid.GetFieldData().GetArray('TimeValue').GetValue(0))\n");
  auto const told = shell("python3 " + script + " " + folder / "out/snapshots/000001.vtu");
  BOOST_TEST(told.out == "45 32 True 0.1\n", told.out << told.err);
}

BOOST_AUTO_TEST_SUITE_END()
