// Functions on the sphere as numbers on a grid, and back, in O(N^2) memory.
//
// On the parallel of the colatitude theta a function is a sum over m of e^{im phi} times
// F_m(theta) = sum_l f_lm P_lm(theta): the longitudes are Fourier transforms, the sums over l are made with
// columns of the normalised Legendre functions, which are found on the way and not stored. With
// t = 1 - cos(theta)
//
//   P_{l+1} = rho_l P_l + D_l,   D_l = alpha_l D_{l-1} - beta_l t P_l,
//   rho_l = sqrt((2l + 3)(l - m + 1)/((2l + 1)(l + m + 1))),
//   alpha_l = rho_l (l + m)/(l - m + 1),   beta_l = rho_l (2l + 1)/(l - m + 1),
//
// is the recurrence in l, in the differences of neighbours. The usual one takes cos(theta), in which the
// neighbourhood of a pole has few digits: at the degree 2048 it is wrong by 1e-9 there, this one by 1e-13
// anywhere. It starts at P_mm, a multiple of sin^m(theta), far below the least double near the poles: a
// number is stored together with how often it was divided by 2^-800.
//
// Parallels are the lanes of a block, and P_lm(pi - theta) = (-1)^{l-m} P_lm(theta) gives two of them for
// one.
//
// libsharp of Debian does the same in a quarter of the time, by instructions that it chooses when it runs. It
// is not used: its licence, the GPL, would become that of every program with this library, and at N = 512 a
// transform takes as long as two or three products of matrices, many of which a step has.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "actio/vorticity/matrix_harmonics.hpp"

namespace actio {

/// Numbers on a grid: a row for each parallel, from the north, a column for each meridian, from longitude 0.
using GridField = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Parallels that lie symmetrically about the equator, and meridians at equal distances.
struct SphereGrid {
  Eigen::ArrayXd colatitude;  ///< of the parallels, rising, in (0, pi)
  Eigen::ArrayXd weight;      ///< of the parallels in an integral over cos(theta); their sum is 2
  int longitudes = 0;         ///< how many meridians there are; the one k is at 2 pi k/longitudes
  bool gaussian = false;  ///< whether the integral of a polynomial of a degree below 2 x parallels is exact

  /// How many circles of latitude there are.
  int latitudes() const { return static_cast<int>(colatitude.size()); }
  /// In radians, north positive.
  double latitude(int row) const { return M_PI / 2 - colatitude[row]; }
  /// In radians.
  double longitude(int column) const { return 2 * M_PI * column / longitudes; }
  /// The integral over the sphere.
  double integral(GridField const& field) const {
    return 2 * M_PI / longitudes * weight.matrix().dot(field.rowwise().sum());
  }

  /// The middles of the cells of a net with equal steps in both angles; no parallel is a pole.
  /// @throws OutsideDomain  where there are fewer than one of each
  static SphereGrid uniform(int latitudes, int longitudes) {
    SphereGrid grid(latitudes, longitudes);
    for (int j = 0; j < latitudes; ++j) {
      grid.colatitude[j] = M_PI * (j + 0.5) / latitudes;
      grid.weight[j] = 2 * std::sin(grid.colatitude[j]) * std::sin(M_PI / (2 * latitudes));
    }
    return grid;
  }
  /// Parallels at the zeros of the Legendre polynomial, with the weights of Gauss.
  ///
  /// Accuracy: a few epsilon, relative to the angle and to the weight.
  /// @throws OutsideDomain  where there are fewer than one of each
  static SphereGrid gauss(int latitudes, int longitudes) {
    SphereGrid grid(latitudes, longitudes);
    grid.gaussian = true;
    int const n = latitudes;
    for (int j = 0; j < (n + 1) / 2; ++j) {
      // Newton's iteration in the angle, from Tricomi's guess, by the differences of neighbours.
      long double theta = std::numbers::pi_v<long double> * (4.0L * j + 3) / (4.0L * n + 2), slope = 0;
      for (int round = 0; round < 4; ++round) {
        long double const half = std::sin(theta / 2), t = 2 * half * half;
        long double p = 1, difference = 0;
        for (int l = 0; l < n; ++l) {
          difference = (l * difference - (2 * l + 1) * t * p) / (l + 1);
          p += difference;
        }
        // sin(theta) dP_n/d theta = n (cos(theta) P_n - P_{n-1}).
        slope = n * (difference - t * p) / std::sin(theta);
        theta -= p / slope;
      }
      if (2 * j + 1 == n) theta = std::numbers::pi_v<long double> / 2;
      grid.colatitude[j] = static_cast<double>(theta);
      grid.colatitude[n - 1 - j] = static_cast<double>(std::numbers::pi_v<long double> - theta);
      grid.weight[j] = grid.weight[n - 1 - j] = static_cast<double>(2 / (slope * slope));
    }
    return grid;
  }

 private:
  SphereGrid(int rows, int columns)
      : colatitude(std::max(rows, 0)), weight(std::max(rows, 0)), longitudes(columns) {
    if (rows < 1 || columns < 1)
      throw OutsideDomain("grid on the sphere", "at least one parallel and one meridian are needed",
                          std::min(rows, columns), 1);
  }
};

/// The normalised Legendre functions \f$P_{lm}(\theta)\f$, \f$Y_{lm} = P_{lm}e^{im\varphi}\f$, for one m
/// after the other.
class LegendreFunctions {
 public:
  /// The most parallels of a block.
  static constexpr int lanes = 32;
  /// One row for each degree, one column for each latitude.
  using Block = Eigen::Matrix<double, Eigen::Dynamic, lanes, Eigen::RowMajor>;

  /// For m = 0.
  /// @param colatitudes  in [0, pi]
  LegendreFunctions(Eigen::ArrayXd const& colatitudes, int degrees)
      : degrees_(degrees),
        t_(colatitudes.size()),
        sine_(colatitudes.size()),
        first_(colatitudes.size()),
        exponent_(colatitudes.size(), 0) {
    for (Eigen::Index j = 0; j < colatitudes.size(); ++j) {
      auto const at = static_cast<std::size_t>(j);
      double const half = std::sin(colatitudes[j] / 2);
      t_[j] = 2 * half * half;
      sine_[at] = std::sin(static_cast<long double>(colatitudes[j]));
      first_[at] = 1 / std::sqrt(4 * std::numbers::pi_v<long double>);
    }
    set_coefficients();
  }

  int m() const { return m_; }  ///< the order
  /// Goes on to the next m.
  void next() {
    ++m_;
    for (std::size_t j = 0; j < first_.size(); ++j) {
      int by = 0;
      first_[j] = std::frexp(-first_[j] * sine_[j] * std::sqrt((2 * m_ + 1.0L) / (2.0L * m_)), &by);
      exponent_[j] += by;
    }
    set_coefficients();
  }
  /// \f$P_{lm}(\theta_j)\f$ for j from `first` on: the rows are l = m, m + 1, ..., degrees - 1; lanes beyond
  /// the last j hold what may be overwritten.
  /// @return the first row to be read: those before it, which are not set, are below \f$2^{-700}\f$
  int block(int first, Block& u) const {
    int const size = degrees_ - m_;
    if (u.rows() < size) u.resize(size, lanes);
    Lanes t, p, small;
    for (int i = 0; i < lanes; ++i) {
      auto const at = std::min<std::size_t>(first + i, first_.size() - 1);
      int const times = exponent_[at] < 0 ? -exponent_[at] / binary : 0;
      t[i] = t_[static_cast<Eigen::Index>(at)], small[i] = times;
      p[i] = static_cast<double>(std::ldexp(first_[at], exponent_[at] + binary * times));
    }
    Lanes d = p;
    int r = 0, from = 0;
    // As long as a lane is small, only the others are written.
    for (; r < size && (small > 0).any(); ++r) {
      u.row(r) = (small > 0).select(Lanes::Zero(), p);
      if ((small > 0).all()) from = r + 1;
      advance(r, t, p, d);
      if (r % 4 == 3) lift(p, d, small);
    }
    for (; r < size; ++r) {
      u.row(r) = p;
      advance(r, t, p, d);
    }
    return from;
  }

 private:
  using Lanes = Eigen::Array<double, 1, lanes>;
  static constexpr int binary = 800;

  void set_coefficients() {
    auto const size = static_cast<std::size_t>(std::max(0, degrees_ - m_));
    rho_.resize(size), alpha_.resize(size), beta_.resize(size);
    for (std::size_t r = 0; r < size; ++r) {
      double const l = m_ + static_cast<double>(r), above = static_cast<double>(r) + 1;
      rho_[r] = std::sqrt((2 * l + 3) * above / ((2 * l + 1) * (l + m_ + 1)));
      alpha_[r] = rho_[r] * (l + m_) / above, beta_[r] = rho_[r] * (2 * l + 1) / above;
    }
  }
  void advance(int r, Lanes const& t, Lanes& p, Lanes& d) const {
    auto const at = static_cast<std::size_t>(r);
    d = alpha_[at] * d - beta_[at] * t * p;
    p = rho_[at] * p + d;
  }
  /// Lanes that have grown to 1 are large enough to be stored with one division less.
  static void lift(Lanes& p, Lanes& d, Lanes& small) {
    double const unit = std::ldexp(1.0, -binary);
    for (int i = 0; i < lanes; ++i)
      if (small[i] > 0 && std::abs(p[i]) >= 1) p[i] *= unit, d[i] *= unit, --small[i];
  }

  int degrees_, m_ = 0;
  Eigen::ArrayXd t_;
  std::vector<long double> sine_, first_;  ///< P_mm is first x 2^exponent
  std::vector<int> exponent_;
  std::vector<double> rho_, alpha_, beta_;  ///< at l - m
};

/// Calls `use(m, first, lanes, from, u)` for blocks that hold the northern half of the parallels, the equator
/// with it; rows of u before `from` are nothing.
template <class Use>
void over_half_of_sphere(SphereGrid const& grid, int degrees, Use const& use) {
  int const half = (grid.latitudes() + 1) / 2;
  LegendreFunctions functions(grid.colatitude.head(half), degrees);
  LegendreFunctions::Block u;
  for (; functions.m() < degrees; functions.next())
    for (int first = 0; first < half; first += LegendreFunctions::lanes) {
      int const from = functions.block(first, u);
      use(functions.m(), first, std::min(LegendreFunctions::lanes, half - first), from, u);
    }
}

/// The values of functions on a grid, all of the same degrees. O(N^3) operations, O(N^2) memory for each.
///
/// Accuracy: about 1e-13 of the largest value at N = 2048. The grid may be coarser than the functions.
inline std::vector<GridField> values_on(SphereGrid const& grid,
                                        std::vector<SphereHarmonics> const& functions) {
  int const degrees = functions.empty() ? 0 : functions.front().degrees();
  int const rows = grid.latitudes(), columns = grid.longitudes, bins = columns / 2 + 1;
  // Each parallel's Fourier coefficients, those beyond the grid's own folded into them.
  std::vector<Eigen::MatrixXcd> spectra(functions.size(), Eigen::MatrixXcd::Zero(bins, rows));
  auto const put = [&](Eigen::MatrixXcd& spectrum, int row, int m, std::complex<double> value) {
    int bin = m % columns;
    if (bin > columns / 2) bin = columns - bin, value = std::conj(value);
    bool const alone = bin == 0 || 2 * bin == columns;
    spectrum(bin, row) += alone ? (m == 0 ? 1 : 2) * value.real() : value;
  };
  over_half_of_sphere(grid, degrees,
                      [&](int m, int first, int count, int from, LegendreFunctions::Block const& u) {
    for (std::size_t k = 0; k < functions.size(); ++k) {
      // Even and odd l - m apart: their sum is the value in the north, their difference the one in the south.
      Eigen::Matrix<double, 4, LegendreFunctions::lanes, Eigen::RowMajor> parts;
      parts.setZero();
      for (int r = from; r < degrees - m; ++r) {
        std::complex<double> const c = functions[k](m + r, m);
        parts.row(2 * (r % 2)) += c.real() * u.row(r);
        parts.row(2 * (r % 2) + 1) += c.imag() * u.row(r);
      }
      for (int i = 0; i < count; ++i) {
        std::complex<double> const even(parts(0, i), parts(1, i)), odd(parts(2, i), parts(3, i));
        int const north = first + i, south = rows - 1 - north;
        put(spectra[k], north, m, even + odd);
        if (south != north) put(spectra[k], south, m, even - odd);
      }
    }
  });
  Eigen::FFT<double> fourier;
  fourier.SetFlag(Eigen::FFT<double>::HalfSpectrum), fourier.SetFlag(Eigen::FFT<double>::Unscaled);
  std::vector<GridField> fields(functions.size(), GridField(rows, columns));
  for (std::size_t k = 0; k < functions.size(); ++k)
    for (int j = 0; j < rows; ++j)
      if (columns == 1)
        fields[k](j, 0) = spectra[k](0, j).real();
      else
        fourier.inv(fields[k].row(j).data(), spectra[k].col(j).data(), columns);
  return fields;
}
/// The same of one.
inline GridField values_on(SphereGrid const& grid, SphereHarmonics const& f) {
  return std::move(values_on(grid, std::vector{f}).front());
}

/// The coefficients of a function of the degrees below `degrees`, from its values: the inverse of
/// `values_on`.
/// @throws OutsideDomain  where the grid is not Gauss's, or is too coarse for the degrees
inline SphereHarmonics harmonics_from(SphereGrid const& grid, GridField const& field, int degrees) {
  int const rows = grid.latitudes(), columns = grid.longitudes;
  if (!grid.gaussian || rows < degrees)
    throw OutsideDomain("harmonics of a field",
                        "as many parallels at Gauss's latitudes as degrees are needed",
                        grid.gaussian ? rows : 0, degrees);
  if (columns < 2 * degrees - 1)
    throw OutsideDomain("harmonics of a field", "at least 2 x degrees - 1 meridians are needed", columns,
                        2 * degrees - 1);
  if (field.rows() != rows || field.cols() != columns)
    throw OutsideDomain("harmonics of a field", "a value for each place of the grid is needed",
                        static_cast<double>(field.size()), static_cast<double>(rows) * columns);
  Eigen::MatrixXcd spectra(columns / 2 + 1, rows);
  Eigen::FFT<double> fourier;
  fourier.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  for (int j = 0; j < rows; ++j) {
    if (columns == 1)
      spectra(0, j) = field(j, 0);
    else
      fourier.fwd(spectra.col(j).data(), field.row(j).data(), columns);
    spectra.col(j) *= 2 * M_PI / columns * grid.weight[j];
  }
  SphereHarmonics f(degrees);
  over_half_of_sphere(grid, degrees,
                      [&](int m, int first, int count, int from, LegendreFunctions::Block const& u) {
    Eigen::Matrix<double, 4, LegendreFunctions::lanes, Eigen::RowMajor> parts;
    parts.setZero();
    for (int i = 0; i < count; ++i) {
      int const north = first + i, south = rows - 1 - north;
      std::complex<double> const a = spectra(m, north), b = south == north ? 0 : spectra(m, south);
      parts.col(i) << (a + b).real(), (a + b).imag(), (a - b).real(), (a - b).imag();
    }
    for (int r = from; r < degrees - m; ++r)
      f(m + r, m) += std::complex<double>(u.row(r).dot(parts.row(2 * (r % 2))),
                                          u.row(r).dot(parts.row(2 * (r % 2) + 1)));
  });
  return f;
}

}  // namespace actio
