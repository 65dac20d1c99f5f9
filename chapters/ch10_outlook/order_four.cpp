// Order 4 for the fluid on the sphere: which weights, which variant, with the projection along the orbit or
// without.
//
// What is shown. Every variant of a step, composed of substeps with the weights b of the triple jump, of
// Suzuki or of McLachlan, is of order 4; each composition conserves what its variant does, and the projection
// along the orbit adds what is left. Each is run with several steps: its error, against order 6 with short
// ones, is set against the products of matrices that it took. Read first. "Order four" of section 10A.4.
//
// Compiled at -O2: it takes many steps.
#include <Eigen/Core>

#include "actio/vorticity/diagonal_runge_kutta.hpp"
#include "actio/vorticity/orbit_projection.hpp"
#include "book/measure.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"
#include "counting_products.hpp"
#include "random_flow.hpp"

using namespace actio;
using namespace actio::sphere;
using Weights = std::vector<double>;
using NamedWeights = std::vector<std::pair<std::string, Weights>>;
using book::measured, book::number;

constexpr int size = 14, seed = 10;
constexpr double duration = 4, accuracy = 1e-8;

// 1. A flow at random: degrees 1 to 6.
SkewHermitian<> flow_at_random() {
  SphereHarmonics f = random_flow(size, 1, 6, seed);
  f.coefficient = f.coefficient / 3.0;
  return matrix_of(f);
}

// 2. A scheme, and its runs: products for a unit of time, the error at the end, the changes of invariants.
struct Scheme {
  std::string name, weights;
  Conserved form;
  Weights b;
  int order;
  bool projected;
  std::vector<double> lengths = {}, work = {}, errors = {};
  double energy = 0, momentum = 0, spectrum = 0;

  SkewHermitian<> run(SphereLaplacian const& laplacian, int steps, TurningFrame const& frame) {
    auto const counted = std::make_shared<CountingProducts>();
    SkewHermitian<> const start = flow_at_random();
    SkewHermitian<> w = start;
    auto const levels = energy_momentum(laplacian, start);
    ComposedVorticityStep<> step(laplacian, form, duration / steps, b, frame, counted);
    OrbitProjection<> projection(laplacian, counted);
    for (int k = 0; k < steps; ++k) {
      step.advance(w);
      if (projected) projection.project(levels, w);
    }
    auto const now = energy_momentum(laplacian, w);
    energy = std::max(energy, std::abs(now.energy / levels.energy - 1));
    momentum = std::max(momentum, (now.momentum - levels.momentum).norm() / levels.momentum.norm());
    auto const moved = (vorticity_values(w) - vorticity_values(start)).lpNorm<Eigen::Infinity>();
    spectrum = std::max(spectrum, moved * std::sqrt(double(size)) / norm(start));
    lengths.push_back(duration / steps), work.push_back(counted->complex_products / duration);
    return w;
  }
  double measured_order() const { return book::exponent(lengths, errors); }
  // Along the line between the two runs around the accuracy.
  double products() const {
    std::size_t k = 1;
    while (k + 1 < errors.size() && errors[k] > accuracy) ++k;
    double const share = std::log(errors[k - 1] / accuracy) / std::log(errors[k - 1] / errors[k]);
    return work[k - 1] * std::pow(work[k] / work[k - 1], share);
  }
};

// 3. The weights and the two constants of their errors, for one step and for the same work.
void show_weights(book::Program& program, NamedWeights const& sets) {
  std::vector<book::Program::Row> rows;
  for (auto const& [name, b] : sets) {
    auto const [fifth, nested] = composition_error(b);
    double const scale = std::pow(double(b.size()), 4), longest = std::abs(b[b.size() / 2]);
    rows.push_back({name, number(double(b.size())), number(longest), number(fifth), number(nested, 2),
                    number(scale * fifth), number(scale * nested, 2)});
  }
  program.table("weights", {"", "s", "longest substep", "e_5", "e_113", "s^4 e_5", "s^4 e_113"}, rows,
                "Constants of the error of compositions of order 4, for a step and for the same work.");
}

// 4. The schemes: single steps, every set of weights, every variant, with the projection and without.
std::vector<Scheme> all_schemes(NamedWeights const& sets) {
  using enum Conserved;
  std::vector<Scheme> schemes{{"all invariants", "one step", all_invariants, {1.0}, 2, false}};
  for (auto const& [name, b] : sets) schemes.push_back({"all invariants", name, all_invariants, b, 4, false});
  for (auto const& [name, form] :
       {std::pair("Lie-Poisson", lie_poisson), {"energy-Casimir", energy_casimir}}) {
    schemes.push_back({name, "Suzuki", form, sets[1].second, 4, false});
    schemes.push_back({name + std::string(", projected"), "Suzuki", form, sets[1].second, 4, true});
  }
  return schemes;
}

// 5. Their runs. A single step is a fifth as long as one of five substeps.
void run_all(std::vector<Scheme>& schemes) {
  SphereLaplacian const laplacian(size);
  auto const frame = calmest_frame(QuantizedSphere(size), laplacian, flow_at_random());
  Scheme reference{"", "", Conserved::lie_poisson, kahan_li<double>(), 6, false};
  auto const truth = reference.run(laplacian, 100, frame);
  for (Scheme& s : schemes)
    for (int const steps : {16, 24, 36, 54})
      s.errors.push_back(norm(s.run(laplacian, steps * (5 / int(s.b.size())), frame) - truth) / norm(truth));
}
void show(book::Program& program, std::vector<Scheme> const& schemes) {
  std::vector<book::Program::Row> rows;
  for (Scheme const& s : schemes)
    rows.push_back({s.name, s.weights, number(s.measured_order()), number(s.products()), number(s.energy, 2),
                    number(s.momentum, 2), number(s.spectrum, 2)});
  program.table("schemes",
                {"variant", "weights", "order", "products", "energy", "angular momentum", "spectrum"}, rows,
                "Order; complex products for a unit of time at an error of " + number(accuracy) +
                    " (extrapolated for single steps); relative changes of the invariants, N = " +
                    std::to_string(size) + ".");
  auto plot = book::Plot("complex products for a unit of time", "error, relative").log_x().log_y();
  for (std::size_t const k : {0, 1, 2, 5})
    plot.curve(schemes[k].work, schemes[k].errors, schemes[k].name + ", " + schemes[k].weights);
  program.picture("work", plot.svg(), "Error against work.");
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "order 4 for the fluid on the sphere, in three variants");
  program.say("a flow at random from seed ", seed);
  NamedWeights const sets{
      {"triple jump", triple_jump<double>()}, {"Suzuki", suzuki<double>()}, {"McLachlan", mclachlan()}};
  show_weights(program, sets);
  auto schemes = all_schemes(sets);
  run_all(schemes);
  show(program, schemes);

  // 6. What must be so: of the orders, of the spectrum, and of energy and angular momentum where they are to
  // be conserved.
  double miss = 0, spectrum = 0, rest = 0;
  for (Scheme const& s : schemes) {
    miss = std::max(miss, std::abs(s.measured_order() - s.order)), spectrum = std::max(spectrum, s.spectrum);
    if (s.projected || s.form == Conserved::all_invariants) rest = std::max({rest, s.energy, s.momentum});
  }
  auto const times = [&](std::size_t k) { return schemes[k].products() / schemes[2].products(); };
  std::string const over = " over those of all invariants, Suzuki";
  program.figure("single", times(0), number(times(0), 2), "products of single steps" + over);
  program.figure("jump", times(1), number(times(1), 2), "products of the triple jump" + over);
  program.figure("detour", times(5), number(times(5), 2), "products of Lie-Poisson, projected," + over);
  program.claim(measured(miss) < 0.1, "every order is what it should be");
  program.claim(measured(std::max(spectrum, rest)) < 1e-12,
                "every scheme conserves the spectrum; all invariants and the projections conserve the rest");
  program.claim(measured(std::min(schemes[4].energy, schemes[6].momentum)) > 1e-12,
                "the other variants give up energy or angular momentum");
  program.claim(measured(std::min({times(1), times(3), times(5)})) > 1,
                "all invariants with Suzuki's weights take the fewest products");
  program.headline("order 4: " + number(times(0), 2) + " times fewer products for eight digits", times(0));
  return program.finish();
}
