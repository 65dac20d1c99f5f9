// SIMD lanes: several numbers in one register, on which an instruction does the same arithmetic at once.
//
// The vectors are those of the compiler (GNU extension), so the source is the same for every width of
// registers: a Pack of four doubles is one register of AVX2, or two of SSE2. Kernels are function objects
// whose call is always inlined; `run_on` compiles each twice, for the plain machine and for AVX2 with fused
// multiplication, and takes the one that is asked for. Arguments go by reference throughout: by value, the
// two would not agree on where they are.
#pragma once

#include <cmath>
#include <string>

#if (defined(__x86_64__) || defined(__i386__)) && defined(__GNUC__)
#define ACTIO_AVX2 1
#define ACTIO_FOR_AVX2 [[gnu::target("avx2,fma")]]
#else
/// 1 where the compiler can be asked for AVX2 instructions in a single function.
#define ACTIO_AVX2 0
/// Before a function: it may use AVX2 and fused multiplication.
#define ACTIO_FOR_AVX2
#endif

namespace actio::bodies {

/// n doubles in the lanes of one SIMD register; n a power of two.
template <int n>
struct Pack {
  /// What the compiler calls n doubles.
  using Vector [[gnu::vector_size(n * sizeof(double))]] = double;
  static constexpr int size = n;

  alignas(n * sizeof(double)) Vector lane;  ///< the numbers

  Pack() = default;
  /// The same number in all lanes.
  [[gnu::always_inline]] Pack(double x) : lane(x - Vector{}) {}
  /// These numbers.
  [[gnu::always_inline]] explicit Pack(Vector const& x) : lane(x) {}

  /// The number in lane i.
  [[gnu::always_inline]] double operator[](int i) const { return read(lane, i); }
  /// Puts x into lane i.
  [[gnu::always_inline]] void set(int i, double x) { write(lane, i, x); }

  [[gnu::always_inline]] friend Pack operator+(Pack const& x, Pack const& y) { return Pack(x.lane + y.lane); }
  [[gnu::always_inline]] friend Pack operator-(Pack const& x, Pack const& y) { return Pack(x.lane - y.lane); }
  [[gnu::always_inline]] friend Pack operator*(Pack const& x, Pack const& y) { return Pack(x.lane * y.lane); }
  [[gnu::always_inline]] friend Pack operator/(Pack const& x, Pack const& y) { return Pack(x.lane / y.lane); }
  [[gnu::always_inline]] friend Pack operator-(Pack const& x) { return Pack(-x.lane); }
  [[gnu::always_inline]] Pack& operator+=(Pack const& y) { return lane += y.lane, *this; }
  [[gnu::always_inline]] Pack& operator-=(Pack const& y) { return lane -= y.lane, *this; }
  [[gnu::always_inline]] Pack& operator*=(Pack const& y) { return lane *= y.lane, *this; }

 private:
  // Templates of their own: the compiler must know that it is a vector before it accepts the brackets.
  template <class V>
  [[gnu::always_inline]] static double read(V const& vector, int i) { return vector[i]; }
  template <class V>
  [[gnu::always_inline]] static void write(V& vector, int i, double x) { vector[i] = x; }
};

/// Whether x is at most the bound, in every lane; a NaN is not.
[[gnu::always_inline]] inline bool all_within(double const& x, double bound) { return x <= bound; }
/// The same for lanes.
template <int n>
[[gnu::always_inline]] inline bool all_within(Pack<n> const& x, double bound) {
  auto const within = x.lane <= Pack<n>(bound).lane;
  auto both = within[0];
  for (int i = 1; i < n; ++i) both &= within[i];
  return both != 0;
}

/// Whether the arithmetic of T is that of double, in one lane or in several.
template <class T>
inline constexpr bool of_doubles = false;
/// \copydoc of_doubles
template <>
inline constexpr bool of_doubles<double> = true;
/// \copydoc of_doubles
template <int n>
inline constexpr bool of_doubles<Pack<n>> = true;

/// For which machine a kernel is compiled.
enum class Machine {
  plain,  ///< whatever the compiler was told, on x86-64 two lanes
  avx2    ///< four lanes and fused multiplication
};

/// The best that this machine can do.
Machine best_machine();
/// Its name, for people.
inline std::string name_of(Machine machine) { return machine == Machine::avx2 ? "AVX2" : "baseline"; }

namespace detail {
template <class Kernel>
ACTIO_FOR_AVX2 void run_avx2(Kernel& kernel) { kernel(); }
template <class Kernel>
void run_plain(Kernel& kernel) { kernel(); }
}  // namespace detail

/// Runs a kernel, compiled for that machine. Its call operator must be always_inline.
template <class Kernel>
void run_on(Machine machine, Kernel& kernel) {
  if (ACTIO_AVX2 && machine == Machine::avx2)
    detail::run_avx2(kernel);
  else
    detail::run_plain(kernel);
}

}  // namespace actio::bodies
