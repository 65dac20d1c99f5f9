#include "actio/quantized_torus/fft.hpp"

#include <fftw3.h>

#include <mutex>
#include <new>

namespace actio::torus::detail {
namespace {

/// FFTW makes and destroys one plan at a time.
std::mutex& planner() {
  static std::mutex one;
  return one;
}
fftw_complex* raw(std::complex<double>* numbers) { return reinterpret_cast<fftw_complex*>(numbers); }
fftw_plan plan_of(std::shared_ptr<void> const& plan) { return static_cast<fftw_plan>(plan.get()); }

/// Keeps a plan, which is to be made under the lock of the planner.
std::shared_ptr<void> kept(fftw_plan plan) {
  if (!plan) throw std::bad_alloc();
  return {static_cast<void*>(plan), [](void* p) {
            std::lock_guard const lock(planner());
            fftw_destroy_plan(static_cast<fftw_plan>(p));
          }};
}

}  // namespace

std::complex<double>* fft_allocate(std::size_t count) {
  auto* const memory = fftw_malloc(count * sizeof(fftw_complex));
  if (!memory) throw std::bad_alloc();
  return static_cast<std::complex<double>*>(memory);
}
void fft_free(void* memory) { fftw_free(memory); }

// A plan that is estimated, and not measured, is the same one in every run, and leaves the numbers alone.

std::shared_ptr<void> fft_side_by_side(int length, int many, bool forwards) {
  std::unique_ptr<std::complex<double>, void (*)(void*)> const some(
      fft_allocate(static_cast<std::size_t>(length) * static_cast<std::size_t>(many)), fft_free);
  fftw_plan plan;
  {
    std::lock_guard const lock(planner());
    plan = fftw_plan_many_dft(1, &length, many, raw(some.get()), nullptr, many, 1, raw(some.get()), nullptr,
                              many, 1, forwards ? FFTW_FORWARD : FFTW_BACKWARD, FFTW_ESTIMATE);
  }
  return kept(plan);
}
void fft_run(std::shared_ptr<void> const& plan, std::complex<double>* numbers) {
  fftw_execute_dft(plan_of(plan), raw(numbers), raw(numbers));
}

void fft_to_values(int size, std::complex<double>* coefficients, double* values) {
  fftw_plan plan;
  {
    std::lock_guard const lock(planner());
    plan = fftw_plan_dft_c2r_2d(size, size, raw(coefficients), values, FFTW_ESTIMATE);
  }
  fftw_execute(plan_of(kept(plan)));
}
void fft_from_values(int size, double const* values, std::complex<double>* coefficients) {
  fftw_plan plan;
  {
    std::lock_guard const lock(planner());
    plan = fftw_plan_dft_r2c_2d(size, size, const_cast<double*>(values), raw(coefficients),
                                FFTW_ESTIMATE | FFTW_PRESERVE_INPUT);
  }
  fftw_execute(plan_of(kept(plan)));
}

}  // namespace actio::torus::detail
