#include "actio/fast_media/fast_box_3d.hpp"

namespace actio::media {

detail::Space<double> FastBox3d::shift(int d) const {
  auto const& p = period[d];
  if (p[0] != 0 || p[1] != 0 || p[2] != 0) return {p[0], p[1], p[2]};
  double const length = cells[d] * spacing[d];
  return {d == 0 ? length : 0, d == 1 ? length : 0, d == 2 ? length : 0};
}

double FastBox3d::response(std::array<int, 3> const& node, int c) const {
  double volume = measure();
  for (int d = 0; d < 3; ++d) {
    if (!moves(d, node[d], c)) return 0;
    volume *= share(d, node[d]);
  }
  return 1 / volume;
}

}  // namespace actio::media
