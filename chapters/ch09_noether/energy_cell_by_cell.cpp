// Where the energy of a gas goes that spreads into empty space: cell by cell of the body, through each face.
//
// What is shown. The Noether current of time translation is the current of energy: what leaves a cell through
// its faces is what the cell loses, at each moment to rounding, and over a time as well as the quadrature of
// that time. The body has polar coordinates, whose metric is not constant. Read first. gas_in_cells.hpp, the
// cloud and its cells.
#include "actio/numbers/gauss_quadrature.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"
#include "gas_in_cells.hpp"

using namespace actio;
using book::number;

Gas const gas{};

// 1. At each moment: what a cell loses leaves through its faces. The largest balance over the largest
// rate of a cell; with the motion as it is, and with a tenth too much acceleration.
struct Balance {
  double right, wrong;
};
Balance balance_at(double t) {
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
  return {balance / scale, unbalanced / scale};
}
double show_moments(book::Program& program) {
  double worst = 0, control = 0;
  for (double const t : {0.0, 0.4, 0.8, 1.6}) {
    auto const [right, wrong] = balance_at(t);
    worst = std::max(worst, right), control = std::max(control, wrong);
  }
  program.figure("balance", worst,
                 "largest balance of a cell over the largest rate, 144 cells at four times");
  program.figure("control", control, "the same with a tenth too much acceleration");
  program.claim(book::measured(worst) < 1e-12, "each cell loses what leaves through its faces, to rounding");
  program.claim(book::measured(control) > 1e-3, "not so when the motion is no solution");
  return worst;
}

// 2. Over a time: what leaves each ring through its faces, added up by Gauss's rule in each quarter of
// it.
double const end = 1.6;
std::array<double, rings> outflow_over_time() {
  auto const rule = gauss_quadrature<double>(16);
  std::array<double, rings> left{};
  for (int part = 0; part < 4; ++part)
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
      Cloud const phi = cloud_at(end / 4 * (part + rule.nodes[k]));
      for (int ring = 0; ring < rings; ++ring)
        left[ring] += end / 4 * rule.weights[k] * outflow(gas, phi, whole_ring(ring));
    }
  return left;
}
void show_rings(book::Program& program) {
  auto const left = outflow_over_time();
  Cloud const first = cloud_at(0), last = cloud_at(end);
  std::vector<book::Program::Row> rows;
  double total_before = 0, total_after = 0, over_time = 0, growth = 0;
  for (int ring = 0; ring < rings; ++ring) {
    double const before = energy_in(gas, first, whole_ring(ring)),
                 after = energy_in(gas, last, whole_ring(ring));
    double const balance = after - before + left[ring];
    std::string const range = number(double(ring) / rings, 2) + " to " + number(double(ring + 1) / rings, 2);
    rows.push_back({range, number(before, 6), number(after, 6), number(left[ring], 6), number(balance, 2)});
    total_before += before, total_after += after;
    over_time = std::max(over_time, std::abs(balance) / total_before);
    growth = after / before;
  }
  program.table("rings", {"ring, r", "energy at t = 0", "at t = 1.6", "left through its faces", "balance"},
                rows, "Rings of the body: energy at two times, and what went through their faces meanwhile.");
  program.figure("over_time", over_time,
                 "largest balance of a ring, over the time, over the energy of the rings up to it");
  program.figure("total", std::abs(total_after / total_before - 1), "relative change of the whole energy");
  program.figure("outermost", growth, "energy of the outermost ring at the end over that at the beginning");
  program.claim(book::measured(over_time) < 1e-10, "over a time as well");
}

// 3. The cells where they are, in the colour of what they do: one for gaining, one for losing energy,
// the stronger the more.
std::string outline(Cloud const& phi, Cell const& cell) {
  std::vector<Corner> corners;
  for (int k = 0; k <= 4; ++k)
    corners.push_back({cell.low[0], cell.low[1] + (cell.high[1] - cell.low[1]) * k / 4});
  for (int k = 4; k >= 0; --k)
    corners.push_back({cell.high[0], cell.low[1] + (cell.high[1] - cell.low[1]) * k / 4});
  double const scale = 190 / phi.A.norm();
  std::string path;
  for (auto const& x : corners) {
    auto const y = phi(Event<double, 2>(phi.t, x[0], x[1]));
    path += (path.empty() ? "M" : "L") + book::svg::pixel(220 + scale * y[0]) + " " +
            book::svg::pixel(190 - scale * y[1]);
  }
  return path + "Z";
}
std::string map_of_cells(Cloud const& phi) {
  double most = 0;
  std::vector<double> rates;
  for (int i = 0; i < rings * sectors; ++i) {
    Cell const cell = cell_of(i / sectors, i % sectors);
    rates.push_back(energy_rate(gas, phi, cell) /
                    ((cell.high[0] * cell.high[0] - cell.low[0] * cell.low[0])));
    most = std::max(most, std::abs(rates.back()));
  }
  std::string out;
  for (int i = 0; i < rings * sectors; ++i) {
    std::string const path = outline(phi, cell_of(i / sectors, i % sectors)),
                      colour = rates[i] > 0 ? "dot1" : "dot2";
    out += "<path class=\"" + colour + "\" fill-opacity=\"" + number(std::abs(rates[i]) / most) + "\" d=\"" +
           path + "\"/>";
    out += "<path class=\"grid\" d=\"" + path + "\"/>\n";
  }
  out +=
      "<circle class=\"dot1\" cx=\"30\" cy=\"392\" r=\"6\"/>" + book::svg::label({42, 396}, "gains energy");
  out +=
      "<circle class=\"dot2\" cx=\"170\" cy=\"392\" r=\"6\"/>" + book::svg::label({182, 396}, "loses energy");
  return book::svg::picture(440, 410, out);
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "the energy of a gas that spreads, cell by cell of its body");
  double const worst = show_moments(program);
  show_rings(program);
  program.picture("map", map_of_cells(cloud_at(0.4)),
                  "The cells of the body where they are at t = 0.4: which of them gain and which "
                  "lose energy per area of the body.");
  program.headline("energy balanced in each cell to " + number(worst, 2), worst);
  return program.finish();
}
