// The Cartan form from the boundary of a varied action: what theorem 6.2.1 says, on a gas that spreads into
// empty space.
//
// What is shown. Vary the action on a box of space-time, with dual numbers and nothing else. On an exact
// solution all that is left of its derivative is an integral over the boundary of the box, that of the Cartan
// form; for variations that move space-time too, only if the form has its last term. On a motion that solves
// nothing the rest is the integral of the Euler-Lagrange derivative inside. And two first variations of the
// solution have no flux through the boundary. Read first. gas_ellipse.
//
// Compiled at -O2: it takes many steps.
#include <array>

#include "actio/jets/prolongation.hpp"
#include "actio/jets/tilted_section.hpp"
#include "book/plot.hpp"
#include "first_variations.hpp"

using namespace actio;
using book::measured, book::number;

// 1. The cloud, a box of space-time within it, and a variation that moves everything.
constexpr int nodes = 14;  // of Gauss's rule along each side

EllipticGas const gas{0.2, 1.4};
auto const medium = gas.medium();
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
  double residual() const { return derivative - inside - boundary; }
  double relative(double rest) const { return std::abs(rest / boundary); }  // over the boundary integral
};
template <class Phi, class V>
Terms terms(Phi const& phi, V const& field, int count) {
  int const degree = 2 * count - 1;
  auto const E_on_vertical = [&](Event<double, 2> const& x) {
    auto const jet = second_jet(phi, x);
    return euler_lagrange(medium, jet)
        .dot(vertical_part<double, 2, 2>(jet, field(point_of<double, 2, 2>(jet))));
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

// 4. The theorem: a solution of which places alone vary, the same of which space-time varies, too, and a
// motion that solves nothing.
std::array<Terms, 3> show_the_theorem(book::Program& program) {
  std::array const found{terms(solution(), variation(0, 1), nodes), terms(solution(), variation(1, 1), nodes),
                         terms(pushed_about(), variation(1, 1), nodes)};
  std::array const names{"solution, places vary", "solution, space-time too", "pushed about, space-time too"};
  std::vector<book::Program::Row> rows;
  for (std::size_t i = 0; i < found.size(); ++i) {
    Terms const& t = found[i];
    rows.push_back({names[i], number(t.derivative, 6), number(t.inside, 3), number(t.boundary, 6),
                    number(t.without_last, 6), number(std::abs(t.residual()), 2)});
  }
  program.table("terms",
                {"motion and variation", "dS", "inside", "boundary", "without its last term", "residual"},
                rows,
                "The derivative of the action on a box of space-time, the integral of the Euler-Lagrange "
                "derivative inside, and that of the Cartan form over the boundary.");
  return found;
}

// 5. How the two sides meet as the rule of quadrature gets better.
void show_quadrature(book::Program& program, double scale) {
  std::vector<double> counts, misses;
  for (int count = 2; count <= nodes; count += 2) {
    auto const t = terms(solution(), variation(1, 1), count);
    counts.push_back(count), misses.push_back(std::abs((t.derivative - t.boundary) / scale));
  }
  auto plot = book::Plot("nodes of Gauss's rule along a side", "relative difference").log_y();
  plot.curve(counts, misses, "derivative of the action less boundary integral", {.width = 1.8});
  program.picture("nodes", plot.svg(),
                  "Both sides of the theorem are integrals: they meet as the rule of "
                  "quadrature gets better, to rounding.");
}

// 6. The flux of a first variation and of another field through the boundary of the box.
template <class Field>
double flux_with(Field const& field) {
  return std::abs(flux(medium, solution(), neighbour(gas, middle, 1), field, box, 2 * nodes - 1));
}

int main(int argc, char** argv) {
  book::Program program(
      argc, argv, "the action of a spreading gas is varied: what is left on the boundary is the Cartan form");
  auto const [places, all, wrong] = show_the_theorem(program);
  show_quadrature(program, all.boundary);

  double const theorem = all.relative(all.derivative - all.boundary),
               missing = all.relative(all.derivative - all.without_last),
               vertical = places.relative(places.derivative - places.without_last),
               off = wrong.relative(wrong.inside), whole = wrong.relative(wrong.residual());
  program.figure("theorem", theorem,
                 "solution, all varied: derivative of the action less boundary integral, relative");
  program.figure("missing", missing, "the same with the form that vertical variations give");
  program.figure("vertical", vertical, "that form where places alone vary");
  program.figure("off", off, "pushed about: what is inside, over the boundary integral");
  program.figure("whole", whole, "pushed about: derivative less inside less boundary, relative");

  auto const no_first_variation = []<class X>(X const& x) {
    return Matrix<typename X::Scalar, 2, 1>(x[1] * x[2], x[0] * x[1] - x[2]);
  };
  double const kept = flux_with(neighbour(gas, middle, 2)), lost = flux_with(no_first_variation);
  program.figure("flux", kept, "flux of two neighbouring ellipses through the boundary");
  program.figure("flux_lost", lost, "the same with one that is no first variation");

  program.claim(measured(theorem) < 1e-12 && measured(whole) < 1e-12,
                "derivative of the action = inside + boundary, to rounding");
  program.claim(measured(vertical) < 1e-12 && measured(missing) > 1e-2,
                "vertical variations see all of the Cartan form but its last term");
  program.claim(measured(off) > 1e-2, "a motion that solves nothing has something inside");
  program.claim(measured(kept) < 1e-12 && measured(lost) > 1e-3,
                "two first variations have no flux through the boundary");
  program.headline("derivative of the action equals the boundary integral to " + number(theorem, 2), theorem);
  return program.finish();
}
