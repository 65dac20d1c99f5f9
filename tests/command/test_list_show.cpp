// actio list and actio show: names, and what is told of them.
#include <boost/test/unit_test.hpp>

#include <set>
#include <sstream>

#include "command.hpp"

namespace {

using command::actio;

std::vector<std::string> const lists{"systems", "groups", "methods", "quantities",
                                     "bodies",  "keys",   "scenes"};

std::vector<std::string> lines_of(std::string const& text) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) out.push_back(line);
  return out;
}
std::vector<std::string> names_in(std::string const& list) {
  std::vector<std::string> out;
  for (auto const& line : lines_of(actio({"list", list}).out)) out.push_back(line.substr(0, line.find(' ')));
  return out;
}
bool has(std::string const& text, std::string const& part) { return text.find(part) != std::string::npos; }
/// The lines from `[system]` on.
std::string scene_in(std::string const& text) {
  std::size_t const at = text.find("[system]");
  if (at == std::string::npos) return "";
  // A name may be that of a key as well, which is told behind it.
  std::size_t const end = text.find("\n\n", at);
  return text.substr(at, end == std::string::npos ? end : end + 1 - at);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(list_and_show)

BOOST_AUTO_TEST_CASE(every_list_has_names_and_says_what_they_mean) {
  for (auto const& list : lists) {
    auto const outcome = actio({"list", list});
    BOOST_TEST(outcome.status == 0, outcome.err);
    BOOST_TEST((outcome.err == "" || list == "groups"));
    BOOST_TEST(!outcome.out.empty());
    for (auto const& line : lines_of(outcome.out)) {
      BOOST_TEST(line.find("  ") != std::string::npos, line);
      BOOST_TEST(line.find_first_not_of(' ') == 0u, line);
      BOOST_TEST(line.back() != ' ', line);
    }
  }
}

BOOST_AUTO_TEST_CASE(columns_are_aligned) {
  std::set<std::size_t> second;
  for (auto const& line : lines_of(actio({"list", "bodies"}).out))
    second.insert(line.find_first_not_of(' ', line.find(' ')));
  BOOST_TEST(second.size() == 1u);
}

BOOST_AUTO_TEST_CASE(materials_are_listed_with_their_systems_and_constants_and_shown) {
  auto const outcome = actio({"list", "materials"});
  BOOST_TEST(outcome.status == 0);
  for (auto const& part :
       {"polytropic_gas ", " barotropic_fluid ", " K,gamma ", "neo_hookean ", " elastic_body "})
    BOOST_TEST(has(outcome.out, part), outcome.out);
  std::string const shown = actio({"show", "tait"}).out;
  for (auto const& part : {"a material of barotropic_fluid", "modulus, a pressure", "[system.material]",
                           "name = \"tait\"", "gamma = 7"})
    BOOST_TEST(has(shown, part), shown);
}

BOOST_AUTO_TEST_CASE(how_a_scene_takes_a_group_is_said_beside_the_list) {
  auto const outcome = actio({"list", "groups"});
  BOOST_TEST(has(outcome.err, "kind = \"euler_poincare\", group = "));
  for (auto const& part : {"  w v1 v2  ", "  x1 x2 ..., w1 w2 w3 on SO(3)  ", "  w1 w2 w3 v1 v2 v3  "})
    BOOST_TEST(has(outcome.out, part), part);
}

BOOST_AUTO_TEST_CASE(whatever_is_listed_can_be_shown) {
  for (auto const& list : lists)
    for (auto const& name : names_in(list)) {
      auto const outcome = actio({"show", name});
      BOOST_TEST(outcome.status == 0, name << ": " << outcome.err);
      BOOST_TEST(outcome.out.starts_with(name + ", a"), outcome.out);
    }
}

BOOST_AUTO_TEST_CASE(the_contract_is_in_the_lists) {
  auto const systems = names_in("systems"), bodies = names_in("bodies"), quantities = names_in("quantities"),
             groups = names_in("groups"), methods = names_in("methods");
  auto const all_of = [](std::vector<std::string> const& wanted, std::vector<std::string> const& list) {
    for (auto const& name : wanted) BOOST_TEST(std::count(list.begin(), list.end(), name) >= 1, name);
  };
  all_of({"rigid_body"}, systems);
  all_of({"apophis", "toutatis", "water", "t_handle", "iss", "nesc_brick"}, bodies);
  all_of({"attitude", "angular_velocity", "body_momentum", "spatial_momentum", "energy", "casimir"},
         quantities);
  all_of({"moser_veselov", "natural_chart"}, methods);
  all_of({"R^n", "SO(n)", "SE(2)", "SE(3)", "GL(n)", "SL(n)", "U(n)", "SU(n)", "Sp(2n)", "Aff(1)",
          "Heisenberg", "direct_product", "semidirect_product", "spanned_group"},
         groups);
}

BOOST_AUTO_TEST_CASE(a_list_that_is_not_there_names_those_that_are) {
  for (std::vector<std::string> const& arguments : {std::vector<std::string>{"list"}, {"list", "cities"}}) {
    auto const outcome = actio(arguments);
    BOOST_TEST(outcome.status == 2);
    BOOST_TEST(lines_of(outcome.err).size() == 1u);
    for (auto const& list :
         {"systems", "groups", "methods", "quantities", "bodies", "materials", "keys", "scenes"})
      BOOST_TEST(has(outcome.err, list), list);
  }
  BOOST_TEST(has(actio({"list", "bodeis"}).err, "did you mean 'bodies'?"));
  BOOST_TEST(has(actio({"list", "body"}).err, "did you mean 'bodies'?"));
}

BOOST_AUTO_TEST_CASE(an_unknown_name_is_answered_with_the_nearest) {
  auto const outcome = actio({"show", "enrgy"});
  BOOST_TEST(outcome.status == 2);
  BOOST_TEST(outcome.err.starts_with("actio show: unknown name 'enrgy'; did you mean 'energy'?"),
             outcome.err);
  BOOST_TEST(has(actio({"show", "apofis"}).err, "did you mean 'apophis'?"));
}

BOOST_AUTO_TEST_CASE(an_entry_of_a_table_is_told_with_the_table) {
  for (std::string const name : {"system.mesh.cells", "system.load.traction", "system.load.traction.right",
                                 "system.material.kappa", "system.parameters.c", "system.boundary.left"}) {
    auto const outcome = actio({"show", name});
    BOOST_TEST(outcome.status == 0, name);
    BOOST_TEST(outcome.out.starts_with(name.substr(0, name.find('.', 7)) + ", a key of scenes of"),
               outcome.out);
  }
  BOOST_TEST(actio({"show", "system.mesh.cell_count"}).status == 2);
  BOOST_TEST(has(actio({"show", "circulation"}).out, "yes, and its drift is in summary.json, but not where"));
}

BOOST_AUTO_TEST_CASE(a_name_of_several_systems_is_told_for_each) {
  std::string const systems = actio({"list", "systems"}).out, shown = actio({"show", "energy"}).out;
  for (auto const& line : lines_of(systems))
    BOOST_TEST(has(shown, "energy, a quantity of " + line.substr(0, line.find(' ')) + "\n"), line);
}

BOOST_AUTO_TEST_CASE(a_body_is_told_with_a_spin_that_runs_when_pasted) {
  for (auto const& body : names_in("bodies")) {
    std::string const shown = actio({"show", body}).out;
    for (auto const& part : {"moments", "unit of time", "spin", "source", "derived"})
      BOOST_TEST(has(shown, part), body << " " << part);
    command::Folder const folder;
    std::string const scene = folder.write(
        "scene.toml", scene_in(shown) + "[run]\nuntil = 1\n[output]\nquantities = [\"energy\"]\n");
    auto const outcome = actio({"run", scene, "--dry-run"});
    BOOST_TEST(outcome.status == 0, body << ": " << outcome.err);
  }
}

BOOST_AUTO_TEST_CASE(axes_are_told_of_bodies_that_are_turned_in_the_catalogue_alone) {
  BOOST_TEST(has(actio({"show", "iss"}).out, "axes"));
  BOOST_TEST(!has(actio({"show", "apophis"}).out, "axes"));
}

BOOST_AUTO_TEST_CASE(every_system_has_a_small_scene_that_runs_as_it_is) {
  for (auto const& system : names_in("systems")) {
    command::Folder const folder;
    auto const outcome = actio({"run", folder.write("scene.toml", scene_in(actio({"show", system}).out))});
    BOOST_TEST(outcome.status == 0, system << ": " << outcome.err);
  }
}

BOOST_AUTO_TEST_CASE(a_system_is_told_with_its_parameters_methods_and_quantities) {
  std::string const shown = actio({"show", "rigid_body"}).out;
  for (auto const& part : {"system.inertia", "initial.angular_velocity", "moser_veselov",
                           "order exact, 2, 4, 6, 8, 10", "natural_chart", "spatial_momentum"})
    BOOST_TEST(has(shown, part), part);
}

BOOST_AUTO_TEST_CASE(a_quantity_is_told_with_formula_unit_columns_and_needs) {
  std::string const shown = actio({"show", "angular_velocity"}).out;
  for (auto const& part :
       {"omega = I^-1 M", "1/time", "angular_velocity_x angular_velocity_y angular_velocity_z",
        "body_momentum", "conserved"})
    BOOST_TEST(has(shown, part), part);
  for (auto const& quantity : names_in("quantities"))
    BOOST_TEST(!has(actio({"show", quantity}).out, "\\"), quantity << ": TeX is left");
}

BOOST_AUTO_TEST_CASE(statements_that_are_named_are_told_in_words) {
  BOOST_TEST(has(actio({"show", "energy"}).out, "eq_5_1: rigid body Lagrangian as kinetic energy"));
}

BOOST_AUTO_TEST_CASE(statements_are_found_as_readers_of_the_thesis_write_them) {
  for (auto const& word :
       {"eq_3_10", "(3.10)", "3.10", "equation (3.10)", "eq. 3.10", "Eq 3.10", "equations 3.10"})
    BOOST_TEST(actio({"show", word}).out.starts_with("eq_3_10, a statement"), word);
  for (auto const& word : {"Theorem 3.2.1", "thm_3_2_1", "thm 3.2.1", "Thm. 3.2.1", "theorem(3.2.1)"})
    BOOST_TEST(actio({"show", word}).out.starts_with("thm_3_2_1, a statement"), word);
  // A number that several have.
  std::string const several = actio({"show", "3.2.1"}).out;
  for (auto const& id : {"thm_3_2_1, a", "rem_3_2_1, a", "prop_3_2_1, a"})
    BOOST_TEST(has(several, id), several);
  BOOST_TEST(actio({"show", "1" + std::string(100000, '1') + ".2"}).status == 2);
  for (auto const& word : {"(3.100)", "Theorem 3.10", "Lemma 3.2.1", "(3)", "3.10.", "..", "(3.10"})
    BOOST_TEST((actio({"show", word}).status == 2) == (std::string(word) != "(3.10"), word);
}

BOOST_AUTO_TEST_CASE(a_statement_is_told_with_what_the_book_says_of_it) {
  std::string const theorem = actio({"show", "thm_3_2_1"}).out;
  for (auto const& part :
       {"Discrete Euler-Poincar", "1. The sequence (g_k) is a critical point of the action sum (3.1)",
        "4. It satisfies the discrete Euler-Poincar", "theorem, Theorem 3.2.1"})
    BOOST_TEST(has(theorem, part), theorem);
  // Formulas are in plain letters, references are names.
  std::string const reconstruction = actio({"show", "thm_3_2_3"}).out;
  for (auto const& part : {"then f_(k,k+1) = g_k g_(k+1)^-1 satisfies (3.10).", "g_(k+1) = f_(k,k+1)^-1 g_k"})
    BOOST_TEST(has(reconstruction, part), reconstruction);
  int told = 0;
  std::istringstream registry(command::contents(ACTIO_DATA "/../proofs_checks/registry.tsv"));
  for (std::string line; std::getline(registry, line);) {
    if (line.find("theorem") == std::string::npos && !line.starts_with("eq_3_")) continue;
    std::string const shown = actio({"show", line.substr(0, line.find('\t'))}).out;
    BOOST_TEST(!has(shown, "\\"), shown);
    told += has(shown, "\n  text ");
  }
  BOOST_TEST(told > 20);
}

BOOST_AUTO_TEST_CASE(a_statement_is_told_with_its_verdict_where_there_is_a_ledger) {
  command::Folder const folder;
  std::filesystem::create_directories(folder / "bin"), std::filesystem::create_directories(folder / "report"),
      std::filesystem::create_directories(folder / "book");
  std::filesystem::copy_file(ACTIO_COMMAND, folder / "bin/actio");
  auto const show = [&folder](std::string const& id) {
    return command::shell("'" + (folder / "bin/actio") + "' show " + id).out;
  };
  BOOST_TEST(has(show("eq_3_1"), "actio check eq_3_1 finds its verdict"));
  BOOST_TEST(has(show("eq_3_1"), "ch03.html#eq_3_1 of the book"));
  folder.write("report/statements.json",
               R"json({"statements": [{"id": "eq_3_1", "verdict": "corrected", "printed": "\\sum_{k=1}^N",
 "corrected": "\\sum_{k=0}^{N-1}", "note": "The first is left out."}]})json");
  folder.write("book/ch03.html", "<h2 id=\"eq_3_1\">");
  std::string const shown = show("eq_3_1");
  for (auto const& part :
       {"verdict       corrected", "printed       sum_(k=1)^N", "corrected     sum_(k=0)^(N-1)",
        "note          The first is left out.", "book/ch03.html#eq_3_1\n"})
    BOOST_TEST(has(shown, part), shown);
  folder.write("report/statements.json", "[torn");
  BOOST_TEST(has(show("eq_3_1"), "finds its verdict"));
}

BOOST_AUTO_TEST_CASE(groups_are_found_however_they_are_written) {
  for (auto const& word : {"SO(n)", "so", "SO3", "SO(3)", "so(7)"})
    BOOST_TEST(actio({"show", word}).out.starts_with("SO(n), a group"), word);
  BOOST_TEST(actio({"show", "SU2"}).out.starts_with("SU(2), a group"));
  BOOST_TEST(actio({"show", "su5"}).out.starts_with("SU(n), a group"));
  BOOST_TEST(actio({"show", "Sp(4)"}).out.starts_with("Sp(2n), a group"));
  for (auto const& part : {"SE(2), a group", "SE(3), a group"})
    BOOST_TEST(has(actio({"show", "se"}).out, part), part);
  BOOST_TEST(actio({"show", "se7"}).status == 2);
}

BOOST_AUTO_TEST_CASE(the_velocity_on_a_group_is_told_by_its_components_and_its_matrix) {
  std::string const motions = actio({"show", "SE(2)"}).out;
  for (auto const& part :
       {"components    of SE(2): w v1 v2\n", "velocity      [0, -w, v1]\n", "                [w, 0, v2]\n"})
    BOOST_TEST(has(motions, part), motions);
  for (auto const& word : {"SO(3)", "so3"})
    BOOST_TEST(has(actio({"show", word}).out, "of SO(3): w1 w2 w3"), word);
  BOOST_TEST(has(actio({"show", "so(4)"}).out, "of SO(4): x1 x2 x3 x4 x5 x6"));
  std::string const family = actio({"show", "SO(n)"}).out;
  BOOST_TEST(has(family, "components    x1 x2 ..., w1 w2 w3 on SO(3)"), family);
}

BOOST_AUTO_TEST_CASE(products_of_groups_are_told_as_scenes_name_them) {
  std::string const product = actio({"show", "SL(2) |x R^2"}).out;
  BOOST_TEST(product.starts_with("SL(2) |x R^2, a group of scenes\n"), product);
  for (auto const& part : {"dimension     5", "x1 x2 x3 x4 x5", "[x3, -x1, x5]"})
    BOOST_TEST(has(product, part), product);
  BOOST_TEST(actio({"show", "SO(3) x"}).status == 2);
}

BOOST_AUTO_TEST_CASE(the_header_of_a_group_is_there_and_has_its_type) {
  for (auto const& group : names_in("groups")) {
    std::string header, type;
    for (auto const& line : lines_of(actio({"show", group}).out)) {
      std::istringstream words(line);
      std::string label, value;
      words >> label >> value;
      if (label == "header") header = command::contents(ACTIO_DATA "/../src/" + value);
      if (label == "type")
        type = value.substr(std::string("actio::").size(), value.find('<') - std::string("actio::").size());
    }
    BOOST_TEST(has(header, "struct " + type), group);
  }
}

BOOST_AUTO_TEST_CASE(nothing_is_coloured_in_a_pipe) {
  for (auto const& arguments : {std::vector<std::string>{"show", "energy"}, {"list", "systems"}, {"--help"}})
    BOOST_TEST(!has(actio(arguments).out, "\x1b"));
}

BOOST_AUTO_TEST_CASE(a_terminal_has_bold_headings_unless_NO_COLOR_is_set) {
  if (command::shell("command -v script").status != 0) return;
  BOOST_TEST(has(command::shell("script -qec \"$ACTIO show energy\" /dev/null").out, "\x1b[1menergy"));
  BOOST_TEST(!has(command::shell("NO_COLOR=1 script -qec \"$ACTIO show energy\" /dev/null").out, "\x1b"));
}

BOOST_AUTO_TEST_CASE(a_full_disk_is_status_4_for_lists_too) {
  if (command::shell("test -w /dev/full").status != 0) return;
  BOOST_TEST(command::shell("\"$ACTIO\" list quantities > /dev/full").status == 4);
}

BOOST_AUTO_TEST_SUITE_END()
