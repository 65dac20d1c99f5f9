// A step of a symmetric flow on its blocks.
#include <boost/test/unit_test.hpp>

#include "actio/skew_matrices/bracket_blocks.hpp"
#include "actio/vorticity/vorticity_step.hpp"
#include "flows.hpp"

using namespace actio;
using namespace actio::sphere;
using testing::random_matrix, testing::random_state, testing::symmetric_state;

namespace {

constexpr Conserved forms[] = {Conserved::lie_poisson, Conserved::energy_casimir, Conserved::all_invariants};

}  // namespace

BOOST_AUTO_TEST_SUITE(step_on_blocks)
BOOST_AUTO_TEST_CASE(a_step_on_blocks_is_the_step) {
  int const n = 22, fold = 4, steps = 10;
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const start = symmetric_state(n, fold);
  TurningFrame const calm = calmest_frame(QuantizedSphere(n), laplacian, start);
  BOOST_TEST(calm.rate != 0);
  for (auto const conserved : forms) {
    SkewHermitian<> whole = start, blocks = start;
    VorticityStep<> step(laplacian, conserved, 0.03, calm);
    VorticityStep<> on_blocks(laplacian, conserved, 0.03, calm, std::make_shared<SymmetricProducts>(fold));
    for (int k = 0; k < steps; ++k) step.advance(whole), on_blocks.advance(blocks);
    BOOST_TEST(norm(whole - start) > 1e-2 * norm(start));
    BOOST_TEST(norm(whole - blocks) <= 1e-14 * steps * norm(start));
    BOOST_TEST(symmetry_of(blocks) == fold);
  }
}

BOOST_AUTO_TEST_SUITE_END()
