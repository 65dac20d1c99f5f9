#include "app/usage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "actio/numbers/nearest_name.hpp"
#include "app/text.hpp"
#include "program/base/printable.hpp"

namespace actio::app {
namespace {

using actio::did_you_mean;

constexpr std::size_t width = 100;

/// `--out DIR`, `SCENE`
std::string written(CLI::Option const& option) {
  std::string const name = option.get_positional() ? option.get_name(true) : option.get_name(false, true);
  return option.get_positional() || option.get_type_size() == 0 || option.get_type_name().empty()
             ? name
             : name + " " + option.get_type_name();
}
/// `SCENE`, `[ID...]`, `KIND`
std::string in_usage(CLI::Option const& option) {
  std::string name = written(option);
  if (option.get_expected_max() > 1) name += "...";
  return option.get_required() ? name : "[" + name + "]";
}

std::vector<CLI::Option const*> options_of(CLI::App const& app, bool positional) {
  auto options = app.get_options(
      [positional](CLI::Option const* option) { return option->get_positional() == positional; });
  std::stable_partition(options.begin(), options.end(),
                        [&](CLI::Option const* option) { return option != app.get_help_ptr(); });
  return options;
}

std::string usage_of(CLI::App const& app) {
  std::string line = app.get_parent() ? app.get_parent()->get_name() + " " + app.get_name()
                                      : app.get_name() + " COMMAND ...";
  for (auto const* const option : options_of(app, true)) line += " " + in_usage(*option);
  for (auto const* const option : options_of(app, false))
    if (option->get_required()) line += " " + written(*option);
  return line + (app.get_parent() && options_of(app, false).size() > 1 ? " [OPTIONS]" : "");
}

std::string paragraph(std::vector<std::vector<std::string>> rows) {
  std::size_t first = 0;
  for (auto const& row : rows) first = std::max(first, row[0].size());
  for (auto& row : rows) row[1] = wrapped(row[1], width, first + 4);
  return rows.empty() ? "" : "\n" + aligned(rows, "  ");
}

}  // namespace

std::string Help::make_help(CLI::App const* app, std::string, CLI::AppFormatMode) const {
  std::string meaning = app->get_description();
  meaning[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(meaning[0])));
  std::string out = "usage: " + usage_of(*app) + "\n\n" + meaning + ".\n";
  std::vector<std::vector<std::string>> rows;
  for (auto const* const part : app->get_subcommands([](CLI::App const*) { return true; }))
    rows.push_back({part->get_name(), part->get_description()});
  out += paragraph(rows), rows.clear();
  for (bool const positional : {true, false})
    for (auto const* const option : options_of(*app, positional))
      rows.push_back({written(*option), option->get_description()});
  out += paragraph(rows);
  if (!app->get_footer().empty()) out += "\n" + app->get_footer() + "\n";
  return out;
}

namespace {

/// The option that a message of CLI11 is about: it begins with the name, or with that of a flag without its
/// dashes.
CLI::Option const* option_in(CLI::App const& app, std::string const& message) {
  CLI::Option const* found = nullptr;
  for (auto const* const option : app.get_options()) {
    std::string const name = option->get_name();
    bool const about = message.starts_with(name) || ("--" + message).starts_with(name + " was given");
    if (about && (!found || name.size() > found->get_name().size())) found = option;
  }
  return found;
}

std::string example_of(std::string const& positional) {
  if (positional == "SCENE") return "which scene? For example: actio run apophis.toml";
  if (positional == "DIR") return "which folder? One that a run left, for example: actio resume apophis";
  if (positional == "WHAT")
    return "which list? There are systems, groups, methods, quantities, bodies, materials, keys, scenes";
  if (positional == "KIND")
    return "which scene? For example: actio new rigid_body; actio list systems names the kinds";
  if (positional == "NAME") return "which name? For example: actio show energy; actio list has the names";
  return "'" + positional + "' is missing";
}

/// An option that this part does not know.
std::string unknown_option(CLI::App const& command, CLI::App const& part, std::string const& word) {
  std::string const name = word.substr(0, word.find('='));
  std::vector<std::string> known, elsewhere;
  for (auto const* const option : options_of(part, false)) known.push_back(option->get_name(false, true));
  for (auto const* const other : command.get_subcommands([](CLI::App const*) { return true; }))
    for (auto const* const option : options_of(*other, false))
      if (option->get_name() == name) elsewhere.push_back(other->get_name());
  if (&part == &command && !elsewhere.empty())
    return fmt::format("'{}' belongs after the command: actio {} ... {}", name, elsewhere.front(), name);
  std::string const near = did_you_mean(name, known);
  return fmt::format("unknown option '{}'{}", name,
                     near.empty() && !elsewhere.empty() ? "; actio " + elsewhere.front() + " has it" : near);
}

/// A word that is one too many.
std::string unknown_word(CLI::App const& command, CLI::App const& part, std::string const& word) {
  if (&part != &command) return fmt::format("'{}' is one too many; usage: {}", word, usage_of(part));
  std::vector<std::string> known{"--help", "--version"};
  for (auto const* const other : command.get_subcommands([](CLI::App const*) { return true; }))
    known.push_back(other->get_name());
  bool const scene = word.ends_with(".toml");
  return fmt::format("unknown command '{}'{}", word,
                     scene ? "; did you mean 'actio run " + word + "'?" : did_you_mean(word, known));
}

}  // namespace

std::string usage_error(CLI::App const& command, CLI::ParseError const& error) {
  auto const chosen = command.get_subcommands();
  auto const before = command.remaining();
  CLI::App const& part = chosen.empty() || !before.empty() ? command : *chosen.front();
  std::string const name = &part == &command ? "actio" : "actio " + part.get_name();
  auto const left = part.remaining();
  auto const option = std::find_if(left.begin(), left.end(),
                                   [](std::string const& word) { return word.size() > 1 && word[0] == '-'; });
  // Behind '--' all words stand for themselves.
  auto const mark = std::find(left.begin(), left.end(), "--");
  std::string what = error.what();
  CLI::Option const* const known = option_in(part, what);
  if (mark != left.end() && mark + 1 != left.end())
    what = fmt::format("'{}' is one too many behind '--', where there are no options", mark[1]);
  else if (option != left.end())
    what = unknown_option(command, part, *option);
  else if (dynamic_cast<CLI::RequiredError const*>(&error) && known)
    what = known->get_positional() ? example_of(known->get_name()) : written(*known) + " is needed";
  else if (!left.empty())
    what = unknown_word(command, part, left.front());
  else if (dynamic_cast<CLI::ArgumentMismatch const*>(&error) && known)
    what = known->get_expected_min() == 0 ? known->get_name() + " takes no value"
           : known->count() > 0 && !known->results().empty()
               ? known->get_name() + " is there twice"
               : written(*known) + ": " + known->get_type_name() + " is missing";
  return fmt::format("{}: {} ({} --help)", name, scene::printable(what), name);
}

}  // namespace actio::app
