// Chapter 10: the vorticity of an ideal fluid on the sphere as a matrix, and what a step conserves.
//
// dW/dt = [P, W], Delta P = W, in su(N); hbar is in the unit of time. A step is made of a displacement A and
// the vorticity half-way Wt: W_0 = (1 - A) Wt (1 + A) and W_1 = (1 + A) Wt (1 - A). Where the displacement,
// or the stream function, is drawn and the rest is found from it, a step needs no iteration, and every field
// will do.
#include "actio/groups/unitary_groups.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/vorticity/vorticity_step.hpp"

#include "fields/node_fluid.hpp"
#include "models/models.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::sphere;
using namespace actio::checks;

namespace {

/// The quantised sphere without roots: complex matrices A + iB as real ones ((A, -B), (B, A)), in a basis
/// whose vectors have the squared lengths 1/binomial(N - 1, k) instead of 1, so that the spin matrices are
/// rational.
template <class S>
struct RationalSphere {
  int n;
  std::array<Matrix<S>, 3> generator;  ///< \f$iS_j\f$
  Vector<S> form;                      ///< of the basis: X* is its inverse times the transpose of X times it

  explicit RationalSphere(int size) : n(size), form(2 * size) {
    Matrix<S> above = Matrix<S>::Zero(n, n), below = above, weights = above, none = above;
    S binomial(1);
    for (int k = 0; k < n; ++k) {
      weights(k, k) = ratio<S>(n - 1 - 2 * k, 2);
      form[k] = form[n + k] = binomial;
      if (k + 1 == n) break;
      above(k, k + 1) = ratio<S>(n - 1 - k, 2), below(k + 1, k) = ratio<S>(k + 1, 2);
      binomial = binomial * S(n - 1 - k) / S(k + 1);
    }
    generator = {complex(none, Matrix<S>(above + below)), complex(Matrix<S>(above - below), none),
                 complex(none, weights)};
  }
  static Matrix<S> complex(Matrix<S> const& real, Matrix<S> const& imaginary) {
    auto const n = real.rows();
    Matrix<S> whole(2 * n, 2 * n);
    whole << real, -imaginary, imaginary, real;
    return whole;
  }
  std::string name() const { return "N = " + std::to_string(n); }
  Matrix<S> one() const { return Matrix<S>::Identity(2 * n, 2 * n); }
  Matrix<S> i() const { return complex(Matrix<S>::Zero(n, n), Matrix<S>::Identity(n, n)); }
  Matrix<S> star(Matrix<S> const& x) const {
    Matrix<S> turned = x.transpose();
    for (int r = 0; r < 2 * n; ++r)
      for (int c = 0; c < 2 * n; ++c) turned(r, c) = turned(r, c) * form[c] / form[r];
    return turned;
  }
  /// The part of a skew matrix with trace zero.
  Matrix<S> balanced(Matrix<S> const& x) const { return x + i() * (S((i() * x).trace()) / S(2 * n)); }
  Matrix<S> skew(Matrix<S> const& x) const { return balanced((x - star(x)) / S(2)); }
  Matrix<S> draw_skew(Draw& draw) const {
    auto const real = draw_matrix<S>(draw, n, n);
    return skew(complex(real, draw_matrix<S>(draw, n, n)));
  }
  /// A basis of su(N).
  std::vector<Matrix<S>> basis() const {
    std::vector<Matrix<S>> all;
    Matrix<S> const none = Matrix<S>::Zero(n, n);
    for (int r = 0; r < n; ++r)
      for (int c = r; c < n; ++c) {
        Matrix<S> unit = none;
        unit(r, c) = S(1);
        if (r != c) all.push_back(skew(complex(unit, none)));
        if (r + 1 != n || r != c) all.push_back(skew(complex(none, unit)));
      }
    return all;
  }
  /// \f$-\sum_j[S_j, [S_j, W]]\f$.
  template <class T>
  Matrix<T> laplacian(Matrix<T> const& w) const {
    Matrix<T> sum = Matrix<T>::Zero(2 * n, 2 * n);
    for (auto const& s : generator) {
      Matrix<T> const x = s.template cast<T>(), once = x * w - w * x;
      sum += x * once - once * x;
    }
    return sum;
  }
  /// P with trace zero, \f$\Delta P = W\f$ up to its trace: a polynomial of the Laplacian, whose eigenvalues
  /// are -l(l + 1).
  Matrix<S> stream(Matrix<S> const& vorticity) const {
    Matrix<S> rest = balanced(vorticity), p = Matrix<S>::Zero(2 * n, 2 * n);
    for (int l = 1; l < n; ++l) {
      p -= rest / S(l * (l + 1));
      rest += laplacian(rest) / S(l * (l + 1));
    }
    return p;
  }
};

template <class S>
Matrix<S> bracket_of(Matrix<S> const& x, Matrix<S> const& y) { return x * y - y * x; }
/// \f$-\mathrm{Tr}(XY)\f$.
template <class S>
S inner(Matrix<S> const& x, Matrix<S> const& y) { return -S((x * y).trace()); }

/// A displacement that is diagonal in a basis at hand, so that linear equations with it are solved entry by
/// entry.
template <class S>
struct Displacement {
  Matrix<S> a, vectors, inverse;
  Vector<S> angles;  ///< A is i times these

  /// X with \f$X - AXA = M\f$.
  Matrix<S> half_way(Matrix<S> const& m) const {
    Matrix<S> x = inverse * m * vectors;
    auto const n = angles.size();
    for (Index r = 0; r < 2 * n; ++r)
      for (Index c = 0; c < 2 * n; ++c) x(r, c) /= S(1) + angles[r % n] * angles[c % n];
    return vectors * x * inverse;
  }
};
template <class S>
Displacement<S> draw_displacement(RationalSphere<S> const& sphere, Draw& draw) {
  Displacement<S> d;
  // The basis is made of small whole numbers, so that of what is drawn only the angles count in a degree.
  auto const whole = [&] {
    Matrix<S> m(sphere.n, sphere.n);
    for (int r = 0; r < sphere.n; ++r)
      for (int c = 0; c < sphere.n; ++c) m(r, c) = S(static_cast<long>(draw.below(7)) - 3);
    return m;
  };
  Matrix<S> const real = whole();
  d.vectors = cayley(sphere.skew(sphere.complex(real, whole())));
  d.inverse = inverse_matrix(d.vectors);
  d.angles = draw_vector<S>(draw, sphere.n) / S(2);
  S const mean = S(d.angles.sum()) / S(sphere.n);
  for (auto& x : d.angles) x -= mean;
  Matrix<S> const diagonal = d.angles.asDiagonal();
  d.a = d.vectors * sphere.complex(Matrix<S>::Zero(sphere.n, sphere.n), diagonal) * d.inverse;
  return d;
}

/// One step: displacement and vorticity half-way.
template <class S>
struct Step {
  Matrix<S> a, middle;
  Matrix<S> one() const { return Matrix<S>::Identity(a.rows(), a.cols()); }
  Matrix<S> before() const { return (one() - a) * middle * (one() + a); }
  Matrix<S> after() const { return (one() + a) * middle * (one() - a); }
  Matrix<S> half_change() const { return bracket_of(a, middle); }
  /// The midpoint rule, which leaves out A Wt A: what the same displacement would do without the Cayley map.
  Matrix<S> plain_before() const { return middle - half_change(); }
  Matrix<S> plain_after() const { return middle + half_change(); }
};
/// P is drawn, of A = eps P, \f$\tilde W = \Delta P\f$ with the trace that leaves none to \f$W_0\f$.
template <class S>
Step<S> lie_poisson_step(RationalSphere<S> const& sphere, Matrix<S> const& p, S const& eps) {
  Step<S> step{p * eps, sphere.laplacian(p)};
  Matrix<S> const i = sphere.i(), turned = i * (sphere.one() - step.a * step.a);
  step.middle -= i * (S((i * step.before()).trace()) / S((i * turned).trace()));
  return step;
}
/// P is drawn, of A = eps P, \f$\tilde W - A\tilde WA = \Delta P\f$, which is the mean of \f$W_0\f$ and
/// \f$W_1\f$.
template <class S>
Step<S> energy_step(RationalSphere<S> const& sphere, Displacement<S> const& d, S const& eps) {
  return {d.a, d.half_way(sphere.laplacian(Matrix<S>(d.a / eps)))};
}
/// A is drawn; the vorticity half-way is a multiple of \f$U + tA\f$ with a U for which no angular momentum
/// changes, and the t for which the energy does not: an equation of first degree, because A commutes with A.
template <class S>
Step<S> all_invariants_step(RationalSphere<S> const& sphere, Matrix<S> const& a, Draw& draw) {
  // U from four matrices, by the minors of the three equations.
  Matrix<S> drawn[4], equations(3, 4);
  for (int k = 0; k < 4; ++k) {
    drawn[k] = sphere.draw_skew(draw);
    for (int j = 0; j < 3; ++j) equations(j, k) = inner(bracket_of(sphere.generator[j], a), drawn[k]);
  }
  auto const minor = [&](int x, int y, int z) {
    auto const& e = equations;
    return S(e(0, x) * (e(1, y) * e(2, z) - e(1, z) * e(2, y)) -
             e(0, y) * (e(1, x) * e(2, z) - e(1, z) * e(2, x)) +
             e(0, z) * (e(1, x) * e(2, y) - e(1, y) * e(2, x)));
  };
  Matrix<S> const u = drawn[0] * minor(1, 2, 3) - drawn[1] * minor(0, 2, 3) + drawn[2] * minor(0, 1, 3) -
                      drawn[3] * minor(0, 1, 2);
  auto const mean_stream = [&](Matrix<S> const& w) { return sphere.stream(w - a * w * a); };
  Matrix<S> const change = bracket_of(a, u);
  // Multiplied by what t is divided by: the equations are homogeneous in the vorticity.
  return {a, u * inner(mean_stream(a), change) - a * inner(mean_stream(u), change)};
}

/// \f$\mathrm{Tr}((-iW)^k)\f$, k = 2 .. N, twice.
template <class S>
Vector<S> casimirs(RationalSphere<S> const& sphere, Matrix<S> const& w) {
  Matrix<S> const x = -sphere.i() * w;
  Matrix<S> power = x;
  Vector<S> traces(sphere.n - 1);
  for (int k = 2; k <= sphere.n; ++k) {
    power = power * x;
    traces[k - 2] = power.trace();
  }
  return traces;
}
/// What the sums of products in the Casimirs are made of.
template <class S>
S size_of_casimirs(RationalSphere<S> const& sphere, Matrix<S> const& w) {
  S const x = S(magnitude(w)) * S(2 * sphere.n);
  S size(1);
  for (int k = 0; k < sphere.n; ++k) size *= x + S(1);
  return size;
}
template <class S>
Vector<S> angular_momentum(RationalSphere<S> const& sphere, Matrix<S> const& w) {
  Vector<S> l(3);
  for (int j = 0; j < 3; ++j) l[j] = inner(sphere.generator[j], w);
  return l;
}
/// Twice the energy.
template <class S>
S energy(RationalSphere<S> const& sphere, Matrix<S> const& w) { return -inner(sphere.stream(w), w); }

/// The tangent of a step by the stream function drawn: the components of what \f$W_0\f$ and \f$W_1\f$ change
/// by.
template <class S>
struct Tangents {
  Matrix<S> before, after;
};
template <class S, class Middle>
Tangents<S> tangents(RationalSphere<S> const& sphere, Step<S> const& step, S const& eps,
                     Middle const& middle) {
  auto const basis = sphere.basis();
  auto const d = static_cast<Index>(basis.size());
  Tangents<S> t{Matrix<S>(d, d), Matrix<S>(d, d)};
  Matrix<S> const one = sphere.one(), minus = one - step.a, plus = one + step.a, i = sphere.i(),
                  trace = i * minus * plus;
  for (Index c = 0; c < d; ++c) {
    Matrix<S> const da = basis[static_cast<std::size_t>(c)] * eps,
                    dw = middle(basis[static_cast<std::size_t>(c)], da);
    Matrix<S> before = minus * dw * plus - da * step.middle * plus + minus * step.middle * da,
              after = plus * dw * minus + da * step.middle * minus - plus * step.middle * da;
    // What changes the trace of Wt so that that of W_0 stays zero.
    S const balance = S((i * before).trace()) / S((i * trace).trace());
    before -= trace * balance, after -= trace * balance;
    for (Index r = 0; r < d; ++r) {
      t.before(r, c) = inner(basis[static_cast<std::size_t>(r)], before);
      t.after(r, c) = inner(basis[static_cast<std::size_t>(r)], after);
    }
  }
  return t;
}
/// The Lie-Poisson bracket of the components of W: \f$\langle W, [e_a, e_b]\rangle\f$.
template <class S>
Matrix<S> poisson_tensor(RationalSphere<S> const& sphere, Matrix<S> const& w) {
  auto const basis = sphere.basis();
  auto const d = static_cast<Index>(basis.size());
  Matrix<S> tensor(d, d);
  for (Index a = 0; a < d; ++a)
    for (Index b = 0; b < d; ++b)
      tensor(a, b) =
          inner(w, bracket_of(basis[static_cast<std::size_t>(a)], basis[static_cast<std::size_t>(b)]));
  return tensor;
}

/// A step from a given vorticity, by the plain iteration of its equations: the three forms.
template <class S>
Step<S> solved_step(RationalSphere<S> const& sphere, Matrix<S> const& w, S const& eps, Conserved form) {
  Step<S> step{w * S(0), w};
  Matrix<S> change = w * S(0);
  Vector<S> factors = Vector<S>::Zero(4);
  Base<S> least(0);
  int stays = 0;
  for (int k = 0; k < 400 && stays < 4; ++k) {
    bool const all = form == Conserved::all_invariants;
    Matrix<S> const p = sphere.stream(form == Conserved::lie_poisson ? step.middle : Matrix<S>(w + change));
    std::vector<Matrix<S>> along;
    if (all) {
      along.push_back(change);
      for (auto const& s : sphere.generator) along.push_back(bracket_of(s, step.middle));
    }
    step.a = p * eps;
    for (std::size_t j = 0; j < along.size(); ++j) step.a += along[j] * factors[static_cast<Index>(j)];
    Matrix<S> const next_change = step.half_change(), next = w + next_change + step.a * step.middle * step.a;
    Base<S> moved = magnitude(Matrix<S>(next - step.middle));
    if (all && k > 0) {
      Matrix<S> gram(4, 4);
      Vector<S> right(4);
      for (int i = 0; i < 4; ++i) {
        right[i] = i == 0 ? S(eps * inner(p, next_change)) : inner(sphere.generator[i - 1], next_change);
        for (int j = 0; j < 4; ++j) gram(i, j) = inner(along[i], along[j]);
      }
      Vector<S> const part = solve_linear(gram, right);
      factors += part;
      moved += magnitude(part);
    }
    change = next_change, step.middle = next;
    // Done where rounding keeps it from falling.
    stays = k > 0 && !(moved * Base<S>(2) < least) ? stays + 1 : 0;
    if (k == 0 || moved < least) least = moved;
  }
  return step;
}
/// \f$\dot W = [P, W]\f$ by Runge and Kutta's scheme of fourth order.
template <class S>
Matrix<S> flow(RationalSphere<S> const& sphere, Matrix<S> w, S const& time, int steps, S const& sense) {
  S const h = time / S(steps);
  auto const rate = [&](Matrix<S> const& x) { return Matrix<S>(bracket_of(sphere.stream(x), x) * sense); };
  for (int k = 0; k < steps; ++k) {
    Matrix<S> const k1 = rate(w), k2 = rate(w + k1 * (h / S(2))), k3 = rate(w + k2 * (h / S(2))),
                    k4 = rate(w + k3 * h);
    w += (k1 + k2 * S(2) + k3 * S(2) + k4) * (h / S(6));
  }
  return w;
}
/// To the orthonormal basis, and the library's store.
template <class S>
SkewHermitian<> in_the_library(RationalSphere<S> const& sphere, Matrix<S> const& w) {
  int const n = sphere.n;
  SkewHermitian<> out(n);
  for (int r = 0; r < n; ++r)
    for (int c = 0; c < n; ++c) {
      double const scale = std::sqrt(to_double(sphere.form[r]) / to_double(sphere.form[c]));
      out.real(r, c) = to_double(w(r, c)) * scale, out.imaginary(r, c) = to_double(w(n + r, c)) * scale;
    }
  return out;
}

char const* name_of(Conserved form) {
  return form == Conserved::lie_poisson      ? "Lie-Poisson form"
         : form == Conserved::energy_casimir ? "energy-Casimir form"
                                             : "form of all invariants";
}

}  // namespace

STATEMENT(claim_10_0_reduced_hydrodynamics, "reduced hydrodynamic schemes and known first integrals") {
  claim.convention(
      "For the ideal fluid on the sphere whose vorticity is a matrix $W\\in\\mathfrak{su}(N)$. The known "
      "first integrals are then the $N-1$ Casimirs, the energy and the angular momentum. Every step that "
      "conjugates by a Cayley map conserves the Casimirs. The discrete Lie-Poisson step of chapter 3 "
      "conserves the angular momentum and is a Poisson map; its energy is within $O(h^2)$. With the stream "
      "function of the mean vorticity the energy is conserved, and the angular momentum and the Poisson "
      "property are given up. With a displacement that moves along the orbit all of them are conserved, "
      "and the Poisson property is given up.");
  claim.leaves(
      "Fluids in space, where the helicity is a first integral, and on other surfaces than the sphere; one "
      "step that keeps all integrals and is a Poisson map. That the matrices tend to the fluid as "
      "$N\\to\\infty$ is cited on the page, and that a step has a solution is shown where one is found.");
  // The sizes bound the sums of products, so that plain evaluation is what remains.
  double const sums = 1;
  for (int const n : {4, 5}) {
    if (numbers_grow() && n > 4) continue;  // fractions grow with the size of a system
    RationalSphere<S> const sphere(n);
    std::string const model = sphere.name();
    auto const P = sphere.draw_skew(draw);
    auto const d = draw_displacement(sphere, draw);
    S const eps = ratio<S>(1, 3);
    auto const poisson = lie_poisson_step(sphere, P, eps), level = energy_step(sphere, d, eps),
               all = all_invariants_step(sphere, Matrix<S>(sphere.draw_skew(draw) / S(2)), draw);
    // Any displacement, and any vorticity half-way.
    Step<S> const any{sphere.draw_skew(draw), sphere.draw_skew(draw)};

    // Casimirs: for every displacement.
    for (auto const& [step, of] : {std::pair{&any, "any displacement"},
                                   {&poisson, "Lie-Poisson form"},
                                   {&level, "energy-Casimir form"},
                                   {&all, "form of all invariants"}})
      claim.zero(std::string("Casimirs of degree 2 to N, ") + of, model,
                 Vector<S>(casimirs(sphere, step->after()) - casimirs(sphere, step->before())),
                 size_of_casimirs(sphere, step->before()) + size_of_casimirs(sphere, step->after()), sums);
    // The midpoint rule conserves those of second degree.
    claim.refutes("without A Wt A, the midpoint rule", model,
                  Vector<S>(casimirs(sphere, any.plain_after()) - casimirs(sphere, any.plain_before())),
                  size_of_casimirs(sphere, any.plain_before()), 1e-9);

    // Energy.
    auto const energy_size = [&](Step<S> const& step) {
      S const size = S(magnitude(step.before()) + magnitude(step.after()));
      return S(size * size * S(4 * n * n));
    };
    auto const change_of_energy = [&](Step<S> const& step) {
      return S(energy(sphere, step.after()) - energy(sphere, step.before()));
    };
    auto const by_mean = [&](Step<S> const& step, Matrix<S> const& mean) {
      return S(-inner(sphere.stream(mean), step.half_change()) * S(4));
    };
    claim.zero("the change of energy is that of the mean vorticity", model,
               S(change_of_energy(any) - by_mean(any, (any.before() + any.after()) / S(2))), energy_size(any),
               sums);
    claim.refutes("of the vorticity half-way", model, S(change_of_energy(any) - by_mean(any, any.middle)),
                  energy_size(any), 1e-6);
    claim.zero("energy, energy-Casimir form", model, change_of_energy(level), energy_size(level), sums);
    claim.zero("energy, form of all invariants", model, change_of_energy(all), energy_size(all), sums);
    claim.refutes("energy, Lie-Poisson form", model, change_of_energy(poisson), energy_size(poisson), 1e-7);

    // Angular momentum.
    auto const change_of_momentum = [&](Step<S> const& step) {
      return Vector<S>(angular_momentum(sphere, step.after()) - angular_momentum(sphere, step.before()));
    };
    auto const momentum_size = [&](Step<S> const& step) {
      return S(S(magnitude(step.before()) + magnitude(step.after())) * S(4 * n * n));
    };
    claim.zero("angular momentum, Lie-Poisson form", model, change_of_momentum(poisson),
               momentum_size(poisson), sums);
    claim.zero("angular momentum, form of all invariants", model, change_of_momentum(all), momentum_size(all),
               sums);
    claim.refutes("angular momentum, energy-Casimir form", model, change_of_momentum(level),
                  momentum_size(level), 1e-7);
  }

  // Poisson maps: the first form alone. With P drawn before and after are functions of P, and the tangent of
  // the step is T_1 T_0^{-1}.
  if (!numbers_grow()) {
    RationalSphere<S> const sphere(3);
    std::string const model = sphere.name();
    S const eps = ratio<S>(1, 3);
    auto const d = draw_displacement(sphere, draw);
    auto const poisson = lie_poisson_step(sphere, sphere.draw_skew(draw), eps),
               level = energy_step(sphere, d, eps);
    auto const defect = [&](Step<S> const& step, auto const& middle) {
      auto const t = tangents(sphere, step, eps, middle);
      Matrix<S> const map = t.after * inverse_matrix(t.before),
                      before = poisson_tensor(sphere, step.before());
      return std::pair{Matrix<S>(map * before * map.transpose() - poisson_tensor(sphere, step.after())),
                       S(S(magnitude(map)) * S(magnitude(map)) * S(magnitude(before)) * S(64))};
    };
    auto const [zero, size] =
        defect(poisson, [&](Matrix<S> const& dp, Matrix<S> const&) { return sphere.laplacian(dp); });
    // The tangent divides by a matrix of eight rows.
    claim.zero("the Lie-Poisson form is a Poisson map", model, zero, size, 10);
    auto const [other, other_size] = defect(level, [&](Matrix<S> const& dp, Matrix<S> const& da) {
      return d.half_way(sphere.laplacian(dp) + da * level.middle * d.a + d.a * level.middle * da);
    });
    claim.refutes("the energy-Casimir form", model, other, other_size, 1e-7);
    // With two degrees alone the energy is a function of angular momentum and enstrophy.
    auto const energies = S(energy(sphere, poisson.after()) - energy(sphere, poisson.before()));
    claim.zero("energy, Lie-Poisson form, for N = 3", model, energies,
               S(S(magnitude(poisson.before())) * S(magnitude(poisson.before())) * S(36)), sums);
  }
  if (exact_arithmetic<S>()) return;

  // Steps from a vorticity that is given.
  RationalSphere<S> const sphere(4);
  std::string const model = "N = 4, the step solved";
  auto const W = sphere.draw_skew(draw);
  S const eps = ratio<S>(1, 4), size = S(magnitude(W)) * S(64);
  for (auto const form : {Conserved::lie_poisson, Conserved::energy_casimir, Conserved::all_invariants}) {
    auto const step = solved_step(sphere, W, eps, form);
    auto const after = step.after();
    std::string const of = std::string(", ") + name_of(form);
    claim.equal("it starts where it is asked to" + of, model, step.before(), W, 10);
    claim.zero("Casimirs" + of, model, Vector<S>(casimirs(sphere, after) - casimirs(sphere, W)),
               size_of_casimirs(sphere, W), 10);
    auto const energies = S(energy(sphere, after) - energy(sphere, W));
    Vector<S> const momenta = angular_momentum(sphere, after) - angular_momentum(sphere, W);
    if (form == Conserved::lie_poisson)
      claim.refutes("energy" + of, model, energies, S(size * size), 1e-10);
    else
      claim.zero("energy" + of, model, energies, S(size * size), 10);
    if (form == Conserved::energy_casimir)
      claim.refutes("angular momentum" + of, model, momenta, size, 1e-9);
    else
      claim.zero("angular momentum" + of, model, momenta, size, 10);
    auto const back = solved_step(sphere, after, S(-eps), form);
    claim.equal("the step back" + of, model, back.after(), W, 100);
    // The library has hbar in its unit of time, and an orthonormal basis.
    if (claim.fits_orders()) {
      SphereLaplacian const laplacian(4);
      VorticityStep<> made(laplacian, form, 2 * QuantizedSphere(4).hbar() * to_double(eps));
      auto w = in_the_library(sphere, W);
      made.advance(w);
      auto const difference = w - in_the_library(sphere, after), change = w - in_the_library(sphere, W);
      claim.zero("the library's step" + of, model, S(norm(difference)), S(norm(w)), 10);
      claim.refutes("the library's step against none" + of, model, S(norm(change)), S(norm(w)), 1e-4);
      // Order 2 to the flow, forwards in time.
      std::vector<double> steps, errors, backwards;
      S const time(1);
      auto const exact = flow(sphere, W, time, 400, S(1)), reversed = flow(sphere, W, time, 400, S(-1));
      for (int count = 2; count <= 64; count *= 2) {
        auto w_k = W;
        for (int k = 0; k < count; ++k) w_k = solved_step(sphere, w_k, S(time / S(2 * count)), form).after();
        steps.push_back(1.0 / count);
        errors.push_back(to_double(S(magnitude(Matrix<S>(w_k - exact)))));
        backwards.push_back(to_double(S(magnitude(Matrix<S>(w_k - reversed)))));
      }
      claim.order("errors after unit time" + of, model, steps, errors, 2);
      claim.refutes_order("against the flow backwards in time" + of, model, steps, backwards, 2);
    }
  }
}

namespace {

/// What the nodes of a mesh have of relabellings, and what their circulation does.
template <class S>
void relabellings_of_nodes(Claim<S>& claim, Draw& draw) {
  std::string const mesh = "six triangles about a node", cell = "a triangle alone";
  auto const fluid = [&](int nodes, std::vector<std::array<int, 3>> const& cells) {
    NodeFluid<S> made{Vector<S>(nodes), cells};
    for (int p = 0; p < nodes; ++p) made.mass[p] = S(1) + draw.template number<S>() / S(4);
    return made;
  };
  auto const hexagon = fluid(7, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 1}});
  auto const alone = fluid(3, {{0, 1, 2}});
  // Linear equations in 49 unknowns.
  if (claim.first()) {
    claim.fact("relabellings that keep energy and areas: none", mesh, hexagon.symmetries() == 0);
    claim.fact("relabellings that keep energy and areas: one", cell, alone.symmetries() == 1);
  }
  auto const motion = [&](NodeFluid<S> const& of, Matrix<S> const& about) {
    Matrix<S> const place = about + draw_matrix<S>(draw, 2, of.nodes()) / S(8);
    return NodeMotion<S>{place, keeping_areas(of, place, draw_matrix<S>(draw, 2, of.nodes()))};
  };
  Matrix<S> corners(2, 7);
  corners << S(0), S(2), S(1), S(-1), S(-2), S(-1), S(1), S(0), S(0), S(2), S(2), S(0), S(-2), S(-2);
  auto const around = motion(hexagon, corners), turning = motion(alone, Matrix<S>(corners.leftCols(3)));
  std::vector<int> const ring = {1, 2, 3, 4, 5, 6}, edge = {0, 1, 2};
  auto const size = [](NodeMotion<S> const& m) {
    return S(size_of(m.velocity) * size_of(m.velocity) * Base<S>(m.velocity.cols()));
  };
  // Pressures are solved for: Condition of equations that are nearly orthogonal.
  claim.zero("areas stay", mesh, Vector<S>(rates_of_areas(hexagon, around.place) * stacked(around.velocity)),
             S(size_of(around.place) * size_of(around.velocity)), 10);
  claim.zero("circulation along the nodes", cell, rate_of_circulation(alone, turning, edge), size(turning),
             10);
  claim.refutes("circulation along the nodes", mesh, rate_of_circulation(hexagon, around, ring),
                size(around));
}

}  // namespace

STATEMENT(claim_10_0_vorticity_preservation, "discrete vorticity preservation for incompressible fluids") {
  claim.corrected(
      R"(\text{the discrete Noether theorem over nodes}\;\Longrightarrow\;\text{discrete vorticity )"
      R"(preserved})",
      R"(g_k^{-1}W_kg_k = W_0\quad\text{for } g_{k+1} = \mathrm{cay}(A_k)\,g_k \text{ in a group of )"
      R"(relabellings})",
      "Nodes and cells have no relabellings left: for six triangles about a node no linear map of the "
      "labels but 0 keeps the kinetic energy and the areas, so there is no momentum to be preserved, and "
      "the circulation around the six nodes changes at a rate. A cell alone has one such map, and its "
      "circulation is constant. With $\\SU(N)$ in the place of the area-preserving maps of the sphere the "
      "momentum map of the relabellings is the vorticity carried back to the labels, the same at every "
      "step: $W_0$ and $W_1$ are the two discrete Legendre images of a Lagrangian on the group.");
  claim.leaves("Other discretizations of a fluid by nodes than triangles whose areas are held.");
  relabellings_of_nodes(claim, draw);
  for (int const n : {3, 4}) {
    if (numbers_grow() && n > 3) continue;
    RationalSphere<S> const sphere(n);
    std::string const model = sphere.name();
    Matrix<S> const one = sphere.one(), W0 = sphere.draw_skew(draw);
    Matrix<S> W = W0, g = one, wrong = one;
    for (int k = 0; k < (numbers_grow() ? 2 : 4); ++k) {
      Matrix<S> const a = sphere.draw_skew(draw) / S(2);
      Step<S> const step{a,
                         Matrix<S>(solve_linear(Matrix<S>(one - a), W) * inverse_matrix(Matrix<S>(one + a)))};
      W += step.half_change() * S(2);
      Matrix<S> const u = cayley(Matrix<S>(a * S(2)));
      g = u * g, wrong = wrong * u;
    }
    S const size = S(magnitude(W)) * S(magnitude(g)) * S(magnitude(inverse_matrix(g))) * S(4 * n * n);
    // Two linear systems in each of four steps.
    claim.zero("the vorticity carried back to the labels", model, Matrix<S>(inverse_matrix(g) * W * g - W0),
               size);
    claim.refutes("displacements composed on the other side", model,
                  Matrix<S>(inverse_matrix(wrong) * W * wrong - W0), size, 1e-5);
    // Kelvin's theorem: the circulation around what is carried along.
    auto const xi = sphere.draw_skew(draw);
    claim.zero("circulation, an element of the algebra carried along", model,
               S(inner(W, Matrix<S>(g * xi * inverse_matrix(g))) - inner(W0, xi)),
               S(size * S(magnitude(xi))));
    claim.refutes("circulation of one that stays", model, S(inner(W, xi) - inner(W0, xi)),
                  S(size * S(magnitude(xi))), 1e-5);
  }
  // Against the general algorithm of chapter 3: its momenta at the two ends of a step, of the Lagrangian
  // Tr(A Delta A)/eps. The Cayley transform of a matrix without trace is in SU(N) up to a phase, on which
  // nothing depends. The three matrices of the rotations of space are iS_j in another basis of size 3.
  if (numbers_grow()) return;
  std::string const model = "SU(3), general algorithm";
  SU<> const group(3);
  RationalSphere<S> sphere(3);
  sphere.form.setConstant(S(1));
  for (int j = 0; j < 3; ++j) {
    Matrix<S> turn = Matrix<S>::Zero(3, 3);
    turn((j + 2) % 3, (j + 1) % 3) = S(1), turn((j + 1) % 3, (j + 2) % 3) = S(-1);
    sphere.generator[j] = sphere.complex(turn, Matrix<S>::Zero(3, 3));
  }
  S const eps = ratio<S>(1, 3);
  auto const P = sphere.draw_skew(draw);
  auto const step = lie_poisson_step(sphere, P, eps);
  auto const l = [&](auto const& f) {
    using T = typename std::decay_t<decltype(f)>::Scalar;
    Matrix<T> a = inverse_cayley(Matrix<T>(f.value)) * T(ratio<S>(-1, 2));
    // f counts up to a phase, the one that leaves A without a trace: here none, so that one step of Newton's
    // method has its derivative.
    Matrix<T> const i = sphere.i().template cast<T>(), phase = i - i * a * a;
    a -= phase * T(T((i * a).trace()) / T((i * phase).trace()));
    return T(T((a * sphere.laplacian(a)).trace()) / T(eps));
  };
  Element<SU<>, S> const f{group, cayley(Matrix<S>(step.a * S(-2)))};
  auto const momentum_of = [&](Matrix<S> const& w) {
    Vector<S> components(group.dimension());
    for (int a = 0; a < group.dimension(); ++a)
      components[a] = -inner(w, Matrix<S>(group.hat(Vector<S>(Vector<S>::Unit(group.dimension(), a)))));
    return Momentum<SU<>, S>{group, components};
  };
  auto const start = momentum_of(step.before()), end = momentum_of(step.after());
  // Derivatives of a quotient of matrices of size six.
  claim.equal("the momentum at the start of the step is the vorticity before", model,
              momentum_before_right(l, f), start, 10);
  claim.equal("that at its end is the vorticity after", model, -left_differential(l, f), end, 10);
  claim.equal("the update (3.17)", model, lie_poisson_update_right(f, start), end, 10);
  claim.differs("the momentum at the start against the vorticity half-way", model,
                momentum_before_right(l, f), momentum_of(step.middle), 1e-3);
  claim.differs("the update with the inverse motion", model, lie_poisson_update_right(inverse(f), start),
                end);
}
