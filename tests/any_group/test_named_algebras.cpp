// Bases and structure constants of the groups with names are those of the library's types.
#include <boost/test/unit_test.hpp>

#include "actio/any_group/named_algebra.hpp"
#include "actio/groups/direct_product.hpp"
#include "actio/groups/semidirect_product.hpp"
#include "actio/groups/unit_quaternions.hpp"

using namespace actio;

namespace {

using Tables = std::vector<Eigen::MatrixXd>;

/// The matrices of ad of all basis vectors, from the bracket of a group of the library.
template <class G>
Tables brackets(G const& group) {
  using V = Coordinates<G, double>;
  int const d = group.dimension();
  Tables all;
  for (int a = 0; a < d; ++a) {
    V e = V::Zero(d);
    e[a] = 1;
    all.push_back(primitive::ad_matrix(group, e));
  }
  return all;
}
/// The same from structure constants.
Tables brackets(MatrixAlgebra const& algebra) {
  auto const d = static_cast<std::size_t>(algebra.dimension);
  Tables all(d, Eigen::MatrixXd::Zero(algebra.dimension, algebra.dimension));
  for (auto const& c : algebra.constants) all[static_cast<std::size_t>(c.a)](c.c, c.b) += c.value;
  return all;
}
void same(std::string const& what, Tables const& a, Tables const& b) {
  BOOST_TEST_REQUIRE(a.size() == b.size(), what << ": " << a.size() << " and " << b.size());
  for (std::size_t k = 0; k < a.size(); ++k) BOOST_TEST((a[k] == b[k]), what << ", vector " << k + 1);
}
/// As a matrix group: the same matrices and the same brackets, without rounding.
template <MatrixGroup G>
void is(std::string const& name, G const& group) {
  MatrixAlgebra const algebra = named_algebra(name);
  BOOST_TEST(algebra.name == name);
  BOOST_TEST(algebra.size == group.matrix_size());
  BOOST_TEST_REQUIRE(algebra.dimension == group.dimension(), name);
  for (int a = 0; a < algebra.dimension; ++a) {
    Coordinates<G, double> e = Coordinates<G, double>::Zero(group.dimension());
    e[a] = 1;
    BOOST_TEST((algebra.basis[static_cast<std::size_t>(a)] == Eigen::MatrixXd(group.hat(e))), name);
  }
  same(name, brackets(algebra), brackets(group));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(named_algebras)

BOOST_AUTO_TEST_CASE(rotations_and_motions) {
  is("SO(2)", SO<2>{});
  is("SO(3)", SO<3>{});
  is("SO(4)", SO<4>{});
  is("SE(2)", SE<2>{});
  is("SE(3)", SE<3>{});
}
BOOST_AUTO_TEST_SUITE_END()
