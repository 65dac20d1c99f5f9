// Materials whose energy is a formula of the scene: they are those of the library where the formula is
// theirs, and what is no energy of a solid is refused.
#include <boost/test/unit_test.hpp>

#include "last_row.hpp"
#include "program/systems/media/material.hpp"
#include "refusal.hpp"
#include "witness/draw.hpp"

using namespace actio;
using namespace actio::scene;

namespace {

std::string own(std::string const& energy, std::string const& constants) {
  return "energy = \"" + energy + "\", constants = { " + constants + " }";
}
std::string text_of(std::string const& material, std::string const& mesh) {
  return "[system]\nkind = \"elastic_body\"\nmaterial = { " + material + " }\nmesh = { " + mesh +
         " }\n[initial]\nvelocity = [\"0.3*Y\", \"0.2*X - 0.1*Y\"]\n[method]\nstep = 0.01\n"
         "[run]\nuntil = 0.5\nevery = 0.1\n[output]\nquantities = [\"energy\", \"angular_momentum\", "
         "\"min_jacobian\"]\n";
}
std::string const disc = "shape = \"disc\", radius = 1, cells = [3, 3]";

/// A formula against a material of the library, at deformations of some size.
/// @param size  of the terms of W
template <int d, class M>
void is_the_same(std::string const& energy, std::string const& constants, M const& material, double size) {
  auto const file = SceneFile::parse("[system]\nmaterial = { " + own(energy, constants) + " }\n", "own.toml");
  auto const ours = stored_energy_of<d>(read_material(file.section("system"), false, d)),
             theirs = stored_energy_of<d>(material);
  Draw draw(7 + d);
  for (int sample = 0; sample < 20; ++sample) {
    Matrix<double, d, d> H, change;
    for (int k = 0; k < d * d; ++k)
      H.data()[k] = (sample % 2 ? 0.3 : 1e-3) * draw.number<double>() / d,
      change.data()[k] = draw.number<double>();
    // Each formula rounds terms of the size of the moduli some ten times.
    double const rounding = 100 * epsilon<double>() * size;
    auto const near = [&](Matrix<double, d, d> const& a, Matrix<double, d, d> const& b, char const* what) {
      double off = 0;
      for (int k = 0; k < d * d; ++k) off = std::max(off, std::abs(a.data()[k] - b.data()[k]));
      BOOST_TEST(off <= rounding, what << " of " << energy);
    };
    BOOST_TEST(std::abs(ours->energy_beyond(H) - theirs->energy_beyond(H)) <= rounding, energy);
    near(ours->stress_beyond(H), theirs->stress_beyond(H), "the stress");
    Matrix<double, d, d> const F = media::beyond_identity<d>(H), E = media::green_strain(H);
    near(ours->green_stress_beyond(E), theirs->green_stress_beyond(E), "the stress of Green's strain");
    near(ours->stress_rate(F, change), theirs->stress_rate(F, change), "the rate of the stress");
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(energy_formula)

BOOST_AUTO_TEST_CASE(it_is_the_material_of_the_library_that_has_this_formula) {
  std::string const rubber = " - 2*log(J)) + kappa/2*(J - 1)^2", moduli = "mu = 1, kappa = 2.5";
  is_the_same<1>("mu/2*(I1 - 1" + rubber, moduli, materials::NeoHookean{1, 2.5}, 10);
  is_the_same<2>("mu/2*(I1 - 2" + rubber, moduli, materials::NeoHookean{1, 2.5}, 10);
  is_the_same<3>("mu/2*(I1 - 3" + rubber, moduli, materials::NeoHookean{1, 2.5}, 10);
  is_the_same<3>("c1*(I1 - 3) + c2*(I2 - 3) - 2*(c1 + 2*c2)*log(J) + lambda/2*log(J)^2",
                 "c1 = 0.4, c2 = 0.1, lambda = 1.1", materials::MooneyRivlin{0.4, 0.1, 1.1}, 10);
  is_the_same<2>("trace = C11 + C22 - 2; lambda/8*trace^2 + mu/4*((C11 - 1)^2 + (C22 - 1)^2 + 2*C12^2)",
                 "lambda = 0.7, mu = 1.2", materials::SaintVenantKirchhoff{0.7, 1.2}, 10);
  is_the_same<3>(
      "trace = C11 + C22 + C33 - 3; lambda/8*trace^2 + mu/4*((C11 - 1)^2 + (C22 - 1)^2 + "
      "(C33 - 1)^2 + 2*C12^2 + 2*C13^2 + 2*C23^2)",
      "lambda = 0.7, mu = 1.2", materials::SaintVenantKirchhoff{0.7, 1.2}, 10);
}

BOOST_AUTO_TEST_CASE(a_body_of_it_moves_as_one_of_the_library_does) {
  for (std::string const method : {"", "conserve = \"energy\"\n"}) {
    auto const row = [&](std::string const& material) {
      std::string text = text_of(material, disc);
      return last_row(text.insert(text.find("step ="), method));
    };
    auto const library = row("name = \"neo_hookean\", mu = 1, kappa = 2"),
               formula = row(own("mu/2*(I1 - 2 - 2*log(J)) + kappa/2*(J - 1)^2", "mu = 1, kappa = 2"));
    BOOST_REQUIRE(library.size() == formula.size());
    for (std::size_t k = 0; k < library.size(); ++k)
      BOOST_TEST(std::abs(library[k] - formula[k]) <= 1e-12 * (1 + std::abs(library[k])), "number " << k);
  }
}

BOOST_AUTO_TEST_CASE(what_is_no_energy_of_a_stable_solid_is_refused_with_what_was_found) {
  auto const refused = [](std::string const& material, std::string const& words) {
    check_said(refusal(text_of(material, disc), "own.toml"), words);
  };
  std::string const rubber = "mu/2*(I1 - 2 - 2*log(J)) + kappa/2*(J - 1)^2";
  refused(own("mu/2*(I1 - 2 - 2*log(JJ))", "mu = 1"), "did you mean 'J'?");
  refused(own("mu/2*(I1 - 2 - 2*log(J)) + abs(J)", "mu = 1"), "abs");
  refused(own(rubber, "mu = 1, kappa = 2, kapa = 3"), "constants: 'kapa' does not occur in the energy");
  refused(own(rubber, "mu = 1, kappa = 2, I1 = 3"), "an invariant or a component of C");
  refused(own(rubber, "mu = -1, kappa = 2"), "the least shear modulus at rest must be positive");
  refused(own(rubber, "mu = 1, kappa = -1.5"), "the bulk modulus at rest must be positive");
  refused(own("mu/2*(I1 - 2) + kappa/2*(J - 1)^2", "mu = 1, kappa = 2"), "its stress at rest is 1");
  refused(own("sqrt(I1 - 2)", ""), "no finite number");
  refused("name = \"formula\"", "energy");
  refused("name = \"formula\", energy = \"I1\", mu = 1", "mu");
  refused("name = \"neo_hookean\", energy = \"I1\", mu = 1, kappa = 1", "energy");
}

BOOST_AUTO_TEST_CASE(its_moduli_and_its_stress_at_rest_are_told) {
  auto const told = [](std::string const& energy) {
    std::string all;
    auto const scene =
        Scene::read(SceneFile::parse(text_of(own(energy, "mu = 1, kappa = 2"), disc), "own.toml"));
    for (auto const& one : scene.simulation.remarks) all += one + "\n";
    return all;
  };
  std::string const rubber = "mu/2*(I1 - 2 - 2*log(J)) + kappa/2*(J - 1)^2";
  check_said(told(rubber), "at rest the bulk modulus of the material is 3, its least shear modulus 1");
  BOOST_TEST(told(rubber).find("stress at rest") == std::string::npos);
  check_said(told(rubber + " + 0.1*J"), "the material has a stress at rest, up to 0.1");
}

BOOST_AUTO_TEST_SUITE_END()
