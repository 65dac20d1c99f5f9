// A rubber ball, pulled long and let go: its stresses, by every way the chapter has, and a material that
// forgets which side is out.
//
// What is shown. The ball is stiff inside and soft at its surface, so that x = A(t) X is an exact motion of
// it whatever the material. Its first Piola-Kirchhoff stress is minus its momenta, and is Cauchy's stress
// carried back to the body. That needs an energy that knows the deformation through the Green tensor alone;
// with one that does not, Piola's transformation fails, and the angular momentum of the ball with it. Blown
// up and let go, a neo-Hookean ball bounces for ever. One of St Venant and Kirchhoff collapses into its
// centre, for its energy has no objection. Read first. gas_ellipse; graded_body.hpp proves the motion exact.
//
// Compiled at -O2: it takes many steps.
#include "actio/continuum/stresses.hpp"
#include "actio/jets/field_equations.hpp"
#include "book/plot.hpp"
#include "graded_body.hpp"
#include "witness/draw.hpp"

using namespace actio;
using Matrix3d = actio::Matrix<double, 3, 3>;

// Moduli over the mass density, squares of speeds: the ball has radius 1 and its slow wave speed 1.
OfGreenTensor const neo_hookean{NeoHookean{1.0, LogarithmicVolume<double>{2.0}}};
OfGreenTensor const st_venant_kirchhoff{StVenantKirchhoff<double>{2.0, 1.0}};

// Rubber with fibres that are fixed in space rather than in the body: it knows F^1_2, and not through the
// Green tensor.
struct Lopsided {
  template <class BodyMetric, class SpaceMetric, class S>
  S operator()(Matrix<S, 3, 1> const& X, BodyMetric const& G, SpaceMetric const& g,
               Matrix<S, 3, 3> const& F) const {
    return neo_hookean(X, G, g, F) + F(0, 1) * F(0, 1) * 0.1;
  }
};

// A ball of a material: the graded medium, and A'' = -2 dw/dA of its linear motions.
template <class Energy>
struct Ball {
  Energy w;
  auto medium() const {
    return Continuum{Euclidean<3>{}, Euclidean<3>{}, Homogeneous<double>{}, GradedEnergy{w}};
  }
  template <class S>
  Matrix<S, 3, 3> operator()(Matrix<S, 3, 3> const& A) const {
    Jet<S, 3, 3> centre{Event<S, 3>::Zero(), Matrix<S, 3, 1>::Zero(), Matrix<S, 3, 4>::Zero()};
    centre.v.template rightCols<3>() = A;
    return first_piola_kirchhoff_stress(medium(), centre) * S(-2);
  }
};
template <class Energy>
Ball(Energy) -> Ball<Energy>;
Ball const rubber{neo_hookean};
Ball const stiff{st_venant_kirchhoff};

// 1. The field equations and the ways to the stress are evaluated along the motion, the worst of random
//    particles counting.
struct Misses {
  double equation = 0, momenta = 0, piola = 0, symmetry = 0, turning = 0;
};
template <class Energy>
Misses misses(Ball<Energy> const& ball, LinearState<double, 3> state) {
  auto const medium = ball.medium();
  Draw draw(7);
  Misses most;
  auto const turning = [](auto const& s) {
    return Matrix3d(part_of<3>(s, 0) * part_of<3>(s, 1).transpose() -
                    part_of<3>(s, 1) * part_of<3>(s, 0).transpose());
  };
  auto const first = turning(state);
  for (int k = 0; k < 24; ++k) {
    state = taylor_reference(state_rate<3>(ball), state, 0.25);
    most.turning = std::max(most.turning, (turning(state) - first).norm() / first.norm());
    auto const motion = linear_motion<3>(ball, state, 0, 8);
    Event<double, 3> x = Event<double, 3>::Zero();
    x.tail<3>() = draw.vector<double, Vector<double, 3>>(3) / 2;
    auto const jet = second_jet(motion, x);
    Jet<double, 3, 3> const& one = jet;
    Matrix3d const P = first_piola_kirchhoff_stress(medium, one), sigma = cauchy_stress(medium, one),
                   p = momenta(medium, one).template rightCols<3>();
    Matrix3d const carried = piola_transformation(medium.G(x), medium.g(x), one.gradient(), sigma),
                   spatial = P * one.gradient().transpose();
    most.equation = std::max(most.equation, euler_lagrange(medium, jet).norm() / jet.acceleration().norm());
    most.momenta = std::max(most.momenta, (P + p).norm() / P.norm());
    most.piola = std::max(most.piola, (P - carried).norm() / P.norm());
    most.symmetry = std::max(most.symmetry, (spatial - spatial.transpose()).norm() / spatial.norm());
  }
  return most;
}

// 2. Three balls are thrown and turn; the third is the lopsided one.
std::array<Misses, 3> throw_balls(book::Program& program) {
  Matrix3d A0, V0;
  A0 << 1.4, 0.2, 0, -0.1, 0.8, 0.1, 0, 0, 0.9;
  V0 << 0, -0.5, 0.2, 0.6, 0, 0, 0.1, 0, 0;
  auto const thrown = linear_state<double, 3>(A0, V0);
  std::vector<book::Program::Row> rows;
  auto const follow = [&](char const* name, auto const& ball) {
    Misses const m = misses(ball, thrown);
    rows.push_back({name, book::number(m.equation, 2), book::number(m.momenta, 2), book::number(m.piola, 2),
                    book::number(m.symmetry, 2), book::number(m.turning, 2)});
    return m;
  };
  std::array const found{follow("neo-Hookean", rubber), follow("St Venant and Kirchhoff", stiff),
                         follow("lopsided", Ball{Lopsided{}})};
  program.table("ways", {"material", "equations", "momenta", "Piola", "asymmetry", "turning"}, rows,
                "A ball that is thrown and turns: residual of the field equations; the first "
                "Piola-Kirchhoff stress beside minus the momenta and beside Piola's transformation; "
                "asymmetry of that stress times F; change of the angular momentum. All relative.");
  return found;
}

// 3. A ball is pulled long and let go: half its length and width, and the stresses at its centre along it,
//    are drawn as it swings.
void swing(book::Program& program) {
  auto state = linear_state<double, 3>(Vector<double, 3>(1.6, 0.8, 0.8).asDiagonal(), Matrix3d::Zero());
  auto const medium = rubber.medium();
  std::vector<double> time, length, width, cauchy, piola;
  for (double t = 0; t <= 8; t += 0.04) {
    auto const jet =
        first_jet(linear_motion<3>(rubber, state, 0, 2), Event<double, 3>(Event<double, 3>::Zero()));
    time.push_back(t), length.push_back(jet.v(0, 1)), width.push_back(jet.v(1, 2));
    cauchy.push_back(cauchy_stress(medium, jet)(0, 0)),
        piola.push_back(first_piola_kirchhoff_stress(medium, jet)(0, 0));
    state = taylor_reference(state_rate<3>(rubber), state, 0.04);
  }
  auto axes = book::Plot("time, radii over the speed of shear waves", "half axes; stress over mass density");
  axes.curve(time, length, "half length")
      .curve(time, width, "half width")
      .curve(time, piola, "first Piola-Kirchhoff stress", {.dashed = true})
      .curve(time, cauchy, "Cauchy stress", {.dashed = true});
  program.picture("swing", axes.svg(),
                  "A neo-Hookean ball pulled to 1.6 times its length and let go; stresses at its centre "
                  "along it, over the mass density.");
}

// 4. A ball is blown up and let go: its radius is drawn, and the smallest is the result.
template <class Energy>
double breath(Ball<Energy> const& ball, book::Plot& radii, char const* name) {
  auto state = linear_state<double, 3>(Matrix3d::Identity() * 1.6, Matrix3d::Zero());
  std::vector<double> time, radius;
  for (double t = 0; t <= 4; t += 0.02) {
    time.push_back(t), radius.push_back(state[0]);
    state = taylor_reference(state_rate<3>(ball), state, 0.02);
  }
  radii.curve(time, radius, name);
  return *std::ranges::min_element(radius);
}

int main(int argc, char** argv) {
  book::Program program(
      argc, argv,
      "a rubber ball swings: its stresses by three routes, and a material that lets it turn inside out");
  auto const [a, b, c] = throw_balls(program);
  swing(program);
  auto radii = book::Plot("time, radii over the speed of shear waves", "radius");
  double const smallest = breath(rubber, radii, "neo-Hookean"),
               inside_out = breath(stiff, radii, "St Venant and Kirchhoff");
  program.picture("breath", radii.svg(),
                  "Blown up to 1.6 times its radius and let go. Below zero the ball is inside out.");
  double const exact = std::max(a.equation, b.equation),
               ways = std::max({a.momenta, b.momenta, a.piola, b.piola, a.symmetry, b.symmetry});
  program.figure("equation", exact, "field equations over acceleration");
  program.figure("ways", ways, "largest difference between the ways to the first Piola-Kirchhoff stress");
  program.figure("turning", std::max(a.turning, b.turning), "change of the angular momentum");
  program.figure("lopsided", c.piola, "lopsided: Piola's transformation beside the stress");
  program.figure("lopsided_turning", c.turning, "lopsided: change of the angular momentum");
  program.figure("smallest", smallest, "smallest radius of the neo-Hookean ball");
  program.figure("inside_out", inside_out, "smallest radius of the other");
  program.claim(book::measured(exact) < 1e-12 && book::measured(c.equation) < 1e-12,
                "the field equations vanish on the motion, whatever the material");
  program.claim(book::measured(ways) < 1e-13 && book::measured(c.momenta) < 1e-13,
                "all ways lead to one stress");
  program.claim(book::measured(a.turning) < 1e-12 && book::measured(b.turning) < 1e-12,
                "angular momentum is kept");
  program.claim(book::measured(c.piola) > 1e-3 && book::measured(c.turning) > 1e-3,
                "where the energy knows more than the Green tensor, neither holds");
  program.claim(book::measured(smallest) > 0 && book::measured(inside_out) < 0,
                "the neo-Hookean ball bounces, that of St Venant and Kirchhoff turns inside out");
  program.headline("first Piola-Kirchhoff stress by three ways to " + book::number(ways, 2), ways);
  return program.finish();
}
