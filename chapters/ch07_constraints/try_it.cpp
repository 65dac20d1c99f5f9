// Lines to try of chapter 7: a multiplier, the stiff spring that it replaces, a string, and a wheel.
#include <cmath>

#include "actio/constraints/inextensible.hpp"
#include "actio/constraints/multiplier_theorem.hpp"
#include "actio/jets/field_equations.hpp"
#include "actio/numbers/print.hpp"
#include "book/try_it.hpp"
using namespace actio;

TRY_IT(multiplier) {
  auto const height = [](auto const& q) { return q[0] * 3.0 + q[1] * 4.0; };
  auto const sphere = []<class T>(Matrix<T, 3, 1> const& q) {
    T const excess = q.dot(q) - 1.0;
    return Matrix<T, 1, 1>(excess);
  };
  auto const hill = constrained<1>(height, sphere);
  Vector<double, 3> const top(0.6, 0.8, 0), beside(1, 0, 0);
  print("multiplier at the top", hill.multiplier(top));
  print("slope along the sphere there", hill.restricted_differential(top));
  print("slope along the sphere elsewhere", hill.restricted_differential(beside));
  try {
    hill.multiplier(Vector<double, 3>(0, 0, 0));
  } catch (NotRegular const& refusal) {
    print(refusal.what());
  }
}

TRY_IT(stiff_spring) {
  // A spring of stiffness k in place of the constraint: 5 r + k (r^2 - 1)^2 / 2.
  for (double const k : {1e2, 1e4, 1e6}) {
    double r = 1;
    for (int i = 0; i < 20; ++i) r -= (5 + 2 * k * (r * r - 1) * r) / (k * (6 * r * r - 2));
    print("stiffness", k);
    print("  force of the spring", -k * (r * r - 1));
  }
}

TRY_IT(string) {
  double const rho = 0.05, v = 6;
  auto const hoop = [](auto const& x) {
    auto const s = x[1] - x[0] * 6.0;
    return Matrix<std::remove_const_t<decltype(s)>, 2, 1>(cos(s), sin(s));
  };
  auto const held_by = [&](double tension) {
    auto const lambda = [tension](auto const& x) {
      using T = typename std::remove_cvref_t<decltype(x)>::Scalar;
      return Matrix<T, 1, 1>(T(tension));
    };
    HeavyString<double, 2> const string{rho, {0, 0}};
    AugmentedDensity const density{string, Inextensible{Euclidean<2>{}}};
    return euler_lagrange(density, ExtendedSection{hoop, lambda}, Event<double, 1>(0.1, 0.2));
  };
  print("residual with the tension rho v^2", held_by(rho * v * v));
  print("with a tenth less", held_by(0.9 * rho * v * v));
}

TRY_IT(wheel) {
  // A wheel of radius 1 that rolls round a circle: place, heading, angle of rolling.
  auto const free = []<class T>(Jet<T, 0, 4> const& j) {
    auto const velocity = j.v.col(0);
    return T(velocity.dot(velocity) / 2.0);
  };
  auto const rolls = constraint<2>([]<class T>(Jet<T, 0, 4> const& j) {
    using std::cos, std::sin;
    T const x = j.v(0, 0), y = j.v(1, 0), rolling = j.v(3, 0);
    return Matrix<T, 2, 1>(x - rolling * cos(j.y[2]), y - rolling * sin(j.y[2]));
  });
  for (double const c : {0.0, 1.0}) {  // added to the multipliers -(x', y')
    auto const section = [c]<class T>(Matrix<T, 1, 1> const& t) {
      using std::cos, std::sin;
      Matrix<T, 6, 1> all;
      all << sin(t[0]), -cos(t[0]), t[0], t[0], -cos(t[0]) + T(c), -sin(t[0]);
      return all;
    };
    AugmentedDensity const augmented{free, rolls};
    print("c", c);
    print("  vakonomic equations", euler_lagrange(augmented, section, Event<double, 0>(0.7)));
  }
}

TRY_IT_MAIN("the lines to try of chapter 7")
