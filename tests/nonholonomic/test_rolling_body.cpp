// The steps of a rolling body that are written out are those of its formulas.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/nonholonomic/rolling_steps.hpp"
#include "actio/reduction/composition.hpp"
#include "refused.hpp"
#include "rolling_systems.hpp"

using namespace actio;
using namespace actio::systems;
using namespace actio::testing;

namespace {

using Three = Triad<double>;
Three three(Triple const& x) { return {x[0], x[1], x[2]}; }
double apart(Three const& a, Triple const& b) {
  return std::max({std::abs(a.x - b[0]), std::abs(a.y - b[1]), std::abs(a.z - b[2])});
}

/// Both roads from an angular velocity and a normal.
void both_agree(char const* name, RollingBody<Ellipsoid> const& body, Triple const& w, Triple const& u,
                double h, int steps) {
  auto const& [half_axes, above] = body.shape;
  Constrained const system(
      "SE(3)",
      "(A*w1^2 + B*w2^2 + C*w3^2)/2 + F*w2*w3 + G*w1*w3 + H*w1*w2 + m*(v1^2 + v2^2 + v3^2)/2"
      " - m*g*(S - s*up3)",
      point_rests, {"up"},
      {{"A", body.inertia[0]},
       {"B", body.inertia[1]},
       {"C", body.inertia[2]},
       {"F", body.inertia[3]},
       {"G", body.inertia[4]},
       {"H", body.inertia[5]},
       {"m", body.mass},
       {"g", body.gravity},
       {"a", half_axes[0]},
       {"b", half_axes[1]},
       {"c", half_axes[2]},
       {"s", above}},
      "S = sqrt((a*up1)^2 + (b*up2)^2 + (c*up3)^2); r1 = -a^2*up1/S; r2 = -b^2*up2/S; r3 = s - c^2*up3/S;");
  auto const contact = [&](Triple const& normal) {
    auto const r = body.shape(three(normal));
    return Triple(r.x, r.y, r.z);
  };
  for (int const order : {2, 4}) {
    auto const fractions = symmetric_composition<double>(order);
    auto run = system.run(h, fractions, system.state(rolling_velocity(w, contact(u)), direction(u)));
    run.follow_configuration(Eigen::MatrixXd::Identity(4, 4));
    RollingSteps<Ellipsoid> fast(body, h, fractions, three(w), three(u));
    fast.follow({});
    double size = 0, momentum = 0, normal = 0, velocity = 0, place = 0, turned = 0, way = 0;
    for (int k = 0; k < steps; ++k) {
      run.step(), fast.step();
      auto const now = run.state();
      Triple const up = triple(now.point.vectors, 0),
                   about = triple(now.point.momentum, 0) -
                           testing::cross(contact(up), triple(now.point.momentum, 3));
      size = std::max(size, about.norm()), momentum = std::max(momentum, apart(fast.momentum(), about));
      normal = std::max(normal, apart(fast.normal(), up));
      velocity = std::max(velocity, apart(fast.velocity(), triple(now.velocity, 0)));
      Eigen::MatrixXd const& g = run.configuration();
      place = std::max(place, apart(fast.place()->centre, g.col(3).head<3>()));
      way = std::max(way, g.col(3).head<3>().norm());
      for (Index i = 0; i < 3; ++i)
        turned = std::max(turned, apart(fast.place()->axes[static_cast<std::size_t>(i)], g.row(i).head<3>()));
    }
    BOOST_TEST_MESSAGE(name << ", order " << order << ": momentum " << momentum / size << ", normal "
                            << normal << ", axes " << turned << ", place " << place / way);
    BOOST_TEST_CONTEXT(name << ", order " << order) {
      // Up to five hundred substeps, each with some sixteen roundings on either road.
      double const room = 500 * 16 * 0x1p-52;
      BOOST_TEST(momentum < room * size);
      BOOST_TEST(normal < room);
      BOOST_TEST(velocity < room * w.norm());
      BOOST_TEST(turned < room);
      BOOST_TEST(place < room * way);
    }
  }
}

RollingBody<Ellipsoid> const rattleback{{{20, 3, 2}, 1}, {2, 16, 17, 0, 0, -0.2}, 1, 981};

}  // namespace

BOOST_AUTO_TEST_SUITE(rolling_bodies)

BOOST_AUTO_TEST_CASE(both_roads_are_one) {
  Rattleback const body;
  both_agree("rattleback", rattleback, -5 * body.up, body.up, 0.001, 100);
  both_agree("lopsided egg", {{{1.2, 1, 0.9}, 0.2}, {1, 2, 2.5, 0.3, -0.1, 0.2}, 1.7, 3}, {0.9, -0.4, 1.2},
             {0.36, 0.48, 0.8}, 0.05, 100);
  both_agree("disc", {{{1, 1, 0}, 0}, {0.25, 0.25, 0.5, 0, 0, 0}, 1, 1}, {0.1, 0.3, 1.4}, {0, 0.96, 0.28},
             0.05, 100);
  // Long steps, up to nearly a radian, need all terms of the series.
  both_agree("ball", {{{1, 1, 1}, 0}, {1, 2, 2.5, 0, 0, 0}, 1, 0}, {0.9, -0.4, 1.2}, {0.36, 0.48, 0.8}, 0.4,
             10);
}

BOOST_AUTO_TEST_CASE(the_spin_of_a_rattleback_after_twelve_seconds) {
  // To 1e-4 by order 4 with 8500 steps; the truth by order 8, which half as many steps do not change.
  Rattleback const body;
  auto const spin_after = [&](int order, int count) {
    RollingSteps<Ellipsoid> run(rattleback, 12.0 / count, symmetric_composition<double>(order),
                                three(-5 * body.up), three(body.up));
    for (int k = 0; k < count; ++k) run.step();
    return dot(run.velocity(), run.normal());
  };
  double const truth = spin_after(8, 4800), coarser = spin_after(8, 2400), spin = spin_after(4, 8500);
  BOOST_TEST_MESSAGE("rattleback after 12 s: spin " << truth << " rad/s, order 4 with 8500 steps is off by "
                                                    << std::abs(spin - truth));
  BOOST_TEST(std::abs(coarser - truth) < 1e-4);
  BOOST_TEST(std::abs(spin - truth) < 1e-4);
}

BOOST_AUTO_TEST_CASE(bodies_without_a_contact_are_refused) {
  RollingBody<Ellipsoid> const disc{{{1, 1, 0}, 0}, {0.25, 0.25, 0.5, 0, 0, 0}, 1, 1};
  auto const start = [](RollingBody<Ellipsoid> const& body, Three const& w, Three const& u) {
    return RollingSteps<Ellipsoid>(body, 0.01, {1}, w, u);
  };
  CHECK_REFUSED(start(disc, {0, 0, 1}, {0, 0, 1}), NotFinite);
  CHECK_REFUSED(start(disc, {std::nan(""), 0, 1}, {0, 1, 0}), NotFinite);
  RollingBody<Ellipsoid> const needle{{{1, 0, 0}, 0}, {0, 0, 0, 0, 0, 0}, 1, 1};
  CHECK_REFUSED(start(needle, {0, 0, 1}, {0.6, 0.8, 0}).step(), Singular);
  // Too long a step: the run stays where it was.
  Rattleback const body;
  RollingSteps<Ellipsoid> run(rattleback, 0.01, symmetric_composition<double>(4), three(-5 * body.up),
                              three(body.up));
  bool refused = false;
  for (int k = 0; k < 1000 && !refused; ++k) {
    Three const k_before = run.momentum(), u_before = run.normal();
    try {
      run.step();
    } catch (NotConverged const&) {
      refused = true;
      BOOST_TEST(dot(run.momentum() - k_before, run.momentum() - k_before) == 0);
      BOOST_TEST(dot(run.normal() - u_before, run.normal() - u_before) == 0);
    }
  }
  BOOST_TEST(refused);
}

BOOST_AUTO_TEST_SUITE_END()
