// Media on boxes on several ranks: the same bits as on one.
#include <boost/test/unit_test.hpp>

#include "actio/fast_media/fast_medium_2d.hpp"
#include "actio/fast_media/fast_medium_3d.hpp"
#include "actio/parallel/thread_ranks.hpp"
#include "ranks_through.hpp"

using namespace actio;
using namespace actio::media;

namespace {

/// A start in the plane.
std::array<double, 2> place(std::array<double, 2> const& X) {
  return {X[0] + 0.02 * std::sin(3 * X[1]), X[1] + 0.03 * std::cos(2 * X[0])};
}
std::array<double, 2> rate(std::array<double, 2> const& X) {
  return {0.1 * std::sin(5 * X[1]), -0.2 * X[0] * X[1]};
}

/// Places and velocities after some steps, with a state that was taken on the way and gone on from.
template <class Medium, class Box, class Placement, class Velocity>
auto run(Medium const& medium, Box const& box, double dt, Placement const& placement,
         Velocity const& velocity, FastOptions const& options) {
  FastMedium<Medium, Box> made(medium, box, dt, 1.2, placement, velocity, options);
  made.step(7);
  auto const state = made.state();
  made.step(3);
  made.look_ahead(dt / 3);
  FastMedium<Medium, Box> other(medium, box, dt, 1.2, placement, velocity, options);
  other.go_on_from(state);
  other.step(20);
  auto out = other.state();
  out.places.push_back(made.places().back());
  return out;
}

template <class Medium, class Box, class Placement, class Velocity>
void check_ranks(Medium const& medium, Box const& box, double dt, Placement const& placement,
                 Velocity const& velocity) {
  auto const alone = run(medium, box, dt, placement, velocity, {});
  for (int const ranks : {1, 2, 3, 4, 7})
    for (int const threads : {1, 2})
      for (int const levels : {1, 3}) {
        decltype(run(medium, box, dt, placement, velocity, {})) together;
        on_thread_ranks(ranks, [&](Ranks& here) {
          FastOptions options;
          options.threads = threads, options.levels = levels, options.ranks = &here;
          share_parts(
              here, [&](std::string const&, double step) { return medium_part(medium, box, step, options); },
              [&] { together = run(medium, box, dt, placement, velocity, options); });
        });
        BOOST_TEST((alone.places == together.places));
        BOOST_TEST((alone.velocities == together.velocities));
      }
}

}  // namespace

/// Ranks that put a copy together from a share of each of three, as one does who sums over ranks, where
/// others copy it.
class AddingRanks final : public testing::RanksThrough {
 public:
  using RanksThrough::RanksThrough;
  void exchange(int to, std::span<std::byte const> mine, int from, std::span<std::byte> theirs) override {
    RanksThrough::exchange(to, mine, from, theirs);
    std::vector<double> now(theirs.size() / sizeof(double));
    std::ranges::copy(theirs, bytes_of(now).begin());
    for (double& one : now) one = one / 3 + one / 3 + one / 3;
    std::ranges::copy(bytes_of(now), theirs.begin());
  }
};

BOOST_AUTO_TEST_SUITE(media_on_ranks)

// The control: bits notice what a sum across ranks leaves of them, with three of them, and with one nothing.
BOOST_AUTO_TEST_CASE(a_sum_across_ranks_changes_bits) {
  auto const law = neo_hookean(1, 1);
  FastBox2d const box{{13, 17}, {0.1, 0.08}};
  auto const alone = run(law, box, 0.01, place, rate, {});
  for (int const ranks : {1, 3}) {
    decltype(run(law, box, 0.01, place, rate, {})) together;
    on_thread_ranks(ranks, [&](Ranks& threads) {
      AddingRanks here(threads);
      FastOptions options;
      options.ranks = &here;
      share_parts(
          here, [&](std::string const&, double step) { return medium_part(law, box, step, options); },
          [&] { together = run(law, box, 0.01, place, rate, options); });
    });
    BOOST_TEST((alone.places == together.places) == (ranks == 1));
    // It is a matter of bits, and of nothing more.
    double most = 0;
    for (std::size_t k = 0; k < alone.places.size(); ++k)
      most = std::max(most, std::abs(alone.places[k][0] - together.places[k][0]));
    BOOST_TEST(most < 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(what_each_has_is_known_everywhere) {
  for (int const ranks : {1, 2, 5})
    on_thread_ranks(ranks, [&](Ranks& here) {
      std::vector<long> const all = all_of(here, 10L + here.rank());
      bool right = all.size() == static_cast<std::size_t>(ranks);
      for (std::size_t k = 0; k < all.size(); ++k) right = right && all[k] == 10 + static_cast<long>(k);
      if (!right) throw std::logic_error("rank " + std::to_string(here.rank()) + " has heard something else");
    });
}

BOOST_AUTO_TEST_CASE(what_throws_ends_all_ranks) {
  auto const law = neo_hookean(1, 1);
  FastBox2d const box{{4, 8}, {0.1, 0.1}};
  auto const home = [](auto const& X) { return X; };
  auto const rest = [](auto const&) { return std::array{0.0, 0.0}; };
  for (int const failing : {0, 1, 2})
    BOOST_CHECK_THROW(on_thread_ranks(3,
                                      [&](Ranks& here) {
                                        FastOptions options;
                                        options.ranks = &here;
                                        share_parts(
                                            here,
                                            [&](std::string const&, double step) {
                                              if (here.rank() == failing) throw std::domain_error("a part");
                                              return medium_part(law, box, step, options);
                                            },
                                            [&] {
                                              FastMedium made(law, box, 0.01, 1, home, rest, options);
                                              made.step(3);
                                              if (failing == 0) throw std::domain_error("rank 0");
                                            });
                                      }),
                      std::domain_error);
}

BOOST_AUTO_TEST_CASE(in_the_plane) {
  auto const solid = neo_hookean(1, 1);
  check_ranks(solid, FastBox2d{{13, 17}, {0.1, 0.08}}, 0.01, place, rate);
  FastBox2d walls{{9, 15}, {0.1, 0.08}};
  walls.below_above = {Side::fixed, Side::sliding}, walls.left_right = {Side::sliding, Side::free};
  check_ranks(solid, walls, 0.01, place, rate);
  FastBox2d around{{12, 16}, {0.1, 0.1}};
  around.below_above = {Side::periodic, Side::periodic};
  auto const wave = [](std::array<double, 2> const& X) {
    double const k = 2 * 3.14159265358979323846 / 1.6;
    return std::array<double, 2>{X[0] + 0.02 * std::sin(k * X[1]), X[1] + 0.01 * std::cos(k * X[1])};
  };
  check_ranks(solid, around, 0.01, wave, rate);
}

BOOST_AUTO_TEST_CASE(in_space) {
  auto const place = [](std::array<double, 3> const& X) {
    return std::array<double, 3>{X[0] + 0.02 * std::sin(3 * X[1]), X[1] + 0.02 * std::cos(2 * X[2]), X[2]};
  };
  auto const rate = [](std::array<double, 3> const& X) {
    return std::array<double, 3>{0.1 * std::sin(5 * X[2]), -0.2 * X[0] * X[1], 0.1};
  };
  auto const solid = neo_hookean(1, 1);
  check_ranks(solid, FastBox3d{{5, 4, 9}, {0.1, 0.1, 0.1}}, 0.01, place, rate);
  FastBox3d around{{4, 5, 8}, {0.1, 0.1, 0.1}};
  around.ends(2) = {Side::periodic, Side::periodic}, around.ends(1) = {Side::fixed, Side::free};
  auto const wave = [](std::array<double, 3> const& X) {
    double const k = 2 * 3.14159265358979323846 / 0.8;
    return std::array<double, 3>{X[0] + 0.02 * std::sin(k * X[2]), X[1], X[2]};
  };
  check_ranks(solid, around, 0.01, wave, rate);
}

BOOST_AUTO_TEST_SUITE_END()
