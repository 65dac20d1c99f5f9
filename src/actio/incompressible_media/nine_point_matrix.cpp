// In a unit of its own
#include "actio/incompressible_media/nine_point_matrix.hpp"

#include <cstring>

#include "actio/numbers/registers.hpp"

namespace actio::media {

namespace {

/// Eight doubles.
using Doubles [[gnu::vector_size(64)]] = double;

/// The same anywhere in memory.
using DoublesThere [[gnu::vector_size(64), gnu::aligned(8), gnu::may_alias]] = double;

[[gnu::always_inline]] inline DoublesThere const& load_eight(double const* from) {
  return *reinterpret_cast<DoublesThere const*>(from);
}

/// out = S x, or b - S x where there is a b.
struct Product {
  NinePointMatrix const& m;
  double const* b;
  double const* x;
  double* out;
  std::vector<double> const& zero;

  [[gnu::always_inline]] void operator()() {
    int const n = m.cells[0];
    for (int j = 0; j < m.cells[1]; ++j) {
      std::size_t const row = m.at(0, j);
      bool const above = m.holds(0, j + 1), below = m.holds(0, j - 1);
      double const *const up = above ? x + m.at(0, j + 1) : zero.data(),
                          *const down = below ? x + m.at(0, j - 1) : zero.data(), *const here = x + row;
      auto const lower = [&](std::vector<double> const& a) {
        return below ? a.data() + m.at(0, j - 1) : zero.data();
      };
      double const *const self = m.self.data() + row, *const e = m.east.data() + row,
                          *const n0 = m.north.data() + row, *const ne = m.north_east.data() + row,
                          *const nw = m.north_west.data() + row, *const s = lower(m.north),
                          *const sw = lower(m.north_east), *const se = lower(m.north_west);
      int i = 1;
      finish(j, 0);
      for (; i + 8 < n; i += 8) {
        Doubles const along = load_eight(self + i) * load_eight(here + i) +
                              load_eight(e + i) * load_eight(here + i + 1) +
                              load_eight(e + i - 1) * load_eight(here + i - 1);
        Doubles const over = load_eight(n0 + i) * load_eight(up + i) +
                             load_eight(ne + i) * load_eight(up + i + 1) +
                             load_eight(nw + i) * load_eight(up + i - 1);
        Doubles const under = load_eight(s + i) * load_eight(down + i) +
                              load_eight(sw + i - 1) * load_eight(down + i - 1) +
                              load_eight(se + i + 1) * load_eight(down + i + 1);
        Doubles sum = along + (over + under);
        if (b) sum = load_eight(b + row + i) - sum;
        std::memcpy(out + row + i, &sum, sizeof sum);
      }
      for (; i < n; ++i) finish(j, i);
    }
  }

 private:
  [[gnu::always_inline]] void finish(int j, int i) const {
    std::size_t const k = m.at(i, j);
    double const sum = m.product(x, i, j);
    out[k] = b ? b[k] - sum : sum;
  }
};

}  // namespace

void NinePointMatrix::product(double const* x, double* out) const { residual(nullptr, x, out); }

void NinePointMatrix::residual(double const* b, double const* x, double* out) const {
  std::vector<double> const zero(static_cast<std::size_t>(cells[0]) + 8);
  Product product{*this, b, x, out, zero};
  run_with(best_registers(), product);
}

}  // namespace actio::media
