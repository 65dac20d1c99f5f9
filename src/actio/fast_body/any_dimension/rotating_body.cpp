#include "actio/fast_body/any_dimension/rotating_body.hpp"

namespace actio::bodies {

Element<RotatingBody::Group, double> RotatingBody::attitude() const {
  Eigen::MatrixXd g(size(), size());
  for (int j = 0; j < size(); ++j)
    for (int i = 0; i < size(); ++i) g(i, j) = full(attitude_)[detail::full_entry(shape_, i, j)];
  return {Group{size()}, g};
}

RotatingBody::RotatingBody(int n)
    : shape_(n),
      full_size_(detail::full_size(shape_)),
      half_size_(detail::half_size(shape_)),
      full_(full_size_ * full_arrays),
      halves_(half_size_ * half_arrays) {
  for (int k = 0; k < longest; ++k) ring_[static_cast<std::size_t>(k)] = guess_ + 1 + k;
}

Momentum<RotatingBody::Group, double> RotatingBody::skew(int array) const {
  Group const group{size()};
  Momentum<Group, double> pi{group, Eigen::VectorXd(group.dimension())};
  over_planes(size(), [&](int a, int i, int j) {
    pi.components[a] = i > j ? half(array)[detail::half_entry(shape_, i, j)]
                             : -half(array)[detail::half_entry(shape_, j, i)];
  });
  return pi;
}

}  // namespace actio::bodies
