// Incompressible media on several ranks: the same bits as on one.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <numbers>

#include "actio/incompressible_media/incompressible_medium.hpp"
#include "actio/parallel/thread_ranks.hpp"
#include "actio/stored_energy/stored_energies.hpp"

using namespace actio;
using namespace actio::media;

namespace {

/// A medium as it is made on each rank, and what is followed of it.
template <int d>
struct Case {
  std::string name;
  std::function<BodyMesh()> mesh;
  IncompressibleStart<d> start;
  BodySides<d> sides = {};
  BodyLoads<d> loads = {};
  std::shared_ptr<StoredEnergy<d> const> law = {};
  double step = 0.02;
  PressureBy by = PressureBy::multigrid;

  std::unique_ptr<IncompressibleMedium<d>> made(Ranks* ranks) const {
    VolumeSolving solving;
    solving.by = by, solving.ranks = ranks;
    return std::make_unique<IncompressibleMedium<d>>(mesh(), law, start, step, sides, loads, solving);
  }
  /// Does this on so many ranks that share such media.
  void on_ranks(int count, std::function<void(Ranks&)> const& work) const {
    on_thread_ranks(count, [&](Ranks& ranks) {
      share_parts(
          ranks,
          [&](std::string const&, double) {
            return std::make_unique<LikePart<IncompressibleMedium<d>>>(made(&ranks));
          },
          [&] { work(ranks); });
    });
  }
};

/// All numbers of a run with looks ahead, another step, and a state that is gone on from.
template <int d>
std::vector<double> numbers_of(Case<d> const& of, Ranks* ranks) {
  std::vector<double> out;
  auto const note = [&](auto const& values) {
    for (auto const& one : values)
      if constexpr (std::is_same_v<std::decay_t<decltype(one)>, double>)
        out.push_back(one);
      else
        out.insert(out.end(), one.begin(), one.end());
  };
  auto medium = of.made(ranks);
  note(medium->velocities()), note(medium->pressures());
  medium->step(7);
  note(medium->places()), note(medium->velocities()), note(medium->pressures()), note(medium->jacobians());
  auto const energies = medium->energies();
  note(std::array{energies.kinetic, energies.stored, energies.loads, medium->volume_defect()});
  note(medium->momentum()), note(medium->angular_momentum());
  medium->look_ahead(of.step / 3);
  note(medium->places()), note(medium->pressures());
  auto const state = medium->remember();
  note(state);
  auto other = of.made(ranks);
  other->restore(state);
  other->step(6), medium->step(6);
  note(other->places());
  BOOST_TEST((other->remember() == medium->remember()));
  medium->change_step(of.step / 2, of.step / 4, 100);
  medium->step(3);
  note(medium->places()), note(medium->remember());
  return out;
}

template <int d>
void check_ranks(Case<d> const& of, std::vector<int> const& counts) {
  auto const alone = numbers_of(of, nullptr);
  for (int const count : counts) {
    std::vector<double> together;
    of.on_ranks(count, [&](Ranks& ranks) { together = numbers_of(of, &ranks); });
    std::size_t const same =
        static_cast<std::size_t>(std::ranges::mismatch(alone, together).in1 - alone.begin());
    BOOST_TEST(same == alone.size(),
               of.name << " has other bits on " << count << " ranks from number " << same);
  }
}

constexpr double pi = std::numbers::pi;

}  // namespace

BOOST_AUTO_TEST_SUITE(incompressible_on_ranks)

BOOST_AUTO_TEST_CASE(in_the_plane) {
  IncompressibleStart<2> cells;
  cells.velocity = [](auto const& X) {
    return std::array{std::sin(X[0]) * std::cos(X[1]), -std::cos(X[0]) * std::sin(X[1])};
  };
  cells.project = true;
  BodySides<2> const walls{{"left", {Side::sliding, {}}},
                           {"right", {Side::sliding, {}}},
                           {"bottom", {Side::sliding, {}}},
                           {"top", {Side::sliding, {}}}};
  check_ranks<2>({"cells in a box",
                  [] {
                    return box_mesh({0, 0}, {pi, pi}, {21, 66});
                  },
                  cells, walls},
                 {1, 2, 3, 4, 7});
  auto tank = cells;
  tank.velocity = [](auto const& X) {
    return std::array{0.1 * std::sin(X[0]), -0.1 * X[1] * std::cos(X[0])};
  };
  tank.gravity = {0.1, -1};
  auto open = walls;
  open.erase("top");
  check_ranks<2>({"a tank", [] { return box_mesh({0, 0}, {pi, 1.7}, {14, 57}); }, tank, open}, {2, 3, 7});
  auto round = cells;
  round.velocity = [](auto const& X) {
    return std::array{0.3 * std::sin(X[1] - 0.4), 0.2 * std::cos(3 * X[0])};
  };
  auto const tube = [] { return box_mesh({0, 0}, {2, 2 * pi}, {13, 64}, {false, true}); };
  check_ranks<2>({"a jet", tube, round}, {2, 3, 4});
  auto pressed = cells;
  pressed.project = true;
  BodyLoads<2> loads;
  loads.pressures["top"] = [](double t) { return 0.2 * std::sin(3 * t); };
  BodySides<2> held{{"bottom", {Side::fixed, {}}}, {"left", {Side::sliding, {}}}};
  Case<2> rubber{
      "rubber", [] { return box_mesh({0, 0}, {1, 3}, {9, 48}); },
      pressed,  held,
      loads,    stored_energy<2>([](auto const& F) { return 0.5 * ((F.transpose() * F).trace() - 2.0); }),
      0.004};
  check_ranks<2>(rubber, {2, 3});
  rubber.name = "rubber by factors", rubber.by = PressureBy::factors;
  check_ranks<2>(rubber, {2, 4});
}

BOOST_AUTO_TEST_CASE(in_space) {
  IncompressibleStart<3> start;
  start.velocity = [](auto const& X) {
    return std::array{0.1 * std::sin(X[2]), -0.2 * X[0] * X[1], 0.1 * std::cos(X[0])};
  };
  start.project = true, start.gravity = {0, 0, -0.3};
  check_ranks<3>({"a block",
                  [] {
                    return box_mesh({0, 0, 0}, {1, 1, 3}, {4, 3, 25});
                  },
                  start,
                  {{"bottom", {Side::sliding, {}}}},
                  {},
                  {},
                  0.02,
                  PressureBy::best},
                 {2, 3});
}

BOOST_AUTO_TEST_CASE(what_ends_a_run_ends_it_on_all_ranks) {
  // A vortex shears a cell until it folds.
  IncompressibleStart<2> vortex;
  vortex.velocity = [](auto const& X) {
    return std::array{std::sin(X[0]) * std::cos(X[1]), -std::cos(X[0]) * std::sin(X[1])};
  };
  vortex.project = true;
  BodySide<2> const slides{Side::sliding, {}};
  Case<2> const of{.name = "a vortex",
                   .mesh =
                       [] {
                         return box_mesh({0, 0}, {pi, pi}, {7, 24});
                       },
                   .start = vortex,
                   .sides = {{"left", slides}, {"right", slides}, {"bottom", slides}, {"top", slides}}};
  auto const told = [&](Ranks* ranks) {
    auto medium = of.made(ranks);
    try {
      medium->step(1000);
    } catch (Error const& error) {
      return std::string(error.what()) + show(medium->time());
    }
    return std::string("nothing");
  };
  std::string const alone = told(nullptr);
  BOOST_TEST(alone.find("folds") != std::string::npos, alone);
  of.on_ranks(3, [&](Ranks& ranks) { BOOST_TEST(told(&ranks) == alone); });
}

BOOST_AUTO_TEST_SUITE_END()
