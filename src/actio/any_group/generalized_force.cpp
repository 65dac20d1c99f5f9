#include "actio/any_group/generalized_force.hpp"

#include <algorithm>
#include <cmath>

#include "actio/numbers/errors.hpp"

namespace actio::systems {

HeldInput::HeldInput(std::vector<std::pair<double, double>> rows) : rows_(std::move(rows)) {
  if (rows_.empty()) throw OutsideDomain("HeldInput", "an input needs a row; rows", 0, 1);
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    auto const [t, value] = rows_[k];
    if (!std::isfinite(t) || !std::isfinite(value)) throw NotFinite("HeldInput: time and value of a row");
    if (k > 0 && !(t > rows_[k - 1].first))
      throw OutsideDomain("HeldInput", "times must ascend; a time behind the one before", t,
                          rows_[k - 1].first);
  }
}

double HeldInput::operator()(double t) const {
  if (rows_.empty()) {
    thread_local std::vector<double> work;
    double value = 0;
    of_time_(&t, &value, work);
    return value;
  }
  auto const next = std::ranges::upper_bound(rows_, t, {}, &std::pair<double, double>::first);
  return (next == rows_.begin() ? next : next - 1)->second;
}

bool GeneralizedForce::is_same_at_both_ends(int dimension) const {
  int const inputs = components.inputs - static_cast<int>(held.size());
  for (int i = dimension; i < inputs - 1 - dimension; ++i)
    if (components.depends_on(i)) return false;
  return !components.depends_on(inputs - 1);
}

}  // namespace actio::systems
