// actio export: files for other programs out of what a run has left.
#include <boost/test/unit_test.hpp>

#include <filesystem>

#include "medium_scene.hpp"
#include "sphere_scene.hpp"

BOOST_AUTO_TEST_SUITE(exports)

namespace {

using namespace command;

/// That a run which did not ask for formats has the same files afterwards as one that did.
void check_same_as_asked(std::string const& scene, std::string const& formats,
                         std::vector<std::string> const& files) {
  Folder const folder;
  std::string const file = folder.write("scene.toml", scene), asked = folder / "asked", out = folder / "out";
  std::string list;
  for (char const c : formats) list += c == ',' ? "\", \"" : std::string(1, c);
  BOOST_REQUIRE(actio({"run", file, "--out", out, "--quiet"}).status == 0);
  auto const with =
      actio({"run", file, "--out", asked, "--quiet", "--set", "output.formats=[\"csv\", \"" + list + "\"]"});
  BOOST_TEST_REQUIRE(with.status == 0, with.err);
  for (auto const& name : files) BOOST_TEST(!std::filesystem::exists(out + "/" + name), name);
  auto const made = actio({"export", out, "--formats", formats});
  BOOST_TEST_REQUIRE(made.status == 0, made.err);
  for (auto const& name : files) {
    BOOST_TEST(std::filesystem::exists(out + "/" + name), name);
    // What tells the scene tells its formats.
    if (!name.ends_with(".h5"))
      BOOST_TEST((contents(out + "/" + name) == contents(asked + "/" + name)), name);
  }
  // They are the run's own.
  BOOST_TEST(actio({"run", file, "--out", out, "--quiet", "--force"}).status == 0);
  for (auto const& name : files) BOOST_TEST(!std::filesystem::exists(out + "/" + name), name);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_run_that_asked_for_no_format_can_be_had_in_each) {
  Sphere flow;
  flow.n = "10", flow.more = "snapshots = [\"u\"]\nsnapshot_every = 1\n";
  check_same_as_asked(flow.text(), "hdf5,netcdf", {"series.h5", "snapshots/fields.nc"});
  Medium sheared;
  sheared.kind = "elastic_body", sheared.material = "name = \"neo_hookean\", mu = 1, kappa = 3";
  sheared.mesh = "shape = \"box\", lower = [0, 0], upper = [1, 0.5], cells = [8, 4]";
  sheared.output = "snapshots = [\"pressure\"]\nsnapshot_every = 0.1\n";
  check_same_as_asked(sheared.text(), "vtu,hdf5",
                      {"series.h5", "snapshots/frames.h5", "snapshots/series.pvd", "snapshots/000001.vtu"});
}

BOOST_AUTO_TEST_CASE(what_cannot_be_made_is_refused_by_name) {
  Folder const folder;
  std::string const out = folder / "apophis";
  BOOST_REQUIRE(actio({"run", folder.write("apophis.toml", apophis())}).status == 0);
  auto const refused = [&](std::vector<std::string> arguments, std::string const& says) {
    arguments.insert(arguments.begin(), "export");
    auto const outcome = actio(arguments);
    BOOST_TEST(outcome.status == 2);
    BOOST_TEST(outcome.err == says + "\n");
  };
  refused({out, "--formats", "hdf"},
          "--formats hdf: unknown format 'hdf' of rigid_body, whose runs can be had "
          "as hdf5; did you mean 'hdf5'?");
  refused({out, "--formats", "hdf5,vtu"},
          "--formats hdf5,vtu: unknown format 'vtu' of rigid_body, whose runs can be had as hdf5");
  refused({out}, out + ": the scene asks for no other format than csv; --formats names one: hdf5");
  refused({folder / "nowhere"}, folder / "nowhere" + ": there is no such folder");
  BOOST_TEST(!std::filesystem::exists(out + "/series.h5"));
  Sphere still;
  still.n = "5";
  BOOST_REQUIRE(actio({"run", folder.write("still.toml", still.text())}).status == 0);
  refused({folder / "still", "--formats", "netcdf"},
          "--formats netcdf: netcdf holds snapshots, and the scene of this run asks for none "
          "(output.snapshots)");
}

BOOST_AUTO_TEST_SUITE_END()
