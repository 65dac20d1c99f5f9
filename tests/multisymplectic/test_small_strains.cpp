// Stored energies and stresses of small strains against 50 digits: nothing is lost, however small they are.
#include <boost/test/unit_test.hpp>

#include "actio/fast_media/fast_medium_2d.hpp"
#include "actio/fast_media/fast_medium_3d.hpp"
#include "actio/media_on_meshes/medium_on_mesh.hpp"
#include "witness/draw.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::media;

namespace {
template <class T, int d>
using Square = Matrix<T, d, d>;

/// Some hundred roundings.
constexpr double bound = 1e-13;

template <int d>
Square<Number, d> in_many_digits(Square<double, d> const& A) { return A.template cast<Number>(); }
template <int d>
Square<Number, d> with_identity(Square<Number, d> A) {
  for (int i = 0; i < d; ++i) A(i, i) += 1;
  return A;
}

/// As in a book, given F: \f$\tfrac\lambda2(\Tr E)^2+\mu\Tr E^2\f$ and its derivative.
template <int d>
struct Kirchhoff {
  double lambda, mu;
  Square<Number, d> strain(Square<Number, d> const& F) const {
    Square<Number, d> const C = F.transpose() * F;
    return (C - Square<Number, d>::Identity()) * Number(0.5);
  }
  Number energy(Square<Number, d> const& F) const {
    auto const E = strain(F);
    return lambda * E.trace() * E.trace() / 2 + mu * (E * E).trace();
  }
  Square<Number, d> stress(Square<Number, d> const& F) const {
    auto const E = strain(F);
    Square<Number, d> S = E * Number(2 * mu);
    for (int i = 0; i < d; ++i) S(i, i) += lambda * E.trace();
    return F * S;
  }
};
/// \f$\tfrac\mu2(\Tr C-d)+U(J)\f$, given U and U'.
template <int d, class U, class Slope>
struct Rubber {
  double mu;
  U u;
  Slope slope;
  Number energy(Square<Number, d> const& F) const {
    return mu * ((F.transpose() * F).trace() - d) / 2 + u(small_determinant(F));
  }
  Square<Number, d> stress(Square<Number, d> const& F) const {
    return F * Number(mu) + cofactors(F) * Number(slope(small_determinant(F)));
  }
};
template <int d, class U, class Slope>
Rubber<d, U, Slope> rubber(double mu, U u, Slope slope) { return {mu, u, slope}; }

/// Green's strain and the stress of it, in 50 digits.
template <int d>
Square<double, d> rounded(Square<Number, d> const& A) {
  return A.unaryExpr([](Number const& x) { return to_double(x); });
}
template <int d>
double largest(Square<double, d> const& A) {
  double most = 0;
  for (int k = 0; k < d * d; ++k) most = std::max(most, std::abs(A.data()[k]));
  return most;
}

template <int d, class Medium, class Witness>
void is_known(Medium const& medium, Witness const& witness, Draw& draw, bool energy = true) {
  auto const law = stored_energy<d>(medium);
  for (double const size : {1e-12, 1e-8, 1e-6, 1e-3, 0.1, 0.2})
    for (int sample = 0; sample < 4; ++sample) {
      Square<double, d> H;
      for (int k = 0; k < d * d; ++k) H.data()[k] = size * draw.number<double>();
      auto const F = with_identity<d>(in_many_digits<d>(H));
      double const W = to_double(witness.energy(F));
      Square<Number, d> const P = witness.stress(F), S = inverse_matrix(F) * P, C = F.transpose() * F;
      if (energy) BOOST_TEST(std::abs(law->energy_beyond(H) - W) <= bound * W, "energy at " << size);
      Square<double, d> const off = law->stress_beyond(H) - rounded<d>(P);
      BOOST_TEST(largest<d>(off) <= bound * largest<d>(rounded<d>(P)), "stress at " << size);
      Square<double, d> const E = rounded<d>((C - Square<Number, d>::Identity()) * Number(0.5)),
                              off_green = law->green_stress_beyond(E) - rounded<d>(S);
      BOOST_TEST(largest<d>(off_green) <= bound * largest<d>(rounded<d>(S)), "green at " << size);
    }
}

template <int d>
void every_medium() {
  WithArithmetic const digits(Arithmetic::decimal(50));
  Draw draw(10 + d);
  is_known<d>(FastStVenantKirchhoff{0.9, 0.6}, Kirchhoff<d>{0.9, 0.6}, draw);
  is_known<d>(per_volume(FastStVenantKirchhoff{0.9, 0.6}), Kirchhoff<d>{0.9, 0.6}, draw);
  is_known<d>(neo_hookean(1.3, 0.7),
              rubber<d>(
                  0.7, [](Number const& J) { return Number(log(J) * (log(J) * 1.3 / 2 - 0.7)); },
                  [](Number const& J) { return Number((log(J) * 1.3 - 0.7) / J); }),
              draw);
  auto const quadratic = rubber<d>(
      0.7, [](Number const& J) { return Number((J - 1) * (J - 1) * 1.9 / 2 - log(J) * 0.7); },
      [](Number const& J) { return Number((J - 1) * 1.9 - 0.7 / J); });
  is_known<d>(FastNeoHookean<QuadraticLaw>{0.7, {0.7, 1.9}}, quadratic, draw);
  is_known<d>(FastNeoHookean<ReciprocalLaw>{0.7, {0.7, 1.9, 1.9}}, quadratic, draw);
  // Its energy at rest is not zero.
  is_known<d>(blatz_ko<1>(0.8),
              rubber<d>(
                  0.8, [](Number const& J) { return Number(Number(0.4) / (J * J)); },
                  [](Number const& J) { return Number(Number(-0.8) / (J * J * J)); }),
              draw);
}

/// A body that is strained a little, and the energy that its nodes have where they are.
template <int d>
struct Strained {
  std::array<int, d> cells;
  double size = 1e-8;
  std::array<double, d> operator()(std::array<double, d> const& X) const {
    auto x = X;
    for (int a = 0; a < d; ++a) x[a] += size * (0.7 * X[a] + 0.4 * X[(a + 1) % d] * X[a]);
    return x;
  }
};
/// The sum over the corners of all cells in 50 digits, given how far nodes are from where they are in the
/// body.
template <int d, class Witness>
double exact_energy(std::array<int, d> const& cells, std::vector<std::array<double, d>> const& X,
                    std::vector<std::array<double, d>> const& x, Witness const& witness) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  Number sum = 0, part = 1;
  for (int const n : cells) part /= 2 * n;
  media::detail::for_indices(cells, [&](auto const& cell) {
    for (int corner = 0; corner < 1 << d; ++corner) {
      auto const at = [&](int bits) {
        std::size_t node = 0;
        for (int a = d - 1; a >= 0; --a)
          node = node * static_cast<std::size_t>(cells[a] + 1) +
                 static_cast<std::size_t>(cell[a] + (bits >> a & 1));
        return node;
      };
      Square<Number, d> F;
      for (int k = 0; k < d; ++k)
        for (int i = 0; i < d; ++i) {
          std::size_t const low = at(corner & ~(1 << k)), up = at(corner | 1 << k);
          F(i, k) =
              (Number(x[up][i]) - X[up][i] - (Number(x[low][i]) - X[low][i])) * cells[k] + (i == k ? 1 : 0);
        }
      sum += part * witness.energy(F);
    }
  });
  return to_double(sum);
}
}  // namespace

BOOST_AUTO_TEST_SUITE(small_strains)

BOOST_AUTO_TEST_CASE(functions_that_vanish_with_their_arguments_lose_nothing) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  for (double size = 1e-12; size < 0.9; size *= 3.7)
    for (double const x : {size, -size}) {
      Number const many = x;
      double const first = to_double(many - log(1 + many)), second = to_double(exp(many) - 1 - many);
      BOOST_TEST(std::abs(without_logarithm(x) - first) <= 4e-15 * first, x);
      BOOST_TEST(std::abs(exponential_beyond_line(x) - second) <= 4e-15 * second, x);
    }
}

BOOST_AUTO_TEST_CASE(energies_and_stresses_are_those_of_50_digits_on_a_line) { every_medium<1>(); }
BOOST_AUTO_TEST_CASE(energies_and_stresses_are_those_of_50_digits_in_the_plane) { every_medium<2>(); }
BOOST_AUTO_TEST_CASE(energies_and_stresses_are_those_of_50_digits_in_space) { every_medium<3>(); }

BOOST_AUTO_TEST_CASE(a_body_in_the_plane_knows_its_energy_on_both_ways) {
  Strained<2> const strained{{8, 8}};
  FastStVenantKirchhoff const medium{0.9, 0.6};
  FastBox2d const box{.cells = strained.cells, .spacing = {0.125, 0.125}};
  FastMedium2d<FastStVenantKirchhoff> const fast(medium, box, 0.01, 1, strained, [](auto const&) {
    return std::array{0.0, 0.0};
  });
  BodyStart<2> start;
  start.placement = strained;
  MediumOnMesh<2> const plain(box_mesh({0, 0}, {1, 1}, {8, 8}), stored_energy<2>(medium), start,
                              {.step = 0.01});
  std::vector<std::array<double, 2>> X;
  media::detail::for_nodes(box, [&](auto const& node, std::size_t) { X.push_back(box.at(node)); });
  double const exact = exact_energy<2>(strained.cells, X, plain.places(), Kirchhoff<2>{0.9, 0.6});
  BOOST_TEST(std::abs(plain.energies().stored - exact) <= bound * exact);
  BOOST_TEST(std::abs(fast.energies()[1] - exact) <= bound * exact);
}

BOOST_AUTO_TEST_CASE(a_body_at_rest_has_no_energy_and_stays_there) {
  BodyStart<3> start;
  MediumOnMesh<3> body(box_mesh({0.1, 0.2, 0.3}, {1, 1.3, 1.7}, {3, 3, 3}),
                       stored_energy<3>(per_volume(FastNeoHookean{0.7, QuadraticLaw{0.7, 1.9}})), start,
                       {.step = 0.01});
  body.step(20);
  BOOST_TEST(body.energies().total() == 0);
}

BOOST_AUTO_TEST_CASE(steps_that_conserve_energy_do_so_at_any_strain) {
  for (double const size : {1e-3, 1e-6, 1e-8}) {
    Strained<2> const strained{{4, 4}, size};
    BodyStart<2> start;
    start.placement = strained;
    MediumOnMesh<2> body(box_mesh({0, 0}, {1, 1}, {4, 4}),
                         stored_energy<2>(FastNeoHookean{0.7, QuadraticLaw{0.7, 1.9}}), start,
                         {.step = 0.02, .conserve = Conserve::energy});
    double const first = body.energies().total();
    body.step(200);
    BOOST_TEST_MESSAGE("strain " << size << ": energy off by " << body.energies().total() / first - 1);
    BOOST_TEST(std::abs(body.energies().total() / first - 1) <= bound);
  }
}

BOOST_AUTO_TEST_SUITE_END()
