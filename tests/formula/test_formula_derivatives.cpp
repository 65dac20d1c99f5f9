// Gradients and Hessians of formulas against the dual numbers of the library, against closed forms, and
// exactly over the rationals.
#include <cmath>
#include <functional>
#include <random>

#include <boost/test/unit_test.hpp>

#include "actio/formula/parse_formula.hpp"
#include "actio/formula/tape_derivatives.hpp"
#include "actio/numbers/derivative.hpp"
#include "refused.hpp"
#include "witness/number.hpp"

using namespace actio;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
std::vector<std::string> const names{"x", "y", "z"};
template <class S>
using Triple = Matrix<S, 3, 1>;

template <class S>
std::vector<S> values(Tape const& tape, Triple<S> const& x) {
  std::vector<S> work, y(static_cast<std::size_t>(tape.size()));
  tape(x.data(), y.data(), work);
  return y;
}

/// Value, gradient and upper triangle of the Hessian of a callable, by dual numbers.
template <class F, class S>
std::vector<S> by_dual_numbers(F const& f, Triple<S> const& x) {
  auto const gradient = [&](auto const& at) { return derivative(f, at).gradient(); };
  auto const second = derivative(gradient, x);
  std::vector<S> all{f(x)};
  for (int i = 0; i < 3; ++i) all.push_back(second.value[i]);
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) all.push_back(second.matrix(i, j));
  return all;
}

struct Quotient {
  static constexpr char const* text = "(x^3 - 0.1*y)/(z^2 + 1) + x^-2*y^4 - c*x*y*z";
  template <class T>
  T operator()(Triple<T> const& p) const {
    T const &x = p[0], &y = p[1], &z = p[2];
    return (x * x * x - y / 10) / (z * z + 1) + y * y * y * y / (x * x) - x * y * z * 13 / 4;
  }
};

/// What a Lagrangian of a top in a field may look like.
struct Transcendental {
  static constexpr char const* text =
      "r = sqrt(x^2 + y^2 + 1); u = exp(-r/2)*sin(x*y); u + log(r + z^2)*cos(z) + atan2(y, x)/r + "
      "r^-1.5 + (x^2 + 1)^y + hypot(x, z)";
  template <class T>
  T operator()(Triple<T> const& p) const {
    using std::sqrt, std::exp, std::sin, std::cos, std::log, std::atan2, std::pow;
    T const &x = p[0], &y = p[1], &z = p[2];
    T const r = sqrt(T(x * x + y * y + 1)), u = exp(T(-r / 2)) * sin(T(x * y));
    return u + log(T(r + z * z)) * cos(z) + atan2(y, x) / r + pow(r, -1.5) + exp(T(y * log(T(x * x + 1)))) +
           sqrt(T(x * x + z * z));
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(formula_derivatives)

BOOST_AUTO_TEST_CASE(a_rational_function_has_exact_derivatives) {
  WithArithmetic const exactly(Arithmetic::rationals());
  Tape const f = parse_formula(Quotient::text, names, {{"c", 3.25}});
  Triple<Number> const x(Number(2) / 3, Number(-5) / 7, Number(11) / 13);
  auto const expected = by_dual_numbers(Quotient{}, x);
  auto const hessian = values(with_hessian(f, {0, 1, 2}), x),
             gradient = values(with_gradient(f, {0, 1, 2}), x);
  BOOST_TEST((hessian == expected));
  BOOST_TEST((gradient == std::vector<Number>(expected.begin(), expected.begin() + 4)));
  // The tape on dual numbers has the same derivatives.
  auto const on_tape = [&](auto const& at) { return values(f, at).at(0); };
  BOOST_TEST((by_dual_numbers(on_tape, x) == expected));
}

BOOST_AUTO_TEST_CASE(a_formula_with_functions_has_the_derivatives_of_dual_numbers) {
  Tape const f = parse_formula(Transcendental::text, names);
  Tape const hessian = with_hessian(f, {0, 1, 2});
  auto const on_tape = [&](auto const& at) { return values(f, at).at(0); };
  std::mt19937_64 random(1971);
  std::uniform_real_distribution<double> uniform(-1.5, 1.5);
  for (int k = 0; k < 40; ++k) {
    Triple<double> const x(uniform(random), uniform(random), uniform(random));
    auto const expected = by_dual_numbers(Transcendental{}, x);
    auto const tape = values(hessian, x), dual = by_dual_numbers(on_tape, x);
    // Near x = y = 0 the angle's second derivatives are large; each term is rounded relative to the largest.
    double scale = 1;
    for (double e : expected) scale = std::max(scale, std::abs(e));
    for (std::size_t i = 0; i < expected.size(); ++i) {
      BOOST_TEST(std::abs(tape[i] - expected[i]) <= 64 * eps * scale);
      BOOST_TEST(std::abs(dual[i] - expected[i]) <= 64 * eps * scale);
    }
  }
}

BOOST_AUTO_TEST_CASE(functions_have_their_derivatives_in_closed_form) {
  using F = std::function<double(double)>;
  struct Function {
    std::string name;
    F first, second;
    double at;
  };
  double const l2 = std::log(2.), l10 = std::log(10.);
  std::vector<Function> const functions{
      {"tan", [](double x) { return std::pow(std::cos(x), -2); },
       [](double x) { return 2 * std::sin(x) * std::pow(std::cos(x), -3); }, 0.7},
      {"asin", [](double x) { return 1 / std::sqrt(1 - x * x); },
       [](double x) { return x * std::pow(1 - x * x, -1.5); }, -0.6},
      {"acos", [](double x) { return -1 / std::sqrt(1 - x * x); },
       [](double x) { return -x * std::pow(1 - x * x, -1.5); }, 0.3},
      {"atan", [](double x) { return 1 / (1 + x * x); },
       [](double x) { return -2 * x * std::pow(1 + x * x, -2); }, 1.9},
      {"sinh", [](double x) { return std::cosh(x); }, [](double x) { return std::sinh(x); }, -0.8},
      {"cosh", [](double x) { return std::sinh(x); }, [](double x) { return std::cosh(x); }, -0.8},
      {"tanh", [](double x) { return std::pow(std::cosh(x), -2); },
       [](double x) { return -2 * std::sinh(x) * std::pow(std::cosh(x), -3); }, 0.4},
      {"asinh", [](double x) { return 1 / std::sqrt(1 + x * x); },
       [](double x) { return -x * std::pow(1 + x * x, -1.5); }, -2.2},
      {"acosh", [](double x) { return 1 / std::sqrt(x * x - 1); },
       [](double x) { return -x * std::pow(x * x - 1, -1.5); }, 1.6},
      {"atanh", [](double x) { return 1 / (1 - x * x); },
       [](double x) { return 2 * x * std::pow(1 - x * x, -2); }, -0.5},
      {"log2", [=](double x) { return 1 / (x * l2); }, [=](double x) { return -1 / (x * x * l2); }, 3},
      {"log10", [=](double x) { return 1 / (x * l10); }, [=](double x) { return -1 / (x * x * l10); }, 3},
      {"cbrt", [](double x) { return std::pow(x, -2. / 3) / 3; },
       [](double x) { return -2 * std::pow(x, -5. / 3) / 9; }, 2.1},
      {"sqrt", [](double x) { return 0.5 / std::sqrt(x); },
       [](double x) { return -0.25 * std::pow(x, -1.5); }, 2.1},
      {"exp", [](double x) { return std::exp(x); }, [](double x) { return std::exp(x); }, -1.3},
      {"log", [](double x) { return 1 / x; }, [](double x) { return -1 / (x * x); }, 0.3},
      {"sin", [](double x) { return std::cos(x); }, [](double x) { return -std::sin(x); }, 2.4},
      {"cos", [](double x) { return -std::sin(x); }, [](double x) { return -std::cos(x); }, 2.4},
  };
  for (auto const& f : functions) {
    Tape const tape = parse_formula(f.name + "(x)", names);
    Triple<double> const x(f.at, 0, 0);
    auto const all = values(with_hessian(tape, {0}), x);
    auto const dual = by_dual_numbers([&](auto const& at) { return values(tape, at).at(0); }, x);
    BOOST_TEST_CONTEXT(f.name) {
      for (auto const& [first, second] : {std::pair(all[1], all[2]), std::pair(dual[1], dual[4])}) {
        BOOST_TEST(first == f.first(f.at), boost::test_tools::tolerance(16 * eps));
        BOOST_TEST(second == f.second(f.at), boost::test_tools::tolerance(32 * eps));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_second_derivatives_of_a_quadratic_form_are_constants) {
  WithArithmetic const exactly(Arithmetic::rationals());
  Tape const f = parse_formula("(a*x^2 + 0.3*(y - z)^2)/2 + 7*x*(2*y + z)/3 - (x + y)*(x - y) + 5*x - 1",
                               names, {{"a", 6}});
  Tape const hessian = with_hessian(f, {0, 1, 2});
  std::vector<Number> const expected{
      4, Number(14) / 3, Number(7) / 3, Number(23) / 10, Number(-3) / 10, Number(3) / 10};
  auto const at_zero = values(hessian, Triple<Number>(0, 0, 0));
  for (int k = 0; k < 6; ++k) {
    BOOST_TEST(hessian.is_constant(4 + k));
    BOOST_TEST((at_zero[static_cast<std::size_t>(4 + k)] == expected[static_cast<std::size_t>(k)]));
  }
  // So they cost no instruction beyond the gradient's.
  BOOST_TEST(hessian.instructions.size() == with_gradient(f, {0, 1, 2}).instructions.size());
}

BOOST_AUTO_TEST_CASE(inputs_that_are_not_asked_for_are_held_fixed) {
  Tape const f = parse_formula("x^2*y + sin(z)*x", names);
  Triple<double> const x(2, 3, 0.5);
  auto const some = values(with_hessian(f, {2, 0}), x);
  std::vector<double> const expected{12 + 2 * std::sin(0.5), 2 * std::cos(0.5), 12 + std::sin(0.5),
                                     -2 * std::sin(0.5),     std::cos(0.5),     6};
  BOOST_TEST(some == expected, boost::test_tools::per_element());
  BOOST_TEST(with_gradient(f, {}).size() == 1);
  CHECK_REFUSED(with_gradient(f, {3}), OutsideDomain);
  CHECK_REFUSED(with_gradient(f, {-1}), OutsideDomain);
  // Of an input itself, of a constant, and of a tape of derivatives.
  BOOST_TEST((values(with_hessian(parse_formula("z", names), {2}), x) == std::vector<double>{0.5, 1, 0}));
  BOOST_TEST((values(with_gradient(parse_formula("2^0.5", names), {0}), x) ==
              std::vector<double>{std::sqrt(2.), 0}));
  BOOST_TEST((values(with_gradient(with_gradient(parse_formula("x^2", names), {0}), {0}), x) ==
              std::vector<double>{4, 4}));
}

BOOST_AUTO_TEST_CASE(a_small_number_keeps_its_value_in_the_derivative) {
  // Over double 10^310 is infinite on the way.
  auto const y = values(with_gradient(parse_formula("1e-310*x", names), {0}), Triple<double>(2, 0, 0));
  BOOST_TEST(y[1] == 1e-310);
}

BOOST_AUTO_TEST_SUITE_END()
