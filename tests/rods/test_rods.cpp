// Rods as they are used: steps against the general road, balances of boxes, ends and supports, threads, and
// what is refused.
#include <boost/test/unit_test.hpp>

#include <random>

#include "actio/reduction/discrete_euler_poincare.hpp"
#include "actio/reduction/relative_motion.hpp"
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
/// The field of a run: `field[k][a]`.
std::vector<std::vector<Motion3>> field_of(Rod& rod, int levels) {
  std::vector<std::vector<Motion3>> out;
  for (int k = 0; k < levels; ++k) {
    auto const frame = rod.frame();
    out.emplace_back();
    for (std::size_t a = 0; a < rod.sections(); ++a) out.back().push_back(placement(frame, a));
    rod.step();
  }
  return out;
}

/// The differentials of both actions along a field, in space: what crosses each edge.
struct Crossings {
  std::vector<std::vector<Matrix<double, 6, 1>>> start, end,  // of steps, at their start and end
      low, up;                                                // of elements
};
Matrix<double, 6, 1> in_space(Motion3 const& g, Momentum<SE<3>, double> const& m) {
  return Ad_star(inverse(g), m).components;
}
Crossings crossings_of(Rod const& rod, std::vector<std::vector<Motion3>> const& field, double step) {
  Crossings out;
  auto const& c = rod.constants();
  for (std::size_t k = 0; k < field.size(); ++k) {
    auto& row = field[k];
    out.low.emplace_back(), out.up.emplace_back(), out.start.emplace_back(), out.end.emplace_back();
    for (std::size_t a = 0; a < row.size(); ++a) {
      if (k + 1 < field.size()) {
        auto const f = relative_motion_left(row[a], field[k + 1][a]);
        KineticAction const l{rod.section(), c.share[a], step};
        out.start.back().push_back(in_space(row[a], left_differential(l, f)));
        out.end.back().push_back(in_space(field[k + 1][a], -right_differential(l, f)));
      }
      if (a + 1 < row.size()) {
        auto const e = relative_motion_left(row[a], row[a + 1]);
        StrainAction const l{
            rod.section(), {c.inverse_length[a], vector_at(c.Gamma, a), vector_at(c.kappa, a)}, step};
        out.low.back().push_back(in_space(row[a], left_differential(l, e)));
        out.up.back().push_back(in_space(row[a + 1], -right_differential(l, e)));
      }
    }
  }
  return out;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(rods)

// The steps, written out, obey (3.11) in time and in space together, by dual numbers.
BOOST_AUTO_TEST_CASE(steps_are_those_of_the_general_road) {
  double const step = 0.01;
  Rod rod = free_rod(11, step);
  auto const field = field_of(rod, 30);
  auto const c = crossings_of(rod, field, step);
  double worst = 0, size = 0;
  for (std::size_t k = 1; k + 1 < field.size(); ++k)
    for (std::size_t a = 0; a < rod.sections(); ++a) {
      Matrix<double, 6, 1> sum = c.start[k][a] + c.end[k - 1][a];
      size = std::max(size, c.start[k][a].cwiseAbs().maxCoeff());
      if (a + 1 < rod.sections()) sum += c.low[k][a];
      if (a > 0) sum += c.up[k][a - 1];
      worst = std::max(worst, sum.cwiseAbs().maxCoeff());
    }
  BOOST_TEST_MESSAGE("residual of (3.11), twice: " << worst << " of momenta of " << size);
  BOOST_TEST(worst <= 1e-14 * size * 30);  // what a difference of momenta of that size is rounded by
}

// What crosses the boundary of any box of space-time adds up to zero: linear and angular momentum.
BOOST_AUTO_TEST_CASE(momenta_balance_on_boxes) {
  double const step = 0.02;
  Rod rod = free_rod(16, step);
  auto const field = field_of(rod, 60);
  auto const c = crossings_of(rod, field, step);
  std::mt19937 draw(5);
  auto const below = [&](std::size_t n) { return draw() % n; };
  double worst = 0, off = 0;
  for (int box = 0; box < 200; ++box) {
    std::size_t k0 = 1 + below(56), k1 = 1 + below(56), a0 = below(17), a1 = below(17);
    if (k0 > k1) std::swap(k0, k1);
    if (a0 > a1) std::swap(a0, a1);
    Matrix<double, 6, 1> sum = Matrix<double, 6, 1>::Zero(), size = sum;
    auto const add = [&](Matrix<double, 6, 1> const& one) { sum += one, size += one.cwiseAbs(); };
    for (std::size_t a = a0; a <= a1; ++a) add(c.end[k0 - 1][a]), add(c.start[k1][a]);
    for (std::size_t k = k0; k <= k1; ++k) {
      if (a0 > 0) add(c.up[k][a0 - 1]);
      if (a1 < 16) add(c.low[k][a1]);
    }
    for (int i = 0; i < 6; ++i) worst = std::max(worst, std::abs(sum[i]) / size.maxCoeff());
    // The control: one step less of one section does not balance.
    sum -= c.end[k0 - 1][a0] - c.end[k0][a0];
    off = std::max(off, sum.cwiseAbs().maxCoeff() / size.maxCoeff());
  }
  BOOST_TEST_MESSAGE("momenta on 200 boxes: " << worst << ", control " << off);
  BOOST_TEST(worst <= 1e-14);
  BOOST_TEST(off > 1e-4);
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
