#include <Eigen/Core>

#include "actio/any_group/matrix_algebra.hpp"

namespace actio::systems {

namespace detail {

Eigen::MatrixXd commutator(std::vector<MatrixAlgebra::Entry> const& a,
                           std::vector<MatrixAlgebra::Entry> const& b, int size) {
  Eigen::MatrixXd c = Eigen::MatrixXd::Zero(size, size);
  for (auto const& x : a)
    for (auto const& y : b) {
      if (x.column == y.row) c(x.row, y.column) += x.value * y.value;
      if (y.column == x.row) c(y.row, x.column) -= x.value * y.value;
    }
  return c;
}

void find_projection(MatrixAlgebra& algebra) {
  std::vector<Eigen::VectorXd> rows;
  for (auto const& e : algebra.basis) rows.push_back(entries_of(e));
  SpanProjection const span(rows);
  algebra.denominator = span.denominator;
  for (int a = 0; a < algebra.dimension; ++a)
    for (int j = 0; j < algebra.size; ++j)
      for (int i = 0; i < algebra.size; ++i) {
        auto const k = static_cast<std::size_t>(a);
        if (double const x = algebra.basis[k](i, j); x != 0) algebra.entries.push_back({a, i, j, x});
        double const y = span.dual[k][i + j * algebra.size];
        if (y != 0) algebra.projection.push_back({a, i, j, y});
      }
}

namespace {

/// Structure constants, from the commutators.
/// @throws OutsideDomain  where a commutator leaves the span: which one, and how far
void find_constants(MatrixAlgebra& algebra) {
  constexpr double bound = 1e-9, rounding = 1e-14;
  auto const d = static_cast<std::size_t>(algebra.dimension);
  std::vector<std::vector<MatrixAlgebra::Entry>> of(d);
  for (auto const& e : algebra.entries) of[static_cast<std::size_t>(e.direction)].push_back(e);
  for (std::size_t a = 0; a < d; ++a)
    for (std::size_t b = a + 1; b < d; ++b) {
      Eigen::MatrixXd const c = commutator(of[a], of[b], algebra.size);
      Vector<double> const v = algebra.vee(c);
      double const scale = algebra.basis[a].norm() * algebra.basis[b].norm(),
                   outside = (Eigen::MatrixXd(algebra.hat(v)) - c).norm() / scale;
      if (!(outside <= bound))
        throw OutsideDomain("basis of an algebra",
                            "commutators of the matrices must be in their span, but [e_" +
                                std::to_string(a + 1) + ", e_" + std::to_string(b + 1) +
                                "] leaves it; distance relative to the two",
                            outside, bound);
      for (std::size_t k = 0; k < d; ++k) {
        double const x = v[static_cast<Index>(k)];
        if (!(std::abs(x) * algebra.basis[k].norm() > rounding * scale)) continue;
        int const i = static_cast<int>(a), j = static_cast<int>(b), l = static_cast<int>(k);
        algebra.constants.push_back({i, j, l, x}), algebra.constants.push_back({j, i, l, -x});
      }
    }
}

}  // namespace

MatrixAlgebra algebra_of_basis(std::string name, std::vector<Eigen::MatrixXd> basis) {
  MatrixAlgebra algebra;
  algebra.name = std::move(name);
  algebra.basis = std::move(basis);
  algebra.size = static_cast<int>(algebra.basis.front().rows());
  algebra.dimension = static_cast<int>(algebra.basis.size());
  for (int a = 1; a <= algebra.dimension; ++a) algebra.components.push_back("x" + std::to_string(a));
  find_projection(algebra);
  find_constants(algebra);
  return algebra;
}

namespace {

/// @throws OutsideDomain, NotFinite
void check_basis_matrix(Eigen::MatrixXd const& e, Index rows, std::size_t number) {
  std::string const which = "matrix e_" + std::to_string(number) + " of a basis";
  if (e.rows() != rows || e.cols() != rows)
    throw OutsideDomain(which,
                        "square matrices of one size are needed; it has " + std::to_string(e.rows()) +
                            " rows; its columns and the rows of the first",
                        static_cast<double>(e.cols()), static_cast<double>(rows));
  require_finite(e, which.c_str());
  double const largest = e.cwiseAbs().maxCoeff();
  if (!(largest >= 1e-6))
    throw OutsideDomain(which, "a matrix with an entry of moderate size is needed, scale it; largest",
                        largest, 1e-6);
  if (!(largest <= 1e6))
    throw OutsideDomain(which, "entries of moderate size are needed, scale the matrix; largest", largest,
                        1e6);
}

}  // namespace
}  // namespace detail

MatrixAlgebra spanned_algebra(std::vector<Eigen::MatrixXd> basis) {
  if (basis.empty()) throw OutsideDomain("basis of an algebra", "at least one matrix is needed", 0, 1);
  detail::require_moderate_dimension("with a basis of its own", static_cast<double>(basis.size()));
  Index const rows = basis.front().rows();
  if (rows < 1 || rows > 128)
    throw OutsideDomain("basis of an algebra", "matrices of 1 to 128 rows are needed",
                        static_cast<double>(rows), rows < 1 ? 1 : 128);
  for (std::size_t a = 0; a < basis.size(); ++a) detail::check_basis_matrix(basis[a], rows, a + 1);
  return detail::algebra_of_basis("", std::move(basis));
}

}  // namespace actio::systems
