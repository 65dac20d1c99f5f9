#include "actio/fast_media/fast_strains.hpp"

#include <algorithm>

namespace actio::media::detail {
namespace {

/// Vectors with \f$e_k\cdot c_l=\delta_{kl}D\f$; D is the determinant of the edges.
[[gnu::always_inline]] inline Quad cofactors(Plane<Quad> const (&e)[2], Plane<Quad> (&c)[2]) {
  c[0] = {e[1].y, -e[1].x}, c[1] = {-e[0].y, e[0].x};
  return dot(e[0], c[0]);
}
[[gnu::always_inline]] inline Quad cofactors(Space<Quad> const (&e)[3], Space<Quad> (&c)[3]) {
  c[0] = cross(e[1], e[2]), c[1] = cross(e[2], e[0]), c[2] = cross(e[0], e[1]);
  return dot(e[0], c[0]);
}
[[gnu::always_inline]] inline void raise(Quad& most, Quad::Bits const& there, Quad const& x) {
  most = chosen(there & (x.lane > most.lane), x, most);
}
inline double largest(Quad const& x) { return std::max({x.lane[0], x.lane[1], x.lane[2], x.lane[3]}); }

template <int d, class Vector>
struct StrainSweep {
  RowsOfCells<Vector> const& rows;
  Strips const& strips;
  std::array<double, d> const& spacing;
  alignas(32) Quad squeeze{0.0}, stretch{0.0}, rate{0.0};
  static constexpr int corners = 1 << d;

  [[gnu::always_inline]] void operator()() {
    Quad most[3] = {Quad(0), Quad(0), Quad(0)};
    for (int layer = 0; layer < rows.layers; ++layer)
      for (int j = 0; j + 1 < rows.across; ++j) cell_row(layer * rows.across + j, most);
    squeeze = most[0], stretch = most[1], rate = most[2];
  }

 private:
  [[gnu::always_inline]] void cell_row(int first, Quad (&most)[3]) const {
    Quad::Bits const all = ~Quad::Bits{};
    for (int s = 0; s < strips.packs; ++s) {
      Vector x[corners], v[corners];
      put(rows.x, first, s, x), put(rows.v, first, s, v);
      cell(x, v, s < strips.full ? all : strips.there[s - strips.full], most);
    }
  }
  /// The corners of the cells at register s.
  [[gnu::always_inline]] void put(Vector const* const* from, int first, int s, Vector (&out)[corners]) const {
    for (int r = 0; r < corners / 2; ++r) {
      Vector const* const row = from[first + (r & 1) + (r >> 1) * rows.across];
      out[2 * r] = row[s];
      out[2 * r + 1] = s + 1 < strips.packs ? row[s + 1] : turned(row[0]);
    }
  }
  [[gnu::always_inline]] static Plane<Quad> turned(Plane<Quad> const& a) {
    return {turned_down(a.x), turned_down(a.y)};
  }
  [[gnu::always_inline]] static Space<Quad> turned(Space<Quad> const& a) {
    return {turned_down(a.x), turned_down(a.y), turned_down(a.z)};
  }
  /// The edges that meet at a corner.
  [[gnu::always_inline]] static void edges(Vector const (&x)[corners], int corner, Vector (&e)[d]) {
    for (int k = 0; k < d; ++k) e[k] = x[corner | 1 << k] - x[corner & ~(1 << k)];
  }
  [[gnu::always_inline]] void cell(Vector const (&x)[corners], Vector const (&v)[corners],
                                   Quad::Bits const& there, Quad (&most)[3]) const {
    Vector e[d], c[d];
    for (int p = 0; p < corners; ++p) {
      edges(x, p, e);
      Quad const D = cofactors(e, c), over = Quad(1) / (D * D);
      Quad back(0), forth(0);
      for (int k = 0; k < d; ++k) {
        double const h = spacing[static_cast<std::size_t>(k)];
        back += Quad(h * h) * dot(c[k], c[k]), forth += Quad(1 / (h * h)) * dot(e[k], e[k]);
      }
      raise(most[0], there, back * over), raise(most[1], there, forth);
      if (p > 0) continue;
      // The velocity gradient is the sum of g_k c_k over the determinant, g_k the edges of the velocities.
      Vector g[d];
      edges(v, 0, g);
      Quad twice(0);
      for (int k = 0; k < d; ++k)
        for (int l = 0; l < d; ++l)
          twice += dot(g[k], g[l]) * dot(c[k], c[l]) + dot(g[k], c[l]) * dot(g[l], c[k]);
      raise(most[2], there, Quad(0.5) * twice * over);
    }
  }
};

template <int d, class Vector>
Strains swept(RowsOfCells<Vector> const& rows, Strips const& strips, std::array<double, d> const& spacing,
              Registers registers) {
  StrainSweep<d, Vector> sweep{rows, strips, spacing};
  run_with(registers, sweep);
  return {largest(sweep.squeeze), largest(sweep.stretch), largest(sweep.rate)};
}

}  // namespace

Strains strains_of(RowsOfCells<Plane<Quad>> const& rows, Strips const& strips,
                   std::array<double, 2> const& spacing, Registers registers) {
  return swept<2>(rows, strips, spacing, registers);
}
Strains strains_of(RowsOfCells<Space<Quad>> const& rows, Strips const& strips,
                   std::array<double, 3> const& spacing, Registers registers) {
  return swept<3>(rows, strips, spacing, registers);
}

}  // namespace actio::media::detail
