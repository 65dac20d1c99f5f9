#include "actio/rods/unshearable.hpp"

#include <cmath>

namespace actio::rods {
namespace {

using Block = std::array<Three<double>, 3>;  // rows

Block product(Block const& a, Block const& b) {
  Block out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) out[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  return out;
}
/// a diag(d) b^T
Block product_transposed(Block const& a, Three<double> const& d, Block const& b) {
  Block out;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      out[i][j] = a[i][0] * d[0] * b[j][0] + a[i][1] * d[1] * b[j][1] + a[i][2] * d[2] * b[j][2];
  return out;
}
Block sum(Block const& a, Block const& b, double factor) {
  Block out;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) out[i][j] = a[i][j] + factor * b[i][j];
  return out;
}
Block transposed(Block const& a) {
  return {Three<double>{a[0][0], a[1][0], a[2][0]}, {a[0][1], a[1][1], a[2][1]}, {a[0][2], a[1][2], a[2][2]}};
}
Three<double> applied(Block const& a, Three<double> const& v) {
  return {bodies::dot(a[0], v), bodies::dot(a[1], v), bodies::dot(a[2], v)};
}
/// c + v x: the matrix of that.
Block cross_matrix(double c, Three<double> const& v) {
  return {Three<double>{c, -v[2], v[1]}, {v[2], c, -v[0]}, {-v[1], v[0], c}};
}
/// Of a symmetric positive definite block.
bool invert(Block const& a, Block& out) {
  double const c0 = a[1][1] * a[2][2] - a[1][2] * a[1][2], c1 = a[0][2] * a[1][2] - a[0][1] * a[2][2],
               c2 = a[0][1] * a[1][2] - a[0][2] * a[1][1], det = a[0][0] * c0 + a[0][1] * c1 + a[0][2] * c2,
               minor = a[0][0] * a[1][1] - a[0][1] * a[0][1];
  if (!(a[0][0] > 0 && minor > 0 && det > 0)) return false;
  double const d = 1 / det;
  double const x12 = (a[0][1] * a[0][2] - a[0][0] * a[1][2]) * d;
  out = {Three<double>{c0 * d, c1 * d, c2 * d},
         {c1 * d, (a[0][0] * a[2][2] - a[0][2] * a[0][2]) * d, x12},
         {c2 * d, x12, minor * d}};
  return true;
}

/// How the stretch of an element changes with its sections: by their places in space, and by turns in their
/// axes.
struct StretchDifferential {
  Block shift;  ///< by the place of the second section in the axes of the first; the first has its negative
  Block first,  ///< by turns of the first section
      second;   ///< by turns of the second section
  Four<double> q;  ///< attitude of the first section
};

StretchDifferential differential(RodState const& state, std::size_t k) {
  auto const q0 = vector_at(state.q, k), q1 = vector_at(state.q, k + 1);
  auto const a = vector_at(state.x, k), b = vector_at(state.x, k + 1);
  auto const e = RelativePlacement<double>::of(q0, q1, {b[0] - a[0], b[1] - a[1], b[2] - a[2]});
  // dw = T(w) (theta_1 - E^T theta_0), T(w) E^T = T(-w); d eps = u_1 - u_0 + eps x theta_0.
  auto const T = [&](double sign) {
    Block out = cross_matrix(1, times(sign / 2, e.w));
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) out[i][j] += e.w[i] * e.w[j] / 4;
    return out;
  };
  Block const shift = cross_matrix(1, times(-0.5, e.w)), half = cross_matrix(0, times(0.5, e.eps));
  return {shift, sum(product(shift, cross_matrix(0, e.eps)), product(half, T(-1)), -1), product(half, T(1)),
          q0};
}

}  // namespace

bool StretchMatrix::factor(RodConstants const& rod, RodState const& state, double factor,
                           std::array<bool, 2> const& held_places,
                           std::array<bool, 2> const& held_attitudes) {
  std::size_t const elements = rod.elements;
  inverse_.resize(elements), below_.resize(elements);
  auto const& I = rod.section.inertia;
  auto const weight = [&](std::size_t section, bool place) {
    bool const first = section == 0, last = section == elements;
    auto const& held = place ? held_places : held_attitudes;
    if ((first && held[0]) || (last && held[1])) return 0.0;
    return factor / rod.share[section];
  };
  StretchDifferential here = differential(state, 0);
  double mass = weight(0, true) / rod.section.mass, turn = weight(0, false);
  for (std::size_t k = 0; k < elements; ++k) {
    double const next_mass = weight(k + 1, true) / rod.section.mass, next_turn = weight(k + 1, false);
    auto const over = [&](double w) { return Three<double>{w / I[0], w / I[1], w / I[2]}; };
    Block const& A = here.shift;
    Block diagonal = product_transposed(A, {mass + next_mass, mass + next_mass, mass + next_mass}, A);
    diagonal = sum(diagonal, product_transposed(here.first, over(turn), here.first), 1);
    diagonal = sum(diagonal, product_transposed(here.second, over(next_turn), here.second), 1);
    if (k > 0) {
      // S_{k,k-1} in below_[k-1] so far; L = S_{k,k-1} D_{k-1}^{-1}
      Block const off = below_[k - 1];
      below_[k - 1] = product(off, inverse_[k - 1]);
      diagonal = sum(diagonal, product(below_[k - 1], transposed(off)), -1);
    }
    if (!invert(diagonal, inverse_[k])) return false;
    if (k + 1 == elements) break;
    StretchDifferential const next = differential(state, k + 1);
    // Rows of element k + 1, columns of k: places of section k + 1 in the axes of k, by E_k.
    auto const e = bodies::compose(inverse_turn(here.q), next.q);
    Block rotation;  // columns: axes of the section after, in those of the section before
    for (std::size_t i = 0; i < 3; ++i) {
      Three<double> axis{};
      axis[i] = 1;
      auto const column = turned(e, axis);
      for (std::size_t j = 0; j < 3; ++j) rotation[j][i] = column[j];
    }
    Block const forward = product(here.shift, rotation);
    below_[k] = sum(product_transposed(next.shift, {-next_mass, -next_mass, -next_mass}, forward),
                    product_transposed(next.first, over(next_turn), here.second), 1);
    here = next, mass = next_mass, turn = next_turn;
  }
  return true;
}

void StretchMatrix::correct(Rows<3>& r, Rows<3>& N) const {
  std::size_t const elements = inverse_.size();
  Three<double> before = vector_at(r, 0);
  for (std::size_t k = 1; k < elements; ++k) {
    auto const down = applied(below_[k - 1], before);
    auto here = vector_at(r, k);
    for (std::size_t i = 0; i < 3; ++i) here[i] -= down[i];
    put_vector(r, k, here), before = here;
  }
  Three<double> after{};
  for (std::size_t k = elements; k-- > 0;) {
    auto x = applied(inverse_[k], vector_at(r, k));
    if (k + 1 < elements) {
      auto const up = applied(transposed(below_[k]), after);
      for (std::size_t i = 0; i < 3; ++i) x[i] -= up[i];
    }
    for (std::size_t i = 0; i < 3; ++i) N[i][k] += x[i];
    after = x;
  }
}

}  // namespace actio::rods
