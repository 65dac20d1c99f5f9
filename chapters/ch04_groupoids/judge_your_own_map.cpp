// A map of your own: twenty lines that step a spinning body, and what the instruments say about them.
//
// What is shown. A map of your own is a function from a momentum to a momentum, written with `auto` so that
// it takes every kind of number; nothing else is needed to judge it. Here are two readers' maps. The first
// takes a midpoint step and puts the momentum back on its sphere, which looks right for ever: the length of
// the momentum never changes. The second rests on an idea, that the field of a spinning body is a sum of
// three turns about fixed axes, and carries each of them out exactly. Read first. judging_integrators.
//
//   Pi     momentum in the body frame, J s          h      step, s
//   I      principal moments of inertia, kg m^2
#include "actio/groups/rotations.hpp"
#include "actio/instruments/leaf_defect.hpp"
#include "actio/instruments/poisson_defect.hpp"
#include "actio/instruments/reversibility_defect.hpp"
#include "book/sphere.hpp"

using namespace actio;
using Vector3d = actio::Vector<double, 3>;
using BodyMomentum = Momentum<SO<3>, double>;
constexpr double h = 0.2;

// 1. The first map. Pi' = Pi x Omega; half a step to find the velocity in the middle, a whole step with it,
//    and back to the length of before.
auto const on_the_sphere = [](auto const& step, auto const& pi) {
  using S = typename std::decay_t<decltype(step)>;
  using std::sqrt;
  Matrix<S, 3, 1> const I(S(2), S(3), S(4)), m = pi.components;
  auto const rate = [&](auto const& x) { return cross(x, x.cwiseQuotient(I)); };
  Matrix<S, 3, 1> const middle = m + rate(m) * (step / S(2)), after = m + rate(middle) * step;
  return momentum(pi.group, Matrix<S, 3, 1>(after * sqrt(S(m.squaredNorm() / after.squaredNorm()))));
};

// 2. The second. Turn about axis 1 as fast as Pi_1 says, then about axis 2, about axis 3, and back through 2
//    and 1.
auto const three_turns = [](auto const& step, auto const& pi) {
  using S = typename std::decay_t<decltype(step)>;
  using std::cos, std::sin;
  Matrix<S, 3, 1> const I(S(2), S(3), S(4));
  Matrix<S, 3, 1> m = pi.components;
  auto const turn = [&](int a, S const& time) {
    int const b = (a + 1) % 3, c = (a + 2) % 3;
    S const angle = time * m[a] / I[a], along = m[b], across = m[c];
    m[b] = cos(angle) * along + sin(angle) * across, m[c] = cos(angle) * across - sin(angle) * along;
  };
  turn(0, step / S(2)), turn(1, step / S(2)), turn(2, step), turn(1, step / S(2)), turn(0, step / S(2));
  return momentum(pi.group, m);
};

// 3. The instruments. A map with its step filled in is judged by its tangent, a family by the way it leaves.
struct Verdict {
  double poisson, leaf, back;
};
template <class Family>
Verdict judge(Family const& family, BodyMomentum const& pi) {
  constexpr LiePoissonMinus body_momenta;
  auto const map = [&](auto const& x) { return family(typename std::decay_t<decltype(x)>::Scalar(h), x); };
  return {poisson_defect(body_momenta, map, pi), leaf_defect(body_momenta, family, h, pi),
          self_adjointness_defect(body_momenta, family, h, pi)};
}

// 4. What it comes to: 6000 steps, and by how much the energy has changed. Both maps have order 2. The true
//    motion goes round one closed curve, which is drawn at the start and after 1200, 2400, ... steps.
double energy(BodyMomentum const& x) {
  return x.components.cwiseAbs2().cwiseQuotient(Vector3d(4, 6, 8)).sum();
}
struct EnergyChange {
  double at_the_end = 0, largest = 0;
};
template <class Family>
EnergyChange run(Family const& family, BodyMomentum const& start, std::vector<std::vector<Vector3d>>& loops) {
  EnergyChange change;
  auto x = start;
  for (int k = 0; k < 6000; ++k) {
    if (k % 1200 == 0) loops.emplace_back();
    if (k % 1200 < 42) loops.back().push_back(x.components.normalized());  // once round
    x = family(h, x);
    change.at_the_end = energy(x) / energy(start) - 1;
    change.largest = std::max(change.largest, std::abs(change.at_the_end));
  }
  return change;
}
void draw(book::Sphere& sphere, std::vector<std::vector<Vector3d>> const& loops, std::string const& name,
          int colour) {
  for (auto const& loop : loops)
    sphere.curve(loop, &loop == &loops.front() ? name : "", {.colour = colour, .width = 1.2});
}
std::string percent(double x) { return book::number(100 * x, 2) + " %"; }

// 5. Both maps, judged and run; the start was chosen so that the difference can be seen. From another one,
//    nearer the middle axis, the same two maps over as many steps.
int judge_both(book::Program& program) {
  auto const pi = momentum(SO<3>{}, Vector3d(4.0, 1.0, 1.5)),
             other = momentum(SO<3>{}, Vector3d(1.0, 4.0, 1.5));
  Verdict const first = judge(on_the_sphere, pi), second = judge(three_turns, pi);
  auto const row = [](std::string name, Verdict const& v) {
    return book::Program::Row{std::move(name), book::number(v.poisson, 2), book::number(v.leaf, 2),
                              book::number(v.back, 2)};
  };
  program.table("verdicts", {"map", "Poisson", "leaf", "way back"},
                {row("back on the sphere", first), row("three turns", second)},
                "Defects of one step of 0.2 s.");
  std::vector<std::vector<Vector3d>> winding, closed, unseen;
  auto const lost = run(on_the_sphere, pi, winding), swing = run(three_turns, pi, closed),
             lost_elsewhere = run(on_the_sphere, other, unseen),
             swing_elsewhere = run(three_turns, other, unseen);
  auto sphere = book::Sphere(35, 25).axes({"1", "2", "3"});
  draw(sphere, winding, "back on the sphere", 2), draw(sphere, closed, "three turns", 1);
  program.picture("paths", sphere.svg(),
                  "The direction of the momentum: once round at the start, and after 1200, 2400, 3600 and "
                  "4800 steps. The true motion is one closed curve. The three turns stay on theirs; what "
                  "is put back on the sphere after every step winds away, and never leaves the sphere.");
  program.figure("poisson_first", first.poisson, "Poisson defect of the map that is put back on the sphere");
  program.figure("poisson_second", second.poisson, "Poisson defect of the three turns");
  program.figure("energy_first", 100 * lost.at_the_end, percent(lost.at_the_end),
                 "change of the energy after 6000 steps, put back on the sphere");
  program.figure("energy_second", 100 * swing.largest, percent(swing.largest),
                 "largest change of the energy, three turns");
  program.figure("elsewhere_first", 100 * lost_elsewhere.largest, percent(lost_elsewhere.largest),
                 "from another start, largest change of energy, back on the sphere");
  program.figure("elsewhere_second", 100 * swing_elsewhere.largest, percent(swing_elsewhere.largest),
                 "the same for the three turns");

  // 6. What must be so. A few epsilon are rounding.
  double const rounding = 100 * 0x1p-52;
  using book::measured;
  program.claim(measured(std::max(first.leaf, second.leaf)) < rounding,
                "both maps stay on the coadjoint orbit");
  program.claim(measured(second.poisson) < rounding, "the three turns are Poisson");
  program.claim(measured(second.back) < rounding, "and go back the way they came");
  program.claim(measured(first.poisson) > rounding, "the map that is put back on the sphere is not Poisson");
  program.claim(measured(first.back) > rounding, "and does not go back the way it came");
  program.claim(measured(std::abs(lost.at_the_end)) > 10 * swing.largest,
                "it dissipates energy, more than ten times what that of the three turns goes up and down by");
  program.headline("on the sphere to " + book::number(first.leaf, 1) + " and not Poisson by " +
                       book::number(first.poisson, 2),
                   first.poisson);
  return program.finish();
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "two maps of a reader's own, judged without a change in the library");
  return judge_both(program);
}
