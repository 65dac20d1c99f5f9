// Four free bodies in the lanes of a SIMD register (pack.hpp), and the loop that steps them.
//
// The half turn of half_turn.hpp acts on more than the direction u of the momentum. Let w be a unit vector at
// right angles to u. The half turn about v takes it to minus
//
//     w' = w - 2 (w.v)/(v.v) v,
//
// and the motion is this followed by a rotation by 2T a step about the momentum, the same in all steps, and
// about an axis that stands still in space: by 2nT after n steps, which is computed when the attitude is
// asked for. So a step has six numbers, one division and no root; the attitude comes from u, w and nT when it
// is read.
//
// The axis is the null vector of diag(delta) + [u]x, and there is one only on the orbit that the delta belong
// to. Once rounding has moved u beside it, a long step with the formula for the null vector may double the
// distance, and the next one again. The eigenvector of the small eigenvalue mu, that is the same formula with
// delta - mu, makes a map whose inverse is the one with -delta, and stays where it is. Long steps take it,
// with one step of Newton's for mu, and are set back on the orbit each time.
#pragma once

#include <algorithm>
#include <utility>

#include "actio/fast_body/pack.hpp"
#include "actio/fast_body/space/short_flow.hpp"

namespace actio::bodies::detail {

/// Four free bodies.
struct FreeLanes {
  using Lanes = Pack<4>;
  Three<Lanes> u;        ///< direction of the momentum
  Three<Lanes> w;        ///< at right angles to it
  Three<Lanes> stretch;  ///< \f$1+\delta_j\delta_k\f$
  Three<Lanes> shear;    ///< \f$\delta_k-\delta_j\f$
  Three<Lanes> delta;    ///< \f$\delta_i\f$
  Three<Lanes> sum;      ///< \f$\delta_j+\delta_k\f$
  Lanes product;         ///< \f$\delta_1\delta_2\delta_3\f$
  /// \f$1/(1+\delta_1\delta_2+\delta_2\delta_3+\delta_3\delta_1)\f$, one over the slope of the determinant at
  /// its root
  Lanes newton;
  bool gentle = true;  ///< whether no \f$\delta_i\f$ is larger than 1
};

/// Steps of `packs` times four bodies, which the machine works on at the same time.
template <int packs, bool attitude, bool gentle>
struct LaneSteps {
  using Lanes = Pack<4>;
  FreeLanes* lanes;
  long from, count;

  /// \f$u' = 2(u.v)/(v.v)\,v-u\f$. The gaps \f$\delta_k-\delta_j\f$ have the sum 0, so that u.v needs no v.
  ///
  /// In gentle steps what is added to u: since \f$u\times v = -(\delta_iv_i)\f$, it is
  /// \f$2(u\times v)\times v/(v.v)\f$, small, and so is its rounding. Where a \f$\delta_i\f$ is large this
  /// would magnify the rounding of v.
  [[gnu::always_inline]] static void step(FreeLanes const& c, Three<Lanes>& u, Three<Lanes>& w) {
    // [batch_half_turn]
    Lanes s0 = c.stretch[0] * u[0], s1 = c.stretch[1] * u[1], s2 = c.stretch[2] * u[2];
    if constexpr (!gentle) {
      Lanes const mu = beside_orbit(c, u) * c.newton;
      s0 -= mu * (c.sum[0] * u[0]), s1 -= mu * (c.sum[1] * u[1]), s2 -= mu * (c.sum[2] * u[2]);
    }
    Lanes const v0 = s0 + c.shear[0] * (u[1] * u[2]), v1 = s1 + c.shear[1] * (u[2] * u[0]),
                v2 = s2 + c.shear[2] * (u[0] * u[1]);
    Lanes const vv = (v0 * v0 + v1 * v1) + v2 * v2, twice = 2.0 / vv;
    if constexpr (attitude) {
      Lanes const across = twice * (w[0] * v0 + w[1] * v1 + w[2] * v2);
      w = {w[0] - across * v0, w[1] - across * v1, w[2] - across * v2};
    }
    if constexpr (gentle) {
      Lanes const g0 = c.delta[0] * v0, g1 = c.delta[1] * v1, g2 = c.delta[2] * v2;
      u = {u[0] - twice * (g1 * v2 - g2 * v1), u[1] - twice * (g2 * v0 - g0 * v2),
           u[2] - twice * (g0 * v1 - g1 * v0)};
    } else {
      Lanes const along = twice * (s0 * u[0] + s1 * u[1] + s2 * u[2]);
      u = {along * v0 - u[0], along * v1 - u[1], along * v2 - u[2]};
    }
    // [batch_half_turn]
  }
  /// \f$\det(\mathrm{diag}(\delta)+[u]_\times) = \delta_1\delta_2\delta_3+\sum\delta_iu_i^2\f$: zero on the
  /// orbit, for the \f$\delta_i\f$ are linear in the \f$1/I_i\f$.
  [[gnu::always_inline]] static Lanes beside_orbit(FreeLanes const& c, Three<Lanes> const& u) {
    return c.product + (c.delta[0] * u[0] * u[0] + c.delta[1] * u[1] * u[1] + c.delta[2] * u[2] * u[2]);
  }
  /// To length 1 and a right angle again, without a root, for both are nearly so; after long steps back on
  /// the orbit too, along the gradient of what is zero there.
  [[gnu::always_inline]] static void tidy(FreeLanes const& c, Three<Lanes>& u, Three<Lanes>& w) {
    Lanes const shorter = 1.5 - 0.5 * dot(u, u);
    u = {u[0] * shorter, u[1] * shorter, u[2] * shorter};
    if constexpr (!gentle) {
      Three<Lanes> g{c.delta[0] * u[0], c.delta[1] * u[1], c.delta[2] * u[2]};
      Lanes const radial = dot(u, g);
      g = {g[0] - radial * u[0], g[1] - radial * u[1], g[2] - radial * u[2]};
      // Next to a turn about an axis there is no way along it, and none is needed.
      Lanes const size = dot(g, g),
                  way = -0.5 * beside_orbit(c, u) * size /
                        (size * size + 1e-12 * (radial * radial) * (radial * radial) + 1e-290);
      u = {u[0] + way * g[0], u[1] + way * g[1], u[2] + way * g[2]};
    }
    if constexpr (attitude) {
      Lanes const beside = dot(u, w), longer = 1.5 - 0.5 * dot(w, w);
      for (int i = 0; i < 3; ++i) w[i] = longer * (w[i] - beside * u[i]);
    }
  }
  /// The packs one after another in one body of the loop, so that each can stay in registers.
  template <std::size_t... k>
  [[gnu::always_inline]] void run(std::index_sequence<k...>) const {
    // counted from the start of the batch: how its steps are spread over calls makes no difference
    long const between = gentle ? 1024 : 1;
    Three<Lanes> u[packs] = {lanes[k].u...}, w[packs] = {lanes[k].w...};
    for (long done = 0; done < count;) {
      long const row = std::min(count - done, between - (from + done) % between);
      for (long n = 0; n < row; ++n) (step(lanes[k], u[k], w[k]), ...);
      done += row;
      if ((from + done) % between == 0) (tidy(lanes[k], u[k], w[k]), ...);
    }
    ((lanes[k].u = u[k], lanes[k].w = w[k]), ...);
  }
  [[gnu::always_inline]] void operator()() const { run(std::make_index_sequence<packs>()); }
};

}  // namespace actio::bodies::detail
