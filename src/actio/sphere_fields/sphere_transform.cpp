#include <Eigen/Core>

#include "actio/sphere_fields/sphere_transform.hpp"

namespace actio::sphere {

std::vector<GridField> values_on(SphereGrid const& grid, std::vector<SphereHarmonics> const& functions) {
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
  over_half_of_sphere(
      grid, degrees, [&](int m, int first, int count, int from, LegendreFunctions::Block const& u) {
        for (std::size_t k = 0; k < functions.size(); ++k) {
          // Even and odd l - m apart: their sum is the value in the north, their difference the one in the
          // south.
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

SphereHarmonics harmonics_from(SphereGrid const& grid, GridField const& field, int degrees) {
  int const rows = grid.latitudes(), columns = grid.longitudes;
  if (!grid.gaussian || rows < degrees)
    throw OutsideDomain("harmonics of a field",
                        "as many parallels at Gauss's latitudes as degrees are needed",
                        grid.gaussian ? rows : 0, degrees);
  if (columns < 2 * degrees - 1)
    throw OutsideDomain("harmonics of a field", "at least 2 x degrees - 1 meridians are needed", columns,
                        2 * degrees - 1);
  if (field.rows() != rows || field.cols() != columns)
    throw OutsideDomain("harmonics of a field", "a value for each point of the grid is needed",
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
  over_half_of_sphere(
      grid, degrees, [&](int m, int first, int count, int from, LegendreFunctions::Block const& u) {
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

}  // namespace actio::sphere
