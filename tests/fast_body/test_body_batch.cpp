// Many free bodies in lanes, held to one body at a time, to the exact motion, and to somebody else's solution
// of the differential equations.
#include <Eigen/Geometry>
#include <boost/test/unit_test.hpp>

#include "../rigid_body/random_bodies.hpp"
#include "actio/fast_body/space/body_batch.hpp"
#include "refused.hpp"
#include "witness/reference_solution.hpp"

using namespace actio;
using namespace actio::bodies;
using Eigen::Vector3d;
using Eigen::Vector4d;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
using Moment = Momentum<SO<3>, double>;
using Attitude = Element<SU2, double>;

struct Cast {
  std::vector<Inertia<3>> inertias;
  std::vector<Moment> momenta;
  std::vector<Attitude> attitudes;

  void add(Vector3d const& moments, Vector3d const& spin, Vector4d const& q = {0.8, 0.2, -0.4, 0.4}) {
    inertias.push_back(inertia_from_moments<double>(moments));
    momenta.push_back(body_momentum(inertias.back(), velocity(SO<3>{}, spin)));
    attitudes.push_back({SU2{}, q.normalized()});
  }
};

// All orders of the axes; symmetric bodies, spheres, flat and long ones, turns about each axis, and rest.
Cast all_kinds() {
  Cast cast;
  Vector3d const spin(0.5, 0.7, -0.4);
  int const order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  for (auto const& o : order) {
    Vector3d const I(0.6, 0.8, 1.0);
    cast.add({I[o[0]], I[o[1]], I[o[2]]}, spin, {0.1, -0.9, 0.3, 0.2});
  }
  for (int i = 0; i < 3; ++i) {
    Vector3d disc(1, 1, 1), flat(1, 1, 1), nearly(1, 1, 1);
    disc[i] = 1.7, flat[i] = 2, nearly[i] = 1 + 1e-12;
    for (auto const& I : {disc, flat, nearly}) cast.add(I, spin);
    cast.add({0.7, 0.9, 1.1}, 0.9 * Vector3d::Unit(i));
  }
  cast.add({1, 1, 1}, spin);
  cast.add({0.4, 0.5, 0.9}, {0.7, 0.3, 0.1});
  cast.add({0.6, 0.8, 1.0}, {0, 0, 0});
  // Last, for rows of four with long bodies take another road.
  for (int i = 0; i < 3; ++i) {
    Vector3d rod(1, 1, 1);
    rod[i] = 1e-3;
    cast.add(rod, spin);
  }
  return cast;
}

// q and -q are one attitude.
double apart(Attitude const& a, Attitude const& b) {
  return std::min((a.value - b.value).norm(), (a.value + b.value).norm());
}

// A step rounds some twenty numbers of size 1 or less; what that adds to the energy shifts the phase from
// then on, by no more than the angle of a step each.
double room(double steps, double angle) { return 20 * eps * steps * (1 + steps * angle / 2); }

struct Distance {
  double momentum = 0, attitude = 0;
};
template <class Other>
Distance farthest(BodyBatch const& batch, Cast const& cast, Other const& other) {
  Distance most;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    FreeState const state = other(i);
    double const size = cast.momenta[i].components.norm();
    double const off = (batch.momentum(i).components - state.body_momentum.components).norm();
    most.momentum = std::max(most.momentum, size > 0 ? off / size : off);
    most.attitude = std::max(most.attitude, apart(batch.attitude(i), state.attitude));
  }
  return most;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(body_batch)

// Half turns, whose first component is zero, about axes between which the largest component changes, and
// turns next to these: the components of the quaternion have the digits of the frame.
BOOST_AUTO_TEST_CASE(a_frame_has_its_quaternion_whichever_component_is_largest) {
  for (double const scalar : {0.0, 1e-9, 0.3})
    for (int direction = 0; direction < 27; ++direction) {
      Vector3d const axis(direction % 3 - 1.1, direction / 3 % 3 - 1.0, direction / 9 - 0.9);
      for (Vector3d const& v : {axis, Vector3d::Unit(direction % 3).eval()}) {
        Vector4d q;
        q << scalar, v;
        q.normalize();
        Eigen::Matrix3d const r = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
        Vector4d const found =
            bodies::detail::frame_quaternion({r(0, 0), r(1, 0), r(2, 0)}, {r(0, 1), r(1, 1), r(2, 1)});
        BOOST_TEST(std::min((found - q).norm(), (found + q).norm()) <= 8 * eps);
      }
    }
}

BOOST_AUTO_TEST_CASE(each_body_moves_as_it_does_alone_and_exactly) {
  Cast const cast = all_kinds();
  for (Machine const machine : {Machine::plain, best_machine()})
    for (double const h : {0.1, -0.3, 2.5}) {
      int const steps = 200;
      BodyBatch batch(cast.inertias, cast.momenta, cast.attitudes, h, machine);
      BOOST_TEST(batch.refused().empty());
      batch.step(steps - 3);
      for (int k = 0; k < 3; ++k) batch.step();
      BOOST_TEST(batch.time() == steps * h);
      auto const alone = farthest(batch, cast, [&](std::size_t i) {
        FreeBody const body(cast.inertias[i], cast.momenta[i], cast.attitudes[i]);
        HalfTurn<double> const turn(body.step_parameters(h));
        auto state = body.start();
        for (int k = 0; k < steps; ++k) turn.step(state);
        return body.state(state);
      });
      auto const exact = farthest(batch, cast, [&](std::size_t i) {
        return FreeBody(cast.inertias[i], cast.momenta[i], cast.attitudes[i]).at(steps * h);
      });
      BOOST_TEST_MESSAGE("bodies in lanes (" << name_of(machine) << "), h = " << h
                                             << ": from the loop over one body " << alone.momentum << ", "
                                             << alone.attitude << "; from the exact motion " << exact.momentum
                                             << ", " << exact.attitude);
      double const angle = std::min(1.0, std::abs(h));
      BOOST_TEST(exact.momentum <= room(steps, angle));
      BOOST_TEST(exact.attitude <= room(steps, angle));
      // Long steps of the loop leave the orbit of the rod: the next case.
      if (std::abs(h) > 1) continue;
      BOOST_TEST(alone.momentum <= room(steps, angle));
      BOOST_TEST(alone.attitude <= room(steps, angle));
    }
}

BOOST_AUTO_TEST_CASE(long_steps_stay_on_the_orbit) {
  std::mt19937 random(testing::seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  Cast cast;
  for (int i = 0; i < 400; ++i) {
    Vector3d lambda;
    for (double& l : lambda) l = std::pow(10.0, -3 * uniform(random));
    Vector3d const I(lambda[1] + lambda[2], lambda[0] + lambda[2], lambda[0] + lambda[1]);
    Vector3d spin(uniform(random) - 0.5, uniform(random) - 0.5, uniform(random) - 0.5);
    cast.add(I, spin / spin.norm() * std::pow(10.0, 2 * uniform(random)));  // up to a hundred radians a step
  }
  BodyBatch batch(cast.inertias, cast.momenta, cast.attitudes, 1);
  long const steps = 300;
  batch.step(steps);
  double error = 0, control = 0;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    double const before = kinetic_energy(cast.inertias[i], cast.momenta[i]);
    error = std::max(error, std::abs(kinetic_energy(cast.inertias[i], batch.momentum(i)) / before - 1));
    FreeBody const body(cast.inertias[i], cast.momenta[i], cast.attitudes[i]);
    HalfTurn<double> const turn(body.step_parameters(1));
    auto u = body.start().direction;
    for (long k = 0; k < steps; ++k) turn.step(u);
    control = std::max(
        control,
        std::abs(kinetic_energy(cast.inertias[i], body.state({u, {1, 0, 0, 0}}).body_momentum) / before - 1));
  }
  BOOST_TEST_MESSAGE("long steps, 300 of them: energy off by " << error << " at most; by " << control
                                                               << " where the axis is not set right");
  BOOST_TEST(error <= 20 * eps * std::sqrt(static_cast<double>(steps)));
  BOOST_TEST(control > 1e-3);
}

BOOST_AUTO_TEST_CASE(the_differential_equations_agree) {
  Cast const cast = all_kinds();
  BodyBatch batch(cast.inertias, cast.momenta, cast.attitudes, 0.25);
  batch.step(40);
  auto const solved = farthest(batch, cast, [&](std::size_t i) -> FreeState {
    Vector3d const I = cast.inertias[i].moments;
    using Seven = actio::Vector<double, 7>;
    auto const rate = [&](double, Seven const& y) {
      Vector3d const M = y.head<3>(), w = M.cwiseQuotient(I), q = y.tail<3>();
      Seven change;
      change << M.cross(w), -0.5 * q.dot(w), 0.5 * (y[3] * w + q.cross(w));
      return change;
    };
    Seven start;
    start << cast.momenta[i].components, cast.attitudes[i].value;
    Seven const end = reference_solution(rate, start, 0, 10);
    return {{SO<3>{}, end.head<3>()}, {SU2{}, end.tail<4>()}};
  });
  BOOST_TEST(solved.momentum <= 1e-11);
  BOOST_TEST(solved.attitude <= 1e-11);
}

BOOST_AUTO_TEST_CASE(momenta_alone_are_the_same_momenta) {
  Cast const cast = all_kinds();
  BodyBatch whole(cast.inertias, cast.momenta, cast.attitudes, 0.1), half = whole;
  whole.step(100);
  half.step_momentum(100);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    double const size = cast.momenta[i].components.norm();
    BOOST_TEST((whole.momentum(i).components - half.momentum(i).components).norm() <= room(100, 0.1) * size);
    CHECK_REFUSED(half.attitude(i), OutsideDomain);
  }
  CHECK_REFUSED(half.step(), OutsideDomain);
  CHECK_REFUSED(whole.step(-1), OutsideDomain);
  BOOST_CHECK_NO_THROW(whole.step(0));
}

BOOST_AUTO_TEST_CASE(what_free_motion_conserves_stays) {
  Cast const cast = all_kinds();
  BodyBatch batch(cast.inertias, cast.momenta, cast.attitudes, 0.3);
  long const steps = 20000;
  batch.step(steps);
  double length = 0, energy = 0, space = 0;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (cast.momenta[i].components.norm() == 0) continue;
    Moment const before = cast.momenta[i], after = batch.momentum(i);
    length = std::max(length, std::abs(after.components.norm() / before.components.norm() - 1));
    energy = std::max(
        energy,
        std::abs(kinetic_energy(cast.inertias[i], after) / kinetic_energy(cast.inertias[i], before) - 1));
    auto const in_space = [](Attitude const& q, Moment const& M) {
      return SU2::Ad<double>(q.value, M.components);
    };
    space =
        std::max(space, (in_space(batch.attitude(i), after) - in_space(cast.attitudes[i], before)).norm() /
                            before.components.norm());
  }
  BOOST_TEST_MESSAGE("bodies in lanes after " << steps << " steps: amount " << length << ", energy " << energy
                                              << ", spatial momentum " << space);
  // Amount and spatial momentum are set right when they are read. The energy walks, by some twenty roundings
  // a step.
  BOOST_TEST(length <= 4 * eps);
  BOOST_TEST(space <= 16 * eps);
  BOOST_TEST(energy <= 20 * eps * std::sqrt(static_cast<double>(steps)));
}

BOOST_AUTO_TEST_CASE(no_unit_is_too_small_or_too_large) {
  Vector3d const I(0.6, 0.8, 1.0), spin(0.5, 0.7, -0.4);
  for (double const unit : {1e-47, 1e-20, 1.0, 1e20, 1e47})
    for (double const pace : {1e-12, 1.0, 1e6}) {
      Cast cast, plain;
      cast.add(unit * I, pace * spin), plain.add(I, spin);
      BodyBatch batch(cast.inertias, cast.momenta, cast.attitudes, 0.1 / pace),
          same(plain.inertias, plain.momenta, plain.attitudes, 0.1);
      BOOST_TEST(batch.refused().empty());
      batch.step(50), same.step(50);
      BOOST_TEST((batch.momentum(0).components / unit / pace - same.momentum(0).components).norm() <=
                 room(50, 0.1));
      BOOST_TEST(apart(batch.attitude(0), same.attitude(0)) <= room(50, 0.1));
    }
}

BOOST_AUTO_TEST_CASE(a_bad_body_is_named_and_loses_no_other) {
  Cast good = all_kinds(), cast = good;
  cast.momenta[2].components[1] = std::nan("");
  cast.attitudes[5].value *= 2;
  cast.inertias[7].moments = {1, 1, 3};
  cast.inertias[9].moments[0] = -1;
  BodyBatch batch(cast.inertias, cast.momenta, cast.attitudes, 0.1),
      whole(good.inertias, good.momenta, good.attitudes, 0.1);
  BOOST_REQUIRE(batch.refused().size() == 4u);
  std::size_t const bad[] = {2, 5, 7, 9};
  for (int k = 0; k < 4; ++k) {
    BOOST_TEST(batch.refused()[k].index == bad[k]);
    std::string const what = batch.refused()[k].what();
    BOOST_TEST(what.find("body " + std::to_string(bad[k]) + ": ") == 0u);
    CHECK_REFUSED(batch.momentum(bad[k]), BodyRefused);
    CHECK_REFUSED(batch.attitude(bad[k]), BodyRefused);
  }
  BOOST_TEST(std::string(batch.refused()[2].what()).find("triangle") != std::string::npos);
  batch.step(30), whole.step(30);
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (std::count(std::begin(bad), std::end(bad), i)) continue;
    BOOST_TEST(batch.momentum(i).components == whole.momentum(i).components);
    BOOST_TEST(batch.attitude(i).value == whole.attitude(i).value);
  }
  CHECK_REFUSED(batch.momentum(batch.size()), OutsideDomain);
  cast.momenta.pop_back();
  CHECK_REFUSED(BodyBatch(cast.inertias, cast.momenta, cast.attitudes, 0.1), OutsideDomain);
  CHECK_REFUSED(BodyBatch(0.0), OutsideDomain);
  CHECK_REFUSED(BodyBatch(std::nan("")), NotFinite);
}

BOOST_AUTO_TEST_CASE(a_body_may_come_later) {
  Cast const cast = all_kinds();
  BodyBatch batch(0.1), late(0.1);
  batch.step(7);
  auto const first = batch.add(cast.inertias[1], cast.momenta[1], cast.attitudes[1]);
  late.add(cast.inertias[1], cast.momenta[1], cast.attitudes[1]);
  try {
    batch.add(cast.inertias[0], {SO<3>{}, Vector3d(1, INFINITY, 0)});
    BOOST_TEST(false);
  } catch (BodyRefused const& why) {
    BOOST_TEST(why.index == 1u);
  }
  BOOST_TEST(batch.size() == 1u);
  batch.step(20), late.step(20);
  BOOST_TEST(batch.attitude(first).value == late.attitude(0).value);
  // Steps in one call or in many are the same steps.
  BodyBatch single = late;
  late.step(5000);
  for (int k = 0; k < 5000; ++k) single.step();
  BOOST_TEST(single.attitude(0).value == late.attitude(0).value);
}

BOOST_AUTO_TEST_SUITE_END()
