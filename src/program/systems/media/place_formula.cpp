#include "program/systems/media/place_formula.hpp"

#include <fmt/format.h>

#include <cmath>

#include "actio/formula/tape_derivatives.hpp"
#include "actio/numbers/nearest_name.hpp"
#include "program/systems/formula.hpp"

namespace actio::scene {

std::vector<std::string> const& axes() {
  static std::vector<std::string> const names{"X", "Y", "Z"};
  return names;
}

PlaceFormula::PlaceFormula(SceneTable table, std::string const& key,
                           std::vector<std::string> const& otherwise)
    : variables_(axes().begin(), axes().begin() + static_cast<long>(otherwise.size())) {
  if (!table.has(key)) table.set(key, otherwise);
  auto const texts = table.formulas(key);
  if (texts.size() != otherwise.size())
    table.fail(key, fmt::format("{}: {} formulas in {} are expected, one for each dimension, found {}", key,
                                otherwise.size(), listed(variables_), texts.size()));
  for (std::size_t k = 0; k < texts.size(); ++k) written_.push_back({texts[k], table.text_place(key, k)});
  read();
}
PlaceFormula::PlaceFormula(std::string const& text, int dimension, TextPlace const& place)
    : variables_(axes().begin(), axes().begin() + dimension), written_{{text, place}} {
  read();
}

void PlaceFormula::read() {
  std::vector<Tape> tapes;
  for (auto const& [text, place] : written_) {
    auto formula = scene_formula(text, variables_, {}, place, "", for_values);
    for (auto const& variable : variables_) constant_ = constant_ && !formula.used.contains(variable);
    tapes.push_back(std::move(formula.value));
  }
  values_ = joined(tapes);
}

void PlaceFormula::evaluate(std::span<double const> X, double* out) const {
  thread_local std::vector<double> work;
  values_(X.data(), out, work);
  for (std::size_t k = 0; k < written_.size(); ++k)
    if (!std::isfinite(out[k])) fail(written_[k], X, out[k]);
}

void PlaceFormula::fail(Written const& formula, std::span<double const> X, double value) const {
  std::string where;
  for (std::size_t i = 0; i < variables_.size(); ++i)
    where += fmt::format("{}{} = {}", i ? ", " : " at ", variables_[i], X[i]);
  formula.place.fail(formula.text, 0,
                     fmt::format("a finite value is expected, found {}{}",
                                 std::isnan(value) ? std::abs(value) : value, where));
}

}  // namespace actio::scene
