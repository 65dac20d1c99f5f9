// The conditions on the method ABA(8,6,4), word by word.
//
// With drifts A and kicks epsilon B a step is a sum of words in A and B, and the flow of A + epsilon B has
// 1/n! before each word of length n. For the method a word with one B is A^i B A^j, and its coefficient the
// sum over the kicks of b c^i/i! (1-c)^j/j!, c the part of the step that has been drifted; and so on with
// more.
#include <boost/test/unit_test.hpp>

#include "actio/numbers/functions.hpp"
#include "actio/two_bodies/pair_method.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::bodies;

namespace {
/// The largest miss of the words with `kicks` letters B and a length.
double miss(Splitting const& method, int kicks, int length) {
  double worst = 0;
  std::vector<int> drifts(kicks + 1, 0);
  std::vector<double> at;  // when the kicks are
  double c = 0;
  for (std::size_t k = 0; k <= method.drifts.size(); ++k) {
    at.push_back(c);
    if (k < method.drifts.size()) c += method.drifts[k];
  }
  // All ways to write length - kicks as a sum of the exponents of A.
  auto const over_words = [&](auto const& self, int place, int left) -> void {
    if (place < kicks) {
      for (int n = 0; n <= left; ++n) drifts[place] = n, self(self, place + 1, left - n);
      return;
    }
    drifts[kicks] = left;
    // The sum over kicks m1 <= m2 <= ...; the same kick n times has 1/n!.
    auto const sum = [&](auto const& again, int letter, std::size_t from, int same, double weight) -> double {
      if (letter == kicks)
        return weight * std::pow(1 - at[from], drifts[kicks]) / double(factorial(drifts[kicks]));
      double total = 0;
      for (std::size_t m = letter == 0 ? 0 : from; m < at.size(); ++m) {
        bool const repeated = letter > 0 && m == from;
        if (repeated && drifts[letter] > 0) continue;
        double const time = letter == 0 ? at[m] : at[m] - at[from];
        double const step =
            method.kicks[m] * (repeated ? 1.0 / (same + 1)
                                        : std::pow(time, drifts[letter]) / double(factorial(drifts[letter])));
        total += again(again, letter + 1, m, repeated ? same + 1 : 1, weight * step);
      }
      return total;
    };
    worst = std::max(worst, std::abs(sum(sum, 0, 0, 0, 1) - 1 / double(factorial(length))));
  };
  over_words(over_words, 0, length - kicks);
  return worst;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(pair_method)

BOOST_AUTO_TEST_CASE(the_method_8_6_4_meets_its_conditions_and_no_more) {
  auto const method = aba_864_splitting();
  for (int kicks = 1; kicks <= 4; ++kicks) {
    int const order = kicks == 1 ? 8 : kicks == 2 ? 6 : 4;
    for (int length = kicks; length <= order; ++length) BOOST_TEST(miss(method, kicks, length) <= 2e-15);
    if (kicks <= 3) BOOST_TEST(miss(method, kicks, order + 1) > 1e-8);
    BOOST_TEST_MESSAGE(kicks << " kicks: beyond order " << order << " by " << miss(method, kicks, order + 1));
  }
  // The same count for methods that are known.
  BOOST_TEST(miss(strang_splitting(), 1, 2) == 0);
  BOOST_TEST(miss(strang_splitting(), 1, 3) > 0.01);
  for (int kicks = 1; kicks <= 2; ++kicks) {
    for (int length = kicks; length <= 4; ++length)
      BOOST_TEST(miss(blanes_moan_splitting(), kicks, length) <= 5e-14);
    BOOST_TEST(miss(blanes_moan_splitting(), kicks, 5) > 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(other_orders_are_refused) {
  CHECK_REFUSED(pair_splitting(3), OutsideDomain);
  CHECK_REFUSED(pair_splitting(6), OutsideDomain);
}

BOOST_AUTO_TEST_SUITE_END()
