// A round cloud of gas that spreads into empty space, x = A(t) X with |X| <= 1, and the energy of its body
// cell by cell.
//
// The cloud has the mass 1 - |X|^2 and the pressure (rho/J)^2, and moves exactly when A'' = 4 (det A)^-1
// A^-T, an ordinary differential equation for A. Its body is described by polar coordinates r, theta, whose
// metric is not constant. A cell is a box of these: it has energy in it, the rate of that, and what flows out
// through its faces.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "actio/continuum/continuum.hpp"
#include "actio/jets/action.hpp"
#include "actio/noether/current_divergence.hpp"
#include "actio/noether/time_translation.hpp"
#include "witness/reference_solution.hpp"

struct Polar {
  template <class V>
  auto operator()(V const& x) const {
    actio::Matrix<typename V::Scalar, 2, 2> G = actio::Matrix<typename V::Scalar, 2, 2>::Identity();
    G(1, 1) = x[0] * x[0];
    return G;
  }
};
struct Mass {
  template <class V>
  auto operator()(V const& x) const { return typename V::Scalar(1 - x[0] * x[0]); }
};
// Energy rho(x)/J per mass: the pressure is (rho/J)^2.
struct Energy {
  template <class G, class g, class T>
  T operator()(actio::Matrix<T, 2, 1> const& x, G const& body, g const& space,
               actio::Matrix<T, 2, 2> const& F) const {
    return Mass{}(x) / actio::jacobian(body, space, F);
  }
};
using Gas = actio::Continuum<Polar, actio::Euclidean<2>, Mass, Energy>;

inline actio::Matrix<double, 2, 2> acceleration(actio::Matrix<double, 2, 2> const& A) {
  return actio::inverse_matrix(A).transpose() * (4 / actio::determinant(A));
}

// The motion to second order about a time: all that second jets see. A, its rate V, and the rate of that, B.
struct Cloud {
  actio::Matrix<double, 2, 2> A, V, B;
  double t;
  template <class T>
  actio::Matrix<T, 2, 1> operator()(actio::Matrix<T, 3, 1> const& x) const {
    using std::cos, std::sin;
    T const late = x[0] - t, X[] = {x[1] * cos(x[2]), x[1] * sin(x[2])};
    actio::Matrix<T, 2, 1> y;
    for (int a = 0; a < 2; ++a) {
      y[a] = T(0);
      for (int i = 0; i < 2; ++i) y[a] += (late * late * B(a, i) * 0.5 + late * V(a, i) + A(a, i)) * X[i];
    }
    return y;
  }
};
// The cloud that is drawn out, leaning and turning at first, at a later time.
inline Cloud cloud_at(double t) {
  using Matrix2d = actio::Matrix<double, 2, 2>;
  actio::Matrix<double, 8, 1> start;
  start << 1, 0, 0.3, 0.5, 0.1, 0.7, -0.9, 0.2;
  auto const rate = [](double, auto const& s) {
    Matrix2d const A = actio::as_matrix<2, 2>(s.data());
    actio::Matrix<double, 8, 1> d;
    actio::as_matrix<2, 2>(d.data() + 4) = acceleration(A);
    d.template head<4>() = s.template tail<4>();
    return d;
  };
  auto const s = actio::reference_solution(rate, start, 0.0, t);
  Matrix2d const A = actio::as_matrix<2, 2>(s.data()), V = actio::as_matrix<2, 2>(s.data() + 4);
  return {A, V, acceleration(A), t};
}

// A cell of the body: low and high corner in r and theta.
using Corner = actio::Vector<double, 2>;
struct Cell {
  Corner low, high;
};
inline double energy_in(Gas const& gas, Cloud const& phi, Cell const& cell) {
  using Event = actio::Event<double, 2>;
  auto const density = [&](Corner const& x) {
    return actio::energy_density(gas, actio::first_jet(phi, Event(phi.t, x[0], x[1])));
  };
  return actio::integral(density, cell.low, cell.high, 23);
}
// Its rate: the derivative of the energy density along the motion.
inline double energy_rate(Gas const& gas, Cloud const& phi, Cell const& cell) {
  auto const rate = [&](Corner const& x) {
    auto const e = [&](auto const& jet) { return actio::energy_density(gas, jet); };
    return actio::total_derivative(0, e, actio::second_jet(phi, actio::Event<double, 2>(phi.t, x[0], x[1])));
  };
  return actio::integral(rate, cell.low, cell.high, 23);
}
// What leaves the cell through its four faces, by the current of energy.
inline double outflow(Gas const& gas, Cloud const& phi, Cell const& cell) {
  using Point = actio::Matrix<double, 1, 1>;
  double sum = 0;
  for (int k = 0; k < 2; ++k)
    for (bool upper : {false, true}) {
      double const at = (upper ? cell.high : cell.low)[k];
      // the face at the centre has no length, and at the rim there is no gas
      if (k == 0 && (at == 0 || at == 1)) continue;
      auto const q = [&](Point const& along_face) {
        actio::Event<double, 2> x(phi.t, along_face[0], along_face[0]);
        x[1 + k] = at;
        return actio::energy_current(gas, actio::first_jet(phi, x))[1 + k];
      };
      sum += (upper ? 1 : -1) * actio::integral(q, Point(cell.low[1 - k]), Point(cell.high[1 - k]), 23);
    }
  return sum;
}

// The body cut into cells: rings of equal breadth, each into sectors.
constexpr int rings = 6, sectors = 24;
inline Cell cell_of(int ring, int sector) {
  using std::numbers::pi;
  return {{double(ring) / rings, 2 * pi * sector / sectors},
          {double(ring + 1) / rings, 2 * pi * (sector + 1) / sectors}};
}
inline Cell whole_ring(int ring) {
  return {cell_of(ring, 0).low, {cell_of(ring, 0).high[0], 2 * std::numbers::pi}};
}
