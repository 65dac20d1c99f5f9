// On its leaf: the relative motions of a spinning brick, seen as points of SO(3).
//
// What is shown. A discrete Lagrangian on a group foliates the group, as far as it is regular, into surfaces
// that no discrete motion leaves: what its Legendre map sends to spheres of momentum. Each rotation is drawn
// as its rotation vector. The first picture is one leaf, made from its sphere, with ten thousand relative
// motions of the brick on it; the second a section through all leaves, out to where the Lagrangian is no
// longer regular and the leaves end. Read first. "Invariant leaves" in chapter 4.
//
//   f      relative motion g1^-1 g0           l    reduced discrete Lagrangian Tr((1 - f) Lambda)/h, J s
//   pi     body momentum -L*_f l'(f), J s     C    Tr(f Lambda f Lambda), the Casimir (5.10)
#include "actio/forms/forms.hpp"
#include "actio/groupoid/poisson_on_group.hpp"
#include "actio/groups/rotations.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"

using namespace actio;
using Vector3d = actio::Vector<double, 3>;
using Rotation = Element<SO<3>, double>;

// The trace Lagrangian of a body with moments of inertia 2.4, 1.9 and 1.1: an action, in J s.
struct Brick {
  Vector3d lambda{0.3, 0.8, 1.6};
  double h = 1;
  template <class S>
  S operator()(Element<SO<3>, S> const& f) const {
    S sum(0);
    for (int i = 0; i < 3; ++i) sum += (S(1) - f.value(i, i)) * S(lambda[i]);
    return sum / S(h);
  }
  template <class S>
  S casimir(Element<SO<3>, S> const& f) const {
    auto const m = (f.value * lambda.template cast<S>().asDiagonal()).eval();
    return (m * m).eval().trace();
  }
};
Rotation rotation(Vector3d const& v) { return exp(velocity(SO<3>{}, v)); }
Brick const brick;
double const rest = std::pow(brick.lambda.norm(), 2);  // C at the identity

// The distance from the identity along a direction at which `value` changes its sign.
template <class F>
double first_change(Vector3d const& direction, F const& value) {
  double const start = value(rotation(1e-3 * direction));
  for (double r = 0.01; r < 3.1; r += 0.01)
    if (value(rotation(r * direction)) * start < 0) {
      double low = r - 0.01, high = r;
      for (int k = 0; k < 50; ++k)
        (value(rotation((low + high) / 2 * direction)) * start < 0 ? high : low) = (low + high) / 2;
      return low;
    }
  return NAN;
}
// A point of a picture: the ball of rotation vectors, looked at a little from above.
struct Projected {
  std::vector<double> x, y;
  void add(Vector3d const& p) {
    x.push_back(0.8 * p[0] - 0.6 * p[1]), y.push_back(0.9 * p[2] - 0.26 * p[0] - 0.35 * p[1]);
  }
};
struct Motion {
  Projected seen;
  double radius, worst = 0;
};
constexpr int steps = 10000;

// 1. The brick spins, near its middle axis. Its relative motions, and how far they leave C.
Motion spin() {
  auto f = rotation({-0.08, -0.55, -0.05});
  double const level = brick.casimir(f);
  Motion motion{.seen = {}, .radius = momentum_before_left(brick, f).components.norm()};
  for (int k = 0; k < steps; ++k) {
    if (k < 200) motion.seen.add(log(f).coordinates);
    f = step_euler_poincare_left(brick, f).value;
    motion.worst = std::max(motion.worst, std::abs(brick.casimir(f) - level) / (rest - level));
  }
  return motion;
}

// The relative motions that belong to a circle of momenta.
template <class Point>
void draw_circle(book::Plot& leaf, double radius, Point const& point) {
  Projected curve;
  auto near = rotation(-0.2 * point(0.0));
  for (int j = 0; j <= 120; ++j) {
    double const angle = 2 * M_PI * j / 120;
    auto const pi = momentum(SO<3>{}, Vector3d(radius * point(angle)));
    near = relative_motion_from_momentum_left(brick, pi, near).value;
    curve.add(log(near).coordinates);
  }
  leaf.curve(curve.x, curve.y, "", {.colour = 5, .width = 0.7});
}

// 2. The leaf: the relative motions that belong to a sphere of momenta, along circles of latitude and
//    longitude.
void draw_leaf(book::Program& program, Motion const& motion) {
  book::Plot leaf("", "");
  leaf.equal().size(620, 520);
  for (int k = 0; k < 6; ++k) {
    double const c = std::cos(k * M_PI / 6), s = std::sin(k * M_PI / 6);
    double const height = -0.83 + 0.333 * k, wide = std::sqrt(1 - height * height);
    auto const meridian = [&](double a) { return Vector3d(c * std::cos(a), s * std::cos(a), std::sin(a)); };
    auto const parallel = [&](double a) { return Vector3d(wide * std::cos(a), wide * std::sin(a), height); };
    draw_circle(leaf, motion.radius, meridian), draw_circle(leaf, motion.radius, parallel);
  }
  leaf.dots(motion.seen.x, motion.seen.y, "relative motions of the brick", {.colour = 2});
  program.picture("leaf", leaf.svg(),
                  "A leaf in SO(3), drawn in rotation vectors, and two hundred relative motions in a row.");
}

// How far the Lagrangian is regular along a direction: as far as its second derivative has an inverse.
double edge(Vector3d const& direction) {
  auto const regularity = [](Rotation const& g) { return determinant(left_second_differential(brick, g)); };
  return first_change(direction, regularity);
}

// A curve around the identity, at a distance given for each direction.
template <class Distance>
void draw_around(book::Plot& section, Distance const& distance, std::string const& name, int colour,
                 double width) {
  std::vector<double> x, y;
  for (int j = 0; j <= 240; ++j) {
    double const a = 2 * M_PI * j / 240;
    Vector3d const direction(std::cos(a), 0, std::sin(a));
    double const r = distance(direction);
    x.push_back(r * direction[0]), y.push_back(r * direction[2]);
  }
  section.curve(x, y, name, {.colour = colour, .width = width});
}

// 3. A section through the leaves: rotations about axes in one plane. Where the second derivative of l has no
//    inverse they end.
void draw_section(book::Program& program) {
  book::Plot section("rotation about the first axis", "rotation about the third axis");
  section.equal().size(620, 520);
  for (int k = 1; k <= 6; ++k) {
    double const c = rest - 0.35 * k * k * (rest / 12);
    auto const as_far_as_it_goes = [&](Vector3d const& d) {
      double const r = first_change(d, [&](Rotation const& g) { return brick.casimir(g) - c; });
      return r < edge(d) ? r : NAN;
    };
    draw_around(section, as_far_as_it_goes, k == 1 ? "leaves" : "", 1, 1);
  }
  draw_around(section, edge, "no longer regular", 3, 2);
  program.picture("section", section.svg(),
                  "A section through the leaves, out to where the Lagrangian is no longer regular.");
}

// The nearest and the farthest edge over the directions of the section.
std::pair<double, double> edges() {
  double nearest = HUGE_VAL, farthest = 0;
  for (int j = 0; j < 240; ++j) {
    double const a = 2 * M_PI * j / 240, r = edge(Vector3d(std::cos(a), 0, std::sin(a)));
    nearest = std::min(nearest, r), farthest = std::max(farthest, r);
  }
  return {nearest, farthest};
}

// 4. What must be so. About a principal axis the momentum is I sin(angle)/h: it ends at a quarter of a turn,
//    and no rotation by less is singular.
void claim_what_must_be_so(book::Program& program, Motion const& motion) {
  double const quarter = edge(Vector3d(0, 0, 1));
  program.claim(book::measured(motion.worst) < 20 * steps * 0x1p-52,
                "the relative motions stay on the leaf to rounding");
  program.claim(book::measured(std::abs(quarter - M_PI / 2)) < 1e-12,
                "about a principal axis the structure ends at a quarter of a turn");
  auto const [nearest, farthest] = edges();
  program.claim(book::measured(M_PI / 2 - nearest) < 1e-12,
                "and about no axis of the section before a quarter of a turn");
  auto const at = rotation({-0.3, 0.2, 0.4});
  Matrix<double, 3, 3> const bracket = legendre_bivector_left(brick, at);
  program.claim(matrix_rank(bracket) == 2, "the bracket has rank 2: the leaves are surfaces");
  auto const slope = right_differential([](auto const& g) { return brick.casimir(g); }, at).components;
  double const differential = (bracket * slope).norm() / bracket.norm();
  program.claim(book::measured(differential) < 1e-14, "C has no bracket with anything");
  program.figure(
      "kept", motion.worst,
      "change of C along ten thousand steps, relative to its distance from the value at the identity");
  program.figure("bracket_of_C", differential, "bracket of C with any function, relative");
  program.figure("edge", quarter * 180 / M_PI, book::number(quarter * 180 / M_PI, 4) + "°",
                 "rotation about a principal axis at which the structure ends");
  program.figure("farthest", farthest * 180 / M_PI, book::number(farthest * 180 / M_PI, 4) + "°",
                 "largest rotation about an axis of the section up to which the structure reaches");
}

int main(int argc, char** argv) {
  book::Program program(
      argc, argv, "relative motions of a brick stay on a surface in SO(3), the leaf of a Poisson structure");
  auto const motion = spin();
  draw_leaf(program, motion);
  draw_section(program);
  claim_what_must_be_so(program, motion);
  program.headline("10 000 steps stay on their leaf to " + book::number(motion.worst, 2), motion.worst);
  return program.finish();
}
