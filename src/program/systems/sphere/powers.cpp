#include <Eigen/Core>

#include "program/systems/sphere/powers.hpp"

#include <algorithm>

#include "actio/quantized_sphere/sphere_invariants.hpp"
#include "actio/skew_matrices/bracket_blocks.hpp"

namespace actio::scene {
namespace {

/// Products of Hermitian matrices that commute, so that the product is Hermitian, too, and half of it is
/// computed. X = -iW is stored as W = R + iJ: X Y has the parts J J' - R R' and J R' + R J'.
class CommutingProducts {
 public:
  CommutingProducts(sphere::Products products, Eigen::Index n)
      : products_(std::move(products)), first_(n, n), second_(n, n), both_(n, n) {}

  sphere::SkewHermitian<> operator()(sphere::SkewHermitian<> const& x, sphere::SkewHermitian<> const& y) {
    left_ = x.real + x.imaginary, right_ = y.real + y.imaginary;
    products_->multiply_lower(x.imaginary, y.imaginary, first_);
    products_->multiply_lower(x.real, y.real, second_);
    products_->multiply_lower(left_, right_, both_);
    sphere::SkewHermitian<> out(x.size());
    out.imaginary.triangularView<Eigen::Lower>() = first_ - second_;
    out.real.triangularView<Eigen::StrictlyLower>() = both_ - first_ - second_;
    sphere::mirror_lower(out);
    return out;
  }

 private:
  sphere::Products products_;
  Eigen::MatrixXd first_, second_, both_, left_, right_;
};

}  // namespace

Eigen::VectorXd vorticity_casimirs(sphere::Products const& products, sphere::SkewHermitian<> const& w,
                                   double area) {
  CommutingProducts product(products, w.size());
  sphere::SkewHermitian<> const square = product(w, w), cube = product(square, w),
                                fourth = product(square, square);
  // Tr(X Y) = <X, Y>.
  Eigen::VectorXd casimirs(7);
  casimirs << sphere::inner_product(w, w), sphere::inner_product(w, square),
      sphere::inner_product(square, square), sphere::inner_product(square, cube),
      sphere::inner_product(cube, cube), sphere::inner_product(cube, fourth),
      sphere::inner_product(fourth, fourth);
  return area * casimirs;
}

Eigen::VectorXd vorticity_eigenvalues(sphere::SkewHermitian<> const& w) {
  Eigen::Index const n = w.size();
  int const fold = sphere::symmetry_of(w);
  if (fold == 1) return sphere::vorticity_values(w);
  Eigen::VectorXd all(n);
  if (fold == 0) {
    all = w.imaginary.diagonal();
  } else {
    using Stride = Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>;
    Eigen::Index found = 0;
    for (Eigen::Index first = 0; first < std::min<Eigen::Index>(fold, n); ++first) {
      Eigen::Index const count = (n - first + fold - 1) / fold, at = first * (n + 1);
      auto const block = [&](Eigen::MatrixXd const& part) {
        return Eigen::Map<Eigen::MatrixXd const, 0, Stride>(part.data() + at, count, count,
                                                            Stride(fold * n, fold));
      };
      all.segment(found, count) =
          sphere::vorticity_values(sphere::SkewHermitian<>(block(w.real), block(w.imaginary)));
      found += count;
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace actio::scene
