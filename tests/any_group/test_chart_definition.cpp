// One step of the natural chart by structure constants is what its definition says, with dense matrices and
// power series in long double.
#include <boost/test/unit_test.hpp>

#include "own_system.hpp"

using namespace actio;
using namespace actio::systems;

namespace {

using Number = long double;
using Square = Matrix<Number>;
using Column = Vector<Number>;
using List = std::vector<double>;

/// A Lagrangian of a velocity of three components and two carried vectors of two, without any symmetry.
char const* const lagrangian =
    "(2*x1^2 + 3*x2^2 + 5*x3^2)/2 + x1*x2/3 + x3^3/7 + a1*(1 + x1/4) - b2*a2/2 + b1^2/3";
/// Its differential in the velocity.
Column slope_in_velocity(Column const& v, Column const& a) {
  return Column{{2 * v[0] + v[1] / 3 + a[0] / 4, 3 * v[1] + v[0] / 3, 5 * v[2] + 3 * v[2] * v[2] / 7}};
}
/// Its differential in the two vectors.
Column slope_in_vectors(Column const& v, Column const& a) {
  return Column{{1 + v[0] / 4, -a[3] / 2, 2 * a[2] / 3, -a[1] / 2}};
}

/// On SL(2), or on the triangular matrices, of which some products vanish in one order alone.
ReducedSystem system_on(Side side, Chart chart, bool triangular = false) {
  auto const entry = [](int i, int j) { return systems::detail::elementary_matrix(2, i, j); };
  MatrixAlgebra algebra =
      triangular ? spanned_algebra({entry(0, 0), entry(0, 1), entry(1, 1)}) : named_algebra("SL(2)");
  Tape l = parse_formula(lagrangian, {"x1", "x2", "x3", "a1", "a2", "b1", "b2"}, {});
  return {std::move(algebra), side, 2, std::move(l), chart};
}

/// By Gauss and Jordan, for matrices near the identity.
Square inverse_of(Square m) {
  Square inverse = Square::Identity(m.rows(), m.rows());
  for (Index k = 0; k < m.rows(); ++k) {
    Number const pivot = m(k, k);
    m.row(k) /= pivot, inverse.row(k) /= pivot;
    for (Index i = 0; i < m.rows(); ++i) {
      if (i == k) continue;
      Number const factor = m(i, k);
      m.row(i) -= factor * m.row(k), inverse.row(i) -= factor * inverse.row(k);
    }
  }
  return inverse;
}
Square power_series(Square const& a, int first) {
  Square term = Square::Identity(a.rows(), a.cols()), sum = term;
  for (int k = first; k < first + 120; ++k) term = (term * a / static_cast<Number>(k)).eval(), sum += term;
  return sum;
}

struct Ends {
  Column before, after, vectors;
};
/// What the header of the step says, word by word.
Ends by_definition(ReducedSystem const& system, Number h, Column const& v, Column const& a0) {
  int const d = system.dimension(), m = system.length();
  Number const sign = system.side == Side::left ? 1 : -1;
  std::vector<Square> basis;
  for (auto const& e : system.algebra.basis) basis.push_back(e.cast<Number>());
  Square hv = Square::Zero(m, m), one = Square::Identity(m, m);
  for (int b = 0; b < d; ++b) hv += sign * h * v[b] * basis[static_cast<std::size_t>(b)];
  bool const cayley = system.chart == Chart::cayley;
  Square const back = cayley ? Square(inverse_of(one + hv / 2) * (one - hv / 2)) : power_series(-hv, 1);
  Column a1(a0.size());
  for (int k = 0; k < a0.size(); k += m) a1.segment(k, m) = back * a0.segment(k, m);

  Square ad(d, d), squares(d, d);
  for (int b = 0; b < d; ++b) {
    Square const& e = basis[static_cast<std::size_t>(b)];
    ad.col(b) = system.algebra.vee(Matrix<Number>(hv * e - e * hv));
    squares.col(b) = system.algebra.vee(Matrix<Number>(hv * e * hv));
  }
  Square const id = Square::Identity(d, d),
               chi = cayley ? Square(id - ad / 2 - squares / 4) : inverse_of(power_series(ad, 2)),
               other = cayley ? Square(id + ad / 2 - squares / 4) : inverse_of(power_series(-ad, 2));
  Column const p = (slope_in_velocity(v, a0) + slope_in_velocity(v, a1)) / 2;
  auto const push = [&](Column const& a) {
    Column const slope = slope_in_vectors(v, a);
    Column j = Column::Zero(d);
    for (int b = 0; b < d; ++b)
      for (int k = 0; k < a.size(); k += m)
        j[b] += slope.segment(k, m).dot(basis[static_cast<std::size_t>(b)] * a.segment(k, m));
    return Column(sign * h / 2 * j);
  };
  return {chi.transpose() * p + push(a0), other.transpose() * p - push(a1), a1};
}

Column column(List const& x) {
  Column out(static_cast<Index>(x.size()));
  for (std::size_t i = 0; i < x.size(); ++i) out[static_cast<Index>(i)] = x[i];
  return out;
}
/// The largest difference, over the largest number.
template <class Read>
double apart(Ends const& ends, Read const& read) {
  Number difference = 0, size = 1e-300L;
  for (int which = 0; which < 3; ++which) {
    Column const& truth = which == 0 ? ends.before : which == 1 ? ends.after : ends.vectors;
    for (Index i = 0; i < truth.size(); ++i) {
      difference = std::max(difference, std::abs(truth[i] - static_cast<Number>(read(which, i))));
      size = std::max(size, std::abs(truth[i]));
    }
  }
  return static_cast<double>(difference / size);
}

/// A velocity whose motion turns, by 2.06 times the step.
List const v{0.2, 1.0, -1.1}, a{0.7, -0.4, 0.3, 1.2};

}  // namespace

BOOST_AUTO_TEST_SUITE(definition_of_a_chart_step)

BOOST_AUTO_TEST_CASE(momenta_and_vectors_at_both_ends_are_those_of_the_definition) {
  for (Side const side : {Side::left, Side::right})
    for (Chart const chart : {Chart::exponential, Chart::cayley})
      for (double const h : {0.05, -0.3, 0.8, 1.4})
        for (bool const triangular : {false, true}) {
          ReducedSystem const system = system_on(side, chart, triangular);
          ChartStep<double> step(system);
          BOOST_TEST(step(h, v, a));
          Ends const truth = by_definition(system, h, column(v), column(a));
          double const by = apart(truth, [&](int which, Index i) {
            auto const& list = which == 0 ? step.before : which == 1 ? step.after : step.vectors;
            return list[static_cast<std::size_t>(i)];
          });
          // Up to thirty powers of a matrix of size 4, each with its roundings, and factors that shrink
          // faster.
          BOOST_TEST(by < 256 * 0x1p-52, "triangular " << triangular << ", side " << (side == Side::left)
                                                       << ", chart " << (chart == Chart::cayley) << ", step "
                                                       << h << ": " << by);
        }
}

BOOST_AUTO_TEST_CASE(rates_of_momenta_and_vectors_are_those_of_the_definition) {
  // Differences of the definition over 2e-5: the third derivatives are below 1e3, so they are right to 1e-7.
  Number const by = 1e-5L;
  for (Side const side : {Side::left, Side::right})
    for (Chart const chart : {Chart::exponential, Chart::cayley})
      for (double const h : {0.1, 0.8})
        for (std::size_t direction = 0; direction < 8; ++direction) {
          ReducedSystem const system = system_on(side, chart);
          using D = Moved<double>;
          std::vector<D> dv(v.begin(), v.end()), da(a.begin(), a.end());
          D dh(h);
          Column up = column(v), down = up, up_a = column(a), down_a = up_a;
          Number up_h = h, down_h = h;
          if (direction < 3) {
            dv[direction].part[0] = 1;
            up[static_cast<Index>(direction)] += by, down[static_cast<Index>(direction)] -= by;
          } else if (direction < 7) {
            da[direction - 3].part[0] = 1;
            up_a[static_cast<Index>(direction) - 3] += by, down_a[static_cast<Index>(direction) - 3] -= by;
          } else {
            dh.part[0] = 1, up_h += by, down_h -= by;
          }
          ChartStep<D> step(system);
          BOOST_TEST(step(dh, dv, da));
          Ends const more = by_definition(system, up_h, up, up_a),
                     less = by_definition(system, down_h, down, down_a),
                     rates{(more.before - less.before) / (2 * by), (more.after - less.after) / (2 * by),
                           (more.vectors - less.vectors) / (2 * by)};
          double const off = apart(rates, [&](int which, Index i) {
            auto const& list = which == 0 ? step.before : which == 1 ? step.after : step.vectors;
            return list[static_cast<std::size_t>(i)].part[0];
          });
          BOOST_TEST(off < 1e-7, "direction " << direction << ", step " << h << ": " << off);
        }
}

BOOST_AUTO_TEST_CASE(coefficients_of_chi_follow_from_zeta_of_even_numbers) {
  // Euler: (n + 1/2) zeta(2n) is the sum of zeta(2k) zeta(2n - 2k) over k from 1 to n - 1; zeta(2) = pi^2/6.
  std::array<Number, 65> zeta{};
  Number const pi = std::numbers::pi_v<Number>;
  zeta[1] = pi * pi / 6;
  for (std::size_t n = 2; n < 65; ++n) {
    for (std::size_t k = 1; k < n; ++k) zeta[n] += zeta[k] * zeta[n - k];
    zeta[n] /= static_cast<Number>(n) + 0.5L;
  }
  auto const& beta = systems::detail::coefficients_of_chi();
  BOOST_TEST(beta[0] == 1);
  for (int k = 1; k < 65; ++k) {
    auto const at = static_cast<std::size_t>(k);
    Number const truth = (k % 2 ? 2 : -2) * zeta[at] / std::pow(2 * pi, static_cast<Number>(2 * k));
    // A power of the rounded 2 pi, and from the seventh on the terms of zeta after the twelfth.
    double const tail = k < 6 ? 0 : std::pow(12.0, 1 - 2 * k) / (2 * k - 1);
    BOOST_TEST(std::abs(static_cast<double>(beta[at] / truth - 1)) < tail + (2 * k + 4) * 0x1p-52, k);
  }
}

BOOST_AUTO_TEST_CASE(a_turn_beyond_the_series_is_outside_of_the_chart) {
  // The turn is 2.06 times the step. The series of chi converges for turns below 2 pi, its terms fall as the
  // square of the turn over 2 pi, and 64 of them reach 2^-55 up to 0.74 of that, a step of 2.26.
  ReducedSystem const system = system_on(Side::left, Chart::exponential);
  ChartStep<double> step(system);
  BOOST_TEST(step(2.2, v, a));
  BOOST_TEST(!step(2.4, v, a));
  BOOST_TEST(!step(3.2, v, a));
}

BOOST_AUTO_TEST_CASE(a_small_covector_is_carried_to_second_order) {
  ReducedSystem const system = system_on(Side::left, Chart::exponential);
  ChartStep<double> step(system);
  double const h = 0x1p-12;
  step(h, v, a);
  Square ad = Square::Zero(3, 3);
  Number squares = 0;
  for (auto const& c : system.algebra.constants)
    ad(c.c, c.b) += static_cast<Number>(h) * v[static_cast<std::size_t>(c.a)] * c.value;
  for (Number const x : ad.reshaped()) squares += x * x;
  BOOST_TEST(std::abs(step.square_of_ad() / static_cast<double>(squares) - 1) < 16 * 0x1p-52);
  List x{1, -2, 3};
  Column const truth = power_series(ad.transpose(), 1) * column(x);
  step.transport(x);
  // The term of third order: the cube of a matrix of size 4 h over 6, times a covector of size 6.
  double const third = 64 * h * h * h;
  for (Index i = 0; i < 3; ++i)
    BOOST_TEST(std::abs(static_cast<double>(truth[i]) - x[static_cast<std::size_t>(i)]) < third);
}

BOOST_AUTO_TEST_SUITE_END()
