// Judge your own map: twenty lines that step a spinning body, and what the instruments say about them.
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

// 1. The first map. Pi' = Pi x Omega; half a step to find the velocity in the middle, a whole step with it,
//    and back to the length of before.
auto const on_the_sphere = [](auto const& h, auto const& pi) {
  using S = typename std::decay_t<decltype(h)>;
  using std::sqrt;
  Matrix<S, 3, 1> const I(S(2), S(3), S(4)), m = pi.components;
  auto const rate = [&](auto const& x) { return cross(x, x.cwiseQuotient(I)); };
  Matrix<S, 3, 1> const middle = m + rate(m) * (h / S(2)), after = m + rate(middle) * h;
  return momentum(pi.group, Matrix<S, 3, 1>(after * sqrt(S(m.squaredNorm() / after.squaredNorm()))));
};

// 2. The second. Turn about axis 1 as fast as Pi_1 says, then about axis 2, about axis 3, and back through 2
//    and 1.
auto const three_turns = [](auto const& h, auto const& pi) {
  using S = typename std::decay_t<decltype(h)>;
  using std::cos, std::sin;
  Matrix<S, 3, 1> const I(S(2), S(3), S(4));
  Matrix<S, 3, 1> m = pi.components;
  auto const turn = [&](int a, S const& time) {
    int const b = (a + 1) % 3, c = (a + 2) % 3;
    S const angle = time * m[a] / I[a], along = m[b], across = m[c];
    m[b] = cos(angle) * along + sin(angle) * across, m[c] = cos(angle) * across - sin(angle) * along;
  };
  turn(0, h / S(2)), turn(1, h / S(2)), turn(2, h), turn(1, h / S(2)), turn(0, h / S(2));
  return momentum(pi.group, m);
};

int main(int argc, char** argv) {
  book::Program program(argc, argv, "two maps of a reader's own, judged without a change in the library");
  auto const pi = momentum(SO<3>{}, Vector3d(4.0, 1.0, 1.5));
  double const h = 0.2;
  constexpr LiePoissonMinus body_momenta;

  // 3. The instruments. A map with its step filled in is judged by its tangent, a family by the way it
  //    leaves.
  struct Verdict {
    double poisson, leaf, back;
  };
  auto const judge = [&](auto const& family) {
    auto const map = [&](auto const& x) { return family(typename std::decay_t<decltype(x)>::Scalar(h), x); };
    return Verdict{poisson_defect(body_momenta, map, pi), leaf_defect(body_momenta, family, h, pi),
                   self_adjointness_defect(body_momenta, family, h, pi)};
  };
  Verdict const first = judge(on_the_sphere), second = judge(three_turns);
  auto const row = [](std::string name, Verdict const& v) {
    return book::Program::Row{std::move(name), book::number(v.poisson, 2), book::number(v.leaf, 2),
                              book::number(v.back, 2)};
  };
  program.table("verdicts", {"map", "Poisson", "leaf", "way back"},
                {row("back on the sphere", first), row("three turns", second)},
                "Defects of one step of 0.2 s.");

  // 4. What it comes to: where each of them is after a while. Both have order 2. The true motion goes round
  // one closed curve; the first map dissipates energy and winds away from it.
  auto const energy = [](auto const& x) {
    return x.components.cwiseAbs2().cwiseQuotient(Vector3d(4, 6, 8)).sum();
  };
  auto sphere = book::Sphere(35, 25).axes({"1", "2", "3"});
  double lost[2] = {0, 0}, worst[2] = {0, 0};
  auto const run = [&](int which, auto const& family, std::string const& name) {
    auto x = pi;
    for (int round = 0; round < 5; ++round) {
      std::vector<Vector3d> path;
      for (int k = 0; k < 1200; ++k) {
        if (k < 42) path.push_back(x.components.normalized());  // once round
        x = family(h, x);
        lost[which] = energy(x) / energy(pi) - 1,
        worst[which] = std::max(worst[which], std::abs(lost[which]));
      }
      sphere.curve(path, round == 0 ? name : "", {.colour = which == 0 ? 2 : 1, .width = 1.2});
    }
  };
  run(0, on_the_sphere, "back on the sphere"), run(1, three_turns, "three turns");
  program.picture("paths", sphere.svg(),
                  "The direction of the momentum: once round at the start, and after 1200, 2400, 3600 and "
                  "4800 steps. The true motion is one closed "
                  "curve. The three turns stay on theirs; what is put back on the sphere after every step "
                  "winds away, and never leaves the sphere.");
  program.figure("poisson_first", first.poisson, "Poisson defect of the map that is put back on the sphere");
  program.figure("poisson_second", second.poisson, "Poisson defect of the three turns");
  program.figure("energy_first", 100 * lost[0], book::number(100 * lost[0], 2) + " %",
                 "change of the energy after 6000 steps, put back on the sphere");
  program.figure("energy_second", 100 * worst[1], book::number(100 * worst[1], 2) + " %",
                 "largest change of the energy, three turns");

  // The start was chosen so that this can be seen. From another one, nearer the middle axis, the same two
  // maps over as many steps.
  auto const other = momentum(SO<3>{}, Vector3d(1.0, 4.0, 1.5));
  auto const largest_change = [&](auto const& family) {
    double largest = 0;
    auto x = other;
    for (int k = 0; k < 6000; ++k)
      x = family(h, x), largest = std::max(largest, std::abs(energy(x) / energy(other) - 1));
    return 100 * largest;
  };
  double const elsewhere[] = {largest_change(on_the_sphere), largest_change(three_turns)};
  program.figure("elsewhere_first", elsewhere[0], book::number(elsewhere[0], 2) + " %",
                 "from another start, largest change of energy, back on the sphere");
  program.figure("elsewhere_second", elsewhere[1], book::number(elsewhere[1], 2) + " %",
                 "the same for the three turns");

  // 5. What must be so. A few epsilon are rounding.
  double const rounding = 100 * 0x1p-52;
  program.claim(book::measured(first.leaf) < rounding && book::measured(second.leaf) < rounding,
                "both maps stay on the coadjoint orbit");
  program.claim(book::measured(second.poisson) < rounding && book::measured(second.back) < rounding,
                "the three turns are Poisson and go back the way they came");
  program.claim(book::measured(first.poisson) > rounding && book::measured(first.back) > rounding,
                "the map that is put back on the sphere does neither");
  program.claim(book::measured(std::abs(lost[0])) > 10 * worst[1],
                "it dissipates energy, more than ten times what that of the three turns goes up and down by");
  program.headline("on the sphere to " + book::number(first.leaf, 1) + " and not Poisson by " +
                       book::number(first.poisson, 2),
                   first.poisson);
  return program.finish();
}
