// A skate on a slope: a constraint on velocities, for which the two principles part.
//
// What is shown. The blade does not slip sideways. By the principle of Lagrange and d'Alembert (virtual
// work) the skate that is let go spinning runs along a cycloid, across the slope, and never gets farther
// down than its first arc; by the vakonomic principle, a critical point of the action among the motions that
// satisfy the constraint, it goes down for ever. Real skates do the former. The multiplier of the augmented
// density is the vakonomic principle, so the chapter keeps to constraints without derivatives in time. Read
// first. The two principles in the chapter.
//
//   x      down the slope, m      theta  direction of the blade      u      speed along the blade, m/s
//   y      across it, m           omega  first rate of turning, 1/s  m, I   mass, moment of inertia
#include "actio/constraints/augmented.hpp"
#include "actio/jets/field_equations.hpp"
#include "book/measure.hpp"
#include "book/plot.hpp"

using namespace actio;
using Points = std::vector<double>;
double const m = 70, inertia = 20, downhill = 0.6, omega = 1.5;

// 1. The body on its slope, free of the blade, and the velocity across the blade, which
// vanishes. The fields are over time alone, n = 0.
struct Slope {
  template <class T>
  T operator()(Jet<T, 0, 3> const& j) const {
    T const x = j.v(0, 0), y = j.v(1, 0), turning = j.v(2, 0);
    return (x * x + y * y) * (m / 2) + turning * turning * (inertia / 2) + j.y[0] * (m * downhill);
  }
};
struct Blade {
  static constexpr int components = 1;
  template <class T>
  Matrix<T, 1, 1> operator()(Jet<T, 0, 3> const& j) const {
    using std::cos, std::sin;
    return Matrix<T, 1, 1>(j.v(0, 0) * sin(j.y[2]) - j.v(1, 0) * cos(j.y[2]));
  }
};

// 2. The motion of Lagrange and d'Alembert: the blade turns uniformly, and the speed along
// it is downhill/omega sin(omega t). That is a cycloid.
struct Cycloid {
  template <class V>
  auto operator()(V const& x) const {
    using T = typename V::Scalar;
    using std::cos, std::sin;
    T const angle = x[0] * omega, s = sin(angle);
    double const size = downhill / (2 * omega * omega);
    return Matrix<T, 3, 1>(s * s * size, (angle - s * cos(angle)) * size, angle);
  }
};

// 3. The vakonomic motion: its momenta are (m downhill t, 0), hence u = downhill t cos theta
// and lambda = m downhill t sin theta; theta and its rate are integrated by the classical
// method of Runge and Kutta.
struct Vakonomic {
  double t = 0, theta = 0, rate = omega, x = 0, y = 0;
  using State = Vector<double, 4>;  // theta, rate, x, y
  static double torque(double t, double theta) {
    return m / inertia * downhill * downhill * t * t * std::sin(theta) * std::cos(theta);
  }
  static State slope(double t, State const& z) {
    double const u = downhill * t * std::cos(z[0]);
    return {z[1], torque(t, z[0]), u * std::cos(z[0]), u * std::sin(z[0])};
  }
  void advance(double h) {
    State const z(theta, rate, x, y), a = slope(t, z), b = slope(t + h / 2, z + h / 2 * a);
    State const c = slope(t + h / 2, z + h / 2 * b), d = slope(t + h, z + h * c);
    State const next = z + h / 6 * (a + 2 * b + 2 * c + d);
    t += h, theta = next[0], rate = next[1], x = next[2], y = next[3];
  }
  // The second jet with its multiplier: derivatives of what is said above.
  SecondJet<double, 0, 4> jet() const {
    double const s = std::sin(theta), c = std::cos(theta), u = downhill * t * c,
                 du = downhill * (c - t * s * rate);
    SecondJet<double, 0, 4> j;
    j.x << t;
    j.y << x, y, theta, m * downhill * t * s;
    j.v << u * c, u * s, rate, m * downhill * (s + t * c * rate);
    j.w[0] << du * c - u * s * rate, du * s + u * c * rate, torque(t, theta), 0;
    return j;
  }
};

// 4. What remains of the free equations along the cycloid, over the weight down the slope,
// once a force across the blade is allowed; and what remains without one, which is what the
// augmented density asks for: as the blade turns uniformly, its equation leaves lambda u = 0.
std::pair<double, double> along_cycloid(double end) {
  double left = 0, other = 0;
  for (int i = 1; i <= 200; ++i) {
    Event<double, 0> const t(end * i / 200);
    Vector<double, 3> const E = euler_lagrange(Slope{}, Cycloid{}, t);
    Vector<double, 3> const across(std::sin(omega * t[0]), -std::cos(omega * t[0]), 0);
    left = std::max(left, (E - across * across.dot(E)).norm() / (m * downhill));
    other = std::max(other, E.norm() / (m * downhill));
  }
  return {left, other};
}

int main(int argc, char** argv) {
  book::Program program(argc, argv,
                        "a skate on a slope: two principles for a constraint on velocities, and two motions");
  double const end = 10, h = 1e-3;
  Points xs, ys, us, vs;
  Vakonomic other;
  AugmentedDensity const augmented{Slope{}, Blade{}};
  double worst = 0;
  for (int i = 0; i * h <= end; ++i) {
    auto const p = Cycloid{}(Event<double, 0>(i * h));
    xs.push_back(-p[0]), ys.push_back(p[1]), us.push_back(-other.x), vs.push_back(other.y);
    if (i % 50 == 0)
      worst = std::max(worst, euler_lagrange(augmented, other.jet()).cwiseAbs().maxCoeff() /
                                  (m * downhill * std::max(1.0, other.t)));
    other.advance(h);
  }
  auto plot = book::Plot("across the slope, m", "up the slope, m").size(560, 470).equal();
  plot.curve(ys, xs, "Lagrange-d'Alembert: a cycloid").curve(vs, us, "vakonomic");
  program.picture("tracks", plot.svg(),
                  "A skate let go on a slope, spinning, by the two principles: across the slope, and down.");

  auto const [left, missing] = along_cycloid(end);
  double const deepest = downhill / (2 * omega * omega);
  program.table("principles",
                {"", "Lagrange-d'Alembert equations", "vakonomic equations", "down the slope, m"},
                {{"cycloid", book::number(left, 2), book::number(missing, 2), book::number(deepest)},
                 {"vakonomic motion", "–", book::number(worst, 2), book::number(other.x)}},
                "What the two motions leave of the equations, over the force down the "
                "slope, and how far down they get in " +
                    book::number(end) + " s.");
  program.figure("deepest", deepest, book::number(100 * deepest) + " cm", "how far down the cycloid gets");
  program.figure("far", other.x, book::number(other.x) + " m", "how far down the other one is at the end");
  program.claim(book::measured(left) < 1e-12, "the cycloid satisfies the Lagrange-d'Alembert equations");
  program.claim(book::measured(worst) < 1e-10,
                "the vakonomic motion satisfies the augmented equations and the constraint");
  program.claim(book::measured(missing) > 0.1 && book::measured(other.x) > 10 * deepest,
                "the two principles differ");
  program.headline(
      "the principles part by " + book::number(other.x - deepest) + " m in " + book::number(end) + " s",
      other.x - deepest);
  return program.finish();
}
