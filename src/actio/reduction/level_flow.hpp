// The flow of a first-order equation on a group, by an explicit method of order 8 in the natural chart.
#pragma once

#include <array>
#include <utility>

#include "actio/reduction/column_sum.hpp"
#include "actio/reduction/commutators.hpp"
#include "actio/reduction/cooper_verner.hpp"

namespace actio::detail {

/// Steps of \f$\dot g = g\,\xi(\mu)\f$ (side -1) or \f$\dot g = \xi(\mu)\,g\f$ (side +1), where \f$\mu\f$
/// moves with g on its coadjoint orbit: \f$\dot\mu = \mathrm{ad}^*_\xi\,\mu\f$ or
/// \f$-\mathrm{ad}^*_\xi\,\mu\f$.
/// @tparam V  a column of coordinates of the algebra
template <int side, Real B, class V>
class LevelFlow {
  using Square = Matrix<typename V::Scalar, V::RowsAtCompileTime, V::RowsAtCompileTime>;

 public:
  static constexpr int last = CooperVerner<B>::stages - 1;  ///< stage

  /// Whether what is assumed of velocities is to be checked at a stage.
  static constexpr bool checks(int stage) { return stage == last / 2 || stage == last; }

  /// @param zero  a column of the size of the algebra
  LevelFlow(Commutators<B> commutators, V const& zero)
      : commutators_(std::move(commutators)),
        zero_(zero),
        mu_(zero),
        xi_(zero),
        first_(zero),
        sum_(zero),
        power_(zero),
        ad_(Square::Zero(zero.size(), zero.size())) {
    turned_.fill(zero), changed_.fill(zero);
  }

  /// How many coordinates move.
  Index size() const { return zero_.size(); }

  /// The displacement \f$\eta\f$ over a step in the natural chart: \f$g_1 = g_0e^\eta\f$ or
  /// \f$g_1 = e^\eta g_0\f$.
  /// @param velocity  (stage, mu, xi) -> whether to go on: writes the velocity of a momentum
  /// @return          false where it did not go on
  template <class VelocityOf>
  bool operator()(V const& start, B const& h, VelocityOf const& velocity, V& eta) {
    for (int i = 0; i <= last; ++i) {
      add(method_.rows[i], changed_, h * B(-side), start, mu_);
      if (!velocity(i, mu_, xi_)) return false;
      commutators_.ad_star(xi_, mu_, changed_[i]);
      if (i > 0) add(method_.rows[i], turned_, h, zero_, eta);
      rate_in_chart(i, eta, turned_[i]);
    }
    add(method_.rows[last + 1], turned_, h, zero_, eta);
    return true;
  }
  /// \f$\mathrm{Ad}^*\f$ of a displacement: \f$\exp(\mp\mathrm{ad}^*_\eta)\,\mu\f$ by its series, to
  /// rounding.
  void transport(V const& eta, V& mu) {
    using S = typename V::Scalar;
    commutators_.ad(eta, ad_);
    Square const dual = ad_.transpose();
    sum_ = mu;
    for (int k = 1; k <= longest_; ++k) {
      add_columns(zero_, dual, sum_, power_);
      plus(zero_, power_, B(-side) / B(k), sum_), plus(mu, sum_, B(1), mu);
      if (k % 4 == 0 && !(magnitude(sum_) > negligible<S>() * magnitude(mu))) return;
    }
    throw OutsideDomain("momentum level", "a step must be short enough for its series; terms", longest_,
                        longest_);
  }

 private:
  /// out = from + h times a row of the method.
  static void add(typename CooperVerner<B>::Row const& row, std::array<V, last + 1> const& rates, B const& h,
                  V const& from, V& out) {
    ColumnSum<V> sum(from, out);
    for (int k = 0; k < row.count; ++k) sum.add(rates[row.of[k]].data(), h * row.weight[k]);
    sum.store();
  }

  /// \f$\eta' = \mathrm{iex}(\pm\mathrm{ad}_\eta)^{-1}\xi\f$ up to the sixth power of ad, and up to the
  /// fourth at stages that have no weight at the end of the step.
  ///
  /// Since \f$\eta\f$ and \f$\xi\f$ commute to first order, the k-th power is of the order h^(k+1): what is
  /// left out changes the end of the step in the ninth order alone.
  void rate_in_chart(int stage, V const& eta, V& rate) {
    if (stage == 0) return void(rate = xi_);
    // [level_rate]
    // x/(e^x - 1) = 1 - x/2 + x/12 (x - x^2/60 (x - x^2 x/42)), with -x for x on the left.
    commutators_.ad(eta, ad_);
    product(xi_, first_);
    sum_ = first_;
    for (int k = stage < method_.first_with_weight ? 1 : 0; k < 2; ++k) {
      product(sum_, power_), product(power_, sum_);
      plus(first_, sum_, parts_[k], sum_);
    }
    product(sum_, power_);
    plus(xi_, power_, parts_[2], rate), plus(rate, first_, parts_[3], rate);
    // [level_rate]
  }
  /// out = ad times a column.
  [[gnu::always_inline]] void product(V const& by, V& out) const { add_columns(zero_, ad_, by, out); }
  /// out = x + c y.
  static void plus(V const& x, V const& y, B const& c, V& out) {
    for (Index a = 0; a < out.size(); ++a) out[a] = x[a] + y[a] * c;
  }

  static constexpr int longest_ = 300;  // series
  CooperVerner<B> method_;
  Commutators<B> commutators_;
  std::array<V, last + 1> turned_, changed_;  // rates at the stages
  V zero_, mu_, xi_, first_, sum_, power_;
  Square ad_;
  B const parts_[4] = {B(-1) / B(42), B(-1) / B(60), B(1) / B(12), B(-side) / B(2)};
};

}  // namespace actio::detail
