// Runs the checks of this program, each in the columns that its source is meant for.
//
//   checks_ch03 [ID...] [--columns prime,rational,double,50,100,ball|all] [--digits N] [--modulo P] [--balls]
//   [--points N] [--seed N]
//               [--source ch03_2] [--report DIR] [--quick] [--brief]
//   checks_ch03 --list          the statements as JSON, one a line: id, source, chapter, columns, title
//   checks_ch03 --sources       the sources, one a line
//
// --quick tries a tenth of the points in the prime field. --digits adds a column of N decimal digits, --balls
// one of balls; --modulo takes another prime. With --report, DIR/SOURCE_SCALAR.json receives the records,
// failed ones included; what an earlier program left there of this chapter's sources and is no more is
// removed. Status: 0 all passed, 1 a check failed, 2 wrong use, 4 a report could not be written.
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include <nlohmann/json.hpp>

#include "actio/numbers/square_root.hpp"
#include "book/json.hpp"
#include "statement.hpp"
#include "witness/number_counts.hpp"

namespace actio::checks {

std::vector<Check>& all_checks() {
  static std::vector<Check> checks;
  return checks;
}
bool add_check(Check const& check) {
  all_checks().push_back(check);
  return true;
}

std::vector<std::string> const& all_columns() {
  static std::vector<std::string> const columns = {"prime", "rational", "double", "50", "100", "ball"};
  return columns;
}

namespace {

std::map<std::string, std::string>& columns_by_source() {
  static std::map<std::string, std::string> columns;
  return columns;
}

}  // namespace

bool set_columns(char const* source, char const* columns) {
  columns_by_source()[source] = columns;
  return true;
}
std::vector<std::string> columns_of(std::string const& source) {
  auto const named = columns_by_source().find(source);
  std::istringstream words(named == columns_by_source().end() ? "prime rational double 50 100"
                                                              : named->second);
  std::vector<std::string> columns;
  for (std::string word; words >> word;) columns.push_back(word);
  return columns;
}

}  // namespace actio::checks

namespace {

using namespace actio;
using actio::checks::Check;
using actio::checks::Claim;
using actio::checks::Record;
using nlohmann::ordered_json;
namespace fs = std::filesystem;

/// Wrong use: one line, and status 2.
struct Usage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Options {
  std::vector<std::string> ids, columns = {"all"};
  std::string report, source;
  std::uint64_t seed = 20000518, modulus = Arithmetic::mersenne;
  std::optional<int> digits;
  int points = 0;  // 0: as many as the column has
  bool balls = false, brief = false, quick = false, list = false, sources = false;
};

/// Points of a statement in the prime field, over all its models: this many, or as many as the products of
/// the budget allow.
struct Effort {
  int points;
  std::uint64_t products;
};
constexpr Effort full_effort{1000, 40'000'000}, quick_effort{100, 2'000'000};
constexpr int rounded_points = 3, rational_points = 3;

std::string stem_of(std::string const& path) { return fs::path(path).stem().string(); }
/// `ch03` from `ch03_2`.
std::string chapter_of(std::string const& stem) { return stem.substr(0, stem.find('_')); }

/// One column of one check.
struct Column {
  std::string name;
  Arithmetic arithmetic;
};

Arithmetic arithmetic_of(std::string const& column, Options const& options) {
  if (column == "prime") return Arithmetic::prime_field(options.modulus);
  if (column == "rational") return Arithmetic::rationals();
  if (column == "double") return Arithmetic::hardware();
  if (column == "ball") return Arithmetic::balls(options.digits.value_or(50));
  return Arithmetic::decimal(std::stoi(column));
}

/// The columns that a check runs in.
std::vector<Column> columns_for(Check const& check, Options const& options) {
  auto const meant = checks::columns_of(check.source);
  bool const all = options.columns.size() == 1 && options.columns.front() == "all";
  bool const asked = options.digits || options.balls;
  std::vector<Column> columns;
  for (auto const& name : checks::all_columns()) {
    bool const fits = std::count(meant.begin(), meant.end(), name) > 0;
    bool const wanted = all ? name != "ball" && !(asked && options.columns.empty())
                            : std::count(options.columns.begin(), options.columns.end(), name) > 0;
    if (wanted && fits) columns.push_back({name, arithmetic_of(name, options)});
  }
  if (options.digits && !options.balls) {
    if (std::count(meant.begin(), meant.end(), "50") == 0)
      throw Usage(std::string(check.id) + " is not meant for decimal digits, only for: " + [&] {
        std::string text;
        for (auto const& name : meant) text += (text.empty() ? "" : ", ") + name;
        return text;
      }());
    columns.push_back({std::to_string(*options.digits), Arithmetic::decimal(*options.digits)});
  }
  if (options.balls) {
    if (std::count(meant.begin(), meant.end(), "ball") == 0)
      throw Usage(std::string(check.id) + " has no claim for balls; digits will do: --digits 100");
    columns.push_back({"ball", arithmetic_of("ball", options)});
  }
  return columns;
}

/// Points that a statement has been tried at: over all its models, for what was tried most.
int points_of(Record const& record) {
  std::map<std::string, int> points;
  for (auto const& e : record.evidence)
    if (e.kind != "order") points[e.what] += e.points;
  int most = 1;
  for (auto const& [what, count] : points) most = std::max(most, count);
  return most;
}

/// One call of the body. @return whether the draw served; where a divisor vanished or a root was missing it
/// did not
bool called(Check const& check, Claim<Number>& claim) {
  forget_roots();
  try {
    check.body(claim, claim.draw);
    return true;
  } catch (DivisionByZero const&) {
  } catch (Singular const&) {
    if (!current_arithmetic().exact()) throw;
  } catch (NotASquare const&) {
  }
  ++claim.record.redrawn;
  return false;
}

/// The degrees of the identities of a check, by one point in the prime field; none where the check is not
/// meant for it.
std::map<std::string, double> measured_degrees(Check const& check, Options const& options) {
  std::map<std::string, double> degrees;
  auto const meant = checks::columns_of(check.source);
  if (std::count(meant.begin(), meant.end(), "prime") == 0) return degrees;
  WithArithmetic const field(Arithmetic::prime_field());
  Claim<Number> claim(check.id, check.title, "prime", options.seed);
  try {
    for (int attempt = 0; attempt < 5000 && !called(check, claim); ++attempt) {
    }
  } catch (Error const&) {
  }
  for (auto const& e : claim.record.evidence) degrees[e.what + " (" + e.model + ")"] = e.degree;
  return degrees;
}

/// A check in one column.
Record run(Check const& check, Column const& column, Options const& options) {
  auto const start = std::chrono::steady_clock::now();
  Record record;
  Arithmetic arithmetic = column.arithmetic;
  for (int attempt = 0;; ++attempt) {
    std::map<std::string, double> degrees;
    if (arithmetic.kind() == ArithmeticKind::rational) degrees = measured_degrees(check, options);
    WithArithmetic const in_force(arithmetic);
    Claim<Number> claim(check.id, check.title, arithmetic.name(), options.seed);
    claim.degrees = &degrees;
    bool again = false;
    try {
      Effort const effort = options.quick ? quick_effort : full_effort;
      bool const field = arithmetic.kind() == ArithmeticKind::prime;
      int const wanted = options.points       ? options.points
                         : field              ? effort.points
                         : arithmetic.exact() ? rational_points
                                              : rounded_points;
      std::uint64_t const before = operations_done();
      int passes = 1, served = 0;
      while (served < passes && claim.record.failures.empty()) {
        claim.pass = served;
        if (!called(check, claim)) {
          // A check that asks for several squares at once finds them in one draw of some hundreds.
          if (claim.record.redrawn > 5000 + 500 * served)
            throw Error(
                "thousands of draws have no inverse or no root: the model does not fit this arithmetic");
          continue;
        }
        if (++served > 1) continue;
        passes = wanted;
        if (field) {
          passes = (wanted + points_of(claim.record) - 1) / points_of(claim.record);
          if (!options.points)
            passes = std::min<std::uint64_t>(passes, 2 + effort.products / (1 + operations_done() - before));
        }
      }
      claim.judge_controls();
    } catch (Undecided const& undecided) {
      // More digits may tell.
      again = arithmetic.kind() == ArithmeticKind::ball && attempt < 5;
      if (!again) claim.fail(std::string("threw: ") + undecided.what());
    } catch (std::exception const& error) {
      claim.fail(std::string("threw: ") + error.what());
    }
    record = std::move(claim.record);
    if (!again) break;
    arithmetic = Arithmetic::balls(2 * arithmetic.digits());
  }
  record.source = "proofs_checks/" + fs::path(check.source).filename().string();
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (record.verdict.empty()) record.failures.push_back("no verdict was given");
  return record;
}

// ---- What is told

ordered_json in_json(Record const& r) {
  auto const number = [](double x) { return std::isfinite(x) ? ordered_json(x) : ordered_json(nullptr); };
  ordered_json evidence = ordered_json::array(), control = ordered_json::array();
  for (auto const& e : r.evidence)
    evidence.push_back({{"what", e.what},
                        {"kind", e.kind},
                        {"scalar", e.scalar},
                        {"model", e.model},
                        {"measured", number(e.measured)},
                        {"bound", number(e.bound)},
                        {"epsilon", number(e.epsilon)},
                        {"steps", e.steps},
                        {"errors", e.errors},
                        {"slope", number(e.slope)},
                        {"spread", number(e.spread)},
                        {"degree", number(e.degree)},
                        {"points", e.points},
                        {"probability", number(e.probability)},
                        {"margin", number(e.margin)}});
  for (auto const& c : r.control)
    control.push_back({{"what", c.what},
                       {"scalar", c.scalar},
                       {"model", c.model},
                       {"measured", number(c.measured)},
                       {"median", number(c.median)},
                       {"floor", number(c.floor)},
                       {"points", c.points}});
  return {{"id", r.id},
          {"title", r.title},
          {"verdict", r.verdict},
          {"printed", r.printed},
          {"corrected", r.corrected},
          {"note", r.note},
          {"left", r.left},
          {"first", r.first},
          {"scan", r.scan},
          {"scalar", r.scalar},
          {"evidence", evidence},
          {"control", control},
          {"failures", r.failures},
          {"seed", r.seed},
          {"redrawn", r.redrawn},
          {"source", r.source},
          {"seconds", number(r.seconds)}};
}

void tell(Record const& r, bool brief) {
  std::ostringstream out;
  out << r.scalar << ' ' << r.id << " [" << r.verdict << "]";
  if (r.redrawn) out << ", " << r.redrawn << " draws drawn again";
  if (!brief) {
    for (auto const& e : r.evidence) {
      out << "\n    " << e.what << " (" << e.model << "): ";
      if (e.kind == "order")
        out << "order " << e.slope << " +- " << e.spread;
      else if (e.kind == "enclosure")
        out << (e.measured == 0 ? "decided in " : "not decided in ") << e.points << " boxes, margin "
            << e.margin;
      else if (e.epsilon > 0)
        out << e.measured / e.epsilon << " epsilon, allowed " << e.bound / e.epsilon;
      else
        out << e.measured << " at " << e.points << " points";
      if (e.kind == "exact" && e.degree > 0)
        out << ", degree at most " << e.degree << ", a false one passes with probability below "
            << e.probability;
    }
    for (auto const& c : r.control)
      out << "\n    control: " << c.what << " (" << c.model << "): " << c.measured << ", median " << c.median
          << ", floor " << c.floor;
  }
  out << '\n';
  std::cout << out.str();
  for (auto const& failure : r.failures)
    std::cout << "FAILED " << r.scalar << ' ' << r.id << ": " << failure << '\n';
  std::cout.flush();
}

/// Removes reports of this chapter's sources that are no more: the ledger would still count them.
void forget_reports(Options const& options, std::set<std::string> const& written) {
  std::set<std::string> chapters, sources;
  for (Check const& check : checks::all_checks())
    sources.insert(stem_of(check.source)), chapters.insert(chapter_of(stem_of(check.source)));
  for (auto const& entry : fs::directory_iterator(options.report)) {
    std::string const stem = entry.path().stem().string(), source = stem.substr(0, stem.rfind('_'));
    if (entry.path().extension() != ".json" || !chapters.contains(chapter_of(stem)) || written.contains(stem))
      continue;
    if (!sources.contains(source)) fs::remove(entry.path());
  }
}

/// The statements as JSON, each on a line of its own, in the order of their sources: which of these are
/// compiled together changes nothing.
std::string listed() {
  std::string list;
  auto all = checks::all_checks();
  std::stable_sort(all.begin(), all.end(),
                   [](Check const& a, Check const& b) { return stem_of(a.source) < stem_of(b.source); });
  for (Check const& check : all)
    list += (list.empty() ? "[\n" : ",\n") +
            ordered_json{{"id", check.id},
                         {"source", "proofs_checks/" + fs::path(check.source).filename().string()},
                         {"chapter", chapter_of(stem_of(check.source))},
                         {"columns", checks::columns_of(check.source)},
                         {"title", check.title}}
                .dump();
  return list + "\n]";
}

// ---- The command line

template <class T>
T number_after(std::string const& key, std::string const& text, T least, T most) {
  T value{};
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < least || value > most)
    throw Usage(key + " wants a whole number from " + std::to_string(least) + " to " + std::to_string(most) +
                ", not '" + text + "'");
  return value;
}

std::vector<std::string> split(std::string const& text) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, ',');)
    parts.push_back(part == "dec50" ? "50" : part == "dec100" ? "100" : part);
  return parts;
}

Options options_from(std::vector<std::string> const& words) {
  Options o;
  bool columns_named = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::string key = words[i], value;
    if (!key.starts_with("--")) {
      o.ids.push_back(key);
      continue;
    }
    bool const flag =
        key == "--balls" || key == "--list" || key == "--sources" || key == "--brief" || key == "--quick";
    if (auto const equals = key.find('='); equals != std::string::npos)
      value = key.substr(equals + 1), key.resize(equals);
    else if (!flag) {
      if (i + 1 == words.size()) throw Usage("option '" + key + "' needs a value");
      value = words[++i];
    }
    if (key == "--columns")
      o.columns = split(value), columns_named = true;
    else if (key == "--digits")
      o.digits = number_after(key, value, Arithmetic::fewest_digits, Arithmetic::most_digits);
    else if (key == "--modulo")
      o.modulus = number_after<std::uint64_t>(key, value, 0, std::numeric_limits<std::uint64_t>::max());
    else if (key == "--points")
      o.points = number_after(key, value, 1, 1'000'000'000);
    else if (key == "--seed")
      o.seed = number_after<std::uint64_t>(key, value, 0, std::numeric_limits<std::uint64_t>::max());
    else if (key == "--report")
      o.report = value;
    else if (key == "--source")
      o.source = value;
    else if (key == "--balls")
      o.balls = true;
    else if (key == "--brief")
      o.brief = true;
    else if (key == "--quick")
      o.quick = true;
    else if (key == "--list")
      o.list = true;
    else if (key == "--sources")
      o.sources = true;
    else
      throw Usage("unknown option '" + key +
                  "'; there are --columns, --digits, --modulo, --balls, --points, --seed, --source, "
                  "--report, --quick, --brief, --list, --sources");
  }
  if (!columns_named && (o.digits || o.balls)) o.columns.clear();
  if (!columns_named && o.modulus != Arithmetic::mersenne) o.columns = {"prime"};
  for (auto const& column : o.columns)
    if (column != "all" &&
        std::count(checks::all_columns().begin(), checks::all_columns().end(), column) == 0)
      throw Usage("unknown column '" + column +
                  "'; there are prime, rational, double, 50, 100, ball and all");
  try {
    Arithmetic::prime_field(o.modulus);
  } catch (OutsideDomain const& refusal) {
    throw Usage(std::string("--modulo: ") + refusal.what());
  }
  return o;
}

/// The checks that were asked for.
std::vector<Check const*> chosen(Options const& o) {
  std::vector<Check const*> out;
  for (Check const& check : checks::all_checks()) {
    for (auto const& column : checks::columns_of(check.source))
      if (std::count(checks::all_columns().begin(), checks::all_columns().end(), column) == 0)
        throw Usage(std::string(check.source) + ": '" + column + "' is no column");
    if (!o.source.empty() && stem_of(check.source) != o.source) continue;
    if (o.ids.empty() || std::count(o.ids.begin(), o.ids.end(), check.id) > 0) out.push_back(&check);
  }
  for (auto const& id : o.ids)
    if (std::none_of(out.begin(), out.end(), [&](Check const* check) { return check->id == id; }))
      throw Usage("this program has no check of '" + id + "'; --list tells which it has");
  if (out.empty())
    throw Usage("there is no source '" + o.source + "' in this program; --sources tells which there are");
  return out;
}

int run_all(Options const& o) {
  std::map<std::string, ordered_json> reports;
  int failed = 0, ran = 0;
  double seconds = 0;
  for (Check const* check : chosen(o)) {
    auto const columns = columns_for(*check, o);
    if (columns.empty() && !o.ids.empty()) {
      std::string meant;
      for (auto const& column : checks::columns_of(check->source))
        meant += (meant.empty() ? "" : ", ") + column;
      throw Usage(std::string(check->id) + " is not meant for these columns; it has: " + meant);
    }
    for (auto const& column : columns) {
      Record const record = run(*check, column, o);
      tell(record, o.brief);
      ++ran, failed += !record.failures.empty(), seconds += record.seconds;
      auto& report = reports[stem_of(check->source) + "_" + record.scalar];
      if (report.is_null()) report = ordered_json::array();
      report.push_back(in_json(record));
    }
  }
  std::cout << ran << " checks run in " << seconds << " s, " << failed << " failed\n";
  if (!o.report.empty()) {
    fs::create_directories(o.report);
    std::set<std::string> written;
    for (auto const& [name, records] : reports) {
      book::json::write_file(fs::path(o.report) / (name + ".json"), records.dump(1) + "\n");
      written.insert(name);
    }
    forget_reports(o, written);
  }
  return failed ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    Options const options = options_from({argv + 1, argv + argc});
    if (options.list) {
      std::cout << listed() << '\n';
      return 0;
    }
    if (options.sources) {
      std::set<std::string> sources;
      for (Check const& check : checks::all_checks()) sources.insert(stem_of(check.source));
      for (auto const& source : sources) std::cout << source << '\n';
      return 0;
    }
    return run_all(options);
  } catch (Usage const& usage) {
    std::cerr << fs::path(argv[0]).filename().string() << ": " << usage.what() << '\n';
    return 2;
  } catch (std::exception const& error) {
    std::cerr << fs::path(argv[0]).filename().string() << ": " << error.what() << '\n';
    return 4;
  }
}
