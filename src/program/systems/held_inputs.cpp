#include "program/systems/held_inputs.hpp"

#include <fmt/format.h>

#include <charconv>

namespace actio::scene {
namespace {

using Rows = std::vector<std::pair<double, double>>;

/// A number at the start of a text, which is moved behind it.
bool take_number(std::string_view& text, double& value) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r"), text.size()));
  return true;
}

/// `time, value` in each line; empty lines and those that begin with # say nothing, and the first may have
/// names.
Rows rows_of_file(SceneTable const& inputs, std::string const& name, std::string const& path,
                  std::string_view text) {
  Rows out;
  for (long line = 1; !text.empty(); ++line) {
    std::size_t const end = std::min(text.find('\n'), text.size());
    std::string_view row = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    std::string_view const whole = row;
    if (row.find_first_not_of(" \t\r") == row.npos || row.front() == '#') continue;
    double t = 0, value = 0;
    bool const first = take_number(row, t), comma = first && row.starts_with(',');
    if (comma) row.remove_prefix(1);
    if (comma && take_number(row, value) && row.empty()) {
      out.emplace_back(t, value);
    } else if (line > 1 || first) {
      inputs.fail(name, fmt::format("{}: line {} of {}: 'time, value' is expected, found '{}'", name, line,
                                    path, printable(std::string(whole))));
    }
  }
  return out;
}

systems::HeldInput read_input(SceneTable inputs, std::string const& name, SharedNames& shared) {
  Rows rows;
  if (inputs.is_matrix(name)) {
    Eigen::MatrixXd const all = inputs.rows(name, 2);
    for (Eigen::Index k = 0; k < all.rows(); ++k) rows.emplace_back(all(k, 0), all(k, 1));
  } else if (inputs.is_text(name) && inputs.text(name).ends_with(".csv")) {
    auto const [path, text] = inputs.read_file(name, "rows of a time and a value");
    rows = rows_of_file(inputs, name, path, text);
  } else {
    return systems::HeldInput(
        shared.read(inputs.formula(name), {"t"}, inputs.text_place(name), name, for_values).value);
  }
  try {
    return systems::HeldInput(std::move(rows));
  } catch (Error const& error) {
    inputs.fail(name, fmt::format("{}: {}", name, error.what()));
  }
}

}  // namespace

HeldInputs read_held_inputs(SceneTable const& inputs, std::vector<std::string> const& taken,
                            SharedNames& shared) {
  HeldInputs out{inputs.keys()};
  for (auto const& name : out.names) {
    require_formula_name(inputs, name, taken, "a number of the force");
    shared.require_free(inputs, name);
    out.values.push_back(read_input(inputs, name, shared));
  }
  return out;
}

void HeldInputs::require_used(SceneTable const& inputs, SharedNames::Names const& used,
                              std::string const& formulas) const {
  for (auto const& name : names)
    if (!used.contains(name))
      inputs.fail(name, fmt::format("inputs: '{}' does not occur in the {}{}", name, formulas,
                                    meant_used_name(name, used)));
}

}  // namespace actio::scene
