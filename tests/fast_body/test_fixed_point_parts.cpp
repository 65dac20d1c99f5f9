// What an iteration on SO(n) is made of: when it ends, what it extrapolates from past steps, and how it is
// accelerated. Each against its definition.
#include <boost/test/unit_test.hpp>

#include <random>

#include "actio/fast_body/any_dimension/anderson.hpp"
#include "actio/fast_body/any_dimension/stopping_rule.hpp"

using namespace actio;
using namespace actio::bodies;
using bodies::detail::Defect, bodies::detail::StoppingRule, bodies::detail::Weights;

namespace {

using Long = long double;
constexpr Long eps = std::numeric_limits<double>::epsilon();

/// The rule in norms, where the library has squares of norms: |ee^T - G|, |ee^T| and |e|.
struct Norms {
  Sweeps sweeps;
  Long sigma;
  bool any_negative;
  Long change, square, motion;

  /// Bound on the factor of a sweep, with |e|^2 at most |ee^T|.
  Long contraction() const { return std::sqrt(2 * square) * sigma; }
  /// Half of what rounding e makes of the defect, and of what rounding its square does.
  Long allowed() const { return std::hypot(eps * motion / 2, eps * motion * motion / 2); }
  static Long after_one_more(Long defect, Long q) { return q < 0.5L ? q * defect : defect; }
  bool at_rounding(Long before, Long factor = 1) const {
    Long const q = before < HUGE_VALL ? std::min(contraction(), 2 * change / before) : contraction();
    return after_one_more(change, q) <= factor * allowed();
  }
  bool done(Long before) const {
    bool const stalls = change > before / 2;
    switch (sweeps) {
      case Sweeps::to_half_the_digits:
        if (change <= 1e-8L * square) return true;
        [[fallthrough]];
      case Sweeps::to_rounding:
        return at_rounding(before) || (stalls && at_rounding(before, 16));
      default:
        return change <= eps * square || (stalls && at_rounding(before));
    }
  }
  bool on_branch() const { return any_negative ? contraction() < 0.5L : square < 2; }
  int squares_needed(Long error, Long q, Long amplification) const {
    int count = 1;
    for (Long left = q; count < 9; ++count, error *= q, left *= q) {
      Long const next = after_one_more(error, count > 1 ? std::min(contraction(), 2 * q) : contraction());
      bool const enough = sweeps == Sweeps::to_rounding          ? 4 * next <= allowed()
                          : sweeps == Sweeps::to_half_the_digits ? 4 * error <= 1e-8L * square
                                                                 : 4 * error <= eps * square;
      if (enough && amplification * left <= 0.5L) break;
    }
    return sweeps == Sweeps::beyond_rounding ? count + 1 : count;
  }
};

/// The next argument by the normal equations, from the last steps and changes of the residual, oldest first.
std::vector<double> accelerated(std::vector<double> const& x, std::vector<double> const& residual,
                                std::vector<std::vector<double>> const& steps,
                                std::vector<std::vector<double>> const& changes) {
  std::size_t const m = steps.size(), n = x.size();
  std::vector<std::vector<Long>> a(m, std::vector<Long>(m + 1, 0));
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t j = 0; j < m; ++j) a[i][j] += static_cast<Long>(changes[i][k]) * changes[j][k];
      a[i][m] += static_cast<Long>(changes[i][k]) * residual[k];
    }
  for (std::size_t p = 0; p < m; ++p)
    for (std::size_t i = 0; i < m; ++i)
      if (i != p)
        for (std::size_t j = m + 1; j-- > p;) a[i][j] -= a[p][j] * (a[i][p] / a[p][p]);
  std::vector<double> next(n);
  for (std::size_t k = 0; k < n; ++k) {
    Long sum = x[k] + static_cast<Long>(residual[k]) / 2;
    for (std::size_t i = 0; i < m; ++i) sum -= a[i][m] / a[i][i] * (steps[i][k] + Long(changes[i][k]) / 2);
    next[k] = static_cast<double>(sum);
  }
  return next;
}

/// Arguments and residuals as they come: each next argument held to the normal equations with the last
/// `counted` changes.
void mixes_as_the_normal_equations(std::size_t n, int memory, std::size_t counted) {
  std::mt19937 random(static_cast<unsigned>(n));
  std::uniform_real_distribution<double> uniform(-1, 1);
  Anderson anderson(memory);
  std::vector<double> x(n), residual(n), old_x, old_residual;
  for (double& v : x) v = uniform(random);
  std::vector<std::vector<double>> steps, changes;
  for (int round = 0; round < 8; ++round) {
    for (double& r : residual) r = uniform(random);
    if (round > 0) {
      steps.push_back(x), changes.push_back(residual);
      for (std::size_t k = 0; k < n; ++k) steps.back()[k] -= old_x[k], changes.back()[k] -= old_residual[k];
      if (steps.size() > counted) steps.erase(steps.begin()), changes.erase(changes.begin());
    }
    old_x = x, old_residual = residual;
    auto const expected = accelerated(x, residual, steps, changes);
    anderson.mix(x, residual);
    for (std::size_t k = 0; k < n; ++k)
      BOOST_TEST(std::abs(x[k] - expected[k]) <= 1e-9 * (1 + std::abs(expected[k])),
                 "dimension " << n << ", round " << round << ": " << x[k] << " and " << expected[k]);
    // Next time from somewhere near.
    for (double& v : x) v = uniform(random);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(fixed_point_parts)

BOOST_AUTO_TEST_CASE(the_rule_in_squares_of_norms_is_the_rule_in_norms) {
  std::mt19937_64 random(1971);
  auto const between = [&](double a, double b) { return a + (b - a) * (random() >> 11) * 0x1p-53; };
  auto const decades = [&](double a, double b) { return std::pow(10.0, between(a, b)); };
  int ended[3][2] = {}, branch[2][2] = {}, needed[3][12] = {};
  for (int trial = 0; trial < 30000; ++trial) {
    auto const sweeps = static_cast<Sweeps>(trial % 3);
    Norms n{sweeps, std::sqrt(between(0.5, 1.5)), trial % 2 == 1, 0, decades(-14, 1), 0};
    n.motion = std::sqrt(n.square * between(1, 3));
    // About the bounds of this rule, and far from them.
    n.change = (trial % 4 == 0   ? 1e-8L * n.square
                : trial % 4 == 1 ? eps * n.square
                                 : n.allowed()) *
               decades(-2, 3);
    Long const before = trial % 5 == 0 ? HUGE_VALL : n.change * decades(-1, 4);
    StoppingRule const rule{sweeps, static_cast<double>(n.sigma * n.sigma), n.any_negative};
    Defect const d{static_cast<double>(n.change * n.change), static_cast<double>(n.square * n.square),
                   static_cast<double>(n.motion * n.motion)};
    double const before2 = static_cast<double>(before * before);
    BOOST_TEST(rule.at_rounding(d, before2) == n.at_rounding(before));
    BOOST_TEST(rule.at_rounding(d, before2, 16) == n.at_rounding(before, 16));
    BOOST_TEST(rule.done(d, before2) == n.done(before));
    BOOST_TEST(rule.on_branch_of_identity(d) == n.on_branch());
    Long const q = decades(-4, 0.2), error = n.allowed() * decades(-3, 8), amplification = decades(0, 4);
    int const count = n.squares_needed(error, q, amplification);
    BOOST_TEST(rule.squares_needed(static_cast<double>(error * error), d, static_cast<double>(q * q),
                                   static_cast<double>(amplification)) == count);
    ++ended[trial % 3][n.done(before)], ++branch[n.any_negative][n.on_branch()], ++needed[trial % 3][count];
  }
  // Every answer was given.
  for (auto const& of : ended) BOOST_TEST((of[0] > 100 && of[1] > 100));
  for (auto const& of : branch) BOOST_TEST((of[0] > 100 && of[1] > 100));
  for (int count = 1; count <= 9; ++count) BOOST_TEST((needed[0][count] > 0 && needed[1][count + 1] > 0));
}

BOOST_AUTO_TEST_CASE(a_change_that_equals_what_is_allowed_is_allowed) {
  // Powers of two, of which nothing is rounded: |ee^T| = 2^-20, and a change of eps times that.
  StoppingRule const beyond{Sweeps::beyond_rounding, 0.5, false};
  double const square = 0x1p-40, at_bound = 0x1p-104 * square;
  BOOST_TEST(beyond.done({at_bound, square, 0x1p-20}, HUGE_VAL));
  BOOST_TEST(!beyond.done({2 * at_bound, square, 0x1p-20}, HUGE_VAL));
  // A contraction by 2^-10 of the norm, and a defect that is half of eps (|e|^2 + |e|^4)^(1/2) after it.
  StoppingRule const rule{Sweeps::to_rounding, 0.5, false};
  double const allowed = 0x1p-104 * 0x1p-20 * (1 + 0x1p-20) / 4;
  BOOST_TEST(rule.at_rounding({allowed * 0x1p20, square, 0x1p-20}, HUGE_VAL));
  BOOST_TEST(!rule.at_rounding({allowed * 0x1.01p20, square, 0x1p-20}, HUGE_VAL));
  // Where a sweep need not contract, at a factor of a half, the defect itself counts; and there, or where
  // |ee^T| is 2, no solution is sure to be the one of the identity.
  double const next_to_two = 0x1p-104 * 0x1p-2 * (1 + 0x1p-2) / 4;
  BOOST_TEST(!rule.at_rounding({2 * next_to_two, 0x1p-4, 0x1p-2}, HUGE_VAL));
  BOOST_TEST(rule.at_rounding({next_to_two, 0x1p-4, 0x1p-2}, HUGE_VAL));
  BOOST_TEST((!rule.on_branch_of_identity({0, 4, 0}) && rule.on_branch_of_identity({0, 3.99, 0})));
  StoppingRule const negative{Sweeps::to_rounding, 0.5, true};
  BOOST_TEST(
      (!negative.on_branch_of_identity({0, 0x1p-4, 0}) && negative.on_branch_of_identity({0, 0x1p-5, 0})));
}

BOOST_AUTO_TEST_CASE(extrapolations_are_exact_for_polynomials_and_no_weights_are_smaller) {
  int expected_length = 0, count = 0;
  for (Weights const& w : bodies::detail::all_extrapolations()) {
    int const p = w.degree, m = w.length;
    ++count;
    BOOST_TEST(m >= expected_length);
    expected_length = m;
    BOOST_TEST((1 <= p && p <= 12 && (m == p || m == p + 2 || m == p + 4) && m <= Weights::longest));
    // The terms are at 0, -1, -2, ..., and the next one at 1.
    for (int power = 0; power < p; ++power) {
      Long sum = 0, size = 0;
      for (int a = 0; a < m; ++a) {
        Long const term = w.weight[static_cast<std::size_t>(a)] * std::pow(-static_cast<Long>(a), power);
        sum += term, size += std::abs(term);
      }
      BOOST_TEST(static_cast<double>(std::abs(sum - 1)) <= static_cast<double>(eps * size),
                 "degree " << p << ", " << m << " terms, power " << power);
    }
    // Weights of least length are values of a polynomial of degree p-1: their differences of order p vanish.
    for (int first = 0; first + p < m; ++first) {
      Long difference = 0, size = 0, binomial = 1;
      for (int j = 0; j <= p; binomial = binomial * (p - j) / (j + 1), ++j) {
        Long const term = (j % 2 ? -binomial : binomial) * w.weight[static_cast<std::size_t>(first + j)];
        difference += term, size += std::abs(term);
      }
      BOOST_TEST(static_cast<double>(std::abs(difference)) <= static_cast<double>(eps * size));
    }
    Long squares = 0;
    for (Long const x : w.weight) squares += x * x;
    BOOST_TEST(std::abs(w.amplification / static_cast<double>(std::sqrt(squares)) - 1) <= 8 * eps);
    for (int a = m; a < Weights::longest; ++a) BOOST_TEST(w.weight[static_cast<std::size_t>(a)] == 0);
  }
  // Three for each degree up to 12.
  BOOST_TEST(count == 36);
}

BOOST_AUTO_TEST_CASE(an_accelerated_argument_is_that_of_the_normal_equations) {
  mixes_as_the_normal_equations(7, 3, 3);
  mixes_as_the_normal_equations(5, 1, 1);
  mixes_as_the_normal_equations(9, 20, 20);
  // In two dimensions the two newest changes span everything: older ones are left out.
  mixes_as_the_normal_equations(2, 5, 2);
}

BOOST_AUTO_TEST_SUITE_END()
