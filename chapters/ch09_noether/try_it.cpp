// The lines to try of chapters 9 and 10: symmetries of a medium, Noether's identity, circulation; reciprocity
// and Newmark's scheme.

#include "actio/noether/circulation.hpp"
#include "actio/noether/current_divergence.hpp"
#include "actio/noether/relabelling.hpp"
#include "actio/noether/time_translation.hpp"
#include "actio/numbers/print.hpp"
#include "book/try_it.hpp"
#include "momentum_map_forms.hpp"
#include "two_media.hpp"

using namespace actio;

TRY_IT(moved_jet) {
  auto const phi = motion_of(cloud, 0.0);       // the gas of chapter 6, thrown
  auto const eta = relabelling<2>(Squeeze{2});  // (t, X^1, X^2) -> (t, 2 X^1, X^2/2), places stay
  auto const back = relabelling<2>(Squeeze{0.5}).base;
  Event<double, 2> const x(0.0, 0.2, 0.1);
  print("jet of the moved section", first_jet(moved_section(eta, back, phi), eta.base(x)).v);
  print("prolongation of the jet, (9.2)", prolongation(eta, first_jet(phi, x)).v);
}

TRY_IT(symmetry) {
  auto const j = first_jet(motion_of(cloud, 0.0), Event<double, 2>(0.0, 0.2, 0.1));
  auto const defect = [&](auto const& medium, auto const& eta) {
    return equivariance_defect(medium, relabelling<2>(eta), j);
  };
  print("gas, labels squeezed", defect(uniform_gas, Squeeze{2}));
  print("gas, labels stretched", defect(uniform_gas, Stretched{2}));
  print("rubber, labels squeezed", defect(uniform_rubber, Squeeze{2}));
  print("rubber, labels turned", defect(uniform_rubber, QuarterTurn{}));
}

TRY_IT(off_shell) {
  auto const phi = [](auto const& x) {  // a section that solves nothing
    using T = decltype(x[0] * 1.0);
    return Matrix<T, 2, 1>(x[1] + x[0] * x[2], x[2] * 2.0 + x[0] * x[0] * x[1]);
  };
  auto const xi = [](auto const& p) {  // at p = (t, x1, x2, y1, y2) of Y; no symmetry
    using Point = std::remove_cvref_t<decltype(p)>;
    return Point(p[0] * p[1], p[2] * p[2], p[0] + p[1], p[3] * p[4], p[1] - p[4]);
  };
  auto const j = second_jet(phi, Event<double, 2>(0.3, 0.2, 0.1));
  Jet<double, 2, 2> const& first = j;
  print("divergence of the current", current_divergence(uniform_gas, xi, j));
  double const r = equivariance_rate(uniform_gas, xi, first);
  print("r - E q", r + noether_identity(uniform_gas, xi, j));
  print("-E q alone", noether_identity(uniform_gas, xi, j));
}

TRY_IT(kelvin) {
  auto const loop = [](auto const& a) {  // a circle of particles about X = (0.2, 0.1)
    using std::cos, std::sin;
    return Matrix<decltype(a * 1.0), 2, 1>(0.2 + 0.5 * cos(a), 0.1 + 0.5 * sin(a));
  };
  auto const along = [&](auto const& body, double t) {
    return circulation(motion_of(body, t), Euclidean<2>{}, loop, t);
  };
  for (double const t : {0.0, 0.5, 1.0})
    print("gas, rubber, rubber with fibres",
          Vector<double, 3>(along(cloud, t), along(rubber, t), along(fibred_rubber, t)));
}

TRY_IT(masses_preserved) {
  auto const j = second_jet(motion_of(cloud, 0.4), Event<double, 2>(0.4, 0.2, 0.3));
  auto const A = [](auto const& X) { return Matrix<decltype(X[0] * 1.0), 1, 1>(X[0] * X[0] * X[1]); };
  auto const keeping = [&](auto const& metric) {
    auto const xi = relabelling_field<2>(RelabellingField{metric, A});
    return current_divergence(cloud.medium(), xi, j);
  };
  print("the field preserves areas of the body", keeping(Euclidean<2>{}));
  print("the field preserves masses", keeping(MassAsArea{}));
}

TRY_IT(forms) {
  auto const phi = motion_of(cloud, 0.0);
  auto const at = coordinates(first_jet(phi, Event<double, 2>(0.0, 0.2, 0.1)));
  auto const V = some_vectors<11, 3>();
  auto const turned = relabelling_field<2>(QuarterTurn{});  // X -> (-X^2, X^1), as a field
  auto const pulled = [](auto const& p) { return std::remove_cvref_t<decltype(p)>(0, 0, 0, p[3], p[4]); };
  print("(9.4), labels turned", momentum_map_defect<2, 2>(cloud.medium(), turned, at, V));
  print("(9.4), places pulled", momentum_map_defect<2, 2>(cloud.medium(), pulled, at, V));
}

TRY_IT(moved_action) {
  auto const phi = motion_of(cloud, 0.0);
  Box<double, 2> const box{{0, 0, 0}, {0.1, 0.2, 0.4}}, squeezed{{0, 0, 0}, {0.1, 0.4, 0.2}};
  auto const left = [&](auto const& eta, auto const& back, auto const& region) {
    auto const moving = relabelling<2>(eta);
    return action_defect(uniform_gas, moving, relabelling<2>(back).base, phi, box, region, 15);
  };
  print("labels squeezed, the box with them", left(Squeeze{2}, Squeeze{0.5}, squeezed));
  print("labels squeezed, the box left", left(Squeeze{2}, Squeeze{0.5}, box));
}

TRY_IT(energy) {
  auto const leak = [](auto const& body, auto const& motion) {
    auto const j = second_jet(motion, Event<double, 2>(0.4, 0.2, 0.3));
    return current_divergence(body.medium(), TimeTranslation{}, j);
  };
  print("gas", leak(cloud, motion_of(cloud, 0.4)));
  print("rubber with fibres", leak(fibred_rubber, motion_of(fibred_rubber, 0.4)));
  print("the same in the motion of the gas", leak(fibred_rubber, motion_of(cloud, 0.4)));
}

TRY_IT(betti) {
  auto const field = [](double a, double b, double c) {  // displacements (a x^2 + b y^2, c x y)
    return [a, b, c](auto const& x) {
      auto const first = x[1] * x[1] * a + x[2] * x[2] * b;
      return Matrix<decltype(x[0] * 1.0), 2, 1>(first, x[1] * x[2] * c);
    };
  };
  auto const rest = [](auto const& x) { return Matrix<decltype(x[0] * 1.0), 2, 1>(x[1], x[2]); };
  auto const flux = [&](auto const& V, auto const& W) {
    auto const current = [&](Event<double, 2> const& x) {
      auto const j = first_jet(rest, x);
      return multisymplectic_current(uniform_rubber, j, first_jet(V, x), first_jet(W, x));
    };
    Box<double, 2> const box{{0, 0, 0}, {1, 1, 2}};
    return boundary_integral(flux_form(current), box, 8);
  };
  print("two equilibria", flux(field(1, -4, 0), field(0, 3, -2)));
  print("one equilibrium, one that needs a force inside", flux(field(1, 0, 0), field(0, 3, -2)));
}

TRY_IT(newmark) {
  double const h = 0.1, beta = 0.25;
  auto const a = [](double q) { return -q - q * q * q; };  // acceleration in V = q^2/2 + q^4/4
  double q[3] = {1, 0, 0}, v = 0;
  for (int k = 0; k < 2; ++k) {  // two steps of Newmark's scheme, the implicit equation by iteration
    q[k + 1] = q[k];
    for (int i = 0; i < 50; ++i)
      q[k + 1] = q[k] + h * v + h * h * ((0.5 - beta) * a(q[k]) + beta * a(q[k + 1]));
    v += h / 2 * (a(q[k]) + a(q[k + 1]));
  }
  auto const z = [&](int k) { return q[k] - beta * h * h * a(q[k]); };
  print("second difference of z", z(2) - 2 * z(1) + z(0));
  print("h^2 times the acceleration", h * h * a(q[1]));
}

TRY_IT_MAIN("the lines to try of chapters 9 and 10: symmetries, Noether's identity, circulation, reciprocity")
