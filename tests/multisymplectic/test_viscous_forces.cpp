// The forces of von Neumann and Richtmyer's viscosity against their formula, corner by corner.
#include <boost/test/unit_test.hpp>

#include "actio/media_on_meshes/artificial_viscosity.hpp"
#include "plain_body.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::media;
using namespace actio::testing;

namespace {
/// Forces of viscosity by their formula, corner by corner, and the longest steps: about the compressed points
/// and about all.
struct PlainViscosity {
  std::vector<double> forces;
  ViscousLimit compressed, all;
};
template <int d>
PlainViscosity plain_viscosity(Sample const& s, ArtificialViscosity const& by) {
  using Square = Matrix<double, d, d>;
  PlainBody<d> const plain{s.mesh};
  auto const nodes = [&](int cell, int p) {
    auto const& all = s.mesh.cells[cell];
    return plain.simplex ? std::vector<int>(all.begin(), all.begin() + plain.corners) : std::vector{all[p]};
  };
  std::vector<double> volumes(s.mesh.nodes.size(), 0);
  auto const masses = plain.masses();
  auto const for_points = [&](auto const& f) {
    for (int cell = 0; cell < int(s.mesh.cells.size()); ++cell)
      for (int p = 0; p < plain.points; ++p) f(cell, p, nodes(cell, p));
  };
  for_points([&](int cell, int p, auto const& at) {
    for (int node : at) volumes[node] += plain.volume(cell, p) / double(at.size());
  });
  PlainViscosity out{std::vector<double>(s.x.size(), 0), {}, {}};
  std::vector<Dual<double>> moved;
  for (double const x : s.x) moved.emplace_back(x);
  for_points([&](int cell, int p, auto const& at) {
    double rho = 0;
    for (int node : at) rho += masses[node] / volumes[node] / double(at.size());
    double const volume = plain.volume(cell, p), weight = plain.weight(cell, p);
    Square const F = plain.gradient(s.x, cell, p), a = plain.edges(s.x, cell, p);
    // The gradient is affine in the places, with the periods in its constant: velocities have its linear
    // part.
    std::vector<double> next = s.x;
    for (std::size_t k = 0; k < next.size(); ++k) next[k] += s.u[k];
    Square const rates = (plain.gradient(next, cell, p) - F) * inverse_matrix(F);
    double r = 0, face = d == 1 ? 1 : 0;
    for (int i = 0; i < d; ++i) r -= rates(i, i);
    r = std::max(r, 0.0);
    for (int i = 0; i < d; ++i) {
      if (d == 2) face = std::max(face, a.col(i).norm());
      auto const &e = a.col((i + 1) % d), &g = a.col((i + 2) % d);
      if (d == 3) face = std::max(face, std::sqrt(e.squaredNorm() * g.squaredNorm() - e.dot(g) * e.dot(g)));
    }
    double const J = small_determinant(F), l = small_determinant(a) / face;
    // Along a dilation s F the pressure is -W'(s)/(d s^(d-1) J), and c^2 = -J^2 dp/dJ by mass.
    auto const W = [&]<class T>(Matrix<T, 1, 1> const& t) -> T {
      return Fibred{}(Matrix<T, d, d>(F.template cast<T>() * t[0]));
    };
    auto const slope = [&]<class T>(Matrix<T, 1, 1> const& t) -> Matrix<T, 1, 1> {
      return derivative(W, t).gradient();
    };
    Matrix<double, 1, 1> const one(1.0);
    double const first = slope(one)[0], second = derivative(slope, one).matrix(0, 0);
    double const c = std::sqrt(std::max(0.0, (second - (d - 1) * first) / (d * d) * weight / (rho * volume)));
    double const q = rho / J * (by.quadratic * l * r * l * r + by.linear * l * c * r);
    double const longest = l / (2 * (by.linear * c + 2 * by.quadratic * l * r));
    if (longest < out.all.step) out.all = {longest, cell};
    if (q > 0 && longest < out.compressed.step) out.compressed = {longest, cell};
    for (std::size_t k = 0; k < s.x.size(); ++k) {
      moved[k] = variable(s.x[k]);
      out.forces[k] += q * volume * rate_of(small_determinant(plain.gradient(moved, cell, p)));
      moved[k] = Dual<double>(s.x[k]);
    }
  });
  return out;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(viscous_forces)

// On meshes and motions without any symmetry, with a density that varies: some points are compressed, others
// are not.
BOOST_AUTO_TEST_CASE(forces_and_longest_steps_are_those_of_the_formula_on_every_shape) {
  auto const held = []<int d>(Sample const& s) {
    auto const law = stored_energy<d>(Weighed{Fibred{}, 2.0});
    auto const rho = [](Spot<d> const& X) { return density_at(X); };
    BodyQuadrature<d> const body(s.mesh, *law, rho);
    for (ArtificialViscosity const by : {ArtificialViscosity{0.5, 2}, {0.7, 0}, {0, 1.5}}) {
      ViscousForces<d> const viscous(by, body);
      auto const plain = plain_viscosity<d>(s, by);
      std::vector<double> f;
      auto const found = viscous.forces(body, *law, s.x, s.u, f), all = viscous.limit(body, *law, s.x, s.u);
      // Some hundred roundings of forces below a hundred.
      double const rounding = 100 * 100 * std::numeric_limits<double>::epsilon();
      BOOST_TEST_CONTEXT(name_of(s.mesh.shape) << "s, " << by.linear << " and " << by.quadratic) {
        BOOST_TEST(apart(f, plain.forces) <= rounding);
        BOOST_TEST(found.cell == plain.compressed.cell);
        BOOST_TEST(std::abs(1 / found.step - 1 / plain.compressed.step) <= 10 * rounding);
        BOOST_TEST(all.cell == plain.all.cell);
        BOOST_TEST(std::abs(1 / all.step - 1 / plain.all.step) <= 10 * rounding);
      }
      std::vector<double> const before = plus(s.u, s.x, 0.2), after = plus(s.u, f, -0.1);
      double work = 0;
      for (std::size_t k = 0; k < f.size(); ++k) work -= f[k] * (before[k] / 2 + after[k] / 2) * 0.3;
      BOOST_TEST(std::abs(ViscousForces<d>::taken(f, 0.3, before, after) - work) <= 10 * rounding);
      BOOST_TEST(viscous.bytes() == body.points.size() * sizeof(double));
    }
  };
  on_every_shape([&]<int d>(Sample s) {
    held.template operator()<d>(s);
    for (double& one : s.u) one = -one;
    held.template operator()<d>(s);
  });
}

BOOST_AUTO_TEST_CASE(a_coefficient_that_is_negative_is_refused_with_its_value) {
  BodyQuadrature<1> const body(box_mesh({0}, {1}, {2}), *stored_energy<1>(isentropic_gas(1, 2)),
                               [](Spot<1> const&) { return 1.0; });
  for (ArtificialViscosity const by : {ArtificialViscosity{-0.5, 2}, {2, -0.5}})
    BOOST_CHECK_EXCEPTION(ViscousForces<1>(by, body), OutsideDomain,
                          [](OutsideDomain const& e) { return e.measured == -0.5 && e.bound == 0; });
  CHECK_REFUSED(ViscousForces<1>({HUGE_VAL, 0}, body), NotFinite);
  ViscosityNeedsShorterSteps const error(7, 0.25, 0.125);
  BOOST_TEST(error.cell == 7);
  BOOST_TEST(error.measured == 0.25);
  BOOST_TEST(error.bound == 0.125);
}

BOOST_AUTO_TEST_SUITE_END()
