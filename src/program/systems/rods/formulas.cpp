#include "program/systems/rods/formulas.hpp"

#include <fmt/format.h>

#include <cmath>

#include "actio/formula/tape_derivatives.hpp"

namespace actio::scene {

RodFormulas::RodFormulas(SceneTable const& table, std::string const& key, std::vector<std::string> names,
                         SharedNames& shared, std::size_t count, bool slopes)
    : table_(table), key_(key), names_(std::move(names)), count_(count), slopes_(slopes) {
  bool const list = count > 1;
  auto const texts = list ? table.formulas(key) : std::vector<std::string>{table.formula(key)};
  if (texts.size() != count)
    table.fail(key, fmt::format("{}: three formulas in {} are expected, found {}", key,
                                fmt::join(names_, ", "), texts.size()));
  std::vector<Tape> parts;
  for (std::size_t k = 0; k < count; ++k) {
    auto const place = list ? table.text_place(key, k) : table.text_place(key);
    auto formula = shared.read(texts[k], names_, place, key, slopes ? FormulaUse{} : for_values);
    used_.insert(formula.used.begin(), formula.used.end());
    try {
      parts.push_back(slopes ? with_gradient(formula.value, {0}) : std::move(formula.value));
    } catch (SceneError const&) {
      throw;
    } catch (Error const& error) {
      place.fail(texts[k], 0, key + ": " + error.what());
    }
  }
  tape_ = joined(parts);
  out_.resize(count * (slopes ? 2 : 1));
}

RodFormulas::Vector RodFormulas::evaluate(std::span<double const> at, std::size_t which) const {
  tape_(at.data(), out_.data(), work_);
  Vector out{};
  for (std::size_t k = 0; k < count_; ++k) {
    double const value = out_[slopes_ ? 2 * k + which : k];
    if (!std::isfinite(value)) {
      std::string where;
      for (std::size_t i = 0; i < names_.size(); ++i)
        where += fmt::format("{}{} = {}", i ? ", " : " at ", names_[i], at[i]);
      table_.fail(key_,
                  fmt::format("{}: a finite {} is expected, found {}{}", key_, which ? "derivative" : "value",
                              std::isnan(value) ? std::abs(value) : value, where));
    }
    out[k] = value;
  }
  return out;
}

}  // namespace actio::scene
