#include "actio/fast_body/space/natural_chart_step.hpp"

namespace actio::bodies {

ChartFactors::ChartFactors(double s) {
  if (s < 0.25) {
    // c = sum |B_2k| s^(k-1)/(2k)!: the first term that is left out is below 1e-18.
    constexpr double b[] = {1.0 / 12,
                            1.0 / 720,
                            1.0 / 30240,
                            1.0 / 1209600,
                            1.0 / 47900160,
                            691.0 / 1307674368000,
                            1.0 / 74724249600,
                            3617.0 / 10670622842880000,
                            43867.0 / 5109094217170944000,
                            174611.0 / 802857662698291200000.0};
    c = b[9], slope_c = 0;
    for (int k = 8; k >= 0; --k) slope_c = slope_c * s + c, c = c * s + b[k];
    a = 1 - c * s, slope_a = -(c + slope_c * s);
    return;
  }
  double const half = std::sqrt(s) / 2;
  a = half * std::cos(half) / std::sin(half);
  c = (1 - a) / s, slope_a = (a - a * a - s / 4) / (2 * s), slope_c = -(slope_a + c) / s;
}

NaturalChartStep::StepRotation NaturalChartStep::turn(Three<double> const& p, Three<double> v) const {
  double last = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < 12; ++iteration) {
    Linearization const l = at(v);
    if (!(l.s < half_turn_squared) || !(l.determinant > 0)) return {v, l.s, false};
    Three<double> const change = l.solve(minus(p, l.p));
    v = plus(v, change);
    double const moved = largest(change), size = largest(v);
    // The error after a move is its square, over a few tenths.
    if (moved <= 1e-10 * size) return {v, dot(v, v), dot(v, v) < half_turn_squared};
    // No smaller than the move before: rounding, or nothing to be found from here.
    if (!(moved < last)) return {v, dot(v, v), moved <= 1e-7 * size && dot(v, v) < half_turn_squared};
    last = moved;
  }
  return {v, dot(v, v), false};
}

NaturalChartStep::StepRotation NaturalChartStep::followed(Three<double> const& p) const {
  StepRotation reached{{0, 0, 0}, 0, true};
  constexpr int pieces = 32;
  for (int k = 1; k <= pieces; ++k) {
    double const part = static_cast<double>(k) / pieces;
    Three<double> const ahead = at(reached.v).solve({p[0] / pieces, p[1] / pieces, p[2] / pieces});
    reached = turn({part * p[0], part * p[1], part * p[2]}, plus(reached.v, ahead));
    if (!reached.found) break;
  }
  return reached;
}

Three<double> NaturalChartStep::Linearization::solve(Three<double> const& r) const {
  Three<double> x;
  for (int i = 0; i < 3; ++i)
    x[i] = (cofactors[0][i] * r[0] + cofactors[1][i] * r[1] + cofactors[2][i] * r[2]) / determinant;
  return x;
}

NaturalChartStep::Linearization NaturalChartStep::at(Three<double> const& v) const {
  Linearization l;
  l.s = dot(v, v);
  ChartFactors const f(l.s < half_turn_squared * 3 ? l.s : half_turn_squared * 3);
  Three<double> const y{moments_[0] * v[0], moments_[1] * v[1], moments_[2] * v[2]};
  double const vy = dot(v, y), along = f.c * vy;
  for (int i = 0; i < 3; ++i) {
    int const j = (i + 1) % 3, k = (i + 2) % 3;
    // (v x y)_i = (I_k - I_j) v_j v_k: of a long body the difference would lose its digits.
    l.p[i] = f.a * y[i] + 0.5 * gap_[i] * (v[j] * v[k]) + along * v[i];
    double const rate = 2 * (f.slope_a * y[i] + f.slope_c * vy * v[i]), across = 2 * f.c * v[i];
    l.rows[i][i] = f.a * moments_[i] + along + rate * v[i] + across * y[i];
    l.rows[i][j] = 0.5 * gap_[i] * v[k] + rate * v[j] + across * y[j];
    l.rows[i][k] = 0.5 * gap_[i] * v[j] + rate * v[k] + across * y[k];
  }
  for (int i = 0; i < 3; ++i) l.cofactors[i] = cross(l.rows[(i + 1) % 3], l.rows[(i + 2) % 3]);
  l.determinant = dot(l.rows[0], l.cofactors[0]);
  return l;
}

}  // namespace actio::bodies
