// Units: those of a body of the library, or those that a scene names, on the axes of pictures, in the viewer
// and in HDF5.
#include <boost/test/unit_test.hpp>

#include "command.hpp"
#include "hdf5_table.hpp"

namespace {

using command::actio;

bool has(std::string const& text, std::string const& part) { return text.find(part) != std::string::npos; }

std::string scene(std::string const& system, std::string const& head = "") {
  return head + "[system]\nkind = \"rigid_body\"\n" + system +
         "\n[initial]\nangular_velocity = [1, 2, 3]\n[run]\nuntil = 1\nevery = 0.1\n[output]\n"
         "quantities = [\"attitude\", \"angular_velocity\", \"body_momentum\", \"energy\", \"casimir\"]\n"
         "formats = [\"hdf5\"]\n";
}

/// The units in series.h5, in the order t, angular velocity, momentum, energy, casimir.
std::string units(std::string const& text) {
  command::Folder const folder;
  auto const outcome = actio({"run", folder.write("scene.toml", text)});
  BOOST_TEST(outcome.status == 0, outcome.err);
  auto const table = command::read_hdf5(folder / "scene/series.h5");
  std::string out;
  for (auto const* const name : {"t", "angular_velocity", "body_momentum", "energy", "casimir"})
    out += (out.empty() ? "" : "; ") + table.attributes.at(name).at("unit");
  return out;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(units_of_scenes)

BOOST_AUTO_TEST_CASE(a_body_of_the_library_has_the_units_of_its_moments_and_of_its_time) {
  BOOST_TEST(units(scene("body = \"t_handle\"")) == "s; 1/s; kg m^2/s; J; (kg m^2/s)^2");
  BOOST_TEST(units(scene("body = \"apophis\"")) == "h; 1/h; ratio/h; ratio/h^2; (ratio/h)^2");
}

BOOST_AUTO_TEST_CASE(a_scene_without_units_speaks_in_words) {
  BOOST_TEST(units(scene("inertia = [1, 2, 3]")) == "time; 1/time; energy x time; energy; (energy x time)^2");
}

BOOST_AUTO_TEST_CASE(a_scene_can_name_its_units) {
  auto const named = [](std::string const& table) {
    return units(scene("inertia = [1, 2, 3]", "[scene]\nunits = " + table + "\n"));
  };
  BOOST_TEST(named("{ mass = \"kg\", length = \"m\", time = \"s\" }") == "s; 1/s; kg m^2/s; J; (kg m^2/s)^2");
  BOOST_TEST(named("{ mass = \"t\", length = \"km\", time = \"d\" }") ==
             "d; 1/d; t km^2/d; t km^2/d^2; (t km^2/d)^2");
  BOOST_TEST(named("{ time = \"s\" }") == "s; 1/s; energy x s; energy; (energy x s)^2");
}

BOOST_AUTO_TEST_CASE(units_are_on_the_axes_and_in_the_viewer) {
  command::Folder const folder;
  std::string const path = folder.write("scene.toml", scene("body = \"t_handle\""));
  BOOST_TEST(actio({"run", path, "--plots"}).status == 0);
  BOOST_TEST(has(command::contents(folder / "scene/plots/body_momentum.svg"), "kg m²/s"));
  BOOST_TEST(has(command::contents(folder / "scene/plots/index.html"), "kg m²/s"));
}

BOOST_AUTO_TEST_CASE(a_body_is_shown_with_the_units_of_its_scenes) {
  BOOST_TEST(has(actio({"show", "t_handle"}).out, "angular velocity 1/s, momentum kg m^2/s, energy J"));
  BOOST_TEST(has(actio({"show", "toutatis"}).out, "momentum ratio/d"));
}

BOOST_AUTO_TEST_CASE(what_is_no_unit_is_refused_at_its_place) {
  command::Folder const folder;
  auto const said = [&folder](std::string const& system, std::string const& table) {
    std::string const path = folder.write("scene.toml", scene(system, "[scene]\nunits = " + table + "\n"));
    auto const outcome = actio({"run", path, "--dry-run"});
    BOOST_TEST(outcome.status == 2);
    return outcome.err.substr(std::min(path.size(), outcome.err.size()));
  };
  BOOST_TEST(said("inertia = [1, 2, 3]", "\"SI\"").starts_with(":2:9: units: a table is expected"));
  BOOST_TEST(said("inertia = [1, 2, 3]", "{ time = \"<b>\" }")
                 .starts_with(":2:18: time: the name of a unit is expected"));
  BOOST_TEST(said("inertia = [1, 2, 3]", "{ time = 3 }").starts_with(":2:18: time: a text is expected"));
  BOOST_TEST(said("inertia = [1, 2, 3]", "{ tme = \"s\" }")
                 .starts_with(":2:11: unknown key of [scene.units] 'tme'; did you mean 'time'?"));
  BOOST_TEST(said("body = \"apophis\"", "{ time = \"s\" }")
                 .starts_with(":2:9: units: apophis has its own, h and ratio"));
}

BOOST_AUTO_TEST_SUITE_END()
