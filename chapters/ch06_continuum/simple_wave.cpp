// A simple wave in a gas and in a solid: exact until it breaks, oblique to all coordinates.
//
// What is shown. Let the particles move along one direction n only, x = X + d (f(s, t) - s) with s = d.X.
// Where W is isotropic that is an exact motion if f_tt = c(f_s)^2 f_ss with c^2 = w''(q), w(q) the stored
// energy of the stretch q along d. A wave that runs one way carries each stretch at its own speed c(q); where
// the speeds differ the wave steepens and breaks, in a gas at the front of a compression. The field equations
// vanish on it to rounding, in three dimensions and up to the moment of breaking, where it is no motion any
// more. Read first. gas_ellipse.
#include <numbers>

#include "actio/continuum/materials.hpp"
#include "actio/jets/field_equations.hpp"
#include "book/plot.hpp"
#include "witness/draw.hpp"

using namespace actio;

// Stretch, wave speed and what follows from them, over any scalar; `travel` is the integral of c, so that the
// particles' velocity is minus it.
struct Gas {
  static constexpr double K = 1, gamma = 1.4;
  static auto energy() { return Barotropic{Polytropic<double>{K, gamma}}; }
  template <class T>
  static T speed(T const& q) {
    using std::pow;
    return pow(q, -(gamma + 1) / 2) * std::sqrt(K * gamma);
  }
  template <class T>
  static T travel(T const& q) {
    using std::pow;
    return pow(q, (1 - gamma) / 2) * (2 * std::sqrt(K * gamma) / (1 - gamma));
  }
};
struct Solid {  // St Venant and Kirchhoff's: w = (lambda + 2 mu)/8 (q^2 - 1)^2
  static constexpr double lambda = 2, mu = 1, M = lambda + 2 * mu;
  static auto energy() { return OfGreenTensor{StVenantKirchhoff<double>{lambda, mu}}; }
  template <class T>
  static T speed(T const& q) {
    using std::sqrt;
    return sqrt((q * q * 3.0 - 1.0) * (M / 2));
  }
  template <class T>
  static T travel(T const& q) {  // of sqrt(3 q^2 - 1), times the root of M/2
    using std::log, std::sqrt;
    T const r = sqrt(q * q * 3.0 - 1.0);
    return (q * r - log(q * std::sqrt(3.0) + r) / std::sqrt(3.0)) * (std::sqrt(M / 2) / 2);
  }
};

// The stretch at the start, as a function of the label of a characteristic, and its integral.
constexpr double height = 0.3;
template <class T>
T stretch(T const& label) {
  using std::sin;
  return sin(label) * height + 1.0;
}
template <class T>
T placed(T const& label) {
  using std::cos;
  return label - cos(label) * height;
}

// The characteristic through s at the time t: s = label + c t. Halving gets the number, and each round of
// Newton's method its derivatives to one order more.
template <class Law, class T>
T label_of(T const& s, T const& t) {
  double const c0 = Law::speed(1 - height), c1 = Law::speed(1 + height), at = to_double(base_value(s)),
               time = to_double(base_value(t));
  double low = at - std::max(c0, c1) * time, high = at - std::min(c0, c1) * time;
  for (int k = 0; k < 60; ++k) {
    double const middle = (low + high) / 2;
    (middle + Law::speed(stretch(middle)) * time < at ? low : high) = middle;
  }
  T label((low + high) / 2);
  for (int k = 0; k < 3; ++k) {
    Dual<T> moved(label);
    moved.part[0] = T(1);
    Dual<T> const arrives = moved + Law::speed(stretch(moved)) * Dual<T>(t);
    if (!(arrives.part[0] > T(0)))
      throw OutsideDomain("simple wave", "characteristics that have not met",
                          to_double(base_value(arrives.part[0])), 0);
    label -= (arrives.value - s) / arrives.part[0];
  }
  return label;
}

// The wave as a section of three dimensions, along the oblique direction d.
template <class Law>
struct SimpleWave {
  Vector<double, 3> d = Vector<double, 3>(2, -1, 2) / 3;
  // f(s, t): along a characteristic f changes at the rate of velocity + c q
  template <class T>
  T along(T const& s, T const& t) const {
    T const label = label_of<Law>(s, t), q = stretch(label);
    return placed(label) + (Law::speed(q) * q - Law::travel(q) + Law::travel(1.0)) * t;
  }
  template <class V>
  auto operator()(V const& x) const {
    using T = typename V::Scalar;
    Matrix<T, 3, 1> const X = x.template tail<3>();
    T const s = X[0] * d[0] + X[1] * d[1] + X[2] * d[2], shift = along(s, T(x[0])) - s;
    return Matrix<T, 3, 1>(X[0] + shift * d[0], X[1] + shift * d[1], X[2] + shift * d[2]);
  }
};

// When neighbouring characteristics first meet: 1 + (dc/dlabel) t = 0.
template <class Law>
double breaks_at() {
  double steepest = 0;
  for (double label = 0; label < 2 * std::numbers::pi; label += 1e-4) {
    Dual<double> moved(label);
    moved.part[0] = 1;
    steepest = std::min(steepest, Law::speed(stretch(moved)).part[0]);
  }
  return -1 / steepest;
}

// The field equations at random points until close to the end, over mass times acceleration as large as it
// gets.
template <class Law>
double miss() {
  Continuum const medium{Euclidean<3>{}, Euclidean<3>{}, Homogeneous<double>{}, Law::energy()};
  Draw draw(11);
  double const end = breaks_at<Law>();
  double most = 0, largest = 0;
  for (int k = 0; k < 100; ++k) {
    Event<double, 3> x = draw.vector<double, Event<double, 3>>(4) * 3.0;
    x[0] = std::abs(x[0]) / 3 * 0.8 * end;
    auto const jet = second_jet(SimpleWave<Law>{}, x);
    most = std::max(most, euler_lagrange(medium, jet).norm()),
    largest = std::max(largest, jet.acceleration().norm());
  }
  return most / largest;
}

template <class Law>
std::string picture() {
  auto plot = book::Plot("s, along the wave", "stretch");
  double const end = breaks_at<Law>();
  for (double const part : {0.0, 0.4, 0.8, 0.999}) {
    std::vector<double> s, q;
    for (double label = -1; label < 2 * std::numbers::pi + 1; label += 0.01)
      s.push_back(label + Law::speed(stretch(label)) * part * end), q.push_back(stretch(label));
    plot.curve(s, q, part == 0 ? "at the start" : book::number(100 * part) + "% of the time to break");
  }
  return plot.svg();
}

int main(int argc, char** argv) {
  book::Program program(argc, argv,
                        "a wave steepens and breaks: an exact solution oblique to all coordinates");
  double const gas = miss<Gas>(), solid = miss<Solid>();
  program.figure("gas", gas, "gas: residual of the field equations over the largest mass times acceleration");
  program.figure("solid", solid, "St Venant and Kirchhoff's solid: the same");
  program.figure("gas_breaks", breaks_at<Gas>(), "time at which the wave in the gas breaks");
  program.figure("solid_breaks", breaks_at<Solid>(), "time at which the wave in the solid breaks");
  program.picture("gas", picture<Gas>(),
                  "A simple wave in a gas: compressed parts run faster, and overtake.");
  program.picture("solid", picture<Solid>(),
                  "The same in St Venant and Kirchhoff's solid, where stretched parts run faster.");
  program.claim(book::measured(gas) < 1e-11 && book::measured(solid) < 1e-11,
                "the field equations vanish on the wave");
  program.headline("simple wave exact to " + book::number(std::max(gas, solid), 2), std::max(gas, solid));
  return program.finish();
}
