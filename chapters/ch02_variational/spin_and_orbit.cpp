// A spinning book: reduction seen from inside the book and from outside.
//
// What is shown. A free body does not care which way it points, so its motion closes in the algebra
// (Euler-Poincaré, 2.2.1). Seen from the book the momentum wanders, but never leaves its coadjoint orbit, a
// sphere, nor its level of the energy: it runs along the curve where the two meet. Seen from space the
// momentum does not move at all. Read first. The section "When the group is its own symmetry" of chapter 2.
//
//   R      attitude in SO(3), body to space            L     Lagrangian on TG, J
//   Omega  body velocity R^-1 R', 1/s                  l     the same on the algebra, a function of Omega
//   Pi     body momentum dl/dOmega, J s                mu    spatial momentum, Pi = Ad*_R mu
//   h      step of the Runge-Kutta method, s           I     moments of inertia, kg m^2
#include "actio/groups/rotations.hpp"
#include "actio/variational/euler_lagrange.hpp"
#include "actio/variational/euler_poincare.hpp"
#include "book/plot.hpp"
#include "book/sphere.hpp"

using namespace actio;
using Matrix3d = actio::Matrix<double, 3, 3>;
using Vector3d = actio::Vector<double, 3>;

// A motion on the reduced road: where the book is and how it turns, in the body frame. Linear, so that
// Runge-Kutta can add.
struct Motion {
  Matrix3d R;
  Vector3d Omega;
  Motion operator+(Motion const& b) const { return {R + b.R, Omega + b.Omega}; }
};
Motion operator*(double s, Motion const& a) { return {s * a.R, s * a.Omega}; }

// One step of the classical Runge-Kutta method: here just a good enough approximation of the flow.
template <class Rate, class X>
X runge_kutta(Rate const& rate, X const& x, double h) {
  X const k1 = rate(x), k2 = rate(x + h / 2 * k1), k3 = rate(x + h / 2 * k2), k4 = rate(x + h * k3);
  return x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
}

// 1. The book: 24 cm high, 17 cm wide, 3 cm thick, 0.8 kg. Axis 1 along the height, 2 across, 3 through the
//    pages.
Vector3d moments_of_inertia() {
  Vector3d const edge(0.24, 0.17, 0.03);
  double const mass = 0.8;
  return mass / 12 * (Vector3d::Constant(edge.squaredNorm()) - edge.cwiseAbs2());
}
Vector3d const I = moments_of_inertia();
double const p = 12 * I[1], h = 1.25e-4, duration = 4;  // 12 radians a second, were it about the middle axis

// 2. Its Lagrangian on the algebra, at every scalar, and the same one on TG.
auto const l = [](auto const& Omega) {
  auto const& w = Omega.coordinates;
  return (w[0] * w[0] * I[0] + w[1] * w[1] * I[1] + w[2] * w[2] * I[2]) / 2.0;
};
auto const L = left_invariant(l);
auto body(Vector3d const& w) { return velocity(SO<3>{}, w); }
auto Pi_of(Motion const& m) { return gradient(l, body(m.Omega)); }
auto mu_of(Motion const& m) { return Ad_star(inverse(Element<SO<3>, double>{{}, m.R}), Pi_of(m)); }

// 3. Three equations of motion: Euler-Poincaré in the algebra with R reconstructed; the same with the sign of
//    right-invariant systems, as a control; and Euler-Lagrange on TG, which uses no symmetry.
Motion reduced(Motion const& m) {
  return {m.R * SO<3>::hat(m.Omega), euler_poincare_acceleration_left(l, body(m.Omega)).coordinates};
}
Motion wrong_side(Motion const& m) {
  return {m.R * SO<3>::hat(m.Omega), euler_poincare_acceleration_right(l, body(m.Omega)).coordinates};
}
Motion unreduced(Motion const& m) {  // here the velocity is translated to the identity on the right, as on TG
  State<SO<3>, double> const state{{{}, m.R}, body(m.Omega)};
  return {SO<3>::hat(m.Omega) * m.R, lagrange_acceleration(L, state).coordinates};
}

// 4. Throw the book with one and the same amount of momentum along many directions, and follow the momentum
//    in the book. What should be conserved, and its largest change over all throws.
struct Lost {
  double orbit = 0, energy = 0, space = 0;
};

// One throw: the path of the momentum in the book.
std::vector<Vector3d> follow(Vector3d const& direction, Lost& off) {
  Vector3d const start = p * direction.normalized();
  Motion m{Matrix3d::Identity(), start.cwiseQuotient(I)};
  double const energy = l(body(m.Omega));
  std::vector<Vector3d> path{start};
  bool away = false, closed = false;  // one time round will do for the picture
  for (int k = 0; k * h < duration; ++k) {
    m = runge_kutta(reduced, m, h);
    Vector3d const Pi = Pi_of(m).components;
    away = away || (Pi - start).norm() > 0.1 * p;
    if (k % 8 == 0 && !closed) {
      closed = away && (Pi - start).norm() < 0.02 * p;
      path.push_back(closed ? start : Pi);
    }
    off.orbit = std::max(off.orbit, std::abs(Pi.norm() / p - 1));
    off.energy = std::max(off.energy, std::abs(l(body(m.Omega)) / energy - 1));
    off.space = std::max(off.space, (mu_of(m).components - start).norm() / p);
  }
  return path;
}

// All sixteen throws, drawn on the sphere.
Lost throw_all_ways(book::Sphere& sphere) {
  Lost off;
  for (double const sign : {1.0, -1.0})
    for (double const tilt : {0.2, 0.5, 1.0, 2.0}) {
      sphere.curve(follow({sign, tilt, 0}, off),
                   sign > 0 && tilt < 0.3 ? "round the axis of the smallest moment" : "", {.colour = 2});
      sphere.curve(follow({0, tilt, sign}, off),
                   sign > 0 && tilt < 0.3 ? "round the axis of the largest moment" : "", {.colour = 1});
    }
  return off;
}

// 5. Where the energy is that of the middle axis the level splits the sphere: two great circles through that
//    axis.
void draw_separatrix(book::Sphere& sphere) {
  for (double const sign : {1.0, -1.0}) {
    Vector3d const across =
        Vector3d(std::sqrt(1 / I[1] - 1 / I[2]), 0, sign * std::sqrt(1 / I[0] - 1 / I[1])).normalized();
    std::vector<Vector3d> circle;
    for (int k = 0; k <= 360; ++k)
      circle.push_back(std::cos(k * M_PI / 180) * Vector3d::UnitY() + std::sin(k * M_PI / 180) * across);
    sphere.curve(circle, sign > 0 ? "separatrix, through the middle axis" : "", {.colour = 4, .width = 2.2});
  }
}

// 6. A throw about the middle axis, a hundredth off, along all three equations at once.
struct Flip {
  std::vector<double> time;
  std::array<std::vector<double>, 3> inside, outside;
  double apart = 0, wrong_space = 0, lowest = p;
};
Flip throw_about_middle_axis() {
  Motion m{Matrix3d::Identity(), (p * Vector3d(0.01, 1, 0.01).normalized()).cwiseQuotient(I)}, wrong = m,
                                                                                               whole = m;
  Vector3d const thrown = mu_of(m).components;
  Flip flip;
  for (int k = 0; k * h < duration; ++k) {
    if (k % 32 == 0) flip.time.push_back(k * h);
    for (int i = 0; k % 32 == 0 && i < 3; ++i)
      flip.inside[i].push_back(Pi_of(m).components[i] / p),
          flip.outside[i].push_back(mu_of(m).components[i] / p);
    m = runge_kutta(reduced, m, h), wrong = runge_kutta(wrong_side, wrong, h),
    whole = runge_kutta(unreduced, whole, h);
    flip.apart = std::max(flip.apart, (m.R - whole.R).norm());
    flip.wrong_space = std::max(flip.wrong_space, (mu_of(wrong).components - thrown).norm() / p);
    flip.lowest = std::min(flip.lowest, Pi_of(m).components[1]);
  }
  return flip;
}

// The components of the momentum in that throw over time, in the body frame and in the spatial frame.
void show_flip(book::Program& program, Flip const& flip) {
  auto plot = book::Plot("time, s", "component / amount of momentum").size(660, 320).y_range(-1.15, 1.15);
  char const* const names[] = {"book, 1", "book, 2", "book, 3"};
  for (int i = 0; i < 3; ++i)
    plot.curve(flip.time, flip.inside[i], names[i], {.colour = i == 0 ? 2 : i == 1 ? 4 : 1});
  for (int i = 0; i < 3; ++i)
    plot.curve(flip.time, flip.outside[i], i ? "" : "space, all three",
               {.colour = 6, .width = 1.2, .dashed = true});
  program.picture("flip", plot.svg(),
                  "One throw about the middle axis, a hundredth off. Seen from the book its momentum turns "
                  "over again and again; seen from space "
                  "(dashed) it never moves: it is the book that turns over.");
  program.figure("apart", flip.apart, "reduced and unreduced motion, largest distance of the attitudes");
  program.figure("wrong_side", flip.wrong_space,
                 "change of the spatial momentum with the sign of right-invariant systems");
}

// 7. What must be so. A step has an error of about (h Omega)^5/120, and all of them may add up; a hundredth
// off the unstable axis
//    the point on the curve is a hundred times as sensitive.
void claim_what_must_be_so(book::Program& program, Lost const& off, Flip const& flip) {
  double const allowed = duration / h * std::pow(h * p / I[0], 5) / 120;
  program.claim(book::measured(off.orbit) < allowed && book::measured(off.energy) < allowed,
                "the momentum stays on its sphere and on its level of the energy");
  program.claim(book::measured(off.space) < allowed, "the spatial momentum is constant");
  program.claim(book::measured(flip.apart) < 100 * allowed,
                "Euler-Poincaré with the attitude reconstructed is the motion of Euler-Lagrange");
  program.claim(book::measured(flip.wrong_space) > 0.5,
                "with the sign of the other side the spatial momentum is not conserved");
  program.claim(book::measured(flip.lowest) < -0.9 * p, "thrown about the middle axis the book turns over");
}

int main(int argc, char** argv) {
  book::Program program(argc, argv,
                        "a spinning book: its momentum runs round a sphere as seen from the book, and stands "
                        "still as seen from space");
  program.say("moments of inertia, kg m^2: ", I[0], ", ", I[1], ", ", I[2]);

  auto sphere = book::Sphere(38, 24).axes({"1 height", "2 width", "3 pages"});
  Lost const off = throw_all_ways(sphere);
  draw_separatrix(sphere);
  program.picture("orbit", sphere.svg(),
                  "The momentum of a thrown book in the body frame: sixteen throws with the same amount of "
                  "momentum, so all on one sphere, the "
                  "coadjoint orbit. Each follows a level of the energy. Round the height and through the "
                  "pages the curves close about the axis; "
                  "about the middle axis, where the great circles cross, nothing stays near.");
  program.figure("orbit", off.orbit, "largest distance from the sphere, relative");
  program.figure("energy", off.energy, "largest change of the energy, relative");
  program.figure("space", off.space, "largest change of the spatial momentum, relative");

  Flip const flip = throw_about_middle_axis();
  show_flip(program, flip);

  claim_what_must_be_so(program, off, flip);
  program.headline(
      "spatial momentum conserved to " + book::number(off.space, 2) + ", not with the sign of the other side",
      off.space);
  return program.finish();
}
