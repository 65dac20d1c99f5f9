#include "actio/fast_body/any_dimension/step_continuation.hpp"

namespace actio::bodies {

namespace detail {

StepContinuation::StepContinuation(NaturalChartEquation& equation, double const* p)
    : equation_(equation),
      algebra_(equation.algebra()),
      whole_(algebra_.size()),
      p_(algebra_.size()),
      z_(algebra_.size()) {
  std::copy(p, p + algebra_.size(), whole_.data());
}

double StepContinuation::follow(double* z) {
  std::vector<double> now(static_cast<std::size_t>(unknowns()), 0.0), before = now;
  double reached = 0, previous = 0, first = first_part(), gap = first;
  while (reached < 1 && gap > smallest_gap * std::max(reached, first)) {
    double const part = std::min(1.0, reached + gap);
    std::vector<double> next = now;
    // Along the secant; from rest along the velocity of the first guess.
    if (reached == 0)
      next = first_guess(part);
    else
      for (std::size_t a = 0; a < next.size(); ++a)
        next[a] += (now[a] - before[a]) * ((part - reached) / (reached - previous));
    std::vector<double> const expected = next;
    if (solve(part, next) && distance(next, expected) <= 0.3 * distance(next, now)) {
      before = now, previous = reached, now = next, reached = part, gap *= 2;
    } else {
      gap = (part - reached) / 2;
    }
  }
  put(now, z);
  return reached;
}

void StepContinuation::put(std::vector<double> const& x, double* z) const {
  std::size_t a = 0;
  for (int j = 0; j < size(); ++j)
    for (int i = j + 1; i < size(); ++i, ++a)
      z[full_entry(algebra_.shape(), i, j)] = x[a], z[full_entry(algebra_.shape(), j, i)] = -x[a];
}

std::vector<double> StepContinuation::taken(double const* z) const {
  std::vector<double> x;
  for (int j = 0; j < size(); ++j)
    for (int i = j + 1; i < size(); ++i) x.push_back(z[full_entry(algebra_.shape(), i, j)]);
  return x;
}

bool StepContinuation::solve(double part, std::vector<double>& x) {
  std::copy(whole_.data(), whole_.data() + algebra_.size(), p_.data());
  algebra_.scale(part, p_.data());
  for (int derivatives = 0; derivatives < 4; ++derivatives) {
    if (!differentiate(x)) return false;
    double before = HUGE_VAL;
    for (int k = 0; k < 12; ++k) {
      auto const move = newton_move(change(x));
      for (std::size_t a = 0; a < x.size(); ++a) x[a] += move[a];
      double const size = norm(move);
      if (!(size < 1)) return false;
      bool const stalls = size > before / 4,
                 settled = derivatives > 0 && stalls && size <= rounding_at_end * norm(x);
      if (size <= 4 * std::numeric_limits<double>::epsilon() * norm(x) || settled) {
        put(x, z_.data());
        return equation_.in_chart(z_.data()) && (derivatives > 0 || differentiate(x));
      }
      if (stalls) break;
      before = size;
    }
  }
  return false;
}

bool StepContinuation::differentiate(std::vector<double> const& x) {
  int const n = unknowns();
  double const apart = 1e-7 * std::max(1.0, norm(x));
  auto const at_x = change(x);
  derivative_.resize(n, n);
  for (int b = 0; b < n; ++b) {
    auto moved = x;
    moved[static_cast<std::size_t>(b)] += apart;
    auto const at_moved = change(moved);
    for (int a = 0; a < n; ++a)
      derivative_(a, b) = (at_x[static_cast<std::size_t>(a)] - at_moved[static_cast<std::size_t>(a)]) / apart;
  }
  if (!derivative_.allFinite()) return false;
  order_.resize(static_cast<std::size_t>(n));
  gsl_permutation order{order_.size(), order_.data()};
  // GSL reads rows where there are columns.
  Eigen::MatrixXd const by_rows = derivative_.transpose();
  derivative_ = by_rows;
  auto view = actio::detail::as_gsl(derivative_);
  int sign = 1;
  gsl_linalg_LU_decomp(&view.matrix, &order, &sign);
  return gsl_linalg_LU_sgndet(&view.matrix, sign) == 1;
}

std::vector<double> StepContinuation::newton_move(std::vector<double> move) {
  gsl_permutation order{order_.size(), order_.data()};
  auto view = actio::detail::as_gsl(derivative_);
  auto right = gsl_vector_view_array(move.data(), move.size());
  gsl_linalg_LU_svx(&view.matrix, &order, &right.vector);
  return move;
}

}  // namespace detail

}  // namespace actio::bodies
