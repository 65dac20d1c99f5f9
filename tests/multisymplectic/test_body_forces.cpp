// What acts inside of a body on any mesh and on it, against the definition of its energy.
#include <boost/test/unit_test.hpp>

#include "plain_body.hpp"

using namespace actio;
using namespace actio::media;
using namespace actio::testing;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();

/// Loads of every kind: a hill with its curvature, a bowl of which none is known, tractions and pressures.
template <int d>
BodyLoads<d> all_loads(BodyMesh const& mesh) {
  BodyLoads<d> loads;
  loads.potentials.push_back(space_potential<d>(Hill{}));
  loads.potentials.push_back({[](Spot<d> const& x) {
                                double square = 0;
                                for (double const one : x) square += one * one;
                                return 0.4 * square;
                              },
                              [](Spot<d> x) {
                                for (double& one : x) one *= 0.8;
                                return x;
                              },
                              {}});
  loads.outside_pressure = 0.35;
  double size = 0.2;
  for (auto const& side : mesh.sides) {
    for (int a = 0; a < d; ++a) loads.tractions[side.first][std::size_t(a)] = size += 0.13;
    loads.pressures[side.first] = [size](double t) { return size - t; };
  }
  return loads;
}

template <int d>
void against_the_definition(Sample const& s) {
  auto const law = stored_energy<d>(Weighed{Fibred{}, 2.0});
  auto const rho = [](Spot<d> const& X) { return density_at(X); };
  PlainBody<d> plain{s.mesh};
  BodyForces<d> const alone(s.mesh, law, rho, {}), loaded(s.mesh, law, rho, all_loads<d>(s.mesh));
  BOOST_TEST_CONTEXT(name_of(s.mesh.shape) << "s, periodic: " << !s.mesh.wraps.empty()) {
    // Numbers below 20 are sums of some tens of terms, each of them rounded some ten times.
    double const bound = 20 * 300 * eps;
    BOOST_TEST(apart(alone.body.masses, plain.masses()) <= bound);
    List<double> f, g;
    BOOST_TEST(std::abs(alone.stored(s.x) - plain.energy(s.x)) <= bound);
    BOOST_TEST(alone.of_loads(s.x) == 0);
    LeastJacobian const least = alone.forces(s.x, 0, f);
    BOOST_TEST(apart(f, plain.forces(s.x)) <= bound);
    // Loads: what has a potential is in the energy, tractions by their work, pressures not at all.
    auto const dead = [&](List<double> const& x) {
      List<double> out(x.size(), 0);
      for (auto const& [name, traction] : all_loads<d>(s.mesh).tractions)
        for (auto const& facet : s.mesh.sides.at(name))
          for (auto const& [node, area] : plain.areas(plain.reference(), facet)) {
            double square = 0;
            for (double const one : area) square += one * one;
            for (std::size_t a = 0; a < d; ++a)
              out[std::size_t(node * d) + a] += std::sqrt(square) * traction[a];
          }
      return out;
    };
    auto const following = [&](List<double> const& x, double t) {
      List<double> out(x.size(), 0);
      for (auto const& [name, pressure] : all_loads<d>(s.mesh).pressures)
        for (auto const& facet : s.mesh.sides.at(name))
          for (auto const& [node, area] : plain.areas(x, facet))
            for (std::size_t a = 0; a < d; ++a) out[std::size_t(node * d) + a] -= pressure(t) * area[a];
      return out;
    };
    plain.pressure = 0.35, plain.hill = 1, plain.bowl = 0.4;
    auto const pull = dead(s.x);
    double work = 0;
    for (std::size_t k = 0; k < pull.size(); ++k) work += pull[k] * s.x[k];
    BOOST_TEST(std::abs(loaded.stored(s.x) + loaded.of_loads(s.x) - plain.energy(s.x) + work) <= bound);
    loaded.forces(s.x, 0.7, g);
    BOOST_TEST(apart(g, plus(plus(plain.forces(s.x), pull, 1), following(s.x, 0.7), 1)) <= bound);

    // The second derivative along u; the bowl says nothing of its own.
    plain.bowl = 0;
    List<Dual<double>> along;
    for (std::size_t k = 0; k < s.x.size(); ++k)
      along.push_back(Dual<double>(s.x[k]) + variable(0.0) * s.u[k]);
    List<double> rate;
    for (auto const& one : plain.forces(along)) rate.push_back(-rate_of(one));
    loaded.stiffness(s.x, s.u, g);
    BOOST_TEST(apart(g, rate) <= 10 * bound);

    // The least Jacobian, its cell and what the points of each have.
    double lowest = HUGE_VAL;
    int cell = -1;
    for (int c = 0; c < int(s.mesh.cells.size()); ++c)
      for (int p = 0; p < plain.points; ++p)
        if (double const J = small_determinant(plain.gradient(s.x, c, p)); J < lowest) lowest = J, cell = c;
    for (auto const& found : {least, alone.least_jacobian(s.x)}) {
      BOOST_TEST(std::abs(found.jacobian - lowest) <= bound);
      BOOST_TEST(found.cell == cell);
    }
    int calls = 0;
    alone.each_point(s.x, [&](int c, int p, CellPoint<d> const& point, Matrix<double, d, d> const& F) {
      BOOST_TEST(c == calls / plain.points);
      BOOST_TEST(p == calls++ % plain.points);
      BOOST_TEST(std::abs(point.volume - plain.volume(c, p)) <= bound);
      BOOST_TEST(std::abs(point.weight - plain.weight(c, p)) <= bound);
      BOOST_TEST(magnitude(Matrix<double, d, d>(F - plain.gradient(s.x, c, p))) <= bound);
    });
    BOOST_TEST(calls == int(s.mesh.cells.size()) * plain.points);
  }
}

/// The forces between two places: their work is the decrease of the energy, and those inside have no sum and
/// no torque about the middle. Halfway they differ from the forces in the middle by the square of the way.
template <int d>
void between_two_places(Sample const& s) {
  auto const law = stored_energy<d>(Weighed{Fibred{}, 2.0});
  auto const rho = [](Spot<d> const& X) { return density_at(X); };
  auto loads = all_loads<d>(s.mesh);
  loads.pressures.clear();
  BodyForces<d> const inside(s.mesh, law, rho, {}), loaded(s.mesh, law, rho, loads);
  List<double> const none(s.x.size(), 0), minus = plus(none, s.u, -0.01);
  auto const energy = [](BodyForces<d> const& f, List<double> const& x) {
    return f.stored(x) + f.of_loads(x);
  };
  BOOST_TEST_CONTEXT(name_of(s.mesh.shape) << "s, periodic: " << !s.mesh.wraps.empty()) {
    double const bound = 20 * 300 * eps;
    // Small ways, and those where the energies themselves are subtracted.
    for (double const size : {1e-5, 1e-3, 0.01, 0.03, 0.06})
      for (auto const* forces : {&inside, &loaded}) {
        List<double> f, way = plus(none, s.u, size);
        LeastJacobian const least = forces->discrete_forces(s.x, none, way, 0.3, f),
                            there = forces->least_jacobian(plus(s.x, way, 1));
        BOOST_TEST(std::abs(least.jacobian - there.jacobian) <= bound);
        BOOST_TEST(least.cell == there.cell);
        double work = 0;
        for (std::size_t k = 0; k < f.size(); ++k) work += f[k] * way[k];
        BOOST_TEST(std::abs(work + energy(*forces, plus(s.x, way, 1)) - energy(*forces, s.x)) <= bound);
        if (forces == &loaded) continue;
        Matrix<double, d, d> torque = Matrix<double, d, d>::Zero();
        Spot<d> sum{};
        for (std::size_t k = 0; k < f.size(); k += d)
          for (std::size_t a = 0; a < d; ++a) {
            sum[a] += f[k + a];
            for (std::size_t b = 0; b < d; ++b) torque(a, b) += (s.x[k + a] + way[k + a] / 2) * f[k + b];
          }
        for (double const one : sum) BOOST_TEST(std::abs(one) <= bound);
        if (s.mesh.wraps.empty())
          BOOST_TEST(magnitude(Matrix<double, d, d>(torque - torque.transpose())) <= bound);
      }
    double off[3];
    for (int k = 0; k < 3; ++k) {
      List<double> f, in_the_middle, way = plus(none, s.u, 0.004 / (1 << k));
      loaded.discrete_forces(s.x, none, way, 0.3, f);
      loaded.forces(plus(s.x, way, 0.5), 0.3, in_the_middle);
      off[k] = apart(f, in_the_middle);
    }
    BOOST_TEST(std::abs(std::log2(off[0] / off[1]) - 2) <= 0.1);
    BOOST_TEST(std::abs(std::log2(off[1] / off[2]) - 2) <= 0.1);
    // What places have beyond their rounded numbers is a part of them.
    List<double> f, g, way = plus(none, s.u, 0.02);
    inside.discrete_forces(plus(s.x, minus, -1), minus, way, 0, f),
        inside.discrete_forces(s.x, none, way, 0, g);
    BOOST_TEST(apart(f, g) <= bound);
  }
}
}  // namespace

BOOST_AUTO_TEST_SUITE(body_forces)

BOOST_AUTO_TEST_CASE(forces_energies_and_stiffness_are_the_derivatives_of_the_energy_on_every_shape) {
  on_every_shape([]<int d>(Sample const& s) { against_the_definition<d>(s); });
}

BOOST_AUTO_TEST_CASE(forces_between_two_places_do_the_work_of_the_energy_and_turn_nothing) {
  on_every_shape([]<int d>(Sample const& s) { between_two_places<d>(s); });
}

// A follower load acts where the middle is, at the time that is given.
BOOST_AUTO_TEST_CASE(pressures_between_two_places_are_those_of_the_middle) {
  on_every_shape([]<int d>(Sample const& s) {
    BodyLoads<d> loads;
    loads.pressures = all_loads<d>(s.mesh).pressures;
    auto const law = stored_energy<d>(Fibred{});
    auto const rho = [](Spot<d> const& X) { return density_at(X); };
    BodyForces<d> const inside(s.mesh, law, rho, {}), loaded(s.mesh, law, rho, loads);
    List<double> const none(s.x.size(), 0), way = plus(none, s.u, 0.03), middle = plus(s.x, way, 0.5);
    List<double> a, b, f, g;
    inside.discrete_forces(s.x, none, way, 0.3, a), loaded.discrete_forces(s.x, none, way, 0.3, b);
    inside.forces(middle, 0.3, f), loaded.forces(middle, 0.3, g);
    BOOST_TEST(apart(plus(b, a, -1), plus(g, f, -1)) <= 100 * 20 * eps);
  });
}

BOOST_AUTO_TEST_SUITE_END()
