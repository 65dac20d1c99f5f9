// Sequences of configurations and of relative motions, their variations, and motions of more than one step:
// for the checks of section 3.2.
#pragma once

#include <utility>
#include <vector>

#include "actio/reduction/relative_motion.hpp"
#include "models/models.hpp"

namespace actio::checks {

template <class S>
using GroupElement = Element<SpannedGroup, S>;
template <class S>
using GroupElements = std::vector<GroupElement<S>>;

/// Groups for checks of several steps: over the rationals four of them, since numbers grow long with each
/// step.
template <class S>
std::vector<SpannedGroup> const& groups_for_sequences() {
  return numbers_grow() ? few_groups() : all_groups();
}

/// The groups of the commuting squares and brackets of chapter 4: SO(3), SO(4), SE(3), Aff(1), SU(2), GL(3).
/// Over the rationals, where the inverse of a matrix of many rows is long, GL(2) stands for GL(3) and SO(4)
/// is left to the other scalars.
template <class S>
std::vector<SpannedGroup> const& groups_for_squares() {
  static std::vector<SpannedGroup> const all = {spanned("SO(3)", SO<3>{}), spanned("SE(3)", SE<3>{}),
                                                spanned("Aff(1)", Aff1{}), spanned_su2(),
                                                spanned("SO(4)", SO<4>{}), spanned("GL(3)", GL<3>{})};
  static std::vector<SpannedGroup> const short_ones = {all[0], all[1], all[2], all[3],
                                                       spanned("GL(2)", GL<2>{})};
  return numbers_grow() ? short_ones : all;
}

/// `count` configurations, or relative motions, at random.
template <class S>
GroupElements<S> draw_configurations(Draw& draw, SpannedGroup const& group, int count,
                                     S const& size = ratio<S>(1, 2)) {
  GroupElements<S> configurations;
  for (int k = 0; k < count; ++k) configurations.push_back(draw.element<S>(group, size));
  return configurations;
}
/// One velocity for each configuration: how it varies, \f$\vartheta_k = \delta g_k g_k^{-1}\f$ or
/// \f$g_k^{-1}\delta g_k\f$. Nothing varies at the ends.
template <class S>
std::vector<Velocity<SpannedGroup, S>> draw_variations(Draw& draw, SpannedGroup const& group, int count) {
  std::vector<Velocity<SpannedGroup, S>> theta;
  for (int k = 0; k < count; ++k)
    theta.push_back(draw.velocity<S>(group, k == 0 || k == count - 1 ? S(0) : S(1)));
  return theta;
}

/// The curve \f$g + \epsilon\,\delta g\f$, to first order; `change` is a matrix.
template <class S>
GroupElement<Dual<S>> varied(GroupElement<S> const& g, Matrix<S> const& change) {
  Matrix<Dual<S>> value = g.value.template cast<Dual<S>>();
  for (Index i = 0; i < value.rows(); ++i)
    for (Index j = 0; j < value.cols(); ++j) value(i, j).part[0] = change(i, j);
  return {g.group, value};
}
/// The matrices of \f$\vartheta\f$, of \f$\vartheta g\f$ and of \f$g\vartheta\f$.
template <class S>
Matrix<S> matrix_of(Velocity<SpannedGroup, S> const& theta) { return theta.group.hat(theta.coordinates); }
template <class S>
Matrix<S> from_left(Velocity<SpannedGroup, S> const& theta, GroupElement<S> const& g) {
  return matrix_of(theta) * g.value;
}
template <class S>
Matrix<S> from_right(GroupElement<S> const& g, Velocity<SpannedGroup, S> const& theta) {
  return g.value * matrix_of(theta);
}
/// What \f$\epsilon\f$ multiplies.
template <class S>
Matrix<S> rate(GroupElement<Dual<S>> const& g) {
  Matrix<S> m(g.value.rows(), g.value.cols());
  for (Index i = 0; i < m.rows(); ++i)
    for (Index j = 0; j < m.cols(); ++j) m(i, j) = g.value(i, j).part[0];
  return m;
}
/// \f$l'(f)\cdot v\f$ for a tangent vector given as a matrix: the definition, with no translation in it.
template <class S, class F>
S slope(F const& l, GroupElement<S> const& f, Matrix<S> const& v) { return l(varied(f, v)).part[0]; }

/// The relative motions of a sequence of configurations, \f$g_kg_{k+1}^{-1}\f$, each found from
/// \f$f\,g_{k+1} = g_k\f$ by elimination.
template <class S>
GroupElements<S> relative_motions_right(GroupElements<S> const& g) {
  GroupElements<S> f;
  for (std::size_t k = 0; k + 1 < g.size(); ++k) {
    Matrix<S> const transposed =
        solve_linear(g[k + 1].value.transpose().eval(), g[k].value.transpose().eval(), "f g1 = g0");
    f.push_back({g[k].group, transposed.transpose()});
  }
  return f;
}
/// \f$g_{k+1}^{-1}g_k\f$, found from \f$g_{k+1}f = g_k\f$.
template <class S>
GroupElements<S> relative_motions_left(GroupElements<S> const& g) {
  GroupElements<S> f;
  for (std::size_t k = 0; k + 1 < g.size(); ++k)
    f.push_back({g[k].group, solve_linear(g[k + 1].value, g[k].value, "g1 f = g0")});
  return f;
}
/// Configurations from the first one and the relative motions, by \f$f\,g_{k+1} = g_k\f$ or
/// \f$g_{k+1}f = g_k\f$.
template <class S>
GroupElements<S> configurations_right(GroupElement<S> const& g0, GroupElements<S> const& f) {
  GroupElements<S> g{g0};
  for (auto const& step : f) g.push_back({g0.group, solve_linear(step.value, g.back().value, "f g1 = g0")});
  return g;
}
template <class S>
GroupElements<S> configurations_left(GroupElement<S> const& g0, GroupElements<S> const& f) {
  GroupElements<S> g{g0};
  for (auto const& step : f) {
    Matrix<S> const transposed =
        solve_linear(step.value.transpose().eval(), g.back().value.transpose().eval(), "g1 f = g0");
    g.push_back({g0.group, transposed.transpose()});
  }
  return g;
}

/// A function of pairs that depends on \f$g_0g_1^{-1}\f$ only, or on \f$g_1^{-1}g_0\f$ only, found by
/// elimination: not through the library's quotient. One type for both sides: such functions are
/// differentiated twice and thrice, and each type would be compiled on its own.
template <class F>
struct Lifted {
  enum class Side { right, left };
  F l;
  Side side;
  template <class T>
  T operator()(GroupElement<T> const& g0, GroupElement<T> const& g1) const {
    GroupElements<T> const g{g0, g1};
    return l((side == Side::right ? relative_motions_right(g) : relative_motions_left(g)).front());
  }
};
template <class F>
Lifted<F> lifted(F const& l) { return {l, Lifted<F>::Side::right}; }
template <class F>
Lifted<F> lifted_left(F const& l) { return {l, Lifted<F>::Side::left}; }
/// \f$\mathrm{Ad}^*_g\mu\f$ written out: the coefficients of \f$g e_a g^{-1}\f$ in the basis, by Gram's
/// system, weighted with mu.
template <class S>
Momentum<SpannedGroup, S> coadjoint(GroupElement<S> const& g, Momentum<SpannedGroup, S> const& mu) {
  int const d = g.group.dimension();
  Matrix<S> gram(d, d), products(d, d);
  auto const basis = [&](int a) { return matrix_of(basis_velocity<S>(g.group, a)); };
  for (int a = 0; a < d; ++a) {
    Matrix<S> const turned =
        solve_linear(g.value.transpose().eval(), (g.value * basis(a)).transpose().eval()).transpose();
    for (int b = 0; b < d; ++b)
      gram(b, a) = contract(basis(b), basis(a)), products(b, a) = contract(basis(b), turned);
  }
  return momentum(g.group, Vector<S>(solve_linear(gram, products).transpose() * mu.components));
}
/// Whether the basis of the algebra is orthonormal for an Ad-invariant metric: there a missing star makes no
/// difference.
inline bool has_invariant_metric(std::string const& model) {
  return model == "SO(3)" || model == "SO(4)" || model == "SU(2)";
}
/// A sum of reduced Lagrangians over a sequence.
template <class F, class S>
S reduced_sum(F const& l, GroupElements<S> const& f) {
  S sum(0);
  for (auto const& step : f) sum += l(step);
  return sum;
}

/// Five values of something that draws, a number or a column: one may be small by chance, five are not.
template <class Call>
auto several(Call const& call) {
  using Value = std::decay_t<decltype(call())>;
  if constexpr (Scalar<Value>) {
    Vector<Value> values(5);
    for (int i = 0; i < 5; ++i) values[i] = call();
    return values;
  } else {
    Value first = call();
    Matrix<typename Value::Scalar> values(first.rows(), 5 * first.cols());
    for (int i = 0; i < 5; ++i) values.middleCols(i * first.cols(), first.cols()) = i == 0 ? first : call();
    return values;
  }
}
/// A momentum or a velocity as a column.
template <class S>
Vector<S> column(Momentum<SpannedGroup, S> const& mu) { return mu.components; }
template <class S>
Vector<S> column(Velocity<SpannedGroup, S> const& xi) { return xi.coordinates; }
/// Matrices below each other.
template <class S>
Matrix<S> stacked(std::vector<GroupElement<S>> const& parts) {
  int const n = parts.front().group.matrix_size();
  Matrix<S> all(n * static_cast<int>(parts.size()), n);
  for (std::size_t k = 0; k < parts.size(); ++k) all.middleRows(static_cast<int>(k) * n, n) = parts[k].value;
  return all;
}
/// What epsilon multiplies in a momentum.
template <class S>
Vector<S> rate(Momentum<SpannedGroup, Dual<S>> const& mu) {
  Vector<S> v(mu.components.size());
  for (Index a = 0; a < v.size(); ++a) v[a] = mu.components[a].part[0];
  return v;
}
/// Several momenta below each other.
template <class S>
Vector<S> stacked(std::vector<Momentum<SpannedGroup, S>> const& parts) {
  int const d = parts.front().group.dimension();
  Vector<S> all(d * static_cast<int>(parts.size()));
  for (std::size_t k = 0; k < parts.size(); ++k)
    all.segment(static_cast<int>(k) * d, d) = parts[k].components;
  return all;
}

/// The residual of (3.10), written with matrices, at every inner configuration of a sequence of relative
/// motions.
template <class F, class S>
Vector<S> reduced_residual_right(F const& l, GroupElements<S> const& f) {
  auto const& group = f.front().group;
  int const d = group.dimension();
  Vector<S> all(d * (static_cast<int>(f.size()) - 1));
  for (std::size_t k = 1; k < f.size(); ++k)
    for (int a = 0; a < d; ++a) {
      auto const e = basis_velocity<S>(group, a);
      all[(static_cast<int>(k) - 1) * d + a] =
          slope(l, f[k], from_left(e, f[k])) - slope(l, f[k - 1], from_right(f[k - 1], e));
    }
  return all;
}
/// The same for (3.11).
template <class F, class S>
Vector<S> reduced_residual_left(F const& l, GroupElements<S> const& f) {
  auto const& group = f.front().group;
  int const d = group.dimension();
  Vector<S> all(d * (static_cast<int>(f.size()) - 1));
  for (std::size_t k = 1; k < f.size(); ++k)
    for (int a = 0; a < d; ++a) {
      auto const e = basis_velocity<S>(group, a);
      all[(static_cast<int>(k) - 1) * d + a] =
          slope(l, f[k], from_right(f[k], e)) - slope(l, f[k - 1], from_left(e, f[k - 1]));
    }
  return all;
}
/// Size of the momenta along a sequence.
template <class F, class S>
Base<S> momenta_of(F const& l, GroupElements<S> const& f) {
  Base<S> size(0);
  for (auto const& step : f)
    size += size_of(right_differential(l, step)) + size_of(left_differential(l, step));
  return size;
}

/// A reduced Lagrangian, with prescribed differentials if wanted: to `l` is added, for each k,
/// \f$\langle C_k, f-f_k\rangle\prod_{j\ne k}|f-f_j|^2/|f_k-f_j|^2\f$, which changes the differential at
/// \f$f_k\f$ and at no other \f$f_j\f$.
template <class S>
struct MotionPolynomial {
  GroupPolynomial<S> l;
  GroupElements<S> f;
  std::vector<Matrix<S>> c;

  template <class T>
  T operator()(GroupElement<T> const& at) const {
    T sum = l(at);
    for (std::size_t k = 0; k < c.size(); ++k) {
      T bump = contract(c[k], Matrix<T>(at.value - f[k].value.template cast<T>()));
      for (std::size_t j = 0; j < f.size(); ++j)
        if (j != k)
          bump *= square_of(Matrix<T>(at.value - f[j].value.template cast<T>())) /
                  square_of(Matrix<S>(f[k].value - f[j].value));
      sum += bump;
    }
    return sum;
  }

 private:
  template <class T>
  static T square_of(Matrix<T> const& m) {
    T sum(0);
    for (Index a = 0; a < m.size(); ++a) sum += m(a) * m(a);
    return sum;
  }
};
template <class S>
MotionPolynomial<S> draw_reduced_lagrangian(Draw& draw, SpannedGroup const& group) {
  return {draw_group_polynomial<S>(draw, group), {}, {}};
}
/// Makes `f` one motion of a Lagrangian near `l`: `residual(l, k)` is the equation that joins f[k-1] and
/// f[k], `tangent(k, a)` the direction at f[k] along which its a-th component takes the differential. One
/// step after the other, the differential at f[k] is changed until the equation holds.
template <class S, class Residual, class Tangent>
MotionPolynomial<S> solved_for(MotionPolynomial<S> const& l, GroupElements<S> const& f,
                               Residual const& residual, Tangent const& tangent) {
  int const n = f.front().group.matrix_size(), d = f.front().group.dimension();
  MotionPolynomial<S> made{l.l, f, std::vector<Matrix<S>>(f.size(), Matrix<S>::Zero(n, n))};
  for (int k = 1; k < static_cast<int>(f.size()); ++k) {
    Vector<S> const left = residual(made, k);
    Matrix<S> gram(d, d);
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) gram(a, b) = contract(Matrix<S>(tangent(k, a)), Matrix<S>(tangent(k, b)));
    Vector<S> const coefficients = solve_linear(gram, Vector<S>(-left), "solved_for");
    for (int b = 0; b < d; ++b) made.c[k] += tangent(k, b) * coefficients[b];
  }
  return made;
}
/// A reduced Lagrangian that has the given relative motions as one motion, right- or left-invariant.
template <class S>
MotionPolynomial<S> with_motions_right(MotionPolynomial<S> const& l, GroupElements<S> const& f) {
  return solved_for(
      l, f,
      [&](auto const& k, int i) {
        return reduced_residual_right(k, GroupElements<S>{f[i - 1], f[i]});
      },
      [&](int i, int a) { return from_left(basis_velocity<S>(f[i].group, a), f[i]); });
}
template <class S>
MotionPolynomial<S> with_motions_left(MotionPolynomial<S> const& l, GroupElements<S> const& f) {
  return solved_for(
      l, f,
      [&](auto const& k, int i) {
        return reduced_residual_left(k, GroupElements<S>{f[i - 1], f[i]});
      },
      [&](int i, int a) { return from_right(f[i], basis_velocity<S>(f[i].group, a)); });
}

}  // namespace actio::checks
