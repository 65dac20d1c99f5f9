// Example of the module covariant_reduction.
#include "actio/covariant_reduction/balances.hpp"
#include "actio/groups/unit_quaternions.hpp"

#include "example.hpp"

BOOST_AUTO_TEST_SUITE(examples_of_covariant_reduction)
using namespace actio;

BOOST_AUTO_TEST_CASE(a_chiral_field) {
  // [chiral_field]
  // A chiral field on a string: unit quaternions g(s, t), action |g_t|^2/2 - |g_s|^2/2, steps h and D.
  double const h = 0.05, D = 0.1;
  auto const squared = [](double w) { return [w](auto const& f) { return (1.0 - f.value[0]) * (4 * w); }; };
  auto const l = time_and_space(squared(D / h), squared(-h / D));

  SU2 const group;
  GroupField<SU2, double> field{{{}}, {End::free, End::free}};
  std::vector<Momentum<SU2, double>> momenta;
  for (int a = 0; a < 10; ++a) {
    field.levels[0].push_back(exp(velocity(group, Vector<double, 3>(0, 0, std::sin(0.3 * a)))));
    momenta.push_back(momentum(group, Vector<double, 3>(D * 0.2, 0, 0)));
  }
  step_in_time(l, field, momenta);                      // the first step, from the momenta
  for (int k = 0; k < 20; ++k) step_in_time(l, field);  // the field equation at each node

  auto const balance =
      noether_balance(l, field, {.first_node = 2, .nodes = 5, .first_level = 3, .levels = 9});
  assert(magnitude(balance.sum.components) < 1e-14 * balance.terms);
  // [chiral_field]
}

BOOST_AUTO_TEST_SUITE_END()
