// Where the energy of a gas goes that spreads into empty space: cell by cell of the body, through each face.
//
// What is shown. A round cloud x = A(t) X, |X| <= 1, of mass 1 - |X|^2 and pressure (rho/J)^2 moves exactly when A'' = 4 (det A)^-1 A^-T (an ordinary differential equation for the matrix A). Its body is
// described by polar coordinates, whose metric is not constant. The Noether current of time translation is the current of energy: what leaves a cell through its faces is what the cell loses, at each moment to rounding,
// and over a time as well as the quadrature of that time.
//
//   r, theta  polar coordinates of the body      e, q^j  energy per dr dtheta, and what flows through the faces
#include "actio/foundations/gauss_quadrature.hpp"
#include "actio/foundations/reference_solution.hpp"
#include "actio/jets/action.hpp"
#include "actio/jets/continuum.hpp"
#include "actio/noether/current_divergence.hpp"
#include "actio/noether/time_translation.hpp"
#include "book/plot.hpp"

using namespace actio;
using Eigen::Matrix2d;
using std::numbers::pi;

struct Polar {
  template <class V>
  auto operator()(V const& x) const {
    Eigen::Matrix<typename V::Scalar, 2, 2> G = Eigen::Matrix<typename V::Scalar, 2, 2>::Identity();
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
  T operator()(Eigen::Matrix<T, 2, 1> const& x, G const& body, g const& space, Eigen::Matrix<T, 2, 2> const& F) const {
    return Mass{}(x) / jacobian(body, space, F);
  }
};
using Gas = Continuum<Polar, Euclidean<2>, Mass, Energy>;

Matrix2d acceleration(Matrix2d const& A) { return inverse_matrix(A).transpose() * (4 / determinant(A)); }

// The motion to second order about a time: all that second jets see.
struct Cloud {
  Matrix2d A, V, B;
  double t;
  template <class T>
  Eigen::Matrix<T, 2, 1> operator()(Eigen::Matrix<T, 3, 1> const& x) const {
    using std::cos, std::sin;
    T const late = x[0] - t, X[] = {x[1] * cos(x[2]), x[1] * sin(x[2])};
    Eigen::Matrix<T, 2, 1> y;
    for (int a = 0; a < 2; ++a) {
      y[a] = T(0);
      for (int i = 0; i < 2; ++i) y[a] += (late * late * B(a, i) * 0.5 + late * V(a, i) + A(a, i)) * X[i];
    }
    return y;
  }
};
Cloud cloud_at(double t) {
  Eigen::Matrix<double, 8, 1> start;
  start << 1, 0, 0.3, 0.5, 0.1, 0.7, -0.9, 0.2;
  auto const rate = [](double, auto const& s) {
    Matrix2d const A = Eigen::Map<Matrix2d const>(s.data());
    Eigen::Matrix<double, 8, 1> d;
    Eigen::Map<Matrix2d>(d.data() + 4) = acceleration(A);
    d.template head<4>() = s.template tail<4>();
    return d;
  };
  auto const s = reference_solution(rate, start, 0.0, t);
  Matrix2d const A = Eigen::Map<Matrix2d const>(s.data()), V = Eigen::Map<Matrix2d const>(s.data() + 4);
  return {A, V, acceleration(A), t};
}

// A cell of the body: low and high corner in r and theta.
using Corner = Eigen::Vector2d;
struct Cell {
  Corner low, high;
};
double energy_in(Gas const& gas, Cloud const& phi, Cell const& cell) {
  return integral([&](Corner const& x) { return energy_density(gas, first_jet(phi, Event<double, 2>(phi.t, x[0], x[1]))); }, cell.low, cell.high, 23);
}
// Its rate: the derivative of the energy density along the motion.
double energy_rate(Gas const& gas, Cloud const& phi, Cell const& cell) {
  auto const rate = [&](Corner const& x) { return -detail::current_component(gas, TimeTranslation{}, along(second_jet(phi, Event<double, 2>(phi.t, x[0], x[1])), 0), 0).part[0]; };
  return integral(rate, cell.low, cell.high, 23);
}
// What leaves the cell through its four faces, by the current of energy.
double outflow(Gas const& gas, Cloud const& phi, Cell const& cell) {
  double sum = 0;
  for (int k = 0; k < 2; ++k)
    for (bool upper : {false, true}) {
      double const at = (upper ? cell.high : cell.low)[k];
      if (k == 0 && (at == 0 || at == 1)) continue;  // the face at the centre has no length, and at the rim there is no gas
      auto const q = [&](Eigen::Matrix<double, 1, 1> const& along_face) {
        Event<double, 2> x(phi.t, along_face[0], along_face[0]);
        x[1 + k] = at;
        return energy_current(gas, first_jet(phi, x))[1 + k];
      };
      Eigen::Matrix<double, 1, 1> const from(cell.low[1 - k]), to(cell.high[1 - k]);
      sum += (upper ? 1 : -1) * integral(q, from, to, 23);
    }
  return sum;
}

constexpr int rings = 6, sectors = 24;
Cell cell_of(int ring, int sector) {
  return {{double(ring) / rings, 2 * pi * sector / sectors}, {double(ring + 1) / rings, 2 * pi * (sector + 1) / sectors}};
}

// The cells where they are, in the colour of what they do: one for gaining, one for losing energy, the stronger the more.
std::string map_of_cells(Gas const& gas, Cloud const& phi) {
  double most = 0;
  std::vector<double> rates;
  for (int i = 0; i < rings * sectors; ++i) {
    Cell const cell = cell_of(i / sectors, i % sectors);
    rates.push_back(energy_rate(gas, phi, cell) / ((cell.high[0] * cell.high[0] - cell.low[0] * cell.low[0])));
    most = std::max(most, std::abs(rates.back()));
  }
  double const reach = phi.A.norm(), scale = 190 / reach;
  std::string out;
  for (int i = 0; i < rings * sectors; ++i) {
    Cell const cell = cell_of(i / sectors, i % sectors);
    std::vector<Corner> outline;
    for (int k = 0; k <= 4; ++k) outline.push_back({cell.low[0], cell.low[1] + (cell.high[1] - cell.low[1]) * k / 4});
    for (int k = 4; k >= 0; --k) outline.push_back({cell.high[0], cell.low[1] + (cell.high[1] - cell.low[1]) * k / 4});
    std::string path;
    for (auto const& x : outline) {
      auto const y = phi(Event<double, 2>(phi.t, x[0], x[1]));
      path += (path.empty() ? "M" : "L") + book::svg::pixel(220 + scale * y[0]) + " " + book::svg::pixel(190 - scale * y[1]);
    }
    out += "<path class=\"dot" + std::string(rates[i] > 0 ? "1" : "2") + "\" fill-opacity=\"" + book::number(std::abs(rates[i]) / most) + "\" d=\"" + path + "Z\"/><path class=\"grid\" d=\"" + path + "Z\"/>\n";
  }
  out += "<circle class=\"dot1\" cx=\"30\" cy=\"392\" r=\"6\"/>" + book::svg::label({42, 396}, "gains energy") + "<circle class=\"dot2\" cx=\"170\" cy=\"392\" r=\"6\"/>" + book::svg::label({182, 396}, "loses energy");
  return book::svg::picture(440, 410, out);
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "the energy of a gas that spreads, cell by cell of its body");
  Gas const gas{};

  // 1. At each moment: what a cell loses leaves through its faces.
  double worst = 0, control = 0;
  std::vector<double> times, parts[3];
  for (double const t : {0.0, 0.4, 0.8, 1.6}) {
    Cloud const phi = cloud_at(t);
    Cloud wrong = phi;
    wrong.B *= 1.1;
    double scale = 0, balance = 0, unbalanced = 0;
    for (int i = 0; i < rings * sectors; ++i) {
      Cell const cell = cell_of(i / sectors, i % sectors);
      double const rate = energy_rate(gas, phi, cell), out = outflow(gas, phi, cell);
      scale = std::max(scale, std::abs(rate));
      balance = std::max(balance, std::abs(rate + out));
      unbalanced = std::max(unbalanced, std::abs(energy_rate(gas, wrong, cell) + out));
    }
    worst = std::max(worst, balance / scale), control = std::max(control, unbalanced / scale);
  }
  program.figure("balance", worst, "largest balance of a cell over the largest rate, 144 cells at four times");
  program.figure("control", control, "the same with a tenth too much acceleration");

  // 2. Over a time: the flow through the faces of each ring, added up by Gauss's rule in each quarter of it.
  double const end = 1.6;
  auto const rule = gauss_quadrature<double>(16);
  std::array<double, rings> before{}, after{}, left{};
  auto const over_ring = [&](int ring) { return Cell{cell_of(ring, 0).low, {cell_of(ring, 0).high[0], 2 * pi}}; };
  for (int ring = 0; ring < rings; ++ring) before[ring] = energy_in(gas, cloud_at(0), over_ring(ring)), after[ring] = energy_in(gas, cloud_at(end), over_ring(ring));
  for (int part = 0; part < 4; ++part)
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
      Cloud const phi = cloud_at(end / 4 * (part + rule.nodes[k]));
      for (int ring = 0; ring < rings; ++ring) left[ring] += end / 4 * rule.weights[k] * outflow(gas, phi, over_ring(ring));
    }
  std::vector<book::Program::Row> rows;
  double total_before = 0, total_after = 0, over_time = 0;
  for (int ring = 0; ring < rings; ++ring) {
    rows.push_back({book::number(double(ring) / rings, 2) + " to " + book::number(double(ring + 1) / rings, 2), book::number(before[ring], 6), book::number(after[ring], 6), book::number(left[ring], 6), book::number(after[ring] - before[ring] + left[ring], 2)});
    total_before += before[ring], total_after += after[ring];
    over_time = std::max(over_time, std::abs(after[ring] - before[ring] + left[ring]) / total_before);
  }
  program.table("rings", {"ring, r", "energy at t = 0", "at t = 1.6", "left through its faces", "balance"}, rows, "Rings of the body: energy at two times, and what went through their faces meanwhile.");
  program.figure("over_time", over_time, "largest balance of a ring over the whole energy, over the time");
  program.figure("total", std::abs(total_after / total_before - 1), "relative change of the whole energy");
  program.figure("outermost", after[rings - 1] / before[rings - 1], "energy of the outermost ring at the end over that at the beginning");
  program.picture("map", map_of_cells(gas, cloud_at(0.4)), "The cells of the body where they are at t = 0.4: which of them gain and which lose energy per area of the body.");

  program.claim(worst < 1e-12, "each cell loses what leaves through its faces, to rounding");
  program.claim(control > 1e-3, "not so when the motion is no solution");
  program.claim(over_time < 1e-10, "over a time as well");
  program.headline("energy balanced in each cell to " + book::number(worst, 2), worst);
  return program.finish();
}
