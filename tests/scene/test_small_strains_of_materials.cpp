// The energies and stresses that materials of scenes have at small strains, against 50 digits.
#include <boost/test/unit_test.hpp>

#include "program/systems/media/material.hpp"
#include "witness/draw.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::scene;

namespace {
template <int d>
using Many = Matrix<Number, d, d>;

/// W and its derivative, as a book has them, given F.
template <int d>
std::pair<Number, Many<d>> mooney_rivlin(Many<d> const& F, double c1, double c2, double lambda) {
  Many<d> const C = F.transpose() * F;
  Number const J = media::small_determinant(F), first = C.trace(),
               second = (first * first - (C * C).trace()) / 2,
               slope = 2 * (Number(c1) + (d - 1) * Number(c2));
  Many<d> S = C * Number(-2 * c2);
  for (int i = 0; i < d; ++i) S(i, i) += 2 * c1 + 2 * c2 * first;
  return {c1 * (first - d) + c2 * (second - d * (d - 1) / 2) - slope * log(J) + lambda * log(J) * log(J) / 2,
          F * S + media::cofactors(F) * Number((lambda * log(J) - slope) / J)};
}
template <int d>
std::pair<Number, Many<d>> tait(Many<d> const& F, double B, double gamma) {
  Number const J = media::small_determinant(F);
  return {B * ((pow(J, 1 - Number(gamma)) - 1) / (Number(gamma) - 1) + J - 1),
          media::cofactors(F) * Number(B * (1 - pow(J, -Number(gamma))))};
}

/// @param size_of_terms  of the terms of its energy
template <int d, class M, class Witness>
void is_known(M const& material, double size_of_terms, Witness const& witness, Draw& draw) {
  auto const law = stored_energy_of<d>(material);
  for (double const size : {1e-12, 1e-8, 1e-4, 0.1, 0.2})
    for (int sample = 0; sample < 4; ++sample) {
      Matrix<double, d, d> H;
      for (int k = 0; k < d * d; ++k) H.data()[k] = size * draw.number<double>();
      Many<d> F = H.template cast<Number>();
      for (int i = 0; i < d; ++i) F(i, i) += 1;
      auto const [energy, stress] = witness(F);
      double const W = to_double(energy);
      double off = 0, most = 0;
      Matrix<double, d, d> const P = law->stress_beyond(H);
      for (int k = 0; k < d * d; ++k) {
        double const exact = to_double(stress.data()[k]);
        off = std::max(off, std::abs(P.data()[k] - exact)), most = std::max(most, std::abs(exact));
      }
      BOOST_TEST(off <= 1e-13 * most, M::name << " stress at " << size);
      // From an eighth on the formula of F is taken: a difference of terms of the size of the constants, each
      // rounded a few times. What it is at small strains is not known from it.
      bool small = true;
      for (int k = 0; k < d * d; ++k) small = small && std::abs(H.data()[k]) < 0.125;
      double const terms = small ? 0 : size_of_terms;
      BOOST_TEST(std::abs(law->energy_beyond(H) - W) <= 1e-13 * W + 8 * epsilon<double>() * terms,
                 M::name << " energy at " << size << ": " << law->energy_beyond(H) - W << " of " << W);
    }
}

template <int d>
void every_material() {
  WithArithmetic const digits(Arithmetic::decimal(50));
  Draw draw(20 + d);
  is_known<d>(
      materials::MooneyRivlin{0.4, 0.1, 1.1}, 0.4,
      [](Many<d> const& F) { return mooney_rivlin<d>(F, 0.4, 0.1, 1.1); }, draw);
  is_known<d>(
      materials::Tait{1.3, 7}, 1.3, [](Many<d> const& F) { return tait<d>(F, 1.3, 7); }, draw);
}
}  // namespace

BOOST_AUTO_TEST_SUITE(small_strains_of_materials)

BOOST_AUTO_TEST_CASE(nothing_is_lost_of_them_on_a_line) { every_material<1>(); }
BOOST_AUTO_TEST_CASE(nothing_is_lost_of_them_in_the_plane) { every_material<2>(); }
BOOST_AUTO_TEST_CASE(nothing_is_lost_of_them_in_space) { every_material<3>(); }

BOOST_AUTO_TEST_SUITE_END()
