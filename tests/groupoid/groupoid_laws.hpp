// The laws of a groupoid, for a reader's own too: three arrows in a row are enough.
#pragma once

#include <string>

#include "actio/groupoid/groupoid.hpp"

namespace actio::testing {

/// By how much the laws of a groupoid are broken at three arrows in a row, and which is broken the most.
/// Rounding, where they hold.
struct BrokenLaw {
  std::string law = "none";
  double by = 0;
};
template <MovableGroupoid Gamma, class A>
BrokenLaw groupoid_laws(Gamma const& gamma, A const& g, A const& h, A const& k) {
  BrokenLaw worst;
  auto const same = [&](std::string law, A const& a, A const& b) {
    Vector<double> const left = gamma.entries(a), right = gamma.entries(b);
    double const by = (left - right).norm() / (1 + right.norm());
    if (!(by <= worst.by)) worst = {std::move(law), by};
  };
  same("(gh)k = g(hk)", gamma.compose(gamma.compose(g, h), k), gamma.compose(g, gamma.compose(h, k)));
  same("source(gh) = source(g)", gamma.unit(gamma.source(gamma.compose(g, h))), gamma.unit(gamma.source(g)));
  same("target(gh) = target(h)", gamma.unit(gamma.target(gamma.compose(g, h))), gamma.unit(gamma.target(h)));
  same("unit g = g", gamma.compose(gamma.unit(gamma.source(g)), g), g);
  same("g unit = g", gamma.compose(g, gamma.unit(gamma.target(g))), g);
  same("g inverse(g) = unit", gamma.compose(g, gamma.inverse(g)), gamma.unit(gamma.source(g)));
  same("inverse(g) g = unit", gamma.compose(gamma.inverse(g), g), gamma.unit(gamma.target(g)));
  same("near_unit(x, 0) = unit",
       gamma.near_unit(gamma.source(g), Fibre<Gamma, double>(Fibre<Gamma, double>::Zero(gamma.dimension()))),
       gamma.unit(gamma.source(g)));
  return worst;
}

}  // namespace actio::testing
