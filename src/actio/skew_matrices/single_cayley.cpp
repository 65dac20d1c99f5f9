#include <Eigen/Core>

#include "actio/skew_matrices/single_cayley.hpp"

namespace actio::sphere {

void SingleCayley::factor(SkewHermitian<> const& a, double radius, double error) {
  auto const n = a.size();
  allocate(n);
  a_.real = a.real.cast<float>(), a_.imaginary = a.imaginary.cast<float>(), a_.sum = a_.real + a_.imaginary;
  // What is left out of the factors is by far less than the error that is allowed.
  auto const negligible = static_cast<float>(0.02 * error * radius);
  auto const measure = [negligible](Split& m) { m.reach = useful_reach(m.real, m.imaginary, negligible); };
  measure(a_);
  // X = -A^2, and X^2.
  lower(a_, a_);
  over_columns([&](auto below) {
    below(x_.real) = below(t2_) - below(t1_), below(x_.imaginary) = below(t1_) + below(t2_) - below(t3_);
  });
  complete(x_), measure(x_);
  lower(x_, x_);
  over_columns([&](auto below) {
    below(y_.real) = below(t1_) - below(t2_), below(y_.imaginary) = below(t3_) - below(t1_) - below(t2_);
  });
  complete(y_), measure(y_);
  // S - 1 by Horner's rule in X^2.
  Eigen::VectorXf const c = reciprocal(radius * radius, error).cast<float>();
  Eigen::Index k = c.size() - 3;
  over_columns([&](auto below) {
    below(h_.real) = c[k + 1] * below(x_.real) + c[k + 2] * below(y_.real);
    below(h_.imaginary) = c[k + 1] * below(x_.imaginary) + c[k + 2] * below(y_.imaginary);
  });
  h_.real.diagonal().array() += c[k];
  complete(h_), measure(h_);
  while (k > 0) {
    k -= 2;
    lower(y_, h_);
    over_columns([&](auto below) {
      below(h_.real) = c[k + 1] * below(x_.real) + (below(t1_) - below(t2_));
      below(h_.imaginary) = c[k + 1] * below(x_.imaginary) + (below(t3_) - below(t1_) - below(t2_));
    });
    h_.real.diagonal().array() += c[k];
    complete(h_), measure(h_);
  }
  // A S = A + A (S - 1), skew-Hermitian.
  lower(a_, h_);
  over_columns([&](auto below) {
    below(t3_) += below(a_.imaginary) - below(t1_) - below(t2_), below(t1_) += below(a_.real) - below(t2_);
    below(k_.real) = below(h_.real) + below(t1_), below(k_.imaginary) = below(h_.imaginary) + below(t3_);
    below(star_.real) = below(h_.real) - below(t1_);
    below(star_.imaginary) = below(h_.imaginary) - below(t3_);
  });
  over_tiles(n, [&](auto i, auto j, auto rows, auto columns) {
    adjoin(k_, star_, i, j, rows, columns), adjoin(star_, k_, i, j, rows, columns);
  });
  k_.sum = k_.real + k_.imaginary, star_.sum = star_.real + star_.imaginary;
  measure(k_), measure(star_);
}

void SingleCayley::evaluate(SkewHermitian<> const& a, double factor, SkewHermitian<float> const& x,
                            SkewHermitian<float>& f, SkewHermitian<float>& e, Eigen::Index reach) {
  // The squares that led to K are done with.
  Split& left = x_;
  left.real = (factor * a.real).cast<float>(), left.imaginary = (factor * a.imaginary).cast<float>();
  left.sum = left.real + left.imaginary, left.reach = a_.reach;
  both_sides(left, x, reach, a_, f, e);
  f *= static_cast<float>(1 / factor), e *= static_cast<float>(1 / factor);
}

void SingleCayley::commutator(SkewHermitian<float> const& y, SkewHermitian<float> const& x,
                              SkewHermitian<float>& c) {
  allocate(x.size());
  Reach const reach{reach_in_single(y), reach_in_single(x)};
  products_->multiply(y.real, x.real, t1_, reach);
  products_->multiply(y.imaginary, x.imaginary, t2_, reach);
  g_.real = y.real + y.imaginary, g_.imaginary = x.real + x.imaginary;
  products_->multiply(g_.real, g_.imaginary, t3_, reach);
  g_.real = t1_ - t2_, g_.imaginary = t3_ - t1_ - t2_;
  skew_part(c);
}

int SingleCayley::degree(double radius, double error) {
  double const b = radius * radius;
  // The pole of 1/(1 + x) seen from [0, b]: coefficients of Chebyshev's polynomials fall by this factor.
  double const fall = (2 + b) / b + std::sqrt((2 + b) / b * ((2 + b) / b) - 1);
  int degree = 2;
  while (degree < 24 && 2 * std::pow(fall, -degree - 1) > error) degree += 2;
  return degree;
}

void SingleCayley::allocate(Eigen::Index n) {
  if (t1_.rows() == n) return;
  for (Split* s : {&x_, &y_, &h_, &k_, &star_, &g_})
    s->real.resize(n, n), s->imaginary.resize(n, n), s->sum.resize(n, n);
  for (Part* part : {&t1_, &t2_, &t3_}) part->resize(n, n);
}

void SingleCayley::complete(Split& m) {
  m.imaginary.diagonal().setZero();
  over_tiles(m.real.rows(), [&](auto i, auto j, auto rows, auto columns) {
    if (i == j)
      for (Eigen::Index c = 0; c < columns; ++c)
        for (Eigen::Index r = c + 1; r < rows; ++r)
          m.real(j + c, i + r) = m.real(i + r, j + c), m.imaginary(j + c, i + r) = -m.imaginary(i + r, j + c);
    else
      m.real.block(j, i, columns, rows) = m.real.block(i, j, rows, columns).transpose(),
                                  m.imaginary.block(j, i, columns, rows) =
                                      -m.imaginary.block(i, j, rows, columns).transpose();
  });
  m.sum = m.real + m.imaginary;
}

void SingleCayley::adjoin(Split& m, Split const& star, Eigen::Index i, Eigen::Index j, Eigen::Index rows,
                          Eigen::Index columns) {
  for (Eigen::Index r = 0; r < rows; ++r)
    for (Eigen::Index c = 0; c < std::min(columns, i + r - j); ++c)
      m.real(j + c, i + r) = star.real(i + r, j + c),
                        m.imaginary(j + c, i + r) = -star.imaginary(i + r, j + c);
}

void SingleCayley::skew_part(SkewHermitian<float>& out) const {
  fit(out);
  over_tiles(t1_.rows(), [&](auto i, auto j, auto rows, auto columns) {
    out.real.block(i, j, rows, columns) =
        g_.real.block(i, j, rows, columns) - g_.real.block(j, i, columns, rows).transpose();
    out.imaginary.block(i, j, rows, columns) =
        g_.imaginary.block(i, j, rows, columns) + g_.imaginary.block(j, i, columns, rows).transpose();
  });
}

void SingleCayley::lower(Split const& a, Split const& b) {
  Reach const reach{a.reach, b.reach};
  products_->multiply_lower(a.real, b.real, t1_, reach);
  products_->multiply_lower(a.imaginary, b.imaginary, t2_, reach);
  products_->multiply_lower(a.sum, b.sum, t3_, reach);
}

void SingleCayley::both_sides(Split const& left, SkewHermitian<float> const& x, Eigen::Index reach_of_x,
                              Split const& right, SkewHermitian<float>& f, SkewHermitian<float>& e) {
  Reach const reach{left.reach, reach_of_x};
  t3_ = x.real + x.imaginary;
  products_->multiply(left.real, x.real, t1_, reach);
  products_->multiply(left.imaginary, x.imaginary, t2_, reach);
  products_->multiply(left.sum, t3_, g_.sum, reach);
  g_.reach = reach.product();
  g_.real = t1_ - t2_, g_.imaginary = g_.sum - t1_ - t2_;
  g_.sum = g_.real + g_.imaginary;
  skew_part(f);
  lower(g_, right);
  fit(e);
  over_columns([&](auto below) {
    below(e.real) = below(t1_) - below(t2_), below(e.imaginary) = below(t3_) - below(t1_) - below(t2_);
  });
  e.real.diagonal().setZero();
}

Eigen::VectorXd SingleCayley::reciprocal(double b, double error) {
  auto const count = degree(std::sqrt(b), error) + 1;
  // T_{k+1} = 2 (2x/b - 1) T_k - T_{k-1}, each in units of its value at -1, which grows with k.
  Eigen::VectorXd now = Eigen::VectorXd::Zero(count + 1), before = now;
  before[0] = 1, now[0] = 1 / (1 + 2 / b), now[1] = -2 / (b + 2);
  double ratio = -(1 + 2 / b);  // T_k(-1)/T_{k-1}(-1)
  for (int k = 1; k < count; ++k) {
    double const next = -2 * (1 + 2 / b) - 1 / ratio;
    Eigen::VectorXd t = -2 / next * now - before / (next * ratio);
    t.tail(count) += 4 / (b * next) * now.head(count);
    before = now, now = t, ratio = next;
  }
  // Division of 1 - T/T(-1), which vanishes at -1.
  Eigen::VectorXd c(count);
  c[0] = 1 - now[0];
  for (Eigen::Index k = 1; k < count; ++k) c[k] = -now[k] - c[k - 1];
  c[0] -= 1;
  return c;
}

}  // namespace actio::sphere
