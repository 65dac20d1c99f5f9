// What a step of a medium in the plane costs: nanoseconds for a cell, on one thread and on two, beside a
// plain loop of the same scheme in matrices of Eigen, finite elements, and what this machine can do at all,
// in the same rounds.
//
// The limits are measured: fused multiplications and additions on registers alone, and a pass over memory
// that reads and writes each number once, as one step of a medium does that is larger than the caches. A pass
// of the optimised implementation makes several steps, so that it may come below the second. Times are those
// of a clock on the wall, since two threads are no cheaper than one by processor time.
#include "actio/fast_media/fast_medium_2d.hpp"
#include "media_cost.hpp"

using namespace actio;
using namespace actio::media;
using Point = std::array<double, 2>;

namespace {

double sum = 0;  // of what was computed, so that nothing is left out

/// A number that counts what is done with it.
struct Counted {
  static inline long operations = 0;
  double value;
  Counted(double x = 0) : value(x) {}
  friend Counted operator+(Counted a, Counted b) { return ++operations, a.value + b.value; }
  friend Counted operator-(Counted a, Counted b) { return ++operations, a.value - b.value; }
  friend Counted operator*(Counted a, Counted b) { return ++operations, a.value * b.value; }
  friend Counted operator/(Counted a, Counted b) { return ++operations, a.value / b.value; }
  friend Counted operator-(Counted a) { return -a.value; }
};
/// Additions, multiplications and divisions of a step of one cell, with its node.
template <class Medium>
long operations_of(Medium const& medium) {
  media::detail::Edges<Counted> const e{{1, 0}, {1, 0}, {0, 1}, {0, 1}};
  Counted d[4];
  Counted::operations = 0;
  media::detail::areas(e, d);
  auto const f = medium.on(1, 1).slopes(e, d);
  sum += f.below.x.value;
  // Three new edges, the forces of a cell on its nodes, kick and drift.
  return Counted::operations + 6 + 16 + 8;
}

/// Fused multiplications and additions, on eleven registers that wait for nothing else.
struct Fused {
  long rounds;
  media::detail::Quad out{0};
  [[gnu::always_inline]] void operator()() {
    media::detail::Quad a[11];
    for (int k = 0; k < 11; ++k) a[k] = media::detail::Quad(1 + 1e-3 * k);
    media::detail::Quad const b(0.999999), c(1e-7);
    for (long i = 0; i < rounds; ++i) {
#pragma GCC unroll 11
      for (int k = 0; k < 11; ++k) a[k] = a[k] * b + c;
    }
    for (int k = 0; k < 11; ++k) out = out + a[k];
  }
};
/// Reads and writes each number once.
struct Pass {
  media::detail::Quad* from;
  std::size_t count;
  [[gnu::always_inline]] void operator()() {
    media::detail::Quad const b(0.999999);
    for (std::size_t i = 0; i < count; ++i) from[i] = from[i] * b;
  }
};

/// A gas as its reader would write it, who knows nothing of lanes.
struct OwnGas {
  double K, gamma;
  template <class T>
  T energy(T const& J) const {
    using std::pow;
    return K / (gamma - 1) * pow(J, 1 - gamma);
  }
  template <class T>
  T slope(T const& J) const {
    using std::pow;
    return -K * pow(J, -gamma);
  }
};

Point place(Point const& X) {
  return {X[0] + 0.01 * std::sin(6 * X[0] + 2 * X[1]), X[1] + 0.02 * std::cos(3 * X[0])};
}
Point velocity(Point const& X) { return {0.1 * X[1], -0.1 * X[0]}; }

}  // namespace

int main(int argc, char** argv) {
  benchmark::Benchmark program(argc, argv, "media in the plane: nanoseconds for a cell and step");
  using book::number;
  struct Size {
    int across, up, steps;
  };
  Size const size = program.length(Size{2048, 1024, 20}, Size{1024, 256, 8});
  double const h = 1.0 / size.across;
  FastBox2d const box{{size.across, size.up}, {h, h}}, small{{100, 60}, {0.01, 0.01}};

  // What the machine can do.
  std::size_t const numbers = program.length<std::size_t>(1u << 22, 1u << 21);
  std::vector<media::detail::Quad> memory(numbers, media::detail::Quad(1));
  long const rounds = program.length(4000000L, 1000000L);
  auto const pass = [&](int threads) {
    as_team(threads, [&](int k, Meeting&) {
      std::size_t const share = numbers / static_cast<std::size_t>(threads);
      Pass one{memory.data() + share * static_cast<std::size_t>(k), share};
      media::detail::run_with(best_registers(), one);
    });
  };
  auto const limits = benchmark::nanoseconds_on_the_wall(
      program.rounds(15), {{"fused",
                            [&] {
                              Fused fused{rounds};
                              media::detail::run_with(best_registers(), fused);
                              sum += fused.out.lane[0];
                            },
                            static_cast<double>(rounds) * 11 * 8},
                           {"memory", [&] { pass(1); }, static_cast<double>(numbers)},
                           {"memory, two", [&] { pass(2); }, static_cast<double>(numbers)}});
  program.figure("fused", 1 / limits[0], "10^9 additions and multiplications a second, fused, on one core");
  program.figure(
      "memory", limits[1],
      "ns for a pass over the four numbers of a node in memory, read and written once, on one core");
  program.figure("memory_two", limits[2], "the same on two");

  std::vector<book::Program::Row> rows;
  double gas = 0, solid = 0, any = 0, ratio = HUGE_VAL, elements = HUGE_VAL, shared = 0;
  auto const add = [&](std::string const& name, auto const& medium, auto const& stress, long operations) {
    auto const c = benchmark::cost_of(program, medium, stress, box, small, size.steps, place, velocity, sum);
    double const floor = operations > 0 ? static_cast<double>(operations) * limits[0] : 0;
    rows.push_back({name, number(c.one), number(c.two), number(c.plain), number(c.plain / c.one),
                    number(c.elements / c.one), operations > 0 ? std::to_string(operations) : "",
                    operations > 0 ? number(floor) : "", operations > 0 ? number(c.one / floor) : ""});
    ratio = std::min(ratio, c.plain / c.one), elements = std::min(elements, c.elements / c.one);
    shared = std::max(shared, c.two / c.one);
    return c.one;
  };
  auto const counted = [&](std::string const& name, auto const& medium, auto const& stress) {
    return add(name, medium, stress, operations_of(medium));
  };
  gas = counted("gas, exponent 2", FastFluid{PolytropicByRoots<1, 2>{1}}, peers::GasOfTwoStress{1});
  solid = counted("St Venant-Kirchhoff", FastStVenantKirchhoff{1, 1}, peers::StVenantKirchhoffStress{1, 1});
  counted("Blatz-Ko", blatz_ko<1>(1), peers::BlatzKoStress{1});
  double const named = std::max(
      {add("gas, exponent 5/3", FastFluid{PolytropicByRoots<3, 5>{1}}, peers::GasStress{1, 5. / 3}, 0),
       add("gas, exponent 4/3", FastFluid{PolytropicByRoots<3, 4>{1}}, peers::GasStress{1, 4. / 3}, 0),
       add("gas, exponent 3/2", FastFluid{PolytropicByRoots<2, 3>{1}}, peers::GasStress{1, 1.5}, 0),
       add("gas, exponent 7/5", FastFluid{PolytropicByRoots<5, 7>{1}}, peers::GasStress{1, 1.4}, 0)});
  any = add("gas, any exponent", FastFluid{PolytropicGas{1, 1.37}}, peers::GasStress{1, 1.37}, 0);
  double const rubber = counted("neo-Hookean, square", FastNeoHookean{1, ReciprocalLaw{1, 2, 2}},
                                peers::NeoHookeanSquareStress{1, 2});
  add("neo-Hookean, logarithm", neo_hookean(1, 1), peers::NeoHookeanStress{1, 1}, 0);
  // Number by number, which is not what the limits are of.
  auto const own = benchmark::cost_of(program, FastFluid{OwnGas{1, 1.37}}, peers::GasStress{1, 1.37}, box,
                                      small, size.steps, place, velocity, sum);
  rows.push_back({"a law of one's own", number(own.one), number(own.two), number(own.plain),
                  number(own.plain / own.one), number(own.elements / own.one), "", "", ""});
  program.table("plane",
                {"medium", "one thread", "two", "Eigen", "Eigen / one", "elements / one", "operations",
                 "floor", "one / floor"},
                rows,
                "Media in the plane: nanoseconds for a cell and step. The floor is that of the "
                "operations, if all were fused in pairs.");
  program.figure("gas", gas, "ns for a cell and step of a gas with exponent 2, one thread");
  program.figure("solid", solid, "ns for a cell and step of St Venant and Kirchhoff's solid, one thread");
  program.figure("rubber", rubber, "ns for a cell and step of a neo-Hookean solid");
  program.figure("named", named, "ns for a cell and step of a gas with an exponent by roots, the slowest");
  program.figure("any", any, "ns for a cell and step of a gas with any exponent");
  program.figure("own", own.one / any, "times that the same gas takes as a law of one's own, without lanes");
  program.figure("ratio", ratio, "times that the Eigen loop takes longer, least");
  program.figure("elements", elements, "times that a step of finite elements takes longer, least");
  // With a homogeneous deformation corners and Gauss points have the same gradient.
  FastMedium2d const stretched(
      FastNeoHookean{1, ReciprocalLaw{1, 2, 2}}, small, 1e-3, 1,
      [](Point const& X) {
        return Point{1.2 * X[0] + 0.1 * X[1], 0.9 * X[1] - 0.2 * X[0]};
      },
      [](Point const&) {
        return Point{0, 0};
      });
  double const apart = peers::forces_apart(peers::gathered(peers::NeoHookeanSquareStress{1, 2}, small, 1e-3,
                                                           stretched.places(), stretched.velocities()));
  program.claim(apart <= 1e-12,
                "the forces of finite elements are those of the plain loop where the gradient is the same "
                "everywhere, to 1e-12; measured " +
                    number(apart));
  program.figure("shared", shared, "what two threads take of the time of one, most");
  program.figure("sum", sum, "sum of the last states, so that nothing is left out");
  if (best_registers() != Registers::plain)
    program.claim_of_time(ratio >= 5,
                          "the plain loop takes at least five times as long, whatever the medium");
  program.headline("a cell and step of a gas takes " + number(gas) + " ns, by a plain loop at least " +
                       number(ratio) + " times as long",
                   gas);
  return program.finish();
}
