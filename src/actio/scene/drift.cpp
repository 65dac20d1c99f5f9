#include "actio/scene/drift.hpp"

#include <algorithm>
#include <cmath>

namespace actio::scene {
namespace {

double size_of(std::span<double const> v) {
  double largest = 0, sum = 0;
  for (double const x : v) largest = std::max(largest, std::abs(x));
  if (v.size() == 1 || !(largest > 0) || !std::isfinite(largest)) return largest;
  for (double const x : v) sum += (x / largest) * (x / largest);
  return largest * std::sqrt(sum);
}

}  // namespace

double Drift::Seen::relative() const {
  double const unit = at_start > 0 ? at_start : modulus;
  return unit > 0 ? difference / unit : 0;
}

void Drift::see(std::span<double const> row) {
  bool const start = first_.empty();
  if (start) first_.assign(row.begin(), row.end());
  std::vector<double> difference;
  for (std::size_t k = 0; k < quantities_.size(); ++k) {
    auto const now = row.subspan(quantities_[k].first, quantities_[k].size);
    double const modulus = size_of(now);
    if (start) seen_[k].at_start = modulus;
    seen_[k].modulus = std::max(seen_[k].modulus, modulus);
    difference.assign(now.begin(), now.end());
    for (std::size_t i = 0; i < now.size(); ++i) difference[i] -= first_[quantities_[k].first + i];
    seen_[k].difference = std::max(seen_[k].difference, size_of(difference));
  }
}

std::vector<Drift::Entry> Drift::entries() const {
  std::vector<Entry> out;
  for (std::size_t k = 0; k < quantities_.size(); ++k) out.push_back({quantities_[k].name, seen_[k].relative()});
  return out;
}
double Drift::worst() const {
  double worst = 0;
  for (auto const& s : seen_) worst = std::max(worst, s.relative());
  return worst;
}
void Drift::remember(Memory& memory) { memory(seen_, first_); }

}  // namespace actio::scene
