// Products of real matrices by a BLAS, on several threads, equal bit for bit for any number of them.
//
// The library is taken by pointers to its functions, so that a program may link it or load it when it runs:
//
//   linked    extern "C" void dgemm_(...), sgemm_(...);
//             BlasFunctions const blas{&dgemm_, &sgemm_};
//   loaded    void* const library = dlopen("libopenblas.so.0", RTLD_NOW | RTLD_LOCAL);
//             BlasFunctions const blas{reinterpret_cast<Gemm<double>*>(dlsym(library, "dgemm_")),
//                                      reinterpret_cast<Gemm<float>*>(dlsym(library, "sgemm_"))};
//
// Integers are of 32 bits. Inside, the library has to work on one thread (openblas_set_num_threads(1), or the
// environment variable OPENBLAS_NUM_THREADS): columns of the result are cut into panels that depend on the
// size alone, and the threads are ours and take panels as they become free.
#pragma once

#include <Eigen/Core>

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "actio/skew_matrices/products.hpp"

namespace actio::sphere {

/// The product of general matrices as BLAS has it, called as in Fortran.
template <class Real>
using Gemm = void(char const* a_transposed, char const* b_transposed, int const* m, int const* n,
                  int const* k, Real const* alpha, Real const* a, int const* lda, Real const* b,
                  int const* ldb, Real const* beta, Real* c, int const* ldc);

/// The two functions of a BLAS that a step needs.
struct BlasFunctions {
  Gemm<double>* dgemm = nullptr;  ///< in double precision
  Gemm<float>* sgemm = nullptr;   ///< in single precision
};

/// Threads that wait for work.
class PanelThreads {
 public:
  /// @param threads  how many work, the caller among them
  explicit PanelThreads(int threads) {
    for (int k = 1; k < threads; ++k) threads_.emplace_back([this] { serve(); });
  }
  PanelThreads(PanelThreads const&) = delete;
  PanelThreads& operator=(PanelThreads const&) = delete;
  ~PanelThreads();

  /// Calls `work(0)` to `work(count - 1)`, each once, in any order and on any thread; returns when all are
  /// done.
  void run(int count, std::function<void(int)> const& work);

 private:
  void serve();
  std::mutex mutex_;
  std::condition_variable wake_, done_;
  std::function<void(int)> const* work_ = nullptr;
  std::atomic<int> next_ = 0;
  int count_ = 0, busy_ = 0;
  long round_ = 0;
  bool over_ = false;
  std::vector<std::thread> threads_;
};

/// Products of real matrices for the steps of a flow, used by one caller at a time.
class BlasProducts : public ProductsBy<BlasProducts> {
 public:
  /// @param threads  the most that work on a product; small products are left to the caller's
  explicit BlasProducts(BlasFunctions blas, int threads = 1) : blas_(blas) {
    if (threads > 1) threads_ = std::make_unique<PanelThreads>(threads);
  }

  /// Products of matrices smaller than this are not worth waking a thread for.
  static constexpr int smallest_shared = 128;
  /// The width of the panels into which the columns of a result are cut: an eighth, so that half of a result
  /// costs 9/16 of the whole.
  static int panel(int n) { return std::max(32, ((n + 7) / 8 + 7) / 8 * 8); }

  /// out = a b.
  template <class Part>
  void whole(Part const& a, Part const& b, Part& out, Reach reach = {}) const {
    int const n = static_cast<int>(a.rows());
    // Alone it is one panel below the size that is shared. Products of up to a million terms have a kernel of
    // their own in OpenBLAS, and it is worth four panels to be among them; then two lose the least.
    int const width = n < smallest_shared       ? n
                      : reach.product() < n / 2 ? panel(n)
                      : n < 256 || n > 512      ? 2 * panel(n)
                                                : 4 * panel(n);
    over_panels(n, width,
                [&](int first, int columns) { multiply_columns(a, b, out, reach, 0, first, columns); });
  }
  /// What is on and below the diagonal of out = a b, and some of what is above.
  template <class Part>
  void lower(Part const& a, Part const& b, Part& out, Reach reach = {}) const {
    int const n = static_cast<int>(a.rows());
    over_panels(n, panel(n),
                [&](int first, int columns) { multiply_columns(a, b, out, reach, first, first, columns); });
  }

 private:
  template <class Real>
  void gemm(int m, int n, int k, Real const* a, int lda, Real const* b, int ldb, Real* c, int ldc) const {
    Real const one = 1, zero = 0;
    if constexpr (std::is_same_v<Real, double>)
      blas_.dgemm("N", "N", &m, &n, &k, &one, a, &lda, b, &ldb, &zero, c, &ldc);
    else
      blas_.sgemm("N", "N", &m, &n, &k, &one, a, &lda, b, &ldb, &zero, c, &ldc);
  }
  /// Some columns of out = a b, from the row `top` on.
  template <class Part>
  void multiply_columns(Part const& a, Part const& b, Part& out, Reach reach, int top, int first,
                        int columns) const {
    int const n = static_cast<int>(a.rows());
    auto const within = [n](Eigen::Index k) { return static_cast<int>(std::clamp<Eigen::Index>(k, 0, n)); };
    // What is not zero of these columns of b, and what of a meets it.
    int const inner = within(first - reach.right), inner_end = within(first + columns + reach.right);
    int const begin = std::max(top, within(inner - reach.left)), end = within(inner_end + reach.left);
    gemm(end - begin, columns, inner_end - inner, &a(begin, inner), n, &b(inner, first), n,
         &out(begin, first), n);
    out.block(top, first, begin - top, columns).setZero();
    out.block(end, first, n - end, columns).setZero();
  }
  template <class Work>
  void over_panels(int n, int width, Work const& work) const {
    int const count = (n + width - 1) / width;
    auto const one = [&](int k) { work(k * width, std::min(width, n - k * width)); };
    if (threads_ && n >= smallest_shared && count > 1)
      threads_->run(count, one);
    else
      for (int k = 0; k < count; ++k) one(k);
  }
  BlasFunctions blas_;
  std::unique_ptr<PanelThreads> threads_;
};

}  // namespace actio::sphere
