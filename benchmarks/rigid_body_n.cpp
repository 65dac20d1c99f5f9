// What a Moser-Veselov step on SO(n) costs, in products of two n by n matrices; and how far a million of them
// drift.
//
// The unit is one dgemm of OpenBLAS on one processor. All steps have |xi|_2 = 1 and Lambda between 1/2 and 2,
// so that the step h is the largest angle turned. The peers solve the same equation as a Riccati equation,
// from scratch, as textbooks do; ours continues from the steps before.
#include <Eigen/Core>

#include <array>
#include <random>

#include "actio/fast_body/any_dimension/moser_veselov_n.hpp"
#include "benchmark.hpp"
#include "peers/riccati.hpp"
#include "timing.hpp"

extern "C" {
void dgemm_(char const* a_transposed, char const* b_transposed, int const* m, int const* n, int const* k,
            double const* alpha, double const* a, int const* lda, double const* b, int const* ldb,
            double const* beta, double* c, int const* ldc);
void openblas_set_num_threads(int);
}

using namespace actio;
using namespace actio::bodies;
using Eigen::MatrixXd;
using Eigen::VectorXd;
constexpr int n_ = Eigen::Dynamic;

struct Task {
  Inertia<n_> inertia;
  Momentum<SO<n_>, double> pi;
};
Task random_task(int n, unsigned seed = 1971) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  VectorXd lambda(n), xi(n * (n - 1) / 2);
  for (auto& l : lambda) l = 1.25 + 0.75 * uniform(random);
  for (auto& x : xi) x = uniform(random);
  auto const inertia = inertia_from_lambda<n_, double>(lambda);
  MatrixXd const turn = inertia.group.hat(xi);
  xi /= std::sqrt(largest_eigenvalue(turn.transpose() * turn));
  return {inertia, body_momentum(inertia, velocity(inertia.group, xi))};
}

/// One dgemm, on columns that are not a power of two apart.
struct Product {
  int n, apart;
  std::vector<double> a, b, c;
  explicit Product(int size)
      : n(size), apart(size >= 32 ? size + 8 : size), a(static_cast<std::size_t>(apart * n)), b(a), c(a) {
    for (std::size_t k = 0; k < a.size(); ++k)
      a[k] = 1e-3 * static_cast<double>(k % 7), b[k] = 1e-3 * static_cast<double>(k % 5);
  }
  void operator()() {
    double const one = 1, zero = 0;
    dgemm_("N", "T", &n, &n, &n, &one, a.data(), &apart, b.data(), &apart, &zero, c.data(), &apart);
  }
};

/// A body in motion under one step, with its count of squares.
struct Runner {
  FastMoserVeselov scheme;
  RotatingBody body;
  double squares = 0, steps = 0;
  Runner(Task const& task, double h, Sweeps sweeps = Sweeps::to_rounding)
      : scheme(task.inertia, h, sweeps), body(scheme.release(task.pi)) {
    for (int k = 0; k < 40; ++k) scheme.step_with_attitude(body);
  }
  void run(double count, bool with_attitude) {
    for (int k = 0; k < count; ++k) {
      with_attitude ? scheme.step_with_attitude(body) : scheme.step(body);
      squares += body.squares(), ++steps;
    }
  }
};

/// Step and product of one size, of the best tenth of the rounds.
struct Cost {
  double product_us, with_us, with, alone, squares;
};
Cost cost_of(benchmark::Benchmark const& program, Task const& task, double h) {
  int const n = task.inertia.group.n;
  Product product(n);
  Runner with(task, h), alone(task, h);
  double const cube = 1.0 * n * n * n, products = std::clamp(2e7 / cube, 1.0, 5000.0),
               steps = std::clamp(5e6 / (cube + 500), 1.0, 3000.0);
  auto const t =
      benchmark::in_turns(program.rounds(n >= 256 ? 11 : 31),
                          {{"product",
                            [&] {
                              for (int k = 0; k < products; ++k) product();
                            },
                            std::ceil(products)},
                           {"with attitude", [&] { with.run(steps, true); }, std::ceil(steps)},
                           {"momentum alone", [&] { alone.run(steps, false); }, std::ceil(steps)}});
  return {1e6 * benchmark::best_tenth(t[0]), 1e6 * benchmark::best_tenth(t[1]),
          benchmark::ratio_of_best(t[1], t[0]), benchmark::ratio_of_best(t[2], t[0]),
          with.squares / with.steps};
}

/// The textbook's solvers against a step of ours, momentum alone, at the same momentum.
struct Peers {
  double schur, newton, ours, schur_difference, newton_difference;
  int iterations;
};
Peers peers_of(Task const& task, double h) {
  Runner runner(task, h);
  auto const pi = runner.body.momentum();
  peers::Riccati const riccati{task.inertia.lambda, task.inertia.group.hat(VectorXd(h / 2 * pi.components))};
  Peers result{};
  MatrixXd const schur = riccati.relative_motion(peers::by_ordered_schur(riccati)),
                 newton = riccati.relative_motion(peers::by_newton_kleinman(riccati, result.iterations));
  runner.scheme.step_with_attitude(runner.body);
  MatrixXd const f = runner.scheme.last_relative_motion(runner.body).value;
  result.schur_difference = (schur - f).norm(), result.newton_difference = (newton - f).norm();

  int const n = task.inertia.group.n, times = std::max(1, 200000 / (n * n * n)),
            steps = std::max(4, 5000000 / (n * n * n));
  Product product(n);
  MatrixXd sink;
  int ignored = 0;
  auto const t = benchmark::in_turns(5, {{"product",
                                          [&] {
                                            for (int k = 0; k < 4 * steps; ++k) product();
                                          },
                                          4.0 * steps},
                                         {"ordered Schur",
                                          [&] {
                                            for (int k = 0; k < times; ++k)
                                              sink = peers::by_ordered_schur(riccati);
                                          },
                                          1.0 * times},
                                         {"Newton-Kleinman",
                                          [&] {
                                            for (int k = 0; k < times; ++k)
                                              sink = peers::by_newton_kleinman(riccati, ignored);
                                          },
                                          1.0 * times},
                                         {"ours", [&] { runner.run(steps, false); }, 1.0 * steps}});
  result.schur = benchmark::ratio_of_best(t[1], t[0]);
  result.newton = benchmark::ratio_of_best(t[2], t[0]);
  result.ours = benchmark::ratio_of_best(t[3], t[0]);
  return result;
}

/// \f$\mathrm{Tr}M^2\f$ and \f$\mathrm{Tr}M^4\f$ in long double, from the momentum and its remainder.
std::array<long double, 2> traces(RotatingBody const& body) {
  using Wide = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  SO<n_> const group{body.size()};
  Wide const m = group.hat(Eigen::Matrix<long double, Eigen::Dynamic, 1>(
      body.momentum().components.cast<long double>() +
      body.momentum_remainder().components.cast<long double>()));
  Wide const square = m * m;
  return {square.trace(), (square * square).trace()};
}
struct Drift {
  double second, fourth, spatial, orthogonality, nanoseconds, squares;
};
std::vector<Drift> drifts(Task const& task, Sweeps sweeps, std::vector<long> const& marks) {
  FastMoserVeselov const scheme(task.inertia, 0.1, sweeps);
  auto body = scheme.release(task.pi);
  auto const before = traces(body);
  auto const spatial = body.spatial_momentum();
  std::vector<Drift> list;
  double squares = 0, began = benchmark::processor_seconds();
  for (long k = 1; k <= marks.back(); ++k) {
    scheme.step_with_attitude(body);
    squares += body.squares();
    if (k != marks[list.size()]) continue;
    auto const now = traces(body);
    auto const g = body.attitude().value;
    double const n = static_cast<double>(k);
    list.push_back({static_cast<double>(now[0] / before[0] - 1), static_cast<double>(now[1] / before[1] - 1),
                    (body.spatial_momentum() - spatial).components.norm() / spatial.components.norm(),
                    (g.transpose() * g - MatrixXd::Identity(g.rows(), g.cols())).norm(),
                    1e9 * (benchmark::processor_seconds() - began) / n, squares / n});
  }
  return list;
}

int main(int argc, char** argv) {
  openblas_set_num_threads(1);
  benchmark::Benchmark program(
      argc, argv, "a step of the generalized rigid body on SO(n), in products of n by n matrices");
  using book::number;
  constexpr double eps = std::numeric_limits<double>::epsilon();

  std::vector<book::Program::Row> rows;
  double with_large = 0, alone_large = 0, with_256 = 0, us_8 = 0, ns_4 = 0;
  for (int n : {4, 8, 16, 32, 64, 128, 256, 512}) {
    // Of the largest bodies alone the steps before the clock take seconds.
    if (program.is_short() && n > 256) continue;
    auto const task = random_task(n);
    Cost const slow = cost_of(program, task, 0.01), fast = cost_of(program, task, 0.1);
    rows.push_back({std::to_string(n), number(slow.product_us), number(slow.with_us), number(slow.with),
                    number(slow.alone), number(slow.squares), number(fast.with), number(fast.alone),
                    number(fast.squares)});
    if (n >= 128)
      with_large = std::max(with_large, slow.with), alone_large = std::max(alone_large, slow.alone);
    if (n == 256) with_256 = fast.with;
    if (n == 8) us_8 = slow.with_us;
    if (n == 4) ns_4 = 1e3 * slow.with_us;
  }
  program.table("cost",
                {"n", "product, us", "h=0.01: step, us", "with attitude", "momentum", "squares",
                 "h=0.1: with attitude", "momentum", "squares"},
                rows);
  program.figure("with_attitude", with_large,
                 "largest cost of a step with attitude at h = 0.01 and n >= 128, in products");
  program.figure("momentum_alone", alone_large, "largest cost of a step of the momentum alone, same");
  program.claim_of_time(with_large <= 2.2,
                        "for n >= 128 a step with attitude costs at most 2.2 products at h = 0.01");
  program.claim_of_time(alone_large <= 1.2, "and the momentum alone at most 1.2");
  program.claim_of_time(with_256 <= 3,
                        "at h = 0.1 and n = 256 a step with attitude costs at most 3 products");
  program.claim_of_time(us_8 <= 0.6, "for n = 8 it takes at most 0.6 microseconds");
  program.figure("n8", us_8, "microseconds of a step with attitude, n = 8, h = 0.01");
  program.figure("n4", ns_4, "nanoseconds of the same for n = 4");

  rows.clear();
  bool agree = true;
  double least = HUGE_VAL;
  for (int n : {4, 8, 16, 32, 64}) {
    Peers const p = peers_of(random_task(n), 0.1);
    rows.push_back({std::to_string(n), number(p.ours), number(p.schur), number(p.newton),
                    std::to_string(p.iterations), number(p.schur_difference), number(p.newton_difference)});
    // A thousand roundings of n entries for the condition of an invariant subspace.
    agree = agree && p.schur_difference <= 1e3 * n * eps && p.newton_difference <= 1e3 * n * eps;
    least = std::min({least, p.schur / p.ours, p.newton / p.ours});
  }
  program.table("peers",
                {"n", "step, momentum", "ordered Schur, 2n", "Newton-Kleinman", "its iterations",
                 "Schur: difference of f", "Newton: difference of f"},
                rows);
  program.claim(agree, "the solvers of the Riccati equation find the same relative motion");
  program.figure("gain", least, "how many times cheaper a step is than the cheaper of the two, least over n");
  program.claim_of_time(least >= 10, "a step by squares costs less than a tenth of either");

  rows.clear();
  auto const eight = random_task(8);
  std::vector<long> const marks{1000, 10000, 100000, 1000000};
  auto const rounded = drifts(eight, Sweeps::to_rounding, marks),
             beyond = drifts(eight, Sweeps::beyond_rounding, marks);
  for (std::size_t k = 0; k < marks.size(); ++k)
    for (auto const& [name, d] :
         {std::pair{"to rounding", rounded[k]}, std::pair{"beyond rounding", beyond[k]}})
      rows.push_back({number(static_cast<double>(marks[k])), name, number(d.second, 2), number(d.fourth, 2),
                      number(d.spatial, 2), number(d.orthogonality, 2), number(d.squares),
                      number(d.nanoseconds)});
  program.table(
      "drift",
      {"steps", "sweeps", "Tr M^2", "Tr M^4", "momentum in space", "attitude", "squares", "ns a step"}, rows);
  double const walk = 0.1 * eps * std::sqrt(1e6 / 28);
  program.figure("drift", std::abs(beyond.back().second),
                 "relative change of Tr M^2 in 1e6 steps of 0.1 rad, n = 8");
  program.claim(std::abs(beyond.back().second) <= walk,
                "after 1e6 steps the trace of M^2 has moved by no more than a random walk of "
                "roundings of the relative motion");
  program.headline("a step on SO(n), n >= 128, costs " + number(with_large) + " products with attitude, " +
                       number(alone_large) + " without",
                   with_large);
  return program.finish();
}
