#include "actio/fast_body/any_dimension/one_parameter_subgroup.hpp"

namespace actio::bodies {

namespace detail {

void OneParameterSubgroup::relative_motion(double const* z, double* e) {
  int const halvings = halvings_of(z);
  series_of_exponential(z, std::ldexp(1.0, -halvings), e);
  for (int k = 0; k < halvings; ++k) {
    // (1 + e)^2 - 1.
    std::copy(e, e + algebra_.size(), term_.data());
    algebra_.transpose_in_place(term_.data());
    algebra_.times_transposed(e, term_.data(), product_.data());
    algebra_.scale(2, e), algebra_.add(1, product_.data(), e);
  }
  orthogonalize(e);
}

void OneParameterSubgroup::mean(double const* z, double const* p, double* result) {
  int const halvings = halvings_of(z);
  series_of_mean(z, std::ldexp(1.0, -halvings), p, result);
  if (halvings == 0) return;
  double* const f = motion_.data();
  series_of_exponential(z, std::ldexp(1.0, -halvings), f);
  double* const room = term_.data();
  algebra_.add_identity(f);
  for (int k = 0; k < halvings; ++k) {
    // Over twice the way: half of the mean q so far, and half of f q f^T.
    algebra_.times_transposed(f, result, room), algebra_.times_transposed(room, f, product_.data());
    algebra_.add(-1, product_.data(), result);
    algebra_.scale(0.5, result), algebra_.make_skew(result);
    if (k + 1 == halvings) break;
    std::copy(f, f + algebra_.size(), room);
    algebra_.transpose_in_place(room);
    algebra_.times_transposed(f, room, product_.data());
    std::copy(product_.data(), product_.data() + algebra_.size(), f);
  }
}

void OneParameterSubgroup::series_of_exponential(double const* z, double part, double* e) {
  double const size = part * algebra_.norm(z);
  std::copy(z, z + algebra_.size(), e);
  algebra_.scale(-part, e);
  std::copy(e, e + algebra_.size(), term_.data());
  for (int k = 2; k < 40; ++k) {
    algebra_.times_transposed(term_.data(), z, product_.data());
    std::swap(term_, product_);
    algebra_.scale(part / k, term_.data());
    algebra_.add(1, term_.data(), e);
    if (!(algebra_.norm(term_.data()) > rounding * size)) break;
  }
}

void OneParameterSubgroup::series_of_mean(double const* z, double part, double const* p, double* result) {
  double const size = algebra_.norm(p);
  std::copy(p, p + algebra_.size(), result);
  std::copy(p, p + algebra_.size(), term_.data());
  for (int k = 2; k < 60; ++k) {
    algebra_.times_transposed(z, term_.data(), product_.data());
    algebra_.subtract_transposed(product_.data());
    std::swap(term_, product_);
    algebra_.scale(part / k, term_.data());
    algebra_.add(1, term_.data(), result);
    if (!(algebra_.norm(term_.data()) > rounding * size)) break;
  }
}

void OneParameterSubgroup::orthogonalize(double* e) {
  std::size_t const size = algebra_.size();
  double *const x = term_.data(), *const transposed = motion_.data(), *const product = product_.data();
  std::copy(e, e + size, transposed);
  algebra_.transpose_in_place(transposed);
  algebra_.times_transposed(transposed, transposed, x);
  algebra_.add(1, e, x), algebra_.add(1, transposed, x);
  algebra_.times_transposed(e, x, product);
  algebra_.add(-0.5, x, e), algebra_.add(-0.5, product, e);
}

}  // namespace detail

}  // namespace actio::bodies
