// The Moser-Veselov equation on SO(n) by squares: what is done entry by entry.
//
// Let f = 1 + e be the relative motion of a step and G = e e^T. That f is a rotation and that M0 and M1 are
// the momenta of its step is, together,
//
//     e + e^T = -G,      e - e^T = -h J^-1 (M0 + M1),      M1 - M0 = -[Lambda, G]/h,
//
// with (J xi)_ij = (Lambda_i + Lambda_j) xi_ij. The first line is f f^T = 1. Given it, the momenta h M0 = f^T
// Lambda - Lambda f and h M1 = Lambda f^T - f Lambda have the difference Lambda (e + e^T) - (e + e^T) Lambda
// and the sum -Lambda (e - e^T) - (e - e^T) Lambda. So e is made of G and M0 without any product,
//
//     e_ij = -G_ij/2 - h (M0_ij + (Lambda_j - Lambda_i) G_ij/2h) / (Lambda_i + Lambda_j),
//
// and G = e e^T is a fixed-point equation for the symmetric matrix G alone. A sweep computes e from G, and a
// square G from e.
//
// No Lambda_i is divided by: one may be zero or negative. Nothing of first order in the step cancels: G is of
// second order, and so is what its rounding does to M. And the constants may be rounded: f is normal, so that
// sum G_ij (mu_j - mu_i) (e - e^T)_ij = 0 for any mu, and as M1 - M0 is c_ij G_ij and e - e^T is -a_ij
// (M0 + M1)_ij, with a_ij and c_ij as they are in the machine, the n-1 sums sum (mu_j - mu_i) (a_ij/c_ij)
// M_ij^2 are conserved as they would be with exact constants: among them what is near Tr M^2 and near the
// energy.
//
// Matrices are in blocks: e is full, of G and M one half is stored.
#pragma once

#include "actio/fast_body/any_dimension/blocked_matrix.hpp"
#include "actio/fast_body/any_dimension/least_squares_extrapolation.hpp"

namespace actio::bodies::detail {

/// sum + rest + more, the first to rounding of the whole and the second what that rounding left over.
[[gnu::always_inline]] inline void add_compensated(FourLanes& sum, FourLanes& rest, FourLanes const& more) {
  FourLanes const s = sum + more, part = s - sum;
  FourLanes const left = rest + ((sum - (s - part)) + (more - part));
  sum = s + left;
  rest = left - (sum - s);
}

/// Four entries of e from as many of G and M0, below the diagonal (`lower`) and at their mirror images
/// (`upper`).
/// @param slope    \f$(\Lambda_j-\Lambda_i)/h\f$
/// @param inverse  \f$h/(\Lambda_i+\Lambda_j)\f$
[[gnu::always_inline]] inline void relative_motion_entries(FourLanes const& square, FourLanes const& momentum,
                                                           FourLanes const& slope, FourLanes const& inverse,
                                                           FourLanes& lower, FourLanes& upper) {
  // [relative_motion_of_square]
  FourLanes const half = square * 0.5;
  FourLanes const turn = inverse * (momentum + slope * half);
  lower = -(half + turn);
  upper = turn - half;
  // [relative_motion_of_square]
}

/// What a body is to a sweep.
struct SweptInertia {
  double const* lambda;   ///< \f$\Lambda_i/h\f$, zeros beyond n
  double const* inverse;  ///< \f$h/(\Lambda_i+\Lambda_j)\f$, a half; zero on the diagonal and beyond n
};

/// Writes the mirror image of block (i, j) of e, unless it lies on the diagonal.
template <int B>
[[gnu::always_inline]] inline void write_mirror(Blocked<B> const& shape, FourLanes (&mirror)[4], double* e,
                                                int i, int j) {
  if (i == j) return;
  transpose(mirror);
  double* const to = e + full_block(shape, j, i);
#pragma GCC unroll 4
  for (int c = 0; c < 4; ++c) lanes(to + 4 * c) = mirror[c];
}

/// e from G and M0.
template <int B>
[[gnu::always_inline]] inline void relative_motion(Blocked<B> const& shape, SweptInertia const& body,
                                                   double const* square, double const* momentum, double* e) {
  std::ptrdiff_t at = 0;
  for (int j = 0; j < shape.blocks(); ++j)
    for (int i = j; i < shape.blocks(); ++i, at += 16) {
      FourLanes const lambda = lanes(body.lambda + 4 * i);
      double* const to = e + full_block(shape, i, j);
      FourLanes mirror[4];
#pragma GCC unroll 4
      for (int c = 0; c < 4; ++c)
        relative_motion_entries(lanes(square + at + 4 * c), lanes(momentum + at + 4 * c),
                                body.lambda[4 * j + c] - lambda, lanes(body.inverse + at + 4 * c),
                                lanes(to + 4 * c), mirror[c]);
      write_mirror(shape, mirror, e, i, j);
    }
}

/// What a sweep has achieved.
struct Defect {
  double change = 0;  ///< \f$|ee^T-G|_F^2\f$ where e was made of G: the square of \f$|ff^T-1|_F\f$
  double square = 0;  ///< \f$|ee^T|_F^2\f$
  double trace = 0;   ///< \f$|e|_F^2\f$
};
template <int B>
[[gnu::always_inline]] inline Defect defect(Blocked<B> const& shape, double const* square,
                                            double const* guess) {
  FourLanes change = {}, size = {};
  Defect sums;
  std::ptrdiff_t at = 0;
  for (int j = 0; j < shape.blocks(); ++j) {
    for (int c = 0; c < 4; ++c) sums.trace += square[at + 5 * c];
    for (int i = j; i < shape.blocks(); ++i, at += 16) {
      double const weight = i == j ? 1 : 2;
#pragma GCC unroll 4
      for (int c = 0; c < 4; ++c) {
        FourLanes const g = lanes(square + at + 4 * c), d = g - lanes(guess + at + 4 * c);
        change += d * d * weight, size += g * g * weight;
      }
    }
  }
  sums.change = sum(change), sums.square = sum(size);
  return sums;
}

/// After the step: the momentum, a guess at the next square from the past ones, and e of these two.
/// \implements{eq_5_8}
/// @param past  the latest square, and those before it
template <int B>
[[gnu::always_inline]] inline void advance(Blocked<B> const& shape, SweptInertia const& body,
                                           Weights const& next, double const* const* past, double* momentum,
                                           double* rest, double* guess, double* e) {
  std::ptrdiff_t at = 0;
  for (int j = 0; j < shape.blocks(); ++j)
    for (int i = j; i < shape.blocks(); ++i, at += 16) {
      FourLanes const lambda = lanes(body.lambda + 4 * i);
      double* const to = e + full_block(shape, i, j);
      FourLanes mirror[4], g[4] = {};
      for (int k = 0; k < next.length; ++k) {
        double const* const term = past[k] + at;
        double const weight = next.weight[static_cast<std::size_t>(k)];
#pragma GCC unroll 4
        for (int c = 0; c < 4; ++c) g[c] += lanes(term + 4 * c) * weight;
      }
#pragma GCC unroll 4
      for (int c = 0; c < 4; ++c) {
        std::ptrdiff_t const offset = at + 4 * c;
        FourLanes const slope = body.lambda[4 * j + c] - lambda;
        // [eq_5_8]
        add_compensated(lanes(momentum + offset), lanes(rest + offset), slope * lanes(past[0] + offset));
        // [eq_5_8]
        lanes(guess + offset) = g[c];
        relative_motion_entries(g[c], lanes(momentum + offset), slope, lanes(body.inverse + offset),
                                lanes(to + 4 * c), mirror[c]);
      }
      write_mirror(shape, mirror, e, i, j);
    }
}

/// \f$g_1 = g_0 + g_0e^T\f$, given the product.
template <int B>
[[gnu::always_inline]] inline void turn(Blocked<B> const& shape, double* attitude, double* rest,
                                        double const* product) {
  std::ptrdiff_t const size = full_block(shape, shape.blocks(), 0);
  for (std::ptrdiff_t at = 0; at < size; at += 4)
    add_compensated(lanes(attitude + at), lanes(rest + at), lanes(product + at));
}

}  // namespace actio::bodies::detail
