// The largest strains of a medium on a box: those of each corner by Eigen, on any number of ranks and
// threads.
#include <Eigen/Dense>
#include <boost/test/unit_test.hpp>

#include "actio/fast_media/fast_medium_2d.hpp"
#include "actio/fast_media/fast_medium_3d.hpp"
#include "actio/parallel/thread_ranks.hpp"

using namespace actio;
using namespace actio::media;

namespace {

/// Cell by cell and corner by corner.
template <class Medium>
Strains one_by_one(Medium const& made) {
  constexpr int d = std::tuple_size_v<typename Medium::Point>;
  using Matrix = Eigen::Matrix<double, d, d>;
  auto const& box = made.box();
  auto const state = made.state();
  Strains out;
  actio::media::detail::for_indices(box.cells, [&](auto const& cell) {
    auto const corners = actio::media::detail::corners_of(box, cell);
    auto const edges = [&](std::size_t corner, auto const& of, bool places) {
      Matrix out;
      for (std::size_t k = 0; k < d; ++k)
        for (std::size_t i = 0; i < d; ++i) {
          std::size_t const end = corner | std::size_t{1} << k, begin = end ^ std::size_t{1} << k;
          double edge = of[corners.node[end]][i] - of[corners.node[begin]][i];
          bool const seam = corners.periods[end] >> k & 1;
          if (places && seam && i == k) edge += box.cells[k] * box.spacing[k];
          out(static_cast<int>(i), static_cast<int>(k)) = edge / box.spacing[k];
        }
      return out;
    };
    for (std::size_t p = 0; p < std::size_t{1} << d; ++p) {
      Matrix const F = edges(p, state.places, true), back = F.inverse();
      Strains here{back.squaredNorm(), F.squaredNorm(), 0};
      if (p == 0) {
        Matrix const L = edges(p, state.velocities, false) * back, D = (L + L.transpose()) / 2;
        here.rate = D.squaredNorm();
      }
      out = out.with(here);
    }
  });
  return out;
}

template <class Box, class Placement, class Velocity>
void check_strains(Box const& box, Placement const& placement, Velocity const& velocity) {
  auto const law = neo_hookean(1, 1);
  Strains alone;
  {
    FastMedium<decltype(law), Box> made(law, box, 0.005, 1, placement, velocity);
    made.step(9);
    Strains const expected = one_by_one(made);
    alone = made.strains();
    // Rounding of places beside the edges between them, some tens of operations.
    double const bound = 1e-12;
    BOOST_TEST(std::abs(alone.squeeze - expected.squeeze) <= bound * expected.squeeze);
    BOOST_TEST(std::abs(alone.stretch - expected.stretch) <= bound * expected.stretch);
    BOOST_TEST(std::abs(alone.rate - expected.rate) <= bound * expected.rate);
    BOOST_TEST(expected.rate > 0);
  }
  for (int const ranks : {1, 2, 3})
    for (int const threads : {1, 2})
      on_thread_ranks(ranks, [&](Ranks& here) {
        FastOptions options;
        options.threads = threads, options.ranks = &here;
        share_parts(
            here, [&](std::string const&, double step) { return medium_part(law, box, step, options); },
            [&] {
              FastMedium<decltype(law), Box> made(law, box, 0.005, 1, placement, velocity, options);
              made.step(9);
              Strains const found = made.strains();
              BOOST_TEST((found.squeeze == alone.squeeze && found.stretch == alone.stretch &&
                          found.rate == alone.rate));
            });
      });
}

}  // namespace

BOOST_AUTO_TEST_SUITE(strains_on_ranks)

BOOST_AUTO_TEST_CASE(in_the_plane) {
  auto const place = [](std::array<double, 2> const& X) {
    return std::array<double, 2>{X[0] + 0.02 * std::sin(3 * X[1]), X[1] + 0.03 * std::cos(2 * X[0])};
  };
  auto const rate = [](std::array<double, 2> const& X) {
    return std::array<double, 2>{0.1 * std::sin(5 * X[1]), -0.2 * X[0] * X[1]};
  };
  check_strains(FastBox2d{{13, 17}, {0.1, 0.08}}, place, rate);
  check_strains(FastBox2d{{3, 6}, {0.1, 0.08}}, place, rate);
  FastBox2d around{{12, 16}, {0.1, 0.1}};
  around.below_above = around.left_right = {Side::periodic, Side::periodic};
  double const k1 = 2 * 3.14159265358979323846 / 1.2, k2 = 2 * 3.14159265358979323846 / 1.6;
  check_strains(
      around,
      [&](std::array<double, 2> const& X) {
        return std::array<double, 2>{X[0] + 0.02 * std::sin(k2 * X[1]), X[1] + 0.01 * std::cos(k1 * X[0])};
      },
      [&](std::array<double, 2> const& X) {
        return std::array<double, 2>{0.1 * std::sin(k2 * X[1]), 0.2 * std::cos(k1 * X[0])};
      });
}

BOOST_AUTO_TEST_CASE(in_space) {
  auto const rate = [](std::array<double, 3> const& X) {
    return std::array<double, 3>{0.1 * std::sin(5 * X[2]), -0.2 * X[0] * X[1], 0.1 * X[2]};
  };
  check_strains(
      FastBox3d{{5, 4, 9}, {0.1, 0.08, 0.12}},
      [](std::array<double, 3> const& X) {
        return std::array<double, 3>{X[0] + 0.02 * std::sin(3 * X[1]), X[1] + 0.02 * std::cos(2 * X[2]),
                                     X[2] + 0.02 * X[0] * X[1]};
      },
      rate);
  FastBox3d around{{4, 5, 8}, {0.1, 0.1, 0.1}};
  around.ends(2) = around.ends(1) = {Side::periodic, Side::periodic};
  double const k = 2 * 3.14159265358979323846 / 0.8, k2 = 2 * 3.14159265358979323846 / 0.5;
  check_strains(
      around,
      [&](std::array<double, 3> const& X) {
        return std::array<double, 3>{X[0] + 0.01 * std::sin(k * X[2]), X[1],
                                     X[2] + 0.004 * std::cos(k2 * X[1])};
      },
      [&](std::array<double, 3> const& X) {
        return std::array<double, 3>{0.1 * std::cos(k * X[2]), 0.1 * std::sin(k2 * X[1]), 0.1};
      });
}

BOOST_AUTO_TEST_SUITE_END()
