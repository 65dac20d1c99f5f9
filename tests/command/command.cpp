#include "command.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace command {

Outcome shell(std::string const& line) {
  Folder const folder;
  std::string const whole = "ACTIO='" ACTIO_COMMAND "'\n{ " + line + "\n} >'" + folder / "out" + "' 2>'" +
                            folder / "err" + "' </dev/null";
  int const status = std::system(whole.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), contents(folder / "out"),
          contents(folder / "err")};
}

Outcome actio(std::vector<std::string> const& arguments, std::string const& before) {
  std::string line = before + " '" ACTIO_COMMAND "'";
  for (auto const& argument : arguments) {
    line += " '";
    for (char const c : argument) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += "'";
  }
  return shell(line);
}

Folder::Folder() {
  std::string name = (std::filesystem::temp_directory_path() / "actio_test_XXXXXX").string();
  if (!::mkdtemp(name.data())) throw std::runtime_error("no folder for the test");
  path_ = name;
}
Folder::~Folder() {
  std::error_code none;
  std::filesystem::remove_all(path_, none);
}
std::string Folder::write(std::string const& name, std::string const& text) const {
  std::ofstream(path_ / name, std::ios::binary) << text;
  return (path_ / name).string();
}

std::string contents(std::string const& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<double> Table::operator[](std::string const& name) const {
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i] == name) {
      std::vector<double> out;
      for (auto const& row : rows) out.push_back(row[i]);
      return out;
    }
  throw std::runtime_error("the table has no column " + name);
}

Table read_csv(std::string const& path) {
  std::string const text = contents(path);
  if (text.empty() || text.back() != '\n') throw std::runtime_error(path + ": does not end with a whole row");
  Table table;
  std::istringstream lines(text);
  std::string line, item;
  std::getline(lines, line);
  for (std::istringstream items(line); std::getline(items, item, ',');) table.columns.push_back(item);
  while (std::getline(lines, line)) {
    std::vector<double> row;
    char const* at = line.c_str();
    for (char* end = nullptr;; at = end + 1) {
      row.push_back(std::strtod(at, &end));
      if (end == at) throw std::runtime_error(path + ": no number in '" + line + "'");
      if (*end != ',') break;
    }
    if (row.size() != table.columns.size())
      throw std::runtime_error(path + ": a row of another length: '" + line + "'");
    table.rows.push_back(row);
  }
  return table;
}

std::string apophis(std::map<std::string, std::string> const& changes) {
  std::string out;
  std::istringstream lines(
      "[scene]\ntitle = \"Apophis\"\n\n[system]\nkind = \"rigid_body\"\nbody = \"apophis\"\n\n[initial]\n"
      "attitude = [1, 0, 0, 0]\nangular_velocity = [0.0649, 0.001, 0.22321]\n\n[method]\n"
      "name = \"moser_veselov\"\norder = \"exact\"\nstep = 0.25\n\n[run]\nuntil = 25.0\nevery = 0.25\n\n"
      "[output]\nquantities = [\"body_momentum\", \"energy\"]\nformats = [\"csv\"]\n");
  for (std::string line; std::getline(lines, line);) {
    auto const change = changes.find(line.substr(0, line.find(' ')));
    if (change == changes.end())
      out += line + "\n";
    else if (!change->second.empty())
      out += change->first + " = " + change->second + "\n";
  }
  return out;
}

}  // namespace command
