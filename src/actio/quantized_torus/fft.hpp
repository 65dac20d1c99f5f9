// Plans of FFTW, made by one thread at a time: the only place that names it.
#pragma once

#include <complex>
#include <memory>

namespace actio::torus::detail {

/// Memory as FFTW's plans expect it; freed by `fft_free`.
std::complex<double>* fft_allocate(std::size_t count);
/// Frees it.
void fft_free(void* memory);

/// In place, of `many` signals side by side: the entry k of the signal j at k many + j.
std::shared_ptr<void> fft_side_by_side(int length, int many, bool forwards);
/// Makes one of these.
void fft_run(std::shared_ptr<void> const& plan, std::complex<double>* numbers);

/// \f$\sum_{mn}g_{mn}e^{2\pi i(mj+nk)/M}\f$ of real functions on M by M points: from the coefficients
/// with n = 0 .. M/2 at m (M/2 + 1) + n to the values at j M + k. The coefficients are overwritten.
void fft_to_values(int size, std::complex<double>* coefficients, double* values);
/// Back: \f$\sum_{jk}f_{jk}e^{-2\pi i(mj+nk)/M}\f$. The values are kept.
void fft_from_values(int size, double const* values, std::complex<double>* coefficients);

}  // namespace actio::torus::detail
