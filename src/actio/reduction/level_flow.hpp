// The flow of a first-order equation on a group, by an explicit method of order 8 in the natural chart.
#pragma once

#include <array>
#include <utility>

#include "actio/reduction/column_sum.hpp"
#include "actio/reduction/commutators.hpp"
#include "actio/reduction/fehlberg.hpp"
#include "actio/reduction/vector_action.hpp"

namespace actio::detail {

/// Steps of \f$\dot g = g\,\xi\f$ (side -1) or \f$\dot g = \xi\,g\f$ (side +1), where \f$\xi\f$ is a function
/// of a momentum and of a vector a that the motion carries, and
///
/// \f[ \dot\mu = \mp(\mathrm{ad}^*_\xi\,\mu + \langle w, \cdot\,a\rangle), \qquad \dot a = \pm\xi a, \f]
///
/// the lower signs on side -1, with a covector w that is a function of them as well.
/// @tparam V  a column of coordinates of the algebra
/// @tparam U  a column of numbers of the vector
template <int side, Real B, class V, class U = Matrix<typename V::Scalar, 0, 1>>
class LevelFlow {
  using S = typename V::Scalar;
  template <class Column>
  using Square = Matrix<S, Column::RowsAtCompileTime, Column::RowsAtCompileTime>;

 public:
  static constexpr int last = Fehlberg<B>::stages - 1;  ///< stage

  /// Whether what is assumed of velocities is to be checked at a stage.
  static constexpr bool checks(int stage) { return stage == last / 2 || stage == last; }

  /// @param zero, nothing  columns of the sizes of the algebra and of the vector
  LevelFlow(Commutators<B> commutators, VectorAction<B> action, V const& zero, U const& nothing)
      : commutators_(std::move(commutators)),
        action_(std::move(action)),
        zero_(zero),
        mu_(zero),
        xi_(zero),
        nothing_(nothing),
        a_(nothing),
        w_(nothing),
        pushed_(nothing),
        ad_(Square<V>::Zero(zero.size(), zero.size())) {
    if (nothing.size() > 0) dual_ = Square<U>::Zero(nothing.size(), nothing.size());
    rates_.fill({zero, zero, nothing, nothing}), powers_.fill(zero), terms_.fill(nothing);
    chart_.fill(B(0)), exponential_.fill(B(1));
    chart_[1] = B(-side) / B(2), chart_[2] = B(1) / B(12), chart_[4] = B(-1) / B(720);
    chart_[6] = B(1) / B(30240);
    for (int k = 1; k < 9; ++k) exponential_[k] = exponential_[k - 1] * B(side) / B(k);
  }

  /// How many coordinates the algebra has.
  Index size() const { return zero_.size(); }
  /// How many numbers the vector has.
  Index length() const { return nothing_.size(); }

  /// The displacement \f$\eta\f$ over a step in the natural chart: \f$g_1 = g_0e^\eta\f$ or
  /// \f$g_1 = e^\eta g_0\f$.
  /// @param velocity  (stage, mu, a, xi, w) -> whether to go on: writes the last two
  /// @return          false where it did not go on
  template <class VelocityOf>
  bool operator()(V const& momentum, U const& vector, B const& h, VelocityOf const& velocity, V& eta) {
    for (int i = 0; i <= last; ++i) {
      Rates& rates = rates_[i];
      find_stage(method_.rows[i], momentum, vector, h, eta);
      if (!velocity(i, mu_, a_, xi_, w_)) return false;
      commutators_.ad_star(xi_, mu_, rates.momentum);
      action_.add_rates(xi_, w_, a_, rates.momentum, rates.vector);
      rate_in_chart(i, eta, rates.chart), push_at_start(i, eta, rates.push);
    }
    auto const& end = method_.rows[last + 1];
    ColumnSum<V> turned(zero_, eta);
    ColumnSum<U> pushed(nothing_, pushed_);
    for (int k = 0; k < end.count; ++k) {
      B const c = h * end.weight[k];
      turned.add(rates_[end.of[k]].chart.data(), c), pushed.add(rates_[end.of[k]].push.data(), c);
    }
    turned.store(), pushed.store();
    return true;
  }
  /// Adds to the momentum at the start of the last step what the vector has done to it over the step, in
  /// coordinates that move with neither: \f$\mp\langle\int e^{\pm\eta^T}w\,dt, \cdot\,a\rangle\f$.
  ///
  /// With a vector a fixed there, this is a coadjoint action of the semidirect product of the group with the
  /// covectors of vectors; \f$\mathrm{Ad}^*\f$ of the displacement is another one. After both, momentum and
  /// vector are those at the end of the step, and its Casimirs are what they were.
  void push(U const& vector, V& momentum) const { action_.add_torque(pushed_, vector, B(-side), momentum); }
  /// Momentum and vector by \f$\mathrm{Ad}^*\f$ of a displacement and by its action,
  /// \f$\exp(\mp\mathrm{ad}^*_\eta)\,\mu\f$ and \f$\exp(\pm\eta)\,a\f$, by their series, to rounding.
  void transport(V const& eta, V& momentum, U& vector) {
    commutators_.ad(eta, ad_), action_.dual_matrix(eta, dual_);
    exponentiate(Square<V>(ad_.transpose()), B(-side), momentum);
    exponentiate(Square<U>(dual_.transpose()), B(side), vector);
  }

 private:
  /// What changes at a stage in a unit of time; momentum and vector for the lower signs.
  struct Rates {
    V momentum, chart;
    U vector, push;
  };

  /// Momentum, vector and displacement at a stage, from the rates at those before it.
  void find_stage(typename Fehlberg<B>::Row const& row, V const& momentum, U const& vector, B const& h,
                  V& eta) {
    ColumnSum<V> mu(momentum, mu_), turned(zero_, eta);
    ColumnSum<U> a(vector, a_);
    for (int k = 0; k < row.count; ++k) {
      B const c = h * row.weight[k], with_side = side > 0 ? B(-c) : c;
      Rates const& rates = rates_[row.of[k]];
      mu.add(rates.momentum.data(), with_side), a.add(rates.vector.data(), with_side);
      turned.add(rates.chart.data(), c);
    }
    mu.store(), a.store(), turned.store();
  }

  /// \f$\eta' = \mathrm{iex}(\pm\mathrm{ad}_\eta)^{-1}\xi\f$ up to the sixth power of ad at stages that have
  /// a weight at the end of the step, and up to the second at others.
  ///
  /// Since \f$\eta\f$ and \f$\xi\f$ commute to first order, the k-th power is of the order h^(k+1): what is
  /// left out changes the end of the step in the ninth order alone. What errors of the fifth order at stages
  /// without weight do to the others is cancelled there (\ref Fehlberg).
  void rate_in_chart(int stage, V const& eta, V& rate) {
    if (stage == 0) return void(rate = xi_);
    // [level_rate]
    // x/(e^x - 1) = 1 - x/2 + x^2/12 - x^4/720 + x^6/30240 - ..., with -x for x on the left.
    commutators_.ad(eta, ad_);
    series(ad_, xi_, chart_, method_.needs_all_powers(stage) ? 6 : 2, powers_, rate);
    // [level_rate]
  }
  /// The covector at a stage in coordinates at the start of the step, \f$e^{\pm\eta^T}w\f$, up to the eighth
  /// power of \f$\eta\f$, one more than the order needs.
  void push_at_start(int stage, V const& eta, U& push) {
    if (length() == 0 || stage < method_.first_with_weight) return;
    action_.dual_matrix(eta, dual_);
    series(dual_, w_, exponential_, method_.needs_all_powers(stage) ? 8 : 1, terms_, push);
  }
  /// out = a column + the sum of coefficients times powers of a matrix times that column.
  template <class Column>
  static void series(Square<Column> const& matrix, Column const& column, std::array<B, 9> const& coefficients,
                     int count, std::array<Column, 9>& powers, Column& out) {
    ColumnSum<Column> sum(column, out);
    powers[0] = column;
    for (int k = 1; k <= count; ++k) {
      multiply(matrix, powers[k - 1], powers[k]);
      sum.add(powers[k].data(), coefficients[k]);
    }
    sum.store();
  }
  /// The exponential of a matrix, times c, applied to a column.
  template <class Column>
  static void exponentiate(Square<Column> const& matrix, B const& c, Column& column) {
    if (column.size() == 0) return;
    Column term = column, next = column;
    for (int k = 1; k <= longest_; ++k) {
      multiply(matrix, term, next);
      for (Index i = 0; i < column.size(); ++i) column[i] += term[i] = next[i] * (c / B(k));
      if (k % 4 == 0 && !(magnitude(term) > negligible<S>() * magnitude(column))) return;
    }
    throw OutsideDomain("momentum level", "a step must be short enough for its series; terms", longest_,
                        longest_);
  }

  static constexpr int longest_ = 300;  // series
  Fehlberg<B> method_;
  Commutators<B> commutators_;
  VectorAction<B> action_;
  std::array<Rates, last + 1> rates_;  // at the stages
  V zero_, mu_, xi_;
  U nothing_, a_, w_, pushed_;
  std::array<V, 9> powers_;
  std::array<U, 9> terms_;
  Square<V> ad_;
  Square<U> dual_;
  std::array<B, 9> chart_ = {}, exponential_ = {};  // coefficients of series
};

}  // namespace actio::detail
