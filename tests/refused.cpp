// Refusals against the table of reviewed messages.
#include "refused.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <stdexcept>
#include <string>

namespace refused {
namespace {

/// Messages by program and case, with a tab between.
std::multimap<std::string, std::string> const& reviewed() {
  static std::multimap<std::string, std::string> const table = [] {
    std::multimap<std::string, std::string> out;
    std::ifstream in(ACTIO_REFUSALS);
    if (!in) throw std::runtime_error("the table of refusals " ACTIO_REFUSALS " cannot be read");
    for (std::string line; std::getline(in, line);)
      if (auto const last = line.rfind('\t'); last != std::string::npos && line[0] != '#')
        out.emplace(line.substr(0, last), line.substr(last + 1));
    return out;
  }();
  return table;
}

/// In one line, without the folders of this machine.
std::string plain(std::string said) {
  said = std::regex_replace(said, std::regex("(" ACTIO_DATA "|/tmp/)[^\\s,:;']*"), "(a path)");
  said = std::regex_replace(said, std::regex("[\n\t]"), " | ");
  return std::regex_replace(said, std::regex("in \\d+ iterations, residual [^,]*"), "in some iterations");
}

bool same_number(std::string const& a, std::string const& b) {
  double const x = std::strtod(a.c_str(), nullptr), y = std::strtod(b.c_str(), nullptr);
  double const low = std::min(std::abs(x), std::abs(y)), high = std::max(std::abs(x), std::abs(y));
  return std::abs(x - y) <= 1e-6 * high || (high < 1e-11 && high <= 100 * low);
}

/// The same words, and numbers alike.
bool alike(std::string const& a, std::string const& b) {
  static std::regex const number("[-+]?(\\d+\\.?\\d*|\\.\\d+)([eE][-+]?\\d+)?");
  using Iterator = std::sregex_iterator;
  std::size_t at = 0, bt = 0;
  Iterator i(a.begin(), a.end(), number), j(b.begin(), b.end(), number);
  Iterator const end;
  for (; i != end && j != end; ++i, ++j) {
    auto const from = static_cast<std::size_t>(i->position()), to = static_cast<std::size_t>(j->position());
    if (a.substr(at, from - at) != b.substr(bt, to - bt) || !same_number(i->str(), j->str())) return false;
    at = from + i->str().size(), bt = to + j->str().size();
  }
  return i == end && j == end && a.substr(at) == b.substr(bt);
}

/// Of the running case.
std::string key() {
  auto const& running = boost::unit_test::framework::current_test_case();
  auto const& master = boost::unit_test::framework::master_test_suite();
  return std::filesystem::path(master.argv[0]).filename().string() + '\t' + running.full_name();
}

}  // namespace

void check(char const* message) {
  std::string const said = plain(message);
  auto const [begin, end] = reviewed().equal_range(key());
  if (std::any_of(begin, end, [&](auto const& line) { return alike(line.second, said); })) return;
  if (char const* file = std::getenv("ACTIO_WRITE_REFUSALS"))
    std::ofstream(file, std::ios::app) << key() << '\t' << said << '\n';
  BOOST_ERROR("a message that is not among the reviewed ones; as a line of tests/refusals.tsv\n"
              << key() << '\t' << said);
}

}  // namespace refused
