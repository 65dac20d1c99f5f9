// Reading and writing rows some sections at a time, and kernels for packs of every width.
//
// For units that are compiled for every kind of register.
#pragma once

#include <cstring>

#include "actio/numbers/registers.hpp"
#include "actio/rods/rod_arrays.hpp"

namespace actio::rods {

/// The numbers from place k on.
template <int W>
[[gnu::always_inline]] inline Pack<W> load(std::vector<double> const& row, std::size_t k) {
  Pack<W> out;
  std::memcpy(&out.lane, row.data() + k, sizeof out.lane);
  return out;
}
/// Puts them there.
template <int W>
[[gnu::always_inline]] inline void store(std::vector<double>& row, std::size_t k, Pack<W> const& x) {
  std::memcpy(row.data() + k, &x.lane, sizeof x.lane);
}
/// Vectors from place k on.
template <int W, std::size_t n>
[[gnu::always_inline]] inline std::array<Pack<W>, n> load(Rows<n> const& rows, std::size_t k) {
  std::array<Pack<W>, n> out;
  for (std::size_t i = 0; i < n; ++i) out[i] = load<W>(rows[i], k);
  return out;
}
/// Puts them there.
template <int W, std::size_t n>
[[gnu::always_inline]] inline void store(Rows<n>& rows, std::size_t k, std::array<Pack<W>, n> const& v) {
  for (std::size_t i = 0; i < n; ++i) store<W>(rows[i], k, v[i]);
}
/// The same vector in all lanes.
template <int W>
[[gnu::always_inline]] inline Three<Pack<W>> everywhere(Three<double> const& v) {
  return {Pack<W>(v[0]), Pack<W>(v[1]), Pack<W>(v[2])};
}
/// How sections lie after each other.
template <int W>
[[gnu::always_inline]] inline RelativePlacement<Pack<W>> placement(RodState const& state, std::size_t k) {
  using T = Pack<W>;
  Three<T> const a = load<W>(state.x, k), b = load<W>(state.x, k + 1);
  return RelativePlacement<T>::of(load<W>(state.q, k), load<W>(state.q, k + 1),
                                  bodies::plus(b, times(T(-1.0), a)));
}

/// Runs the kernel that `make` makes for packs of eight where registers hold them, otherwise of four.
template <class Make>
auto run_sweep(Registers registers, Make const& make) {
  auto const run = [&](auto kernel) {
    run_with(registers, kernel);
    return kernel.result;
  };
  return registers == Registers::avx512 ? run(make.template operator()<8>())
                                        : run(make.template operator()<4>());
}

}  // namespace actio::rods
