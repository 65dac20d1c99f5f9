// Bodies in many dimensions: a step for the price of one square of a matrix, and where a drift comes from.
//
// What is shown. The fixed point of section 5B.5 is the scheme that Newton's method
// solves, to rounding, and a short step takes one square. Over a million steps the momentum's Casimir Tr M^2
// walks by rounding at random if each step is solved beyond rounding, and in proportion to the time if it is
// solved to rounding only: what an iteration leaves out is no noise. Read first. Section 5B.5,
// bodies_of_any_size.
//
//   n        dimensions                     f   relative motion of a step
//   Lambda   second moments, random         M   body momentum, with an angular velocity of norm 1
//
// Compiled at -O2: it takes many steps.
#include <random>

#include <Eigen/Eigenvalues>

#include "actio/fast_body/any_dimension/moser_veselov_n.hpp"
#include "book/measure.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"

using namespace actio;
using namespace actio::bodies;

unsigned const seed = 5;

struct LargeBody {
  Inertia<Dynamic> inertia;
  Momentum<SO<Dynamic>, double> momentum;
};
// Lambda between 1/2 and 2, an angular velocity of norm 1.
LargeBody random_body(int n) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> between(0.5, 2.0);
  std::normal_distribution<double> normal;
  Vector<double> lambda(n), xi(n * (n - 1) / 2);
  for (auto& l : lambda) l = between(random);
  for (auto& c : xi) c = normal(random);
  SO<Dynamic> const group{n};
  xi /= Eigen::MatrixXd(group.hat(xi)).operatorNorm();
  auto const inertia = inertia_from_lambda<Dynamic, double>(lambda);
  return {inertia, body_momentum(inertia, Velocity<SO<Dynamic>, double>{group, xi})};
}

// 1. The scheme is the same as the general solver's, and takes a few squares, which a table counts. The
//    result is the largest difference from the general solver's relative motion, over the angle of the step.
double compare_with_general_solver(book::Program& program) {
  std::vector<book::Program::Row> rows;
  double worst = 0;
  for (int const n : {3, 4, 5, 8, 12, 16, 64, 128}) {
    auto const [inertia, momentum] = random_body(n);
    std::vector<std::string> row{book::number(n)};
    for (double const h : {0.01, 0.1}) {
      FastMoserVeselov const fast(inertia, h);
      auto body = fast.release(momentum);
      long squares = 0;
      int const steps = 40;
      for (int k = 0; k < steps; ++k) {
        fast.step_with_attitude(body);
        if (k >= steps / 2) squares += body.squares();
      }
      row.push_back(book::number(squares / (steps / 2.0)));
      if (n > 16) continue;
      MoserVeselov<Dynamic> const general(inertia, h);
      auto const before = body.momentum();
      auto const solved = general.relative_motion(before).value;
      fast.step(body);
      worst = std::max(
          worst, (fast.last_relative_motion(body).value - solved.value).norm() / (h * std::sqrt(double(n))));
    }
    rows.push_back(row);
  }
  program.table("squares", {"n", "h = 0.01", "h = 0.1"}, rows,
                "Squares of a matrix that a step takes, the angular velocity having the norm 1.");
  return worst;
}

// 2. The relative change of Tr M^2 comes from the momentum and what rounding has left over of it.
double casimir_change(RotatingBody const& body, Vector<double> const& start) {
  auto const m = body.momentum().components, rest = body.momentum_remainder().components;
  long double now = 0, before = 0;
  for (Index a = 0; a < m.size(); ++a) {
    long double const c = static_cast<long double>(m[a]) + rest[a], s = start[a];
    now += c * c, before += s * s;
  }
  return static_cast<double>(now / before - 1);
}

// 3. A million steps in eight dimensions show the largest change so far.
struct Drift {
  double largest = 0;
  std::vector<double> steps, change;
};
Drift million_steps(Sweeps sweeps) {
  auto const [inertia, momentum] = random_body(8);
  FastMoserVeselov const scheme(inertia, 0.1, sweeps);
  auto body = scheme.release(momentum);
  Drift drift;
  for (long k = 1, next = 100; k <= 1000000; ++k) {
    scheme.step(body);
    drift.largest =
        std::max(drift.largest, k % 100 ? 0 : std::abs(casimir_change(body, momentum.components)));
    if (k < next) continue;
    drift.steps.push_back(double(k)), drift.change.push_back(std::max(drift.largest, 1e-18));
    next = next * 4 / 3;
  }
  return drift;
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "bodies in many dimensions: one square of a matrix a step, and no drift");
  program.say("random bodies from seed ", seed);
  double const worst = compare_with_general_solver(program);
  program.figure("apart", worst,
                 "largest difference from the general solver's relative motion, over the angle of the step");
  Drift const rounding = million_steps(Sweeps::to_rounding), beyond = million_steps(Sweeps::beyond_rounding);
  auto plot = book::Plot("steps", "change of Tr M^2").log_x().log_y();
  plot.curve(rounding.steps, rounding.change, "each step solved to rounding")
      .curve(beyond.steps, beyond.change, "beyond rounding");
  program.figure("drift_to_rounding", rounding.largest, "largest change, each step solved to rounding");
  program.figure("drift", beyond.largest, "largest change, solved beyond rounding");
  program.picture("drift", plot.svg(), "Largest relative change of Tr M^2 so far, n = 8, steps of 0.1.");

  // 4. What must be so. The bounds are a hundred roundings.
  double const eps = std::numeric_limits<double>::epsilon();
  program.claim(book::measured(worst) < 100 * eps,
                "both implementations have the same relative motion, to a hundred epsilon of the angle");
  program.claim(book::measured(beyond.largest) < 100 * eps,
                "a million steps change Tr M^2 by less than a hundred epsilon");
  program.headline("Tr M^2 conserved to " + book::number(beyond.largest, 2) + " over a million steps",
                   beyond.largest);
  return program.finish();
}
