// Rods as they are used: steps against the general road, balances of boxes, ends and supports, threads, and
// what is refused.
#include <boost/test/unit_test.hpp>

#include <random>

#include "actio/covariant_reduction/balances.hpp"
#include "actio/rigid_body/moser_veselov.hpp"
#include "actio/rods/rod.hpp"
#include "actio/rods/rod_lagrangian.hpp"
#include "actio/rods/step_limit.hpp"
#include "caught.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::rods;
using bodies::dot;

namespace {

using Motion3 = Element<SE<3>, double>;

RodSection section() { return {{60, 25, 20}, {0.5, 0.8, 0.7}, 1.2, {0.06, 0.03, 0.04}}; }
/// A helix of a rod at rest.
RodShape helix(int elements) {
  return RodShape::of_strains(3, elements, {0.1, -0.2, 0.3}, {0.8, 0, 0.6, 0}, [](double) {
    return Three<double>{0.3, 0.5, -0.2};
  });
}
/// A rod that is let go bent and thrown, with other bends than at rest.
RodStart thrown(int elements) {
  RodStart out{RodShape::of_strains(
                   3, elements, {0, 0, 0}, {1, 0, 0, 0},
                   [](double s) {
                     return Three<double>{0.1, std::sin(s), 0.4};
                   },
                   [](double s) {
                     return Three<double>{1 + 0.1 * std::cos(s), 0.1, 0};
                   }),
               {},
               {}};
  for (int k = 0; k <= elements; ++k) {
    double const s = 3.0 * k / elements;
    out.velocity.push_back({0.3, std::cos(2 * s), 0.5 * s});
    out.angular_velocity.push_back({1 + s, 0.7, std::sin(s)});
  }
  return out;
}
Rod free_rod(int elements, double step, int threads = 1) {
  return {section(), helix(elements), thrown(elements), {}, {step, false, threads}};
}
Motion3 placement(RodFrame const& frame, std::size_t k) {
  Motion3 g = identity<double>(SE<3>{});
  for (int i = 0; i < 3; ++i) {
    Three<double> axis{};
    axis[static_cast<std::size_t>(i)] = 1;
    auto const column = turned(frame.attitudes[k], axis);
    for (int j = 0; j < 3; ++j) g.value(j, i) = column[static_cast<std::size_t>(j)];
    g.value(i, 3) = frame.places[k][static_cast<std::size_t>(i)];
  }
  return g;
}
/// The field of a run.
/// @param shifts  where they are wanted, the ways of sections in each step, h v: as differences of places
///                they would have the rounding of these
GroupField<SE<3>, double> field_of(Rod& rod, int levels,
                                   std::vector<std::vector<Matrix<double, 3, 1>>>* shifts = nullptr) {
  GroupField<SE<3>, double> out;
  if (rod.constants().elements == rod.sections()) out.ends = {End::joined, End::joined};
  for (int k = 0; k < levels; ++k) {
    auto const frame = rod.frame();
    out.levels.emplace_back();
    for (std::size_t a = 0; a < rod.sections(); ++a) out.levels.back().push_back(placement(frame, a));
    rod.step();
    if (!shifts) continue;
    // Length of a step and their number, places, attitudes, velocities over the last step.
    auto const state = rod.remember();
    std::size_t const n = rod.sections();
    shifts->emplace_back();
    for (std::size_t a = 0; a < n; ++a) {
      Matrix<double, 3, 1> way;
      for (std::size_t i = 0; i < 3; ++i) way[static_cast<Index>(i)] = state[0] * state[2 + (7 + i) * n + a];
      shifts->back().push_back(way);
    }
  }
  return out;
}
/// A ring that is bent more than at rest, and spins.
Rod ring(double step) {
  auto const circle = [](double u) {
    double const c = std::cos(2 * M_PI * u), s = std::sin(2 * M_PI * u);
    return std::pair{Three<double>{c, s, 0.1 * std::sin(4 * M_PI * u)},
                     Three<double>{-s, c, 0.2 * std::cos(4 * M_PI * u)}};
  };
  auto const shape = RodShape::along(circle, 14, {0, 0, 1}, true);
  RodStart start{shape, {}, {}};
  for (auto const& x : shape.places) start.velocity.push_back({-x[1], x[0], 0.3 * x[0]});
  return {section(), shape, start, {}, {step}};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(rods)

// The steps, written out, obey the field equation: (3.11) in time and in space, by dual numbers.
BOOST_AUTO_TEST_CASE(steps_are_those_of_the_general_road) {
  double const step = 0.01;
  for (bool const closed : {false, true}) {
    Rod rod = closed ? ring(step) : free_rod(11, step);
    auto const field = field_of(rod, 30);
    RodAction const action{rod.constants(), step};
    double worst = 0, size = 0;
    for (Index k = 1; k + 1 < 30; ++k)
      for (Index a = 0; a < field.grid().nodes; ++a) {
        worst = std::max(worst, field_equation(action, field, a, k).components.cwiseAbs().maxCoeff());
        size = std::max(
            size,
            edge_momentum(action, field, field, {Direction::time, a, k}).components.cwiseAbs().maxCoeff());
      }
    BOOST_TEST_MESSAGE("residual of (3.11), twice: " << worst << " of momenta of " << size);
    BOOST_TEST(worst <= 1e-14 * size * 30);  // what a difference of momenta of that size is rounded by
  }
}

// What crosses the boundary of any box of space-time adds up to zero: linear and angular momentum, and the
// multisymplectic form of two first variations.
BOOST_AUTO_TEST_CASE(balances_on_boxes) {
  double const step = 0.02;
  Rod rod = free_rod(16, step);
  std::vector<std::vector<Matrix<double, 3, 1>>> shifts;
  auto const field = field_of(rod, 60, &shifts);
  auto motions = relative_motions(field);
  for (std::size_t k = 0; k < motions.time.size(); ++k)
    for (std::size_t a = 0; a < motions.time[k].size(); ++a)
      motions.time[k][a].value.topRightCorner<3, 1>() =
          -(field.levels[k + 1][a].value.topLeftCorner<3, 3>().transpose() * shifts[k][a]);
  RodAction const action{rod.constants(), step};
  std::mt19937 draw(5);
  auto const below = [&](Index n) { return static_cast<Index>(draw() % static_cast<unsigned>(n)); };
  double worst = 0, off = 0;
  for (int count = 0; count < 200; ++count) {
    Index const a = below(17), k = 1 + below(58);
    NodeBox const box{a, 1 + below(17 - a), k, 1 + below(59 - k)};
    auto const balance = noether_balance(action, motions, field, box);
    worst = std::max(worst, balance.sum.components.cwiseAbs().maxCoeff() / balance.terms);
    // The control: an edge of another level instead of its own does not balance.
    auto const other = balance.sum + edge_momentum(action, motions, field, {Direction::time, a, k - 1}) -
                       edge_momentum(action, motions, field, {Direction::time, a, k});
    off = std::max(off, other.components.cwiseAbs().maxCoeff() / balance.terms);
  }
  BOOST_TEST_MESSAGE("momenta on 200 boxes: " << worst << ", control " << off);
  BOOST_TEST(worst <= 1e-14);
  BOOST_TEST(off > 1e-4);

  // A variation begins with any two levels.
  auto some = field;
  some.levels.resize(12);
  std::uniform_real_distribution<double> any(-1, 1);
  auto const variation = [&] {
    FieldVariation<SE<3>, double> out(2);
    for (auto& level : out)
      for (Index node = 0; node < 17; ++node) {
        Matrix<double, 6, 1> v;
        for (int i = 0; i < 6; ++i) v[i] = any(draw);
        level.push_back({SE<3>{}, v});
      }
    while (out.size() < 12) step_variation(action, some, out);
    return out;
  };
  auto const V = variation(), W = variation();
  double worst_form = 0;
  for (int count = 0; count < 200; ++count) {
    Index const a = below(17), k = 1 + below(10);
    NodeBox const box{a, 1 + below(17 - a), k, 1 + below(11 - k)};
    auto const balance = form_balance(action, some, V, W, box);
    worst_form = std::max(worst_form, std::abs(balance.sum) / balance.terms);
  }
  BOOST_TEST_MESSAGE("form on 200 boxes: " << worst_form);
  BOOST_TEST(worst_form <= 1e-14);
}

// A section whose elements do not resist is the body of chapter 5, by its scheme.
BOOST_AUTO_TEST_CASE(a_section_alone_is_the_body_of_chapter_5) {
  double const step = 0.01, soft = 1e-300;
  RodSection loose{{soft, soft, soft}, {soft, soft, soft}, 1.2, {0.06, 0.03, 0.04}};
  RodStart start = thrown(4);
  // All turn alike, so that no element folds.
  for (auto& w : start.angular_velocity) w = {1, 0.7, -0.4};
  Rod rod(loose, start.shape, start, {}, {step});
  Matrix<double, 3, 1> moments;
  double const share = rod.constants().share[2];
  moments << 0.06, 0.03, 0.04;
  MoserVeselov<3> const scheme(inertia_from_moments<double>(moments * share), step);
  auto const frame = rod.frame();
  Momentum<SO<3>, double> M{{}, moments};
  for (int i = 0; i < 3; ++i) M.components[i] = frame.body_momenta[2][static_cast<std::size_t>(i)];
  auto g = Element<SO<3>, double>{{}, placement(frame, 2).value.topLeftCorner<3, 3>()};
  auto f = scheme.relative_motion(M).value;
  for (int k = 0; k < 1000; ++k) {
    if (k > 0) f = scheme.step_euler_poincare(f).value;
    g = scheme.reconstruct(g, f);
  }
  rod.step(1000);
  double const apart =
      (placement(rod.frame(), 2).value.topLeftCorner<3, 3>() - g.value).cwiseAbs().maxCoeff();
  BOOST_TEST_MESSAGE("one section and Moser-Veselov after 1000 steps: " << apart);
  BOOST_TEST(apart <= 1e-12);
}

// A rod at rest stays where it is.
BOOST_AUTO_TEST_CASE(rest_is_kept) {
  for (bool const unshearable : {false, true}) {
    auto const shape = RodShape::of_strains(3, 10, {0, 0, 0}, {0.8, 0, 0.6, 0});
    Rod rod(section(), shape, {shape, {}, {}}, {}, {0.004, unshearable});
    auto const before = rod.frame();
    rod.step(100);
    auto const after = rod.frame();
    double moved = 0;
    for (std::size_t k = 0; k < rod.sections(); ++k)
      for (std::size_t i = 0; i < 4; ++i) {
        moved = std::max(moved, std::abs(after.attitudes[k][i] - before.attitudes[k][i]));
        if (i < 3) moved = std::max(moved, std::abs(after.places[k][i] - before.places[k][i]));
      }
    BOOST_TEST(moved <= 1e-14);
  }
}

// No bit depends on threads, or on how many steps are asked for at once.
BOOST_AUTO_TEST_CASE(threads_change_no_bit) {
  auto const run = [](int threads, int pieces) {
    Rod rod = free_rod(2100, 2e-5, threads);
    for (int k = 0; k < pieces; ++k) rod.step(96 / pieces);
    return rod.remember();
  };
  auto const one = run(1, 1);
  BOOST_TEST((one == run(2, 1)));
  BOOST_TEST((one == run(3, 1)));
  BOOST_TEST((one == run(2, 3)));
}

// What a rod remembers is all that it goes on from.
BOOST_AUTO_TEST_CASE(goes_on_bit_for_bit) {
  for (bool const unshearable : {false, true}) {
    auto const make = [&] {
      auto start = thrown(12);
      start.shape = RodShape::of_strains(3, 12, {0, 0, 0}, {1, 0, 0, 0});
      RodLoads loads;
      loads.gravity = {0, 0, -9.81};
      loads.start.held = RodEnd::Held::pinned;
      loads.end.force = [](double t) { return Three<double>{std::sin(t), 0, 0}; };
      for (auto& v : start.velocity) v = {0, 0, 0};
      for (auto& w : start.angular_velocity) w = {0, 0, 0};
      return Rod(section(), start.shape, start, loads, {0.005, unshearable});
    };
    Rod whole = make(), part = make(), other = make();
    whole.step(40), part.step(15);
    other.restore(part.remember());
    other.look_ahead(0.002);
    (void)other.frame();
    other.step(25);
    BOOST_TEST((whole.remember() == other.remember()));
  }
}

// The ledger: what loads, supports and gravity add explains the change of both momenta.
BOOST_AUTO_TEST_CASE(impulses_explain_the_momenta) {
  for (bool const unshearable : {false, true})
    for (auto const held : {RodEnd::Held::free, RodEnd::Held::pinned, RodEnd::Held::clamped}) {
      auto const shape = RodShape::of_strains(3, 10, {0, 0, 0}, {1, 0, 0, 0});
      RodLoads loads;
      loads.gravity = {1, 2, -9.81};
      loads.start.held = held;
      if (held == RodEnd::Held::clamped)
        loads.start.motion = [](double t) {
          return Placement{{std::sin(t), 0, 0}, {std::cos(t / 2), 0, std::sin(t / 2), 0}};
        };
      loads.end.force = [](double t) { return Three<double>{0, 3 * t, 1}; };
      loads.end.moment = [](double t) { return Three<double>{0.01, 0, t / 20}; };
      loads.end.moment_in_body = true;
      Rod rod(section(), shape, {shape, {}, {}}, loads, {0.004, unshearable});
      rod.step(250);
      auto const now = rod.momentum(), by = rod.impulse();
      double worst = 0, size = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        worst = std::max(
            {worst, std::abs(now.linear[i] - by.linear[i]), std::abs(now.angular[i] - by.angular[i])});
        size = std::max({size, std::abs(by.linear[i]), std::abs(by.angular[i])});
      }
      BOOST_TEST(worst <= 1e-13 * std::max(1.0, size) * 16);
      if (unshearable) BOOST_TEST(rod.constraint_residual() <= 1e-13);
    }
}

// A load that has no value at some time ends the run on all threads, and the state is that before.
BOOST_AUTO_TEST_CASE(loads_may_throw) {
  for (int const threads : {1, 2})
    for (bool const at_end : {false, true}) {
      auto const shape = RodShape::of_strains(3, 1100, {0, 0, 0}, {1, 0, 0, 0});
      RodLoads loads;
      (at_end ? loads.end : loads.start).force = [](double t) {
        if (t > 0.00025) throw NotFinite("a load");
        return Three<double>{0, 1, 0};
      };
      Rod rod(section(), shape, {shape, {}, {}}, loads, {1e-5, false, threads});
      BOOST_CHECK_THROW(rod.step(100), NotFinite);
      BOOST_TEST(rod.steps() == 26);
      Rod other(section(), shape, {shape, {}, {}}, loads, {1e-5});
      other.step(26);
      BOOST_TEST((rod.remember() == other.remember()));
    }
}

BOOST_AUTO_TEST_CASE(step_limit_is_told) {
  // A slender rod: steps are bound by the shear that turns its sections.
  auto const thin = RodSection::circular(1e-3, 1e7, 0.25, 1000);
  auto const shape = RodShape::of_strains(1, 50, {0, 0, 0}, {1, 0, 0, 0});
  RodStart const start{shape, {}, {}};
  auto const stays = [&](double part, bool unshearable) {
    RodConstants const constants = Rod(thin, shape, start, {}, {1e-9, unshearable}).constants();
    double const longest = longest_rod_step(constants, unshearable);
    RodStart moved = start;
    for (std::size_t k = 0; k <= 50; ++k)
      moved.velocity.push_back({0, 1e-6 * std::sin(7.0 * static_cast<double>(k * k)), 0});
    Rod rod(thin, shape, moved, {}, {part * longest, unshearable});
    rod.step(4000);
    auto const energies = rod.energies(rod.frame());
    return energies.kinetic + energies.strain < 1e-9;
  };
  BOOST_TEST(stays(0.96, false));
  BOOST_TEST(stays(0.96, true));
  CHECK_REFUSED(stays(1.01, false), OutsideDomain);
  CHECK_REFUSED(stays(1.01, true), OutsideDomain);
}

BOOST_AUTO_TEST_CASE(what_is_no_rod_is_refused) {
  auto const shape = RodShape::of_strains(3, 10, {0, 0, 0}, {1, 0, 0, 0});
  auto const make = [&](auto const& change) {
    RodSection of = section();
    RodStart start{shape, {}, {}};
    RodLoads loads;
    RodOptions options{0.001};
    change(of, start, loads, options);
    return Rod(of, shape, start, loads, options);
  };
  CHECK_REFUSED(make([](auto& of, auto&, auto&, auto&) { of.stretching[1] = 0; }), OutsideDomain);
  CHECK_REFUSED(make([](auto& of, auto&, auto&, auto&) { of.bending[2] = -1; }), OutsideDomain);
  CHECK_REFUSED(make([](auto& of, auto&, auto&, auto&) { of.inertia = {1, 2, 4}; }), OutsideDomain);
  CHECK_REFUSED(make([](auto&, auto& start, auto&, auto&) { start.velocity.resize(3); }), OutsideDomain);
  CHECK_REFUSED(make([](auto&, auto& start, auto&, auto&) { start.shape.places[2][0] = NAN; }), NotFinite);
  CHECK_REFUSED(make([](auto&, auto&, auto& loads, auto&) {
                  loads.end.held = RodEnd::Held::pinned;
                  loads.end.force = [](double) { return Three<double>{1, 0, 0}; };
                }),
                OutsideDomain);
  CHECK_REFUSED(make([](auto&, auto&, auto&, auto& options) { options.step = -1; }), OutsideDomain);
  CHECK_REFUSED(RodShape::of_strains(3, 1, {0, 0, 0}, {1, 0, 0, 0}), OutsideDomain);
  CHECK_REFUSED(RodShape::of_strains(3, 3, {0, 0, 0}, {1, 0, 0, 0},
                                     [](double) {
                                       return Three<double>{0, 0, 2.5};
                                     }),
                OutsideDomain);
  CHECK_REFUSED(RodSection::circular(0.1, 1e6, 0.6, 1000), OutsideDomain);
}

// A rod that folds ends the run, and the state is that before.
BOOST_AUTO_TEST_CASE(folding_is_told) {
  auto const shape = RodShape::of_strains(3, 4, {0, 0, 0}, {1, 0, 0, 0});
  RodStart start{shape, {}, {}};
  for (int k = 0; k <= 4; ++k) start.velocity.push_back({0, k == 2 ? 60.0 : 0.0, 0});
  Rod rod(section(), shape, start, {}, {0.01});
  BOOST_CHECK_THROW(rod.step(1000), RodStepFails);
  BOOST_TEST(std::isfinite(rod.energies(rod.frame()).kinetic));
}

BOOST_AUTO_TEST_SUITE_END()
