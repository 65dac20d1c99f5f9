// What a step of an incompressible fluid on a box costs: nanoseconds for an unknown, of which a cell has three,
// two coordinates and a pressure; by multigrid and by Cholesky factors, in the same rounds.
#include "actio/incompressible_media/incompressible_medium.hpp"
#include "benchmark.hpp"
#include "timing.hpp"

using namespace actio;
using namespace actio::media;
using book::number;

namespace {

/// A block of fluid that is sheared and stretched.
IncompressibleMedium<2> block(int n, PressureBy by) {
  IncompressibleStart<2> start;
  start.velocity = [](auto const& X) {
    return std::array{0.5 * X[0] - 0.6 * X[1] + 0.3 * std::sin(3 * X[1]), 0.8 * X[0] - 0.5 * X[1]};
  };
  start.project = true;
  VolumeSolving solving;
  solving.by = by;
  return {box_mesh({-1, -1}, {1, 1}, {n, n}), {}, start, 0.2 / n, {}, {}, solving};
}

}  // namespace

int main(int argc, char** argv) {
  return 0;
}
