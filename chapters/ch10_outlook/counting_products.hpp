// Products of matrices that are counted, as complex ones: one of these is four real products, and half of a
// product costs half of it.
#pragma once

#include <Eigen/Core>

#include "actio/skew_matrices/products.hpp"

struct CountingProducts : actio::sphere::ProductsBy<CountingProducts> {
  mutable double complex_products = 0;
  template <class Part>
  void whole(Part const& a, Part const& b, Part& out) const {
    out.noalias() = a * b, complex_products += 0.25;
  }
  template <class Part>
  void lower(Part const& a, Part const& b, Part& out) const {
    out.template triangularView<Eigen::Lower>() = a * b, complex_products += 0.125;
  }
};
