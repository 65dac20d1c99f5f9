// The laws, run over the groups of the library: in double, and over numbers whose arithmetic is chosen when
// the program runs. The groups come in parts, so that no unit takes long to compile.
#pragma once

#include <boost/test/unit_test.hpp>

#include "actio/groups/affine_line.hpp"
#include "actio/groups/linear_groups.hpp"
#include "actio/groups/motions.hpp"
#include "actio/groups/spanned_group.hpp"
#include "actio/groups/unipotent_groups.hpp"
#include "actio/groups/unit_quaternions.hpp"
#include "group_laws.hpp"
#include "witness/number.hpp"

namespace actio::laws {

// Compiled once for each scalar, in test_laws_of_any_group_*.cpp.
extern template std::vector<Finding> check_any<double>(AnyGroup<double> const&, std::uint64_t,
                                                       std::vector<Edge<double>> const&);
extern template std::vector<Finding> check_any<Number>(AnyGroup<Number> const&, std::uint64_t,
                                                       std::vector<Edge<Number>> const&);

inline constexpr std::uint64_t seed = 20240131;

/// Runs laws over Number: exactly over the rationals, and in 50 and 100 digits.
template <class Run>
void in_each_arithmetic(Run const& run) {
  for (Arithmetic const& arithmetic :
       {Arithmetic::rationals(), Arithmetic::decimal(50), Arithmetic::decimal(100)}) {
    WithArithmetic const in_force(arithmetic);
    BOOST_TEST_CONTEXT(arithmetic.name()) run();
  }
}

template <Scalar S, Group G>
void hold(std::string const& name, G const& group, std::vector<Edge<S>> const& edges = {}) {
  Finding worst;
  for (Finding const& f : check<S>(group, seed, edges)) {
    BOOST_TEST(f.holds(), name << ": " << f.text());
    if (!(f.measured * std::max(1.0, worst.allowed) <= worst.measured * std::max(1.0, f.allowed))) worst = f;
  }
  BOOST_TEST_MESSAGE(name << ", worst: "
                          << (worst.law.empty() ? "every residual is exactly zero" : worst.text()));
}

/// Coordinates from fractions with the denominator 7, the first shifted by `first`.
template <class G, class S>
Coordinates<G, S> coordinates(S const& first, std::initializer_list<int> sevenths) {
  Coordinates<G, S> v(static_cast<Index>(sevenths.size()));
  int i = 0;
  for (int k : sevenths) v[i++] = ratio<S>(k, 7);
  v[0] += first;
  return v;
}
/// pi - 10^-8
template <Real S>
S nearly_pi() {
  using std::acos;
  return S(acos(S(-1))) - ratio<S>(1, 100000000);
}
/// A vector of 3-space with the given length, along (2, -3, 6)/7.
template <Real S>
Matrix<S, 3, 1> turning(S const& length) {
  return Matrix<S, 3, 1>(ratio<S>(2, 7), ratio<S>(-3, 7), ratio<S>(6, 7)) * length;
}
inline SpannedGroup spanned_motions() {
  std::vector<SpannedGroup::WholeMatrix> basis;
  for (int a = 0; a < 6; ++a) basis.push_back(SE<3>::hat(Matrix<int, 6, 1>::Unit(a)));
  return SpannedGroup("SE(3) from its span", basis);
}

/// R^3, SO(2), SE(2).
template <Scalar S>
void laws_in_the_plane() {
  std::vector<Edge<S>> translations, turns, motions;
  if (!exact_arithmetic<S>()) {
    S const a = nearly_pi<S>();
    translations.push_back({coordinates<Translations<3>, S>(S(1000), {1, 2, 3})});
    turns.push_back({Coordinates<SO<2>, S>(a)});
    turns.push_back({Coordinates<SO<2>, S>(-a)});
    motions.push_back({coordinates<SE<2>, S>(a, {0, 5, -4})});
  }
  hold<S>("R^3", Translations<3>{}, translations);
  hold<S>("SO(2)", SO<2>{}, turns);
  hold<S>("SE(2)", SE<2>{}, motions);
}

/// SO(3), SU(2), SE(3).
template <Scalar S>
void laws_in_space() {
  std::vector<Edge<S>> rotations, quaternions, motions;
  if (!exact_arithmetic<S>()) {
    S const a = nearly_pi<S>();
    rotations.push_back({turning(a)});
    rotations.push_back({Coordinates<SO<3>, S>(S(0), a, S(0))});
    // Next to -1 every direction leads back to 1: the axis, a vector of length 10^-8, has its digits relative
    // to 1.
    quaternions.push_back({turning(S(2) * a), 1e8});
    Coordinates<SE<3>, S> v;
    v << turning(a), S(1), ratio<S>(2, 3), ratio<S>(-1, 3);
    motions.push_back({v});
  }
  hold<S>("SO(3)", SO<3>{}, rotations);
  hold<S>("SU(2)", SU2{}, quaternions);
  hold<S>("SE(3)", SE<3>{}, motions);
}

/// Heisenberg, Aff(1), SL(2), GL(2).
template <Scalar S>
void laws_of_small_matrices() {
  std::vector<Edge<S>> heisenberg, affine, special, general;
  if (!exact_arithmetic<S>()) {
    heisenberg.push_back({coordinates<Heisenberg, S>(S(10), {5, -9, 20})});
    affine.push_back({coordinates<Aff1, S>(S(3), {0, 5})});
    affine.push_back({coordinates<Aff1, S>(S(-3), {0, 5})});
    // Turns by 3: the logarithm of general matrices takes square roots, and each cancels as the eigenvalue
    // comes near to -1.
    special.push_back({coordinates<SL2, S>(S(0), {0, 21, -21}), 100});
    general.push_back({coordinates<GL<2>, S>(S(0), {1, 21, -21, 1}), 100});
  }
  hold<S>("Heisenberg", Heisenberg{}, heisenberg);
  hold<S>("Aff(1)", Aff1{}, affine);
  hold<S>("SL(2)", SL2{}, special);
  hold<S>("GL(2)", GL<2>{}, general);
}

/// One angle next to pi, another 1, in planes that are not those of the coordinates.
template <Scalar S, Group G>
std::vector<Edge<S>> nearly_half_a_turn(G const& group) {
  if constexpr (Real<S>) {
    if (exact_arithmetic<S>()) return {};
    Draw draw(seed);
    auto const frame = exp(draw.velocity<S>(group, S(2)));
    Coordinates<G, S> v = Coordinates<G, S>::Zero();
    v[0] = nearly_pi<S>(), v[G::dim - 1] = S(1);
    return {{Ad(frame, Velocity<G, S>{group, v}).coordinates}};
  } else {
    return {};
  }
}
/// SO(4), GL(3).
template <Scalar S>
void laws_of_larger_matrices() {
  hold<S>("SO(4)", SO<4>{}, nearly_half_a_turn<S>(SO<4>{}));
  hold<S>("GL(3)", GL<3>{});
}
/// SO(5), by itself because its logarithm takes long to compile.
template <Scalar S>
void laws_in_five_dimensions() { hold<S>("SO(5)", SO<5>{}, nearly_half_a_turn<S>(SO<5>{})); }
/// SE(3) from its span.
template <Scalar S>
void laws_of_a_span() { hold<S>("SE(3) from its span", spanned_motions()); }

}  // namespace actio::laws
