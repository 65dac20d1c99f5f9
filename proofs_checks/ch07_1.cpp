// Section 7.1: the theorem of Lagrange multipliers, with the hypothesis that it needs.
#include "statement.hpp"

#include "actio/constraints/multiplier_theorem.hpp"
#include "fields/constrained_models.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

template <class S, int m>
using Numbers = Matrix<S, m, 1>;

/// Two functions on R^4 = R^2 x R^2 that vanish at a given point: none of the coordinates is given as a
/// function of the others.
template <class S>
struct LevelConstraint {
  std::array<Cubic<S, 4>, 2> c;
  Numbers<S, 4> origin;
  template <class T>
  Numbers<T, 2> operator()(Numbers<T, 4> const& q) const {
    Numbers<T, 2> value;
    for (int i = 0; i < 2; ++i) value[i] = c[i](q) - T(c[i](origin));
    return value;
  }
};

/// An inner product of the fibres that depends on the point.
template <class S>
struct FibreMetric {
  AnyMetric<S, 2> g;
  template <class T>
  auto frame(Numbers<T, 4> const& q) const { return g.frame(Numbers<T, 2>(q[0], q[3])); }
  template <class T>
  auto operator()(Numbers<T, 4> const& q) const { return g(Numbers<T, 2>(q[0], q[3])); }
};

/// A cubic with a linear function added, so that its differential at one point is what it should be.
template <class S, int m>
struct Tilted {
  Cubic<S, m> c;
  Numbers<S, m> slope;
  template <class T>
  T operator()(Numbers<T, m> const& q) const {
    T sum = c(q);
    for (int i = 0; i < m; ++i) sum += q[i] * T(slope[i]);
    return sum;
  }
};

/// The zeros of two functions near a point, an inner product of the fibres, and functions h with what a
/// statement asks for at that point.
template <class S>
struct LevelModel {
  LevelConstraint<S> Psi;
  FibreMetric<S> fibre;
  Cubic<S, 4> c;

  explicit LevelModel(Draw& draw)
      : Psi{{draw_cubic<S, 4>(draw, ratio<S>(1, 3)), draw_cubic<S, 4>(draw, ratio<S>(1, 3))},
            draw.vector<S, Numbers<S, 4>>(4) / S(2)},
        fibre{draw_metric<S, 2>(draw)},
        c(draw_cubic<S, 4>(draw)) {
    // The last two coordinates can be solved for.
    Psi.c[0].a[2] += S(2), Psi.c[1].a[3] += S(2);
  }

  auto with(Tilted<S, 4> const& h) const { return constrained<2>(h, Psi, fibre); }
  /// h with the part of \f$d\bar h\f$ in q zero at (q, lambda).
  Tilted<S, 4> critical_at(Numbers<S, 4> const& q, Numbers<S, 2> const& lambda) const {
    Tilted<S, 4> h{c, Numbers<S, 4>::Zero()};
    h.slope = -with(h).augmented_differential(q, lambda).template head<4>();
    return h;
  }
  /// h with a restriction that is critical: its derivative across the zeros is anything.
  Tilted<S, 4> restriction_critical() const {
    Tilted<S, 4> h{c, Numbers<S, 4>::Zero()};
    h.slope.template head<2>() = -along_zeros(h, Psi.origin);
    return h;
  }
  /// The derivative of the restriction of h to the level of Psi through q, in coordinates of this surface:
  /// the first two are free, and the others follow by the iteration of Newton with a fixed slope, which is
  /// exact over dual numbers after one step.
  Numbers<S, 2> along_zeros(Tilted<S, 4> const& h, Numbers<S, 4> const& q) const {
    Matrix<S, 2, 2> const across = derivative(Psi, q).matrix.template rightCols<2>();
    Matrix<S, 2, 2> const back = inverse_matrix(across);
    Numbers<S, 2> const level = Psi(q);
    auto const restricted = [&]<class T>(Numbers<T, 2> const& u) {
      Numbers<T, 4> at;
      at << u, T(q[2]), T(q[3]);
      Numbers<T, 2> const gap = Psi(at) - level.template cast<T>();
      at.template tail<2>() -= back.template cast<T>() * gap;
      return h(at);
    };
    return derivative(restricted, Numbers<S, 2>(q.template head<2>())).gradient();
  }
};

/// The zeros of two functions: a model with its name, and what rounding does to it.
inline std::string const level_name = "zeros of two functions on R^4, inner product that varies";
/// The normal equations: twice the inner product (26) and the derivative of the constraint (9), squared by
/// the determinant, and as much for the right side; pivots are of size one tenth and more.
constexpr double level_condition = 100;

/// Another frame of the fibres, \f$\lambda\mapsto B(q)\lambda\f$: the augmented function is the same function
/// on the bundle, off the zeros as well.
template <class S>
void change_the_frame(Claim<S>& claim, Draw& draw, LevelModel<S> const& model) {
  Numbers<S, 2> const lambda = draw.vector<S, Numbers<S, 2>>(2);
  Numbers<S, 4> const q = model.Psi.origin, beside = q + draw.vector<S, Numbers<S, 4>>(4) / S(2);
  FibreMetric<S> const frame{draw_metric<S, 2>(draw)};
  auto const h = model.critical_at(q, lambda);
  auto const f = model.with(h);
  auto const Psi = [&]<class T>(Numbers<T, 4> const& at) {
    return Numbers<T, 2>(frame.frame(at) * model.Psi(at));
  };
  auto const metric = [&]<class T>(Numbers<T, 4> const& at) {
    Matrix<T, 2, 2> const back = inverse_matrix(Matrix<T, 2, 2>(frame.frame(at)));
    return Matrix<T, 2, 2>(back.transpose() * model.fibre(at) * back);
  };
  auto const turned = constrained<2>(h, Psi, metric);
  auto const carried = [&](Numbers<S, 4> const& at) { return Numbers<S, 2>(frame.frame(at) * lambda); };
  std::string const name = level_name + ", another frame";
  claim.equal("the augmented function, off the zeros as well", name,
              turned.augmented(beside, carried(beside)), f.augmented(beside, lambda), level_condition);
  claim.equal("the multiplier in the other frame", name, turned.multiplier(q), carried(q), level_condition);
  claim.zero("critical in the other frame", name, turned.augmented_differential(q, carried(q)), S(1),
             level_condition);
  Numbers<S, 2> const wrong = Matrix<S, 2, 2>(frame.frame(q)).transpose() * lambda;
  claim.refutes("critical with the multiplier carried by the transposed frame", name,
                turned.augmented_differential(q, wrong), S(1));
  claim.differs("the augmented function with the inner product of the first frame", name,
                constrained<2>(h, Psi, model.fibre).augmented(beside, carried(beside)),
                f.augmented(beside, lambda));
}

// ---- A bundle that is not trivial: over the projective plane.

/// Columns of R^3 up to a factor, in the chart in which component i is 1; and a linear form l on them, which
/// is a section of a line bundle: in this chart it is the function l. Going to chart j multiplies by
/// \f$x_i/x_j\f$, which has both signs, and there is no frame on all of the plane.
template <class S>
struct Projective {
  Matrix<S, 3, 3> form;  // h is the quotient of x.form.x and x.x
  Numbers<S, 3> l;

  template <class T>
  static Numbers<T, 3> column(int i, Numbers<T, 2> const& u) {
    Numbers<T, 3> x;
    for (int a = 0, k = 0; a < 3; ++a) x[a] = a == i ? T(1) : u[k++];
    return x;
  }
  static Numbers<S, 2> coordinates_of(int i, Numbers<S, 3> const& x) {
    Numbers<S, 2> u;
    for (int a = 0, k = 0; a < 3; ++a)
      if (a != i) u[k++] = x[a] / x[i];
    return u;
  }
  auto in_chart(int i) const {
    auto const h = [self = *this, i]<class T>(Numbers<T, 2> const& u) {
      auto const x = column(i, u);
      return T(x.dot((self.form.template cast<T>() * x).eval()) / x.dot(x));
    };
    auto const Psi = [self = *this, i]<class T>(Numbers<T, 2> const& u) {
      return Numbers<T, 1>(self.l.template cast<T>().eval().dot(column(i, u)));
    };
    auto const metric = [i]<class T>(Numbers<T, 2> const& u) {
      auto const x = column(i, u);
      return Matrix<T, 1, 1>(T(1) / x.dot(x));
    };
    return constrained<1>(h, Psi, metric);
  }
};

/// The quotient of two quadratic forms is critical on the line l = 0 of the projective plane at x, in each
/// chart; the multipliers of the charts are one element of the fibre.
template <class S>
void glue_over_the_projective_plane(Claim<S>& claim, Draw& draw) {
  using V = Numbers<S, 3>;
  std::string const name = "line bundle over the projective plane, not trivial";
  V const x = draw.vector<S, V>(3) + V(S(2), S(-2), S(2)), any = draw.vector<S, V>(3),
          free = draw.vector<S, V>(3);
  V const l = any - x * S(any.dot(x) / x.dot(x));
  Matrix<S, 3, 3> form = free * free.transpose();
  // Such that form.x is in the plane of x and l.
  S const slope = draw.number<S>() + S(2);
  V const gap = (l * slope - form * x) / x.dot(x);
  Projective<S> const other{form, l};
  form += gap * x.transpose() + x * gap.transpose();
  Projective<S> const model{form, l};
  std::array<S, 3> multiplier;
  for (int i = 0; i < 3; ++i) {
    auto const f = model.in_chart(i);
    auto const u = model.coordinates_of(i, x);
    multiplier[i] = f.multiplier(u)[0];
    claim.zero("critical on the zeros, in each chart", name, f.restricted_differential(u), S(1),
               level_condition);
    claim.zero("critical with its multiplier, in each chart", name,
               f.augmented_differential(u, Numbers<S, 1>(multiplier[i])), S(1), level_condition);
    claim.refutes("another function", name, other.in_chart(i).restricted_differential(u), S(1));
  }
  for (int i = 0; i < 3; ++i) {
    int const j = (i + 1) % 3;
    claim.equal("the multipliers of two charts are one element of the fibre", name, multiplier[j],
                S(multiplier[i] * x[i] / x[j]), level_condition);
    claim.differs("with the inverse transition function", name, multiplier[j],
                  S(multiplier[i] * x[j] / x[i]));
  }
}

// ---- A space of functions: curves in the plane that sweep area at a given rate.

/// h is the integral of any function of (s, r, r'), and the constraint has a value at each s. Both statements
/// are that one function of s vanishes, and it is the same one.
template <class S>
void vary_a_curve(Claim<S>& claim, Draw& draw) {
  std::string const name = "plane curves with [r, r'] = rho(s), inner product of L^2";
  auto const W = draw_density<S, 0, 2>(draw);
  auto const Phi = draw_areal_rate<S, 0>(draw);
  auto const b = draw_cubic<S, 1>(draw);
  auto const s = draw_event<S, 0>(draw);
  // Cubics of cubics, differentiated up to three times.
  double const condition = 100;
  auto const p = principles_of_areal_rate(W, Phi, b, s);
  claim.zero("the variations keep the constraint", name, rate_of_constraint(Phi, Phi.r, Phi.variation(b), s),
             S(1), 10);
  claim.equal("derivative of the restriction, and of the augmented function", name, p.restricted,
              p.multiplier, condition);
  auto const lambda = Phi.multiplier(W);
  auto const rest = [&](auto const& multiplier) {
    Numbers<S, 2> const E = euler_lagrange(W, Phi.r, s);
    return Numbers<S, 2>(E - reaction(Phi, second_jet(Phi.r, s), first_jet(multiplier, s)));
  };
  // Along r, where no variation of the constraint reaches, the multiplier has to make the equations hold:
  // there is one.
  S const size = size_of(rest(sum_of(lambda, lambda, S(-1))));
  claim.zero("the multiplier is the only one: equations contracted with r", name, rest(lambda).dot(Phi.r(s)),
             size, condition);
  claim.refutes("another multiplier", name, rest(sum_of(lambda, lambda, S(1))).dot(Phi.r(s)), size);
  claim.refutes("a function of which the curve is not critical", name, rest(lambda), size);
}

// ---- A critical point of the augmented function lies on the zeros.

/// A point beside the zeros, critical in the point itself: the derivative in the multiplier keeps it out.
template <class S>
void find_the_zeros(Claim<S>& claim, Draw& draw, LevelModel<S> const& model) {
  Numbers<S, 4> const beside = model.Psi.origin + draw.vector<S, Numbers<S, 4>>(4) / S(2);
  Numbers<S, 2> const lambda = draw.vector<S, Numbers<S, 2>>(2);
  auto const slopes = model.with(model.critical_at(beside, lambda)).augmented_differential(beside, lambda);
  Numbers<S, 2> const in_multiplier = slopes.template tail<2>(), value = model.Psi(beside);
  claim.zero("beside the zeros, with h chosen: derivative in the point", level_name,
             Numbers<S, 4>(slopes.template head<4>()), S(1), level_condition);
  claim.equal("derivative in the multiplier: minus Psi in the inner product, zero on the zeros alone",
              level_name, Numbers<S, 2>(inverse_matrix(Matrix<S, 2, 2>(model.fibre(beside))) * in_multiplier),
              Numbers<S, 2>(-value), level_condition);
  claim.differs("without the inner product", level_name, in_multiplier, Numbers<S, 2>(-value));
  claim.refutes("derivative in the multiplier beside the zeros", level_name, in_multiplier, S(1));
}

// ---- Without regularity.

/// The cusp \f$y^2 = x^3\f$: x is smallest at its tip, where the derivative of the constraint vanishes.
auto const cusp = []<class T>(Numbers<T, 2> const& q) {
  return Numbers<T, 1>(q[1] * q[1] - q[0] * q[0] * q[0]);
};
/// \f$x^2 + y^2 = 0\f$: one point, which is critical for every function.
auto const isolated = []<class T>(Numbers<T, 2> const& q) {
  return Numbers<T, 1>(q[0] * q[0] + q[1] * q[1]);
};
/// A line and a parabola that touch: \f$y = 0,\ y = x^2\f$.
auto const touching = []<class T>(Numbers<T, 2> const& q) { return Numbers<T, 2>(q[1], q[1] - q[0] * q[0]); };
auto const first_coordinate = []<class T>(Numbers<T, 2> const& q) { return q[0]; };

/// Without regularity: the restriction is critical at the origin, and no multiplier makes the augmented
/// function so.
template <class S>
void refute_without_regularity(Claim<S>& claim, Draw& draw) {
  Numbers<S, 2> const origin = Numbers<S, 2>::Zero();
  auto const none = [&](auto const& f, std::string const& model) {
    constexpr int k = std::remove_cvref_t<decltype(f.constraint_derivative(origin))>::RowsAtCompileTime;
    Numbers<S, k> const lambda = draw.vector<S, Numbers<S, k>>(k);
    claim.refutes("differential of the augmented function, whatever the multiplier", model,
                  f.augmented_differential(origin, lambda), S(1));
    claim.template refuses<NotRegular>("no multiplier where the derivative is not onto", model,
                                       [&] { f.multiplier(origin); });
  };
  none(constrained<1>(first_coordinate, cusp), "cusp");
  // All zeros of the cusp are points (t^2, t^3).
  auto const slope = [&](std::string const& what, S const& at) {
    Dual<S> t(at);
    t.part[0] = S(1);
    Numbers<Dual<S>, 2> const moved(t * t, t * t * t);
    Dual<S> const constraint = cusp(moved)[0];
    claim.zero("the curve stays on the cusp, " + what, "cusp",
               Numbers<S, 2>(constraint.value, constraint.part[0]), S(1), 100);
    return first_coordinate(moved).part[0];
  };
  claim.zero("the restriction is critical at the tip", "cusp", slope("at the tip", S(0)), S(1));
  claim.refutes("the restriction is critical beside the tip", "cusp",
                slope("beside the tip", draw.number<S>() + S(2)), S(1));
  none(constrained<1>(first_coordinate, isolated), "isolated point");
  none(constrained<2>(first_coordinate, touching), "touching curves");
}

}  // namespace

STATEMENT(thm_7_1_1, "Lagrange multiplier theorem for sections of an inner product bundle") {
  claim.convention(
      "An extremum is a point where the derivative vanishes, and the derivative of $\\Psi$ is onto at "
      "$\\varphi$; without the second hypothesis, which is not named, the first statement does not imply "
      "the second, as the tip of a cusp shows. Shown for zeros in $\\R^4$ in two frames of the fibres, "
      "over the projective plane for a line bundle that is not trivial, and for curves under a constraint "
      "at each of their points, off shell for every functional of first order.");
  LevelModel<S> const model(draw);
  Numbers<S, 2> const lambda = draw.vector<S, Numbers<S, 2>>(2);
  Numbers<S, 4> const q = model.Psi.origin;

  // Second to first and back. The kernel is that of the library.
  auto const critical = model.with(model.critical_at(q, lambda));
  claim.zero("the restriction is critical where the augmented function is", level_name,
             critical.restricted_differential(q), S(1), level_condition);
  claim.zero("its multiplier is the one that was chosen", level_name,
             Numbers<S, 2>(critical.multiplier(q) - lambda), S(1), level_condition);
  auto const restricted = model.with(model.restriction_critical());
  claim.zero("the augmented function is critical where the restriction is", level_name,
             restricted.augmented_differential(q, restricted.multiplier(q)), S(1), level_condition);

  // Neither holds for another function.
  Tilted<S, 4> const any{model.c, draw.vector<S, Numbers<S, 4>>(4)};
  auto const f = model.with(any);
  claim.refutes("first statement for another function", level_name, f.restricted_differential(q), S(1));
  claim.refutes("second statement for another function", level_name,
                f.augmented_differential(q, f.multiplier(q)), S(1));
  find_the_zeros(claim, draw, model);
  change_the_frame(claim, draw, model);
  glue_over_the_projective_plane(claim, draw);
  vary_a_curve(claim, draw);
  refute_without_regularity(claim, draw);
}

STATEMENT(claim_7_1_first_to_second, "from a constrained extremum to an extremum with multiplier") {
  claim.convention(
      "The derivative of $\\Psi$ is onto at the point, and the second extremum is a point where the "
      "derivative vanishes: $\\bar h$ is affine in the multiplier and rises and falls near every point, so "
      "it has no minimum or maximum there even where $h|_{\\mathcal N}$ has one. Shown for zeros in "
      "$\\R^4$ and for curves under a constraint at each of their points; the multiplier is the only one.");
  {
    LevelModel<S> const model(draw);
    std::string const name = level_name;
    Numbers<S, 4> const q = model.Psi.origin;
    auto const h = model.restriction_critical();
    claim.zero("derivative along the zeros", name, model.along_zeros(h, q), S(1), level_condition);
    auto const f = model.with(h);
    // The normal equations square the condition of the derivative.
    Numbers<S, 2> const lambda = f.multiplier(q);
    claim.zero("derivative of the augmented function in point and multiplier", name,
               f.augmented_differential(q, lambda), S(1), 100);
    claim.refutes("with another multiplier", name,
                  f.augmented_differential(q, Numbers<S, 2>(lambda[0] + S(1), lambda[1])), S(1));

    // Along (p, s DPsi p) the second derivative is p.A.p - 2 s |DPsi p|^2: of either sign.
    Numbers<S, 4> const p = f.constraint_derivative(q).row(0).transpose();
    Numbers<S, 2> const mu = f.constraint_derivative(q) * p;
    auto const second = [&](S const& s) {
      using D = SecondOrder<S, 1>;
      D const t = D::variable(S(0), 0);
      Numbers<D, 4> moved;
      Numbers<D, 2> multiplier;
      for (int i = 0; i < 4; ++i) moved[i] = D(q[i]) + t * D(p[i]);
      for (int i = 0; i < 2; ++i) multiplier[i] = D(lambda[i]) + t * D(S(s * mu[i]));
      return f.augmented(moved, multiplier).second[0];
    };
    if (ordered_arithmetic<S>())
      claim.fact("the augmented function rises and falls near its critical point", name,
                 second(S(1000)) * second(S(-1000)) < S(0));
  }
  vary_a_curve(claim, draw);
  refute_without_regularity(claim, draw);
}

STATEMENT(claim_7_1_second_to_first, "from an extremum with multiplier to a constrained extremum") {
  claim.holds("No regularity is needed in this direction.");
  {
    LevelModel<S> const model(draw);
    std::string const name = level_name;
    Numbers<S, 2> const lambda = draw.vector<S, Numbers<S, 2>>(2);
    Numbers<S, 4> const q = model.Psi.origin;
    auto const h = model.critical_at(q, lambda);
    claim.zero("derivative in point and multiplier", name, model.with(h).augmented_differential(q, lambda),
               S(1), level_condition);
    claim.zero("derivative along the zeros", name, model.along_zeros(h, q), S(1), level_condition);

    // y = 0 and x y = 0 are dependent at the origin; the second multiplier is any number.
    auto const f =
        constrained<2>([]<class T>(Numbers<T, 2> const& p) { return T(p[0] * p[0] + p[1] * T(3)); },
                       []<class T>(Numbers<T, 2> const& p) { return Numbers<T, 2>(p[1], p[0] * p[1]); });
    Numbers<S, 2> const origin = Numbers<S, 2>::Zero(), multipliers(S(3), draw.number<S>());
    claim.zero("dependent constraints: derivative in point and multiplier", "R^2",
               f.augmented_differential(origin, multipliers), S(1));
    claim.zero("dependent constraints: derivative along their zeros, the first axis", "R^2",
               f.differential(origin)[0], S(1));
    claim.template refuses<NotRegular>("the way back, where the constraints are dependent", "R^2",
                                       [&] { f.multiplier(origin); });

    // Without the derivative in the multiplier the point need not satisfy the constraint, and over it the
    // restriction is not critical.
    Numbers<S, 4> const beside = q + Numbers<S, 4>(S(0), S(0), S(1), ratio<S>(1, 2));
    auto const off = model.critical_at(beside, lambda);
    claim.refutes("derivative along the zeros for a critical point beside them", name,
                  model.along_zeros(off, q), S(1));
    find_the_zeros(claim, draw, model);
  }
}
