// The report of a program: what it says is printed and kept at the same time.
#include "book/program.hpp"

namespace book {

Program::Program(int argc, char** argv, std::string shows)
    : name_(std::filesystem::path(argv[0]).stem().string()),
      folder_(std::filesystem::path(argv[0]).parent_path() / ".." / "report" / "programs"),
      shows_(std::move(shows)) {
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]) == "--report" && i + 1 < argc) {
      folder_ = argv[++i];
    } else {
      std::cerr << name_ << ": unknown argument '" << argv[i] << "'\nusage: " << name_ << " [--report DIR]\n";
      std::exit(2);
    }
  }
  // A report of an earlier run must not outlive a run that fails.
  std::error_code ignored;
  std::filesystem::remove(report("json"), ignored);
  std::cout << shows_ << "\n\n";
}

void Program::figure(std::string const& name, double value, std::string const& meaning) {
  figure(name, value, number(value), meaning);
}
void Program::figure(std::string const& name, double value, std::string const& shown,
                     std::string const& meaning) {
  if (!std::isfinite(value)) claim(false, "the figure '" + name + "' is a finite number");
  std::cout << "  " << (meaning.empty() ? name : meaning) << ": " << shown << '\n';
  figures_.push_back("{\"name\": " + json::quote(name) + ", \"value\": " + json::number(value) +
                     ", \"text\": " + json::quote(shown) + ", \"meaning\": " + json::quote(meaning) + "}");
}

void Program::table(std::string const& name, Row const& header, std::vector<Row> const& rows,
                    std::string const& caption) {
  std::vector<std::size_t> widths(header.size());
  auto const fit = [&](Row const& row) {
    for (std::size_t i = 0; i < row.size() && i < widths.size(); ++i)
      widths[i] = std::max(widths[i], width(row[i]));
  };
  auto const print = [&](Row const& row) {
    for (std::size_t i = 0; i < row.size() && i < widths.size(); ++i)
      std::cout << "  " << row[i] << std::string(i + 1 < row.size() ? widths[i] - width(row[i]) : 0, ' ');
    std::cout << '\n';
  };
  fit(header);
  for (auto const& row : rows) fit(row);
  std::cout << '\n';
  print(header);
  std::vector<std::string> lines;
  for (auto const& row : rows) {
    print(row);
    lines.push_back(json::strings(row));
  }
  std::cout << '\n';
  tables_.push_back("{\"name\": " + json::quote(name) + ", \"caption\": " + json::quote(caption) +
                    ", \"header\": " + json::strings(header) + ", \"rows\": " + json::array(lines) + "}");
}

void Program::picture(std::string const& name, std::string const& svg, std::string const& caption) {
  auto const file = report(name + ".svg");
  json::write_file(file, svg);
  pictures_.push_back("{\"name\": " + json::quote(name) + ", \"file\": " +
                      json::quote(file.filename().string()) + ", \"caption\": " + json::quote(caption) + "}");
}

void Program::claim(Comparison const& compared, std::string const& what) {
  judge(compared, what);
  failed_ += !compared.holds;
}

void Program::judge(Comparison const& compared, std::string const& what) {
  std::string const figures = compared.said.empty() ? "" : " (" + compared.said + ")";
  if (compared.holds)
    std::cout << "  holds: " << what << figures << '\n';
  else
    std::cerr << name_ << ": a claim does not hold: " << what << figures << '\n';
  claims_.push_back("{\"holds\": " + std::string(compared.holds ? "true" : "false") + ", \"text\": " +
                    json::quote(what) + ", \"measured\": " + json::quote(compared.said) + "}");
}

void Program::motion(std::string const& name, Row const& header,
                     std::vector<std::vector<double>> const& rows) {
  std::vector<std::string> lines;
  for (auto const& row : rows) {
    if (row.size() != header.size())
      throw std::invalid_argument(
          text("motion ", name, ": a row has ", row.size(), " values, the header ", header.size(), " names"));
    std::vector<std::string> cells;
    // Five digits are more than a screen can show.
    for (double const value : row) cells.push_back(number(value, 5));
    lines.push_back(json::array(cells));
  }
  motions_.push_back("{\"name\": " + json::quote(name) + ", \"header\": " + json::strings(header) +
                     ", \"rows\": " + json::array(lines) + "}");
}

void Program::snippet(std::string const& name, std::string const& said) {
  snippets_.push_back("{\"name\": " + json::quote(name) + ", \"said\": " + json::quote(said) + "}");
}

void Program::property(std::string const& name, std::string const& value) {
  properties_ += ",\n " + json::quote(name) + ": " + value;
}

void Program::headline(std::string const& text, double value) {
  if (!std::isfinite(value)) claim(false, "the headline '" + text + "' is a finite number");
  headline_ = "{\"text\": " + json::quote(text) + ", \"value\": " + json::number(value) + "}";
  std::cout << "\n" << text << '\n';
}

int Program::finish() {
  if (headline_.empty()) claim(false, "the program has a headline");
  std::chrono::duration<double> const seconds = std::chrono::steady_clock::now() - start_;
  json::write_file(
      report("json"),
      "{\"chapter\": " + json::quote(name_.substr(0, name_.find('_'))) +
          ",\n \"program\": " + json::quote(name_) + ",\n \"shows\": " + json::quote(shows_) +
          ",\n \"headline\": " + (headline_.empty() ? "null" : headline_) +
          ",\n \"figures\": " + json::array(figures_) + ",\n \"tables\": " + json::array(tables_) +
          ",\n \"pictures\": " + json::array(pictures_) + ",\n \"claims\": " + json::array(claims_) +
          ",\n \"motions\": " + json::array(motions_) + ",\n \"snippets\": " + json::array(snippets_) +
          properties_ + ",\n \"seconds\": " + json::number(std::round(seconds.count() * 1e3) / 1e3) + "}\n");
  return failed_ == 0 ? 0 : 1;
}

}  // namespace book
