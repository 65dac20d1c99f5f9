// Rods at their limits: a stiff one is a rigid body, and one at rest is bent as others have printed.
//
// What is shown. A rod that hardly gives way moves like the exact body of chapter 5, and the angle between
// both falls with its compliance. A curved cantilever under a load across its plane takes the shape of a
// benchmark that is printed in many places. Read first. Section 10G.
//
//   h   step
//
// Compiled at -O2: it takes many steps.
#include "actio/fast_body/space/free_body.hpp"
#include "actio/rods/rod.hpp"
#include "book/measure.hpp"
#include "book/program.hpp"
#include "witness/semi_discrete_rod.hpp"

using namespace actio;
using namespace actio::rods;
using Table = std::vector<book::Program::Row>;
using List = std::vector<double>;

// 1. A stiff rod, thrown with a spin about no axis of its own, and the exact body of chapter 5.
void rigid(book::Program& program) {
  Table rows;
  List stiffness, errors;
  for (double const s : {1e3, 4e3, 16e3, 64e3}) {
    RodSection const stiff{{s, s, s}, {s / 10, s / 10, s / 10}, 1, {0.06, 0.03, 0.04}};
    auto const rest = RodShape::of_strains(1, 4, {-0.5, 0, 0}, {1, 0, 0, 0});
    RodStart start{rest, {}, {}};
    Three<double> const spin{0.4, 1, 0.7};
    Eigen::Vector3d moments(0.06, 0.03, 0.04);
    for (std::size_t k = 0; k < 5; ++k) {
      auto const& x = rest.places[k];
      start.velocity.push_back(cross(spin, x)), start.angular_velocity.push_back(spin);
      double const part = (k % 4 == 0 ? 0.125 : 0.25) * x[0] * x[0];
      moments[1] += part, moments[2] += part;
    }
    double const h = 0.1 / std::sqrt(s);
    Rod rod(stiff, rest, start, {}, {.step = h});
    rod.step(std::lround(5 / h));
    bodies::FreeBody const body(inertia_from_moments(moments[0], moments[1], moments[2]),
                                {{}, moments.cwiseProduct(Eigen::Vector3d(spin[0], spin[1], spin[2]))});
    auto const& q = body.at(rod.time()).attitude.value;
    auto const between =
        bodies::compose(inverse_turn(Four<double>{q[0], q[1], q[2], q[3]}), rod.frame().attitudes[2]);
    stiffness.push_back(s), errors.push_back(2 * std::hypot(between[1], between[2], between[3]));
    rows.push_back({book::number(s), book::number(h), book::number(errors.back())});
  }
  double const order = -book::exponent(stiffness, errors);
  program.table(
      "rigid", {"stiffness", "h", "angle between the attitudes"}, rows,
      "A stiff rod and the exact rigid body, after time 5; h falls with the root of the stiffness.");
  program.figure("rigid_order", order, "order of the angle in one over the stiffness");
  program.claim(book::measured(order) > 0.97 && book::measured(order) < 1.03,
                "a stiff rod tends to a rigid body, with the first power of its compliance");
}

// 2. A cantilever of an eighth of a circle, radius 100, with a load of 600 across its plane (Bathe and
// Bolourchi 1979: E = 1e7, Poisson's number 0, section a unit square), by Newton's method for its elements.
void bend(book::Program& program) {
  RodSection const square{{1e7, 5e6, 5e6}, {1e7 / 12, 1e7 / 12, 1e7 / 12}, 1, {1, 1, 1}};
  Table rows;
  List lengths, changes;
  Three<double> last{}, limit{};
  for (int const elements : {8, 16, 32, 64, 128}) {
    RodShape arc;
    for (int k = 0; k <= elements; ++k) {
      double const angle = M_PI / 4 * k / elements;
      arc.places.push_back({100 * std::sin(angle), 100 - 100 * std::cos(angle), 0});
      arc.attitudes.push_back({std::cos(angle / 2), 0, 0, std::sin(angle / 2)});
    }
    SemiDiscreteRod rod(square, arc);
    rod.clamped = true;
    rod.load = [](double part) { return EndLoad{{0, 0, 600 * part}, {}}; };
    auto const bent = rod.equilibrium(arc, 20);
    Three<double> tip;
    for (std::size_t i = 0; i < 3; ++i) {
      tip[i] = bent.places.back()[i] - arc.places.back()[i];
      limit[i] = tip[i] + (tip[i] - last[i]) / 3;
    }
    if (elements > 8) {
      lengths.push_back(1.0 / elements);
      changes.push_back(std::hypot(tip[0] - last[0], tip[1] - last[1], tip[2] - last[2]));
    }
    last = tip;
    rows.push_back({std::to_string(elements), book::number(tip[1], 7), book::number(tip[2], 7),
                    book::number(tip[0], 7)});
  }
  rows.push_back(
      {"extrapolated", book::number(limit[1], 7), book::number(limit[2], 7), book::number(limit[0], 7)});
  rows.push_back({"Bathe and Bolourchi", "-13.4", "53.4", "-23.5"});
  program.table("bend", {"elements", "to its side", "along the load", "along its start"}, rows,
                "A curved cantilever: displacement of its end.");
  double const order = book::exponent(lengths, changes);
  program.figure("bend_order", order, "order of the displacement");
  program.claim(book::measured(order) > 1.97 && book::measured(order) < 2.03,
                "the displacement of a curved cantilever has order 2");
  double const from_print =
      std::max({std::abs(limit[1] + 13.4), std::abs(limit[2] - 53.4), std::abs(limit[0] + 23.5)});
  program.claim(book::measured(from_print) < 0.01 * 60,
                "the displacement is the printed one, to a hundredth of its size");
  program.headline(
      "a curved cantilever bends as printed, to " + book::number(from_print / 60, 2) + " of the displacement",
      from_print / 60);
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "a stiff rod is a rigid body, and a curved one bends as printed");
  rigid(program), bend(program);
  return program.finish();
}
