// Hundreds of scenes with one fault each: every one is refused with the place of its fault, at once, and
// leaves nothing behind.
#include <cstdlib>
#include <iterator>

#include <boost/test/unit_test.hpp>

#include "malformed_scenes.hpp"
#include "process.hpp"

namespace {

unsigned seed() {
  char const* const text = std::getenv("ACTIO_TEST_SEED");
  return text ? static_cast<unsigned>(std::strtoul(text, nullptr, 10)) : 1971;
}

std::vector<command::GoodScene> good_scenes() {
  auto const scene = [](std::string const& name) {
    return command::GoodScene(name, command::contents(ACTIO_DATA "/scenes/" + name + ".toml"));
  };
  return {{"made up", command::apophis()}, scene("thin_rod"), scene("so4_body"), scene("nodding_top")};
}

/// Pages of memory touched by all that was started and has ended.
long pages() {
  rusage used = {};
  ::getrusage(RUSAGE_CHILDREN, &used);
  return used.ru_minflt;
}

/// Pages that it takes to read a scene that is in order, and no more; of the largest.
long pages_to_read() {
  static long const most = [] {
    long pages_of_largest = 0;
    for (auto const& scene : good_scenes()) {
      command::Folder const folder;
      long const before = pages();
      command::actio({"run", folder.write("scene.toml", scene.text()), "--dry-run"});
      pages_of_largest = std::max(pages_of_largest, pages() - before);
    }
    return pages_of_largest;
  }();
  return most;
}

/// One line that a terminal may show.
bool is_one_plain_line(std::string const& text) {
  if (text.size() < 2 || text.back() != '\n') return false;
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    auto const c = static_cast<unsigned char>(text[i]), next = static_cast<unsigned char>(text[i + 1]);
    if (c < 0x20 || c == 0x7f || (c == 0xc2 && next < 0xa0)) return false;
  }
  return true;
}

/// What is wrong with the way in which a fault is met; empty where nothing is.
std::string misses(command::Malformed const& fault) {
  command::Folder const folder;
  std::string const path = folder.write("scene.toml", fault.text);
  std::vector<std::string> arguments{"run", path};
  for (auto const& set : fault.set) arguments.insert(arguments.end(), {"--set", set});
  long const most = 10 * pages_to_read(), before = pages();
  auto const outcome = command::actio(arguments);
  long const touched = pages() - before;

  std::string const file = fault.set.empty() ? path : "--set " + fault.set.back();
  std::string place = fault.line          ? file + ":" + std::to_string(fault.line) + ":"
                      : fault.set.empty() ? file + ":"
                                          : "--set ";
  if (fault.line && fault.column) place += std::to_string(fault.column) + ": ";
  std::string wrong;
  if (outcome.status != 2) wrong += "the status is " + std::to_string(outcome.status) + "; ";
  if (!outcome.err.starts_with(place)) wrong += "the place is not " + place + "; ";
  if (outcome.err.find(fault.says) == std::string::npos) wrong += "it does not say '" + fault.says + "'; ";
  if (!is_one_plain_line(outcome.err)) wrong += "it is not one plain line; ";
  if (outcome.err.size() > 2000) wrong += "it is very long; ";
  if (!outcome.out.empty()) wrong += "something was printed; ";
  if (touched > most)
    wrong += std::to_string(touched) + " pages of memory were touched, and " + std::to_string(most) +
             " would do ten times; ";
  if (std::distance(std::filesystem::directory_iterator(std::filesystem::path(path).parent_path()), {}) != 1)
    wrong += "files were left; ";
  return wrong.empty() ? "" : fault.fault + ": " + wrong + "\n    " + outcome.err.substr(0, 400);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(malformed_scenes)

BOOST_AUTO_TEST_CASE(the_scenes_that_faults_are_planted_in_are_in_order) {
  for (auto const& scene : good_scenes()) {
    command::Folder const folder;
    auto const outcome =
        command::actio({"run", folder.write("scene.toml", scene.text()), "--set", "run.until=1", "--quiet"});
    BOOST_TEST(outcome.status == 0, scene.name << ": " << outcome.err);
  }
}

BOOST_AUTO_TEST_CASE(every_fault_is_refused_at_its_place_and_leaves_nothing) {
  auto const faults = command::malformed_scenes(good_scenes(), seed());
  BOOST_TEST(faults.size() >= 200u);
  for (auto const& fault : faults) {
    std::string const wrong = misses(fault);
    BOOST_TEST(wrong.empty(), wrong);
  }
  BOOST_TEST_MESSAGE(faults.size() << " malformed scenes, seed " << seed()
                                   << " (ACTIO_TEST_SEED): each refused at its place");
}

BOOST_AUTO_TEST_CASE(what_a_complaint_offers_instead_is_taken_as_it_is_written) {
  // A key, a value of it that is refused, and the words before the one that would do.
  struct Offer {
    std::string key, wrong, before, after;
  };
  for (auto const& scene : good_scenes())
    for (Offer const& offer : {Offer{"attitude", "[0.3, -0.7, 0.1, 0.4]", "normalised it is ", "\n"},
                               {"attitude", "[1e-200, 2e-200, 0, 1e-210]", "normalised it is ", "\n"},
                               {"attitude", "[1.000000002, 0, 0, 0]", "normalised it is ", "\n"},
                               {"step", "0.0123456789", "the nearest step that would do is ", "\n"},
                               {"step", "0.00077", "the nearest step that would do is ", "\n"},
                               {"quantities", "[\"enrgy\"]", "did you mean '", "'?"}}) {
      if (!scene.has(offer.key) || (offer.key == "step" && scene.is_exact())) continue;
      command::Folder const folder;
      auto const refused =
          command::actio({"run", folder.write("scene.toml", scene.with(offer.key, offer.wrong).text)});
      auto const at = refused.err.find(offer.before);
      BOOST_REQUIRE_MESSAGE(at != std::string::npos, scene.name << ": " << refused.err);
      std::string value = refused.err.substr(at + offer.before.size());
      value = value.substr(0, offer.key == "step" ? value.find_first_of(",\n") : value.find(offer.after));
      if (offer.key == "quantities") value = "[\"" + value + "\"]";
      auto const taken = command::actio({"run", folder.write("scene.toml", scene.with(offer.key, value).text),
                                         "--set", "run.until=1", "--quiet"});
      BOOST_TEST(taken.status == 0, scene.name << ", " << offer.key << " = " << value << ": " << taken.err);
    }
}

BOOST_AUTO_TEST_SUITE_END()
