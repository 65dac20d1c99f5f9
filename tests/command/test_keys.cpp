// The keys of a scene: what the reader takes, what is told of it, and what it writes back are the same.
#include <boost/test/unit_test.hpp>

#include <nlohmann/json.hpp>

#include <map>
#include <set>
#include <sstream>

#include "command.hpp"

namespace {

using command::actio;
using nlohmann::json;

bool has(std::string const& text, std::string const& part) { return text.find(part) != std::string::npos; }
std::string name_of(std::string const& key) { return key.substr(key.rfind('.') + 1); }
std::string table_of(std::string const& key) { return key.substr(0, key.rfind('.')); }

json systems() { return json::parse(actio({"list", "systems", "--json"}).out); }

/// The small scene of a system, as lines `key = value` by their keys.
std::map<std::string, std::string> example_of(std::string const& system) {
  std::string const shown = actio({"show", system}).out;
  std::map<std::string, std::string> out;
  std::istringstream lines(shown.substr(shown.find("[system]")));
  std::string section;
  // Behind the scene there may be a key of the same name.
  for (std::string line; std::getline(lines, line) && !line.empty();)
    if (line.starts_with('['))
      section = line.substr(1, line.find(']') - 1);
    else if (std::size_t const equals = line.find(" = "); equals != std::string::npos)
      out[section + "." + line.substr(0, equals)] = line.substr(equals + 3);
  return out;
}

/// A scene with these values; the keys say their sections.
std::string scene_of(std::map<std::string, std::string> const& values) {
  std::string out;
  for (auto const& [key, value] : values) out += key + " = " + value + "\n";
  return out;
}

/// `system.inertia` of "or system.inertia; ...", all of "or A or B"; nothing where the key excludes none.
std::set<std::string> excluded_by(json const& key) {
  std::istringstream words(key["fallback"].get<std::string>());
  std::set<std::string> out;
  for (std::string word, name; words >> word && word == "or" && words >> name;)
    out.insert(name.substr(0, name.find(';')));
  return out;
}
void erase(std::map<std::string, std::string>& values, std::set<std::string> const& keys) {
  for (auto const& key : keys) values.erase(key);
}

/// The example of a key put over a scene, without what it excludes; keys of a table come with the others of
/// the table.
std::map<std::string, std::string> with_example(std::map<std::string, std::string> values, json const& key,
                                                json const& all) {
  std::string const name = key["key"], table = table_of(name);
  auto const put = [&values](json const& one) {
    erase(values, excluded_by(one));
    values[one["key"]] = one["example"];
  };
  if (has(table, ".")) {
    values.erase(table);
    for (auto const& other : all) {
      if (other["key"] == table) erase(values, excluded_by(other));
      if (table_of(other["key"]) == table && !excluded_by(key).count(other["key"])) put(other);
    }
    erase(values, excluded_by(key));
    if (values.count("initial.angular_velocity.degrees")) values.erase("initial.angular_momentum");
  }
  put(key);
  return values;
}

/// Steps with constraints conserve the energy in one chart.
void add_conserving(std::map<std::string, std::string>& values, std::string const& system) {
  if (system != "euler_poincare") return;
  values["method.name"] = "\"cayley_chart\"", values["system.constraints"] = "[\"v2 - 0.2*v1\"]";
}

}  // namespace

BOOST_AUTO_TEST_SUITE(keys)

BOOST_AUTO_TEST_CASE(every_key_has_a_whole_record) {
  for (auto const& system : systems())
    for (auto const& key : system["parameters"]) {
      for (auto const* const field : {"key", "expects", "fallback", "meaning", "example"})
        BOOST_TEST(!key[field].get<std::string>().empty(), key["key"] << " has no " << field);
      std::string const meaning = key["meaning"];
      BOOST_TEST(meaning.back() == '.', meaning);
      std::string const expects = key["expects"];
      // A number is in some unit; a count and a direction are not.
      bool const measured = has(expects, "number") && !has(expects, "whole") &&
                            name_of(key["key"]) != "axis" && name_of(key["key"]) != "attitude";
      BOOST_TEST(measured == (key["unit"] != ""), key["key"]);
    }
}

BOOST_AUTO_TEST_CASE(the_example_of_every_key_is_taken_and_planned) {
  command::Folder const folder;
  int tried = 0;
  for (auto const& system : systems()) {
    auto const base = example_of(system["name"]);
    for (auto const& key : system["parameters"]) {
      auto values = with_example(base, key, system["parameters"]);
      // A basis names the components that the formula is in.
      if (key["key"] == "system.algebra")
        values["system.lagrangian"] = "\"x1^2/2\"", values["initial.velocity"] = "[1]";
      // What a scene defines is used by something.
      if (key["key"] == "system.algebra" ||
          (key["key"] == "system.lagrangian" && !has(values["system.lagrangian"], "c*")))
        values.erase("system.parameters");
      if (key["key"] == "system.shape")
        values["system.lagrangian"] = "\"(w^2 + v1^2 + c*v2^2 + angle_rate^2 - angle^2)/2\"",
        values["initial.velocity"] = "[0.1, 0.7, 1.0, 0.2]";
      // Names of a rod are those of its formulas, and loads act on what is free.
      bool const rod = system["name"] == "rod";
      if (rod && key["key"] == "system.parameters") values["initial.velocity"] = "[\"0\", \"r*s\", \"0\"]";
      if (rod && key["key"] == "system.definitions") values["initial.velocity"] = "[\"0\", \"bump\", \"0\"]";
      if (table_of(key["key"]) == "system.load") values.erase("system.boundary");
      if (!rod && key["key"] == "system.definitions")
        values["system.lagrangian"] = "\"(w^2 + v1^2 + side)/2\"";
      if (key["key"] == "method.conserve") add_conserving(values, system["name"]);
      if (key["key"] == "system.contact") values["system.constraints"] = "[\"v2 - 0.2*v1\"]";
      if (key["key"] == "system.inputs") values["system.force"] = "{ v1 = \"thrust\" }";
      if (key["key"] == "system.advected") values["output.quantities"] = "[\"gravity\"]";
      if (key["key"] == "system.loops") values["output.quantities"] = "[\"circulation\"]";
      if (key["key"] == "system.metric" && system["name"] == "vorticity_sphere")
        values["system.averaging"] = "0.1";
      if (key["key"] == "run.chosen_for") values["run.accuracy"] = key["example"];
      // Times of snapshots are for who asks for snapshots.
      if (key["key"] == "output.snapshot_at" || key["key"] == "output.snapshot_every")
        values["output.snapshots"] = "[]";
      // A file is beside the scene.
      if (key["key"] == "initial.file") folder.write("vorticity.csv", "l,m,re,im\n1,0,0.5,0\n1,1,0.2,0.1\n");
      folder.write("coefficients.csv", "m,n,re,im\n1,0,0.5,0\n-2,1,0.2,0.1\n");
      folder.write("kw4.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
      // An orbit is that of something.
      if (table_of(key["key"]) == "system.third_body.orbit") values["system.third_body.mass"] = "1e12";
      std::string const scene = scene_of(values);
      auto const outcome = actio({"run", folder.write("scene.toml", scene), "--dry-run"});
      BOOST_TEST(outcome.status == 0, system["name"] << ", " << key["key"] << ": " << outcome.err << "\n"
                                                     << scene);
      ++tried;
    }
  }
  BOOST_TEST(tried > 40);
}

BOOST_AUTO_TEST_CASE(a_key_that_is_not_in_the_records_is_refused_in_every_table) {
  for (auto const& system : systems()) {
    auto const base = scene_of(example_of(system["name"]));
    command::Folder const folder;
    std::string const path = folder.write("scene.toml", base);
    for (auto const* const table : {"scene", "system", "initial", "method", "run", "output"}) {
      auto const outcome = actio({"run", path, "--dry-run", "--set", std::string(table) + ".zzzzzz=1"});
      BOOST_TEST(outcome.status == 2);
      BOOST_TEST(has(outcome.err, std::string("unknown key of [") + table + "] 'zzzzzz' (known: "),
                 outcome.err);
      // What is known there is what the records say.
      for (auto const& key : system["parameters"])
        if (table_of(key["key"]) == table) BOOST_TEST(has(outcome.err, name_of(key["key"])), outcome.err);
    }
  }
}

BOOST_AUTO_TEST_CASE(what_a_run_writes_back_is_taken_again) {
  command::Folder const folder;
  for (auto const& system : systems()) {
    std::string const scene = folder.write("scene.toml", scene_of(example_of(system["name"])));
    auto const outcome = actio({"run", scene, "--out", folder / "out", "--force"});
    BOOST_TEST(outcome.status == 0, outcome.err);
    auto const again = actio({"run", folder / "out/scene.toml", "--dry-run"});
    BOOST_TEST(again.status == 0, system["name"] << ": " << again.err);
  }
}

BOOST_AUTO_TEST_CASE(words_that_are_allowed_are_those_that_are_taken) {
  command::Folder const folder;
  for (auto const& system : systems())
    for (auto const& key : system["parameters"]) {
      if (key["allowed"].empty() || key["key"] == "system.kind") continue;
      for (auto const& word : key["allowed"]) {
        auto values = example_of(system["name"]);
        erase(values, excluded_by(key));
        std::string const text = word, quoted = "\"" + text + "\"";
        bool const number = text.find_first_not_of("0123456789") == std::string::npos;
        // Of an order, by a method that has it.
        if (key["key"] == "method.order")
          for (auto const& method : system["methods"])
            for (auto const& order : method["orders"])
              if (order == word) values["method.name"] = method["name"].dump();
        values[key["key"]] = has(key["expects"], "list") ? "[" + quoted + "]" : number ? text : quoted;
        // A format of snapshots, where there are snapshots.
        if (text == "netcdf" || text == "vtu") values["output.snapshots"] = "[]";
        // Reactions and contacts are of constraints.
        if (text == "reaction" || text == "constraint" || text == "contact")
          values["system.constraints"] = "[\"v2 - 0.2*v1\"]";
        if (text == "contact") values["system.contact"] = "[\"0.3\", \"0\"]";
        if (key["key"] == "method.conserve") add_conserving(values, system["name"]);
        // Friction has a rate.
        if (text == "conformal" || text == "orbit") values["system.dissipation.rate"] = "0.1";
        // A layer has a radius.
        if (text == "quasi_geostrophic") values["system.deformation"] = "0.3";
        // A metric has a length.
        if (text == "rough" || text == "deformation") values["system.averaging"] = "0.1";
        auto const outcome = actio({"run", folder.write("scene.toml", scene_of(values)), "--dry-run"});
        BOOST_TEST(outcome.status == 0,
                   system["name"] << ", " << key["key"] << " = " << text << ": " << outcome.err);
      }
    }
}

BOOST_AUTO_TEST_CASE(the_list_for_programs_has_every_key_with_its_systems) {
  json const keys = json::parse(actio({"list", "keys", "--json"}).out);
  std::map<std::string, std::set<std::string>> of;
  for (auto const& key : keys)
    for (auto const& system : key["systems"]) of[system].insert(key["key"]);
  for (auto const& system : systems())
    for (auto const& key : system["parameters"])
      BOOST_TEST(of[system["name"]].count(key["key"]) == 1u, key["key"]);
}

BOOST_AUTO_TEST_CASE(keys_are_shown_with_type_default_unit_and_example) {
  std::string const every = actio({"show", "run.every"}).out;
  for (auto const& part : {"run.every, a key of every scene", "a number > 0", "or run.at",
                           "unit          time", "[run] every = 0.1"})
    BOOST_TEST(has(every, part), every);
  std::string const formats = actio({"show", "output.formats"}).out;
  for (auto const& part : {"series.h5", "csv, hdf5", "[\"csv\"]"}) BOOST_TEST(has(formats, part), formats);
  std::string const order = actio({"show", "method.order"}).out;
  // Systems that say the same of a key are told of together.
  std::string of_systems;
  std::istringstream lines(order);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("method.order, a key of scenes of ")) of_systems += line + ',';
  for (auto const& system : systems())
    BOOST_TEST(has(of_systems, ' ' + system["name"].get<std::string>() + ','), order);
  BOOST_TEST(has(actio({"show", "seed"}).out, "with another one a random start is another one"));
  BOOST_TEST(has(actio({"show", "run"}).out, "run.every"));
  BOOST_TEST(has(actio({"show", "run.evry"}).err, "did you mean 'run.every'?"));
}

BOOST_AUTO_TEST_CASE(a_word_of_another_system_is_refused_with_that_system) {
  command::Folder const folder;
  std::string const path = folder.write("scene.toml", command::apophis());
  auto const complaint = [&path](std::string const& change) {
    return actio({"run", path, "--set", change}).err;
  };
  std::string const n = folder.write("n.toml",
                                     "[system]\nkind = \"rigid_body_n\"\nlambda = [1, 2, 3, 4]\n[initial]\n"
                                     "angular_velocity = [1, 2, 3, 4, 5, 6]\n[run]\nuntil = 1\n[output]\n"
                                     "quantities = [\"energy\"]\n");
  BOOST_TEST(
      actio({"run", n, "--set", "method.name=variational"}).err ==
      "--set method.name=variational:1:13: unknown method 'variational': it is a method of rigid_body and "
      "heavy_top, and rigid_body_n has moser_veselov, natural_chart\n");
  BOOST_TEST(has(complaint("output.quantities=[\"energy\", \"spectrum\"]"),
                 ":1:30: unknown quantity 'spectrum': it is a quantity of rigid_body_n, vorticity_sphere "
                 "and vorticity_torus, and rigid_body has attitude, "));
  BOOST_TEST(complaint("system.mass=1") ==
             "--set system.mass=1:1:8: unknown key of [system] 'mass'; it is a key of heavy_top, and "
             "rigid_body takes kind, body, inertia, torque\n");
}

BOOST_AUTO_TEST_CASE(a_whole_number_with_a_point_is_refused_with_the_way_to_write_it) {
  command::Folder const folder;
  std::string const path = folder.write("scene.toml", command::apophis());
  BOOST_TEST(has(actio({"run", path, "--set", "method.order=2.0"}).err,
                 ":1:14: order: a whole number is expected, found 2.0; write 2\n"));
  BOOST_TEST(
      has(actio({"run", path, "--set", "method.order=2.5"}).err, "a whole number is expected, found 2.5\n"));
}

BOOST_AUTO_TEST_SUITE_END()
