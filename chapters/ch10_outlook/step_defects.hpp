// What a step on vorticity matrices misses of being isospectral, self-adjoint and a Poisson map.
//
// The instruments of chapter 4A differentiate a map with dual numbers. A step that is found in single
// precision is written for doubles alone, so its tangent comes from differences here: over 0.02 of the state,
// of fourth order, so that an error of 1e-8 in the map becomes one of about 1e-6 in the tangent.
#pragma once

#include <Eigen/Core>

#include <functional>
#include <vector>

#include "actio/quantized_sphere/matrix_harmonics.hpp"
#include "actio/quantized_sphere/sphere_invariants.hpp"

namespace step_defects {

using actio::sphere::SkewHermitian;
// A step of the length h, forwards or back: a map of W alone.
using Step = std::function<actio::sphere::SkewHermitian<>(actio::sphere::SkewHermitian<> const&, double h)>;

// An orthonormal basis of the matrices of trace zero.
inline std::vector<actio::sphere::SkewHermitian<>> basis(int n) {
  std::vector<actio::sphere::SkewHermitian<>> out;
  for (int l = 1; l < n; ++l)
    for (int m = 0; m <= l; ++m)
      for (std::complex<double> const part : {std::complex<double>(1, 0), std::complex<double>(0, 1)}) {
        if (m == 0 && part.imag() != 0) continue;
        actio::sphere::SphereHarmonics f(n);
        f(l, m) = part;
        actio::sphere::SkewHermitian<> const e = actio::sphere::matrix_of(f);
        out.push_back((1 / actio::sphere::norm(e)) * e);
      }
  return out;
}

// The matrix of the Lie-Poisson bracket at W: <W, [e_a, e_b]>.
inline Eigen::MatrixXd bracket_at(std::vector<actio::sphere::SkewHermitian<>> const& e,
                                  actio::sphere::SkewHermitian<> const& w) {
  auto const d = static_cast<Eigen::Index>(e.size());
  Eigen::MatrixXd out(d, d);
  for (Eigen::Index a = 0; a < d; ++a)
    for (Eigen::Index b = 0; b < d; ++b)
      out(a, b) = actio::sphere::inner_product(
          w, actio::sphere::commutator(e[static_cast<std::size_t>(a)], e[static_cast<std::size_t>(b)]));
  return out;
}

// The Poisson defect of chapter 4A.
inline double poisson(Step const& step, actio::sphere::SkewHermitian<> const& w, double h) {
  auto const e = basis(static_cast<int>(w.size()));
  auto const d = static_cast<Eigen::Index>(e.size());
  double const delta = 0.02 * actio::sphere::norm(w);
  Eigen::MatrixXd tangent(d, d);
  for (Eigen::Index b = 0; b < d; ++b) {
    auto const at = [&](double k) { return step(w + (k * delta) * e[static_cast<std::size_t>(b)], h); };
    actio::sphere::SkewHermitian<> const slope =
        (1 / (12 * delta)) * (8.0 * (at(1) - at(-1)) - (at(2) - at(-2)));
    for (Eigen::Index a = 0; a < d; ++a)
      tangent(a, b) = actio::sphere::inner_product(e[static_cast<std::size_t>(a)], slope);
  }
  Eigen::MatrixXd const carried = tangent * bracket_at(e, w) * tangent.transpose(),
                        there = bracket_at(e, step(w, h));
  return (carried - there).norm() / (carried.norm() + there.norm());
}

// How far a step and the step of opposite sign lead from W, relative to it.
inline double self_adjointness(Step const& step, actio::sphere::SkewHermitian<> const& w, double h) {
  return actio::sphere::norm(step(step(w, h), -h) - w) / actio::sphere::norm(w);
}

// The largest change of an eigenvalue, relative to their root mean square.
inline double spectrum(Step const& step, actio::sphere::SkewHermitian<> const& w, double h) {
  Eigen::VectorXd const change =
      actio::sphere::vorticity_values(step(w, h)) - actio::sphere::vorticity_values(w);
  return change.cwiseAbs().maxCoeff() * std::sqrt(static_cast<double>(w.size())) / actio::sphere::norm(w);
}

}  // namespace step_defects
