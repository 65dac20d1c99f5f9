// The Cartan form from the boundary of a varied action: what theorem 6.2.1 says, on a gas that spreads into
// empty space.
//
// What is shown. Vary the action on a box of space-time, with dual numbers and nothing else. On an exact
// solution all that is left of its derivative is an integral over the boundary of the box, that of the Cartan
// form; for variations that move space-time too, only if the form has its last term. On a motion that solves
// nothing the rest is the integral of the Euler-Lagrange derivative inside. And two first variations of the
// solution have no flux through the boundary. Read first. gas_ellipse.
#include "actio/jets/cartan.hpp"
#include "actio/jets/prolongation.hpp"
#include "actio/jets/tilted_section.hpp"
#include "book/plot.hpp"
#include "gas_ellipse.hpp"
#include "witness/draw.hpp"

using namespace actio;

// 1. The cloud, a box of space-time within it, and a variation that moves everything.
constexpr int nodes = 14;  // of Gauss's rule along each side

EllipticGas const gas{0.2, 1.4};
Box<double, 2> const box{{0.02, -0.45, -0.3}, {0.22, 0.35, 0.4}};
double const middle = 0.12;  // of the time of the box: the power series of the motion starts there

// The horizontal components times `across`, the vertical ones times `upward`.
auto variation(double across, double upward) {
  return [=]<class T>(Matrix<T, 5, 1> const& at) {
    T const t = at[0], x1 = at[1], x2 = at[2], y1 = at[3], y2 = at[4];
    Matrix<T, 5, 1> V;
    V << (x1 * x2 + t * 0.5 + 0.2) * across, (x2 - x1 * x1 + t) * across, (t * x1 + 0.3) * across,
        (y1 * y2 + t * x1 * 2.0 + 0.4) * upward, (y2 - y1 * y1 * t + x2) * upward;
    return V;
  };
}

// 2. Two motions: the cloud as it moves, and one that is pushed about and solves nothing.
auto solution() { return linear_motion<2>(gas, thrown_gas(), middle); }
auto pushed_about() {
  return [phi = solution()]<class V>(V const& x) {
    auto y = phi(x);
    y[0] += x[0] * x[0] * x[2] * 2.0, y[1] += x[1] * x[1] * 0.5;
    return y;
  };
}

// 3. The three terms of (6.7), and the boundary integral of the form without its last term.
struct Terms {
  double derivative, inside, boundary, without_last;
};
template <class Phi, class V>
Terms terms(Phi const& phi, V const& field, int count) {
  auto const medium = gas.medium();
  int const degree = 2 * count - 1;
  auto const E_on_vertical = [&](Event<double, 2> const& x) {
    Matrix<double, 5, 1> at;
    at << x, phi(x);
    auto const jet = second_jet(phi, x);
    return euler_lagrange(medium, jet).dot(vertical_part<double, 2, 2>(jet, field(at)));
  };
  auto const contracted = [&](auto const& form) {
    return pull_back(jet_extension(phi), contract(prolonged<2, 2>(field), form));
  };
  // The form as far as vertical variations fix it: p dy ^ d^2x_mu.
  auto const vertical_form = [&]<class S, int D>(Matrix<S, D, 1> const& at, Tangents<S, D, 3> const& T) -> S {
    return affine_form<2, 2>(momenta(medium, jet_at<2, 2>(at)), S(0), at, T);
  };
  auto const Theta = cartan_form<2, 2>(medium);
  // [eq_6_7]
  double const dS = action_variation(medium, phi, field, box, degree);
  double const inside = integral(E_on_vertical, box.low, box.high, degree);
  double const boundary = boundary_integral(contracted(Theta), box, degree);
  // [eq_6_7]
  return {dS, inside, boundary, boundary_integral(contracted(vertical_form), box, degree)};
}

// 4. A first variation: the rate at which the cloud changes with its state at the start.
LinearMotion<double, 2> neighbour(std::uint64_t seed) {
  Draw draw(seed);
  auto state = thrown_gas().cast<Dual<double>>().eval();
  for (auto& s : state) s.part[0] = draw.number<double>();
  // The series of a dual motion: its rates of change are a linear motion again.
  LinearMotion<double, 2> variation{middle, {}};
  for (auto const& term : linear_motion<2>(gas, state, middle).terms)
    variation.terms.emplace_back(term.unaryExpr([](Dual<double> const& a) { return a.part[0]; }));
  return variation;
}

// 5. The flux of two variations through the boundary of the box, an integral of the multisymplectic form.
template <class FieldV, class FieldW>
double flux(FieldV const& V, FieldW const& W) {
  auto const medium = gas.medium();
  auto const phi = solution();
  auto const form = multisymplectic_form<2, 2>(medium);
  // A vertical variation along the solution as a tangent vector of the jet bundle: no change of x, its own
  // value and slopes.
  auto const lifted = [](auto const& variation, auto const& x) {
    auto jet = first_jet(variation, x);
    jet.x.setZero();
    return coordinates(jet);
  };
  auto const pulled_back_form = [&](Event<double, 2> const& x, Tangents<double, 3, 2> const& sides) {
    Tangents<double, 11, 4> T;
    // W is contracted first, so it stands in the first slot.
    T << lifted(W, x), lifted(V, x), pushed(jet_extension(phi), x, sides);
    return form(coordinates(first_jet(phi, x)), T);
  };
  // [eq_6_11]
  return boundary_integral(pulled_back_form, box, 2 * nodes - 1);
  // [eq_6_11]
}

// 6. The theorem: a solution of which places alone vary, the same of which space-time varies, too, and a
// motion that solves nothing.
struct Compared {
  Terms places, all, wrong;
};
Compared compare(book::Program& program) {
  std::vector<book::Program::Row> rows;
  auto const show = [&](std::string const& name, Terms const& t) {
    rows.push_back({name, book::number(t.derivative, 6), book::number(t.inside, 3),
                    book::number(t.boundary, 6), book::number(t.without_last, 6),
                    book::number(std::abs(t.derivative - t.inside - t.boundary), 2)});
    return t;
  };
  auto const places = show("solution, places vary", terms(solution(), variation(0, 1), nodes));
  auto const all = show("solution, space-time too", terms(solution(), variation(1, 1), nodes));
  auto const wrong = show("pushed about, space-time too", terms(pushed_about(), variation(1, 1), nodes));
  program.table("terms",
                {"motion and variation", "dS", "inside", "boundary", "without its last term", "residual"},
                rows,
                "The derivative of the action on a box of space-time, the integral of the Euler-Lagrange "
                "derivative inside, and that of the Cartan form over the boundary.");
  return {places, all, wrong};
}

// 7. How the two sides meet as the rule of quadrature gets better.
void show_quadrature(book::Program& program, double scale) {
  std::vector<double> counts, misses;
  for (int count = 2; count <= nodes; count += 2) {
    auto const t = terms(solution(), variation(1, 1), count);
    counts.push_back(count), misses.push_back(std::abs((t.derivative - t.boundary) / scale));
  }
  program.picture(
      "nodes",
      book::Plot("nodes of Gauss's rule along a side", "relative difference")
          .log_y()
          .curve(counts, misses, "derivative of the action less boundary integral", {.width = 1.8})
          .svg(),
      "Both sides of the theorem are integrals: they meet as the rule of quadrature gets better, to "
      "rounding.");
}

int main(int argc, char** argv) {
  book::Program program(
      argc, argv, "the action of a spreading gas is varied: what is left on the boundary is the Cartan form");
  auto const [places, all, wrong] = compare(program);
  show_quadrature(program, all.boundary);

  double const theorem = std::abs((all.derivative - all.boundary) / all.boundary),
               missing = std::abs((all.derivative - all.without_last) / all.boundary);
  double const vertical = std::abs((places.derivative - places.without_last) / places.boundary),
               off = std::abs(wrong.inside / wrong.boundary);
  double const whole = std::abs((wrong.derivative - wrong.inside - wrong.boundary) / wrong.boundary);
  program.figure("theorem", theorem,
                 "solution, all varied: derivative of the action less boundary integral, relative");
  program.figure("missing", missing, "the same with the form that vertical variations give");
  program.figure("vertical", vertical, "that form where places alone vary");
  program.figure("off", off, "pushed about: what is inside, over the boundary integral");
  program.figure("whole", whole, "pushed about: derivative less inside less boundary, relative");

  auto const random = [](auto const& x) {
    return Matrix<typename std::remove_cvref_t<decltype(x)>::Scalar, 2, 1>(x[1] * x[2], x[0] * x[1] - x[2]);
  };
  double const kept = std::abs(flux(neighbour(1), neighbour(2))), lost = std::abs(flux(neighbour(1), random));
  program.figure("flux", kept, "flux of two neighbouring ellipses through the boundary");
  program.figure("flux_lost", lost, "the same with one that is no first variation");

  program.claim(book::measured(theorem) < 1e-12 && book::measured(whole) < 1e-12,
                "derivative of the action = inside + boundary, to rounding");
  program.claim(book::measured(vertical) < 1e-12 && book::measured(missing) > 1e-2,
                "vertical variations see all of the Cartan form but its last term");
  program.claim(book::measured(off) > 1e-2, "a motion that solves nothing has something inside");
  program.claim(book::measured(kept) < 1e-12 && book::measured(lost) > 1e-3,
                "two first variations have no flux through the boundary");
  program.headline("derivative of the action equals the boundary integral to " + book::number(theorem, 2),
                   theorem);
  return program.finish();
}
