// Cells of the optimised implementation by what defines them: the energy of a cell as a sum over its corners,
// forces and stiffness as its derivatives.
#include <boost/test/unit_test.hpp>
#include <functional>
#include <random>

#include "actio/fast_media/fast_forces.hpp"

using namespace actio;
using namespace actio::media;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
template <std::size_t n>
using Corners = std::array<std::array<long double, n>, 1 << n>;

/// The traces of C and of its square, J, and the number of dimensions.
struct Invariants {
  long double of_C = 0, of_square = 0, J = 0;
  int n = 0;
};
/// W from these.
using Energy = std::function<long double(Invariants const&)>;
Energy gas(long double K, long double gamma) {
  return [=](Invariants const& F) { return K / (gamma - 1) * std::pow(F.J, 1 - gamma); };
}
Energy st_venant_kirchhoff(long double lambda, long double mu) {
  return [=](Invariants const& F) {
    long double const trace = (F.of_C - F.n) / 2, square = (F.of_square - 2 * F.of_C + F.n) / 4;
    return lambda / 2 * trace * trace + mu * square;
  };
}
/// With \f$U = \tfrac b2(J-1)^2+(b-c)J-a\log J+\tfrac\lambda2\log^2J\f$.
Energy neo_hookean_with(long double mu, long double lambda, long double a, long double b, long double c) {
  return [=](Invariants const& F) {
    long double const J = F.J, l = std::log(J);
    return mu / 2 * (F.of_C - F.n) + b / 2 * (J - 1) * (J - 1) + (b - c) * J - a * l + lambda / 2 * l * l;
  };
}
/// The mean of W over the corners, times the measure of the cell.
template <std::size_t n>
long double plain_energy(Energy const& W, std::array<double, n> const& h, Corners<n> const& x) {
  long double sum = 0, measure = 1;
  for (double const one : h) measure *= one;
  for (std::size_t corner = 0; corner < 1 << n; ++corner) {
    // The columns of F, one for each edge that meets there.
    long double F[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (std::size_t d = 0; d < n; ++d)
      for (std::size_t i = 0; i < n; ++i)
        F[d][i] = (x[corner | 1u << d][i] - x[corner & ~(1u << d)][i]) / h[d];
    Invariants of{0, 0, 0, n};
    for (std::size_t d = 0; d < n; ++d)
      for (std::size_t e = 0; e < n; ++e) {
        long double const C = F[d][0] * F[e][0] + F[d][1] * F[e][1] + (n > 2 ? F[d][2] * F[e][2] : 0);
        of.of_C += d == e ? C : 0, of.of_square += C * C;
      }
    for (std::size_t i = 0; i < 3; ++i) {
      std::size_t const j = (i + 1) % 3, k = (i + 2) % 3;
      of.J += F[0][i] * (F[1][j] * F[2][k] - F[1][k] * F[2][j]);
    }
    sum += W(of);
  }
  return measure * sum / (1 << n);
}

/// The larger number; none is the largest.
double larger(double a, double b) { return b <= a ? a : b; }

/// Boxes of cells of three different lengths.
FastBox2d plane() { return {{3, 2}, {0.3, 0.2}}; }
FastBox3d space() { return {{3, 2, 1}, {0.3, 0.2, 0.25}}; }
template <class Box>
void move_all_round(Box& box) {
  for (int d = 0; d < Box::dimension; ++d) box.ends(d) = {Side::periodic, Side::periodic};
  // Sheared, so that each component of a period counts.
  for (std::size_t d = 0; d < Box::dimension; ++d)
    for (std::size_t i = 0; i < Box::dimension; ++i)
      box.period[d][i] =
          i == d ? 1.02 * box.cells[d] * box.spacing[d] : 0.03 + 0.01 * static_cast<double>(i + d);
}

/// How far a cell is from what it should be, over what is allowed.
struct Off {
  double energy = 0, force = 0, stiffness = 0;
};
/// What a medium makes of the cells of a box, all of whose directions are periodic, at places near those of a
/// homogeneous deformation, no two edges alike.
template <class Medium, class Box>
Off worst_of(Medium const& medium, Energy const& W, Box box) {
  constexpr int n = Box::dimension;
  using Vector = media::detail::VectorOf<Box, double>;
  using T = Dual<double>;
  move_all_round(box);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> some(-0.03, 0.03);
  std::vector<Vector> places;
  media::detail::for_nodes(box, [&](auto const& node, std::size_t) {
    Vector x{};
    for (std::size_t i = 0; i < n; ++i) {
      double& out = media::detail::component(x, static_cast<int>(i));
      out = some(random);
      for (std::size_t d = 0; d < n; ++d) out += node[d] * box.period[d][i] / box.cells[d];
    }
    places.push_back(x);
  });
  Off worst;
  auto const law = media::detail::cell_on(medium, box.spacing);
  media::detail::for_indices(box.cells, [&](std::array<int, n> const& cell) {
    // The corners, found once more.
    Corners<n> x;
    media::detail::VectorOf<Box, T> moved[1 << n];
    for (unsigned k = 0; k < 1 << n; ++k) {
      std::size_t at = 0;
      std::array<double, n> further{};
      for (unsigned d = n; d-- > 0;) {
        int const i = cell[d] + static_cast<int>(k >> d & 1), all = box.cells[d];
        at = at * static_cast<std::size_t>(all) + static_cast<std::size_t>(i % all);
        if (i == all)
          for (std::size_t c = 0; c < n; ++c) further[c] += box.period[d][c];
      }
      for (int c = 0; c < n; ++c) {
        Vector place = places[at];
        double const one = media::detail::component(place, c) + further[static_cast<std::size_t>(c)];
        x[k][static_cast<std::size_t>(c)] = one, media::detail::component(moved[k], c) = T(one);
      }
    }
    auto const edges = media::detail::edges_of(box, media::detail::corners_of(box, cell), places);
    long double const energy = plain_energy<n>(W, box.spacing, x);
    // Up to a hundred roundings of terms below 5, one after the other, and F, which is below 2, has lost
    // 2 eps |x|/h = 12 eps to the subtraction of places.
    double const bound = box.measure() * 5 * eps * (100 + 12 * 2 * n);
    double const found = media::detail::cell_energy(medium, box.spacing, edges);
    worst.energy = larger(worst.energy, std::abs(found - static_cast<double>(energy)) / bound);

    // A force is what the energy loses by a motion of the corner; terms are divided by a length of 0.2.
    auto const forces = media::detail::corner_forces(law, edges);
    for (std::size_t k = 0; k < forces.size(); ++k)
      for (int c = 0; c < n; ++c) {
        T& one = media::detail::component(moved[k], c);
        one.part[0] = 1;
        double const slope =
            media::detail::cell_energy(medium, box.spacing, media::detail::edges_between(moved)).part[0];
        one.part[0] = 0;
        Vector force = forces[k];
        worst.force =
            larger(worst.force, std::abs(media::detail::component(force, c) + slope) / (4 * n * bound / 0.2));
      }

    // The second derivative when the corners go towards each other, by differences: their error is delta^2
    // over h^2 times a constant, 1e-8 of the derivative, and rounding of long double counts for less.
    long double const delta = 1e-5L;
    auto const squeezed = [&](long double by) {
      Corners<n> y = x;
      for (unsigned k = 0; k < 1 << n; ++k)
        for (unsigned d = 0; d < n; ++d) y[k][d] += k >> d & 1 ? -by : by;
      return plain_energy<n>(W, box.spacing, y);
    };
    auto const stiffness =
        static_cast<double>((squeezed(delta) - 2 * energy + squeezed(-delta)) / (delta * delta));
    double const off = media::detail::stiffness_of(box, law, cell, places) / stiffness - 1;
    worst.stiffness = larger(worst.stiffness, std::abs(off) / 1e-6);
  });
  return worst;
}
void is_within_bounds(Off const& worst) {
  BOOST_TEST(worst.energy <= 1);
  BOOST_TEST(worst.force <= 1);
  BOOST_TEST(worst.stiffness <= 1);
}
template <class Box>
void cells_are_what_they_should(Box const& box) {
  is_within_bounds(worst_of(FastFluid{PolytropicByRoots<5, 7>{0.7}}, gas(0.7, 1.4L), box));
  is_within_bounds(worst_of(FastStVenantKirchhoff{0.9, 0.6}, st_venant_kirchhoff(0.9, 0.6), box));
  is_within_bounds(worst_of(neo_hookean(0.9, 0.6), neo_hookean_with(0.6, 0.9, 0.6, 0, 0), box));
  is_within_bounds(worst_of(FastNeoHookean{0.6, ReciprocalLaw{0.5, 0.75, 0.25}},
                            neo_hookean_with(0.6, 0, 0.5, 0.75, 0.25), box));
}
}  // namespace

BOOST_AUTO_TEST_SUITE(fast_cells)

BOOST_AUTO_TEST_CASE(energy_forces_and_stiffness_of_a_cell_are_those_of_the_sum_over_its_corners) {
  cells_are_what_they_should(plane());
  cells_are_what_they_should(space());
}

BOOST_AUTO_TEST_SUITE_END()
