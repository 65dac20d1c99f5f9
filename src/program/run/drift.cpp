#include "program/run/drift.hpp"

#include <algorithm>
#include <cmath>

namespace actio::scene {
namespace {

/// The length of a vector, given component by component.
template <class Component>
double length(std::size_t n, Component const& component) {
  if (n == 1) return std::abs(component(0));
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += component(i) * component(i);
  // Squares below 1e-308 are lost, and no more than 1e-18 of such a sum; there is no overflow.
  if (sum > 1e-290 && sum < 1e290) return std::sqrt(sum);
  double largest = 0;
  for (std::size_t i = 0; i < n; ++i) largest = std::max(largest, std::abs(component(i)));
  if (!(largest > 0) || !std::isfinite(largest)) return largest;
  sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += (component(i) / largest) * (component(i) / largest);
  return largest * std::sqrt(sum);
}

}  // namespace

double length_of(std::span<double const> quantity) {
  return length(quantity.size(), [&](std::size_t i) { return quantity[i]; });
}

Drift::Drift(std::vector<QuantityGraph::Conserved> quantities)
    : quantities_(std::move(quantities)), seen_(quantities_.size()) {
  std::size_t size = 0;
  for (auto const& q : quantities_) size += q.size;
  start_.resize(size);
}

void Drift::start(std::span<double const> row) {
  double* at = start_.data();
  for (std::size_t k = 0; k < quantities_.size(); ++k) {
    double const* const now = row.data() + quantities_[k].first;
    seen_[k].at_start = length(quantities_[k].size, [now](std::size_t i) { return now[i]; });
    at = std::copy_n(now, quantities_[k].size, at);
  }
  started_ = true;
}

void Drift::see(std::span<double const> row, std::span<QuantityGraph::Unit const> units) {
  for (std::size_t k = 0; k < units.size(); ++k)
    for (double QuantityGraph::Unit::*const part :
         {&QuantityGraph::Unit::terms, &QuantityGraph::Unit::rounding, &QuantityGraph::Unit::at_rest})
      // Products of large terms may overflow where the quantity does not: they are no unit.
      if (std::isfinite(units[k].*part))
        seen_[k].natural.*part = std::max(seen_[k].natural.*part, units[k].*part);
  if (!started_) return start(row);
  double const* then = start_.data();
  for (std::size_t k = 0; k < quantities_.size(); ++k) {
    std::size_t const size = quantities_[k].size;
    double const* const now = row.data() + quantities_[k].first;
    Seen& seen = seen_[k];
    seen.difference =
        std::max(seen.difference, length(size, [now, then](std::size_t i) { return now[i] - then[i]; }));
    if (!(seen.at_start > 0))
      seen.modulus = std::max(seen.modulus, length(size, [now](std::size_t i) { return now[i]; }));
    then += size;
  }
}

std::vector<Drift::Entry> Drift::entries() const {
  std::vector<Entry> out;
  for (std::size_t k = 0; k < quantities_.size(); ++k)
    out.push_back({quantities_[k].name, seen_[k].relative(), seen_[k].unit()});
  return out;
}
double Drift::worst() const {
  double worst = 0;
  for (auto const& s : seen_) worst = std::max(worst, s.relative());
  return worst;
}

}  // namespace actio::scene
