#include <Eigen/Core>

#include "actio/quantized_sphere/zonal_background.hpp"

namespace actio::sphere {

ZonalTerms::ZonalTerms(QuantizedSphere const& sphere, ZonalBackground const& background, double eps)
    : scale_(background.vorticity * sphere.hbar()),
      turn_(eps * background.stream * sphere.hbar()),
      own_(sphere.n),
      share_(sphere.n),
      middle_(sphere.n) {
  for (int k = 0; k < sphere.n; ++k) {
    own_[k] = turn_ * sphere.weight(k), share_[k] = 1 / (1 + own_[k] * own_[k]);
    middle_[k] = scale_ * sphere.weight(k) * share_[k];
  }
}

void ZonalTerms::add_to_product(SkewHermitian<> const& a, SkewHermitian<> const& v,
                                SkewProducts<double>& products, SkewHermitian<>& c) const {
  products.with_product([&](auto& real, auto& imaginary) {
    for (Eigen::Index j = 0; j < a.size(); ++j) {
      real.col(j) -= own_.cwiseProduct(v.imaginary.col(j)) + middle_[j] * a.imaginary.col(j);
      imaginary.col(j) += own_.cwiseProduct(v.real.col(j)) + middle_[j] * a.real.col(j);
    }
  });
  for (Eigen::Index j = 0; j < a.size(); ++j)
    for (Eigen::Index i = j; i < a.size(); ++i) {
      double const apart = static_cast<double>(i - j);
      double const f = apart * scale_ * (1 - own_[i] * own_[j]) * share_[i] * share_[j], g = -apart * turn_;
      c.real(i, j) -= f * a.imaginary(i, j) + g * v.imaginary(i, j);
      c.imaginary(i, j) += f * a.real(i, j) + g * v.real(i, j);
    }
  mirror_lower(c);
}

void ZonalTerms::add_outside(SkewHermitian<> const& a, SkewProducts<double>& products,
                             SkewHermitian<>& e) const {
  Eigen::VectorXd const both = own_.cwiseProduct(middle_);
  products.with_product([&](auto& real, auto& imaginary) {
    for (Eigen::Index j = 0; j < a.size(); ++j) {
      auto const below = [rows = a.size() - j](auto&& column) { return column.tail(rows); };
      below(e.real.col(j)) -=
          own_[j] * below(imaginary.col(j)) + below(both).cwiseProduct(below(a.real.col(j)));
      below(e.imaginary.col(j)) +=
          own_[j] * below(real.col(j)) - below(both).cwiseProduct(below(a.imaginary.col(j)));
      e.real(j, j) = 0;
    }
  });
  mirror_lower(e);
}

}  // namespace actio::sphere
