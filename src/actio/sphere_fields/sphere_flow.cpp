#include <Eigen/Core>

#include "actio/sphere_fields/sphere_flow.hpp"

namespace actio::sphere {
namespace detail {
namespace {

/// \f$\sin\theta\,\partial_\theta f\f$, of one degree more.
SphereHarmonics sine_times_slope(SphereHarmonics const& f) {
  int const degrees = f.degrees() + 1;
  SphereHarmonics out(degrees);
  for (int m = 0; m < f.degrees(); ++m)
    for (int l = m; l < f.degrees(); ++l) {
      auto const a = [m](double k) { return std::sqrt((k - m) * (k + m) / ((2 * k - 1) * (2 * k + 1))); };
      out(l + 1, m) += l * a(l + 1) * f(l, m);
      if (l > m) out(l - 1, m) -= (l + 1) * a(l) * f(l, m);
    }
  return out;
}

}  // namespace
}  // namespace detail

FlowFields flow_on(SphereGrid const& grid, SphereHarmonics const& vorticity) {
  SphereHarmonics const psi = stream_function(vorticity);
  auto const more = detail::with_one_degree_more;
  auto fields = values_on(
      grid, {more(vorticity), more(psi), detail::sine_times_slope(psi), more(detail::slope_eastwards(psi))});
  Eigen::ArrayXd const cosecant = grid.colatitude.sin().inverse();
  for (std::size_t k : {2, 3}) fields[k].array().colwise() *= cosecant;
  return {std::move(fields[0]), std::move(fields[1]), std::move(fields[2]), std::move(fields[3])};
}

}  // namespace actio::sphere
