// What a step of a medium in space costs, with eight corners a cell: nanoseconds for a cell, on one thread
// and on two, beside a plain loop of the same scheme in matrices of Eigen and finite elements, in the same
// rounds. The plane is measured by media.cpp.
#include "actio/fast_media/fast_medium_3d.hpp"
#include "media_cost.hpp"

using namespace actio;
using namespace actio::media;
using Point = std::array<double, 3>;

namespace {

Point place(Point const& X) {
  return {X[0] + 0.01 * std::sin(6 * X[0] + 2 * X[1]), X[1] + 0.02 * std::cos(3 * X[2]),
          X[2] + 0.01 * std::sin(3 * X[0])};
}
Point velocity(Point const& X) { return {0.1 * X[1], -0.1 * X[0], 0.05}; }

}  // namespace

int main(int argc, char** argv) {
  benchmark::Benchmark program(argc, argv, "media in space: nanoseconds for a cell and step");
  using book::number;
  // Larger than the caches, and no multiples of a page.
  struct Size {
    int across, back, up, steps;
  };
  Size const size = program.length(Size{127, 127, 47, 16}, Size{63, 31, 31, 8});
  double const h = 1.0 / size.across;
  FastBox3d const box{{size.across, size.back, size.up}, {h, h, h}}, small{{20, 15, 10}, {0.02, 0.02, 0.02}};

  double sum = 0, ratio = HUGE_VAL, elements = HUGE_VAL, shared = 0;
  std::vector<book::Program::Row> rows;
  auto const measured = [&](std::string const& name, auto const& medium, auto const& stress) {
    auto const c = benchmark::cost_of(program, medium, stress, box, small, size.steps, place, velocity, sum);
    rows.push_back({name, number(c.one), number(c.two), number(c.plain), number(c.plain / c.one),
                    number(c.elements / c.one)});
    ratio = std::min(ratio, c.plain / c.one), elements = std::min(elements, c.elements / c.one);
    shared = std::max(shared, c.two / c.one);
    return c.one;
  };
  double const gas = measured("gas, exponent 2", FastFluid{PolytropicByRoots<1, 2>{1}},
                              peers::GasOfTwoStress{1}),
               solid = measured("St Venant-Kirchhoff", FastStVenantKirchhoff{1, 1},
                                peers::StVenantKirchhoffStress{1, 1}),
               rubber = measured("neo-Hookean, square", FastNeoHookean{1, ReciprocalLaw{1, 2, 2}},
                                 peers::NeoHookeanSquareStress{1, 2}),
               logarithm =
                   measured("neo-Hookean, logarithm", neo_hookean(1, 1), peers::NeoHookeanStress{1, 1}),
               named = measured("gas, exponent 5/3", FastFluid{PolytropicByRoots<3, 5>{1}},
                                peers::GasStress{1, 5. / 3}),
               any = measured("gas, any exponent", FastFluid{PolytropicGas{1, 1.37}},
                              peers::GasStress{1, 1.37});
  program.table("space",
                {"medium", "one thread", "two threads", "Eigen loop", "Eigen loop / one", "elements / one"},
                rows, "Media in space: nanoseconds for a cell and step.");
  program.figure("gas", gas, "ns for a cell and step of a gas with exponent 2, one thread");
  program.figure("solid", solid, "ns for a cell and step of St Venant and Kirchhoff's solid, one thread");
  program.figure("rubber", rubber, "ns for a cell and step of a neo-Hookean solid, one thread");
  program.figure("logarithm", logarithm, "the same with the logarithm of the volume");
  program.figure("named", named, "ns for a cell and step of a gas with exponent 5/3, one thread");
  program.figure("any", any, "ns for a cell and step of a gas with any exponent, one thread");
  program.figure("ratio", ratio, "times that the Eigen loop takes longer, least");
  program.figure("elements", elements, "times that a step of finite elements takes longer, least");
  program.figure("shared", shared, "what two threads take of the time of one, most");
  program.figure("sum", sum, "sum of the last states, so that nothing is left out");
  if (best_registers() != Registers::plain)
    program.claim_of_time(ratio >= 5,
                          "the plain loop takes at least five times as long, whatever the medium");
  program.headline("a cell and step of a gas in space takes " + number(gas) +
                       " ns, by a plain loop at least " + number(ratio) + " times as long",
                   gas);
  return program.finish();
}
