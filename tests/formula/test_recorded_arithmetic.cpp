// What a tape makes of random arithmetic, its simplifications and its derivatives, exactly over the
// rationals; and how many instructions are left of what can be simplified.
#include <random>

#include <boost/test/unit_test.hpp>

#include "actio/formula/parse_formula.hpp"
#include "actio/formula/tape_derivatives.hpp"
#include "actio/formula/term.hpp"
#include "actio/numbers/derivative.hpp"
#include "actio/numbers/taylor.hpp"
#include "witness/number.hpp"

using namespace actio;

namespace {

using Q = Number;
constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr int inputs = 3;

template <class S>
std::vector<S> values(Tape const& tape, S const* x) {
  std::vector<S> work, y(static_cast<std::size_t>(tape.size()));
  tape(x, y.data(), work);
  return y;
}
/// A random program: each line joins two lines before it, or changes one.
struct Program {
  struct Line {
    int what;
    std::size_t a, b;
    int n;
  };
  std::vector<Line> lines;

  explicit Program(std::mt19937_64& random) {
    for (std::size_t k = 0; k < 12; ++k)
      lines.push_back(
          {int(random() % 12), random() % (inputs + k), random() % (inputs + k), int(random() % 7) - 3});
  }
  /// All lines, over numbers or terms.
  template <class T>
  std::vector<T> run(std::vector<T> all) const {
    for (Line const& l : lines) {
      T const a = all[l.a], b = all[l.b];
      switch (l.what) {
        case 0:
        case 1:
          all.push_back(a + b);
          break;
        case 2:
        case 3:
          all.push_back(a - b);
          break;
        case 4:
          all.push_back(a * b);
          break;
        case 5:
          all.push_back(a / (b * b + 2));
          break;
        case 6:
          all.push_back(-a);
          break;
        case 7:
          all.push_back(a * l.n);
          break;
        case 8:
          all.push_back(l.n / (a * a + 1));
          break;
        case 9:
          all.push_back(a / 3 + l.n);
          break;
        case 10:
          all.push_back(l.n - a);
          break;
        default:
          all.push_back(1 / (b * b * 5 + 3) * a);
      }
    }
    return all;
  }
};
/// How many instructions and constants are left of a formula in x, y and z.
struct Left {
  std::size_t instructions, numbers;
  bool operator==(Left const&) const = default;
};
Left left_of(std::string const& text) {
  Tape const t = parse_formula(text, {"x", "y", "z"});
  return {t.instructions.size(), t.numbers.size()};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(recorded_arithmetic)

BOOST_AUTO_TEST_CASE(a_tape_has_the_values_and_derivatives_of_the_program_that_it_was_recorded_from) {
  WithArithmetic const exactly(Arithmetic::rationals());
  std::mt19937_64 random(5);
  for (int k = 0; k < 150; ++k) {
    Program const program(random);
    TapeBuilder b(inputs);
    std::vector<Term> terms;
    for (int i = 0; i < inputs; ++i) terms.emplace_back(b, b.input(i));
    std::vector<TapeBuilder::Entry> entries;
    for (Term const& t : program.run(terms)) entries.push_back(t.entry());
    Matrix<Q, inputs, 1> const x(Q(2) / 3, Q(-5) / 7, Q(11) / 4);
    auto const expected = program.run(std::vector<Q>(x.begin(), x.end()));
    BOOST_TEST((values(b.tape(entries), x.data()) == expected), "program " << k);
    // Over double the constants are folded once for all; sums of fractions below 1000 in a few lines.
    std::vector<double> const there{2. / 3, -5. / 7, 2.75};
    auto const rounded = values(b.tape(entries), there.data());
    auto const twin = program.run(there);
    for (std::size_t i = 0; i < rounded.size(); ++i)
      BOOST_TEST(std::abs(rounded[i] - twin[i]) <= 1e6 * eps * (1 + std::abs(twin[i])));

    Tape const last = b.tape(std::span(&entries.back(), 1));
    if (k % 5 > 0) continue;
    auto const gradient = [&](auto const& at) {
      return derivative(
                 [&]<class T>(Matrix<T, inputs, 1> const& p) {
                   return program.run(std::vector<T>(p.begin(), p.end())).back();
                 },
                 at)
          .gradient();
    };
    auto const second = derivative(gradient, x);
    std::vector<Q> all{expected.back()};
    for (int i = 0; i < inputs; ++i) all.push_back(second.value[i]);
    for (int i = 0; i < inputs; ++i)
      for (int j = i; j < inputs; ++j) all.push_back(second.matrix(i, j));
    BOOST_TEST((values(with_hessian(last, {0, 1, 2}), x.data()) == all), "program " << k);
    for (int i = 0; i < inputs; ++i)
      BOOST_TEST((last.depends_on(i) || second.value[i] == 0), "program " << k);
  }
}

BOOST_AUTO_TEST_CASE(constant_factors_and_signs_are_collected) {
  struct Case {
    Left left;
    std::vector<std::string> texts;
  };
  // Instructions, then constants.
  Case const cases[] = {
      {{0, 0}, {"-(-x)", "-x*-1", "x*1", "x + 0", "0 + x", "x - 0", "x^1", "2*x/2"}},
      {{0, 1},
       {"3*x - 3*x", "0/x", "0*x", "x^0", "x*y - y*x", "x + y - (y + x)", "sin(x) - sin(x)",
        "exp(0) + log2(1)", "acos(1) + acosh(1)", "cosh(0)*cos(0)", "log10(1) + asin(0)", "sqrt(9/4)",
        "x*(2 - 2)"}},
      {{1, 0},
       {"x + (-y)", "-x + y", "x - (-y)", "-(x - y)", "x*(1/y)", "(1/y)*x", "(-x)/(-y)", "0 - x", "x^2"}},
      {{1, 1}, {"x + x", "2*x + 3*x - x", "x - (-x)", "-(2*x)", "2*(x*3)", "x/4", "2/(4*y)", "x^-1"}},
      {{2, 0}, {"-x - y", "-x + -y"}},
      {{2, 1}, {"(2*x)*(3*y)", "x*(3*y)", "(2*x)*y", "(2*x)/(3*y)", "x/(2*y)", "x*y + y*x"}},
      {{3, 0}, {"x^8"}},
      {{4, 0}, {"x^7"}}};
  for (auto const& [left, texts] : cases)
    for (auto const& text : texts) {
      Left const found = left_of(text);
      BOOST_TEST(found.instructions == left.instructions, text);
      BOOST_TEST(found.numbers == left.numbers, text);
    }
}

BOOST_AUTO_TEST_CASE(instructions_of_one_operation_stand_in_a_row) {
  Tape const t = parse_formula("sin(x)*2 + sin(y)*3 + cos(x) + sin(z) + cos(y)*5 - cos(z)", {"x", "y", "z"});
  std::size_t count = 0, sines = 0, cosines = 0;
  for (Tape::Run const& run : t.runs) {
    count += run.count;
    sines += run.operation == Operation::sin, cosines += run.operation == Operation::cos;
  }
  BOOST_TEST((sines == 1 && cosines == 1 && count == t.instructions.size()));
  BOOST_TEST(t.places() == 3 + t.numbers.size() + count);
  // Constants that are no ratios are made once for all, and are not part of a call.
  Tape const c = parse_formula("x*log(2)*atan2(1, -2) + hypot(1, 2)^pi - cbrt(5)/sin(1)", {"x"});
  for (Tape::Run const& run : c.runs) BOOST_TEST((run.count == 1 && run.operation <= Operation::multiply));
  BOOST_TEST((c.runs.size() == 3 && !c.is_constant(0) && parse_formula("log(2)^2", {}).is_constant(0)));
  double const x = 3, made = x * std::log(2.) * std::atan2(1, -2) + std::pow(std::hypot(1, 2), M_PI) -
                             std::cbrt(5) / std::sin(1);
  BOOST_TEST(std::abs(values(c, &x)[0] - made) <= 32 * eps);
  WithArithmetic const digits(Arithmetic::decimal(50));
  Number const many = 3;
  BOOST_TEST(std::abs(to_double(values(c, &many)[0]) - made) <= 32 * eps);
}

BOOST_AUTO_TEST_CASE(functions_go_through_terms_and_series) {
  auto const f = [](auto const& x, auto const& y) {
    using std::atan2, std::cos, std::exp, std::log, std::sin, std::sqrt;
    return sqrt(x) + 0.5 * exp(-y) - log(x * 2.5) / 3 + (1 - sin(y)) * (cos(x) - 0.25) + atan2(y, x) + 2 / x -
           y / 4.5;
  };
  TapeBuilder b(2);
  Term const t = f(Term(b, b.input(0)), Term(b, b.input(1)));
  Tape const tape = b.tape(std::vector{t.entry()});
  std::vector<double> const at{1.75, -0.4};
  BOOST_TEST(std::abs(values(tape, at.data())[0] - f(at[0], at[1])) <= 32 * eps);
  // A formula of a series in the time is the series of the formula: its rate is that of a dual number.
  Tape const g = parse_formula(
      "x^1.5 + sinh(x)*tan(x/4) - acosh(x + 1)/cosh(x) + hypot(x, 3) + atan(x)*tanh(-x)", {"x"});
  auto const series = Taylor<double>::series({0.75, 2});
  Dual<double> dual(0.75);
  dual.part[0] = 2;
  auto const of_series = values(g, &series)[0];
  auto const of_dual = values(g, &dual)[0];
  BOOST_TEST(std::abs(of_series.coefficient(0) - of_dual.value) <= 64 * eps);
  BOOST_TEST(std::abs(of_series.coefficient(1) - of_dual.part[0]) <= 64 * eps);
}

BOOST_AUTO_TEST_SUITE_END()
