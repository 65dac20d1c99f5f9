// The Cayley transform of A in single precision, by products alone.
//
// With X = -A^2, which is Hermitian with eigenvalues in [0, |A|^2], and S = 1/(1 + X) as a polynomial in X,
//
//   (1 - A)^{-1} = 1 + K,   K = (S - 1) + A S,   cay(A) = (1 - A)^{-1}(1 + A) = 1 + 2K.
//
// Of both terms of K, Hermitian and skew-Hermitian, half is computed. Conjugations follow from
// F = K X + X K^* and E = K X K^*:
//
//   (1 + K) X (1 + K)^* = X + F + E,   cay(A) X cay(A)^* = X + 2F + 4E.
//
// Single precision is enough where what is conjugated is small beside what the result is added to.
#pragma once

#include <Eigen/QR>

#include "actio/vorticity/products.hpp"

namespace actio {

/// Calls `use(i, j)` for all i >= j below n, tile by tile, so that entries (i, j) and (j, i) are both near.
template <class Use>
void over_entry_pairs(Eigen::Index n, Use const& use) {
  constexpr Eigen::Index tile = 32;
  for (Eigen::Index c = 0; c < n; c += tile)
    for (Eigen::Index r = c; r < n; r += tile)
      for (Eigen::Index j = c; j < std::min(c + tile, n); ++j)
        for (Eigen::Index i = std::max(r, j); i < std::min(r + tile, n); ++i) use(i, j);
}

/// \f$K = (1-A)^{-1} - 1\f$ and conjugations by it.
class SingleCayley {
 public:
  using Part = Eigen::MatrixXf;  ///< real matrices

  /// With memory that is taken when the size is known.
  explicit SingleCayley(Products products = eigen_products()) : products_(std::move(products)) {}

  /// K of a skew-Hermitian matrix.
  /// @param radius  a bound of its eigenvalues
  /// @param error   of S, if it is not below the rounding of single precision: lower degrees are cheaper
  void factor(SkewHermitian<> const& a, double radius, double error = 2e-9) {
    auto const n = a.size();
    allocate(n);
    ar_ = a.real.cast<float>(), ai_ = a.imaginary.cast<float>(), as_ = ar_ + ai_;
    // X = -A^2, and X^2.
    lower(ar_, ai_, as_, ar_, ai_, as_);
    hermitian(x_, [&](auto i, auto j) { return -product(i, j); });
    lower(x_.real, x_.imaginary, x_.sum, x_.real, x_.imaginary, x_.sum);
    hermitian(y_, [&](auto i, auto j) { return product(i, j); });
    // S - 1 by Horner's rule in X^2.
    Eigen::VectorXd const c = reciprocal(radius * radius, error);
    Eigen::Index k = c.size() - 3;
    hermitian(h_, [&](auto i, auto j) {
      return combination(c, k, i, j) + static_cast<float>(c[k + 2]) * entry(y_, i, j);
    });
    while (k > 0) {
      k -= 2;
      lower(y_.real, y_.imaginary, y_.sum, h_.real, h_.imaginary, h_.sum);
      hermitian(h_, [&](auto i, auto j) { return combination(c, k, i, j) + product(i, j); });
    }
    // A S = A + A (S - 1).
    lower(ar_, ai_, as_, h_.real, h_.imaginary, h_.sum);
    over_entry_pairs(n, [&](auto i, auto j) {
      Entry const h = entry(h_, i, j);
      Entry t = product(i, j);
      t.real += ar_(i, j), t.imaginary += ai_(i, j);
      put(k_, i, j, {h.real + t.real, h.imaginary + t.imaginary});
      put(star_, i, j, {h.real - t.real, h.imaginary - t.imaginary});
      if (i == j) return;
      put(k_, j, i, {h.real - t.real, t.imaginary - h.imaginary});
      put(star_, j, i, {h.real + t.real, -h.imaginary - t.imaginary});
    });
  }

  /// An entry of a complex matrix.
  struct Entry {
    float real;       ///< its real part
    float imaginary;  ///< its imaginary part
    /// The sum.
    friend Entry operator+(Entry a, Entry b) { return {a.real + b.real, a.imaginary + b.imaginary}; }
    /// The opposite.
    friend Entry operator-(Entry a) { return {-a.real, -a.imaginary}; }
    /// A real multiple.
    friend Entry operator*(float f, Entry a) { return {f * a.real, f * a.imaginary}; }
  };
  /// Calls `use(i, j, f, e)` with the entries of F and E for all i >= j; both are skew-Hermitian.
  template <class Use>
  void conjugate(SkewHermitian<float> const& x, Use const& use) {
    // G = K X, whole.
    t3_ = x.real + x.imaginary;
    products_->multiply(k_.real, x.real, t1_), products_->multiply(k_.imaginary, x.imaginary, t2_);
    products_->multiply(k_.sum, t3_, g_.sum);
    g_.real = t1_ - t2_, g_.imaginary = g_.sum - t1_ - t2_;
    g_.sum = g_.real + g_.imaginary;
    lower(g_.real, g_.imaginary, g_.sum, star_.real, star_.imaginary, star_.sum);
    over_entry_pairs(x.size(), [&](auto i, auto j) {
      Entry e = product(i, j);
      if (i == j) e.real = 0;
      use(i, j, Entry{g_.real(i, j) - g_.real(j, i), g_.imaginary(i, j) + g_.imaginary(j, i)}, e);
    });
  }

  /// \f$[Y, X]\f$ of skew-Hermitian matrices, entry by entry as above, in single precision.
  template <class Use>
  void commutator(SkewHermitian<float> const& y, SkewHermitian<float> const& x, Use const& use) {
    allocate(x.size());
    products_->multiply(y.real, x.real, t1_), products_->multiply(y.imaginary, x.imaginary, t2_);
    g_.real = y.real + y.imaginary, g_.imaginary = x.real + x.imaginary;
    products_->multiply(g_.real, g_.imaginary, t3_);
    over_entry_pairs(x.size(), [&](auto i, auto j) {
      float const one = t3_(i, j) - t1_(i, j) - t2_(i, j), other = t3_(j, i) - t1_(j, i) - t2_(j, i);
      use(i, j, Entry{(t1_(i, j) - t2_(i, j)) - (t1_(j, i) - t2_(j, i)), one + other});
    });
  }

  /// The degree of the polynomial in X for a given radius of A, even.
  static int degree(double radius, double error = 2e-9) {
    double const b = radius * radius;
    // The pole of 1/(1 + x) seen from [0, b]: coefficients of Chebyshev's polynomials fall by this factor.
    double const fall = (2 + b) / b + std::sqrt((2 + b) / b * ((2 + b) / b) - 1);
    int degree = 2;
    while (degree < 24 && 2 * std::pow(fall, -degree - 1) > error) degree += 2;
    return degree;
  }

 private:
  /// A complex matrix for products by three real ones.
  struct Split {
    Part real, imaginary, sum;
  };
  void allocate(Eigen::Index n) {
    if (t1_.rows() == n) return;
    for (Split* s : {&x_, &y_, &h_, &k_, &star_, &g_})
      s->real.resize(n, n), s->imaginary.resize(n, n), s->sum.resize(n, n);
    for (Part* part : {&t1_, &t2_, &t3_}) part->resize(n, n);
  }
  static void put(Split& m, Eigen::Index i, Eigen::Index j, Entry e) {
    m.real(i, j) = e.real, m.imaginary(i, j) = e.imaginary, m.sum(i, j) = e.real + e.imaginary;
  }
  static Entry entry(Split const& m, Eigen::Index i, Eigen::Index j) {
    return {m.real(i, j), m.imaginary(i, j)};
  }

  /// The lower half of a product, as three real ones.
  void lower(Part const& ar, Part const& ai, Part const& as, Part const& br, Part const& bi, Part const& bs) {
    products_->multiply_lower(ar, br, t1_), products_->multiply_lower(ai, bi, t2_),
        products_->multiply_lower(as, bs, t3_);
  }
  Entry product(Eigen::Index i, Eigen::Index j) const {
    return {t1_(i, j) - t2_(i, j), t3_(i, j) - t1_(i, j) - t2_(i, j)};
  }
  /// c_k + c_{k+1} X.
  Entry combination(Eigen::VectorXd const& c, Eigen::Index k, Eigen::Index i, Eigen::Index j) const {
    Entry e = static_cast<float>(c[k + 1]) * entry(x_, i, j);
    if (i == j) e.real += static_cast<float>(c[k]);
    return e;
  }
  /// Writes a Hermitian matrix of which `of` gives the lower half.
  template <class Of>
  void hermitian(Split& m, Of const& of) {
    over_entry_pairs(t1_.rows(), [&](auto i, auto j) {
      Entry e = of(i, j);
      if (i == j) e.imaginary = 0;
      put(m, i, j, e);
      put(m, j, i, {e.real, -e.imaginary});
    });
  }
  /// The coefficients of 1/(1 + x) - 1 on [0, b], by interpolation where Chebyshev's polynomial vanishes.
  static Eigen::VectorXd reciprocal(double b, double error) {
    auto const count = degree(std::sqrt(b), error) + 1;
    Eigen::MatrixXd powers(count, count);
    Eigen::VectorXd values(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      double const t =
          0.5 * (1 + std::cos(M_PI * (static_cast<double>(i) + 0.5) / static_cast<double>(count)));
      values[i] = -b * t / (1 + b * t);
      for (Eigen::Index k = 0; k < count; ++k) powers(i, k) = std::pow(t, static_cast<double>(k));
    }
    Eigen::VectorXd c = powers.colPivHouseholderQr().solve(values);
    for (Eigen::Index k = 0; k < count; ++k) c[k] /= std::pow(b, static_cast<double>(k));
    return c;
  }

  Products products_;
  Part ar_, ai_, as_;
  Split x_, y_, h_;  ///< X, X^2, S - 1
  Split k_, star_;   ///< K and its adjoint
  Split g_;
  Part t1_, t2_, t3_;
};

}  // namespace actio
