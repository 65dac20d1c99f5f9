// What is no formula is refused at its place: hundreds of broken texts, written by hand and made from good
// ones.
#include <cmath>
#include <random>
#include <set>

#include <boost/test/unit_test.hpp>

#include "actio/formula/parse_formula.hpp"
#include "actio/formula/tape_derivatives.hpp"
#include "refused.hpp"

using namespace actio;
using namespace std::string_literals;

namespace {

std::vector<std::string> const names{"w1", "w2", "w3", "gravity1"};

struct Refusal {
  bool refused = false;
  std::size_t position = 0;
  std::string message;
};
Refusal refusal(std::string const& text) {
  try {
    parse_formula(text, names, {{"I1", 2}, {"c", -0.5}});
  } catch (FormulaError const& error) {
    return {true, error.position, error.what()};
  }
  return {};
}
/// Refused, with a place in the text or just behind it and a message in one line.
bool well_refused(std::string const& text) {
  Refusal const r = refusal(text);
  bool printable = !r.message.empty();
  for (char c : r.message) printable = printable && static_cast<unsigned char>(c) >= 0x20 && c != 0x7F;
  return r.refused && r.position <= text.size() && printable;
}

std::string repeated(std::string const& part, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += part;
  return all;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(malformed_formulas)

BOOST_AUTO_TEST_CASE(the_place_and_the_reason_are_told) {
  struct Expected {
    std::string text;
    std::size_t position;
    std::string part;
  };
  for (auto const& [text, position, part] : std::vector<Expected>{
           {"", 0, "found the end, expected a number, a name or '('"},
           {"   ", 3, "found the end"},
           {"w1 + ", 5, "found the end, expected a number"},
           {"w1 w2", 3, "found 'w2', expected an operator"},
           {"2w1", 1, "a product is written 2*x"},
           {"w4", 0, "unknown name 'w4'; did you mean 'w1'? (known: I1, c, gravity1, w1, w2, w3, pi)"},
           {"1 + gravty1", 4, "did you mean 'gravity1'?"},
           {"snh(w1)", 0, "unknown function 'snh'; did you mean 'sinh'?"},
           {"w1*(w2 + 3", 3, "this bracket is not closed"},
           {"w1 + 3)", 6, "found ')', expected an operator"},
           {"sin w1", 4, "expected '(' behind the function sin"},
           {"sin(w1, w2)", 6, "sin is a function of one number"},
           {"atan2(w1)", 8, "expected ',' before the second number of atan2"},
           {"hypot(w1, w2, w3)", 12, "expected an operator or ')'"},
           {"w1(2)", 2, "'w1', which is a number and no function"},
           {"abs(w1)", 0, "'abs' has kinks or jumps, and this formula is smooth, since it is differentiated"},
           {"w1 + max(w1, w2)", 5, "'max' has kinks"},
           {"w1 < 2", 3, "found '<', but this formula is smooth, since it is differentiated"},
           {"w1 == 2", 3, "found '==', but this formula is smooth"},
           {"w1 > 0 ? 1 : 2", 3, "smooth"},
           {"w1 && w2", 3, "smooth"},
           {"w1 | w2", 3, "found '|', but this formula is smooth"},
           {"w1**2", 2, "found '**', expected '^' for a power"},
           {"[w1]", 0, "found '[', expected a round bracket"},
           {"w1 + \xCF\x89", 5, "'\xCF\x89' is no part of a formula; names consist of a-z"},
           {"w1 \xFF", 3, "the byte 255 is no part"},
           {"w1 + \x01", 5, "'\\x01' is no part"},
           {"w1\0+ 2"s, 2, "'\\x00' is no part"},
           {"1.", 0, "a digit on both sides of the point"},
           {".5", 0, "a digit on both sides of the point"},
           {"1.2.3", 3, "found '.' behind the number 1.2"},
           {"1e999", 0, "the number 1e999 is too large or too small"},
           {"1e-999", 0, "too large or too small"},
           {"w1/0", 2, "the divisor is zero"},
           {"w1/(2 - 2)", 2, "the divisor is zero"},
           {"w1 + sqrt(-1)", 5, "this constant does not exist"},
           {"w1*log(0)", 3, "this constant is infinite"},
           {"c^0.3", 1, "this constant does not exist"},
           {"1e300*1e300*w1", 5, "this constant is infinite"},
           {"a = 2", 5, "';' behind the definition of 'a'"},
           {"a = 2;", 6, "found the end, expected the value behind the definitions"},
           {"a = a + 1; a", 4, "unknown name 'a'"},
           {"a = 1; a = 2; a", 7, "the name 'a' stands for a number already"},
           {"w1 = 2; w1", 0, "the name 'w1' stands for a number already"},
           {"pi = 3; pi", 0, "the name 'pi' has a meaning of its own"},
           {"sin = 3; 2", 0, "the name 'sin' has a meaning of its own"},
           {"w1; w2", 2, "expected one formula; a definition is written 'a = 2;'"},
           {"2 = w1", 2, "found '=', expected an operator"},
           {"w1 $ 2", 3, "'$' is no part of a formula"},
       }) {
    Refusal const r = refusal(text);
    BOOST_TEST_CONTEXT("'" << text << "': " << r.message) {
      BOOST_TEST(well_refused(text));
      BOOST_TEST(r.position == position);
      BOOST_TEST(r.message.find(part) != std::string::npos);
    }
  }
}

BOOST_AUTO_TEST_CASE(definitions_are_refused_within_their_own_texts) {
  auto const read = [](std::string const& text, FormulaDefinitions const& definitions) {
    return read_formula(text, {"x", "y"}, {{"c", 2}}, {}, definitions);
  };
  auto const within = [&read](std::string const& text, FormulaDefinitions const& definitions) {
    try {
      read(text, definitions);
    } catch (FormulaError const& error) {
      return error.within + "@" + std::to_string(error.position);
    }
    return "read"s;
  };
  BOOST_TEST(within("a + q", {{"a", "1 + q"}}) == "a@4");
  BOOST_TEST(within("a + q", {{"a", "1 + x"}}) == "@4");
  // What is not used is not read.
  BOOST_TEST(within("x", {{"a", "1 +"}}) == "read");
  CHECK_REFUSED(read("a", {{"a", "b"}, {"b", "x + a"}}), FormulaError);
  CHECK_REFUSED(read("a", {{"a", "q = 2; q"}}), FormulaError);
  CHECK_REFUSED(read("a", {{"a", "2; x"}}), FormulaError);
  CHECK_REFUSED(read("a = 2; a*x", {{"a", "x"}}), FormulaError);
  CHECK_REFUSED(read("c", {{"c", "x"}}), FormulaError);
  FormulaDefinitions chain;
  for (int k = 0; k < 1000; ++k)
    chain["d" + std::to_string(k)] = k == 999 ? "x" : "d" + std::to_string(k + 1);
  CHECK_REFUSED(read("d0", chain), FormulaError);
  BOOST_TEST(within("d900", chain) == "read");
}

BOOST_AUTO_TEST_CASE(names_that_are_none_are_refused) {
  for (auto const* name : {"", "1x", "a b", "x-y", "\xCF\x89", "pi", "sin", "hypot", "x\n"})
    CHECK_REFUSED(parse_formula("1", {name}), FormulaError);
  CHECK_REFUSED(parse_formula("1", {"x", "x"}), FormulaError);
  CHECK_REFUSED(parse_formula("1", {"x"}, {{"x", 1}}), FormulaError);
  CHECK_REFUSED(parse_formula("1", {}, {{"c", std::nan("")}}), FormulaError);
  CHECK_REFUSED(parse_formula("1", {}, {{"c", HUGE_VAL}}), FormulaError);
}

BOOST_AUTO_TEST_CASE(a_formula_that_ends_too_soon_is_refused) {
  // Where a prefix is a formula, it ends behind a number, a name or a bracket.
  std::set<std::string> refused;
  for (std::string const& good : {"(I1*w1^2 + 2.5*w2^2 + sin(w3)^2)/(2 + w1^-2)"s,
                                  "a = hypot(w1, w2); b = -1.5e-3*atan2(a, w3); exp(b^2)*(a - b)"s,
                                  "sqrt(((w1 + w2)*(w2 - w3)^2 + 1)^2 + cosh(gravity1))*pi"s}) {
    BOOST_TEST(!refusal(good).refused);
    for (std::size_t n = 0; n < good.size(); ++n) {
      std::string const prefix = good.substr(0, n);
      if (well_refused(prefix))
        refused.insert(prefix);
      else
        BOOST_TEST(
            std::string("0123456789abcdefghijklmnopqrstuvwxyz)").find(prefix.back()) != std::string::npos,
            "'" << prefix << "' is taken");
      // A sign in the middle that fits nowhere.
      for (char const c : {'$', '\0', '[', '<', '\x80', ';'}) {
        std::string broken = good;
        broken.insert(n, 1, c);
        BOOST_TEST(well_refused(broken), "'" << broken << "' is taken");
        refused.insert(broken);
      }
    }
  }
  BOOST_TEST_MESSAGE(refused.size() << " broken formulas are refused, each with its place");
  BOOST_TEST(refused.size() >= 200u);
}

BOOST_AUTO_TEST_CASE(random_bytes_are_refused_and_random_words_never_break_it) {
  std::mt19937_64 random(1971);
  std::uniform_int_distribution<int> byte(0, 255), length(1, 60);
  for (int k = 0; k < 2000; ++k) {
    std::string text(static_cast<std::size_t>(length(random)), '\0');
    for (char& c : text) c = static_cast<char>(byte(random));
    // A byte that is no ASCII fits nowhere.
    text.insert(text.begin() + static_cast<long>(text.size() / 2), '\xC3');
    BOOST_TEST(well_refused(text));
  }
  std::vector<std::string> const words{"w1", "w2", "c",   "pi",   "2",   "0",     "1e300", "0.5", "+",
                                       "-",  "*",  "/",   "^",    "(",   ")",     ",",     ";",   "=",
                                       "a",  "b",  "sin", "sqrt", "log", "atan2", "hypot", " "};
  std::uniform_int_distribution<std::size_t> word(0, words.size() - 1);
  int taken = 0;
  for (int k = 0; k < 5000; ++k) {
    std::string text;
    for (int n = length(random) / 4; n >= 0; --n) text += words[word(random)];
    if (Refusal const r = refusal(text); r.refused) {
      BOOST_TEST(well_refused(text));
    } else {
      ++taken;
      // What is taken is differentiated and evaluated without harm.
      Tape const tape = with_hessian(parse_formula(text, names, {{"I1", 2}, {"c", -0.5}}), {0, 1});
      std::vector<double> work, x{0.3, 0.7, -1, 2}, y(static_cast<std::size_t>(tape.size()));
      tape(x.data(), y.data(), work);
    }
  }
  BOOST_TEST(taken > 100);
}

BOOST_AUTO_TEST_CASE(sizes_are_bounded) {
  BOOST_TEST(!refusal(repeated("(", 200) + "w1" + repeated(")", 200)).refused);
  Refusal const deep = refusal(repeated("(", 201) + "w1" + repeated(")", 201));
  BOOST_TEST(deep.message == "at most 200 brackets, powers and cases may be open");
  BOOST_TEST(deep.position == 200u);
  for (auto const* part : {"(", "sin(", "2^", "w1*(-(", "2^-(", "hypot(1,", "-("})
    for (int times : {300, 2400}) BOOST_TEST(well_refused(repeated(part, times)));
  // Signs and sums have no depth.
  BOOST_TEST(!refusal(repeated("-", 19999) + "1").refused);
  BOOST_TEST(!refusal("1" + repeated("+w1", 6000)).refused);
  BOOST_TEST(refusal(std::string(200001, '1')).position == 200000u);
  BOOST_TEST(well_refused(std::string(200000, '1')));
  BOOST_TEST(well_refused(std::string(200000, 'x')));
  BOOST_TEST(well_refused("0." + std::string(19000, '0') + "1"));
  BOOST_TEST(!refusal("0." + std::string(19000, '3')).refused);
  BOOST_TEST(well_refused("1e99999999999999999999"));
  // A Hessian may be larger than a formula, but not endless.
  std::string product = "w1";
  for (int k = 0; k < 1200; ++k)
    product += "*sin(w" + std::to_string(1 + k % 3) + "/" + std::to_string(k + 2) + ")";
  BOOST_CHECK_NO_THROW(with_gradient(parse_formula(product, names), {0, 1, 2}));
}

BOOST_AUTO_TEST_CASE(a_formula_with_too_many_instructions_is_refused) {
  TapeBuilder b(1, 100);
  BOOST_CHECK_EXCEPTION(
      for (int k = 2; k < 200; ++k) b.apply(Operation::sin, b.multiply(b.number(k), b.input(0))), Error,
      [](Error const& e) {
        return std::string(e.what()).find("at most 100 instructions") != std::string::npos;
      });
}

BOOST_AUTO_TEST_SUITE_END()
