// In a unit of its own
#include "actio/rods/rod_sweeps.hpp"

#include "actio/rods/rod_shape.hpp"
#include "actio/rods/row_packs.hpp"

namespace actio::rods {
namespace {

template <int W, bool given>
struct Elements {
  RodConstants const& rod;
  RodState const& state;
  Rows<3> const& N;
  RodForces& out;
  Range range;
  bool result;

  [[gnu::always_inline]] void operator()() {
    using T = Pack<W>;
    auto const stretching = everywhere<W>(rod.section.stretching),
               bending = everywhere<W>(rod.section.bending);
    for (std::size_t k = range.begin; k < range.end; k += W) {
      auto const e = placement<W>(state, k);
      T const inverse = load<W>(rod.inverse_length, k);
      ElementAtRest<T> const rest{inverse, load<W>(rod.Gamma, k), load<W>(rod.kappa, k)};
      ElementStrain<T> const strain = element_strain(e, rest);
      Three<T> stress;
      if constexpr (given)
        stress = load<W>(N, k);
      else
        stress = times(stretching, strain.Gamma);
      ElementForce<T> const force = element_force(e, stress, times(bending, strain.kappa));
      store<W>(out.f, first_element + k, turned(load<W>(state.q, k), force.n));
      store<W>(out.first, first_element + k, force.first);
      store<W>(out.second, first_element + k, force.second);
      // What is no number is not within the bound.
      result = result && bodies::dot(e.w, e.w) <= T(largest_turn * largest_turn);
    }
  }
};

template <int W>
struct Sections {
  RodConstants const& rod;
  RodForces const& forces;
  double kick, step;
  RodState const& from;
  RodState& to;
  Range range;
  bool result;

  [[gnu::always_inline]] void operator()() {
    using T = Pack<W>;
    auto const& I = rod.section.inertia;
    double const unit = I[0];
    bodies::InverseMoments<double> const of_length({1.0, I[1] / unit, I[2] / unit});
    bodies::InverseMoments<T> body;
    set_all_lanes(body, of_length);
    T const h(step), length_of_kick(kick), half(step / 2 / unit), over_mass(kick / rod.section.mass);
    auto const g = everywhere<W>(times(kick, rod.acceleration));
    for (std::size_t k = range.begin; k < range.end; k += W) {
      std::size_t const here = first_element + k;
      T const inverse = load<W>(rod.inverse_share, k);
      Three<T> const f = load<W>(forces.f, here), before = load<W>(forces.f, here - 1);
      Three<T> v = load<W>(from.v, k);
      T const by = inverse * over_mass;
      for (std::size_t i = 0; i < 3; ++i) v[i] = v[i] + (by * (f[i] - before[i]) + g[i]);
      store<W>(to.v, k, v);
      store<W>(to.x, k, plus_times(load<W>(from.x, k), h, v));

      Three<T> const first = load<W>(forces.first, here), second = load<W>(forces.second, here - 1);
      Three<T> M = load<W>(from.M, k);
      for (std::size_t i = 0; i < 3; ++i) M[i] = M[i] + length_of_kick * (first[i] - second[i]);
      auto const e = bodies::moser_veselov_turn(body, times(half * inverse, M));
      result = result && e.found;
      store<W>(to.M, k, bodies::turned_back(e.turn, M));
      Four<T> const q = bodies::compose(load<W>(from.q, k), e.turn);
      T const scale = 1.5 - 0.5 * (q[0] * q[0] + q[1] * q[1] + (q[2] * q[2] + q[3] * q[3]));
      store<W>(to.q, k, Four<T>{scale * q[0], scale * q[1], scale * q[2], scale * q[3]});
    }
  }
};

template <int W>
struct Stretches {
  RodConstants const& rod;
  RodState const& state;
  Rows<3>& out;
  Range range;
  double result;

  [[gnu::always_inline]] void operator()() {
    using T = Pack<W>;
    T most(0.0);
    for (std::size_t k = range.begin; k < range.end; k += W) {
      Three<T> const stretch = placement<W>(state, k).stretch(), rest = load<W>(rod.Gamma, k);
      T const length = 1.0 / load<W>(rod.inverse_length, k);
      Three<T> excess;
      for (std::size_t i = 0; i < 3; ++i) {
        excess[i] = stretch[i] - rest[i] * length;
        T const size = magnitude(excess[i]);
        most = T(size.lane <= most.lane ? most.lane : size.lane);
      }
      store<W>(out, k, excess);
    }
    for (int i = 0; i < W; ++i)
      if (!(most.lane[i] <= result)) result = most.lane[i];
  }
};

}  // namespace

bool sweep_elements(Registers registers, RodConstants const& rod, RodState const& state, RodForces& out,
                    Range elements) {
  return run_sweep(registers,
                   [&]<int W>() { return Elements<W, false>{rod, state, state.N, out, elements, true}; });
}
bool sweep_elements_with(Registers registers, RodConstants const& rod, RodState const& state,
                         Rows<3> const& N, RodForces& out, Range elements) {
  return run_sweep(registers, [&]<int W>() { return Elements<W, true>{rod, state, N, out, elements, true}; });
}
bool sweep_sections(Registers registers, RodConstants const& rod, RodForces const& forces, double kick,
                    double step, RodState const& from, RodState& to, Range sections) {
  return run_sweep(registers,
                   [&]<int W>() { return Sections<W>{rod, forces, kick, step, from, to, sections, true}; });
}
double sweep_stretches(Registers registers, RodConstants const& rod, RodState const& state, Rows<3>& out,
                       Range elements) {
  return run_sweep(registers, [&]<int W>() { return Stretches<W>{rod, state, out, elements, 0.0}; });
}

}  // namespace actio::rods
