#include "actio/any_group/invariants.hpp"

namespace actio::systems {

std::string Casimir::text() const {
  std::string sum;
  for (Term const& t : terms) {
    double const size = std::abs(t.coefficient);
    sum += sum.empty() ? (t.coefficient < 0 ? "-" : "") : (t.coefficient < 0 ? " - " : " + ");
    if (size != 1) sum += show(size) + "*";
    std::string const& first = components[static_cast<std::size_t>(t.i)];
    sum += t.j == t.i ? first + "^2"
           : t.j < 0  ? first
                      : first + "*" + components[static_cast<std::size_t>(t.j)];
  }
  return sum;
}

namespace detail {
namespace {

/// The conditions \f$\{C, \mu_b\} = 0\f$ on the coefficients of a polynomial of degree 1 or 2, for one b.
std::map<int, SparseRow> casimir_conditions(MatrixAlgebra const& algebra, int degree, int b) {
  Monomials const monomials{algebra.dimension};
  std::map<int, SparseRow> rows;
  for (auto const& c : algebra.constants) {
    if (c.b != b) continue;
    if (degree == 1)
      rows[c.c][c.a] += c.value;
    else
      for (int i = 0; i < algebra.dimension; ++i)
        rows[monomials.number(i, c.c)][monomials.number(i, c.a)] += i == c.a ? 2 * c.value : c.value;
  }
  return rows;
}

}  // namespace

double defect_of_casimir(MatrixAlgebra const& algebra, Casimir const& casimir) {
  Monomials const monomials{algebra.dimension};
  std::map<int, std::vector<Casimir::Term>> with;  // the terms with a variable, this one first
  double defect = 0, largest = 0, constants = 1e-300;
  for (auto const& t : casimir.terms) {
    with[t.i].push_back(t), largest = std::max(largest, std::abs(t.coefficient));
    if (t.j >= 0) with[t.j].push_back({t.j, t.i, t.coefficient});
  }
  std::map<std::pair<int, int>, double> brackets;  // by b and the monomial
  for (auto const& c : algebra.constants) {
    constants = std::max(constants, std::abs(c.value));
    for (auto const& t : with[c.a])
      brackets[{c.b, t.j < 0 ? c.c : monomials.number(c.c, t.j)}] += t.coefficient * c.value;
  }
  for (auto const& [which, x] : brackets) defect = std::max(defect, std::abs(x));
  return defect / (largest * constants);
}

Casimir with_whole_coefficients(Casimir casimir) {
  double least = std::abs(casimir.terms.front().coefficient);
  for (auto const& t : casimir.terms) least = std::min(least, std::abs(t.coefficient));
  double const sign = casimir.terms.front().coefficient < 0 ? -1 : 1;
  for (int times = 1; times <= 60; ++times) {
    double const scale = sign * times / least;
    bool const whole = std::all_of(casimir.terms.begin(), casimir.terms.end(), [&](auto const& t) {
      double const x = t.coefficient * scale;
      return std::abs(x - std::round(x)) < 1e-9 * times && std::abs(x) < 1e6;
    });
    if (!whole) continue;
    for (auto& t : casimir.terms) t.coefficient = std::round(t.coefficient * scale);
    return casimir;
  }
  for (auto& t : casimir.terms) t.coefficient *= sign;
  return casimir;
}

Casimir casimir_of(MatrixAlgebra const& algebra, int degree, SparseRow const& polynomial) {
  Casimir casimir{degree, {}, algebra.components};
  for (auto const& [k, x] : polynomial) {
    auto const [i, j] = degree == 1 ? std::pair(k, -1) : Monomials{algebra.dimension}.factors(k);
    casimir.terms.push_back({i, j, x});
  }
  return casimir;
}

LevelBasis::LevelBasis(MatrixAlgebra const& algebra) {
  constants.dimension = algebra.dimension, constants.components = algebra.components;
  for (auto const& e : algebra.basis)
    powers_.push_back(std::exp2(std::round(std::log2(e.cwiseAbs().maxCoeff()))));
  for (auto c : algebra.constants) {
    c.value *= power(c.c) / (power(c.a) * power(c.b));
    constants.constants.push_back(c);
  }
}

Casimir LevelBasis::in_basis(Casimir casimir, bool this_one) const {
  for (auto& t : casimir.terms) {
    double const factor = power(t.i) * (t.j < 0 ? 1 : power(t.j));
    t.coefficient = this_one ? t.coefficient * factor : t.coefficient / factor;
  }
  return casimir;
}

namespace {

/// All polynomials of degree 1 or 2 that meet the conditions.
std::vector<SparseRow> homogeneous_casimirs(MatrixAlgebra const& algebra, int degree) {
  SparseElimination conditions(Monomials{algebra.dimension}.count(degree));
  std::vector<SparseRow> waiting;
  for (int b = 0; b < algebra.dimension; ++b)
    for (auto&& [monomial, row] : casimir_conditions(algebra, degree, b)) waiting.push_back(std::move(row));
  // Those that say something new first, and those that repeat what is nearly known last.
  for (double const least : {0.3, 0.1, 0.01, 1e-4, 0.0})
    std::erase_if(waiting, [&](SparseRow const& row) {
      double const distance = conditions.add(row, least);
      return distance == 0 || distance >= least;
    });
  return conditions.null_space();
}

/// Quadratic ones that are no sums of products of linear ones.
std::vector<SparseRow> without_products(std::vector<SparseRow> const& quadratic,
                                        std::vector<SparseRow> const& linear, Monomials monomials) {
  SparseElimination span(monomials.count(2));
  for (std::size_t a = 0; a < linear.size(); ++a)
    for (std::size_t b = a; b < linear.size(); ++b) {
      SparseRow product;
      for (auto const& [i, x] : linear[a])
        for (auto const& [j, y] : linear[b]) product[monomials.number(i, j)] += x * y;
      span.add(product);
    }
  std::size_t const products = span.rows().size();
  for (SparseRow const& q : quadratic) span.add(q);
  return {span.rows().begin() + static_cast<std::ptrdiff_t>(products), span.rows().end()};
}

}  // namespace
}  // namespace detail

std::vector<Casimir> casimirs(MatrixAlgebra const& algebra) {
  detail::LevelBasis const level(algebra);
  std::vector<Casimir> found;
  auto const keep = [&](int degree, std::vector<detail::SparseRow> const& polynomials) {
    for (auto const& p : polynomials) {
      Casimir const level_one = detail::casimir_of(level.constants, degree, p),
                    raw = level.in_basis(level_one, false), whole = detail::with_whole_coefficients(raw);
      double const defect = detail::defect_of_casimir(level.constants, level_one),
                   whole_defect = detail::defect_of_casimir(level.constants, level.in_basis(whole, true));
      if (std::min(defect, whole_defect) < 1e-9) found.push_back(whole_defect <= defect ? whole : raw);
    }
  };
  auto const linear = detail::homogeneous_casimirs(level.constants, 1);
  keep(1, linear);
  keep(2, detail::without_products(detail::homogeneous_casimirs(level.constants, 2), linear,
                                   detail::Monomials{algebra.dimension}));
  return found;
}

}  // namespace actio::systems
