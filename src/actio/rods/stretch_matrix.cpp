// In a unit of its own
#include "actio/rods/stretch_matrix.hpp"

#include "actio/rods/row_packs.hpp"

namespace actio::rods {
namespace {

template <class T>
[[gnu::always_inline]] inline Block<T> product(Block<T> const& a, Block<T> const& b) {
  Block<T> out;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) out[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  return out;
}
/// a diag(d) b^T
template <class T>
[[gnu::always_inline]] inline Block<T> product(Block<T> const& a, Three<T> const& d, Block<T> const& b) {
  Block<T> out;
  for (std::size_t i = 0; i < 3; ++i) {
    Three<T> const row = times(a[i], d);
    for (std::size_t j = 0; j < 3; ++j) out[i][j] = bodies::dot(row, b[j]);
  }
  return out;
}
/// c + v x, as a matrix.
template <class T>
[[gnu::always_inline]] inline Block<T> cross_matrix(T const& c, Three<T> const& v) {
  return {Three<T>{c, -v[2], v[1]}, Three<T>{v[2], c, -v[0]}, Three<T>{-v[1], v[0], c}};
}
/// Of a symmetric positive definite block.
/// @return  whether it is
bool invert(Block<double> const& a, Block<double>& out) {
  double const c0 = a[1][1] * a[2][2] - a[1][2] * a[1][2], c1 = a[0][2] * a[1][2] - a[0][1] * a[2][2],
               c2 = a[0][1] * a[1][2] - a[0][2] * a[1][1], minor = a[0][0] * a[1][1] - a[0][1] * a[0][1],
               det = a[0][0] * c0 + a[0][1] * c1 + a[0][2] * c2, d = 1 / det,
               c4 = (a[0][1] * a[0][2] - a[0][0] * a[1][2]) * d;
  out = {Three<double>{c0 * d, c1 * d, c2 * d},
         {c1 * d, (a[0][0] * a[2][2] - a[0][2] * a[0][2]) * d, c4},
         {c2 * d, c4, minor * d}};
  return a[0][0] > 0 && minor > 0 && det > 0;
}
Three<double> applied(Block<double> const& a, Three<double> const& v) {
  return {bodies::dot(a[0], v), bodies::dot(a[1], v), bodies::dot(a[2], v)};
}
Three<double> applied_transposed(Block<double> const& a, Three<double> const& v) {
  return plus_times(plus_times(times(v[0], a[0]), v[1], a[1]), v[2], a[2]);
}

/// How the stretch of an element changes with its sections: by their places and by turns in their axes. With
/// d eps = u_1 - u_0 + eps x theta_0 in the axes of the first section, dw = T(w) theta_1 - T(-w) theta_0, it
/// is (1 - w x/2) d eps + eps x dw/2.
template <class T>
struct StretchDifferential {
  Block<T> shift,  ///< by u_1, and less it by u_0
      first,       ///< by theta_0
      second;      ///< by theta_1

  [[gnu::always_inline]] explicit StretchDifferential(RelativePlacement<T> const& e)
      : shift(cross_matrix(T(1.0), times(T(-0.5), e.w))) {
    Block<T> const lever = cross_matrix(T(0.0), e.eps), half = cross_matrix(T(0.0), times(T(0.5), e.eps));
    Block<T> forth, back;
    for (std::size_t i = 0; i < 3; ++i) {
      Three<T> axis{T(0.0), T(0.0), T(0.0)};
      axis[i] = T(1.0);
      // Rows of T(w) and of T(-w), whose transposes are each other.
      back[i] = cayley_differential(e.w, axis);
      forth[i] = cayley_differential(times(T(-1.0), e.w), axis);
    }
    second = product(half, forth), first = product(shift, lever);
    Block<T> const turn = product(half, back);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) first[i][j] = first[i][j] - turn[i][j];
  }
};

/// The blocks of S.
template <int W>
struct Blocks {
  RodConstants const& rod;
  RodState const& state;
  std::vector<double> const& over_mass;
  double factor;
  Rows<6>& diagonal;
  Rows<9>& below;
  bool result;

  [[gnu::always_inline]] void operator()() {
    using T = Pack<W>;
    auto const& I = rod.section.inertia;
    auto const over = everywhere<W>({factor / I[0], factor / I[1], factor / I[2]});
    T const by(factor);
    for (std::size_t k = 0; k < rod.elements; k += W) {
      auto const e = placement<W>(state, k);
      StretchDifferential<T> const here(e), next(placement<W>(state, k + 1));
      T const mass = by * load<W>(over_mass, k), next_mass = by * load<W>(over_mass, k + 1),
              both = mass + next_mass;
      Three<T> const turn = times(load<W>(rod.inverse_share, k), over),
                     next_turn = times(load<W>(rod.inverse_share, k + 1), over);
      Block<T> const places = product(here.shift, Three<T>{both, both, both}, here.shift),
                     turns = product(here.first, turn, here.first),
                     next_turns = product(here.second, next_turn, here.second);
      std::size_t at = 0;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = i; j < 3; ++j, ++at)
          store<W>(diagonal[at], k, places[i][j] + (turns[i][j] + next_turns[i][j]));
      // The section between sees the shifts of the element before in the axes of that: E, by columns.
      Block<T> rotation;
      Four<T> const q = bodies::compose(inverse_turn(load<W>(state.q, k)), load<W>(state.q, k + 1));
      for (std::size_t i = 0; i < 3; ++i) {
        Three<T> axis{T(0.0), T(0.0), T(0.0)};
        axis[i] = T(1.0);
        auto const column = turned(q, axis);
        for (std::size_t j = 0; j < 3; ++j) rotation[j][i] = column[j];
      }
      T const less = -next_mass;
      Block<T> const shifts = product(next.shift, Three<T>{less, less, less}, product(here.shift, rotation)),
                     between = product(next.first, next_turn, here.second);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) store<W>(below[3 * i + j], k, shifts[i][j] + between[i][j]);
    }
  }
};

}  // namespace

StretchMatrix::StretchMatrix(RodConstants const& rod, std::array<bool, 2> const& held_places)
    : over_mass_(rod.inverse_share), inverse_(rod.elements), lower_(rod.elements) {
  std::size_t const size = rod.inverse_share.size();
  diagonal_ = zero_rows<6>(size), below_ = zero_rows<9>(size);
  for (double& one : over_mass_) one /= rod.section.mass;
  if (held_places[0]) over_mass_.front() = 0;
  if (held_places[1]) over_mass_[rod.elements] = 0;
}

bool StretchMatrix::factor(Registers registers, RodConstants const& rod, RodState const& state,
                           double factor) {
  run_sweep(registers,
            [&]<int W>() { return Blocks<W>{rod, state, over_mass_, factor, diagonal_, below_, true}; });
  for (std::size_t k = 0; k < rod.elements; ++k) {
    auto const d = vector_at(diagonal_, k);
    Block<double> pivot{Three<double>{d[0], d[1], d[2]}, {d[1], d[3], d[4]}, {d[2], d[4], d[5]}};
    if (k > 0) {
      auto const b = vector_at(below_, k - 1);
      Block<double> const off{Three<double>{b[0], b[1], b[2]}, {b[3], b[4], b[5]}, {b[6], b[7], b[8]}};
      lower_[k - 1] = product(off, inverse_[k - 1]);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = i; j < 3; ++j) pivot[i][j] -= bodies::dot(lower_[k - 1][i], off[j]);
    }
    if (!invert(pivot, inverse_[k])) return false;
  }
  return true;
}

void StretchMatrix::correct(Rows<3>& r, Rows<3>& N) const {
  std::size_t const elements = inverse_.size();
  Three<double> before = vector_at(r, 0);
  for (std::size_t k = 1; k < elements; ++k) {
    before = plus_times(vector_at(r, k), -1.0, applied(lower_[k - 1], before));
    put_vector(r, k, before);
  }
  Three<double> after{};
  for (std::size_t k = elements; k-- > 0;) {
    after = plus_times(applied(inverse_[k], vector_at(r, k)), -1.0, applied_transposed(lower_[k], after));
    for (std::size_t i = 0; i < 3; ++i) N[i][k] += after[i];
  }
}

}  // namespace actio::rods
