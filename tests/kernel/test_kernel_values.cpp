// The definitions of the proofs against the library: proofs_checks/kernel/values.tsv holds, as fractions,
// what they give on matrices; the library evaluates its functions over the rationals on the same matrices.
#include <boost/test/unit_test.hpp>

#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "actio/groupoid/group_as_groupoid.hpp"
#include "actio/groupoid/hamilton_jacobi.hpp"
#include "actio/groupoid/lagrange_equations.hpp"
#include "actio/groups/linear_groups.hpp"
#include "actio/groups/rotations_of_any_size.hpp"
#include "actio/reduction/discrete_euler_lagrange.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/reduction/relative_motion.hpp"
#include "actio/rigid_body/casimirs.hpp"
#include "actio/rigid_body/moser_veselov.hpp"
#include "actio/rigid_body/multiplier.hpp"
#include "actio/variational/coadjoint_orbit.hpp"
#include "actio/variational/lie_poisson.hpp"
#include "witness/number.hpp"

using namespace actio;

namespace {

using Whole = actio::Matrix<Number, Dynamic, Dynamic>;
using Column = actio::Matrix<Number, Dynamic, 1>;

/// A definition on one sample: its arguments and its value.
struct Sample {
  std::string definition, name;
  std::vector<Whole> in;
  Whole out;
};

/// Of a fraction such as -4/5, with any number of digits.
Number number(std::string const& text) {
  Number part(0), numerator(0);
  bool quotient = false;
  for (char const c : text) {
    if (c == '/')
      numerator = part, part = Number(0), quotient = true;
    else if (c != '-')
      part = part * Number(10) + Number(c - '0');
  }
  Number const x = quotient ? numerator / part : part;
  return text.starts_with('-') ? -x : x;
}

std::vector<Sample> samples() {
  std::ifstream file(ACTIO_KERNEL_VALUES);
  BOOST_REQUIRE_MESSAGE(file, "there is no file " ACTIO_KERNEL_VALUES);
  std::vector<Sample> all;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream words(line);
    std::string definition, name, role, entry;
    int rows = 0, columns = 0;
    words >> definition >> name >> role >> rows >> columns;
    Whole m(rows, columns);
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < columns; ++j) {
        BOOST_REQUIRE_MESSAGE(words >> entry, "entries are missing: " << line);
        m(i, j) = number(entry);
      }
    BOOST_REQUIRE_MESSAGE(!(words >> entry), "more entries than rows and columns: " << line);
    if (role == "in1") all.push_back({definition, name, {}, {}});
    BOOST_REQUIRE(!all.empty() && all.back().definition == definition && all.back().name == name);
    if (role == "out")
      all.back().out = m;
    else
      all.back().in.push_back(m);
  }
  return all;
}

template <class A, class B>
bool same(A const& a, B const& b) {
  if (a.rows() != b.rows() || a.cols() != b.cols()) return false;
  for (Index i = 0; i < a.rows(); ++i)
    for (Index j = 0; j < a.cols(); ++j)
      if (!(a(i, j) == b(i, j))) return false;
  return true;
}

/// \f$\mathrm{Tr}(p^Tv)\f$, how the proofs pair matrices.
template <class P, class V>
auto trace_pairing(P const& p, V const& v) {
  typename V::Scalar sum(0);
  for (Index i = 0; i < v.rows(); ++i)
    for (Index j = 0; j < v.cols(); ++j) sum += typename V::Scalar(p(i, j)) * v(i, j);
  return sum;
}

// Functions to differentiate, on group elements and on momenta, which are matrices row by row.

template <class G, class T>
auto const& matrix_of(Element<G, T> const& g) { return g.value; }
template <int n, class T>
auto matrix_of(Momentum<GL<n>, T> const& mu) { return GL<n>::hat(mu.components); }

/// \f$\mathrm{Tr}(p^Tf)\f$.
struct Linear {
  Whole p;
  template <class X>
  auto operator()(X const& f) const { return trace_pairing(p, matrix_of(f)); }
};
/// \f$\mathrm{Tr}(a^T\!f\,b\,f)\f$, and \f$\mathrm{Tr}(a^T\!f\,b\,g)\f$.
struct Product {
  Whole a, b;
  template <class X>
  auto operator()(X const& f, X const& g) const {
    using T = typename X::Scalar;
    auto const x = matrix_of(f), y = matrix_of(g);
    T sum(0);
    Index const n = a.rows();
    for (Index k = 0; k < n; ++k)
      for (Index l = 0; l < n; ++l) {
        if (b(k, l) == Number(0)) continue;
        T inner(0);
        for (Index i = 0; i < n; ++i)
          for (Index j = 0; j < n; ++j) inner += x(i, k) * y(l, j) * T(a(i, j));
        sum += inner * T(b(k, l));
      }
    return sum;
  }
  template <class X>
  auto operator()(X const& f) const { return (*this)(f, f); }
};

/// A sample as the library sees it, on the group G.
template <class G>
struct On {
  Sample const& s;
  G group;

  Element<G, Number> element(int k) const { return {group, s.in.at(k)}; }
  Velocity<G, Number> velocity(int k) const { return {group, group.vee(s.in.at(k))}; }
  /// The components of a covector are its values on the basis.
  Momentum<G, Number> covector(Whole const& p) const {
    Momentum<G, Number> mu{group, Coordinates<G, Number>(group.dimension())};
    for (int a = 0; a < group.dimension(); ++a)
      mu.components[a] = trace_pairing(p, Whole(group.hat(basis_velocity<Number>(group, a).coordinates)));
    return mu;
  }
  Momentum<G, Number> momentum(int k) const { return covector(s.in.at(k)); }
  Product function() const { return {s.in.at(0), s.in.at(1)}; }

  bool is(Element<G, Number> const& g) const { return same(g.value, s.out); }
  bool is(Velocity<G, Number> const& v) const { return same(group.hat(v.coordinates), s.out); }
  bool is(Momentum<G, Number> const& mu) const {
    return s.out.rows() == group.matrix_size() && same(mu.components, covector(s.out).components);
  }
  bool is(Number const& x) const { return s.out.size() == 1 && s.out(0, 0) == x; }
};

template <class Argument>
using Evaluators = std::map<std::string, std::function<bool(Argument const&)>>;

/// What the functions of a group give.
template <class G>
Evaluators<On<G>> const& of_group() {
  using X = On<G>;
  static Evaluators<X> const all{
      {"Ad", [](X const& x) { return x.is(Ad(x.element(0), x.velocity(1))); }},
      {"Ad_star", [](X const& x) { return x.is(Ad_star(x.element(0), x.momentum(1))); }},
      {"bracket", [](X const& x) { return x.is(bracket(x.velocity(0), x.velocity(1))); }},
      {"ad_star", [](X const& x) { return x.is(ad_star(x.velocity(0), x.momentum(1))); }},
      {"pairing", [](X const& x) { return x.is(pair(x.momentum(0), x.velocity(1))); }},
      {"L_star", [](X const& x) { return x.is(left_differential(Linear{x.s.in.at(1)}, x.element(0))); }},
      {"R_star", [](X const& x) { return x.is(right_differential(Linear{x.s.in.at(1)}, x.element(0))); }},
      {"relative_motion_right",
       [](X const& x) { return x.is(relative_motion_right(x.element(0), x.element(1))); }},
      {"relative_motion_left",
       [](X const& x) { return x.is(relative_motion_left(x.element(0), x.element(1))); }},
      {"reconstruct_right", [](X const& x) { return x.is(reconstruct_right(x.element(0), x.element(1))); }},
      {"reconstruct_left", [](X const& x) { return x.is(reconstruct_left(x.element(0), x.element(1))); }},
      {"lie_poisson_update_right",
       [](X const& x) { return x.is(lie_poisson_update_right(x.element(0), x.momentum(1))); }},
      {"lie_poisson_update_left",
       [](X const& x) { return x.is(lie_poisson_update_left(x.element(0), x.momentum(1))); }},
      {"right_differential", [](X const& x) { return x.is(right_differential(x.function(), x.element(2))); }},
      {"left_differential", [](X const& x) { return x.is(left_differential(x.function(), x.element(2))); }},
      {"momentum_before_right",
       [](X const& x) { return x.is(momentum_before_right(x.function(), x.element(2))); }},
      {"momentum_before_left",
       [](X const& x) { return x.is(momentum_before_left(x.function(), x.element(2))); }},
      {"initial_momentum_left",
       [](X const& x) { return x.is(initial_momentum_left(x.function(), x.element(2))); }},
      {"final_momentum_left",
       [](X const& x) { return x.is(final_momentum_left(x.element(0), x.momentum(1))); }},
      {"euler_poincare_right",
       [](X const& x) { return x.is(euler_poincare_right(x.function(), x.element(2), x.element(3))); }},
      {"euler_poincare_left",
       [](X const& x) { return x.is(euler_poincare_left(x.function(), x.element(2), x.element(3))); }},
      {"D1", [](X const& x) { return x.is(D1(x.function(), x.element(2), x.element(3))); }},
      {"D2", [](X const& x) { return x.is(D2(x.function(), x.element(2), x.element(3))); }},
      {"discrete_euler_lagrange",
       [](X const& x) {
         return x.is(discrete_euler_lagrange(x.function(), x.element(2), x.element(3), x.element(4)));
       }},
      {"legendre_at_target",
       [](X const& x) {
         GroupAsGroupoid<G> const gamma{x.group};
         return x.is(Number(legendre_at_target(gamma, x.function(), x.element(2))
                                .components.dot(x.velocity(3).coordinates)));
       }},
      {"legendre_at_source",
       [](X const& x) {
         GroupAsGroupoid<G> const gamma{x.group};
         return x.is(Number(legendre_at_source(gamma, x.function(), x.element(2))
                                .components.dot(x.velocity(3).coordinates)));
       }},
      {"kirillov_kostant_plus",
       [](X const& x) {
         auto const mu = x.momentum(0);
         return x.is(kirillov_kostant_plus(mu, ad_star(x.velocity(1), mu), ad_star(x.velocity(2), mu)));
       }},
  };
  return all;
}

/// What has a function on covectors, which are matrices for the groups of all of them.
template <class G>
Evaluators<On<G>> const& of_matrices() {
  using X = On<G>;
  static Evaluators<X> const all{
      {"lie_poisson_bracket_plus",
       [](X const& x) {
         return x.is(lie_poisson_bracket_plus(Product{x.s.in.at(0), x.s.in.at(1)},
                                              Product{x.s.in.at(2), x.s.in.at(3)}, x.momentum(4)));
       }},
  };
  return all;
}

using Rotations = On<SO<Dynamic>>;
Inertia<Dynamic, Number> inertia(Whole const& lambda) {
  return inertia_from_lambda<Dynamic, Number>(Column(lambda.diagonal()));
}
MoserVeselov<Dynamic, Number> scheme(Whole const& lambda) { return {inertia(lambda), Number(1)}; }
/// A momentum of a body is the skew matrix of which its components are the coordinates.
Velocity<SO<Dynamic>, Number> as_matrix(Momentum<SO<Dynamic>, Number> const& mu) {
  return {mu.group, mu.components};
}

/// What the functions of a body give, in every dimension.
Evaluators<Rotations> const& of_bodies() {
  using X = Rotations;
  static Evaluators<X> const all{
      {"skew_part", [](X const& x) { return x.is(Number(2) * x.velocity(0)); }},
      {"inertia_operator",
       [](X const& x) { return x.is(as_matrix(body_momentum(inertia(x.s.in.at(0)), x.velocity(1)))); }},
      {"kinetic_energy",
       [](X const& x) { return x.is(kinetic_energy(inertia(x.s.in.at(0)), x.velocity(1))); }},
      {"casimir",
       [](X const& x) { return x.is(trace_of_square(actio::momentum(x.group, x.velocity(0).coordinates))); }},
      {"trace_casimir", [](X const& x) { return x.is(trace_casimir(x.s.in.at(0), x.element(1))); }},
      {"cayley", [](X const& x) { return same(cayley(Whole(x.s.in.at(0) * Number(2))), x.s.out); }},
      {"momentum_before",
       [](X const& x) { return x.is(as_matrix(scheme(x.s.in.at(1)).momentum_before(x.element(0)))); }},
      {"momentum_after",
       [](X const& x) { return x.is(as_matrix(scheme(x.s.in.at(1)).momentum_after(x.element(0)))); }},
      {"orthogonality", [](X const& x) { return same(orthogonality(x.s.in.at(0)), x.s.out); }},
      {"body_multiplier",
       [](X const& x) { return same(body_multiplier(x.s.in.at(0), x.s.in.at(1)), x.s.out); }},
      {"hat", [](X const& x) { return same(SO<3>::hat(Column(x.s.in.at(0).col(0))), x.s.out); }},
      {"cross",
       [](X const& x) {
         using Vector3 = actio::Matrix<Number, 3, 1>;
         return same(cross(Vector3(x.s.in.at(0).col(0)), Vector3(x.s.in.at(1).col(0))), x.s.out);
       }},
  };
  return all;
}

/// 1 or 0 as the library's value is or is not the recorded one; -1 where no evaluator knows the definition.
template <class X>
int agrees(Evaluators<X> const& all, X const& x) {
  auto const found = all.find(x.s.definition);
  return found == all.end() ? -1 : found->second(x);
}
int agrees(Sample const& s) {
  auto const on_matrices = [&]<class G>(G group) {
    int const answer = agrees(of_group<G>(), On<G>{s, group});
    return answer < 0 ? agrees(of_matrices<G>(), On<G>{s, group}) : answer;
  };
  auto const group = s.name.substr(0, s.name.find('.'));
  if (group == "GL2") return on_matrices(GL<2>{});
  if (group == "GL3") return on_matrices(GL<3>{});
  if (group == "GL4") return on_matrices(GL<4>{});
  if (!group.starts_with("SO")) return -1;
  int const answer = agrees(of_bodies(), Rotations{s, {std::stoi(group.substr(2))}});
  return answer < 0 && group == "SO3" ? agrees(of_group<SO<3>>(), On<SO<3>>{s, {}}) : answer;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(values_of_the_proofs)

BOOST_AUTO_TEST_CASE(the_library_gives_what_the_definitions_give) {
  WithArithmetic const rationals(Arithmetic::rationals());
  auto const all = samples();
  std::set<std::string> met;
  for (Sample const& s : all) {
    met.insert(s.definition);
    int const answer = agrees(s);
    BOOST_TEST(answer >= 0, s.definition << " has no evaluator here for the sample " << s.name);
    BOOST_TEST(answer != 0, s.definition << " differs on the sample " << s.name);
  }
  BOOST_TEST(all.size() > 200u);
  // And no evaluator is left over.
  auto const required = [&](auto const& evaluators) {
    for (auto const& [name, evaluate] : evaluators)
      BOOST_TEST(met.contains(name), name << " has an evaluator, but no values");
  };
  required(of_group<GL<2>>());
  required(of_matrices<GL<2>>());
  required(of_bodies());
  BOOST_TEST_MESSAGE("definitions of the proofs with a twin in the library: " << met.size() << ", on "
                                                                              << all.size() << " samples");
}

BOOST_AUTO_TEST_CASE(one_entry_that_differs_is_found) {
  WithArithmetic const rationals(Arithmetic::rationals());
  for (Sample s : samples()) {
    // In the corner: an entry on the diagonal is none of the algebra of the rotations.
    s.out(0, s.out.cols() - 1) += Number(1);
    BOOST_TEST(agrees(s) == 0, s.definition << " on the sample " << s.name);
  }
}

BOOST_AUTO_TEST_CASE(what_has_no_evaluator_is_told) {
  WithArithmetic const rationals(Arithmetic::rationals());
  Sample s = samples().front();
  s.definition = "no_definition";
  BOOST_TEST(agrees(s) == -1);
}

BOOST_AUTO_TEST_SUITE_END()
