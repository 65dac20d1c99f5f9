#include "actio/fast_body/space/splitting.hpp"

namespace actio::bodies {

Splitting composed_splitting(std::string name, int order, std::vector<double> const& fractions) {
  Splitting step{std::move(name), order, {0}, fractions};
  double sum = 0, size = 0;
  for (double const f : fractions) {
    if (!is_finite(f)) throw NotFinite("composed splitting: fraction of a step");
    step.kicks.back() += f / 2;
    step.kicks.push_back(f / 2);
    sum += f, size += std::abs(f);
  }
  if (!(std::abs(sum - 1) <= 8 * epsilon<double>() * (1 + size)))
    throw OutsideDomain("composed splitting", "the fractions of a step must add up to 1", sum, 1);
  return step;
}

Splitting blanes_moan_splitting() {
  double const b1 = 0.0829844064174052, b2 = 0.396309801498368, b3 = -0.0390563049223486,
               b4 = 1 - 2 * (b1 + b2 + b3);
  double const a1 = 0.245298957184271, a2 = 0.604872665711080, a3 = 0.5 - (a1 + a2);
  return {"Blanes-Moan", 4, {b1, b2, b3, b4, b3, b2, b1}, {a1, a2, a3, a3, a2, a1}};
}

}  // namespace actio::bodies
